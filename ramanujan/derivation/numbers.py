"""The present masses as exact numbers, for a derivation with numbers.

A float is converted to the entered number: 0.1 to 1/10, and the float nearest to 5/6 to 5/6. If m′ is the float nearest
to ε*m, it is converted to ε*m = (√1729 − 1)/36 · m. The result Ω² = k/m is then computed, not assumed.
"""

from dataclasses import dataclass, fields, replace
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from itertools import count
from math import prod
from typing import Any

import sympy as sp
from sympy.utilities.iterables import sift

from ramanujan.derivation import model
from ramanujan.derivation.elimination import UnitCondition, eliminate, unit_condition
from ramanujan.derivation.model import k, m, m_prime, machine
from ramanujan.derivation.order import InOrder, in_order, ordered_terms
from ramanujan.derivation.printers import DIGITS, Number, decimal_of, latex, rounded
from ramanujan.numerals import in_latex
from ramanujan.translation import _

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
        read = {getattr(model, field.name): _entered(getattr(self, field.name)) for field in fields(self)}
        if is_unit_ratio(self.m, self.m_prime):
            read[m_prime] = unit_frequency_condition().root * read[m]
        return read

    def insert_into(self, expression: sp.Basic) -> sp.Basic:
        """Return an expression with the numbers instead of m, m′ and k, and with the same order of terms.

        Each part that is a rational function of only m, m′ and k becomes one number.

        Parameters
        ----------
        expression : an expression, a matrix or a tuple

        >>> Numbers(2, 1, 3).insert_into(m * model.R * model.X + 4 * k * (m + m_prime) * model.phi)
        2*R*X(t) + 36*varphi(t)
        """
        if expression.free_symbols.isdisjoint(GIVEN):
            return expression
        if _is_number(expression):
            return self.value(expression)
        if expression.is_Add:
            return in_order(*(part for parts in self.terms(expression) for part in parts))
        if expression.is_Mul:
            return self._insert_into_product(expression)
        return expression.func(*map(self.insert_into, expression.args))

    def terms(self, total: sp.Basic) -> list[tuple[sp.Basic, ...]]:
        """Return the terms of a sum with the numbers inserted, and with brackets after a number multiplied out."""
        if _is_number(total):
            return [(self.value(total),)]
        filled = map(self.insert_into, ordered_terms(total))
        return [term.args if isinstance(term, InOrder) else (term,) for term in filled]

    def value(self, expression: sp.Expr) -> sp.Expr:
        """Return the value of a rational function of m, m′ and k, exactly; m′ may contain a square root."""
        value = expression.xreplace(self.exact)
        return value if value.is_Rational else _with_one_root(value)

    def _insert_into_product(self, expression: sp.Mul) -> sp.Expr:
        """Return a product with the numbers inserted; a factor or denominator of a sum is multiplied into its terms."""
        numbers, others = sift(expression.args, _is_number, binary=True)
        sums = [factor for factor in others if factor.is_Add]
        if not numbers or not sums:
            number = [self.value(sp.Mul(*numbers))] if numbers else []
            return expression.func(*number, *map(self.insert_into, others))
        others.remove(sums[0])
        below, others = sift(others, lambda factor: factor.is_Pow and factor.exp.is_negative, binary=True)
        distributed = sp.Add(*(sp.Mul(*numbers, term, *below) for term in sums[0].args))
        return self.insert_into(sp.Mul(distributed, *others))


def _with_one_root(number: sp.Expr) -> sp.Expr:
    """Return a number with fractions and one square root as p + r√n; `radsimp` is thirty times as slow."""
    (root,) = {power for power in number.atoms(sp.Pow) if power.exp == sp.Rational(1, 2)}
    field = _field(root)

    def element(part: sp.Expr) -> Any:
        """Return a part of the number as an element of the field of the numbers p + r√n."""
        if part == root:
            return field.unit
        if part.is_Add:
            return sum(map(element, part.args), field.zero)
        if part.is_Mul:
            return prod(map(element, part.args), start=field.one)
        return element(part.base) ** int(part.exp) if part.is_Pow else field.from_sympy(part)

    return field.to_sympy(element(number))


@cache
def _field(root: sp.Pow) -> Any:
    return sp.QQ.algebraic_field(root)


def _is_number(expression: sp.Basic) -> bool:
    """Return whether the expression is a rational function of only m, m′ and k, and not a sum made by `in_order`."""
    if expression.is_Symbol:
        return expression in GIVEN
    if isinstance(expression, InOrder):
        return False
    return bool(expression.is_Rational) or (
        isinstance(expression, sp.Add | sp.Mul | sp.Pow) and all(map(_is_number, expression.args))
    )


