"""The frequency of the oscillating mode as a function of the masses, and its inverse.

    Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²),    f(ε) = Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32),    ε = m′/m

The curve f falls from 7/4 at ε = 0 like 8/(3ε) for heavy rollers; it is 104/99 for equal masses and 1 at ε*.
"""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.rounding import product_error
from ramanujan.translation import _
from ramanujan.validation import floats

UNIT_MASS_RATIO = 48 / (1 + math.sqrt(1729))
"""ε* = (√1729 − 1)/36, where Ω² = k/m exactly; written without the subtraction, it rounds to the nearest double."""

LIGHT_ROLLERS_LIMIT = 7 / 4
"""Ω²m/k for ε → 0, the least upper bound of the normalized frequency squared."""

Number = TypeVar("Number")


def frequency_ratio(m: Number, m_prime: Number, k: Number) -> tuple[Number, Number]:
    """Return numerator and denominator of Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) in the arithmetic of the arguments.

    >>> frequency_ratio(1, 1, 1)
    (104, 99)
    """
    return 8 * k * (7 * m + 6 * m_prime), 32 * m * m + 49 * m * m_prime + 18 * m_prime * m_prime


def frequency_squared(m: Number, m_prime: Number, k: Number) -> Number:
    """Return Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) in the arithmetic of the arguments.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg] and k [N/m], all fractions, all mpmath numbers, or all symbols. Floats work too, but
        their squares overflow or vanish beyond 1e±154: `Oscillator` is right over the whole range.

    Returns
    -------
    Ω² [rad²/s²] : exact for fractions

    Source: paper, section 2, the equation of motion before eq. (10).

    >>> from fractions import Fraction
    >>> frequency_squared(Fraction(1), Fraction(1), Fraction(1))
    Fraction(104, 99)
    """
    numerator, denominator = frequency_ratio(m, m_prime, k)
    return numerator / denominator


def normalized_frequency_squared(mass_ratio: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return Ω²m/k, the square of the natural frequency in units of √(k/m).

        Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32) = (7/4)/(1 + 21ε/32 + 1/(48 + 56/ε))

    The last form is evaluated, with the denominator as the sum of two doubles. The result is within a few hundredths of
    an ulp of the nearest float; it is exactly 7/4 at ε = 0, never larger, and it never increases with ε.

    Parameters
    ----------
    mass_ratio : ε = m′/m ≥ 0, dimensionless, scalar or array of any shape; float32 in gives float32 out

    Returns
    -------
    Ω²m/k : of the shape of mass_ratio, in (0, 7/4]

    Raises
    ------
    ValueError : a mass ratio is negative, infinite or not a number.

    Source: paper, section 2, the equation of motion before eq. (10), in partial fractions.

    >>> float(normalized_frequency_squared(UNIT_MASS_RATIO))
    1.0
    >>> normalized_frequency_squared([0, 1, 5 / 6])
    array([1.75      , 1.05050505, 1.125     ])
    """
    ratio = floats("mass_ratio", mass_ratio)
    # NaN fails both comparisons.
    if not (np.all(ratio >= 0) and np.all(ratio < np.inf)):
        raise ValueError(_("mass_ratio must be finite and not negative"))
    with np.errstate(under="ignore"):
        return _curve(ratio.astype(np.float64, copy=False)).astype(ratio.dtype)[()]


def mass_ratio_for(normalized_frequency_squared: ArrayLike) -> NDArray[np.floating] | np.floating:
    """Return the one mass ratio ε > 0 at which Ω²m/k has the given value w; the inverse of the function above.

        18w ε² + (49w − 48) ε + (32w − 56) = 0

    With b = 49w − 48 and d = √(b² + 72w(56 − 32w)) = √((7w − 48)² + 48w²), the positive root is
    16(7 − 4w)/(b + d) for b ≥ 0 and (d − b)/(36w) otherwise: neither form subtracts nearly equal numbers.

    Parameters
    ----------
    normalized_frequency_squared : w = Ω²m/k, dimensionless, scalar or array; float32 in gives float32 out

    Returns
    -------
    ε : of the shape of w, dimensionless

    Raises
    ------
    ValueError : w is outside 0 < w < 7/4, or so small that ε leaves the floating-point range.

    Source: physics of the unit-frequency condition, paper section 2, for a general target.

    >>> float(mass_ratio_for(1)) == UNIT_MASS_RATIO
    True
    """
    given = floats("normalized_frequency_squared", normalized_frequency_squared)
    if not np.all((given > 0) & (given < LIGHT_ROLLERS_LIMIT)):
        raise ValueError(_("normalized_frequency_squared must lie strictly between 0 and 7/4"))
    w = given.astype(np.float64, copy=False)
    b = 49 * w - 48
    # The branch that is not taken may divide by a tiny number; its value is not used.
    with np.errstate(over="ignore", under="ignore", divide="ignore"):
        d = np.sqrt((7 * w - 48) ** 2 + 48 * w * w)
        ratio = np.where(b >= 0, 16 * (7 - 4 * w) / (b + d), (d - b) / 36 / w).astype(given.dtype)
    if not np.all(np.isfinite(ratio)):
        raise ValueError(
            _("normalized_frequency_squared is too small: the mass ratio would exceed the range of floats")
        )
    return ratio[()]


def _curve(ratio: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (7/4)/(1 + 21ε/32 + 1/(48 + 56/ε)) for float64.

    21ε/32 is held exactly as `high + low`, and 1/(48 + 56/ε) never falls as ε grows, so their sum always rises. The
    quotient by its leading double is corrected by the exact remainder of that division. Both keep the curve falling.
    """
    y = ratio / 32
    high, five_y = 21 * y, 5 * y
    # Dekker's fast two-sum, twice: 21y = 16y + 5y and 5y = 4y + y, without an error.
    low = (16 * y - high + five_y) + (y - (five_y - 4 * y))
    with np.errstate(divide="ignore", over="ignore"):
        small = 1 / (48 + 56 / ratio)
    leading, lost = _two_sum(1.0, high)
    leading, lost_again = _two_sum(leading, small)
    rest = lost + (low + lost_again)
    # Scaling by powers of two keeps the exact product below within the range for every ε.
    leading, exponent = np.frexp(leading)
    rest = np.ldexp(rest, -exponent)
    quotient = 1.75 / leading
    rounded = quotient * leading
    remainder = (1.75 - rounded) - product_error(quotient, leading, rounded) - quotient * rest
    return np.ldexp(quotient + remainder / leading, -exponent)


def _two_sum(a: NDArray[np.float64] | float, b: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return fl(a + b) and a + b − fl(a + b), exactly (Knuth)."""
    total = a + b
    added = total - a
    return total, (a - (total - added)) + (b - added)
