"""Exact in between, rounded once: how a result is right wherever it is an ordinary double.

A double is a fraction. A scalar result is computed from the given doubles as a `Fraction`, in which nothing overflows
or vanishes, and is rounded to the nearest double at the end. For arrays, which fractions would slow down, `product`
multiplies mantissas and adds exponents, so that only the result itself can leave the range, never a partial product.
"""

from __future__ import annotations

import math
import sys
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike, NDArray

_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant: it cuts a double into two halves whose products are exact."""

_ROOT_BITS = 160
"""Bits of an irrational square root: enough for three doubles."""


def nearest(name: str, exact: Fraction) -> float:
    """Return the double nearest to a fraction; ValueError names what is too large for float64.

    >>> nearest("quotient", Fraction(1, 3))
    0.3333333333333333
    """
    try:
        # Python divides integers of any length and rounds once, correctly.
        return exact.numerator / exact.denominator
    except OverflowError:
        raise ValueError(f"{name} is too large for float64") from None


def normal(name: str, exact: Fraction) -> float:
    """Return the double nearest to a fraction; ValueError also names what loses digits below the normal numbers.

    >>> normal("m", Fraction(5e-324))
    5e-324
    >>> normal("m", Fraction(5e-324) / 3)
    Traceback (most recent call last):
    ValueError: m is too small for float64
    """
    value = nearest(name, exact)
    if abs(value) < sys.float_info.min and value != exact:
        raise ValueError(f"{name} is too small for float64")
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


def product(name: str, *factors: ArrayLike | Fraction) -> NDArray[np.float64]:
    """Return a product of arrays, floats and fractions; ValueError names what is too large for float64.

    >>> float(product("energy", 2.0**1000, 2.0**1000, Fraction(1, 2**1999)))
    2.0
    """
    mantissa, exponent = np.float64(1.0), np.int64(0)
    for factor in factors:
        m, e = _split(factor) if isinstance(factor, Fraction) else np.frexp(factor)
        mantissa, exponent = mantissa * m, exponent + e
    with np.errstate(over="ignore", under="ignore"):
        return in_range(name, np.ldexp(mantissa, exponent))


def in_range(name: str, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return values, or raise ValueError with the name of what has overflowed.

    >>> float(in_range("X", np.float64(2.0)))
    2.0
    """
    if not np.all(np.isfinite(values)):
        raise ValueError(f"{name} is too large for float64")
    return values


def product_error(a: ArrayLike, b: ArrayLike, rounded: ArrayLike) -> NDArray[np.float64]:
    """Return a·b − fl(a·b) exactly, for operands far from the ends of the range (Dekker 1971, Veltkamp's split).

    >>> float(product_error(1 + 2**-52, 1 - 2**-52, (1 + 2**-52) * (1 - 2**-52))) == -(2.0**-104)
    True
    """
    a_high, b_high = _SPLITTER * a - (_SPLITTER * a - a), _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    return ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low


def _split(exact: Fraction) -> tuple[float, int]:
    """Return mantissa and exponent, x = m·2ᵉ with ¼ < |m| < 2 rounded to a double, for a fraction of any size."""
    exponent = exact.numerator.bit_length() - exact.denominator.bit_length()
    return float(exact / Fraction(2) ** exponent), exponent
