"""What a right formula still lacks to be a simplified one."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations
from math import gcd

import sympy as sp
from sympy.ntheory.factor_ import core

from ramanujan.answers import terms
from ramanujan.answers.formulas import is_number, length
from ramanujan.answers.values import at_points, rational_ratio
from ramanujan.translation import _


def to_simplify(typed: sp.Expr, right: sp.Expr, longest: int) -> str | None:
    """Return what is left to simplify, or None.

    Parameters
    ----------
    typed : a right formula, as typed
    right : the derived one
    longest : the length of the longest form that counts as simplified
    """
    parts = list(_parts(typed))
    roots = list(filter(_is_root, parts))
    if any(part.is_Add and _has_like_terms(part) for part in parts):
        return _("Can you combine the like terms?")
    if any(map(_can_be_taken, roots)):
        return _("Can you simplify a root, or the expression under it?")
    if roots and not any(map(_is_root, _parts(right))):
        return _("The formula can be written without a root.")
    if length(typed) > longest:
        return _("The formula can be written shorter.")
    if _has_fraction_below(typed, False):
        return _("Can you remove the fraction inside the denominator?")
    if any(part.is_Mul and _cancels(part) for part in parts):
        return _("Can you cancel a common factor of numerator and denominator?")
    return None


def _parts(expression: sp.Expr) -> Iterator[sp.Expr]:
    yield expression
    if expression.is_Add or expression.is_Mul or expression.is_Pow:
        for part in expression.args[: 1 if expression.is_Pow else None]:
            yield from _parts(part)


def _is_root(expression: sp.Expr) -> bool:
    return bool(expression.is_Pow and not expression.exp.is_Integer)


def _has_like_terms(total: sp.Expr) -> bool:
    """Tell whether a sum has a term that is zero, or two terms of which one is a multiple of the other."""
    values = [at_points(term) for term in total.args]
    return not all(map(any, values)) or any(rational_ratio(*pair) is not None for pair in combinations(values, 2))


def _can_be_taken(root: sp.Expr) -> bool:
    """Tell whether something can be taken out of a root, or worked out under it: √12, √(m²), √(12·144 + 1)."""
    if is_number(root.base):
        n = Fraction(str(root.base))
        return n.denominator > 1 or n < 2 or (n < terms.MAX_RADICAND and core(n.numerator) != n)
    return not root.base.free_symbols or all(isinstance(value, Fraction) for value in at_points(root))


def _has_fraction_below(expression: sp.Expr, below: bool) -> bool:
    if is_number(expression):
        return below and Fraction(str(expression)).denominator != 1
    if not (expression.is_Add or expression.is_Mul or expression.is_Pow):
        return False
    divides = bool(expression.is_Pow and expression.exp < 0)
    return (divides and below) or any(
        _has_fraction_below(part, below or divides) for part in expression.args[: 1 if expression.is_Pow else None]
    )


def _cancels(product: sp.Expr) -> bool:
    """Tell whether something cancels in a quotient: a factor, or a number that divides all terms above and below."""
    below = [sp.Pow(f.base, -f.exp, evaluate=False) for f in product.args if f.is_Pow and f.exp < 0]
    above = [f for f in product.args if not (f.is_Pow and f.exp < 0)]
    if not below:
        return False
    try:
        denominator, *factors = (terms.with_root(each)[0].numer for each in (sp.Mul(*below, evaluate=False), *above))
    except terms.NotComparableError:
        return False
    if denominator.is_ground:
        # A square keeps its number: ½k(2Rφ)² is as simple as 2kR²φ².
        plain = [p for p, factor in zip(factors, above, strict=True) if factor.is_Add or is_number(factor)]
        return any(gcd(int(p.content()), int(denominator.content())) != 1 for p in plain)
    return any(factor.gcd(denominator) != 1 for factor in factors)
