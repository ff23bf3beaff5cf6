"""Euler–Lagrange, the paper's route: Ω² for equal masses, then for any masses, then the condition that leads to 1729.

The paper derives Ω² twice. Here one computation does both: with roller mass m, then with roller mass m′.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ramanujan.derivation.elimination import (
    Elimination,
    Phi_ddot,
    UnitCondition,
    X_ddot,
    eliminate,
    unit_condition,
)
from ramanujan.derivation.steps import ROUTES, Route, Step, equation
from ramanujan.derivation.symbols import (
    COORDINATES,
    Omega_squared,
    epsilon,
    epsilon_star,
    k,
    m,
    m_prime,
    machine,
    normalized_frequency_squared,
)
from ramanujan.translation import _

EQUAL_MASSES = equation(m_prime, m)
"""The special case with which the paper begins."""


@ROUTES.add("euler_lagrange")
def build() -> Route:
    """Return the route in the paper's order."""
    bodies = machine()
    equal, general = eliminate(machine(roller_mass=m)), eliminate(bodies)
    unit = unit_condition(general.natural_frequency_squared)
    steps = (
        Step(
            "velocities",
            _("Find the velocity of every body"),
            _(
                "Measure every velocity $v$ relative to the ground, positive to the right. The block moves to the left "
                "with $\\dot X$. No roller slips: relative to the block, its centre moves to the right by $R$ times "
                "its clockwise angle. The top of a lower roller, and with it the slab, moves twice as far."
            ),
            tuple(equation(f"v_{body.name}", body.velocity) for body in bodies.bodies),
        ),
        Step(
            "energies",
            _("Write down the energies"),
            _(
                "The kinetic energy of a rolling body is that of its centre’s motion plus that of its rotation about "
                "the centre. The spring acts between slab and block, so its compression is the slab’s displacement "
                "relative to the block."
            ),
            (
                *(equation(f"T_{body.name}", body.kinetic_energy) for body in bodies.bodies),
                equation("U", bodies.potential_energy),
            ),
        ),
        *_elimination_steps("equal_", equal, EQUAL_MASSES),
        _close_to_one(equal.natural_frequency_squared * m / k),
        *_elimination_steps("", general),
        *_unit_steps(unit),
    )
    return Route("euler_lagrange", _("Euler–Lagrange"), steps, general.natural_frequency_squared, CELLS)


def _close_to_one(normalized: sp.Expr) -> Step:
    """Return the paper's remark on equal masses: Ω²m/k is close to 1."""
    step = Step(
        "equal_close",
        _("Compare with the plain mass"),
        _(
            "A plain mass $m$ on the same spring has $\\Omega^2=k/m$. For machines whose masses are all equal, $m'=m$, "
            "the value is close to this one. Which mass ratio makes the two exactly equal?"
        ),
        (equation(Omega_squared * m / k, normalized),),
        case=EQUAL_MASSES,
    )
    return replace(
        step, present=replace(step, equations=(equation(normalized_frequency_squared, normalized),), case=None)
    )


