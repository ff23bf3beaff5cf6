"""The values of a typed formula at three points, to 1,200 digits, and its unit.

Two formulas count as equal if they agree at all `POINTS`, whose coordinates have twelve random digits. Two different
rational formulas of degree 120 agree there with a probability below (240/(9·10¹¹))³ < 1e-28, by the lemma of Schwartz
and Zippel. Here 240 is the degree of the equation between the two formulas. The product of a hundred coordinates has
1,200 digits. Therefore two different fractions also differ within these digits if a numerator and a denominator
together have fewer names.
"""

import random
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import TypeAlias

import mpmath
import sympy as sp

from ramanujan.answers.formulas import is_decimal, leaves, replace_letters
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.derivation.model import COORDINATES, R, epsilon, k, m, m_prime
from ramanujan.numerals import superscript

_MP = mpmath.mp.clone()
_MP.dps = 1200
_AGREEING, _VANISHING = _MP.mpf(10) ** -1150, _MP.mpf(10) ** -1180
"""Relative differences below which two values count as equal, and a sum as zero."""

PreciseNumber: TypeAlias = mpmath.mpf
Values = tuple[PreciseNumber, ...]
Mistakes = tuple[tuple[str, Values], ...]
"""Pairs of a hint and the values of the formula that its mistake leads to."""


class NegativeRootError(ArithmeticError):
    """A root of a negative number."""


def evaluate(expression: sp.Expr, values: Mapping[sp.Expr, PreciseNumber]) -> PreciseNumber:
    """Return the value of a formula.

    Parameters
    ----------
    expression : a SymPy expression, which may be unevaluated
    values : symbol → its value

    Raises
    ------
    ArithmeticError : the formula divides by zero, or takes the root of a negative number (`NegativeRootError`).
    """
    if expression in values:
        return values[expression]
    if expression.is_Mul:
        return _MP.fprod(evaluate(part, values) for part in expression.args)
    if expression.is_Add:
        return _add_up([evaluate(part, values) for part in expression.args])
    if expression.is_Pow:
        return _compute_power(evaluate(expression.base, values), expression.exp)
    number = sp.Rational(str(expression))
    return _MP.mpf(number.p) / number.q


def _add_up(parts: list[PreciseNumber]) -> PreciseNumber:
    """Return a sum, exactly zero if the parts cancel up to rounding errors."""
    total = _MP.fsum(parts)
    if any(abs(total) < _VANISHING * abs(part) for part in parts):
        return _MP.zero
    return total


def _compute_power(base: PreciseNumber, exponent: sp.Rational) -> PreciseNumber:
    """Return a power with an integer or a half-integer exponent.

    Raises
    ------
    NegativeRootError : the power is the root of a negative number.
    """
    if exponent.is_Integer:
        return base ** int(exponent)
    if base < 0:
        raise NegativeRootError
    return _MP.sqrt(base) ** int(2 * exponent)


def make_point(**values: PreciseNumber | int) -> dict[sp.Expr, PreciseNumber]:
    """Return symbol → value for values by typed name, with ε = m′/m."""
    coordinates = {SYMBOLS[name]: _MP.convert(value) for name, value in values.items()}
    return coordinates | {epsilon: coordinates[m_prime] / coordinates[m]}


def _draw_points() -> tuple[dict[sp.Expr, PreciseNumber], ...]:
    source = random.Random(1729)
    points = []
    for sign in (1, -1, 1):
        values = {name: source.randrange(10**11, 10**12) for name in SYMBOLS if name != "eps"}
        # A negative X′ distinguishes √(X′²) from X′; φ′ stays positive, so X′φ′ is negative, too.
        for name in values:
            if name in MOTION and "phi" not in name:
                values[name] *= sign
        points.append(make_point(**values))
    return tuple(points)


POINTS = _draw_points()


@cache
def move_points(names: tuple[str, ...]) -> tuple[dict[sp.Expr, PreciseNumber], ...]:
    """Return `POINTS` with other values of these names; `eps` changes m′ and the mass ratio."""
    names = tuple("m'" if name == "eps" else name for name in names)
    next_points = POINTS[1:] + POINTS[:1]
    points = []
    for old, following in zip(POINTS, next_points, strict=True):
        moved = old | {SYMBOLS[name]: following[SYMBOLS[name]] + 1 for name in names}
        points.append(moved | {epsilon: moved[m_prime] / moved[m]})
    return tuple(points)


def evaluate_at_points(expression: sp.Expr, points: tuple[dict[sp.Expr, PreciseNumber], ...] = POINTS) -> Values:
    """Return the values of a formula at some points.

    Raises
    ------
    ArithmeticError : under the conditions of `evaluate`, at a point.
    """
    return tuple(evaluate(expression, values) for values in points)


def evaluate_quotients(expression: sp.Expr, names: tuple[str, ...]) -> Values:
    """Return values that do not change if the equation “expression = 0” is multiplied by a factor without `names`.

    The values are quotients of the expression at `POINTS` and at points with other values of `names`, so such a factor
    cancels.

    Raises
    ------
    ArithmeticError : under the conditions of `evaluate_at_points`.
    """
    numerators, denominators = evaluate_at_points(expression), evaluate_at_points(expression, move_points(names))
    return tuple(a / b if b else _MP.zero for a, b in zip(numerators, denominators, strict=True))


def agree(left: Values, right: Values) -> bool:
    """Return whether two formulas have the same values."""
    return all(abs(a - b) <= _AGREEING * abs(a) for a, b in zip(left, right, strict=True))


