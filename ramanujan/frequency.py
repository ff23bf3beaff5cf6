"""The frequency of the oscillating mode as a function of the mass ratio, and its inverse.

Equation (12) of the paper is φ̈ + Ω²φ = 0. With ε = m′/m its coefficient is

    Ω² = (k/m) / (M_x/m),    M_x/m = 3ε/8 + (8 + 7ε)/(2(7 + 6ε)) = 4/7 + 3ε/8 + ε/(14(7 + 6ε)),

where M_x is the mass that the spring feels. With massless rollers it is 4m/7, and 3m′/8 is the spin of both rollers. In
one fraction,

    Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32).

This curve falls from 7/4 at ε = 0 like 8/(3ε) for heavy rollers. It is 104/99 for equal masses, eq. (8), and 1 at ε*,
eq. (14).
"""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.validation import float_array

UNIT_MASS_RATIO = 48 / (1 + math.sqrt(1729))
"""ε* = (√1729 − 1)/36, eq. (14), where Ω² = k/m. Without the subtraction it rounds to the nearest double."""

LIGHT_ROLLERS_LIMIT = 7 / 4
"""Ω²m/k for ε → 0. It is smaller for every machine with rollers."""

FloatOrArray = TypeVar("FloatOrArray", float, NDArray[np.floating])


def effective_mass_ratio(mass_ratio: FloatOrArray) -> FloatOrArray:
    """Return M_x/m = 4/7 + (3ε/8 + ε/(14(7 + 6ε))), the mass that the spring feels in units of m.

    In floating point this sum rises with ε, as the exact one does. The form with two terms does not: near ε = 10⁻¹⁵ it
    falls from one number to the next.

    Parameters
    ----------
    mass_ratio : ε = m′/m ≥ 0, dimensionless, a float or an array of floats

    Returns
    -------
    M_x/m : of the type and shape of mass_ratio

    Source: paper, eq. (12): the denominator of Ω² divided by 8m, as a sum of positive terms.

    >>> effective_mass_ratio(0.0) == 4 / 7
    True
    """
    return 4 / 7 + (3 / 8 * mass_ratio + mass_ratio / (7 + 6 * mass_ratio) / 14)


def normalized_frequency_squared(mass_ratio: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return Ω²m/k = m/M_x, the square of the natural frequency in units of k/m.

    The error is at most 2.5 units in the last place for 1e-300 ≤ ε ≤ 1e300. The values fall with ε. They are exactly
    7/4 at 0, 104/99 at 1 and 1 at ε*.

    Parameters
    ----------
    mass_ratio : ε = m′/m ≥ 0, dimensionless, a number or an array of any shape; float32 in gives float32 out

    Returns
    -------
    Ω²m/k : of the shape of mass_ratio, in (0, 7/4]

    Raises
    ------
    ValueError : a mass ratio is negative or not finite.

    Source: paper, eq. (12).

    >>> float(normalized_frequency_squared(UNIT_MASS_RATIO))
    1.0
    >>> normalized_frequency_squared([0, 1, 5 / 6])
    array([1.75      , 1.05050505, 1.125     ])
    """
    ratio = float_array("mass_ratio", mass_ratio)
    if np.any(ratio < 0):
        raise ValueError("mass_ratio must not be negative")
    # Beyond ε = 3·10³⁰⁷ the last denominator overflows, and its term vanishes.
    with np.errstate(over="ignore"):
        value: NDArray[np.floating] = 1 / effective_mass_ratio(ratio.astype(np.float64))
    return value.astype(ratio.dtype)[()]


def mass_ratio_for(normalized_frequency_squared: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return the mass ratio ε at which Ω²m/k has the value w.

    The quadratic equation 18wε² + (49w − 48)ε + (32w − 56) = 0 has exactly one positive root for 0 < w < 7/4. With
    b = 49w − 48 and d² = (7w − 48)² + 48w² it is

        ε = 16(7 − 4w)/(d + |b|) for b ≥ 0,    ε = (d + |b|)/(36w) for b < 0.

    Neither form subtracts numbers that are almost equal. The error is at most 16 units in the last place.

    Parameters
    ----------
    normalized_frequency_squared : w = Ω²m/k, dimensionless, a number or an array; float32 in gives float32 out

    Returns
    -------
    ε : of the shape of w, dimensionless

    Raises
    ------
    ValueError : w is not between 0 and 7/4, or so small that ε exceeds the largest float.

    Source: paper, eq. (13), with w in place of 1.

    >>> float(mass_ratio_for(1)) == UNIT_MASS_RATIO
    True
    """
    w = float_array("normalized_frequency_squared", normalized_frequency_squared)
    if not np.all((w > 0) & (w < LIGHT_ROLLERS_LIMIT)):
        raise ValueError("normalized_frequency_squared must lie strictly between 0 and 7/4")
    b = 49 * w - 48
    d = np.hypot(7 * w - 48, math.sqrt(48) * w)
    total = d + np.abs(b)
    with np.errstate(over="ignore"):
        ratio: NDArray[np.floating] = np.where(b >= 0, 16 * (7 - 4 * w) / total, total / (36 * w))
    if not np.all(np.isfinite(ratio)):
        raise ValueError("normalized_frequency_squared is too small: the mass ratio exceeds the largest float")
    return ratio[()]