def _unit_steps(unit: UnitCondition) -> tuple[Step, ...]:
    """Return the three steps from Ω² to 1729; for one machine they say how far it is from the condition."""
    ratio = m_prime / m
    square = unit.completed_square
    quadratic = unit.quadratic.as_expr()
    present = (
        equation(epsilon, ratio),
        equation(normalized_frequency_squared, unit.normalized_frequency_squared.subs(epsilon, ratio)),
    )
    only_ratio = Step(
        "ratio",
        _("Use the mass ratio"),
        _(
            "Divide numerator and denominator by $m^2$. In units of $k/m$, the square of the frequency then depends "
            "only on $\\varepsilon=m'/m$. This ratio is the mass of a lower roller divided by the mass of each other "
            "body."
        ),
        (equation(epsilon, ratio), equation(Omega_squared * m / k, unit.normalized_frequency_squared)),
    )
    exactly_one = Step(
        "unit",
        _("Require exactly 1"),
        _(
            "Set the right side equal to 1 and multiply by the denominator. This gives a quadratic equation for "
            "$\\varepsilon$ with integer coefficients."
        ),
        (equation(quadratic, sp.Integer(0)),),
    )
    root = Step(
        "root",
        _("Find the taxicab number"),
        _(
            "$\\Omega^2m/k=1$ is a quadratic equation for $\\varepsilon$. A mass ratio is positive, and only one of "
            "the two roots is; it is called $\\varepsilon_*$. Completing the square shows the discriminant, the number "
            "under its square root."
        ),
        (equation(quadratic, sp.Integer(0)), equation(epsilon, unit.root), square),
    )
    return (
        replace(only_ratio, present=replace(only_ratio, equations=present)),
        replace(
            exactly_one,
            present=replace(
                exactly_one,
                reason=_(
                    "The condition is that a quadratic in $\\varepsilon$ is zero. For your $\\varepsilon$ it has the "
                    "value below."
                ),
                equations=(equation(quadratic, quadratic.subs(epsilon, ratio)),),
            ),
        ),
        replace(
            root,
            present=replace(
                root,
                reason=_(
                    "The quadratic has one positive root, $\\varepsilon_*$. The last two lines give the difference "
                    "between your $\\varepsilon$ and this root, and the completed square for your $\\varepsilon$."
                ),
                equations=(
                    *present,
                    equation(epsilon - epsilon_star, ratio - unit.root),
                    equation(square.lhs, square.lhs.subs(epsilon, ratio)),
                ),
            ),
        ),
    )


def _elimination_steps(prefix: str, result: Elimination, case: sp.Eq | None = None) -> tuple[Step, ...]:
    """Return the four steps from ℒ to Ω², the same for equal masses and for any."""
    here = "" if case is None else " " + _("This step is about machines whose masses are all equal, $m'=m$.")
    lagrange = (
        "$\\frac{d}{dt}\\frac{\\partial\\mathcal{L}}{\\partial\\dot q}-\\frac{\\partial\\mathcal{L}}{\\partial q}=0$"
    )
    return (
        Step(
            f"{prefix}lagrangian",
            _("Write down the Lagrangian"),
            _("The Lagrangian is $\\mathcal L=T-U$. Like terms are collected.") + here,
            (equation("L", result.lagrangian),),
            case,
        ),
        Step(
            f"{prefix}motion",
            _("Write down Lagrange’s equations"),
            _(
                "Each coordinate $q$ obeys {equation}. The contact forces do not appear: without slip they do no net "
                "work. A common factor of all terms is cancelled."
            ).format(equation=lagrange)
            + here,
            tuple(equation(result.motion[q], sp.Integer(0)) for q in COORDINATES),
            case,
        ),
        Step(
            f"{prefix}elimination",
            _("Eliminate the block and the top cylinder"),
            _(
                "The potential energy depends on $\\varphi$ alone, so the equations of $X$ and $\\Phi$ contain only "
                "accelerations. Solve them for $\\ddot X$ and $\\ddot\\Phi$ in terms of $\\ddot\\varphi$."
            )
            + here,
            (
                equation(Phi_ddot, result.Phi_from_X),
                equation(X_ddot, result.X_from_phi),
                equation(Phi_ddot, result.Phi_from_phi),
            ),
            case,
        ),
        Step(
            f"{prefix}frequency",
            _("Read off the frequency"),
            _(
                "Insert $\\ddot X$ into the equation of $\\varphi$. This leaves the equation of a harmonic oscillator, "
                "$\\ddot\\varphi+\\Omega^2\\varphi=0$, up to a factor."
            )
            + here,
            (
                equation(result.remaining, sp.Integer(0)),
                equation(Omega_squared, result.natural_frequency_squared),
            ),
            case,
        ),
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
