"""From Ω² to 1729: the mass ratio with Ω² = k/m, where the machine is in step with a plain mass on the same spring."""

from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.elimination import Elimination, UnitCondition, unit_condition
from ramanujan.derivation.model import Omega_squared, epsilon, epsilon_star, equation, k, m, m_prime
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Step, insert, margin_text, solve_for, step
from ramanujan.number_theory import sums_of_two_cubes
from ramanujan.text.translation import _


def close_to_one_step(normalized: sp.Expr) -> Step:
    """Return the step with the paper's remark on equal masses: Ω²m/k is close to 1."""
    compared = step(
        "close",
        _("Compare with the plain mass"),
        _(
            "A plain mass $m$ on the same spring has $\\Omega^2=k/m$. With equal masses, $m'=m$, the machine comes "
            "close to it. Which mass ratio makes the two exactly equal?"
        ),
        equation(Omega_squared * m / k, normalized),
        operations=(rf"\times {latex(m / k)}",),
    )
    with_one_symbol = replace(compared, equations=(equation(model.normalized_frequency_squared, normalized),))
    return replace(compared, variant=lambda _numbers: with_one_symbol)


RATIO = m_prime / m
_NORMALIZED = model.normalized_frequency_squared


@dataclass(frozen=True)
class RatioForms:
    """Ω²m/k as a function of ε, and the condition Ω²m/k = 1.

    Parameters
    ----------
    numerator, terms : the numerator of the fraction after the elimination, and the three terms of its denominator
    condition : the quadratic in ε, its root and its discriminant
    """

    numerator: sp.Expr
    terms: tuple[sp.Expr, ...]
    condition: UnitCondition

    @property
    def quadratic(self) -> sp.Expr:
        """The left side of the quadratic equation for ε."""
        return self.condition.quadratic.as_expr()

    @property
    def left_over(self) -> sp.Expr:
        """The sum of the second and third term, which is 0 at ε*. The first term equals the numerator and cancels."""
        _first, rollers, coupling = self.terms
        return rollers + coupling

    def difference_at(self, numbers: Numbers) -> sp.Expr:
        """Return a number with the sign of ε − ε* for a machine."""
        ratio = numbers.exact[m_prime] / numbers.exact[m]
        if ratio.is_Rational:
            return self.condition.quadratic.eval(ratio)
        return (ratio - self.condition.root).expand()


def unit_steps(result: Elimination) -> tuple[Step, ...]:
    """Return the three steps from Ω² to 1729. With numbers they state a machine's distance from the condition."""
    numerator, terms = result.quotient
    in_units_of_k = sp.factor((numerator / k).subs(m_prime, epsilon * m))
    in_units_of_m = tuple(sp.factor((term / m).subs(m_prime, epsilon * m)) for term in terms)
    forms = RatioForms(in_units_of_k, in_units_of_m, unit_condition(result.natural_frequency_squared))
    return _ratio_step(forms), _unit_step(forms), _root_step(forms)


def _ratio_step(forms: RatioForms) -> Step:
    general = step(
        "ratio",
        _("Use the mass ratio"),
        _(
            "Divide numerator and denominator by $m$. In units of $k/m$, the square of the frequency then depends only "
            "on $\\varepsilon=m'/m$. This ratio is the mass of a lower roller divided by the mass of each other body."
        ),
        equation(epsilon, RATIO),
        equation(Omega_squared * m / k, forms.numerator / in_order(*forms.terms)),
        equation(Omega_squared * m / k, forms.condition.normalized_frequency_squared),
        operations=(_define_ratio(), rf"\times {latex(m / k)}", margin_text(_("one fraction"))),
    )
    equations = (
        equation(epsilon, RATIO),
        equation(_NORMALIZED, forms.numerator / in_order(*forms.terms)),
        equation(_NORMALIZED, forms.condition.normalized_frequency_squared.subs(epsilon, RATIO)),
    )
    return replace(general, variant=lambda _numbers: replace(general, equations=equations))


