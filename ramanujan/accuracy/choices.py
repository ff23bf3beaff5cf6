"""The choices of the app itself, with their errors and costs: points, closed form, arithmetic, caching.

These are four small experiments; `work_precision` compares the integrators.
"""

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
PERIODS = (1, 10, 100, 1000, 10_000)
DIGITS = (15, 30, 50, 100)
HEIGHT = 400
"""The height of the figure that the curves fill [pixels]."""
LARGEST_MASS_RATIO = 4.0
"""The right end of the sampled Ω² curve."""

ARRAY = 10_000
"""The number of values in the array of `arithmetics`."""
STATES = 100
"""The number of states in one call of `caching`."""

_BETWEEN = np.arange(1, 32)[:, None] / 32


@dataclass(frozen=True)
class ClosedForm:
    """The closed form after `periods` periods: its phase error [rad] and the seconds for one state."""

    periods: int
    phase_error: float
    seconds: Timing


def curve_sampling() -> dict[str, dict[int, float]]:
    """Return the distance of two curves from their chords, for several numbers of points.

    Each curve fills the height of the figure. The curves are "cosine", one period of it, and "frequency", Ω²m/k for
    0 ≤ ε ≤ LARGEST_MASS_RATIO.

    Returns
    -------
    curve → number of points, of POINTS → the largest vertical distance [pixels]

    >>> list(curve_sampling()["cosine"])[:3]
    [9, 17, 33]
    """
    curves = {"cosine": (np.cos, 2 * np.pi), "frequency": (normalized_frequency_squared, LARGEST_MASS_RATIO)}
    return {name: {n: _off(*curve, n) for n in POINTS} for name, curve in curves.items()}


def closed_form(oscillator: Oscillator, periods: Sequence[int] = PERIODS) -> list[ClosedForm]:
    """Return error and cost of `motion.motion` after each number of periods; the error grows with them.

    Parameters
    ----------
    oscillator : the machine
    periods : whole numbers of periods

    Returns
    -------
    a `ClosedForm` for each number of periods

    >>> [state.periods for state in closed_form(Oscillator(), [1, 1000])]
    [1, 1000]
    """
    found, initial = [], InitialState(phi=1.0)
    for n in periods:
        times = oscillator.period * (n + np.arange(16) / 16)
        seconds = measure(partial(motion, oscillator, initial, float(times[0])))
        found.append(ClosedForm(n, largest_phase_error(oscillator, times), seconds))
    return found


def seconds_per_reduction(oscillator: Oscillator) -> float:
    """Return the seconds that one phase takes if whole turns are subtracted first.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    median [s], for one time

    >>> seconds_per_reduction(Oscillator()) > 0
    True
    """
    return measure(partial(reduced_phase, turns_per_second(oscillator), oscillator.period)).median


def arithmetics(epsilon: float = UNIT_MASS_RATIO) -> dict[str | int, float]:
    """Return the seconds that Ω²m/k takes in several kinds of arithmetic.

    Parameters
    ----------
    epsilon : ε, taken as exactly this float

    Returns
    -------
    "float64", "array" (one of ARRAY values in float64), "integers", "fraction", and the digits of mpmath → seconds

    >>> list(arithmetics(1.0))
    ['float64', 'array', 'integers', 'fraction', 15, 30, 50, 100]
    """
    many = np.full(ARRAY, epsilon)
    cases: dict[str | int, Callable[[], object]] = {
        "float64": lambda: 1 / effective_mass_ratio(epsilon),
        "array": lambda: normalized_frequency_squared(many),
        "integers": lambda: frequency_squared_by_integers(1.0, epsilon, 1.0),
        "fraction": lambda: _at(Fraction(epsilon)),
    }
    cases |= {digits: _with_digits(digits, epsilon) for digits in DIGITS}
    seconds = {kind: measure(evaluate).median for kind, evaluate in cases.items()}
    return seconds | {"array": seconds["array"] / ARRAY}


def caching(oscillator: Oscillator) -> dict[str, float]:
    """Return the speed-up of a stored result, and of many values in one call.

    Parameters
    ----------
    oscillator : the machine of the repeated calls; a first call uses a machine with a slightly different spring

    Returns
    -------
    "frequency" or "state", of a new machine and of the same one again; "states", STATES singly and in one call

    >>> list(caching(Oscillator()))
    ['frequency', 'state', 'states']
    """
    initial, times = InitialState(phi=1.0), np.linspace(0, oscillator.period, STATES)
    # The spring of each new machine is softer by one part in 1e12.
    new = (replace(oscillator, k=oscillator.k * (1 - number * 1e-12)) for number in count(1))
    ways = {
        "frequency": (lambda: next(new).natural_frequency, lambda: oscillator.natural_frequency),
        "state": (lambda: motion(next(new), initial, 1.0), lambda: motion(oscillator, initial, 1.0)),
        "states": (lambda: [motion(oscillator, initial, t) for t in times], lambda: motion(oscillator, initial, times)),
    }
    return {name: measure(slow).median / measure(fast).median for name, (slow, fast) in ways.items()}


def _off(curve: Callable[[np.ndarray], np.ndarray], end: float, points: int) -> float:
    x = np.linspace(0, end, points)
    # The height of the curve, not of its samples: two samples may have equal values.
    height = np.ptp(curve(np.linspace(0, end, POINTS[-1])))
    between, chords = (each[:-1] + _BETWEEN * np.diff(each) for each in (x, curve(x)))
    return float(np.abs(curve(between) - chords).max() / height * HEIGHT)


def _at(epsilon: Fraction | mpmath.mpf) -> Fraction | mpmath.mpf:
    """Return Ω²m/k in the arithmetic of ε."""
    one = type(epsilon)(1)
    return frequency_squared(one, epsilon, one)


def _with_digits(digits: int, epsilon: float) -> Callable[[], mpmath.mpf]:
    """Return a function that evaluates Ω²m/k with `digits` digits, in a separate mpmath context."""
    context = mpmath.MPContext()
    context.dps = digits
    return lambda: _at(context.mpf(epsilon))
