"""The paper’s equations, as printed, compared with the steps in .github/paper.md."""

import re
from pathlib import Path

import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import (
    ACCELERATIONS,
    VELOCITIES,
    Omega_squared,
    R,
    epsilon,
    k,
    m,
    m_prime,
    phi,
)
from tests.reference import difference, is_zero, spoiled

(X_dot, phi_dot, Phi_dot), (X_ddot, phi_ddot, Phi_ddot) = VELOCITIES, ACCELERATIONS

HALF = sp.Rational(1, 2)
DIRECT = 7 * m_prime + 8 * m - 8 * (m_prime + m) ** 2 / (7 * m / 3 + 2 * m_prime)
PAPER = {
    "1": sp.Eq(
        sp.Symbol("L"),
        HALF * m * X_dot**2
        + m_prime * (R * phi_dot - X_dot) ** 2
        + HALF * (m_prime * R**2 + HALF * m_prime * R**2) * phi_dot**2
        + HALF * m * (2 * R * phi_dot - X_dot) ** 2
        + HALF * m * (R * Phi_dot - X_dot) ** 2
        + HALF * HALF * m * R**2 * Phi_dot**2
        - HALF * k * (2 * R * phi) ** 2,
    ),
    "2": sp.Eq(
        sp.Symbol("L"),
        sp.Rational(5, 2) * m * X_dot**2
        + sp.Rational(3, 4) * m * R**2 * Phi_dot**2
        + sp.Rational(15, 4) * m * R**2 * phi_dot**2
        - m * R * X_dot * Phi_dot
        - 4 * m * R * phi_dot * X_dot
        - 2 * k * R**2 * phi**2,
    ),
    "4a": sp.Eq(5 * X_ddot - R * Phi_ddot - 4 * R * phi_ddot, 0),
    "4b": sp.Eq(3 * HALF * R * Phi_ddot - X_ddot, 0),
    "4c": sp.Eq(15 * HALF * m * R * phi_ddot - 4 * m * X_ddot + 4 * k * R * phi, 0),
    "5": sp.Eq(phi_ddot + Omega_squared * phi, 0),
    "6": sp.Eq(sp.Add(15 * HALF * X_ddot, -X_ddot, evaluate=False), 6 * R * phi_ddot, evaluate=False),
    "7": sp.Eq(phi_ddot + 104 * k / (99 * m) * phi, 0),
    "8": sp.Eq(Omega_squared, 104 * k / (99 * m)),
    "9": sp.Eq(
        sp.Symbol("L"),
        (3 * m + 2 * m_prime) / 2 * X_dot**2
        + sp.Rational(3, 4) * m * R**2 * Phi_dot**2
        + (sp.Rational(7, 4) * m_prime + 2 * m) * R**2 * phi_dot**2
        - m * R * X_dot * Phi_dot
        - 2 * (m_prime + m) * R * phi_dot * X_dot
        - 2 * k * R**2 * phi**2,
    ),
    "10a": sp.Eq((3 * m + 2 * m_prime) * X_ddot - m * R * Phi_ddot - 2 * (m + m_prime) * R * phi_ddot, 0),
    "10b": sp.Eq(3 * HALF * R * Phi_ddot - X_ddot, 0),
    "10c": sp.Eq((7 * HALF * m_prime + 4 * m) * R * phi_ddot - 2 * (m + m_prime) * X_ddot + 4 * k * R * phi, 0),
    "11a": sp.Eq(X_ddot, 2 * (m_prime + m) / (2 * m_prime + 2 * m + m / 3) * R * phi_ddot),
    "11b": sp.Eq(Phi_ddot, 4 * (m_prime + m) / (6 * m_prime + 7 * m) * phi_ddot),
    "12": sp.Eq(phi_ddot + 8 * k / DIRECT * phi, 0),
    "13": sp.Eq(sp.cancel((DIRECT - 8 * m).subs(m_prime, epsilon * m) / m), 0),
    "14": sp.Eq(epsilon, (sp.sqrt(1729) - 1) / 36),
    "15": sp.Eq((36 * epsilon + 1) ** 2, 1729),
}  # fmt: skip
"""Number → equation, with R, m and the motion as symbols, and Λ_qℒ written out."""

PLACES = (Path(__file__).parent.parent / ".github" / "paper.md").read_text(encoding="utf-8")
TABLE = re.findall(r"^\| \(([\w, ]+)\) \| (any|equal) \| (\d+) \| (.*) \| `(\w+)` \|$", PLACES, re.MULTILINE)


def test_every_equation_of_the_paper_is_in_the_step_that_its_list_names():
    steps = {number: step for numbers, *step in TABLE for number in numbers.split(", ")}
    assert steps.keys() == PAPER.keys()
    for place, printed in PAPER.items():
        masses, order, heading, key = steps[place]
        route = ROUTES.with_equal_masses("euler_lagrange") if masses == "equal" else ROUTES["euler_lagrange"]
        step = route.steps[int(order) - 1]
        assert (step.heading, step.key) == (heading, key)
        assert any(says(relation, printed) for relation in step.equations), place
        assert not any(says(relation, spoiled(printed)) for relation in step.equations), place


def says(relation: sp.Eq, printed: sp.Eq) -> bool:
    """Return whether two equations differ only by a factor, and the first has at least as many terms."""
    if printed.lhs.is_Symbol or printed.lhs.is_Derivative:
        return relation.lhs == printed.lhs and is_zero(relation.rhs - printed.rhs)
    if not relation.has(*(ACCELERATIONS if printed.has(sp.Derivative) else [epsilon])):
        return False
    ratio = sp.cancel(difference(relation) / difference(printed))
    like = len(sp.Add.make_args(relation.lhs)) >= len(sp.Add.make_args(printed.lhs))
    return like and ratio != 0 and not ratio.has(sp.Derivative, phi, epsilon)
