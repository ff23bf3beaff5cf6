"""A formula as a tree: the parser returns one, and a derived SymPy expression is turned into one for comparison.

A tree keeps the formula as typed; nothing is evaluated. `typeset` writes it as LaTeX, `length` measures how long it is.
`normal_form` decides which formulas are equal.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import ceil, gcd

import sympy as sp

from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime
from ramanujan.translation import _

NAMES = ("m", "m'", "k", "R", "X", "X'", "phi", "phi'", "Phi", "Phi'", "eps")
"""Every name the grammar knows, as one types it."""

SPELLING = dict(
    zip((m, m_prime, k, R, epsilon, *COORDINATES, *VELOCITIES),
        ("m", "m'", "k", "R", "eps", "X", "phi", "Phi", "X'", "phi'", "Phi'"), strict=True)
)  # fmt: skip
"""How one types a symbol of the derivation."""


@dataclass(frozen=True)
class Number:
    """A number as typed: 0.5 equals ½, but `places` remembers how many decimals were given (None: no decimal point)."""

    value: Fraction
    places: int | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Name:
    """One of `NAMES`."""

    name: str


@dataclass(frozen=True)
class Sum:
    """The sum of its terms; what is subtracted is a term times −1."""

    terms: tuple[Expression, ...]


@dataclass(frozen=True)
class Product:
    """The product of its factors; what divides is a factor to a negative power."""

    factors: tuple[Expression, ...]


@dataclass(frozen=True)
class Power:
    """base ^ exponent; the exponent is a multiple of ½, so that a quotient and a root are powers too."""

    base: Expression
    exponent: Fraction


Expression = Number | Name | Sum | Product | Power


def spelled(expression: sp.Expr) -> Expression:
    """Return a SymPy expression of the derivation as a tree like those that the parser returns.

    Raises
    ------
    ValueError : expression is not made of known symbols, numbers, sums, products and powers; infinities are not.
    """
    if expression in SPELLING:
        return Name(SPELLING[expression])
    if expression.is_Rational:
        return Number(Fraction(int(expression.p), int(expression.q)))
    if expression.is_Pow:
        return Power(spelled(expression.base), spelled(expression.exp).value)
    if not (expression.is_Add or expression.is_Mul):
        unknown = _("expression cannot be written in the grammar: {expression}")
        raise ValueError(unknown.format(expression=expression))
    inside = tuple(map(spelled, expression.args))
    return Sum(inside) if expression.is_Add else Product(inside)


def parts(expression: Expression) -> tuple[Expression, ...]:
    """Return the expressions of which an expression is made."""
    match expression:
        case Sum(inside) | Product(inside):
            return inside
        case Power(base, _):
            return (base,)
    return ()


def names(expression: Expression) -> frozenset[str]:
    """Return the names in an expression."""
    if isinstance(expression, Name):
        return frozenset({expression.name})
    return frozenset().union(*map(names, parts(expression)))


def numbers(expression: Expression) -> tuple[Number, ...]:
    """Return the numbers in an expression, in the order in which they were typed; exponents do not count."""
    if isinstance(expression, Number):
        return (expression,)
    return tuple(number for part in parts(expression) for number in numbers(part))


def weight(expression: Expression) -> int:
    """Return how many numbers and names there are when every power is written out: a bound on degree and digits."""
    match expression:
        case Sum(inside) | Product(inside):
            return sum(map(weight, inside))
        case Power(base, exponent):
            return weight(base) * max(1, ceil(abs(exponent)))
    return 1


def length(expression: Expression) -> int:
    """Return how long an expression is to write: a sign for each name, digit of a number, exponent and root."""
    match expression:
        case Name():
            return 1
        case Number(value):
            p, q = abs(value.numerator), value.denominator
            return (len(str(p)) if p != 1 or q == 1 else 0) + (len(str(q)) if q != 1 else 0)
        case Power(base, exponent):
            return length(base) + (abs(exponent) != 1)
        case Product(factors):
            # A sign, and the 1 above a fraction line, take no room.
            return sum(length(factor) for factor in factors if factor not in _UNITS_OF_A_PRODUCT)
    return sum(map(length, parts(expression)))


_UNITS_OF_A_PRODUCT = (Number(Fraction(1)), Number(Fraction(-1)))


# LaTeX

_LATEX = {name: latex(symbol) for symbol, name in SPELLING.items()}
_IN_SUM, _IN_PRODUCT, _IN_POWER = range(3)


def typeset(expression: Expression) -> str:
    """Return the LaTeX of an expression as it was typed: nothing is evaluated, gathered or reordered."""
    return _typeset(expression, _IN_SUM)


def _typeset(expression: Expression, place: int) -> str:
    """Return the LaTeX of an expression, in brackets where its place requires them."""
    match expression:
        case Name(name):
            return f"{{{_LATEX[name]}}}" if place == _IN_POWER and "'" in _LATEX[name] else _LATEX[name]
        case Number(value, places):
            text = _number(value, places)
            return _bracketed(text, value < 0 or (place == _IN_POWER and "frac" in text), place)
        case Sum(terms):
            return _bracketed(_sum(terms), True, place)
        case Power(base, exponent) if exponent < 0:
            return _fraction(Number(Fraction(1)), (_without_sign(expression),))
        case Power(base, exponent):
            return _power(base, exponent)
        case Product(factors):
            return _bracketed(_product(factors), place == _IN_POWER or _negative(expression), place)
    raise TypeError(f"expression is not a formula: {expression!r}")


def _bracketed(text: str, needed: bool, place: int) -> str:
    return rf"\left({text}\right)" if needed and place != _IN_SUM else text


def _number(value: Fraction, places: int | None) -> str:
    if places is not None:
        digits = f"{abs(value.numerator) * 10**places // value.denominator:0{places + 1}d}"
        shown = f"{digits[: len(digits) - places]}.{digits[len(digits) - places :]}".rstrip(".")
    elif value.denominator == 1:
        shown = str(abs(value.numerator))
    else:
        shown = rf"\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
    return f"- {shown}" if value < 0 else shown


def _sum(terms: tuple[Expression, ...]) -> str:
    shown = _term(terms[0])
    for term in terms[1:]:
        text = _term(term)
        shown += f" {text}" if text.startswith("-") else f" + {text}"
    return shown


def _term(term: Expression) -> str:
    """Return a term of a sum; a sum as a term was in brackets, and stays there."""
    return _typeset(term, _IN_PRODUCT if isinstance(term, Sum) else _IN_SUM)


def _power(base: Expression, exponent: Fraction) -> str:
    if exponent == Fraction(1, 2):
        return rf"\sqrt{{{_typeset(base, _IN_SUM)}}}"
    inner = _typeset(base, _IN_POWER)
    if isinstance(base, Power):
        inner = rf"\left({inner}\right)"
    shown = str(exponent.numerator) if exponent.denominator == 1 else f"{exponent.numerator}/{exponent.denominator}"
    return inner if exponent == 1 else f"{inner}^{{{shown}}}"


def _product(factors: tuple[Expression, ...]) -> str:
    if _negative(factors[0]):
        # One minus sign before the whole product, and not above its fraction line.
        positive = (_without_minus(factors[0]), *factors[1:])
        rest = tuple(f for f in positive if f != Number(Fraction(1))) or (Number(Fraction(1)),)
        return f"- {_typeset(rest[0] if len(rest) == 1 else Product(rest), _IN_PRODUCT)}"
    factors = tuple(_quotients(factors))
    below = tuple(_without_sign(factor) for factor in factors if _divides(factor))
    above = tuple(factor for factor in factors if not _divides(factor))
    if below:
        return _fraction(above[0] if len(above) == 1 else Product(above or (Number(Fraction(1)),)), below)
    shown = [_typeset(factor, _IN_PRODUCT) for factor in factors]
    text = shown[0]
    for before, after in pairwise(shown):
        # Two digits side by side would read as one number.
        digits = (before[-1].isdigit() or before.endswith("}")) and after[0].isdigit()
        text += (r" \cdot " if digits or after.startswith(r"\frac") else r"\,") + after
    return text


def _quotients(factors: tuple[Expression, ...]) -> Iterator[Expression]:
    """Yield the factors, a whole number over a whole number as one fraction: 1/2 m reads ½ m."""
    waiting = list(factors)
    while waiting:
        match waiting:
            case [Number(p, None), Power(Number(q, None), minus_one), *_] if (
                minus_one == -1
                and len(factors) > 2
                and p.denominator == q.denominator == 1
                and gcd(int(p), int(q)) == 1 < q
            ):
                yield Number(p / q)
                del waiting[:2]
            case _:
                yield waiting.pop(0)


def _fraction(above: Expression, below: tuple[Expression, ...]) -> str:
    denominator = below[0] if len(below) == 1 else Product(below)
    return rf"\frac{{{_typeset(above, _IN_SUM)}}}{{{_typeset(denominator, _IN_SUM)}}}"


def _divides(factor: Expression) -> bool:
    return isinstance(factor, Power) and factor.exponent < 0


def _without_sign(power: Power) -> Expression:
    """Return a power with the opposite exponent: what a divisor looks like below the fraction line."""
    return power.base if power.exponent == -1 else Power(power.base, -power.exponent)


def _negative(expression: Expression) -> bool:
    """Tell whether an expression begins with a minus sign."""
    match expression:
        case Number(value):
            return value < 0
        case Product(factors):
            return _negative(factors[0])
    return False


def _without_minus(expression: Expression) -> Expression:
    if isinstance(expression, Number):
        return Number(-expression.value, expression.places)
    first = _without_minus(expression.factors[0])
    rest = expression.factors[1:] if first == Number(Fraction(1)) else (first, *expression.factors[1:])
    return rest[0] if len(rest) == 1 else Product(rest)
