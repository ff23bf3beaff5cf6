"""Exact numbers (p + r√n)/q as LaTeX, and their decimals: “=” where a decimal is exact, “≈” where it is rounded."""

from __future__ import annotations

from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from functools import lru_cache
from math import gcd
from typing import NamedTuple

_EXACTLY = Context(prec=200)

LONG = 10**7
"""A denominator from this size on has too many digits to read; the number is then written as a decimal."""

DIGITS = 8
"""Significant digits of a decimal."""


class Number(NamedTuple):
    """(p + r√n)/q in lowest terms, q > 0; a fraction has r = 0."""

    p: int
    q: int = 1
    r: int = 0
    n: int = 1

    @classmethod
    def of(cls, p: int, r: int, q: int, n: int) -> Number:
        """Return (p + r√n)/q.

        >>> Number.of(-2, 2, 72, 1729)
        Number(p=-1, q=36, r=1, n=1729)
        """
        common = gcd(p, q, r) if q > 0 else -gcd(p, q, r)
        return cls(p // common, q // common, r // common, n)

    @property
    def numerator(self) -> Decimal:
        """p + r√n, to 40 digits or more even where the two terms nearly cancel."""
        if not self.r:
            return Decimal(self.p)
        context = Context(prec=40 + 2 * len(str(abs(self.p) + abs(self.r))))
        return context.fma(Decimal(self.r), context.sqrt(Decimal(self.n)), Decimal(self.p))


class Printed(NamedTuple):
    """A number as LaTeX: its sign (1, 0 or −1), numerator and denominator of its absolute value ("" for 1)."""

    sign: int
    above: str
    below: str = ""
    is_sum: bool = False

    @property
    def absolute(self) -> str:
        """The absolute value, in brackets if a minus sign before it would split it."""
        if self.below:
            return rf"\frac{{{self.above}}}{{{self.below}}}"
        return rf"\left({self.above}\right)" if self.is_sum and self.sign < 0 else self.above

    @property
    def says_all(self) -> bool:
        """Whether a decimal would add nothing: the number is an integer, or a decimal already."""
        return not self.below and (self.above.isdigit() or r"\ldots" in self.above)


@lru_cache(maxsize=4096)
def to_latex(number: Number) -> Printed:
    r"""Return a number as LaTeX: one fraction, no root below it; a long one as a decimal that ends in dots.

    >>> to_latex(Number(-3, 2)).absolute, to_latex(Number(37, 36, -1, 1729)).absolute
    ('\\frac{3}{2}', '\\frac{\\sqrt{1729} - 37}{36}')
    """
    value = number.numerator if number.r else number.p
    sign = (value > 0) - (value < 0)
    p, q, r = sign * number.p, number.q, sign * number.r
    if max(q, *((abs(p), abs(r)) if r else (0,))) >= LONG:
        return Printed(sign, truncated(number._replace(p=p, r=r)))
    common = gcd(p, r) if p and r else 1
    above, p, r = str(p), p // common, r // common
    if r:
        roots = rf"{abs(r)}\,\sqrt{{{number.n}}}" if abs(r) > 1 else rf"\sqrt{{{number.n}}}"
        # The absolute value is positive, so one of the two terms is, and it comes first.
        above = roots if not p else f"{roots} - {-p}" if p < 0 else f"{p} {'-' if r < 0 else '+'} {roots}"
    above = rf"{common}\,\left({above}\right)" if common > 1 else above
    return Printed(sign, above, str(q) if q > 1 else "", bool(p and r) and common == 1)


def truncated(number: Number) -> str:
    r"""Return a number > 0 as a decimal of eight digits; one that goes on is cut off and ends in dots.

    >>> truncated(Number(2, 3))
    '0.66666666\\ldots'
    """
    return _decimal(number, ROUND_DOWN, DIGITS, r"\ldots")[0]


def rounded(number: Number, digits: int = DIGITS) -> str:
    """Return a number as a decimal rounded to some significant digits, without the zeros at its end.

    >>> rounded(Number(-2, 3), 4)
    '-0.6667'
    """
    return _decimal(number, ROUND_HALF_EVEN, digits)[0]


def decimal_of(number: Number, digits: int = DIGITS) -> str:
    r"""Return, as LaTeX, a number as a decimal behind its sign: ≈ where the decimal is rounded, otherwise =.

    >>> decimal_of(Number(196, 25)), decimal_of(Number(-2, 3), 4)
    ('= 7.84', '\\approx -0.6667')
    """
    text, is_exact = _decimal(number, ROUND_HALF_EVEN, digits)
    return f"= {text}" if is_exact else rf"\approx {text}"


def _decimal(number: Number, rounding: str, digits: int, goes_on: str = "") -> tuple[str, bool]:
    """Return a decimal, with a power of ten where there are many zeros and a mark if it goes on, and if it is exact."""
    value = number.numerator
    quotient = Context(prec=digits, rounding=rounding).divide(value, number.q)
    if not quotient:
        return "0", True
    is_exact = not number.r and _EXACTLY.multiply(quotient, number.q) == value
    exponent = quotient.adjusted()
    has_power = not -5 <= exponent < digits
    text = f"{quotient.scaleb(-exponent) if has_power else quotient:f}"
    if is_exact or not goes_on:
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        text += goes_on
    return rf"{text} \times 10^{{{exponent}}}" if has_power else text, is_exact
