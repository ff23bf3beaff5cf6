"""Rounding errors of algebraically equal formulas for Ω², with very large and very small parameters.

Errors are in ulp, units in the last place of the exact value. Two sweeps cover the range of floating-point numbers:

    ratio       m = k = 1 and m′ = ε, for ε from very small to very large
    scale       m = m′ = k = s, for s from very small to very large; Ω² = 104/99 for every s

The reference value is computed with 50 digits from the same floats.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared, frequency_squared, frequency_squared_by_integers
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.physics.frequency import effective_mass_ratio
from ramanujan.text.translation import _

RIGHT, INACCURATE, OVERFLOW, ZERO, WRONG = "right", "inaccurate", "overflow", "zero", "wrong"
"""The verdicts on a value.

right         error of at most RIGHT_ULP
inaccurate    larger error, but a relative error below WRONG_ERROR
overflow      ∞ or NaN
zero          0
wrong         relative error of WRONG_ERROR or more; finite and not zero, so it looks like a result
"""

RIGHT_ULP = 4.0
"""Largest error of a right value, which the rounding errors of a few operations can cause."""

WRONG_ERROR = 1e-2
"""Relative error at which a value is wrong rather than inaccurate."""

DECADES = {"float32": 37, "float64": 300}
"""dtype → d: the sweeps extend from 10^−d to 10^d, so that m′ = ε and Ω² are normal numbers."""

SWEEP_NAMES = ("ratio", "scale")
"""Names of the sweeps."""

FloatArray = NDArray[np.floating]


@dataclass(frozen=True)
class Form:
    """A formula for Ω²: its title, its text, and the function (m, m′, k) → Ω² for arrays of one dtype."""

    title: str
    formula: str
    evaluate: Callable[[FloatArray, FloatArray, FloatArray], FloatArray]


@dataclass(frozen=True)
class Stretch:
    """The first and the last x of consecutive samples with the same verdict."""

    verdict: str
    first: float
    last: float


@dataclass(frozen=True, eq=False)
class Sweep:
    """The values of one formula in one dtype along one sweep. Arrays have one element per sample.

    Parameters
    ----------
    form : name in FORMS
    dtype : "float32" or "float64"
    sweep_name : one of SWEEP_NAMES
    x : ε or s
    value : computed Ω²
    error_ulp : |value − truth| in ulp of the truth; NaN or ∞ if the value is NaN or infinite
    verdict : RIGHT, INACCURATE, OVERFLOW, ZERO or WRONG
    """

    form: str
    dtype: str
    sweep_name: str
    x: np.ndarray
    value: np.ndarray
    error_ulp: np.ndarray
    verdict: np.ndarray

    @property
    def worst_right_ulp(self) -> float:
        """The largest error of the samples with the verdict RIGHT; 0 if there are none."""
        return float(self.error_ulp[self.verdict == RIGHT].max(initial=0.0))

    @property
    def stretches(self) -> list[Stretch]:
        """The intervals of x with the same verdict, in ascending order."""
        stretches: list[Stretch] = []
        for x, verdict in zip(self.x.tolist(), self.verdict.tolist(), strict=True):
            if stretches and stretches[-1].verdict == verdict:
                stretches[-1] = replace(stretches[-1], last=x)
            else:
                stretches.append(Stretch(verdict, x, x))
        return stretches


def sweep_forms() -> list[Sweep]:
    """Return the values and errors of all forms along all sweeps.

    Returns
    -------
    one `Sweep` for each sweep name, dtype and form, in this order

    >>> sweep, *_ = sweep_forms()
    >>> [stretch.verdict for stretch in sweep.stretches]
    ['right', 'zero']
    """
    sweeps: list[Sweep] = []
    for sweep_name in SWEEP_NAMES:
        for dtype in DECADES:
            sweeps += _evaluate_forms(sweep_name, dtype)
    return sweeps


# FORMS contains the formula of each of the following functions.
def _paper(m: FloatArray, m_prime: FloatArray, k: FloatArray) -> FloatArray:
    return 8 * k / (7 * m_prime + 8 * m - 8 * (m_prime + m) ** 2 / (7 * m / 3 + 2 * m_prime))


def _scaled(m: FloatArray, m_prime: FloatArray, k: FloatArray) -> FloatArray:
    """Return Ω² from the smaller mass divided by the larger one, so that no returned square overflows."""
    ratio, inverse = m_prime / m, m / m_prime
    for_light_rollers = k / m * (8 * (7 + 6 * ratio) / (32 + ratio * (49 + 18 * ratio)))
    for_heavy_rollers = k / m_prime * (8 * (6 + 7 * inverse) / (18 + inverse * (49 + 32 * inverse)))
    return np.where(m >= m_prime, for_light_rollers, for_heavy_rollers)


def _effective_mass(m: FloatArray, m_prime: FloatArray, k: FloatArray) -> FloatArray:
    return k / m / effective_mass_ratio(m_prime / m)


def _partial_fractions(m: FloatArray, m_prime: FloatArray, k: FloatArray) -> FloatArray:
    ratio = m_prime / m
    return k / m * (7 / 4) / (1 + 21 * ratio / 32 + 1 / (48 + 56 / ratio))


def _integers(m: FloatArray, m_prime: FloatArray, k: FloatArray) -> FloatArray:
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
    "effective_mass": Form(
        _("k divided by an effective mass"), "(k/m)/(4/7 + 3ε/8 + ε/(14(7 + 6ε))), ε = m′/m", _effective_mass
    ),
    "partial_fractions": Form(
        _("split into simple fractions"), "(k/m)·(7/4)/(1 + 21ε/32 + 1/(48 + 56/ε)), ε = m′/m", _partial_fractions
    ),
    "integers": Form(
        _("exact integers"),
        _("{formula}, in integers of any length, rounded once").format(formula="8k(7m + 6m′)/(32m² + 49mm′ + 18m′²)"),
        _integers,
    ),
}
"""Name → formula for Ω²."""
USED_FORM = "effective_mass"
"""The formula that the app uses."""


def _evaluate_forms(sweep_name: str, dtype: str) -> Iterator[Sweep]:
    """Yield one `Sweep` for each form."""
    x, m, m_prime, k = _generate_samples(sweep_name, dtype)
    truth = list(map(exact_frequency_squared, m, m_prime, k))
    for name, form in FORMS.items():
        with np.errstate(all="ignore"):
            value = form.evaluate(m, m_prime, k)
        error_ulp, relative = ulp_errors(value, truth)
        yield Sweep(
            form=name,
            dtype=dtype,
            sweep_name=sweep_name,
            x=x,
            value=value,
            error_ulp=error_ulp,
            verdict=_judge(value, error_ulp, relative),
        )


def _generate_samples(sweep_name: str, dtype: str) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return the samples of a sweep: x, m, m′ and k."""
    x = powers_of_ten(dtype, density=3)
    one = np.ones_like(x)
    return (x, one, x, one) if sweep_name == "ratio" else (x, x, x, x)


