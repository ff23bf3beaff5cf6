"""Formulas as they were typed, SymPy's nodes unevaluated: their size and their letters."""

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction

import sympy as sp


def is_number(token: object) -> bool:
    """Tell whether this is a number as typed: a whole number, a fraction such as ½, or a decimal."""
    return isinstance(token, sp.Rational) or is_decimal(token)


def is_decimal(token: object) -> bool:
    """Tell whether this is a number typed with a decimal point."""
    return isinstance(token, sp.Symbol) and token.name[:1] in "0123456789."


def weights(expression: sp.Expr) -> Counter[sp.Expr]:
    """Return how often each number and name is there when every power is written out: a bound on its degree."""
    if expression.is_Pow:
        times = max(1, int(sp.ceiling(abs(expression.exp))))
        return Counter({leaf: times * n for leaf, n in weights(expression.base).items()})
    if expression.is_Add or expression.is_Mul:
        return sum(map(weights, expression.args), Counter())
    return Counter([expression])


def length(expression: sp.Expr) -> int:
    """Return how long a formula is to write: a sign for each name, digit of a number, exponent and root."""
    if is_number(expression):
        p, q = Fraction(str(abs(expression) if expression.is_Rational else expression)).as_integer_ratio()
        # A sign, and the 1 above a fraction line, take no room.
        return (len(str(p)) if p != 1 or q == 1 else 0) + (len(str(q)) if q != 1 else 0)
    if expression.is_Pow:
        return length(expression.base) + (abs(expression.exp) != 1)
    if expression.is_Mul:
        return sum(length(factor) for factor in expression.args if factor not in (1, -1))
    return sum(map(length, expression.args)) if expression.is_Add else 1


def leaves(expression: sp.Expr) -> set[sp.Expr]:
    """Return the numbers and names of which a formula is made; exponents do not count."""
    return set(weights(expression))


def replaced(expression: sp.Expr, values: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """Return a formula with other expressions in the place of some letters, still unevaluated."""
    if expression.is_Pow:
        return sp.Pow(replaced(expression.base, values), expression.exp, evaluate=False)
    if not (expression.is_Add or expression.is_Mul):
        return values.get(expression, expression)
    return expression.func(*(replaced(part, values) for part in expression.args), evaluate=False)


def without_signs(expression: sp.Expr) -> sp.Expr:
    """Return a formula, still unevaluated, in which every minus sign is a plus: no two of its terms cancel."""
    return replaced(expression, {leaf: abs(leaf) for leaf in leaves(expression) if leaf.is_Rational})