def is_unit_ratio(mass: float, roller_mass: float) -> bool:
    """Return whether m′ is the float nearest to ε*m, or the product of m and the float nearest to ε*.

    These two floats differ by at most two units in the last place. Also return True if m is m′/ε*, rounded.

    Parameters
    ----------
    mass, roller_mass : m, m′ [kg]

    >>> from ramanujan import UNIT_MASS_RATIO
    >>> is_unit_ratio(1.0, UNIT_MASS_RATIO), is_unit_ratio(1.0, 1.127256827)
    (True, False)
    """
    root = _root()
    product = root * Fraction(repr(float(mass)))
    return roller_mass in (float(root) * mass, float(product)) or mass == roller_mass / float(root)


@cache
def _root() -> Fraction:
    """Return ε* to fifty digits, with no float and no midpoint of two floats between the result and ε*."""
    return Fraction(str(sp.N(unit_frequency_condition().root, 50)))


def stated(numbers: Numbers) -> str:
    """Return a sentence with the masses and the stiffness of a derivation with numbers, as Markdown with $…$.

    >>> print(stated(Numbers(1.85, 0.86, 33.5)))
    The numbers are for $m=1.85\\,\\mathrm{kg}$, $m'=0.86\\,\\mathrm{kg}$ and $k=33.5\\,\\mathrm{N/m}$, in SI units.
    """
    mass, roller_mass, stiffness = (as_typed(numbers.exact[symbol]) for symbol in (m, m_prime, k))
    sentence = _("The numbers are for {mass}, {roller_mass} and {stiffness}, in SI units.").format(
        mass=rf"$m={mass}\,\mathrm{{kg}}$",
        roller_mass=rf"$m'={roller_mass}\,\mathrm{{kg}}$",
        stiffness=rf"$k={stiffness}\,\mathrm{{N/m}}$",
    )
    if numbers.exact[m_prime].is_Rational:
        return sentence
    nearest = _("The computer stores $m'$ as the floating-point number nearest to this value.")
    return f"{sentence} {nearest}"


def as_typed(value: sp.Expr) -> str:
    """Return a number of the machine as LaTeX, as a decimal if it has few decimal places.

    >>> as_typed(sp.Rational(27, 25)), as_typed(sp.Rational(5, 6))
    ('1.08', '\\\\frac{5}{6}')
    """
    if value.is_Rational and value.q > 1 and 10**15 % value.q == 0:
        return in_latex(f"{Decimal(value.p) / Decimal(value.q):f}")
    return latex(value)


def with_decimal(value: sp.Expr, digits: int = 5) -> str:
    """Return a number as LaTeX, and its decimal with a few digits, or with enough digits to differ from 1.

    >>> print(with_decimal(sp.Rational(9, 8)), "and", with_decimal(sp.sqrt(2)))
    \\frac{9}{8} = 1.125 and \\sqrt{2} \\approx 1.4142
    """
    exact = latex(sp.factor(value))
    if value.is_Integer:
        return exact
    if not value.is_Rational:
        return rf"{exact} \approx {in_latex(f'{float(value):.{digits}g}')}"
    fraction = Number(value.p, value.q)
    needed = next(digits for digits in count(digits) if rounded(fraction, digits) != "1")
    # A long fraction is written as a decimal anyway.
    is_complete = exact.endswith(r"\ldots") and needed <= DIGITS
    return exact if is_complete else f"{exact} {decimal_of(fraction, needed)}"


@cache
def unit_frequency_condition() -> UnitCondition:
    """Return the machine's condition for Ω² = k/m: the quadratic in ε, its root ε*, and its discriminant 1729."""
    return unit_condition(eliminate(machine()).natural_frequency_squared)


def _entered(value: float) -> sp.Rational:
    """Return a float as a decimal; if it uses all digits, return the simple fraction with this float, if one exists.

    Floats outnumber simple fractions by a factor of a million, so a measured decimal hardly ever matches a fraction.
    """
    text = repr(float(value))
    simple = Fraction(value).limit_denominator(_SIMPLE)
    fills = len(Decimal(text).as_tuple().digits) >= _DIGITS_OF_A_FLOAT
    return sp.Rational(simple.numerator, simple.denominator) if fills and float(simple) == value else sp.Rational(text)
