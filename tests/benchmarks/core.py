"""Duration of the numeric core relative to minimal code, measured in one run: `python -m tests.benchmarks.core`.

Ω² of a new machine         relative to a frozen dataclass with the same checks and the same formula
a new machine, one state    relative to a closed form without checks
states at a million times   relative to a million sines and cosines
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
"""Measurement → largest allowed ratio."""
_MACHINE = (1.0, 1.2, 10.0, 0.1)
_REPEATS = 40


@dataclass(frozen=True)
class Bare:
    """A minimal class with the checks of `Oscillator`."""

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
        """Return Ω² from the same formula as the core."""
        ratio = self.m_prime / self.m
        return self.k / self.m / (4 / 7 + (3 / 8 * ratio + ratio / (7 + 6 * ratio) / 14))


def bare_state(m: float, m_prime: float, k: float, R: float, phi: float, t: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the state after a release from rest, without checks."""
    ratio = m_prime / m
    squared = k / m / (4 / 7 + (3 / 8 * ratio + ratio / (7 + 6 * ratio) / 14))
    omega, kappa = math.sqrt(squared), (1 + ratio) / (7 / 6 + ratio)
    S, C = math.sin(omega * t) / omega, 2 * math.sin(omega * t / 2) ** 2
    shape = kappa * R, 1.0, 2 / 3 * kappa
    change, rate = -phi * C, -phi * squared * S
    q = np.array([shape[0] * change, phi + change, shape[2] * change])
    return q, np.array([shape[0] * rate, rate, shape[2] * rate])


def seconds(call: Callable[[], object], number: int) -> float:
    """Return the processor time of one call: the minimum of many repeats, which other processes affect least."""
    return min(timeit.repeat(call, number=number, repeat=_REPEATS, timer=time.process_time)) / number


def ratios() -> dict[str, float]:
    """Return measurement → duration of the core divided by that of the minimal code."""
    initial, times, machine = InitialState(phi=0.4), np.linspace(0, 100, 10**6), Oscillator(*_MACHINE)
    core = (
        seconds(lambda: Oscillator(*_MACHINE).natural_frequency_squared, 2000),
        seconds(lambda: motion(Oscillator(*_MACHINE), initial, 1.3), 2000),
        seconds(lambda: motion(machine, initial, times), 1),
    )
    minimal = (
        seconds(lambda: Bare(*_MACHINE).frequency_squared(), 2000),
        seconds(lambda: bare_state(*_MACHINE, 0.4, 1.3), 2000),
        seconds(lambda: (np.sin(times), np.cos(times)), 1),
    )
    return {name: ours / least for name, ours, least in zip(LIMITS, core, minimal, strict=True)}


def main() -> int:
    """Print the ratios, and return the number of ratios above their limits."""
    argparse.ArgumentParser(description=__doc__.split("\n")[0]).parse_args()
    measured = ratios()
    for name, ratio in measured.items():
        print(f"{name:<28} {ratio:.2f} of at most {LIMITS[name]}")
    return sum(ratio > LIMITS[name] for name, ratio in measured.items())


if __name__ == "__main__":
    sys.exit(main())
