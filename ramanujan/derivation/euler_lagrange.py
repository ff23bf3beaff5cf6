"""Euler–Lagrange, the paper's route: Ω² from Lagrange's equations, then the condition that leads to 1729.

The paper derives Ω² twice, first for equal masses. Here one computation does both: with roller mass m′ or m.
"""

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.elimination import Elimination, Phi_ddot, X_ddot, eliminate, phi_ddot
from ramanujan.derivation.in_step import close_to_one_step, unit_steps
from ramanujan.derivation.lagrangian import COLLECTED, bodies_steps
from ramanujan.derivation.model import COORDINATES, MOMENTA, Omega_squared, equation, gather, k, m, m_prime, phi, t
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import ROUTES, Route, Step, compare_factors, insert, margin_text, solve_for, step
from ramanujan.text.translation import _


@ROUTES.add("euler_lagrange")
def build(bodies: model.Machine) -> Route:
    """Return the route in the paper's order. At equal masses its last step only compares Ω²m/k with 1."""
    result = eliminate(bodies)
    frequency = result.natural_frequency_squared
    ending = unit_steps(result) if frequency.has(m_prime) else (close_to_one_step(frequency * m / k),)
    steps = (*bodies_steps(bodies), *_elimination_steps(result), *ending)
    return Route(
        name="euler_lagrange",
        title=_("Euler–Lagrange"),
        idea=_("energies of all bodies; no contact force appears"),
        steps=steps,
        natural_frequency_squared=frequency,
        cells=CELLS,
    )


def _elimination_steps(result: Elimination) -> tuple[Step, ...]:
    """Return the steps from ℒ to Ω²."""
    coordinates = tuple(latex(q) for q in COORDINATES)
    return (
        _lagrangian_step(result),
        _momenta_step(result),
        _rates_step(result, coordinates),
        _motion_step(result, coordinates),
        _elimination_step(result),
        _insertion_step(result),
        _frequency_step(result),
    )


def _lagrangian_step(result: Elimination) -> Step:
    return step(
        "lagrangian",
        _("Collect like terms"),
        _("Multiply out the squares, and collect the terms with the same product of velocities or coordinates."),
        equation("L", result.lagrangian),
        operations=(COLLECTED,),
    )


def _momenta_step(result: Elimination) -> Step:
    return step(
        "momenta",
        _("Differentiate with respect to the velocities"),
        _("Each coordinate $q$ has a momentum, $p_q=\\partial\\mathcal L/\\partial\\dot q$."),
        *(equation(p, value) for p, value in zip(MOMENTA, result.momenta.values(), strict=True)),
        operations=tuple(rf"\partial\mathcal{{L}}/\partial {latex(q.diff(t))}" for q in COORDINATES),
    )


def _rates_step(result: Elimination, coordinates: tuple[str, ...]) -> Step:
    return step(
        "rates",
        _("Write down Lagrange’s equations"),
        _(
            "Each coordinate obeys {equation}: the momentum is differentiated once more with respect to time. The "
            "paper writes $\\Lambda_q\\mathcal L=0$ for this. The contact forces do not appear: without slip they "
            "do no net work."
        ).format(
            equation="$\\frac{d}{dt}\\frac{\\partial\\mathcal{L}}{\\partial\\dot q}"
            "=\\frac{\\partial\\mathcal{L}}{\\partial q}$"
        ),
        *(equation(gather(p.diff(t)), result.forces[q]) for q, p in result.momenta.items()),
        labels=coordinates,
        operations=tuple(rf"\tfrac{{d}}{{dt}}\,{latex(p)}" for p in MOMENTA),
    )


def _motion_step(result: Elimination, coordinates: tuple[str, ...]) -> Step:
    return step(
        "motion",
        _("Cancel common factors"),
        _("Bring all terms to one side. Common factors cancel."),
        *(equation(result.motion[q], sp.S.Zero) for q in COORDINATES),
        labels=coordinates,
        underlined_terms=("", "left 3", ""),
        operations=tuple(
            "" if factor == 1 else margin_text(_("cancel {what}"), factor) for factor in result.common.values()
        ),
    )


