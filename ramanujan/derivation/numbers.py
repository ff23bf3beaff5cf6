"""The present masses as exact numbers, for a derivation with numbers.

A float is converted to the entered number: 0.1 to 1/10, and the float nearest to 5/6 to 5/6. If m′ is the float nearest
to m·ε*, it is converted to m·ε* = m(√1729 − 1)/36. The result Ω² = k/m is then computed, not assumed.
"""

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from itertools import chain, count
from math import prod
from typing import Any

import sympy as sp
from sympy.utilities.iterables import sift

from ramanujan.derivation.elimination import UnitCondition, eliminate, unit_condition
from ramanujan.derivation.model import k, m, m_prime, machine
from ramanujan.derivation.order import InOrder, in_order, order_terms
from ramanujan.derivation.printers import DIGITS, QuadraticNumber, format_decimal, latex, round_number
from ramanujan.text.numerals import in_latex
from ramanujan.text.translation import _

GIVEN = (m, m_prime, k)
"""The symbols that have a value."""
_DIGITS_OF_A_FLOAT = 15
"""The number of significant digits that distinguish a float from its neighbours."""
_SIMPLE = 10_000
"""The largest denominator of a fraction that a person would enter."""


@dataclass(frozen=True)
class Numbers:
    """The entered numbers of one machine, by the names of their symbols.

    Parameters
    ----------
    m, m_prime : masses [kg]
    k : stiffness [N/m]
    """

    m: float
    m_prime: float
    k: float

    @classmethod
    def of(cls, machine: Any) -> "Numbers":
        """Return the numbers of an object with these attributes, such as an `Oscillator`."""
        return cls(*(getattr(machine, field.name) for field in fields(cls)))

    @property
    def with_equal_masses(self) -> "Numbers":
        """The numbers with m′ = m."""
        return replace(self, m_prime=self.m)

    @cached_property
    def exact(self) -> dict[sp.Symbol, sp.Expr]:
        """The exact SymPy numbers: symbol → number.

        >>> Numbers(1.85, 5 / 6, 33.5).exact
        {m: 37/20, m_prime: 5/6, k: 67/2}
        """
        exact: dict[sp.Symbol, sp.Expr] = {
            m: _read_float(self.m),
            m_prime: _read_float(self.m_prime),
            k: _read_float(self.k),
        }
        if is_unit_ratio(self.m, self.m_prime):
            exact[m_prime] = unit_frequency_condition().root * exact[m]
        return exact

    def insert_into(self, expression: sp.Basic) -> sp.Basic:
        """Return an expression with the numbers instead of m, m′ and k, and with the same order of terms.

        Each part that is a rational function of only m, m′ and k becomes one number.

        Parameters
        ----------
        expression : an expression, a matrix or a tuple

        >>> from ramanujan.derivation.model import R, X, phi
        >>> Numbers(2, 1, 3).insert_into(m * R * X + 4 * k * (m + m_prime) * phi)
        2*R*X(t) + 36*varphi(t)
        """
        if expression.free_symbols.isdisjoint(GIVEN):
            return expression
        if _becomes_number(expression):
            return self.value(expression)
        if expression.is_Add:
            return in_order(*chain.from_iterable(self.terms(expression)))
        if expression.is_Mul:
            return self._insert_into_product(expression)
        return expression.func(*map(self.insert_into, expression.args))

    def terms(self, total: sp.Basic) -> list[tuple[sp.Basic, ...]]:
        """Return the terms of a sum with the numbers inserted.

        A number before a bracket is multiplied into it. Such a term has several parts.
        """
        if _becomes_number(total):
            return [(self.value(total),)]
        inserted = map(self.insert_into, order_terms(total))
        return [term.args if isinstance(term, InOrder) else (term,) for term in inserted]

    def value(self, expression: sp.Expr) -> sp.Expr:
        """Return the value of a rational function of m, m′ and k, exactly; m′ may contain a square root."""
        value = expression.xreplace(self.exact)
        return value if value.is_Rational else _simplify_root(value)

    def _insert_into_product(self, expression: sp.Mul) -> sp.Expr:
        """Return a product with the numbers inserted. Number and denominator are multiplied into the first bracket."""
        numbers, others = sift(expression.args, _becomes_number, binary=True)
        sums = [factor for factor in others if factor.is_Add]
        if not numbers or not sums:
            number = [self.value(sp.Mul(*numbers))] if numbers else []
            return expression.func(*number, *map(self.insert_into, others))
        bracket = sums[0]
        others.remove(bracket)
        denominators, others = sift(others, lambda factor: factor.is_Pow and factor.exp.is_negative, binary=True)
        distributed = sp.Add(*(sp.Mul(*numbers, term, *denominators) for term in bracket.args))
        return self.insert_into(sp.Mul(distributed, *others))


