"""The cost of the numeric core, in ratios within one run: `python -m tests.benchmarks.core`.

Ω² of a new machine         against a bare frozen dataclass with the same checks and the same formula
a new machine, one state    against a closed form in ten lines without checks
states at a million times   against the sine and the cosine of as many phases
"""

import argparse
import math
import sys
import time
import timeit
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ramanujan import InitialState, Oscillator, motion

LIMITS = {"Ω² of a new machine": 2.5, "a new machine, one state": 4.0, "states at a million times": 4.0}
"""Measurement → the largest ratio."""
_MACHINE = (1.0, 1.2, 10.0, 0.1)
_REPEATS = 40


@dataclass(frozen=True)
class Bare:
    """A machine with the checks of `Oscillator` and nothing else."""

    m: float
    m_prime: float
    k: float
    radius: float

    def __post_init__(self) -> None:
        for value in (self.m, self.m_prime, self.k, self.radius):
            if not 0 < value < math.inf:
                raise ValueError(value)
        if not (0 < self.m_prime / self.m < math.inf and 0 < self.k / self.m < math.inf):
            raise ValueError(self)
        if not 0 < self.frequency_squared() < math.inf:
            raise ValueError(self)

    def frequency_squared(self) -> float:
        """Return Ω², by the formula of the core."""
        ratio = self.m_prime / self.m
        return self.k / self.m / (4 / 7 + (3 / 8 * ratio + ratio / (7 + 6 * ratio) / 14))


def bare_state(m: float, m_prime: float, k: float, R: float, phi: float, t: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the state after a release, without a check."""
    ratio = m_prime / m
    squared = k / m / (4 / 7 + (3 / 8 * ratio + ratio / (7 + 6 * ratio) / 14))
    omega, kappa = math.sqrt(squared), (1 + ratio) / (7 / 6 + ratio)
    S, C = math.sin(omega * t) / omega, 2 * math.sin(omega * t / 2) ** 2
    shape = kappa * R, 1.0, 2 / 3 * kappa
    moved, rate = -phi * C, -phi * squared * S
    q = np.array([shape[0] * moved, phi + moved, shape[2] * moved])
    return q, np.array([shape[0] * rate, rate, shape[2] * rate])


def seconds(call: Callable[[], object], number: int) -> float:
    """Return the processor time of one call: the least of many repeats, which other work disturbs least."""
    return min(timeit.repeat(call, number=number, repeat=_REPEATS, timer=time.process_time)) / number


def ratios() -> dict[str, float]:
    """Return measurement → the time of the core divided by that of the bare program."""
    initial, times, machine = InitialState(phi=0.4), np.linspace(0, 100, 10**6), Oscillator(*_MACHINE)
    own = (
        seconds(lambda: Oscillator(*_MACHINE).natural_frequency_squared, 2000),
        seconds(lambda: motion(Oscillator(*_MACHINE), initial, 1.3), 2000),
        seconds(lambda: motion(machine, initial, times), 1),
    )
    bare = (
        seconds(lambda: Bare(*_MACHINE).frequency_squared(), 2000),
        seconds(lambda: bare_state(*_MACHINE, 0.4, 1.3), 2000),
        seconds(lambda: (np.sin(times), np.cos(times)), 1),
    )
    return {name: mine / theirs for name, mine, theirs in zip(LIMITS, own, bare, strict=True)}


def main() -> int:
    """Print the ratios, and return how many exceed their limits."""
    argparse.ArgumentParser(description=__doc__.split("\n")[0]).parse_args()
    found = ratios()
    for name, ratio in found.items():
        print(f"{name:<28} {ratio:.2f} of at most {LIMITS[name]}")
    return sum(ratio > LIMITS[name] for name, ratio in found.items())


if __name__ == "__main__":
    sys.exit(main())
