"""Euler–Lagrange, the paper's route: Ω² for equal masses, then for any masses, then the condition that leads to 1729.

The paper derives Ω² twice. Here one computation does both: with roller mass m, then with roller mass m′.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ramanujan.derivation.steps import ROUTES, Route, Step, equation
from ramanujan.derivation.symbols import (
    COORDINATES,
    Machine,
    Omega_squared,
    Phi,
    R,
    X,
    epsilon,
    epsilon_star,
    gather,
    k,
    m,
    m_prime,
    machine,
    normalized_frequency_squared,
    phi,
    t,
)
from ramanujan.words import _

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)

EQUAL_MASSES = equation(m_prime, m)
"""The special case with which the paper begins."""


def euler_lagrange_operator(lagrangian: sp.Expr, q: sp.Expr) -> sp.Expr:
    """Return d/dt ∂ℒ/∂q̇ − ∂ℒ/∂q, whose zero is the equation of motion of q.  Source: paper, eq. (3).

    >>> euler_lagrange_operator(m * X.diff(t) ** 2 / 2 - k * X**2 / 2, X)
    k*X(t) + m*Derivative(X(t), (t, 2))
    """
    return lagrangian.diff(q.diff(t)).diff(t) - lagrangian.diff(q)


@dataclass(frozen=True)
class Elimination:
    """The three equations of motion, and the one that is left when X and Φ are expressed by φ.

    `motion` maps each coordinate to its equation (left side of … = 0, without common factor); the others are
    Φ̈ in terms of Ẍ, Ẍ and Φ̈ in terms of φ̈, the φ equation after insertion, and Ω².
    """

    lagrangian: sp.Expr
    motion: dict[sp.Expr, sp.Expr]
    Phi_from_X: sp.Expr
    X_from_phi: sp.Expr
    Phi_from_phi: sp.Expr
    remaining: sp.Expr
    natural_frequency_squared: sp.Expr


@cache
def eliminate(bodies: Machine) -> Elimination:
    """Return the paper's elimination for the machine: the Φ equation into the X equation, both into that of φ.

    >>> eliminate(machine(roller_mass=m)).natural_frequency_squared
    104*k/(99*m)
    """
    lagrangian = bodies.lagrangian
    motion = {q: _without_common_factor(euler_lagrange_operator(lagrangian, q)) for q in COORDINATES}
    (Phi_from_X,) = sp.solve(motion[Phi], Phi_ddot)
    (X_from_phi,) = sp.solve(motion[X].subs(Phi_ddot, Phi_from_X), X_ddot)
    Phi_from_phi = sp.factor(Phi_from_X.subs(X_ddot, X_from_phi))
    remaining = gather(motion[phi].subs(X_ddot, X_from_phi))
    frequency = sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot))
    return Elimination(lagrangian, motion, Phi_from_X, sp.factor(X_from_phi), Phi_from_phi, remaining, frequency)


@dataclass(frozen=True)
class UnitCondition:
    """When Ω² = k/m: the frequency in units of k/m, the quadratic in ε = m′/m, its positive root, its discriminant."""

    normalized_frequency_squared: sp.Expr
    quadratic: sp.Poly
    root: sp.Expr
    discriminant: sp.Integer

    @property
    def completed_square(self) -> sp.Eq:
        """(2aε + b)² = b² − 4ac, the quadratic times 4a with the square completed.  Source: paper, section 2.1."""
        a, b = self.quadratic.all_coeffs()[:2]
        return equation((2 * a * epsilon + b) ** 2, self.discriminant)


def unit_condition(natural_frequency_squared: sp.Expr) -> UnitCondition:
    """Return the condition Ω²m/k = 1 for a frequency given in m, m′ and k, as a quadratic in ε with integers.

    Raises
    ------
    ValueError : not exactly one positive mass ratio satisfies it.

    >>> unit_condition(eliminate(machine()).natural_frequency_squared).completed_square
    Eq((36*varepsilon + 1)**2, 1729)
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
    roots = [root for root in sp.roots(quadratic, multiple=True) if root.is_positive]
    if len(roots) != 1:
        raise ValueError(_("natural_frequency_squared must be k/m at exactly one positive mass ratio"))
    return UnitCondition(normalized, quadratic, sp.factor(roots[0]), quadratic.discriminant())


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
            "A mass ratio is positive, and only one of the two roots is; call it $\\varepsilon_*$. Completing the "
            "square shows the discriminant, the number under its square root."
        ),
        (equation(epsilon, unit.root), square),
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


def _without_common_factor(expression: sp.Expr) -> sp.Expr:
    """Return the equation's left side divided by the symbols that all of its coefficients share."""
    gathered = gather(expression)
    common = sp.gcd_list([term.as_independent(*COORDINATES)[0] for term in gathered.args])
    return gather(sp.cancel(gathered / sp.Mul(*(f for f in sp.Mul.make_args(common) if f in (m, R)))))


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