def state_factor_one(numbers: Numbers, equations: Iterable[sp.Basic]) -> str:
    r"""Return a sentence about each mass of 1 kg that is a factor of a product in the equations; "" without one.

    Such a factor is not written, so the units of the product seem to be wrong: I = R².

    Parameters
    ----------
    numbers : the numbers that are inserted
    equations : in symbols

    >>> from ramanujan.derivation.model import R
    >>> print(state_factor_one(Numbers(1, 2, 3), [sp.Eq(sp.Symbol("I"), m * R**2)]))
    Because $m=1\,\mathrm{kg}$, this factor is not written.
    """
    products = {product for equation in equations for product in equation.atoms(sp.Mul)}
    visible = [product for product in products if not _becomes_number(product)]
    factors = {factor for product in visible for factor in product.args}
    masses = [latex(mass) for mass in (m, m_prime) if numbers.exact[mass] == 1 and mass in factors]
    if not masses:
        return ""
    return _("Because {masses}, this factor is not written.").format(masses=rf"${'='.join(masses)}=1\,\mathrm{{kg}}$")


def _simplify_root(number: sp.Expr) -> sp.Expr:
    """Return a number with fractions and one square root as p + r√n. SymPy's `radsimp` takes thirty times as long."""
    (root,) = {power for power in number.atoms(sp.Pow) if power.exp == sp.Rational(1, 2)}
    # In this field the element `unit` is √n.
    field = _quadratic_field(root)

    def element(part: sp.Expr) -> Any:
        """Return a part of the number as an element of the field of all p + r√n."""
        if part == root:
            return field.unit
        if part.is_Add:
            return sum(map(element, part.args), field.zero)
        if part.is_Mul:
            return prod(map(element, part.args), start=field.one)
        return element(part.base) ** int(part.exp) if part.is_Pow else field.from_sympy(part)

    return field.to_sympy(element(number))


@cache
def _quadratic_field(root: sp.Pow) -> Any:
    return sp.QQ.algebraic_field(root)


def _becomes_number(expression: sp.Basic) -> bool:
    """Return whether the expression becomes one number when the numbers are inserted.

    It is then a rational function of only m, m′ and k. A sum made by `in_order` keeps its terms.
    """
    if expression.is_Symbol:
        return expression in GIVEN
    if isinstance(expression, InOrder):
        return False
    if isinstance(expression, sp.Add | sp.Mul | sp.Pow):
        return all(map(_becomes_number, expression.args))
    return bool(expression.is_Rational)


def is_unit_ratio(mass: float, roller_mass: float) -> bool:
    """Return whether m′ is the float nearest to m·ε*, or the product of m and the float nearest to ε*.

    These two floats differ by at most two units in the last place. Return True also if m is the rounded m′/ε*.

    Parameters
    ----------
    mass, roller_mass : m, m′ [kg]

    >>> from ramanujan import UNIT_MASS_RATIO
    >>> is_unit_ratio(1.0, UNIT_MASS_RATIO), is_unit_ratio(1.0, 1.127256827)
    (True, False)
    """
    root = _unit_ratio_to_fifty_digits()
    # The shortest decimal of a float is the number that was typed.
    product = root * Fraction(repr(float(mass)))
    return roller_mass in (float(root) * mass, float(product)) or mass == roller_mass / float(root)


