"""Validation of arguments: integers and fractions within bounds."""

from __future__ import annotations

import reprlib
from fractions import Fraction
from numbers import Integral, Rational

from ramanujan.text.numerals import number


def integer(name: str, value: object, low: int, high: int) -> int:
    """Return an integer from low to high as an int; raise `ValueError` for any other value.

    >>> integer("digits", 5, 2, 10)
    5
    """
    if isinstance(value, bool) or not isinstance(value, Integral) or not low <= int(value) <= high:
        raise ValueError(f"{name} must be an integer from {number(low)} to {number(high)}")
    return int(value)


def rational(name: str, value: object, largest: int) -> Fraction:
    """Return an exact number as a Fraction whose numerator and denominator are at most `largest` in absolute value.

    >>> rational("target", 2, 10)
    Fraction(2, 1)
    """
    if isinstance(value, bool) or not isinstance(value, Rational):
        raise ValueError(f"{name} must be an exact number, an integer or a Fraction, not {reprlib.repr(value)}")
    exact = Fraction(int(value.numerator), int(value.denominator))
    if max(abs(exact.numerator), exact.denominator) > largest:
        raise ValueError(f"{name} must have a numerator and a denominator of at most {number(largest)}")
    return exact
