"""From Ω² to 1729: the mass ratio at which the machine is in step with a plain mass on the same spring, Ω² = k/m."""

from dataclasses import replace

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.elimination import Elimination, unit_condition
from ramanujan.derivation.model import Omega_squared, epsilon, epsilon_star, equation, k, m, m_prime
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Step, blackboard, insert, solve_for, step
from ramanujan.number_theory import sums_of_two_cubes
from ramanujan.translation import _


def close_to_one_step(normalized: sp.Expr) -> Step:
    """Return the paper's remark on equal masses: Ω²m/k is close to 1."""
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
    special = replace(compared, equations=(equation(model.normalized_frequency_squared, normalized),))
    return replace(compared, special=lambda _numbers: special)


def unit_steps(general: Elimination) -> tuple[Step, ...]:
    """Return the three steps from Ω² to 1729; for one machine they say how far it is from the condition."""
    unit = unit_condition(general.natural_frequency_squared)
    ratio = m_prime / m
    numerator, terms = general.quotient
    numerator, *terms = (
        sp.factor(term.subs(m_prime, epsilon * m)) for term in (numerator / k, *(term / m for term in terms))
    )
    _plain, rollers, coupling = terms
    over, below = sp.fraction(coupling)
    quadratic = unit.quadratic.as_expr()
    multiplied = in_order(sp.Mul(rollers, below, evaluate=False), over)
    two_terms = rollers + coupling
    normalized = (
        equation(epsilon, ratio),
        equation(model.normalized_frequency_squared, numerator / in_order(*terms)),
        equation(model.normalized_frequency_squared, unit.normalized_frequency_squared.subs(epsilon, ratio)),
    )
    defined = blackboard(_("define {what}"), epsilon)
    only_ratio = step(
        "ratio",
        _("Use the mass ratio"),
        _(
            "Divide numerator and denominator by $m$. In units of $k/m$, the square of the frequency then depends only "
            "on $\\varepsilon=m'/m$. This ratio is the mass of a lower roller divided by the mass of each other body."
        ),
        equation(epsilon, ratio),
        equation(Omega_squared * m / k, numerator / in_order(*terms)),
        equation(Omega_squared * m / k, unit.normalized_frequency_squared),
        operations=(defined, rf"\times {latex(m / k)}", blackboard(_("one fraction"))),
    )
    exactly_one = step(
        "unit",
        _("Require exactly 1"),
        _(
            "Set the first form equal to 1: its denominator must equal its numerator. The ${number}$ cancels. Multiply "
            "by the denominator that is left. This gives a quadratic equation for $\\varepsilon$ with integer "
            "coefficients."
        ).format(number=latex(numerator)),
        equation(in_order(*terms), numerator),
        equation(two_terms, sp.Integer(0)),
        equation(multiplied, sp.Integer(0)),
        equation(quadratic, sp.Integer(0)),
        marks=("left 1, right 1", "", "", ""),
        operations=(
            rf"{latex(model.normalized_frequency_squared)} = 1",
            blackboard(_("cancel {what}"), numerator),
            rf"\times \left({latex(below)}\right)",
            blackboard(_("collect {what}"), epsilon),
        ),
    )
    (a, b, c), square = unit.quadratic.all_coeffs(), unit.completed_square
    sums = sums_of_two_cubes(int(unit.discriminant))
    paper_s, other = (in_order(*(sp.Pow(side, 3, evaluate=False) for side in reversed(pair))) for pair in sums)
    root = step(
        "root",
        _("Find the taxicab number"),
        _(
            "Complete the square. At the right stand two cubes, and their sum is the smallest number that is a sum of "
            "two positive cubes in two ways. Only one root is positive, as a mass ratio must be. It is called "
            "$\\varepsilon_*$."
        ),
        equation(quadratic, sp.Integer(0)),
        equation(in_order(4 * a**2 * epsilon**2, 4 * a * b * epsilon), -4 * a * c),
        equation(square.lhs, paper_s),
        square,
        equation(square.lhs, other),
        equation(epsilon, unit.root),
        marks=("", "right 1", "left 1, right 2", "", "", ""),
        operations=(
            blackboard(_("the quadratic")),
            rf"\times {latex(4 * a)}",
            rf"+\,{latex(b**2)}",
            blackboard(_("add the cubes")),
            blackboard(_("two other cubes")),
            solve_for(epsilon),
        ),
    )

    leaves = tuple(equation(side, sp.factor(side.subs(epsilon, ratio))) for side in (two_terms, quadratic))

    def residual(numbers: Numbers) -> Step:
        """Return the condition with what its left side leaves for one machine."""
        present = numbers.exact[m_prime] / numbers.exact[m]
        difference = unit.quadratic.eval(present) if present.is_Rational else (present - unit.root).expand()
        if difference == 0:
            reason = _(
                "For your $\\varepsilon$ the two terms cancel each other: the machine is in step with a plain mass."
            )
        elif difference > 0:
            reason = _(
                "For your $\\varepsilon$ the two terms do not cancel. What they leave is positive: the denominator is "
                "too large, and your machine oscillates more slowly than a plain mass."
            )
        else:
            reason = _(
                "For your $\\varepsilon$ the two terms do not cancel. What they leave is negative: the denominator is "
                "too small, and your machine oscillates faster than a plain mass."
            )
        return replace(exactly_one, reason=reason, equations=leaves, operations=(insert(epsilon),) * 2, marks=())

    distance = replace(
        root,
        reason=_(
            "The quadratic has one positive root, $\\varepsilon_*$. The last line gives the difference between your "
            "$\\varepsilon$ and this root."
        ),
        equations=(normalized[0], normalized[2], equation(epsilon - epsilon_star, ratio - unit.root)),
        operations=(defined, insert(epsilon), rf"-\,{latex(epsilon_star)}"),
        marks=(),
    )
    return (
        replace(only_ratio, special=lambda _numbers: replace(only_ratio, equations=normalized)),
        replace(exactly_one, special=residual),
        replace(root, special=lambda _numbers: distance),
    )
