"""Closed form, our integrators and SciPy's solvers at equal accuracy, in one run: python -m tests.benchmarks.solvers.

Every solver gets the same task: the machine's state (φ, φ′/Ω) after so many periods, from rest at φ = 1, with a state
error up to the tolerance. Each one is set as coarse as it may be for that. Four goals are then checked; the exit
status is 1 if one is missed. Run it on a machine that does nothing else.
"""

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import islice

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from ramanujan import Oscillator, normalized_frequency_squared
from ramanujan.accuracy.measurement import Timing, measure
from ramanujan.accuracy.work_precision import DTYPES, timed, work_precision
from ramanujan.frequency import frequency_squared
from ramanujan.integrators import METHODS, trajectory
from ramanujan.motion import InitialState, motion

State = tuple[float, float]
Settings = Iterator[tuple[str, Callable[[], State]]]
"""A solver's settings from coarse to fine: words, and the call that solves."""

MOST_TIMES_OF_MULTIPLY_ADD = 5.0
LEAST_TIMES_FASTER = 1000.0
MOST_SECONDS_OF_DIAGRAM = 10.0
LEAST_TIMES_FASTER_THAN_FRACTIONS = 5.0


@dataclass(frozen=True)
class Solution:
    """A solver, its setting, its state error and the seconds it takes."""

    solver: str
    setting: str
    error: float
    seconds: Timing


def closed_form(oscillator: Oscillator, t: float) -> State:
    """The state from `motion.motion`."""
    q, q_dot = motion(oscillator, InitialState(phi=1.0), t)
    return float(q[1]), float(q_dot[1]) / oscillator.natural_frequency


def modes(oscillator: Oscillator, t: float) -> State:
    """The state from the normal modes of SciPy's generalized eigenproblem KV = MVΛ, VᵀMV = 1."""
    squared, vectors = eigh(oscillator.stiffness_matrix, oscillator.mass_matrix)
    coordinates = vectors.T @ oscillator.mass_matrix @ np.array([0.0, 1.0, 0.0])
    # The zero modes come out as tiny numbers of either sign; at rest their coordinates stay as they are.
    omegas = np.sqrt(np.maximum(squared, 0.0))
    phi = vectors[1] @ (coordinates * np.cos(omegas * t))
    phi_dot = -vectors[1] @ (coordinates * omegas * np.sin(omegas * t))
    return float(phi), float(phi_dot) / oscillator.natural_frequency


def scipy_solver(oscillator: Oscillator, t: float, method: str, rtol: float) -> State:
    """The state from solve_ivp."""
    squared = oscillator.natural_frequency_squared
    solution = solve_ivp(lambda _, y: [y[1], -squared * y[0]], (0.0, t), [1.0, 0.0], method, rtol=rtol, atol=rtol / 10)
    phi, phi_dot = solution.y[:, -1]
    return float(phi), float(phi_dot) / oscillator.natural_frequency


def integrator(oscillator: Oscillator, t: float, method: str, steps: int) -> State:
    """The state from one of our METHODS, in plain Python floats."""
    squared = oscillator.natural_frequency_squared
    states = trajectory(METHODS[method], lambda q: -squared * q, 1.0, 0.0, t / steps)
    phi, phi_dot = next(islice(states, steps - 1, None))
    return float(phi), float(phi_dot) / oscillator.natural_frequency


def solutions(oscillator: Oscillator, periods: int, tolerance: float) -> Iterator[Solution]:
    """Yield each solver with the coarsest setting that meets the tolerance; one that never does is left out."""
    t = periods * oscillator.period
    tries: dict[str, Settings] = {
        "closed form": iter([("", partial(closed_form, oscillator, t))]),
        "scipy.linalg.eigh": iter([("", partial(modes, oscillator, t))]),
        "DOP853": _tolerances(oscillator, t, "DOP853"),
        "LSODA": _tolerances(oscillator, t, "LSODA"),
    }
    tries |= {method.title: _step_numbers(oscillator, t, name, periods) for name, method in METHODS.items()}
    for solver, settings in tries.items():
        for setting, solve in settings:
            phi, velocity = solve()
            # A whole number of periods: the exact state is the initial one.
            if (error := float(np.hypot(phi - 1, velocity))) <= tolerance:
                yield Solution(solver, setting, error, measure(solve))
                break


def _tolerances(oscillator: Oscillator, t: float, method: str) -> Settings:
    for rtol in 10.0 ** -np.arange(3, 13.5, 0.5):
        yield f"rtol {rtol:.1e}", partial(scipy_solver, oscillator, t, method, rtol)


def _step_numbers(oscillator: Oscillator, t: float, method: str, periods: int) -> Settings:
    for n in np.rint(4 * 2 ** np.arange(0, 9.5, 0.5)).astype(int).tolist():
        yield f"{n} steps a period", partial(integrator, oscillator, t, method, n * periods)


