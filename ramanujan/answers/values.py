"""What a typed formula is worth: at a few points, in 1,200 digits, and in which unit.

Two formulas count as equal if they agree at all `POINTS`. Their coordinates have twelve random digits: by the lemma of
Schwartz and Zippel, two different rational formulas of degree 120 agree with a probability below 1e-29. A value carries
as many digits as a hundred names have together: fractions with fewer names in numerators and denominators differ
within these digits if they differ at all.
"""

import random
from collections.abc import Mapping
from fractions import Fraction
from functools import cache

import mpmath
import sympy as sp

from ramanujan.answers.formulas import is_decimal, leaves, replaced
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.derivation.model import COORDINATES, R, epsilon, k, m, m_prime
from ramanujan.numerals import superscript

_MP = mpmath.mp.clone()
_MP.dps = 1200
_AGREEING, _VANISHING = _MP.mpf(10) ** -1150, _MP.mpf(10) ** -1180
"""Relative differences below which two values count as equal, and a sum as zero."""

Number = mpmath.mpf
Values = tuple[Number, ...]
Mistakes = tuple[tuple[str, Values], ...]
"""Hints, and the values of what the mistake of each gives."""


class NegativeRootError(ArithmeticError):
    """A root of a negative number."""


def evaluate(expression: sp.Expr, values: Mapping[sp.Expr, Number]) -> Number:
    """Return the value of a formula.

    Parameters
    ----------
    expression : SymPy's nodes, unevaluated ones too
    values : symbol → its value

    Raises
    ------
    ArithmeticError : it divides by zero, or takes the root of a negative number (`NegativeRootError`).
    """
    if expression in values:
        return values[expression]
    if expression.is_Mul:
        return _MP.fprod(evaluate(part, values) for part in expression.args)
    if expression.is_Add:
        parts = [evaluate(part, values) for part in expression.args]
        total = _MP.fsum(parts)
        return _MP.zero if any(abs(total) < _VANISHING * abs(part) for part in parts) else total
    if expression.is_Pow:
        base = evaluate(expression.base, values)
        if base < 0 and not expression.exp.is_Integer:
            raise NegativeRootError
        return base ** int(expression.exp) if expression.exp.is_Integer else _MP.sqrt(base) ** int(2 * expression.exp)
    number = sp.Rational(str(expression))
    return _MP.mpf(number.p) / number.q


def point(**values: Number | int) -> dict[sp.Expr, Number]:
    """Return symbol → value with ε = m′/m, the other values by the names as they are typed in a formula."""
    known = {SYMBOLS[name]: _MP.convert(value) for name, value in values.items()}
    return known | {epsilon: known[m_prime] / known[m]}


def _points() -> tuple[dict[sp.Expr, Number], ...]:
    source = random.Random(1729)
    found = []
    for sign in (1, -1, 1):
        drawn = {name: source.randrange(10**11, 10**12) for name in SYMBOLS if name != "eps"}
        # Velocities take both signs against each other, so that √(X′²) is told from X′.
        signed = {name: sign * x if name in MOTION and "phi" not in name else x for name, x in drawn.items()}
        found.append(point(**signed))
    return tuple(found)


POINTS = _points()


@cache
def moved_points(names: tuple[str, ...]) -> tuple[dict[sp.Expr, Number], ...]:
    """Return `POINTS` with other values of these names, eps among them for the mass ratio."""
    names = tuple("m'" if name == "eps" else name for name in names)
    found = []
    for here, there in zip(POINTS, POINTS[1:] + POINTS[:1], strict=True):
        moved = here | {SYMBOLS[name]: there[SYMBOLS[name]] + 1 for name in names}
        found.append(moved | {epsilon: moved[m_prime] / moved[m]})
    return tuple(found)


def at_points(expression: sp.Expr, points: tuple[dict[sp.Expr, Number], ...] = POINTS) -> Values:
    """Return the values of a formula at some points.

    Raises
    ------
    ArithmeticError : it divides by zero, or takes the root of a negative number (`NegativeRootError`), at a point.
    """
    return tuple(evaluate(expression, known) for known in points)


def up_to_a_factor(expression: sp.Expr, names: tuple[str, ...]) -> Values:
    """Return values in which the equation “expression = 0” has, whatever it is multiplied by.

    They are quotients of its values at points that differ in these names alone: a factor without them cancels.

    Raises
    ------
    ArithmeticError : as `at_points` does.
    """
    here, there = at_points(expression), at_points(expression, moved_points(names))
    return tuple(a / b if b else _MP.zero for a, b in zip(here, there, strict=True))


def agree(left: Values, right: Values) -> bool:
    """Tell whether two formulas have the same values."""
    return all(abs(a - b) <= _AGREEING * abs(a) for a, b in zip(left, right, strict=True))


