"""Two references for tests: the machine by SymPy's mechanics package, and the paper's results for any kind of number.

The first shares only the symbols with the derivations, and derives velocities from frames and points. The second is
written down here, and shares nothing with the package.
"""

import random
from functools import cache
from typing import TypeVar

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, inertia

from ramanujan.derivation.model import ACCELERATIONS, COORDINATES, VELOCITIES, R, k, m, m_prime, phi, t

Number = TypeVar("Number")
"""A float, a fraction or a number of mpmath."""


@cache
def mass_and_stiffness() -> tuple[sp.Matrix, sp.Matrix]:
    """Return M and K of M q̈ + K q = 0 by Kane's method, for q = (X, φ, Φ)."""
    ground = ReferenceFrame("N")
    origin = Point("O")
    origin.set_vel(ground, 0)
    u = [speed(t) for speed in sp.symbols("u1:4", cls=sp.Function)]

    def body(name: str, mass: sp.Expr, velocity: sp.Expr, moment: sp.Expr, spin: sp.Expr) -> RigidBody:
        frame, centre = ReferenceFrame(name), Point(name)
        frame.orient_axis(ground, ground.z, 0)
        # y points up, so a clockwise turn is negative about z.
        frame.set_ang_vel(ground, -spin * ground.z)
        centre.set_vel(ground, velocity * ground.x)
        return RigidBody(name, centre, frame, mass, (inertia(frame, 0, 0, moment), centre))

    disc = sp.Rational(1, 2)
    bodies = [
        body("A", m, -u[0], sp.S.Zero, sp.S.Zero),
        body("B", m_prime, -u[0] + R * u[1], m_prime * R**2, u[1]),
        body("C", m_prime, -u[0] + R * u[1], disc * m_prime * R**2, u[1]),
        body("D", m, -u[0] + 2 * R * u[1], sp.S.Zero, sp.S.Zero),
        body("E", m, -u[0] + R * u[2], disc * m * R**2, u[2]),
    ]
    push = 2 * k * R * phi * ground.x
    forces = [(bodies[0].masscenter, push), (bodies[3].masscenter, -push)]
    kane = KanesMethod(
        ground,
        q_ind=list(COORDINATES),
        u_ind=u,
        kd_eqs=[v - w for v, w in zip(VELOCITIES, u, strict=True)],
    )
    kane.kanes_equations(bodies, forces)
    return sp.expand(kane.mass_matrix), sp.expand(-kane.forcing.jacobian(list(COORDINATES)))


@cache
def accelerations() -> dict[sp.Expr, sp.Expr]:
    """Return q̈ as a function of q along the motion."""
    mass, stiffness = mass_and_stiffness()
    solved = -(mass.inv() * stiffness * sp.Matrix(COORDINATES))
    return {a: sp.factor(value) for a, value in zip(ACCELERATIONS, solved, strict=True)}


@cache
def natural_frequency_squared() -> sp.Expr:
    """Return Ω² as the trace of M⁻¹K: the other two eigenvalues are zero."""
    mass, stiffness = mass_and_stiffness()
    return sp.factor((mass.inv() * stiffness).trace())


@cache
def lagrangian() -> sp.Expr:
    """Return ½ q̇ᵀMq̇ − ½ qᵀKq."""
    mass, stiffness = mass_and_stiffness()
    q, v = sp.Matrix(COORDINATES), sp.Matrix(VELOCITIES)
    return (v.T * mass * v / 2 - q.T * stiffness * q / 2)[0]


def matrices(m: Number, m_prime: Number, k: Number, radius: Number, top: Number = 0.5) -> tuple[list, list]:
    """Return M and K of the Lagrangian for q = (X, φ, Φ), with a top body of shape factor `top`."""
    mass = [
        [3 * m + 2 * m_prime, -2 * (m + m_prime) * radius, -m * radius],
        [-2 * (m + m_prime) * radius, (8 * m + 7 * m_prime) * radius**2 / 2, 0],
        [-m * radius, 0, (1 + top) * m * radius**2],
    ]
    return mass, [[0, 0, 0], [0, 4 * k * radius**2, 0], [0, 0, 0]]


def frequency_squared(m: Number, m_prime: Number, k: Number) -> Number:
    """Return Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²). With m = k = 1 and m′ = ε, it is Ω²m/k."""
    return 8 * k * (7 * m + 6 * m_prime) / (32 * m**2 + 49 * m * m_prime + 18 * m_prime**2)


def at_random_point(expression: sp.Expr, seed: int = 0) -> sp.Expr:
    """Return the expression with a random positive fraction for every symbol, function and derivative in it.

    The same unknown gets the same fraction in every expression, so equal expressions give equal numbers.
    """
    unknowns = expression.atoms(sp.Derivative) | expression.atoms(AppliedUndef)
    inner = expression.xreplace({u: fraction(u, seed) for u in unknowns})
    return inner.xreplace({s: fraction(s, seed) for s in inner.free_symbols})


def equal(left: sp.Expr, right: sp.Expr) -> bool:
    """Return whether two rational expressions agree exactly at three random points."""
    return all(sp.radsimp(at_random_point(left, seed) - at_random_point(right, seed)) == 0 for seed in range(3))


def fraction(unknown: sp.Basic, seed: int = 0) -> sp.Rational:
    """Return a random positive fraction, the same for the same unknown."""
    source = random.Random(f"{unknown}/{seed}")
    return sp.Rational(source.randint(1, 97), source.randint(1, 97))


def difference(relation: sp.Eq) -> sp.Expr:
    """Return the left side of an equation minus its right side, with derivatives evaluated."""
    left, right = (side.as_explicit() if isinstance(side, sp.MatrixExpr) else side.doit() for side in relation.args)
    return left - right


def spoiled(relation: sp.Eq) -> sp.Eq:
    """Return an equation with an extra term on its right side, in each of its entries."""
    right = relation.rhs
    if isinstance(right, sp.Tuple):
        wrong = sp.Tuple(*(entry + R for entry in right))
    elif hasattr(right, "shape"):
        wrong = right + R * sp.ones(*right.shape)
    else:
        wrong = right + R
    return sp.Eq(relation.lhs, wrong, evaluate=False)


def is_zero(expression: sp.Expr) -> bool:
    """Return whether an expression is zero at two random points."""
    return all(sp.radsimp(at_random_point(sp.sympify(expression), seed)) == 0 for seed in range(2))
