"""Exact arithmetic with one rounding at the end, so that every result that is an ordinary double is right.

A double is a quotient of two integers. A scalar result is computed from such integers, which neither overflow nor
underflow, and Python rounds the one division at the end correctly. An array is multiplied by such a quotient
(`scaled`), or by other arrays with mantissas and exponents apart (`product`), so that only the result itself can leave
the range.
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.translation import _

_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant: it cuts a double into two halves whose products are exact."""

_ROOT_BITS = 160
"""Bits of an irrational square root: enough for three doubles."""

SMALLEST_NORMAL = sys.float_info.min
"""The smallest double that has all 53 bits."""

_TOO_LARGE = _("{name} is too large for float64")

_ORDINARY_EXPONENT = 1000
"""An exponent of two that is far enough from both ends of float64, ±1022."""


def over_one_denominator(first: float, second: float) -> tuple[int, int, int]:
    """Return two doubles as exact integers over one denominator: both numerators, and the denominator.

    >>> over_one_denominator(0.75, 0.5)
    (6, 4, 8)
    """
    (one, unit), (other, own_unit) = first.as_integer_ratio(), second.as_integer_ratio()
    return one * own_unit, other * unit, unit * own_unit


def nearest(name: str, numerator: int, denominator: int) -> float:
    """Return the double nearest to a quotient; ValueError names a result that is too large for float64.

    >>> nearest("quotient", 1, 3)
    0.3333333333333333
    """
    try:
        # Python divides integers of any length and rounds once, correctly.
        return numerator / denominator
    except OverflowError:
        raise ValueError(_TOO_LARGE.format(name=name)) from None


def normal(name: str, numerator: int, denominator: int) -> float:
    """Return the double nearest to a quotient; ValueError also names a subnormal result that would lose digits.

    >>> normal("m", *(5e-324).as_integer_ratio())
    5e-324
    >>> normal("m", 1, 3 * 2**1074)
    Traceback (most recent call last):
    ValueError: m is too small for float64
    """
    value = nearest(name, numerator, denominator)
    if abs(value) < SMALLEST_NORMAL:
        top, bottom = value.as_integer_ratio()
        if top * denominator != numerator * bottom:
            raise ValueError(_("{name} is too small for float64").format(name=name))
    return value


def square_root(numerator: int, denominator: int) -> tuple[int, int]:
    """Return √(numerator/denominator) as a quotient of integers: exact if it is a double, else to 160 bits.

    >>> top, bottom = square_root(9, 4)
    >>> top / bottom
    1.5
    """
    shift = _ROOT_BITS - (numerator.bit_length() - denominator.bit_length()) // 2
    root = math.isqrt((numerator << 2 * max(shift, 0)) // (denominator << 2 * max(-shift, 0)))
    return root << max(-shift, 0), 1 << max(shift, 0)


def scaled(numerator: int, denominator: int, values: float | NDArray[np.float64]) -> float | NDArray[np.float64]:
    """Return a number or an array times a quotient of any size, which may be infinite; two roundings.

    >>> scaled(2**1060, 3, np.array([0.0, 2.0**-1060]))
    array([0.        , 0.33333333])
    """
    exponent = numerator.bit_length() - denominator.bit_length()
    if abs(exponent) < _ORDINARY_EXPONENT:
        return values * (numerator / denominator)
    mantissa = (numerator << max(-exponent, 0)) / (denominator << max(exponent, 0))
    own_mantissa, own_exponent = np.frexp(values)
    with np.errstate(over="ignore", under="ignore"):
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
