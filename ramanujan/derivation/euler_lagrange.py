"""Euler–Lagrange, the paper's way: from the Lagrangian to Ω², first for equal masses, then for any, then to 1729.

Both halves of the paper are one computation, run with roller mass m and with roller mass m′.
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

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)

EQUAL_MASSES = equation(m_prime, m)
"""The case with which the paper begins."""


def euler_lagrange_operator(lagrangian: sp.Expr, q: sp.Expr) -> sp.Expr:
    """Return d/dt ∂ℒ/∂q̇ − ∂ℒ/∂q, whose zero is the equation of motion of q.  Source: paper, eq. (3).

    >>> euler_lagrange_operator(m * X.diff(t) ** 2 / 2 - k * X**2 / 2, X)
    k*X(t) + m*Derivative(X(t), (t, 2))
    """
    return lagrangian.diff(q.diff(t)).diff(t) - lagrangian.diff(q)


@dataclass(frozen=True)
class Elimination:
    """The three equations of motion and what is left of them when X and Φ are expressed by φ.

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
        a, b, _ = self.quadratic.all_coeffs()
        return equation((2 * a * epsilon + b) ** 2, self.discriminant)


def unit_condition(natural_frequency_squared: sp.Expr) -> UnitCondition:
    """Return the condition Ω²m/k = 1 for a frequency given in m, m′ and k, as a quadratic in ε with integers.

    Raises
    ------
    ValueError : not exactly one positive mass ratio fulfils it.

    >>> unit_condition(eliminate(machine()).natural_frequency_squared).completed_square
    Eq((36*varepsilon + 1)**2, 1729)
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
    roots = [root for root in sp.roots(quadratic, multiple=True) if root.is_positive]
    if len(roots) != 1:
        raise ValueError("natural_frequency_squared must be k/m at exactly one positive mass ratio")
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
            "Follow every body relative to the ground",
            "Measure every velocity $v$ relative to the ground, positive to the right. The block moves to the left "
            "with $\\dot X$. The angles $\\varphi$ and $\\Phi$ count clockwise, so relative to the block a roller’s "
            "centre moves to the right by $R$ times its angle. The slab lies on top of the lower rollers and moves "
            "twice as far.",
            tuple(equation(f"v_{body.name}", body.velocity) for body in bodies.bodies),
        ),
        Step(
            "energies",
            "Add up the energies",
            "A rolling body has kinetic energy of translation, given by the velocity of its centre, and of rotation. "
            "The spring is compressed by the slab’s displacement relative to the block.",
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
    return Route("euler_lagrange", "Euler–Lagrange", steps, general.natural_frequency_squared, CELLS)


def _close_to_one(normalized: sp.Expr) -> Step:
    """Return the paper's remark on equal masses: Ω²m/k is nearly 1."""
    step = Step(
        "equal_close",
        "Nearly one",
        "What would make the square of the frequency, in units of $k/m$, exactly 1? It is close to 1 for machines "
        "whose masses are all equal.",
        (equation(Omega_squared * m / k, normalized),),
        case=EQUAL_MASSES,
    )
    return replace(
        step, present=replace(step, equations=(equation(normalized_frequency_squared, normalized),), case=None)
    )


def _unit_steps(unit: UnitCondition) -> tuple[Step, ...]:
    """Return the three steps from Ω² to 1729; about one machine they say how far it is from the condition."""
    ratio = m_prime / m
    square = unit.completed_square
    quadratic = unit.quadratic.as_expr()
    present = (
        equation(epsilon, ratio),
        equation(normalized_frequency_squared, unit.normalized_frequency_squared.subs(epsilon, ratio)),
    )
    only_ratio = Step(
        "ratio",
        "Only the ratio of the masses matters",
        "In units of $k/m$, the square of the frequency depends on the mass ratio $\\varepsilon=m'/m$ alone.",
        (equation(epsilon, ratio), equation(Omega_squared * m / k, unit.normalized_frequency_squared)),
    )
    exactly_one = Step(
        "unit",
        "Ask for exactly one",
        "Set the right side equal to 1 and clear the fraction. What remains is a quadratic equation for "
        "$\\varepsilon$ with integer coefficients.",
        (equation(quadratic, sp.Integer(0)),),
    )
    root = Step(
        "root",
        "The number of the taxicab",
        "A mass ratio is positive, and only one root is; call it $\\varepsilon_*$. Completing the square shows the "
        "number under its square root.",
        (equation(epsilon, unit.root), square),
    )
    return (
        replace(only_ratio, present=replace(only_ratio, equations=present)),
        replace(
            exactly_one,
            present=replace(
                exactly_one,
                reason="Set the right side equal to 1 and clear the fraction: a quadratic in $\\varepsilon$ must be 0. "
                "For your $\\varepsilon$ it has this value.",
                equations=(equation(quadratic, quadratic.subs(epsilon, ratio)),),
            ),
        ),
        replace(
            root,
            present=replace(
                root,
                reason="The quadratic has one positive root, $\\varepsilon_*$. This is how far your $\\varepsilon$ is "
                "from it, and what your $\\varepsilon$ makes of the completed square.",
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
    here = "" if case is None else " This step is about machines whose masses are all equal, $m'=m$."
    return (
        Step(
            f"{prefix}lagrangian",
            "Write the Lagrangian",
            f"The Lagrangian is $\\mathcal{{L}}=T-U$, with like terms collected.{here}",
            (equation("L", result.lagrangian),),
            case,
        ),
        Step(
            f"{prefix}motion",
            "Write down Lagrange’s equations",
            "Each coordinate $q$ has its equation of motion, $\\frac{d}{dt}\\frac{\\partial\\mathcal{L}}"
            "{\\partial\\dot q}-\\frac{\\partial\\mathcal{L}}{\\partial q}=0$. "
            f"A factor that all its terms share is cancelled.{here}",
            tuple(equation(result.motion[q], sp.Integer(0)) for q in COORDINATES),
            case,
        ),
        Step(
            f"{prefix}elimination",
            "Express the block and the top cylinder by the rollers",
            "The potential energy depends on $\\varphi$ alone, so the equations of $X$ and $\\Phi$ contain only "
            f"accelerations. They give $\\ddot X$ and $\\ddot\\Phi$ in terms of $\\ddot\\varphi$.{here}",
            (
                equation(Phi_ddot, result.Phi_from_X),
                equation(X_ddot, result.X_from_phi),
                equation(Phi_ddot, result.Phi_from_phi),
            ),
            case,
        ),
        Step(
            f"{prefix}frequency",
            "Read off the frequency",
            "Insert $\\ddot X$ into the equation of $\\varphi$. What remains is the equation of one oscillator, "
            f"$\\ddot\\varphi+\\Omega^2\\varphi=0$.{here}",
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
"""The notebook to take home: step key → plain SymPy that works the step out again."""
