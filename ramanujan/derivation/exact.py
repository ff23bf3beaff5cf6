"""Exact numbers of the form a + b√n with fractions a and b, and their LaTeX.

The machine with m′ = ε*m has such numbers in every formula. SymPy's own elements of ℚ(√n) take some 60 µs to multiply,
these take about 1 µs, so that a page can put them into a whole derivation at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from functools import lru_cache
from math import gcd, isqrt, lcm
from typing import Any

import sympy as sp

from ramanujan.translation import _

_EXACTLY = Context(prec=200)

Rational = Any
"""An element of SymPy's domain ℚ, which has `numerator` and `denominator`; plain integers mix with it."""

LONG = 10**7
"""A denominator from this size on has too many digits to read; the number is then written as a decimal."""

DIGITS = 8
"""Significant digits of a decimal."""


class Surd:
    """(a + b√n)/d with integers a, b and d > 0, not in lowest terms; it has + − × ÷ and positive integer powers."""

    __slots__ = ("a", "b", "d", "n")

    def __init__(self, a: int, b: int, d: int, n: int) -> None:
        self.a, self.b, self.d, self.n = a, b, d, n

    def _with(self, other: Surd | Rational) -> Surd:
        """Return another number as one of these."""
        if isinstance(other, Surd):
            return other
        return Surd(int(other.numerator), 0, int(other.denominator), self.n)

    def __add__(self, other: Surd | Rational) -> Surd:
        other = self._with(other)
        d, e = self.d, other.d
        return Surd(self.a * e + other.a * d, self.b * e + other.b * d, d * e, self.n)

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd(-self.a, -self.b, self.d, self.n)

    def __sub__(self, other: Surd | Rational) -> Surd:
        return self + -other

    def __rsub__(self, other: Surd | Rational) -> Surd:
        return -self + other

    def __mul__(self, other: Surd | Rational) -> Surd:
        if isinstance(other, int):
            return Surd(self.a * other, self.b * other, self.d, self.n)
        other = self._with(other)
        a = self.a * other.a + self.n * self.b * other.b
        return Surd(a, self.a * other.b + self.b * other.a, self.d * other.d, self.n)

    __rmul__ = __mul__

    def __truediv__(self, other: Surd | Rational) -> Surd:
        other = self._with(other)
        # Times the conjugate a − b√n, above and below.
        norm = other.a * other.a - self.n * other.b * other.b
        sign = 1 if norm > 0 else -1
        product = self * Surd(sign * other.a, -sign * other.b, 1, self.n)
        return Surd(product.a * other.d, product.b * other.d, product.d * abs(norm), self.n)

    def __rtruediv__(self, other: Rational) -> Surd:
        return self._with(other) / self

    def __pow__(self, exponent: int) -> Surd:
        result = self
        for _i in range(exponent - 1):
            result = result * self
        return result


def element(value: sp.Expr, n: int | None = None) -> Rational | Surd:
    """Return a SymPy number as an element of ℚ, or of ℚ(√n) where n is given.

    Raises
    ------
    ValueError : value does not lie in that field.

    >>> element(sp.Rational(3, 2))
    MPQ(3,2)
    >>> written(element((sp.sqrt(1729) - 1) / 36, 1729)).alone
    '\\\\frac{\\\\sqrt{1729} - 1}{36}'
    """
    if value.is_Rational:
        number = sp.QQ(int(value.p), int(value.q))
        return number if n is None else Surd(int(value.p), 0, int(value.q), n)
    root = sp.sqrt(n) if n else None
    a, b = (sp.S.NaN, sp.S.NaN) if root is None else (value.expand().coeff(root, power) for power in (0, 1))
    if not (a.is_Rational and b.is_Rational):
        raise ValueError(_("value must be a fraction, or a fraction plus a multiple of one square root"))
    d = lcm(int(a.q), int(b.q))
    return Surd(int(a * d), int(b * d), d, n)


def root_in(values: tuple[sp.Expr, ...]) -> int | None:
    """Return the n of the one square root √n in some numbers, or None if all are fractions.

    Raises
    ------
    ValueError : values contain other roots, or more than one.
    """
    roots = {power for value in values for power in value.atoms(sp.Pow) if not power.exp.is_Integer}
    if not roots:
        return None
    (root, *others) = roots
    if others or root.exp != sp.Rational(1, 2) or not root.base.is_Integer:
        raise ValueError(_("values must contain no roots except multiples of one square root"))
    return int(root.base)


@dataclass(frozen=True)
class Written:
    """A number as LaTeX.

    Parameters
    ----------
    sign : 1, 0 or −1; the rest is the absolute value
    above : the numerator
    factor : the numerator as a factor of something else: a sum in brackets, "" for 1
    below : the denominator, "" for 1
    is_decimal : whether it is a decimal because the fraction is too long
    negated : the numerator with the opposite signs where that needs no brackets, so that −(√1729 − 37) is 37 − √1729
    """

    sign: int
    above: str
    factor: str
    below: str
    is_decimal: bool = False
    negated: str = ""

    @property
    def alone(self) -> str:
        """The number by itself, with its sign."""
        if self.sign < 0 and self.negated:
            return _quotient(self.negated, self.below)
        absolute = _quotient(self.above, self.below)
        # As SymPy does, only a bare integer has its sign close to it.
        return f"{'-' if absolute.isdigit() else '- '}{absolute}" if self.sign < 0 else absolute


