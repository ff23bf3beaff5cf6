"""The present masses as exact numbers, for a derivation with numbers.

A float is read as what a person has entered: 0.1 is 1/10, and the float nearest to 5/6 is 5/6. If m′ is the float
nearest to ε*m, it is read as ε*m = (√1729 − 1)/36 · m itself. That Ω² then equals k/m is computed, not assumed.
"""

from dataclasses import dataclass, fields, replace
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from itertools import count
from typing import Any

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.elimination import UnitCondition, eliminate, unit_condition
from ramanujan.derivation.model import k, m, m_prime, machine
from ramanujan.derivation.printers import DIGITS, Number, decimal_of, latex, rounded
from ramanujan.numerals import in_latex
from ramanujan.translation import _

_DIGITS_OF_A_FLOAT = 15
"""So many digits, and more, tell a float from its neighbours."""
_SIMPLE = 10_000
"""The largest denominator of a fraction that a person would enter."""


@dataclass(frozen=True)
class Numbers:
    """The numbers of one machine as a person has entered them, by the names of their symbols.

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
        """Return the numbers of a machine that has them as attributes, such as an `Oscillator`."""
        return cls(*(getattr(machine, field.name) for field in fields(cls)))

    @property
    def with_equal_masses(self) -> "Numbers":
        """The same with m′ = m."""
        return replace(self, m_prime=self.m)

    @cached_property
    def exact(self) -> dict[sp.Symbol, sp.Expr]:
        """The same as exact SymPy numbers: symbol → number.

        >>> Numbers(1.85, 5 / 6, 33.5).exact
        {m: 37/20, m_prime: 5/6, k: 67/2}
        """
        read = {getattr(model, field.name): _entered(getattr(self, field.name)) for field in fields(self)}
        if stands_for_the_root(self.m, self.m_prime):
            read[m_prime] = unit_frequency_condition().root * read[m]
        return read


def stands_for_the_root(mass: float, roller_mass: float) -> bool:
    """Tell whether m′ is the float nearest to ε*m, or the product of m and the float nearest to ε*.

    These two floats differ by at most two units in the last place. The answer is also yes if m is m′/ε*, rounded.

    Parameters
    ----------
    mass, roller_mass : m, m′ [kg]

    >>> from ramanujan import UNIT_MASS_RATIO
    >>> stands_for_the_root(1.0, UNIT_MASS_RATIO), stands_for_the_root(1.0, 1.127256827)
    (True, False)
    """
    root = _root()
    product = root * Fraction(repr(float(mass)))
    return roller_mass in (float(root) * mass, float(product)) or mass == roller_mass / float(root)


@cache
def _root() -> Fraction:
    """Return ε* to fifty digits: no float, and no midpoint of two floats, lies between that number and ε*."""
    return Fraction(str(sp.N(unit_frequency_condition().root, 50)))


def stated(numbers: Numbers) -> str:
    """Return the sentence that names the masses and the stiffness of a derivation with numbers; Markdown with $…$.

    >>> print(stated(Numbers(1.85, 0.86, 33.5)))
    The numbers are for $m=1.85\\,\\mathrm{kg}$, $m'=0.86\\,\\mathrm{kg}$ and $k=33.5\\,\\mathrm{N/m}$, in SI units.
    """
    mass, roller_mass, stiffness = (_short(numbers.exact[symbol]) for symbol in (m, m_prime, k))
    sentence = _("The numbers are for {mass}, {roller_mass} and {stiffness}, in SI units.").format(
        mass=rf"$m={mass}\,\mathrm{{kg}}$",
        roller_mass=rf"$m'={roller_mass}\,\mathrm{{kg}}$",
        stiffness=rf"$k={stiffness}\,\mathrm{{N/m}}$",
    )
    if numbers.exact[m_prime].is_Rational:
        return sentence
    nearest = _("The computer stores $m'$ as the floating-point number nearest to this value.")
    return f"{sentence} {nearest}"


def _short(value: sp.Expr) -> str:
    """Return a number as LaTeX, as a decimal if that has only a few places."""
    if value.is_Rational and value.q > 1 and 10**15 % value.q == 0:
        return in_latex(f"{Decimal(value.p) / Decimal(value.q):f}")
    return latex(value)


def with_decimal(value: sp.Expr, digits: int = 5) -> str:
    """Return a number as LaTeX, and its decimal: of some digits, or of as many as tell it from 1.

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
    says_all = exact.endswith(r"\ldots") and needed <= DIGITS
    return exact if says_all else f"{exact} {decimal_of(fraction, needed)}"


@cache
def unit_frequency_condition() -> UnitCondition:
    """Return the condition for Ω² = k/m of the machine itself: its quadratic in ε, the root ε*, and 1729."""
    return unit_condition(eliminate(machine()).natural_frequency_squared)


def _entered(value: float) -> sp.Rational:
    """Return the decimal that a person sees or, if it fills a float, the simple fraction that has this float, if any.

    There are a million times more floats than simple fractions, so a measured decimal is hardly ever taken for one.
    """
    text = repr(float(value))
    simple = Fraction(value).limit_denominator(_SIMPLE)
    fills = len(Decimal(text).as_tuple().digits) >= _DIGITS_OF_A_FLOAT
    return sp.Rational(simple.numerator, simple.denominator) if fills and float(simple) == value else sp.Rational(text)
