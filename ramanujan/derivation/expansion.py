"""The arithmetic of normal forms: sums, products, inverses and roots, each counted before it is carried out."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import reduce
from math import gcd

import sympy as sp
from sympy.polys.rings import PolyElement

from ramanujan.derivation.expressions import Expression, Name, Number, Power, Product, Sum, spelled
from ramanujan.derivation.polynomials import (
    GENERATOR,
    GENERATORS,
    MAX_GCD_BITS,
    RING,
    VARIABLES,
    bits,
    divided,
    gcd_bits,
    greatest_common_factor,
    is_positive,
    root_of_integer,
)

MAX_WORK = 20_000
"""Products of two terms, weighted by their digits, that one normal form may cost: less than a tenth of a second."""

_MAX_RADICANDS, _MAX_SUMS = 10, 4
"""How many different radicands a formula may have, and how many of them may be sums."""

Radicands = frozenset[PolyElement]

NO_ROOT: Radicands = frozenset()


class TooLargeError(ValueError):
    """The formula would take too long to expand."""


class UncertainRootError(ValueError):
    """A root in the formula has no normal form here: its radicand has no definite sign or contains a root itself."""


class NegativeRootError(ArithmeticError):
    """A root of what is negative for all masses and motions."""


@dataclass(frozen=True)
class NormalForm:
    """Numerators by the roots that multiply them, without zeros, over a positive denominator free of roots."""

    numerators: frozenset[tuple[Radicands, PolyElement]]
    denominator: PolyElement
    is_reduced: bool = field(default=True, compare=False)
    """Whether it was possible to look for common factors; if not, equal formulas may have different normal forms."""

    @classmethod
    def of(cls, derived: sp.Expr) -> NormalForm | None:
        """Return the normal form of an expression of the derivation, None where it divides by zero."""
        try:
            return None if derived.has(sp.nan, sp.zoo) else Expansion().of(spelled(derived))
        except ZeroDivisionError:
            return None

    @property
    def is_zero(self) -> bool:
        """Whether the formula is 0."""
        return not self.numerators

    @property
    def size(self) -> int:
        """The number of its terms."""
        return len(self.denominator) + sum(len(polynomial) for _, polynomial in self.numerators)

    @property
    def numerator(self) -> PolyElement | None:
        """The numerator of a formula without roots, None if there is a root."""
        if not self.numerators:
            return RING.zero
        ((roots, polynomial), *others) = self.numerators
        return None if roots or others else polynomial

    @property
    def names(self) -> frozenset[str]:
        """The names on which the formula depends."""
        polynomials = [self.denominator]
        for roots, polynomial in self.numerators:
            polynomials += [polynomial, *roots]
        return frozenset(
            name for i, name in enumerate(VARIABLES) if any(monomial[i] for p in polynomials for monomial in p)
        )


def constant(value: Fraction) -> NormalForm:
    """Return the normal form of a number."""
    numerator = frozenset({(NO_ROOT, RING(value.numerator))}) if value else frozenset()
    return NormalForm(numerator, RING(value.denominator if value else 1))


def polynomial_form(numerator: PolyElement) -> NormalForm:
    """Return the normal form of a polynomial."""
    return NormalForm(frozenset({(NO_ROOT, numerator)}) if numerator else frozenset(), RING.one)


class Expansion:
    """The arithmetic of one formula: counts its work, and keeps the radicands that it has met coprime."""

    def __init__(self, known: tuple[NormalForm, ...] = ()) -> None:
        self._work, self._reduced = MAX_WORK, True
        self._radicands: set[PolyElement] = set()
        for form in known:
            for roots, _ in form.numerators:
                for radicand in roots:
                    self._meet(radicand)

    def of(self, expression: Expression) -> NormalForm:
        match expression:
            case Number(value):
                return constant(value)
            case Name("eps"):
                return NormalForm(frozenset({(NO_ROOT, GENERATOR["m'"])}), GENERATOR["m"])
            case Name(name):
                return polynomial_form(GENERATOR[name])
            case Sum(terms):
                return reduce(self.sum, map(self.of, terms))
            case Product(factors):
                return reduce(self.product, map(self.of, factors))
            case Power(base, exponent):
                power = self.of(base)
                if exponent.denominator == 2:
                    power = self.root(power)
                power = reduce(self.product, [power] * abs(exponent.numerator), constant(Fraction(1)))
                return self.inverse(power) if exponent < 0 else power
        raise TypeError(f"expression is not a formula: {expression!r}")

    def sum(self, left: NormalForm, right: NormalForm) -> NormalForm:
        if left.is_zero or right.is_zero:
            return right if left.is_zero else left
        same = left.denominator == right.denominator
        numerators: dict[Radicands, PolyElement] = {}
        for one, other in ((left, right), (right, left)):
            for roots, polynomial in one.numerators:
                widened = polynomial if same else self._times(polynomial, other.denominator)
                numerators[roots] = numerators.get(roots, RING.zero) + widened
        denominator = left.denominator if same else self._times(left.denominator, right.denominator)
        return self.tidied(numerators, denominator)

    def product(self, left: NormalForm, right: NormalForm) -> NormalForm:
        numerators: dict[Radicands, PolyElement] = {}
        for roots, one in left.numerators:
            for others, other in right.numerators:
                polynomial = self._times(one, other)
                for radicand in roots & others:
                    polynomial = self._times(polynomial, radicand)
                key = roots ^ others
                numerators[key] = numerators.get(key, RING.zero) + polynomial
        return self.tidied(numerators, self._times(left.denominator, right.denominator))

    def inverse(self, form: NormalForm) -> NormalForm:
        """Return 1/form: conjugates, one radicand after another, take the roots out of the denominator."""
        if form.is_zero:
            raise ZeroDivisionError
        below, factor = NormalForm(form.numerators, RING.one), polynomial_form(form.denominator)
        while radicands := frozenset().union(*(roots for roots, _ in below.numerators)):
            radicand = min(radicands, key=str)
            conjugate = NormalForm(
                frozenset((roots, -p if radicand in roots else p) for roots, p in below.numerators), RING.one
            )
            below, factor = self.product(below, conjugate), self.product(factor, conjugate)
        if below.is_zero:
            raise ZeroDivisionError
        return self.tidied(dict(factor.numerators), below.numerator)

    def root(self, form: NormalForm) -> NormalForm:
        """Return √form = √(N·D)/D."""
        if form.is_zero:
            return form
        if form.numerator is None:
            raise UncertainRootError
        inside, outside = self._root(form.numerator)
        below, outside_below = self._root(form.denominator)
        root = self.product(_rooted(inside, outside), self.inverse(_rooted(below, outside_below)))
        return root

    def tidied(self, numerators: dict[Radicands, PolyElement], denominator: PolyElement) -> NormalForm:
        """Return the quotient without zeros and, where that is cheap to find, without common factors."""
        numerators = {roots: polynomial for roots, polynomial in numerators.items() if polynomial}
        if not numerators:
            return NormalForm(frozenset(), RING.one)
        self._reduced = True
        common = RING.one if denominator == 1 else reduce(self.common_factor, numerators.values(), denominator)
        if denominator.LC < 0:
            common = -common
        parts = frozenset((roots, divided(polynomial, common)) for roots, polynomial in numerators.items())
        return NormalForm(parts, divided(denominator, common), self._reduced)

    def _root(self, polynomial: PolyElement) -> tuple[Radicands, PolyElement]:
        """Return what stays under the root of a polynomial, and what comes out of it."""
        number, rest = polynomial.primitive()
        if rest.LC < 0 and is_positive(-rest):
            number, rest = -number, -rest
        if number < 0:
            raise NegativeRootError if is_positive(rest) else UncertainRootError
        inside, out = root_of_integer(int(number))
        radicands, outside = {RING(factor) for factor in inside}, RING(out)
        exponents = [min(monomial[i] for monomial in rest) for i in range(len(VARIABLES))]
        for generator, exponent in zip(GENERATORS, exponents, strict=True):
            radicands, outside = self._take_out(generator, exponent, radicands, outside)
        rest = rest.exquo(RING({tuple(exponents): 1}))
        if rest != 1:
            if gcd_bits(rest, rest) > MAX_GCD_BITS:
                raise TooLargeError
            for factor, exponent in rest.sqf_list()[1]:
                positive = RING(dict(-factor if factor.LC < 0 and is_positive(-factor) else factor))
                radicands, outside = self._take_out(positive, exponent, radicands, outside)
        for radicand in radicands:
            self._meet(radicand)
        return frozenset(radicands), outside

    def _take_out(
        self, factor: PolyElement, exponent: int, radicands: set[PolyElement], outside: PolyElement
    ) -> tuple[set[PolyElement], PolyElement]:
        """Take √(factor^exponent) apart; |factor| is no polynomial where the factor may be negative."""
        if exponent and exponent % 4 and not is_positive(factor):
            raise UncertainRootError
        for _ in range(exponent // 2):
            outside = self._times(outside, factor)
        return (radicands | {factor} if exponent % 2 else radicands), outside

    def _meet(self, radicand: PolyElement) -> None:
        if radicand in self._radicands:
            return
        if len(self._radicands) == _MAX_RADICANDS or sum(len(other) > 1 for other in self._radicands) == _MAX_SUMS:
            raise TooLargeError
        for other in self._radicands:
            if self.common_factor(radicand, other) != 1:
                raise UncertainRootError
        self._radicands.add(radicand)

    def _times(self, left: PolyElement, right: PolyElement) -> PolyElement:
        digits = 1 + (bits(left) + bits(right)) // 200
        self._spend(len(left) * len(right) * digits)
        return left * right

    def _spend(self, work: int) -> None:
        self._work -= work
        if self._work < 0:
            raise TooLargeError

    def common_factor(self, left: PolyElement, right: PolyElement) -> PolyElement:
        """Return a common factor, the greatest one where its search is cheap."""
        if len(left) == 1 or len(right) == 1:
            monomial = tuple(
                min(min(powers) for powers in column)
                for column in zip(zip(*left, strict=True), zip(*right, strict=True), strict=True)
            )
            return RING({monomial: gcd(int(left.content()), int(right.content()))})
        size = gcd_bits(left, right)
        if size <= MAX_GCD_BITS:
            self._spend(20 + size // 20)
            factor = greatest_common_factor(left, right)
            if factor is not None:
                return factor
        self._reduced = False
        return RING(gcd(int(left.content()), int(right.content())))


def _rooted(radicands: Radicands, outside: PolyElement) -> NormalForm:
    return NormalForm(frozenset({(radicands, outside)}), RING.one)