def multiply_add_ratio(count: int, repeats: int = 5) -> tuple[float, float]:
    """Return seconds for Ω²m/k over that many ratios and for a·b + c over as many numbers, taken in turn."""
    ratios = np.random.default_rng(1729).uniform(0.0, 4.0, count)
    b, c = ratios[::-1].copy(), ratios + 1
    taken = [(_seconds(lambda: normalized_frequency_squared(ratios)), _seconds(lambda: ratios * b + c))]
    for _ in range(repeats):
        taken.append((_seconds(lambda: normalized_frequency_squared(ratios)), _seconds(lambda: ratios * b + c)))
    # The first round maps the memory.
    frequency, multiply_add = np.median(taken[1:], axis=0)
    return float(frequency), float(multiply_add)


def integers_and_fractions(oscillator: Oscillator) -> tuple[Timing, Timing]:
    """Return the seconds for the nearest double to Ω²: by the machine's integers, and by Python's fractions."""
    m, m_prime, k = oscillator.m, oscillator.m_prime, oscillator.k
    assert float(frequency_squared(Fraction(m), Fraction(m_prime), Fraction(k))) == oscillator.natural_frequency_squared
    return measure(lambda: oscillator.natural_frequency_squared), measure(
        lambda: float(frequency_squared(Fraction(m), Fraction(m_prime), Fraction(k)))
    )


def main() -> int:
    """Measure, print, and return 0 if every goal is met."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.solvers", description=__doc__.split("\n\n")[0])
    parser.add_argument("--periods", type=int, default=100, help="length of the task (default: %(default)s)")
    parser.add_argument("--tolerance", type=float, default=1e-3, help="state error allowed (default: %(default)s)")
    parser.add_argument("--count", type=int, default=10_000_000, help="ratios for Ω²m/k (default: %(default)s)")
    options = parser.parse_args()
    oscillator = Oscillator()
    print(f"NumPy {np.__version__}, SciPy {scipy.__version__}, Python {sys.version.split()[0]}")
    print(f"State after {options.periods} periods with an error up to {options.tolerance:g}:")
    found = list(solutions(oscillator, options.periods, options.tolerance))
    fastest = found[0].seconds.median
    for s in found:
        line = f"  {s.solver:18} {s.setting:24} error {s.error:8.1e}   {s.seconds.median:9.3e} s"
        print(f"{line} ({s.seconds.low:.2e} … {s.seconds.high:.2e})   {s.seconds.median / fastest:10.1f} ×")
    missing = {"closed form", "scipy.linalg.eigh", "DOP853", "LSODA", *(m.title for m in METHODS.values())}
    for solver in sorted(missing - {s.solver for s in found}):
        print(f"  {solver:18} does not reach it with any setting tried")

    met = []
    frequency, multiply_add = multiply_add_ratio(options.count)
    ratio = frequency / multiply_add
    met.append(ratio <= MOST_TIMES_OF_MULTIPLY_ADD)
    print(f"Ω²m/k over {options.count} ratios: {frequency:.3e} s, {ratio:.2f} × a·b + c. {_verdict(met)}")

    t = 100 * oscillator.period
    slow = measure(partial(scipy_solver, oscillator, t, "DOP853", 1e-9))
    fast = measure(partial(closed_form, oscillator, t))
    met.append(slow.median / fast.median >= LEAST_TIMES_FASTER)
    print(f"A state after 100 periods: {slow.median / fast.median:.0f} × faster than DOP853 at 1e-9. {_verdict(met)}")

    seconds = _seconds(lambda: [timed(work_precision(method, dtype)) for method in METHODS for dtype in DTYPES])
    met.append(seconds < MOST_SECONDS_OF_DIAGRAM)
    print(f"Work-precision diagram over 100 periods: {seconds:.2f} s. {_verdict(met)}")

    machine, initial = Oscillator(1.37, 0.91, 13.7), InitialState(phi=0.4, X_dot=0.1, phi_dot=0.3)
    integers, fractions = integers_and_fractions(machine)
    times_faster = fractions.median / integers.median
    met.append(times_faster >= LEAST_TIMES_FASTER_THAN_FRACTIONS)
    print(f"Ω²: {1e6 * integers.median:.1f} µs, {times_faster:.0f} × faster than by fractions. {_verdict(met)}")
    for words, call in (
        ("A machine, validated", lambda: Oscillator(1.37, 0.91, 13.7)),
        ("A state after 1e9 s", lambda: motion(machine, initial, 1e9)),
        ("A state of a new machine", lambda: motion(Oscillator(1.37, 0.91, 13.7), initial, 1e9)),
    ):
        print(f"{words}: {1e6 * measure(call).median:.1f} µs")
    return 0 if all(met) else 1


def _verdict(met: list[bool]) -> str:
    return "Goal met." if met[-1] else "Goal MISSED."


def _seconds(function: Callable[[], object]) -> float:
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


if __name__ == "__main__":
    sys.exit(main())