@cache
def _unit_ratio_to_fifty_digits() -> Fraction:
    """Return ε* to fifty digits, which suffices to round products with floats correctly."""
    return Fraction(str(sp.N(unit_frequency_condition().root, 50)))


def state_numbers(numbers: Numbers) -> str:
    """Return a sentence with the masses and the stiffness of a derivation with numbers, as Markdown with $…$.

    >>> print(state_numbers(Numbers(1.85, 0.86, 33.5)))
    The numbers are for $m=1.85\\,\\mathrm{kg}$, $m'=0.86\\,\\mathrm{kg}$ and $k=33.5\\,\\mathrm{N/m}$, in SI units.
    """
    mass, roller_mass, stiffness = (format_as_typed(numbers.exact[symbol]) for symbol in (m, m_prime, k))
    sentence = _("The numbers are for {mass}, {roller_mass} and {stiffness}, in SI units.").format(
        mass=rf"$m={mass}\,\mathrm{{kg}}$",
        roller_mass=rf"$m'={roller_mass}\,\mathrm{{kg}}$",
        stiffness=rf"$k={stiffness}\,\mathrm{{N/m}}$",
    )
    if numbers.exact[m_prime].is_Rational:
        return sentence
    nearest = _("The computer stores $m'$ as the floating-point number nearest to this value.")
    return f"{sentence} {nearest}"


def format_as_typed(value: sp.Expr) -> str:
    """Return a number of the machine as LaTeX, as a decimal if it has few decimal places.

    >>> format_as_typed(sp.Rational(27, 25)), format_as_typed(sp.Rational(5, 6))
    ('1.08', '\\\\frac{5}{6}')
    """
    if value.is_Rational and value.q > 1 and 10**15 % value.q == 0:
        return in_latex(f"{Decimal(value.p) / Decimal(value.q):f}")
    return latex(value)


def format_with_decimal(value: sp.Expr, digits: int = 5) -> str:
    """Return a number as LaTeX, with its decimal to `digits` digits, or to more if it would be rounded to 1.

    >>> print(format_with_decimal(sp.Rational(9, 8)), "and", format_with_decimal(sp.sqrt(2)))
    \\frac{9}{8} = 1.125 and \\sqrt{2} \\approx 1.4142
    """
    exact = latex(sp.factor(value))
    if value.is_Integer:
        return exact
    if not value.is_Rational:
        return rf"{exact} \approx {in_latex(f'{float(value):.{digits}g}')}"
    fraction = QuadraticNumber(value.p, value.q)
    needed = next(digits for digits in count(digits) if round_number(fraction, digits) != "1")
    # A long fraction is written as a decimal anyway.
    is_complete = exact.endswith(r"\ldots") and needed <= DIGITS
    return exact if is_complete else f"{exact} {format_decimal(fraction, needed)}"


@cache
def unit_frequency_condition() -> UnitCondition:
    """Return the machine's condition for Ω² = k/m: the quadratic in ε, its root ε*, and its discriminant 1729."""
    return unit_condition(eliminate(machine()).natural_frequency_squared)


def _read_float(value: float) -> sp.Rational:
    """Return the number that a person entered: the simple fraction nearest to a float, or its shortest decimal.

    A fraction such as 5/6 needs all digits of a float. Floats outnumber simple fractions by a factor of a million, so a
    measured decimal hardly ever equals a fraction.
    """
    decimal = repr(float(value))
    simple = Fraction(value).limit_denominator(_SIMPLE)
    has_all_digits = len(Decimal(decimal).as_tuple().digits) >= _DIGITS_OF_A_FLOAT
    if has_all_digits and float(simple) == value:
        return sp.Rational(simple.numerator, simple.denominator)
    return sp.Rational(decimal)