def _quotient(above: str, below: str) -> str:
    return rf"\frac{{{above}}}{{{below}}}" if below else above


@lru_cache(maxsize=4096)
def _fraction_written(p: int, q: int) -> Written:
    sign, p = (p > 0) - (p < 0), abs(p)
    if q >= LONG:
        decimal = truncated(p, q)
        return Written(sign, decimal, decimal, "", is_decimal=True)
    return Written(sign, str(p), str(p) if p != 1 else "", str(q) if q != 1 else "")


def written(number: Rational | Surd) -> Written:
    """Return a number as LaTeX: one fraction, no root below it; a long one as a decimal that ends in dots."""
    if not isinstance(number, Surd):
        return _fraction_written(int(number.numerator), int(number.denominator))
    common = gcd(number.a, number.b, number.d)
    a, b, q = number.a // common, number.b // common, number.d // common
    if not b:
        return _fraction_written(a, q)
    sign = _sign(a, b, number.n)
    a, b = sign * a, sign * b
    p = gcd(a, b)
    if max(q, abs(a), abs(b)) >= LONG:
        decimal = _digits(_surd_value(a, b, number.n), ROUND_DOWN, Decimal(q))
        return Written(sign, decimal, decimal, "", is_decimal=True)
    a, b = a // p, b // p
    negated = ""
    root = rf"\sqrt{{{number.n}}}" if abs(b) == 1 else rf"{abs(b)}\,\sqrt{{{number.n}}}"
    if not a:
        body = bracketed = root
    else:
        body = f"{root} - {-a}" if a < 0 else f"{a} {'-' if b < 0 else '+'} {root}"
        if p == 1 and a * b < 0:
            negated = f"{-a} - {root}" if a < 0 else f"{root} - {a}"
        bracketed = rf"\left({body}\right)"
    factor = bracketed if p == 1 else rf"{p}\,{bracketed}"
    return Written(sign, body if p == 1 else factor, factor, str(q) if q != 1 else "", negated=negated)


def truncated(p: int, q: int) -> str:
    """Return p/q > 0 as a decimal of eight digits; one that goes on is cut off and ends in dots, so that all are right.

    >>> truncated(2, 3)
    '0.66666666\\\\ldots'
    """
    return _digits(Decimal(p), ROUND_DOWN, Decimal(q))


def rounded(number: Rational | Surd, digits: int = DIGITS) -> str:
    """Return a number as a decimal rounded to some significant digits, without the zeros at its end.

    >>> rounded(sp.QQ(-2, 3), 4)
    '-0.6667'
    """
    if isinstance(number, Surd):
        value, below = _surd_value(number.a, number.b, number.n), Decimal(number.d)
    else:
        value, below = Decimal(int(number.numerator)), Decimal(int(number.denominator))
    return _digits(value, ROUND_HALF_EVEN, below, digits)


def decimal_of(number: Rational | Surd, digits: int = DIGITS) -> str:
    """Return, as LaTeX, a number as a decimal behind its sign: ≈ where the decimal is rounded, otherwise =.

    >>> print(decimal_of(sp.QQ(196, 25)), decimal_of(sp.QQ(-2, 3), 4))
    = 7.84 \\approx -0.6667
    """
    irrational = isinstance(number, Surd) and number.b
    above, below = (number.a, number.d) if isinstance(number, Surd) else (number.numerator, number.denominator)
    goes_on = irrational or r"\ldots" in _digits(Decimal(int(above)), ROUND_DOWN, Decimal(int(below)), digits)
    sign = r"\approx" if goes_on else "="
    return f"{sign} {rounded(number, digits)}"


def _digits(value: Decimal, rounding: str, below: Decimal = Decimal(1), digits: int = DIGITS) -> str:
    """Return value/below in LaTeX with so many significant digits, with a power of ten where there are many zeros."""
    quotient = Context(prec=digits, rounding=rounding).divide(value, below)
    if not quotient:
        return "0"
    exponent = quotient.adjusted()
    has_power = not -5 <= exponent < digits
    text = f"{quotient.scaleb(-exponent) if has_power else quotient:f}"
    if rounding == ROUND_DOWN and _EXACTLY.multiply(quotient, below) != value:
        text += r"\ldots"
    elif "." in text:
        text = text.rstrip("0").rstrip(".")
    return rf"{text} \times 10^{{{exponent}}}" if has_power else text


def _sign(a: int, b: int, n: int) -> int:
    """Return the sign of a + b√n, from integers alone."""
    if a >= 0 and b >= 0:
        return 1
    if a <= 0 and b <= 0:
        return -1
    larger = a * a > b * b * n
    return (1 if a > 0 else -1) if larger else (1 if b > 0 else -1)


def _surd_value(a: int, b: int, n: int) -> Decimal:
    """Return a + b√n, rounded down, to 30 digits or more even where the two nearly cancel."""
    scale = 10 ** (40 + 2 * len(str(abs(a) + abs(b))))
    root = isqrt(b * b * n * scale * scale)
    return Context(prec=60).divide(Decimal(a * scale + (root if b > 0 else -root - 1)), Decimal(scale))