def powers_of_ten(dtype: str, density: int) -> np.ndarray:
    """Return 10^−d … 10^d with `density` values per decade, where d is the entry of the dtype in DECADES.

    >>> powers_of_ten("float32", 1).size
    75
    """
    decades = DECADES[dtype]
    return (10.0 ** (np.arange(-decades * density, decades * density + 1) / density)).astype(dtype)


def ulp_errors(value: np.ndarray, truth: list[mpmath.mpf]) -> tuple[np.ndarray, np.ndarray]:
    """Return the errors |value − truth| in ulp of the truth, and relative to the truth.

    The errors of a value that is NaN or ±∞ are NaN or ∞.

    >>> ulp_errors(np.array([1 + 2.0**-51]), [REFERENCE.mpf(1)])[0]
    array([2.])
    """
    ulps = np.spacing(np.array([float(exact) for exact in truth]).astype(value.dtype))
    samples = zip(value.tolist(), truth, ulps.tolist(), strict=True)
    errors = np.array([_compute_errors(computed, exact, ulp) for computed, exact, ulp in samples])
    return errors[:, 0], errors[:, 1]


def _compute_errors(value: float, truth: mpmath.mpf, ulp: float) -> tuple[float, float]:
    """Return the error of one value in ulp, and its relative error."""
    if not np.isfinite(value):
        # NaN remains NaN, and ±∞ becomes ∞.
        return abs(value), abs(value)
    # An ulp may be subnormal, so the quotients are computed with 50 digits.
    difference = abs(REFERENCE.mpf(value) - truth)
    return float(difference / ulp), float(difference / truth)


def _judge(value: np.ndarray, error_ulp: np.ndarray, relative: np.ndarray) -> np.ndarray:
    """Return the verdict on each sample."""
    # `np.select` chooses the verdict of the first true condition.
    conditions = [~np.isfinite(value), error_ulp <= RIGHT_ULP, value == 0, relative < WRONG_ERROR]
    return np.select(conditions, [OVERFLOW, RIGHT, ZERO, INACCURATE], WRONG)
