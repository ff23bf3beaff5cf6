"""The exact normal form of a formula: a quotient of polynomials in which every square root is a quantity of its own.

    Σ_S N_S √(∏S) / D,     N_S and D polynomials with integer coefficients in m, m′, k, R and the motion

Each S is a set of radicands, pairwise coprime and none of them a square, so that their roots are independent: two
formulas are equal exactly if their normal forms are. ε is written as m′/m. Nothing is sampled or simplified. Each
multiplication is counted before it is carried out, so that the time for any formula is bounded.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, reduce
from math import gcd, isqrt, prod
from operator import itemgetter, sub

import sympy as sp
from sympy.polys.heuristicgcd import heugcd
from sympy.polys.polyerrors import HeuristicGCDFailed
from sympy.polys.rings import PolyElement, PolyRing, ring

from ramanujan.derivation.expressions import NAMES, Expression, Name, Number, Power, Product, Sum, spelled

MAX_WORK = 20_000
"""Products of two terms, weighted by their digits, that one normal form may cost: less than a tenth of a second."""

_MAX_GCD_BITS = 8_000
"""A common factor is looked for only where the integers that the search meets stay shorter than this."""

_MAX_RADICANDS, _MAX_SUMS = 10, 4
"""How many different radicands a formula may have, and how many of them may be sums."""

_SMALL_PRIMES = tuple(sp.primerange(2, 1000))

VARIABLES = NAMES[:-1]
"""The names that a normal form may contain; ε is m′/m."""

_POSITIVE = ("m", "m'", "k", "R")
_RING, *_GENERATORS = ring([f"x{i}" for i in range(len(VARIABLES))], sp.ZZ)
_GENERATOR = dict(zip(VARIABLES, _GENERATORS, strict=True))
_SIGNED = tuple(i for i, name in enumerate(VARIABLES) if name not in _POSITIVE)

Monomial = tuple[int, ...]
Radicands = frozenset[PolyElement]
_NO_ROOT: Radicands = frozenset()


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
            return None if derived.has(sp.nan, sp.zoo) else normal_form(spelled(derived))
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
            return _RING.zero
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


def normal_form(expression: Expression) -> NormalForm:
    """Return the normal form of an expression.

    Raises
    ------
    ZeroDivisionError : the expression divides by zero.
    NegativeRootError : it has a root of something negative.
    TooLargeError : expanding it would take too long.
    UncertainRootError : it has a root whose radicand may be negative, or contains a root.
    """
    return _Expansion().of(expression)


def constant(value: Fraction) -> NormalForm:
    """Return the normal form of a number."""
    numerator = frozenset({(_NO_ROOT, _RING(value.numerator))}) if value else frozenset()
    return NormalForm(numerator, _RING(value.denominator if value else 1))


def polynomial_form(numerator: PolyElement) -> NormalForm:
    """Return the normal form of a polynomial."""
    return NormalForm(frozenset({(_NO_ROOT, numerator)}) if numerator else frozenset(), _RING.one)


def name_form(name: str) -> NormalForm:
    """Return the normal form of one of `VARIABLES`."""
    return polynomial_form(_GENERATOR[name])


def fraction(form: NormalForm) -> tuple[NormalForm, NormalForm]:
    """Return numerator and denominator of a formula."""
    return NormalForm(form.numerators, _RING.one), polynomial_form(form.denominator)


def times(*factors: NormalForm) -> NormalForm:
    """Return the product of some formulas."""
    return reduce(_Expansion(factors).product, factors)


def over(left: NormalForm, right: NormalForm) -> NormalForm:
    """Return the quotient of two formulas; ZeroDivisionError if the second is zero."""
    expansion = _Expansion((left, right))
    return expansion.product(left, expansion.inverse(right))


def plus(*terms: NormalForm) -> NormalForm:
    """Return the sum of some formulas."""
    return reduce(_Expansion(terms).sum, terms)


def minus(left: NormalForm, right: NormalForm) -> NormalForm:
    """Return the difference of two formulas."""
    expansion = _Expansion((left, right))
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
    new = [(_GENERATOR[name], _GENERATOR[v] if isinstance(v, str) else _RING(v)) for name, v in values.items()]
    denominator = form.denominator.compose(new)
    if not denominator:
        raise ZeroDivisionError
    return _Expansion().tidied({roots: p.compose(new) for roots, p in form.numerators}, denominator)


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
    expansion = _Expansion()
    return {
        product: expansion.tidied({roots: _RING(rest) for roots, rest in by_roots.items()}, form.denominator)
        for product, by_roots in found.items()
    }


def expression_of(form: NormalForm) -> Expression:
    """Return a normal form as a tree."""
    above = Sum(tuple(_tree(p, roots) for roots, p in form.numerators) or (Number(Fraction(0)),))
    return Product((above, Power(_tree(form.denominator, _NO_ROOT), Fraction(-1))))


def _tree(polynomial: PolyElement, radicands: Radicands) -> Expression:
    terms = tuple(
        Product(
            (Number(Fraction(int(c))), *(Power(Name(VARIABLES[i]), Fraction(n)) for i, n in enumerate(powers) if n))
        )
        for powers, c in polynomial.items()
    )
    roots = (Power(_tree(radicand, _NO_ROOT), Fraction(1, 2)) for radicand in radicands)
    return Product((Sum(terms), *roots))


def content(form: NormalForm) -> int:
    """Return the greatest whole number that divides all numerators."""
    return gcd(*(int(polynomial.content()) for _, polynomial in form.numerators))


def common_factor(left: NormalForm, right: NormalForm) -> PolyElement:
    """Return the greatest factor that all numerators of two formulas share, as far as it is cheap to find."""
    polynomials = [polynomial for form in (left, right) for _, polynomial in form.numerators]
    return reduce(_Expansion().common_factor, polynomials)


ZERO, ONE, MINUS_ONE = (constant(Fraction(n)) for n in (0, 1, -1))


class _Expansion:
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
                return NormalForm(frozenset({(_NO_ROOT, _GENERATOR["m'"])}), _GENERATOR["m"])
            case Name(name):
                return polynomial_form(_GENERATOR[name])
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
                numerators[roots] = numerators.get(roots, _RING.zero) + widened
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
                numerators[key] = numerators.get(key, _RING.zero) + polynomial
        return self.tidied(numerators, self._times(left.denominator, right.denominator))

    def inverse(self, form: NormalForm) -> NormalForm:
        """Return 1/form: conjugates, one radicand after another, take the roots out of the denominator."""
        if form.is_zero:
            raise ZeroDivisionError
        below, factor = NormalForm(form.numerators, _RING.one), polynomial_form(form.denominator)
        while radicands := frozenset().union(*(roots for roots, _ in below.numerators)):
            radicand = min(radicands, key=str)
            conjugate = NormalForm(
                frozenset((roots, -p if radicand in roots else p) for roots, p in below.numerators), _RING.one
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
            return NormalForm(frozenset(), _RING.one)
        self._reduced = True
        common = _RING.one if denominator == 1 else reduce(self.common_factor, numerators.values(), denominator)
        if denominator.LC < 0:
            common = -common
        parts = frozenset((roots, _divided(polynomial, common)) for roots, polynomial in numerators.items())
        return NormalForm(parts, _divided(denominator, common), self._reduced)

    def _root(self, polynomial: PolyElement) -> tuple[Radicands, PolyElement]:
        """Return what stays under the root of a polynomial, and what comes out of it."""
        number, rest = polynomial.primitive()
        if rest.LC < 0 and _is_positive(-rest):
            number, rest = -number, -rest
        if number < 0:
            raise NegativeRootError if _is_positive(rest) else UncertainRootError
        inside, out = _root_of_integer(int(number))
        radicands, outside = {_RING(factor) for factor in inside}, _RING(out)
        exponents = [min(monomial[i] for monomial in rest) for i in range(len(VARIABLES))]
        for generator, exponent in zip(_GENERATORS, exponents, strict=True):
            radicands, outside = self._take_out(generator, exponent, radicands, outside)
        rest = rest.exquo(_RING({tuple(exponents): 1}))
        if rest != 1:
            if _gcd_bits(rest, rest) > _MAX_GCD_BITS:
                raise TooLargeError
            for factor, exponent in rest.sqf_list()[1]:
                positive = _RING(dict(-factor if factor.LC < 0 and _is_positive(-factor) else factor))
                radicands, outside = self._take_out(positive, exponent, radicands, outside)
        for radicand in radicands:
            self._meet(radicand)
        return frozenset(radicands), outside

    def _take_out(
        self, factor: PolyElement, exponent: int, radicands: set[PolyElement], outside: PolyElement
    ) -> tuple[set[PolyElement], PolyElement]:
        """Take √(factor^exponent) apart; |factor| is no polynomial where the factor may be negative."""
        if exponent and exponent % 4 and not _is_positive(factor):
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
        digits = 1 + (_bits(left) + _bits(right)) // 200
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
            return _RING({monomial: gcd(int(left.content()), int(right.content()))})
        bits = _gcd_bits(left, right)
        if bits <= _MAX_GCD_BITS:
            self._spend(20 + bits // 20)
            factor = _greatest_common_factor(left, right)
            if factor is not None:
                return factor
        self._reduced = False
        return _RING(gcd(int(left.content()), int(right.content())))


def _greatest_common_factor(left: PolyElement, right: PolyElement) -> PolyElement | None:
    """Return the greatest common factor with a positive leading coefficient, None if the search fails.

    The search replaces one variable after another by an integer, so that those that do not occur are left out.
    """
    used = [i for i, column in enumerate(zip(*left, *right, strict=True)) if any(column)]
    small = _ring_of(len(used))
    chosen = itemgetter(*used) if len(used) > 1 else lambda powers: (powers[used[0]],)
    try:
        factor = heugcd(*(small({chosen(powers): c for powers, c in p.items()}) for p in (left, right)))[0]
    except HeuristicGCDFailed:
        return None
    sign = -1 if factor.LC < 0 else 1
    found = {}
    for powers, c in factor.items():
        all_powers = [0] * len(VARIABLES)
        for i, power in zip(used, powers, strict=True):
            all_powers[i] = power
        found[tuple(all_powers)] = sign * c
    return _RING(found)


@cache
def _ring_of(size: int) -> PolyRing:
    return ring([f"x{i}" for i in range(size)], sp.ZZ)[0]


def _divided(polynomial: PolyElement, factor: PolyElement) -> PolyElement:
    """Return a quotient that is exact, as a new polynomial: one that SymPy divided may keep an old hash."""
    if factor == 1:
        return _RING(dict(polynomial))
    if len(factor) > 1:
        return _RING(dict(polynomial.exquo(factor)))
    ((powers, number),) = factor.items()
    return _RING({tuple(map(sub, monomial, powers)): c // number for monomial, c in polynomial.items()})


def _rooted(radicands: Radicands, outside: PolyElement) -> NormalForm:
    return NormalForm(frozenset({(radicands, outside)}), _RING.one)


def _is_positive(polynomial: PolyElement) -> bool:
    """Tell whether a polynomial is evidently positive: sums of products of masses and squares."""
    return all(c > 0 and not any(monomial[i] % 2 for i in _SIGNED) for monomial, c in polynomial.items())


def _root_of_integer(number: int) -> tuple[set[int], int]:
    """Return the factors of a positive integer that stay under its root, and what comes out of it."""
    inside, outside = set(), 1
    for prime in _SMALL_PRIMES:
        exponent = 0
        while number % prime == 0:
            number, exponent = number // prime, exponent + 1
        outside *= prime ** (exponent // 2)
        if exponent % 2:
            inside.add(prime)
    if (root := isqrt(number)) ** 2 == number:
        return inside, outside * root
    return inside | {number}, outside


def _bits(polynomial: PolyElement) -> int:
    return max((abs(int(c)).bit_length() for c in polynomial.values()), default=0)


def _gcd_bits(left: PolyElement, right: PolyElement) -> int:
    """Return about how long the integers become with which `heugcd` replaces one variable after another."""
    degrees = [max(column) for column in zip(*left, *right, strict=True)]
    return (6 + min(_bits(left), _bits(right))) * prod(degree + 1 for degree in degrees)