def rational_ratio(left: Values, right: Values) -> Fraction | None:
    """Return the rational number that is the quotient of two formulas, None if there is none, or only a long one."""
    if 0 in right:
        return None
    quotients = tuple(a / b for a, b in zip(left, right, strict=True))
    found = Fraction(_MP.nstr(quotients[0], 40)).limit_denominator(10**6)
    return found if agree(quotients, (_MP.mpf(found.numerator) / found.denominator,) * len(quotients)) else None


def depends_on(expression: sp.Expr, symbol: sp.Expr, *, of_ratio: bool = False) -> bool:
    """Tell whether a formula changes with a symbol; unless it is a formula in the ratio, ε changes with the masses."""
    known = POINTS[0]
    moved = known | {symbol: known[symbol] + 1}
    if not of_ratio:
        moved[epsilon] = moved[m_prime] / moved[m]
    try:
        values = [evaluate(expression, each) for each in (known, moved)]
    except ArithmeticError:
        return True
    return not agree(values[:1], values[1:])


# Decimals


def decimals(expression: sp.Expr) -> set[sp.Symbol]:
    """Return the decimal numbers that were typed in a formula."""
    return {symbol for symbol in expression.free_symbols if is_decimal(symbol)}


def units_off(expression: sp.Expr, target: Values) -> Number | None:
    """Return by how many units of its last digit a decimal of the formula differs from the number that is meant.

    That number makes the formula right at all points. None if there is none within one and a half units, or if it
    needs no rounding: who types 0.6 for ½ has not rounded.
    """
    for decimal in decimals(expression):
        typed, unit = _MP.mpf(decimal.name), _MP.mpf(10) ** -len(decimal.name.partition(".")[2])
        try:
            meant = _meant(expression, decimal, target, typed - 3 * unit / 2, typed + 3 * unit / 2)
        except ArithmeticError:
            continue
        if meant is None:
            continue
        if abs(meant / unit - _MP.nint(meant / unit)) > _MP.mpf(10) ** -60:
            return abs(meant - typed) / unit
    return None


def _meant(expression: sp.Expr, decimal: sp.Symbol, target: Values, low: Number, high: Number) -> Number | None:
    def error(x: Number, i: int = 0) -> Number:
        return evaluate(expression, POINTS[i] | {decimal: x}) / target[i] - 1

    if error(low) * error(high) >= 0:
        return None
    found = _MP.findroot(error, (low, high), solver="anderson", tol=1e-120, maxsteps=60, verify=False)
    exact = all(abs(error(found, i)) <= _MP.mpf(10) ** -80 for i in range(len(POINTS)))
    return found if exact else None


# Units


class DifferentUnitsError(ValueError):
    """Terms with different units are added; the arguments are the units as text."""


_KG, _M, _S = sp.symbols("kg m s", positive=True)
_UNITS = {m: _KG, m_prime: _KG, k: _KG / _S**2, R: _M, epsilon: sp.S.One}
for _q, _unit in zip(COORDINATES, (_M, sp.S.One, sp.S.One), strict=True):
    _UNITS |= {_q: _unit, _q.diff(): _unit / _S, _q.diff().diff(): _unit / _S**2}


def unit(expression: sp.Expr) -> str:
    """Return the unit of a formula as typed, empty for a plain number; angles are plain numbers.

    Raises
    ------
    DifferentUnitsError : it adds terms with different units.

    >>> unit(k * R**2 / m)
    'm²/s²'
    """
    # A zero that is added has any unit.
    units = {leaf: _UNITS.get(leaf, sp.S.Zero if leaf == 0 else sp.S.One) for leaf in leaves(expression)}
    value = replaced(expression, units).doit()
    # A sum of plain numbers, such as 1 + √2, has no unit.
    for total in sorted((each for each in value.atoms(sp.Add) if each.free_symbols), key=sp.default_sort_key):
        raise DifferentUnitsError(*sorted(_unit_text(term) for term in total.args[:2]))
    return _unit_text(value)


def _unit_text(value: sp.Expr) -> str:
    powers = value.as_powers_dict()
    above, below = (
        "·".join(_power(each, sign * powers[each]) for each in (_KG, _M, _S) if sign * powers[each] > 0)
        for sign in (1, -1)
    )
    if not below:
        return above
    return f"{above or 1}/({below})" if "·" in below else f"{above or 1}/{below}"


def _power(base: sp.Symbol, exponent: sp.Rational) -> str:
    if exponent == 1:
        return base.name
    return f"{base.name}{superscript(int(exponent))}" if exponent.is_Integer else f"{base.name}^({exponent})"
