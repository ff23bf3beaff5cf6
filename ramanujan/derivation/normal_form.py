"""The exact normal form of a formula: a quotient of polynomials in which every square root is a quantity of its own.

    Σ_S N_S √(∏S) / D,     N_S and D polynomials with integer coefficients in m, m′, k, R and the motion

Each S is a set of radicands, pairwise coprime and none of them a square, so that their roots are independent: two
formulas are equal exactly if their normal forms are. ε is written as m′/m. Nothing is sampled or simplified. Each
multiplication is counted before it is carried out, so that the time for any formula is bounded.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from math import gcd

from sympy.polys.rings import PolyElement

from ramanujan.derivation.expansion import (
    NO_ROOT,
    Expansion,
    NormalForm,
    Radicands,
    UncertainRootError,
    constant,
    polynomial_form,
)
from ramanujan.derivation.expressions import Expression, Name, Number, Power, Product, Sum
from ramanujan.derivation.polynomials import (
    GENERATOR,
    RING,
    VARIABLES,
    Monomial,
)


def normal_form(expression: Expression) -> NormalForm:
    """Return the normal form of an expression.

    Raises
    ------
    ZeroDivisionError : the expression divides by zero.
    NegativeRootError : it has a root of something negative.
    TooLargeError : expanding it would take too long.
    UncertainRootError : it has a root whose radicand may be negative, or contains a root.
    """
    return Expansion().of(expression)


def name_form(name: str) -> NormalForm:
    """Return the normal form of one of `VARIABLES`."""
    return polynomial_form(GENERATOR[name])


def fraction(form: NormalForm) -> tuple[NormalForm, NormalForm]:
    """Return numerator and denominator of a formula."""
    return NormalForm(form.numerators, RING.one), polynomial_form(form.denominator)


def times(*factors: NormalForm) -> NormalForm:
    """Return the product of some formulas."""
    return reduce(Expansion(factors).product, factors)


def over(left: NormalForm, right: NormalForm) -> NormalForm:
    """Return the quotient of two formulas; ZeroDivisionError if the second is zero."""
    expansion = Expansion((left, right))
    return expansion.product(left, expansion.inverse(right))


def plus(*terms: NormalForm) -> NormalForm:
    """Return the sum of some formulas."""
    return reduce(Expansion(terms).sum, terms)


def minus(left: NormalForm, right: NormalForm) -> NormalForm:
    """Return the difference of two formulas."""
    expansion = Expansion((left, right))
    return expansion.sum(left, expansion.product(constant(Fraction(-1)), right))


def at(form: NormalForm, values: Mapping[str, int | str]) -> NormalForm:
    """Return a formula with numbers or other names in the place of some names.

    Raises
    ------
    ZeroDivisionError : its denominator is zero there.
    UncertainRootError : it contains the root of a name.
    """
    if any(not radicand.is_ground for roots, _ in form.numerators for radicand in roots):
        raise UncertainRootError
    new = [(GENERATOR[name], GENERATOR[v] if isinstance(v, str) else RING(v)) for name, v in values.items()]
    denominator = form.denominator.compose(new)
    if not denominator:
        raise ZeroDivisionError
    return Expansion().tidied({roots: p.compose(new) for roots, p in form.numerators}, denominator)


def coefficients(form: NormalForm, variables: tuple[str, ...]) -> dict[Monomial, NormalForm] | None:
    """Return a formula as a polynomial in some of its names: products of these names and what multiplies each.

    None if such a name is in a denominator or under a root. A product is a tuple of exponents in the order of
    `VARIABLES`.
    """
    chosen = tuple(name in variables for name in VARIABLES)
    fixed = [form.denominator, *(radicand for roots, _ in form.numerators for radicand in roots)]
    if any(e and c for polynomial in fixed for monomial in polynomial for e, c in zip(monomial, chosen, strict=True)):
        return None
    found: dict[Monomial, dict[Radicands, dict[Monomial, int]]] = {}
    for roots, polynomial in form.numerators:
        for monomial, c in polynomial.items():
            product = tuple(e if is_variable else 0 for e, is_variable in zip(monomial, chosen, strict=True))
            rest = tuple(e - used for e, used in zip(monomial, product, strict=True))
            found.setdefault(product, {}).setdefault(roots, {})[rest] = c
    expansion = Expansion()
    return {
        product: expansion.tidied({roots: RING(rest) for roots, rest in by_roots.items()}, form.denominator)
        for product, by_roots in found.items()
    }


def expression_of(form: NormalForm) -> Expression:
    """Return a normal form as a tree."""
    above = Sum(tuple(_tree(p, roots) for roots, p in form.numerators) or (Number(Fraction(0)),))
    return Product((above, Power(_tree(form.denominator, NO_ROOT), Fraction(-1))))


def _tree(polynomial: PolyElement, radicands: Radicands) -> Expression:
    terms = tuple(
        Product(
            (Number(Fraction(int(c))), *(Power(Name(VARIABLES[i]), Fraction(n)) for i, n in enumerate(powers) if n))
        )
        for powers, c in polynomial.items()
    )
    roots = (Power(_tree(radicand, NO_ROOT), Fraction(1, 2)) for radicand in radicands)
    return Product((Sum(terms), *roots))


def content(form: NormalForm) -> int:
    """Return the greatest whole number that divides all numerators."""
    return gcd(*(int(polynomial.content()) for _, polynomial in form.numerators))


def common_factor(left: NormalForm, right: NormalForm) -> PolyElement:
    """Return the greatest factor that all numerators of two formulas share, as far as it is cheap to find."""
    polynomials = [polynomial for form in (left, right) for _, polynomial in form.numerators]
    return reduce(Expansion().common_factor, polynomials)


ZERO, ONE, MINUS_ONE = (constant(Fraction(n)) for n in (0, 1, -1))