def _elimination_step(result: Elimination) -> Step:
    Phi_line, _multiple, _replaced = result.merged
    above, below = sp.fraction(Phi_line.lhs)
    return step(
        "elimination",
        _("Eliminate the block and the top cylinder"),
        _(
            "The first line is the equation of $\\Phi$. Multiply the $X$ equation by ${times}$. It then contains "
            "${above}/{below}$, which by the first line equals ${same}$. Solve for ${same}$, and insert it into "
            "the first line."
        ).format(times=result.multiplier, above=latex(above), below=below, same=latex(Phi_line.rhs)),
        *result.merged,
        equation(X_ddot, result.X_ddot_from_phi_ddot),
        equation(Phi_ddot, result.Phi_ddot_from_phi_ddot),
        underlined_terms=("", "left 2, right 1", "left 2", "", ""),
        operations=(
            rf"+\,{latex(Phi_line.rhs)}",
            rf"\times {latex(result.multiplier)}",
            insert(X_ddot),
            solve_for(X_ddot),
            insert(X_ddot),
        ),
    )


def _insertion_step(result: Elimination) -> Step:
    spring = result.motion[phi].coeff(phi)
    numerator, terms = result.quotient
    # The equation of φ is the common number times the terms times φ̈, plus the spring's term.
    common_number = spring / numerator
    return step(
        "insertion",
        _("Insert the block’s acceleration"),
        _("Insert $\\ddot X$ into the equation of $\\varphi$ and divide by the factor of $\\ddot\\varphi$."),
        equation(result.inserted, sp.S.Zero),
        equation(in_order(common_number * in_order(*terms) * phi_ddot, spring * phi), sp.S.Zero),
        equation(in_order(phi_ddot, numerator / in_order(*terms) * phi), sp.S.Zero),
        equation(in_order(phi_ddot, result.natural_frequency_squared * phi), sp.S.Zero),
        underlined_terms=("left 1, left 2", "left 1", "left 2", "left 2"),
        operations=(
            insert(X_ddot),
            margin_text(_("collect {what}"), phi_ddot),
            margin_text(_("divide by the factor of {what}"), phi_ddot),
            margin_text(_("one fraction")),
        ),
    )


def _frequency_step(result: Elimination) -> Step:
    oscillator = equation(in_order(phi_ddot, Omega_squared * phi), sp.S.Zero)
    return step(
        "frequency",
        _("Read off the frequency"),
        _(
            "This is the equation of a harmonic oscillator. It has the solution $\\varphi=\\cos\\Omega t$, because "
            "two derivatives with respect to time give $-\\Omega^2\\cos\\Omega t$. So the factor of $\\varphi$ is "
            "$\\Omega^2$. With a minus sign before it, $e^{{\\Omega t}}$ would be a solution: the machine would "
            "run away instead of oscillating."
        ).format(),
        oscillator,
        equation(Omega_squared, result.natural_frequency_squared),
        underlined_terms=("left 2", ""),
        operations=(insert(r"\varphi=\cos\Omega t"), compare_factors(phi)),
    )


CELLS = {
    "motion": """\
def euler_lagrange(lagrangian, x):
    return sp.expand(lagrangian.diff(x.diff(t)).diff(t) - lagrangian.diff(x))


motion = {x: euler_lagrange(L, x) for x in q}
[sp.Eq(left, 0) for left in motion.values()]""",
    "elimination": """\
X_ddot, phi_ddot, Phi_ddot = (x.diff(t, 2) for x in q)
coupled = sp.solve([motion[X], motion[Phi]], [X_ddot, Phi_ddot])
coupled""",
    "frequency": """\
remaining = sp.expand(motion[phi].subs(X_ddot, coupled[X_ddot]))
Omega_squared = sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot))
Omega_squared""",
    "ratio": """\
epsilon = sp.Symbol("varepsilon", positive=True)
normalized = sp.factor(Omega_squared.subs(m_prime, epsilon * m) * m / k)
normalized""",
    "unit": """\
numerator, denominator = sp.fraction(sp.together(normalized))
quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
sp.Eq(quadratic.as_expr(), 0)""",
    "root": """\
(unit_ratio,) = (root for root in sp.solve(quadratic.as_expr(), epsilon) if root.is_positive)
assert sp.radsimp(normalized.subs(epsilon, unit_ratio)) == 1
unit_ratio, quadratic.discriminant()""",
}
"""The notebook: step key → plain SymPy that repeats the step."""
