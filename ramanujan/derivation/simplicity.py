"""What a right formula still lacks to be a simplified one; each question is asked of the tree as it was typed."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd

from ramanujan.derivation.expressions import Expression, Number, Power, Product, Sum, names, parts
from ramanujan.derivation.normal_form import common_factor, content, normal_form


def has_root(expression: Expression) -> bool:
    """Tell whether there is a root in an expression."""
    return any(_is_root(each) for each in _all(expression))


def has_root_to_take(expression: Expression) -> bool:
    """Tell whether something can be taken out of a root, or worked out under it: √12, √(m²), √(12·144 + 1)."""
    return any(_is_root(each) and _can_be_taken(each) for each in _all(expression))


def has_like_terms(expression: Expression) -> bool:
    """Tell whether a sum has a term that is zero, or two terms of which one is a multiple of the other."""
    sums = (each for each in _all(expression) if isinstance(each, Sum))
    return any(_repeats(_without_number(term) for term in each.terms) for each in sums)


def has_fraction_below(expression: Expression, below: bool = False) -> bool:
    """Tell whether there is a fraction in a denominator."""
    if isinstance(expression, Number):
        return below and expression.value.denominator != 1
    divides = isinstance(expression, Power) and expression.exponent < 0
    return (divides and below) or any(has_fraction_below(part, below or divides) for part in parts(expression))


def has_common_factor(expression: Expression) -> bool:
    """Tell whether something cancels in a quotient: a factor, or a number that divides all terms above and below."""
    return any(isinstance(each, Product) and _cancels(each) for each in _all(expression))


def _all(expression: Expression) -> Iterator[Expression]:
    yield expression
    for part in parts(expression):
        yield from _all(part)


def _is_root(expression: Expression) -> bool:
    return isinstance(expression, Power) and expression.exponent.denominator == 2


def _can_be_taken(root: Power) -> bool:
    base, form = normal_form(root.base), normal_form(Power(root.base, Fraction(1, 2)))
    if not names(root.base) and not isinstance(root.base, Number):
        return True
    ((_, outside),) = form.numerators or {(frozenset(), 0)}
    return base.is_zero or outside != 1 or form.denominator != 1


def _repeats(terms: Iterator[object]) -> bool:
    seen = set()
    for term in terms:
        if term is None or term in seen:
            return True
        seen.add(term)
    return False


def _without_number(term: Expression) -> object:
    """Return what a term is apart from its number, None for zero."""
    form = normal_form(term)
    if form.is_zero:
        return None
    number = content(form)
    first = min(form.numerators, key=lambda item: sorted(map(str, item[0])))[1].LC
    sign = -1 if first < 0 else 1
    numerators = frozenset((roots, polynomial.quo_ground(sign * number)) for roots, polynomial in form.numerators)
    return numerators, form.denominator.primitive()[1]


def _cancels(product: Product) -> bool:
    below = tuple(f for f in product.factors if isinstance(f, Power) and f.exponent < 0)
    above = tuple(f for f in product.factors if f not in below)
    if not below:
        return False
    denominator = normal_form(Product(tuple(Power(f.base, -f.exponent) for f in below)))
    if not denominator.names and denominator.numerator is not None:
        # A square keeps its number: ½k(2Rφ)² is as simple as 2kR²φ².
        numbers = (content(normal_form(f)) for f in above if isinstance(f, Number | Sum))
        return any(gcd(number, content(denominator)) != 1 for number in numbers)
    return common_factor(normal_form(Product(above)) if above else normal_form(Number(Fraction(1))), denominator) != 1