def _unit_step(forms: RatioForms) -> Step:
    _first, rollers, coupling = forms.terms
    above, below = sp.fraction(coupling)
    multiplied = in_order(sp.Mul(rollers, below, evaluate=False), above)
    general = step(
        "unit",
        _("Require exactly 1"),
        _(
            "Set the first form equal to 1: its denominator must equal its numerator. The ${number}$ cancels. Multiply "
            "by the denominator that is left. This gives a quadratic equation for $\\varepsilon$ with integer "
            "coefficients."
        ).format(number=latex(forms.numerator)),
        equation(in_order(*forms.terms), forms.numerator),
        equation(forms.left_over, sp.Integer(0)),
        equation(multiplied, sp.Integer(0)),
        equation(forms.quadratic, sp.Integer(0)),
        underlined_terms=("left 1, right 1", "", "", ""),
        operations=(
            rf"{latex(_NORMALIZED)} = 1",
            margin_text(_("cancel {what}"), forms.numerator),
            rf"\times \left({latex(below)}\right)",
            margin_text(_("collect {what}"), epsilon),
        ),
    )
    sides = (forms.left_over, forms.quadratic)
    left = tuple(equation(side, sp.factor(side.subs(epsilon, RATIO))) for side in sides)

    def residual_step(numbers: Numbers) -> Step:
        """Return the step with the value of the condition's left side for one machine."""
        reason = _compare_with_plain_mass(forms.difference_at(numbers))
        return replace(general, reason=reason, equations=left, operations=(insert(epsilon),) * 2, underlined_terms=())

    return replace(general, variant=residual_step)


def _compare_with_plain_mass(difference: sp.Expr) -> str:
    """Return a sentence that compares a machine with a plain mass: in step, faster or slower."""
    if difference == 0:
        return _("For your $\\varepsilon$ the two terms cancel each other: the machine is in step with a plain mass.")
    if difference > 0:
        return _(
            "For your $\\varepsilon$ the two terms do not cancel. What they leave is positive: the denominator is "
            "too large, and your machine oscillates more slowly than a plain mass."
        )
    return _(
        "For your $\\varepsilon$ the two terms do not cancel. What they leave is negative: the denominator is "
        "too small, and your machine oscillates faster than a plain mass."
    )


def _root_step(forms: RatioForms) -> Step:
    a, b, c = forms.condition.quadratic.all_coeffs()
    square = forms.condition.completed_square
    paper_pair, other_pair = sums_of_two_cubes(int(forms.condition.discriminant))
    general = step(
        "root",
        _("Find the taxicab number"),
        _(
            "Complete the square. At the right stand two cubes, and their sum is the smallest number that is a sum of "
            "two positive cubes in two ways. Only one root is positive, as a mass ratio must be."
        ),
        equation(forms.quadratic, sp.Integer(0)),
        equation(in_order(4 * a**2 * epsilon**2, 4 * a * b * epsilon), -4 * a * c),
        equation(square.lhs, _write_sum_of_cubes(*paper_pair)),
        square,
        equation(square.lhs, _write_sum_of_cubes(*other_pair)),
        equation(epsilon, forms.condition.root),
        underlined_terms=("", "right 1", "left 1, right 2", "", "", ""),
        operations=(
            margin_text(_("the quadratic")),
            rf"\times {latex(4 * a)}",
            rf"+\,{latex(b**2)}",
            margin_text(_("add the cubes")),
            margin_text(_("two other cubes")),
            solve_for(epsilon),
        ),
    )
    return replace(general, variant=lambda _numbers: _distance_step(general, forms.condition))


def _write_sum_of_cubes(smaller: int, larger: int) -> sp.Expr:
    return in_order(sp.Pow(larger, 3, evaluate=False), sp.Pow(smaller, 3, evaluate=False))


def _distance_step(general: Step, condition: UnitCondition) -> Step:
    """Return the step with the distance of one machine's mass ratio from the root."""
    return replace(
        general,
        reason=_(
            "The quadratic has one positive root, $\\varepsilon_*$. The last line gives the difference between your "
            "$\\varepsilon$ and this root."
        ),
        equations=(
            equation(epsilon, RATIO),
            equation(_NORMALIZED, condition.normalized_frequency_squared.subs(epsilon, RATIO)),
            equation(epsilon - epsilon_star, RATIO - condition.root),
        ),
        operations=(_define_ratio(), insert(epsilon), rf"-\,{latex(epsilon_star)}"),
        underlined_terms=(),
    )


def _define_ratio() -> str:
    return margin_text(_("define {what}"), epsilon)
