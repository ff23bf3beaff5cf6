"""Four small experiments on the implementation of the app: points of a curve, closed form, arithmetic and caching."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import count

import mpmath
import numpy as np

from ramanujan.accuracy.exact import (
    frequency_squared,
    frequency_squared_by_integers,
    reduced_phase,
    turns_per_second,
)
from ramanujan.accuracy.measurement import Timing, measure
from ramanujan.accuracy.phase import largest_phase_error
from ramanujan.frequency import UNIT_MASS_RATIO, effective_mass_ratio, normalized_frequency_squared
from ramanujan.motion import InitialState, motion
from ramanujan.oscillator import Oscillator

POINTS = (9, 17, 33, 65, 129, 257, 513, 1025)
"""Numbers of points in `measure_chord_errors`."""

PERIODS = (1, 10, 100, 1000, 10_000)
"""Default numbers of periods in `measure_closed_form`."""

DIGITS = (15, 30, 50, 100)
"""Numbers of mpmath digits in `measure_arithmetics`."""

HEIGHT = 400
"""Height of a curve in `measure_chord_errors` [pixels]."""

LARGEST_MASS_RATIO = 4.0
"""Right end of the Ω² curve in `measure_chord_errors`."""

ARRAY_SIZE = 10_000
"""Number of array elements in `measure_arithmetics`."""

STATE_COUNT = 100
"""Number of states in `measure_caching`."""

_FRACTIONS_OF_CHORD = np.arange(1, 32)[:, None] / 32
"""Positions along each chord at which `_largest_distance` is evaluated, shape (31, 1)."""


@dataclass(frozen=True)
class ClosedForm:
    """Phase error [rad] of the closed form after a number of periods, and seconds per state."""

    periods: int
    phase_error: float
    seconds: Timing


def measure_chord_errors() -> dict[str, dict[int, float]]:
    """Return the largest error of two curves when straight lines join a number of their points.

    The curves are "cosine", one period of the cosine, and "frequency", Ω²m/k for 0 ≤ ε ≤ LARGEST_MASS_RATIO. Each is
    scaled to HEIGHT.

    Returns
    -------
    curve → number of points → largest vertical distance between the curve and the lines [pixels]

    >>> list(measure_chord_errors()["cosine"])[:3]
    [9, 17, 33]
    """
    return {
        "cosine": {n: _largest_distance(np.cos, 2 * np.pi, n) for n in POINTS},
        "frequency": {n: _largest_distance(_frequency_curve, LARGEST_MASS_RATIO, n) for n in POINTS},
    }


def measure_closed_form(oscillator: Oscillator, periods: Sequence[int] = PERIODS) -> list[ClosedForm]:
    """Return the error and the cost of `motion.motion` after each number of periods. The error grows with time.

    Parameters
    ----------
    oscillator : the machine
    periods : whole numbers of periods

    Returns
    -------
    a `ClosedForm` for each number of periods

    >>> [state.periods for state in measure_closed_form(Oscillator(), [1, 1000])]
    [1, 1000]
    """
    initial = InitialState(phi=1.0)
    results = []
    for n in periods:
        times = oscillator.period * (n + np.arange(16) / 16)
        seconds = measure(partial(motion, oscillator, initial, float(times[0])))
        results.append(ClosedForm(n, largest_phase_error(oscillator, times), seconds))
    return results


def seconds_per_reduction(oscillator: Oscillator) -> float:
    """Return the duration of one call of `exact.reduced_phase`.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    median duration for one number t [s]

    >>> seconds_per_reduction(Oscillator()) > 0
    True
    """
    return measure(partial(reduced_phase, turns_per_second(oscillator), oscillator.period)).median


def measure_arithmetics() -> dict[str | int, float]:
    """Return the duration of one evaluation of Ω²m/k at ε* in several kinds of arithmetic.

    Returns
    -------
    kind of arithmetic → seconds per value. The kinds are "float64", "array" (float64 arrays of ARRAY_SIZE elements),
    "integers", "fraction", and for mpmath its number of digits.

    >>> list(measure_arithmetics())
    ['float64', 'array', 'integers', 'fraction', 15, 30, 50, 100]
    """
    epsilon, epsilons = UNIT_MASS_RATIO, np.full(ARRAY_SIZE, UNIT_MASS_RATIO)
    cases: dict[str | int, Callable[[], object]] = {
        "float64": lambda: 1 / effective_mass_ratio(epsilon),
        "array": lambda: normalized_frequency_squared(epsilons),
        "integers": lambda: frequency_squared_by_integers(1.0, epsilon, 1.0),
        "fraction": lambda: _frequency_squared_at(Fraction(epsilon)),
    }
    cases |= {digits: _with_digits(digits, epsilon) for digits in DIGITS}
    seconds = {kind: measure(evaluate).median for kind, evaluate in cases.items()}
    return seconds | {"array": seconds["array"] / ARRAY_SIZE}


def measure_caching(oscillator: Oscillator) -> dict[str, float]:
    """Return the gain in speed by a cached result, and by one call for many values.

    Parameters
    ----------
    oscillator : the machine of the repeated calls

    Returns
    -------
    ratios of durations: "frequency" and "state" for a new machine against the same machine again; "states" for
    STATE_COUNT calls against one call with an array

    >>> list(measure_caching(Oscillator()))
    ['frequency', 'state', 'states']
    """
    initial = InitialState(phi=1.0)
    times = np.linspace(0, oscillator.period, STATE_COUNT)
    # Each new machine has a spring that is softer by one part in 1e12, so nothing is cached for it.
    new_machines = (replace(oscillator, k=oscillator.k * (1 - number * 1e-12)) for number in count(1))

    def ratio(slow: Callable[[], object], fast: Callable[[], object]) -> float:
        return measure(slow).median / measure(fast).median

    return {
        "frequency": ratio(lambda: next(new_machines).natural_frequency, lambda: oscillator.natural_frequency),
        "state": ratio(lambda: motion(next(new_machines), initial, 1.0), lambda: motion(oscillator, initial, 1.0)),
        "states": ratio(
            lambda: [motion(oscillator, initial, t) for t in times], lambda: motion(oscillator, initial, times)
        ),
    }


def _frequency_curve(mass_ratios: np.ndarray) -> np.ndarray:
    """Return Ω²m/k along the curve."""
    return np.asarray(normalized_frequency_squared(mass_ratios))


def _largest_distance(curve: Callable[[np.ndarray], np.ndarray], end: float, points: int) -> float:
    """Return the largest vertical distance between a curve on [0, end] and its chords [pixels]."""
    # A few points may miss the extremes of the curve, so its height is that of a fine sampling.
    height = np.ptp(curve(np.linspace(0, end, POINTS[-1])))
    x = np.linspace(0, end, points)
    y = curve(x)
    x_between = x[:-1] + _FRACTIONS_OF_CHORD * np.diff(x)
    y_on_chords = y[:-1] + _FRACTIONS_OF_CHORD * np.diff(y)
    return float(np.abs(curve(x_between) - y_on_chords).max() / height * HEIGHT)


def _frequency_squared_at(epsilon: Fraction | mpmath.mpf) -> Fraction | mpmath.mpf:
    """Return Ω²m/k in the arithmetic of the type of ε."""
    one = type(epsilon)(1)
    return frequency_squared(one, epsilon, one)


def _with_digits(digits: int, epsilon: float) -> Callable[[], mpmath.mpf]:
    """Return a function that evaluates Ω²m/k with this number of digits, in a separate mpmath context."""
    context = mpmath.MPContext()
    context.dps = digits
    return lambda: _frequency_squared_at(context.mpf(epsilon))
