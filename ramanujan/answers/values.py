"""The value of a typed formula: an exact fraction, and with a root numbers of 60 digits; its unit.

A formula without a root is an element of a field, where equal formulas are equal elements. A formula with a root has
numbers at three random points instead. Two such formulas count as equal if they agree there to 50 digits.
"""

import random
from collections.abc import Mapping
from contextlib import suppress
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import mpmath
import sympy as sp
from sympy.polys.fields import FracElement

from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.terms import RootError, to_fraction
from ramanujan.answers.typed_formulas import is_decimal, leaves, replace_letters
from ramanujan.derivation.model import COORDINATES, R, epsilon, k, m, m_prime
from ramanujan.text.numerals import superscript

_MP = mpmath.mp.clone()
_MP.dps = 60
_EQUAL = _MP.mpf(10) ** -50
"""A relative difference below which two values count as equal, and a sum as zero."""

PreciseNumber: TypeAlias = mpmath.mpf
Values = tuple[PreciseNumber, ...]


class Formula:
    """A formula with its exact value, and its values at `POINTS`.

    Parameters
    ----------
    expression : a SymPy expression, which may be unevaluated
    is_in_ratio : as for `terms.to_fraction`

    Raises
    ------
    UnreadableError, ZeroDivisionError : under the conditions of `terms.to_fraction`.
    """

    def __init__(self, expression: sp.Expr, *, is_in_ratio: bool = False) -> None:
        self.expression = expression
        self.fraction: FracElement | None = None
        """The formula in lowest terms, None for a formula with a root."""
        with suppress(RootError):
            self.fraction = to_fraction(expression, is_in_ratio=is_in_ratio)

    @cached_property
    def values(self) -> Values:
        """The values at `POINTS`.

        Raises
        ------
        ArithmeticError : under the conditions of `evaluate`.
        """
        return tuple(evaluate(self.expression, point) for point in POINTS)

    @property
    def is_zero(self) -> bool:
        """Whether the formula vanishes."""
        return not (self.fraction if self.fraction is not None else any(self.values))

    @property
    def has_decimals(self) -> bool:
        """Whether the formula contains a number with a decimal point."""
        return any(map(is_decimal, leaves(self.expression)))

    def equals(self, other: "Formula") -> bool:
        """Return whether two formulas have the same value."""
        if self.fraction is not None and other.fraction is not None:
            return self.fraction == other.fraction
        return agree(self.values, other.values)


Mistakes = tuple[tuple[str, Formula], ...]
"""Pairs of a hint and the formula that its mistake leads to."""


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
    if any(abs(total) < _EQUAL * abs(part) for part in parts):
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


def _draw_points() -> tuple[dict[sp.Expr, PreciseNumber], ...]:
    source = random.Random(1729)
    points = []
    for sign in (1, -1, 1):
        # Coordinates of similar size give each term a share of the value, so a value is close only if all terms are.
        values = {name: 1 + _MP.mpf(source.randrange(10**12)) / 10**12 for name in SYMBOLS if name != "eps"}
        # A negative X′ distinguishes √(X′²) from X′; φ′ stays positive, so X′φ′ is negative, too.
        for name in values:
            if name in MOTION and "phi" not in name:
                values[name] *= sign
        coordinates = {SYMBOLS[name]: value for name, value in values.items()}
        points.append(coordinates | {epsilon: coordinates[m_prime] / coordinates[m]})
    return tuple(points)


POINTS = _draw_points()


def agree(left: Values, right: Values) -> bool:
    """Return whether two formulas have the same values at some points."""
    return all(abs(a - b) <= _EQUAL * abs(a) for a, b in zip(left, right, strict=True))


def find_distance(values: Values, target: Values) -> PreciseNumber:
    """Return the largest relative difference of some values from a target without zeros."""
    return max(abs(value / wanted - 1) for value, wanted in zip(values, target, strict=True))


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
