"""What can be asked of a formula cheaply: its values, its unit, its length, and whether it is one reduced fraction.

Two formulas are compared by their values at fixed random points (Schwartz–Zippel), never by simplifying them: without
roots in exact fractions, with roots to so many digits that only equal formulas agree.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from decimal import Context, Decimal, DivisionByZero, InvalidOperation, Overflow, localcontext
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyElement, ring

from ramanujan.derivation.parser import NAMES, Expression, Name, Number, Power, Product, Sum
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime

SPELLING = dict(
    zip((m, m_prime, k, R, epsilon, *COORDINATES, *VELOCITIES),
        ("m", "m'", "k", "R", "eps", "X", "phi", "Phi", "X'", "phi'", "Phi'"), strict=True)
)  # fmt: skip
"""How one types a symbol of the derivation."""

UNITS = {
    "m": (1, 0, 0),
    "m'": (1, 0, 0),
    "k": (1, 0, -2),
    "R": (0, 1, 0),
    "X": (0, 1, 0),
    "X'": (0, 1, -1),
    "phi": (0, 0, 0),
    "phi'": (0, 0, -1),
    "Phi": (0, 0, 0),
    "Phi'": (0, 0, -1),
    "eps": (0, 0, 0),
}
"""Exponents of kg, m and s; angles and ε are plain numbers."""

Values = tuple[Fraction, ...] | tuple[Decimal, ...]
Unit = tuple[Fraction, ...]

_DIGITS, _AGREEING = 300, Decimal(10) ** -200
_CONTEXT = Context(prec=_DIGITS, traps=[DivisionByZero, InvalidOperation, Overflow])
"""With roots: digits carried, and the relative difference below which two values count as equal."""


class UnitError(ValueError):
    """A sum of unlike units; the message is one sentence for the student."""


def _points() -> Iterator[dict[str, Fraction]]:
    """Yield points at which two different formulas practically never agree; rates take both signs, ε is m′/m."""
    source = random.Random(1729)
    for sign in (1, -1, 1):  # of X and Φ against φ
        point = {name: Fraction(source.randrange(10**4, 10**5)) for name in NAMES}
        point |= {name: sign * point[name] for name in ("X", "X'", "Phi", "Phi'")}
        yield point | {"eps": point["m'"] / point["m"]}


POINTS = tuple(_points())


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
        raise ValueError(f"expression has no spelling as a formula: {expression}")
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


def has_root(expression: Expression) -> bool:
    """Tell whether there is a root in an expression."""
    halved = isinstance(expression, Power) and expression.exponent.denominator == 2
    return halved or any(map(has_root, parts(expression)))


def values(expression: Expression, exact: bool, points: tuple[Mapping[str, Fraction], ...] = POINTS) -> Values:
    """Return the values of an expression at the points, as fractions or, for roots, as long decimals.

    Raises
    ------
    ArithmeticError : the expression divides by zero or has a root of a negative number at a point.
    """
    if exact:
        return tuple(_value(expression, point, Fraction) for point in points)
    with localcontext(_CONTEXT):
        return tuple(_value(expression, point, _decimal) for point in points)


def agree(left: Values, right: Values) -> bool:
    """Tell whether two tuples of values, both exact or both decimal, are equal."""
    return all(map(_equal, left, right))


def ratio(left: Values, right: Values) -> Fraction | None:
    """Return the one simple number left/right at every point, or None."""
    if any(value == 0 for value in right):
        return None
    with localcontext(_CONTEXT):
        quotients = [a / b for a, b in zip(left, right, strict=True)]
        simple = Fraction(quotients[0]).limit_denominator(100)
        expected = simple if isinstance(quotients[0], Fraction) else _decimal(simple)
        return simple if simple and all(_equal(quotient, expected) for quotient in quotients) else None


def unit(expression: Expression) -> Unit:
    """Return the exponents of kg, m and s.

    Raises
    ------
    UnitError : the expression adds unlike units.
    """
    match expression:
        case Name(name):
            return tuple(map(Fraction, UNITS[name]))
        case Sum(terms):
            units = [unit(term) for term in terms]
            for other in units:
                if other != units[0]:
                    raise UnitError(f"You add {unit_text(units[0])} to {unit_text(other)}.")
            return units[0]
        case Product(factors):
            return tuple(map(sum, zip(*map(unit, factors), strict=True)))
        case Power(base, exponent):
            return tuple(exponent * n for n in unit(base))
    return (Fraction(0),) * 3


def unit_text(exponents: Unit) -> str:
    """Return a unit as text: kg·m^2/s^2, or "a plain number"."""
    above = [_unit_factor(name, n) for name, n in zip(("kg", "m", "s"), exponents, strict=True) if n > 0]
    below = [_unit_factor(name, -n) for name, n in zip(("kg", "m", "s"), exponents, strict=True) if n < 0]
    if not above and not below:
        return "a plain number"
    denominator = "·".join(below)
    return ("·".join(above) or "1") + (f"/({denominator})" if len(below) > 1 else f"/{denominator}" if below else "")


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


def has_like_terms(expression: Expression) -> bool:
    """Tell whether a sum has two terms of which one is a simple multiple of the other."""
    if isinstance(expression, Sum):
        exact = not has_root(expression)
        terms = [values(term, exact) for term in expression.terms]
        if any(ratio(one, other) is not None for one, other in combinations(terms, 2)):
            return True
    return any(map(has_like_terms, parts(expression)))


_UNITS_OF_A_PRODUCT = (Number(Fraction(1)), Number(Fraction(-1)))


def has_fraction_below(expression: Expression, below: bool = False) -> bool:
    """Tell whether there is a fraction in a denominator."""
    if isinstance(expression, Number):
        return below and expression.value.denominator != 1
    divides = isinstance(expression, Power) and expression.exponent < 0
    return (divides and below) or any(has_fraction_below(part, below or divides) for part in parts(expression))


def has_common_factor(expression: Expression) -> bool:
    """Tell whether a rational expression with names below has a factor or a number above and below that cancels."""
    numerator, denominator = _fraction(expression)
    return not denominator.is_ground and numerator.gcd(denominator) not in (1, -1)


_RING, *_GENERATORS = ring([f"x{i}" for i in range(len(NAMES))], sp.ZZ)
_GENERATOR = dict(zip(NAMES, _GENERATORS, strict=True))


def _fraction(expression: Expression) -> tuple[PolyElement, PolyElement]:
    """Return numerator and denominator as they stand, nothing cancelled."""
    match expression:
        case Name(name):
            return _GENERATOR[name], _RING.one
        case Number(value):
            return _RING(value.numerator), _RING(value.denominator)
        case Power(base, exponent):
            n = int(exponent)
            numerator, denominator = _fraction(base)
            return (numerator**n, denominator**n) if n >= 0 else (denominator**-n, numerator**-n)
    numerator, denominator = _RING(int(isinstance(expression, Product))), _RING.one
    for part in parts(expression):
        p, q = _fraction(part)
        numerator = numerator * p if isinstance(expression, Product) else numerator * q + denominator * p
        denominator = denominator * q
    return numerator, denominator


def _value(expression: Expression, point: Mapping[str, Fraction], number: Callable[[Fraction], Any]) -> Any:
    match expression:
        case Number(value):
            return number(value)
        case Name(name):
            return number(point[name])
        case Sum(terms):
            return sum(_value(term, point, number) for term in terms)
        case Power(base, exponent):
            value = _value(base, point, number)
            power = (value.sqrt() if exponent.denominator == 2 else value) ** abs(exponent.numerator)
            # A decimal 0 to the power −1 would be infinite without complaint; a division complains.
            return power if exponent >= 0 else 1 / power
    product = number(Fraction(1))
    for factor in expression.factors:
        product *= _value(factor, point, number)
    return product


def _decimal(value: Fraction) -> Decimal:
    return Decimal(value.numerator) / Decimal(value.denominator)


def _equal(left: Any, right: Any) -> bool:
    if isinstance(left, Fraction):
        return left == right
    with localcontext(_CONTEXT):
        return abs(left - right) <= _AGREEING * max(abs(left), abs(right))


def _unit_factor(name: str, exponent: Fraction) -> str:
    if exponent == 1:
        return name
    return f"{name}^{exponent}" if exponent.denominator == 1 else f"{name}^({exponent})"


def as_typed(expression: Expression) -> sp.Expr:
    """Return an expression in SymPy's symbols as it was typed; only the numbers of a product are drawn together."""
    match expression:
        case Number(value):
            return sp.Rational(value.numerator, value.denominator)
        case Name(name):
            return _SYMBOL[name]
        case Sum(terms):
            return sp.Add(*map(as_typed, terms), evaluate=False)
        case Power(base, exponent):
            power = sp.Rational(exponent.numerator, exponent.denominator)
            return sp.Pow(as_typed(base), power, evaluate=exponent == -1 and _is_nonzero_number(base))
    number, others = sp.S.One, []
    for factor in (part for typed in map(as_typed, expression.factors) for part in sp.Mul.make_args(typed)):
        if factor.is_Rational:
            number *= factor
        else:
            others.append(factor)
    return sp.Mul(*([number] if number != 1 or not others else []), *others, evaluate=False)


_SYMBOL = {name: symbol for symbol, name in SPELLING.items()}


def _is_nonzero_number(expression: Expression) -> bool:
    return isinstance(expression, Number) and expression.value != 0
