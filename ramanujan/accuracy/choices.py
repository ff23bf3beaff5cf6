"""The choices of the app itself, with their errors and costs: points, closed form, arithmetic, caching.

These are four small experiments; `work_precision` compares the integrators.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import count
from typing import TypeAlias

import mpmath
import numpy as np

from ramanujan.accuracy.measurement import Timing, measure
from ramanujan.accuracy.phase import largest_phase_error
from ramanujan.frequency import UNIT_MASS_RATIO, frequency_ratio, frequency_squared, normalized_frequency_squared
from ramanujan.motion import InitialState, motion
from ramanujan.oscillator import Oscillator

Value: TypeAlias = float | np.floating | np.ndarray | Fraction | mpmath.mpf
"""A value of one kind of arithmetic."""

POINTS = (9, 17, 33, 65, 129, 257, 513, 1025)
PERIODS = (1, 10, 100, 1000, 10_000)
DIGITS = (15, 30, 50, 100)
HEIGHT = 400
"""Of the figure that the curves fill [pixels]."""
LARGEST_MASS_RATIO = 4.0
"""Right end of the sampled Ω² curve."""

ARRAY = 10_000
"""Values in the array of `arithmetics`."""
STATES = 100
"""States in one call in `caching`."""

_BETWEEN = np.arange(1, 32)[:, None] / 32


@dataclass(frozen=True)
class CurveSampling:
    """A curve drawn as straight pieces between `points` samples.

    curve : "cosine", one period of it, or "frequency", Ω²m/k for 0 ≤ ε ≤ LARGEST_MASS_RATIO
    pixels : largest vertical distance between the curve and its chords, when the curve fills the figure's height
    seconds : duration of computing y
    """

    curve: str
    points: int
    pixels: float
    seconds: Timing


@dataclass(frozen=True)
class ClosedForm:
    """The exact solution after `periods` periods: its phase error [rad] and the seconds for one state."""

    periods: int
    phase_error: float
    seconds: Timing


@dataclass(frozen=True)
class Arithmetic:
    """One evaluation of Ω²m/k in one kind of arithmetic: its relative error and the seconds it takes.

    kind : "float32", "float64", "array" (one of ARRAY values in float64), "integers", "fraction", or "mpmath"
    digits : decimal digits that mpmath carries; None for the other kinds
    """

    kind: str
    digits: int | None
    relative_error: float
    seconds: Timing


@dataclass(frozen=True)
class Comparison:
    """The same result, computed in a slow and in a fast way.

    name : "frequency" or "state", of a new machine and of the same one again; "states", STATES singly and in one call
    """

    name: str
    slow_seconds: Timing
    fast_seconds: Timing

    @property
    def ratio(self) -> float:
        """How many times longer the slow way takes."""
        return self.slow_seconds.median / self.fast_seconds.median


def curve_sampling() -> list[CurveSampling]:
    """Return the error on screen of both curves for each number of POINTS.

    >>> {sampling.curve for sampling in curve_sampling()} == {"cosine", "frequency"}
    True
    """
    found = []
    for name, curve, end in (
        ("cosine", np.cos, 2 * np.pi),
        ("frequency", normalized_frequency_squared, LARGEST_MASS_RATIO),
    ):
        # The height of the curve, not of its samples: two samples may have equal values.
        extent = np.ptp(curve(np.linspace(0, end, POINTS[-1])))
        for n in POINTS:
            x = np.linspace(0, end, n)
            between, chords = (each[:-1] + _BETWEEN * np.diff(each) for each in (x, curve(x)))
            pixels = float(np.abs(curve(between) - chords).max() / extent * HEIGHT)
            found.append(CurveSampling(name, n, pixels, measure(partial(curve, x))))
    return found


def closed_form(oscillator: Oscillator, periods: Sequence[int] = PERIODS) -> list[ClosedForm]:
    """Return error and cost of `motion.motion` after each number of periods; neither grows.

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


def arithmetics(mass_ratio: float = UNIT_MASS_RATIO) -> list[Arithmetic]:
    """Return error and cost of Ω²m/k in float32, float64, exact fractions, and mpmath with n digits.

    Parameters
    ----------
    mass_ratio : ε, taken as exactly this float

    Returns
    -------
    an `Arithmetic` for each kind

    >>> [(value.kind, value.digits) for value in arithmetics(1.0)][-2:]
    [('mpmath', 50), ('mpmath', 100)]
    """
    epsilon, many, few = mass_ratio, np.full(ARRAY, mass_ratio), np.float32(mass_ratio)
    cases: list[tuple[str, int | None, Callable[[], Value]]] = [
        ("float32", None, lambda: normalized_frequency_squared(few)),
        ("float64", None, lambda: normalized_frequency_squared(epsilon)),
        ("array", None, lambda: normalized_frequency_squared(many)),
        ("integers", None, lambda: _by_integers(epsilon)),
        ("fraction", None, lambda: _at(Fraction(epsilon))),
    ]
    cases += [("mpmath", n, _with_digits(n, epsilon)) for n in DIGITS]
    exact, found = _at(Fraction(epsilon)), []
    for kind, digits, evaluate in cases:
        values, timing = np.ravel(evaluate()), measure(evaluate)
        each = Timing(*(seconds / values.size for seconds in (timing.median, timing.low, timing.high)))
        found.append(Arithmetic(kind, digits, float(abs(_fraction(values[0]) / exact - 1)), each))
    return found


def caching(oscillator: Oscillator) -> list[Comparison]:
    """Return how much faster it is to keep a result, or to ask for many values at once.

    Parameters
    ----------
    oscillator : the machine that is asked again; the first calls use machines with a slightly different spring

    Returns
    -------
    the three comparisons

    >>> caching(Oscillator())[0].name
    'frequency'
    """
    initial, times = InitialState(phi=1.0), np.linspace(0, oscillator.period, STATES)
    # The spring of each new machine is softer by one part in 1e12.
    new = (replace(oscillator, k=oscillator.k * (1 - number * 1e-12)) for number in count(1))
    ways = {
        "frequency": (lambda: next(new).natural_frequency, lambda: oscillator.natural_frequency),
        "state": (lambda: motion(next(new), initial, 1.0), lambda: motion(oscillator, initial, 1.0)),
        "states": (lambda: [motion(oscillator, initial, t) for t in times], lambda: motion(oscillator, initial, times)),
    }
    return [Comparison(name, measure(slow), measure(fast)) for name, (slow, fast) in ways.items()]


def _at(epsilon: Fraction | mpmath.mpf) -> Fraction | mpmath.mpf:
    """Return Ω²m/k in the arithmetic of ε."""
    one = type(epsilon)(1)
    return frequency_squared(one, epsilon, one)


def _by_integers(epsilon: float) -> float:
    """Return Ω²m/k as `Oscillator` does: one quotient of integers."""
    m_prime, m = epsilon.as_integer_ratio()
    numerator, denominator = frequency_ratio(m, m_prime, m)
    return numerator / denominator


def _with_digits(digits: int, epsilon: float) -> Callable[[], mpmath.mpf]:
    """Return the evaluation of Ω²m/k in an mpmath context of its own, with that many digits."""
    context = mpmath.MPContext()
    context.dps = digits
    return lambda: _at(context.mpf(epsilon))


def _fraction(value: Value) -> Fraction:
    """Return a float, a Fraction or an mpf (mantissa times a power of two) as exactly the same Fraction."""
    if hasattr(value, "man_exp"):
        mantissa, exponent = value.man_exp
        return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return value if isinstance(value, Fraction) else Fraction(float(value))
