"""Euler–Lagrange, the paper's way: from the Lagrangian to Ω², first for equal masses, then for any, then to 1729.

Both halves of the paper are one computation, run with roller mass m and with roller mass m′.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ramanujan.derivation.steps import Route, Step, equation
from ramanujan.derivation.symbols import (
    COORDINATES,
    Machine,
    Omega_squared,
    Phi,
    R,
    X,
    epsilon,
    gather,
    k,
    m,
    m_prime,
    machine,
    phi,
    t,
)

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)


def euler_lagrange_operator(lagrangian: sp.Expr, q: sp.Expr) -> sp.Expr:
    """Return Λ_q ℒ = d/dt ∂ℒ/∂q̇ − ∂ℒ/∂q, whose zero is the equation of motion of q.  Source: paper, eq. (3)."""
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
    """Return the paper's elimination for the machine: the Φ equation into the X equation, both into that of φ."""
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
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
    roots = [root for root in sp.roots(quadratic, multiple=True) if root.is_positive]
    if len(roots) != 1:
        raise ValueError("natural_frequency_squared must be k/m at exactly one positive mass ratio")
    return UnitCondition(normalized, quadratic, sp.factor(roots[0]), quadratic.discriminant())


def build() -> Route:
    """Return the route in the paper's order."""
    bodies = machine()
    equal, general = eliminate(machine(roller_mass=m)), eliminate(bodies)
    unit = unit_condition(general.natural_frequency_squared)
    steps = (
        Step(
            "velocities",
            "Follow every body over the ground",
            "The floor is the inertial frame. The block moves to the left by $X$; what rolls on it adds "
            "$R\\times$ its angle, and the slab, lying on top of its rollers, adds that twice.",
            tuple(equation(f"v_{body.name}", body.velocity) for body in bodies.bodies),
        ),
        Step(
            "energies",
            "Add up the energies",
            "A rolling body has the energy of its centre and of its spin; the spring is deformed by the slab’s "
            "displacement over the block.",
            (
                *(equation(f"T_{body.name}", body.kinetic_energy) for body in bodies.bodies),
                equation("U", bodies.potential_energy),
            ),
        ),
        *_elimination_steps("equal_", equal, "with equal masses, $m'=m$"),
        Step(
            "equal_close",
            "Nearly one",
            "In units of $k/m$ the square of the frequency is close to 1, yet not 1. What would make it exact?",
            (equation(Omega_squared * m / k, equal.natural_frequency_squared * m / k),),
        ),
        *_elimination_steps("", general, "with rollers of their own mass $m'$"),
        Step(
            "ratio",
            "Only the ratio of the masses matters",
            "Measured in units of $k/m$, the frequency depends on $\\varepsilon=m'/m$ alone.",
            (
                equation(epsilon, m_prime / m),
                equation(Omega_squared * m / k, unit.normalized_frequency_squared),
            ),
        ),
        Step(
            "unit",
            "Ask for exactly one",
            "Setting the right side to 1 and clearing the fraction leaves a quadratic with integer coefficients.",
            (equation(unit.quadratic.as_expr(), sp.Integer(0)),),
        ),
        Step(
            "root",
            "The number of the taxicab",
            "Only one root is positive, as a mass ratio has to be; completing the square shows the number under "
            "its root.",
            (equation(epsilon, unit.root), unit.completed_square),
        ),
    )
    return Route("euler_lagrange", "Euler–Lagrange", steps, general.natural_frequency_squared)


def _elimination_steps(prefix: str, result: Elimination, which: str) -> tuple[Step, ...]:
    """Return the four steps from ℒ to Ω², the same for equal masses and for any."""
    return (
        Step(
            f"{prefix}lagrangian",
            "Write the Lagrangian",
            f"$\\mathcal{{L}}=T-U$, like terms gathered, {which}.",
            (equation("L", result.lagrangian),),
        ),
        Step(
            f"{prefix}motion",
            "Let the operator act",
            "$\\Lambda_q=\\frac{d}{dt}\\frac{\\partial}{\\partial\\dot q}-\\frac{\\partial}{\\partial q}$ gives "
            "one equation of motion for each coordinate; a common factor is dropped.",
            tuple(equation(result.motion[q], sp.Integer(0)) for q in COORDINATES),
        ),
        Step(
            f"{prefix}elimination",
            "Express the block and the top cylinder by the rollers",
            "Without $X$ and $\\Phi$ themselves in them, two of the equations tie the accelerations together.",
            (
                equation(Phi_ddot, result.Phi_from_X),
                equation(X_ddot, result.X_from_phi),
                equation(Phi_ddot, result.Phi_from_phi),
            ),
        ),
        Step(
            f"{prefix}frequency",
            "Read off the frequency",
            "Inserted into the equation of $\\varphi$, they leave one oscillator: "
            "$\\ddot\\varphi+\\Omega^2\\varphi=0$.",
            (
                equation(result.remaining, sp.Integer(0)),
                equation(Omega_squared, result.natural_frequency_squared),
            ),
        ),
    )


def _without_common_factor(expression: sp.Expr) -> sp.Expr:
    """Return the equation's left side divided by the symbols that all of its coefficients share."""
    gathered = gather(expression)
    common = sp.gcd_list([term.as_independent(*COORDINATES)[0] for term in gathered.args])
    return gather(sp.cancel(gathered / sp.Mul(*(f for f in sp.Mul.make_args(common) if f in (m, R)))))
