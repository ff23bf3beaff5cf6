"""Formulas as elements of SymPy's fraction field ℤ(m, m′, k, R, X, …), where every quotient is in lowest terms.

Two formulas without roots are equal if and only if their elements are. The size of each element is bounded before it is
computed, because the greatest common divisor of two large polynomials takes very long.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import partial, reduce
from math import comb, prod
from operator import add, mul, truediv

import sympy as sp
from sympy.polys.fields import FracElement, field
from sympy.polys.rings import PolyElement

from ramanujan.answers.spelling import SYMBOLS, TooLargeError
from ramanujan.answers.typed_formulas import is_decimal
from ramanujan.derivation.model import epsilon, m, m_prime

NAMES = tuple(SYMBOLS)
FIELD = field(list(SYMBOLS.values()), sp.ZZ)[0]
_GENERATORS = dict(zip(SYMBOLS.values(), FIELD.gens, strict=True))
_OF_MASSES = _GENERATORS | {epsilon: _GENERATORS[m_prime] / _GENERATORS[m]}
_OF_RATIO = _GENERATORS | {m_prime: _GENERATORS[epsilon] * _GENERATORS[m]}

_MAX_TERMS, _MAX_DIGITS = 4000, 2_000_000
"""The largest number of products in a multiplication, and of binary digits in a search for common factors."""


class RootError(ValueError):
    """The formula contains a root, so it is not an element of the field."""


def find_names(formula: FracElement) -> frozenset[str]:
    """Return the names on which a formula depends."""
    # Each key of a polynomial contains the powers of NAMES in one of its terms.
    powers_of_terms = [*formula.numer, *formula.denom]
    powers_of_names = zip(NAMES, zip(*powers_of_terms, strict=True), strict=True)
    return frozenset(name for name, powers in powers_of_names if any(powers))


def to_fraction(expression: sp.Expr, *, is_in_ratio: bool = False) -> FracElement:
    """Return a formula in lowest terms.

    Parameters
    ----------
    expression : the formula, which may be unevaluated
    is_in_ratio : whether εm replaces m′, for a formula in the mass ratio; otherwise m′/m replaces ε

    Raises
    ------
    RootError : the formula contains a root.
    TooLargeError : the formula is too large.
    ZeroDivisionError : the formula divides by zero.
    """
    return _compute(expression, _OF_RATIO if is_in_ratio else _OF_MASSES)


def _compute(expression: sp.Expr, names: Mapping[sp.Expr, FracElement]) -> FracElement:
    if expression in names:
        return names[expression]
    if expression.is_Add or expression.is_Mul:
        operation = add if expression.is_Add else mul
        parts = (_compute(part, names) for part in expression.args)
        return reduce(partial(_combine, operation), parts)
    if expression.is_Pow:
        if not expression.exp.is_Integer:
            raise RootError
        return _compute_power(_compute(expression.base, names), int(expression.exp))
    number = sp.Rational(expression.name) if is_decimal(expression) else expression
    return FIELD(number.p) / number.q


def _combine(operation: Callable[..., FracElement], one: FracElement, other: FracElement) -> FracElement:
    """Return the result of an operation on two elements.

    Raises
    ------
    TooLargeError : the operation would take too long.
    """
    if _count_terms(one) * _count_terms(other) > _MAX_TERMS:
        raise TooLargeError
    # Without a sum below a fraction line, it is easy to find common factors.
    has_quotient = operation is truediv or len(one.denom) > 1 or len(other.denom) > 1
    if has_quotient and one and other and _count_digits(one, other) > _MAX_DIGITS:
        raise TooLargeError
    return operation(one, other)


def _compute_power(base: FracElement, exponent: int) -> FracElement:
    times = abs(exponent)
    if comb(times + _count_terms(base) - 1, times) > _MAX_TERMS:
        raise TooLargeError
    power = base**times if times else FIELD.one
    return power if exponent > 0 else _combine(truediv, FIELD.one, power)


def _count_terms(element: FracElement) -> int:
    return len(element.numer) + len(element.denom)


def _count_digits(one: FracElement, other: FracElement) -> int:
    """Return an upper bound of the binary digits in a product of two elements, written with every power of a letter."""
    terms = prod(first + second + 1 for first, second in zip(_find_degrees(one), _find_degrees(other), strict=True))
    return terms * (_count_bits(one) + _count_bits(other))


def _find_degrees(element: FracElement) -> Iterator[int]:
    """Return the highest power of each name."""
    return map(max, element.numer.degrees(), element.denom.degrees())


def _count_bits(element: FracElement) -> int:
    """Return the binary digits of the largest number."""
    return max(int(number).bit_length() for number in (*element.numer.values(), *element.denom.values()))


def collect_coefficients(formula: FracElement, variables: tuple[str, ...]) -> dict[tuple[int, ...], FracElement] | None:
    """Return product of variables → its coefficient, None if a variable is below a fraction line.

    A product is a tuple with the power of each of `NAMES`.
    """
    if find_names(FIELD(formula.denom)).intersection(variables):
        return None
    return {product: FIELD.new(part, formula.denom) for product, part in _group_terms(formula.numer, variables).items()}


def remove_factor(formula: FracElement, variables: tuple[str, ...]) -> FracElement:
    """Return a formula without its factor that does not depend on the variables, up to which an equation is unique."""
    for polynomial, is_above in ((formula.numer, True), (formula.denom, False)):
        groups = _group_terms(polynomial, variables)
        factor = FIELD(groups[max(groups)])
        formula = _combine(truediv if is_above else mul, formula, factor)
    return formula


def _group_terms(polynomial: PolyElement, variables: tuple[str, ...]) -> dict[tuple[int, ...], PolyElement]:
    """Return product of variables → its coefficient, for a polynomial."""
    is_variable = [name in variables for name in NAMES]
    groups: dict[tuple[int, ...], PolyElement] = {}
    for powers, number in polynomial.items():
        # Split the product into its variables and the other names, which belong to the coefficient.
        product = tuple(power if chosen else 0 for power, chosen in zip(powers, is_variable, strict=True))
        other_powers = tuple(0 if chosen else power for power, chosen in zip(powers, is_variable, strict=True))
        groups.setdefault(product, FIELD.ring.zero.copy())[other_powers] = number
    return groups
