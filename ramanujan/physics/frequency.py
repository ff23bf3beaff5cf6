"""Frequency of the oscillating mode as a function of the mass ratio, and the inverse function.

Equation (12) of the paper is φ̈ + Ω²φ = 0 with Ω² = k/M_x. The effective mass M_x is one eighth of the denominator in
eq. (12). In the oscillating mode the kinetic energy is ½M_xẋ², where x = 2Rφ is the compression of the spring. In units
of m, with ε = m′/m,

    M_x/m = ⅛(7ε + 8 − 24(ε + 1)²/(7 + 6ε))         eq. (12)
          = 3ε/8 + (8 + 7ε)/(2(7 + 6ε))             polynomial division
          = 4/7 + 3ε/8 + ε/(14(7 + 6ε))             only positive terms that do not decrease with ε; used here

    Ω²m/k = m/M_x = 8(7 + 6ε)/(18ε² + 49ε + 32)     as one fraction

The term 4/7 is the effective mass for massless rollers. The term 3ε/8 comes from the rotation of hoop
and lower cylinder.

Ω²m/k decreases from 7/4 at ε = 0 and approaches 8/(3ε) for heavy rollers. It is 104/99 for equal masses, eq. (8), and 1
at ε = ε*, eq. (14).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.physics.validation import FloatOrArray, float_array

UNIT_MASS_RATIO = 48 / (1 + math.sqrt(1729))
"""ε* = (√1729 − 1)/36, eq. (14), where Ω² = k/m. The nearest double: the subtraction in eq. (14) loses a digit."""

LIGHT_ROLLERS_LIMIT = 7 / 4
"""Upper bound of Ω²m/k: its limit for ε → 0."""


def effective_mass_ratio(mass_ratio: FloatOrArray) -> FloatOrArray:
    """Return M_x/m = 4/7 + (3ε/8 + ε/(14(7 + 6ε))), the effective mass in units of m.

    The computed sum never decreases with ε. The form with two terms, 3ε/8 + (8 + 7ε)/(2(7 + 6ε)), decreases between
    some neighbouring floats near ε = 10⁻¹⁵, because of rounding.

    Parameters
    ----------
    mass_ratio : ε = m′/m ≥ 0, dimensionless, a float or an array of floats

    Returns
    -------
    M_x/m : of the type and shape of mass_ratio

    Source: paper, eq. (12), rearranged as in the module docstring.

    >>> effective_mass_ratio(0.0) == 4 / 7
    True
    """
    return 4 / 7 + (3 / 8 * mass_ratio + mass_ratio / (7 + 6 * mass_ratio) / 14)


def normalized_frequency_squared(mass_ratio: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return Ω²m/k = m/M_x, the square of the natural frequency in units of k/m.

    The error is at most 4 units in the last place for 1e-300 ≤ ε ≤ 1e300; the greatest known error is 3.4 units. The
    values never increase with ε. They are 7/4 at 0, the nearest float to 104/99 at 1, and 1 at ε*.

    Parameters
    ----------
    mass_ratio : ε = m′/m ≥ 0, dimensionless, a number or an array of any shape

    Returns
    -------
    Ω²m/k : of the shape of mass_ratio, in (0, 7/4]; float32 for float32, otherwise float64

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
    # For ε > 3·10³⁰⁷ the denominator 7 + 6ε is ∞, so its term is 0 instead of 1/84. The sum does not change.
    with np.errstate(over="ignore"):
        value: NDArray[np.floating] = 1 / effective_mass_ratio(ratio.astype(np.float64))
    return value.astype(ratio.dtype)[()]


def mass_ratio_for(normalized_frequency_squared: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return the mass ratio ε at which Ω²m/k has the value w.

    Ω²m/k = w gives the quadratic equation 18wε² + (49w − 48)ε + (32w − 56) = 0. It has exactly one positive root for
    0 < w < 7/4. With b = 49w − 48 and the discriminant d² = b² − 72w(32w − 56) = (7w − 48)² + 48w² the root is

        ε = 16(7 − 4w)/(d + |b|) for b ≥ 0,    ε = (d + |b|)/(36w) for b < 0.

    Neither form subtracts nearly equal numbers d and |b|. The error is at most 16 units in the last place.

    Parameters
    ----------
    normalized_frequency_squared : w = Ω²m/k, dimensionless, a number or an array of any shape

    Returns
    -------
    ε : of the shape of w, dimensionless; float32 for float32, otherwise float64

    Raises
    ------
    ValueError : w is not between 0 and 7/4, or is so small that ε exceeds the largest float.

    Source: paper, eq. (12) with Ω² = wk/m; for w = 1 the quadratic equation is eq. (13).

    >>> float(mass_ratio_for(1)) == UNIT_MASS_RATIO
    True
    """
    w = float_array("normalized_frequency_squared", normalized_frequency_squared)
    if not np.all((w > 0) & (w < LIGHT_ROLLERS_LIMIT)):
        raise ValueError("normalized_frequency_squared must lie strictly between 0 and 7/4")
    b = 49 * w - 48
    d = np.hypot(7 * w - 48, math.sqrt(48) * w)
    d_plus_b = d + np.abs(b)
    with np.errstate(over="ignore"):
        ratio: NDArray[np.floating] = np.where(b >= 0, 16 * (7 - 4 * w) / d_plus_b, d_plus_b / (36 * w))
    if not np.all(np.isfinite(ratio)):
        raise ValueError("normalized_frequency_squared is too small: the mass ratio exceeds the largest float")
    return ratio[()]
