"""Exact arithmetic with one rounding at the end, so that every result that is an ordinary double is right.

A double is a fraction. A scalar result is computed from the given doubles as a `Fraction`, which neither overflows nor
underflows, and is rounded to the nearest double at the end. An array is multiplied by such a fraction (`scaled`), or
by other arrays with mantissas and exponents apart (`product`), so that only the result itself can leave the range.
"""

from __future__ import annotations

import math
import sys
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.translation import _

_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant: it cuts a double into two halves whose products are exact."""

_ROOT_BITS = 160
"""Bits of an irrational square root: enough for three doubles."""

_TOO_LARGE = _("{name} is too large for float64")

_ORDINARY_EXPONENT = 1000
"""An exponent of two that is far enough from both ends of float64, ±1022."""


def nearest(name: str, exact: Fraction) -> float:
    """Return the double nearest to a fraction; ValueError names a result that is too large for float64.

    >>> nearest("quotient", Fraction(1, 3))
    0.3333333333333333
    """
    try:
        # Python divides integers of any length and rounds once, correctly.
        return exact.numerator / exact.denominator
    except OverflowError:
        raise ValueError(_TOO_LARGE.format(name=name)) from None


def normal(name: str, exact: Fraction) -> float:
    """Return the double nearest to a fraction; ValueError also names a subnormal result that would lose digits.

    >>> normal("m", Fraction(5e-324))
    5e-324
    >>> normal("m", Fraction(5e-324) / 3)
    Traceback (most recent call last):
    ValueError: m is too small for float64
    """
    value = nearest(name, exact)
    if abs(value) < sys.float_info.min and value != exact:
        raise ValueError(_("{name} is too small for float64").format(name=name))
    return value


def square_root(exact: Fraction) -> Fraction:
    """Return √x of a fraction x ≥ 0: exact if x is the square of a double, else to 160 bits.

    >>> square_root(Fraction(9, 4))
    Fraction(3, 2)
    """
    if not exact:
        return exact
    numerator, denominator = exact.as_integer_ratio()
    shift = _ROOT_BITS - (numerator.bit_length() - denominator.bit_length()) // 2
    numerator, denominator = numerator << 2 * max(shift, 0), denominator << 2 * max(-shift, 0)
    quotient, rest = divmod(numerator, denominator)
    root = math.isqrt(quotient)
    if rest == 0 and root * root == quotient:
        return Fraction(root) / Fraction(2) ** shift
    # The root lies between two neighbours; their middle is never a tie between doubles.
    return Fraction(2 * root + 1) / Fraction(2) ** (shift + 1)


def scaled(coefficient: Fraction, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return an array times a fraction of any size, which may be infinite; two roundings.

    >>> scaled(Fraction(2**1060, 3), np.array([0.0, 2.0**-1060]))
    array([0.        , 0.33333333])
    """
    numerator, denominator = coefficient.numerator, coefficient.denominator
    exponent = numerator.bit_length() - denominator.bit_length()
    with np.errstate(over="ignore", under="ignore"):
        if abs(exponent) < _ORDINARY_EXPONENT:
            return values * (numerator / denominator)
        mantissa = (numerator << max(-exponent, 0)) / (denominator << max(exponent, 0))
        own_mantissa, own_exponent = np.frexp(values)
        return np.ldexp(mantissa * own_mantissa, own_exponent + exponent)


def product(name: str, *factors: ArrayLike) -> NDArray[np.float64]:
    """Return a product of arrays and floats; ValueError names a result that is too large for float64.

    >>> float(product("energy", 2.0**1000, 2.0**1000, 2.0**-1000, 2.0**-999))
    2.0
    """
    mantissa, exponent = 1.0, 0
    for factor in factors:
        own_mantissa, own_exponent = np.frexp(factor)
        mantissa, exponent = mantissa * own_mantissa, exponent + own_exponent
    with np.errstate(over="ignore", under="ignore"):
        return in_range(name, np.ldexp(mantissa, exponent))


def in_range(name: str, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return values, or raise ValueError with the name of the quantity that has overflowed.

    >>> float(in_range("X", np.float64(2.0)))
    2.0
    """
    if not np.all(np.isfinite(values)):
        raise ValueError(_TOO_LARGE.format(name=name))
    return values


def product_error(a: ArrayLike, b: ArrayLike, rounded: ArrayLike) -> NDArray[np.float64]:
    """Return a·b − fl(a·b) exactly, for operands far from the ends of the range (Dekker 1971, Veltkamp's split).

    >>> float(product_error(1 + 2**-52, 1 - 2**-52, (1 + 2**-52) * (1 - 2**-52))) == -(2.0**-104)
    True
    """
    a_high, b_high = _SPLITTER * a - (_SPLITTER * a - a), _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    return ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low
