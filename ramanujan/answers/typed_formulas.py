"""The size and the letters of typed formulas, which are unevaluated SymPy expressions."""

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction

import sympy as sp


def is_number(token: object) -> bool:
    """Return whether a token is a typed number: a whole number, a fraction such as ½, or a decimal."""
    return isinstance(token, sp.Rational) or is_decimal(token)


def is_decimal(token: object) -> bool:
    """Return whether a token is a number with a decimal point."""
    return isinstance(token, sp.Symbol) and token.name[:1] in "0123456789."


def count_leaves(expression: sp.Expr) -> Counter[sp.Expr]:
    """Count the occurrences of each number and name, with every power written out as a product.

    The count of a name bounds the degree of the formula in it.
    """
    if expression.is_Pow:
        times = max(1, int(sp.ceiling(abs(expression.exp))))
        return Counter({leaf: times * count for leaf, count in count_leaves(expression.base).items()})
    if expression.is_Add or expression.is_Mul:
        return sum(map(count_leaves, expression.args), Counter())
    return Counter([expression])


def length(expression: sp.Expr) -> int:
    """Return the written length of a formula: 1 for each name, digit, exponent and root."""
    if is_number(expression):
        # The name of a decimal's symbol contains its digits.
        size = abs(expression) if expression.is_Rational else expression
        p, q = Fraction(str(size)).as_integer_ratio()
        # The 1 above a fraction line does not count.
        above = 0 if p == 1 and q != 1 else len(str(p))
        below = 0 if q == 1 else len(str(q))
        return above + below
    if expression.is_Pow:
        return length(expression.base) + (abs(expression.exp) != 1)
    if expression.is_Mul:
        return sum(length(factor) for factor in expression.args if factor not in (1, -1))
    if expression.is_Add:
        return sum(map(length, expression.args))
    return 1


def leaves(expression: sp.Expr) -> set[sp.Expr]:
    """Return the numbers and names in a formula, without its exponents."""
    return set(count_leaves(expression))


def replace_letters(expression: sp.Expr, values: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """Replace some letters of a formula by other expressions, without evaluation."""
    if expression.is_Pow:
        return sp.Pow(replace_letters(expression.base, values), expression.exp, evaluate=False)
    if not (expression.is_Add or expression.is_Mul):
        return values.get(expression, expression)
    return expression.func(*(replace_letters(part, values) for part in expression.args), evaluate=False)