def find_rational_ratio(left: Values, right: Values) -> Fraction | None:
    """Return the quotient of two formulas if it is a rational number with a denominator up to 10⁶, else None."""
    if 0 in right:
        return None
    quotients = tuple(a / b for a, b in zip(left, right, strict=True))
    ratio = Fraction(_MP.nstr(quotients[0], 40)).limit_denominator(10**6)
    value = _MP.mpf(ratio.numerator) / ratio.denominator
    return ratio if agree(quotients, (value,) * len(quotients)) else None


def depends_on(expression: sp.Expr, symbol: sp.Expr, *, has_free_ratio: bool = False) -> bool:
    """Return whether the value of a formula changes with a symbol.

    Parameters
    ----------
    expression, symbol : the formula and the symbol
    has_free_ratio : whether ε is independent of the masses; otherwise it is m′/m
    """
    old = POINTS[0]
    moved = old | {symbol: old[symbol] + 1}
    if not has_free_ratio:
        moved[epsilon] = moved[m_prime] / moved[m]
    try:
        before, after = evaluate(expression, old), evaluate(expression, moved)
    except ArithmeticError:
        return True
    return not agree((before,), (after,))


# Decimals


def find_decimals(expression: sp.Expr) -> set[sp.Symbol]:
    """Return the decimal numbers in a formula."""
    return {symbol for symbol in expression.free_symbols if is_decimal(symbol)}


def compute_rounding_error(expression: sp.Expr, target: Values) -> PreciseNumber | None:
    """Return the rounding error of a decimal in the formula, in units of its last digit.

    The decimal rounds an exact number, with which the formula equals the target at all points. The rounding error is
    the difference between both numbers. Return None if no exact number exists within one and a half units. Return None
    also if the exact number has no more digits than the decimal: 0.6 instead of 0.5 is wrong, not rounded.
    """
    for decimal in find_decimals(expression):
        _whole, _point, places = decimal.name.partition(".")
        typed = _MP.mpf(decimal.name)
        unit = _MP.mpf(10) ** -len(places)
        try:
            exact = _find_exact_number(expression, decimal, target, typed - 3 * unit / 2, typed + 3 * unit / 2)
        except ArithmeticError:
            continue
        if exact is None:
            continue
        in_units = exact / unit
        needs_no_rounding = abs(in_units - _MP.nint(in_units)) <= _MP.mpf(10) ** -60
        if not needs_no_rounding:
            return abs(exact - typed) / unit
    return None


def _find_exact_number(
    expression: sp.Expr, decimal: sp.Symbol, target: Values, low: PreciseNumber, high: PreciseNumber
) -> PreciseNumber | None:
    """Return the number from low to high that makes the formula right if it replaces a decimal, or None."""

    def relative_error(number: PreciseNumber, point_number: int = 0) -> PreciseNumber:
        value = evaluate(expression, POINTS[point_number] | {decimal: number})
        return value / target[point_number] - 1

    if relative_error(low) * relative_error(high) >= 0:
        return None
    root = _MP.findroot(relative_error, (low, high), solver="anderson", tol=1e-120, maxsteps=60, verify=False)
    errors = [abs(relative_error(root, point_number)) for point_number in range(len(POINTS))]
    return root if max(errors) <= _MP.mpf(10) ** -80 else None


# Units


class DifferentUnitsError(ValueError):
    """Terms with different units are added; the arguments are the units as text."""


_KG, _M, _S = sp.symbols("kg m s", positive=True)
_UNITS = {m: _KG, m_prime: _KG, k: _KG / _S**2, R: _M, epsilon: sp.S.One}
for _q, _unit in zip(COORDINATES, (_M, sp.S.One, sp.S.One), strict=True):
    _UNITS |= {_q: _unit, _q.diff(): _unit / _S, _q.diff().diff(): _unit / _S**2}


def find_unit(expression: sp.Expr) -> str:
    """Return the unit of a formula, empty for a plain number; angles are plain numbers.

    Raises
    ------
    DifferentUnitsError : the formula adds terms with different units.

    >>> find_unit(k * R**2 / m)
    'm²/s²'
    """
    units = {}
    for leaf in leaves(expression):
        # A zero may be added to any unit.
        plain_number = sp.S.Zero if leaf == 0 else sp.S.One
        units[leaf] = _UNITS.get(leaf, plain_number)
    value = replace_letters(expression, units).doit()
    # Equal units have been added up, and a sum of plain numbers, such as 1 + √2, contains no symbol.
    sums_of_units = [total for total in value.atoms(sp.Add) if total.free_symbols]
    if sums_of_units:
        first, second, *_others = min(sums_of_units, key=sp.default_sort_key).args
        raise DifferentUnitsError(*sorted((_format_unit(first), _format_unit(second))))
    return _format_unit(value)


def _format_unit(value: sp.Expr) -> str:
    powers = value.as_powers_dict()
    above = [_format_power(base, powers[base]) for base in (_KG, _M, _S) if powers[base] > 0]
    below = [_format_power(base, -powers[base]) for base in (_KG, _M, _S) if powers[base] < 0]
    numerator, denominator = "·".join(above), "·".join(below)
    if not below:
        return numerator
    return f"{numerator or 1}/({denominator})" if len(below) > 1 else f"{numerator or 1}/{denominator}"


def _format_power(base: sp.Symbol, exponent: sp.Rational) -> str:
    if exponent == 1:
        return base.name
    return f"{base.name}{superscript(int(exponent))}" if exponent.is_Integer else f"{base.name}^({exponent})"
