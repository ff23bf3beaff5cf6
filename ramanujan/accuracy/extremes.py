"""Ω² for very large and very small numbers: the error of each formula in ulp, and its value where it fails.

The FORMS of Ω² are algebraically equal, so all of them are exact in exact arithmetic. Three sweeps cover the range of
floating point. "ratio" has m = k = 1 and m′ = ε; "scale" has m = m′ = k = s, where Ω² = 104/99 for every s; "machines"
has random m, m′ and k of every size. The reference value is computed with 50 digits from the same floats.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared, frequency_squared, frequency_squared_by_integers
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.frequency import effective_mass_ratio
from ramanujan.translation import _

RIGHT, INACCURATE, OVERFLOW, ZERO, PLAUSIBLE = "right", "inaccurate", "overflow", "zero", "plausible"
"""The verdicts: few enough ulp; some digits lost; ∞ or NaN; 0; finite and not 0, but wrong."""
RIGHT_ULP = 4.0
"""Up to this error a value counts as right: the rounding errors of a few operations add up to it."""
PLAUSIBLE_ERROR = 1e-2
"""Relative error from which a finite nonzero value counts as wrong, although it looks like an answer."""
DECADES = {"float32": 37, "float64": 300}
"""The sweeps run from 10^−d to 10^d, so that m′ = ε and Ω² stay normal numbers."""

MACHINES = 1000
"""Random machines; those whose m′/m, k/m or Ω² leaves the range of the sweeps are left out."""
SWEPT = ("ratio", "scale", "machines")

Values = NDArray[np.floating]


@dataclass(frozen=True)
class Form:
    """A form of Ω²: its title, the formula as text, and the function (m, m′, k) → Ω² for arrays of one dtype."""

    title: str
    formula: str
    evaluate: Callable[[Values, Values, Values], Values]


@dataclass(frozen=True)
class Stretch:
    """Consecutive samples with one verdict: both ends of the stretch."""

    verdict: str
    first: float
    last: float


@dataclass(frozen=True, eq=False)
class Sweep:
    """One form in one dtype along one sweep; arrays with one element per sample.

    Parameters
    ----------
    form, dtype, along : name in FORMS; "float32" or "float64"; one of SWEPT
    x : ε, s, or the number of the machine
    value : Ω² as the form returns it
    error_ulp : |value − truth| in units of the truth's last place; NaN or ∞ where the value is
    verdict : RIGHT, INACCURATE, OVERFLOW, ZERO or PLAUSIBLE
    """

    form: str
    dtype: str
    along: str
    x: np.ndarray
    value: np.ndarray
    error_ulp: np.ndarray
    verdict: np.ndarray

    @property
    def worst_right_ulp(self) -> float:
        """The largest error among the samples that count as right; 0 if there are none."""
        return float(self.error_ulp[self.verdict == RIGHT].max(initial=0.0))

    @property
    def stretches(self) -> list[Stretch]:
        """The sweep as stretches of one verdict each, in ascending order of x."""
        starts = np.flatnonzero(np.r_[True, self.verdict[1:] != self.verdict[:-1]])
        ends = np.r_[starts[1:], self.x.size] - 1
        bounds = zip(self.verdict[starts].tolist(), self.x[starts].tolist(), self.x[ends].tolist(), strict=True)
        return [Stretch(*each) for each in bounds]


def extremes(dtypes: Iterable[str] = tuple(DECADES)) -> list[Sweep]:
    """Return the sweeps: one `Sweep` per sweep, dtype and form.

    Parameters
    ----------
    dtypes : "float32", "float64"

    Returns
    -------
    a `Sweep` for each

    >>> sweep, *_ = extremes(["float32"])
    >>> [stretch.verdict for stretch in sweep.stretches]
    ['right', 'zero']
    """
    return [sweep for along in SWEPT for dtype in dtypes for sweep in _sweeps(along, dtype)]


def _paper(m: Values, m_prime: Values, k: Values) -> Values:
    return 8 * k / (7 * m_prime + 8 * m - 8 * (m_prime + m) ** 2 / (7 * m / 3 + 2 * m_prime))


def _scaled(m: Values, m_prime: Values, k: Values) -> Values:
    r, inverse = m_prime / m, m / m_prime
    light = k / m * (8 * (7 + 6 * r) / (32 + r * (49 + 18 * r)))
    heavy = k / m_prime * (8 * (6 + 7 * inverse) / (18 + inverse * (49 + 32 * inverse)))
    return np.where(m >= m_prime, light, heavy)


def _effective_mass(m: Values, m_prime: Values, k: Values) -> Values:
    return k / m / effective_mass_ratio(m_prime / m)


def _partial_fractions(m: Values, m_prime: Values, k: Values) -> Values:
    ratio = m_prime / m
    return k / m * (7 / 4) / (1 + 21 * ratio / 32 + 1 / (48 + 56 / ratio))


def _integers(m: Values, m_prime: Values, k: Values) -> Values:
    machines = zip(m.tolist(), m_prime.tolist(), k.tolist(), strict=True)
    return np.array([frequency_squared_by_integers(*machine) for machine in machines]).astype(m.dtype)


FORMS: dict[str, Form] = {
    "paper": Form(_("the paper’s form"), "8k/(7m′ + 8m − 8(m′ + m)²/(7m/3 + 2m′))", _paper),
    "polynomial": Form(_("two polynomials"), "8k(7m + 6m′)/(32m² + 49mm′ + 18m′²)", frequency_squared),
    "scaled": Form(
        _("scaled by the larger mass"),
        "(k/m)·8(7 + 6x)/(32 + x(49 + 18x)), x = m′/m ≤ 1; (k/m′)·8(6 + 7x)/(18 + x(49 + 32x)), x = m/m′ < 1",
        _scaled,
    ),
    "effective_mass": Form(_("effective mass"), "(k/m)/(4/7 + 3ε/8 + ε/(14(7 + 6ε))), ε = m′/m", _effective_mass),
    "partial_fractions": Form(
        _("partial fractions"), "(k/m)·(7/4)/(1 + 21ε/32 + 1/(48 + 56/ε)), ε = m′/m", _partial_fractions
    ),
    "integers": Form(
        _("exact integers"),
        _("{formula}, in integers of any length, rounded once").format(formula="8k(7m + 6m′)/(32m² + 49mm′ + 18m′²)"),
        _integers,
    ),
}
"""The forms of Ω² by name; "effective_mass" is the one that the app uses."""


def _sweeps(along: str, dtype: str) -> Iterator[Sweep]:
    x, m, m_prime, k = _swept(along, dtype)
    truth = list(map(exact_frequency_squared, m, m_prime, k))
    for name, form in FORMS.items():
        with np.errstate(all="ignore"):
            value = form.evaluate(m, m_prime, k)
        error_ulp, relative = ulp_errors(value, truth)
        yield Sweep(name, dtype, along, x, value, error_ulp, _verdicts(value, error_ulp, relative))


def _swept(along: str, dtype: str) -> tuple[Values, Values, Values, Values]:
    """Return x of a sweep, and m, m′ and k there."""
    if along == "machines":
        decades = DECADES[dtype]
        exponents = np.random.default_rng(1729).uniform(-decades, decades, (3, MACHINES))
        m, m_prime, k = exponents
        within = np.abs(k - np.maximum(m, m_prime)) < decades - 1
        within &= (np.abs(m_prime - m) < decades) & (np.abs(k - m) < decades)
        m, m_prime, k = (10.0 ** exponents[:, within]).astype(dtype)
        return np.arange(m.size, dtype=dtype), m, m_prime, k
    x = powers_of_ten(dtype, 3)
    one = np.ones_like(x)
    return (x, one, x, one) if along == "ratio" else (x, x, x, x)


def powers_of_ten(dtype: str, density: int) -> np.ndarray:
    """Return the powers of ten from 10^−d to 10^d and density − 1 values between neighbours, rounded to the dtype.

    >>> powers_of_ten("float32", 1).size
    75
    """
    decades = DECADES[dtype]
    return (10.0 ** (np.arange(-decades * density, decades * density + 1) / density)).astype(dtype)


def ulp_errors(value: np.ndarray, truth: list[mpmath.mpf]) -> tuple[np.ndarray, np.ndarray]:
    """Return |value − truth| in ulp of the truth and relative to it; NaN and ∞ pass through.

    >>> ulp_errors(np.array([1 + 2.0**-51]), [REFERENCE.mpf(1)])[0]
    array([2.])
    """
    ulps = np.spacing(np.array([float(t) for t in truth]).astype(value.dtype))
    errors = [_error(float(v), t, float(ulp)) for v, t, ulp in zip(value, truth, ulps, strict=True)]
    return tuple(np.array(errors).T)


def _error(value: float, truth: mpmath.mpf, ulp: float) -> tuple[float, float]:
    """Return the two errors of one value; they are divided with 50 digits, since an ulp may be subnormal."""
    if not np.isfinite(value):
        return abs(value), abs(value)
    gap = abs(REFERENCE.mpf(value) - truth)
    return float(gap / ulp), float(gap / truth)


def _verdicts(value: np.ndarray, error_ulp: np.ndarray, relative: np.ndarray) -> np.ndarray:
    """Return the verdict on each sample; the first condition that holds decides."""
    conditions = [~np.isfinite(value), error_ulp <= RIGHT_ULP, value == 0, relative < PLAUSIBLE_ERROR]
    return np.select(conditions, [OVERFLOW, RIGHT, ZERO, INACCURATE], PLAUSIBLE)
