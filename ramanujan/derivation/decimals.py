"""Formulas in 300 decimal digits: for formulas without a normal form, and for answers with a decimal number.

Two formulas that agree to two hundred digits at every point count as equal; only here does the judge use samples. The
points are random but always the same, and velocities take both signs.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from decimal import ROUND_HALF_EVEN, Context, Decimal, DivisionByZero, InvalidOperation, Overflow, localcontext
from fractions import Fraction

from ramanujan.derivation.expressions import NAMES, Expression, Name, Number, Power, Sum, numbers

_DIGITS, _AGREEING = 300, Decimal(10) ** -200
_CONTEXT = Context(prec=_DIGITS, rounding=ROUND_HALF_EVEN, traps=[DivisionByZero, InvalidOperation, Overflow])
"""Digits carried, and the relative difference below which two values count as equal."""

_ITERATIONS, _FOUND = 60, Decimal(10) ** -80

Point = Mapping[str, Decimal]
Values = tuple[Decimal, ...]


class RootOfNegativeError(ArithmeticError):
    """A root of a negative number, at one of the points at least."""


def _points() -> Iterator[Point]:
    """Yield points at which two different formulas practically never agree; ε is m′/m."""
    source = random.Random(1729)
    for sign in (1, -1, 1):  # of X and Φ against φ
        point = {name: Decimal(source.randrange(10**40, 10**41)) / 10**36 for name in NAMES}
        point |= {name: sign * point[name] for name in ("X", "X'", "Phi", "Phi'")}
        yield point | {"eps": point["m'"] / point["m"]}


with localcontext(_CONTEXT):
    POINTS = tuple(_points())


def values(expression: Expression, points: tuple[Point, ...] = POINTS) -> Values:
    """Return the values of an expression at the points.

    Raises
    ------
    RootOfNegativeError : the expression has a root of a negative number at a point.
    ArithmeticError : it divides by zero there.
    """
    with localcontext(_CONTEXT):
        return tuple(_value(expression, point, None) for point in points)


def value_at(expression: Expression, point: Mapping[str, Decimal]) -> Decimal:
    """Return the value of an expression at one point."""
    with localcontext(_CONTEXT):
        return _value(expression, point, None)


def agree(left: Values, right: Values) -> bool:
    """Tell whether two tuples of values are equal."""
    with localcontext(_CONTEXT):
        return all(_close(a, b, _AGREEING) for a, b in zip(left, right, strict=True))


def rounded(expression: Expression, exact: Values) -> bool:
    """Tell whether an expression becomes exact if one of its decimal numbers changes by less than its last digit.

    The number that makes it exact at the first point has to do so at the others, too.

    Parameters
    ----------
    expression : a formula, with decimal numbers or without
    exact : the values that it should have at `POINTS`
    """
    decimals = [number for number in numbers(expression) if number.places]
    with localcontext(_CONTEXT):
        return any(_stands_for(expression, number, exact) for number in decimals)


def _stands_for(expression: Expression, number: Number, exact: Values) -> bool:
    try:
        found = _solve(expression, number, exact[0])
        return found is not None and all(
            _close(_value(expression, point, (number, found)), value, _FOUND)
            for point, value in zip(POINTS, exact, strict=True)
        )
    except ArithmeticError:
        return False


def _solve(expression: Expression, number: Number, target: Decimal) -> Decimal | None:
    """Return the number less than one last digit away that gives the target at the first point, by false position."""

    def error(x: Decimal) -> Decimal:
        return _value(expression, POINTS[0], (number, x)) - target

    middle, digit = _decimal(number.value), Decimal(10) ** -number.places
    low, high = middle - digit, middle + digit
    at_low, at_high = error(low), error(high)
    if at_low * at_high >= 0:
        return None
    for _ in range(_ITERATIONS):
        x = high - at_high * (high - low) / (at_high - at_low)
        at_x = error(x)
        if at_x == 0 or abs(at_x) < _FOUND * abs(target) / 1000:
            return x
        if at_x * at_high < 0:
            low, at_low = high, at_high
        else:
            # The Illinois rule: an end that stays counts half, so that both ends close in.
            at_low /= 2
        high, at_high = x, at_x
    return None


def _value(expression: Expression, point: Point, replaced: tuple[Number, Decimal] | None) -> Decimal:
    match expression:
        case Number(value):
            # The very number that was typed, not any other that happens to equal it.
            return replaced[1] if replaced and expression is replaced[0] else _decimal(value)
        case Name(name):
            return point[name]
        case Sum(terms):
            return sum((_value(term, point, replaced) for term in terms), Decimal(0))
        case Power(base, exponent):
            value = _value(base, point, replaced)
            if exponent.denominator == 2 and value < 0:
                raise RootOfNegativeError
            power = (value.sqrt() if exponent.denominator == 2 else value) ** abs(exponent.numerator)
            # A decimal 0 to the power −1 would be infinite without complaint; a division complains.
            return power if exponent >= 0 else 1 / power
    product = Decimal(1)
    for factor in expression.factors:
        product *= _value(factor, point, replaced)
    return product


def _decimal(value: Fraction) -> Decimal:
    return Decimal(value.numerator) / Decimal(value.denominator)


def _close(left: Decimal, right: Decimal, relative: Decimal) -> bool:
    return abs(left - right) <= relative * max(abs(left), abs(right))
