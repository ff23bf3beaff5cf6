"""Nothing is left for the blackboard: in the paper's route each equation follows from those before by what is said.

`WALK` repeats the operation of each step by plain SymPy, on the equations that are displayed, and returns what must
vanish. A spoiled equation is noticed where it stands or in the next step that uses it. That the equations of all routes
are true is for test_my_numbers.
"""

from collections.abc import Callable

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.symbols import (
    ACCELERATIONS,
    COORDINATES,
    MOMENTA,
    VELOCITIES,
    Omega_squared,
    Phi,
    R,
    epsilon,
    k,
    m,
    m_prime,
    phi,
    t,
)
from tests.reference import difference, is_zero, spoiled

x = sp.Symbol("x")
(X_dot, phi_dot, Phi_dot), (X_ddot, phi_ddot, Phi_ddot) = VELOCITIES, ACCELERATIONS
BODIES = {"block": m, "hoop": m_prime, "cylinder": m_prime, "slab": m, "top": m}
ANGLES = {"hoop": phi, "cylinder": phi, "top": Phi}
Lines = Callable[[str], list[sp.Eq]]


def known(*groups: list[sp.Eq]) -> dict[sp.Basic, sp.Basic]:
    """Return left sides and right sides, to be inserted."""
    return {relation.lhs: relation.rhs for group in groups for relation in group}


def inserted(relation: sp.Eq, *groups: list[sp.Eq]) -> sp.Expr:
    """Return left minus right with what the groups of equations say inserted, again and again."""
    result = difference(relation)
    for _ in range(3):
        result = result.subs(known(*groups))
    return result


def same_zero(one: sp.Eq, other: sp.Eq) -> sp.Expr:
    """Return what vanishes if two equations differ by a factor without the motion."""
    ratio = sp.cancel(difference(one) / difference(other))
    return ratio.diff(X_ddot) + ratio.diff(phi_ddot) + ratio.diff(Phi_ddot) + ratio.diff(phi)


# What the drawing says: rolling without slipping, all mass of a hoop at R, a disc as rings.
VELOCITY = {"block": -X_dot, "hoop": R * phi_dot - X_dot, "cylinder": R * phi_dot - X_dot, "top": R * Phi_dot - X_dot}
VELOCITY["slab"] = VELOCITY["hoop"] + R * phi_dot
r = sp.Symbol("r", positive=True)
DISC = sp.integrate(2 * r**3, (r, 0, R)) / R**2
INERTIA = {"hoop": m_prime * R**2, "cylinder": m_prime * DISC, "top": m * DISC}


def momenta(at: Lines) -> list[sp.Expr]:
    return [e.rhs - at("lagrangian")[0].rhs.diff(u) for e, u in zip(at("momenta"), VELOCITIES, strict=True)]


def elimination_steps(prefix: str) -> list[Callable[[Lines], list[sp.Expr]]]:
    def collected(at: Lines) -> list[sp.Expr]:
        by_bodies = ROUTES["euler_lagrange"]["sum"].equations[0].rhs
        return [at("lagrangian")[0].rhs - by_bodies.subs({m_prime: m} if prefix else {})]

    def rates(at: Lines) -> list[sp.Expr]:
        (lagrangian,), of = at("lagrangian"), known(at("momenta"))
        found = zip(at("rates"), MOMENTA, COORDINATES, strict=True)
        return [part for e, p, q in found for part in (e.lhs - of[p].diff(t), e.rhs - lagrangian.rhs.diff(q))]

    def motion(at: Lines) -> list[sp.Expr]:
        return [same_zero(one, other) for one, other in zip(at("motion"), at("rates"), strict=True)]

    def eliminated(at: Lines) -> list[sp.Expr]:
        of_X, _, of_Phi = at("motion")
        first, multiplied, replaced, of_block, of_top = at("elimination")
        (turning,) = sp.solve(first, Phi_ddot)
        return [
            same_zero(first, of_Phi),
            same_zero(multiplied, of_X),
            replaced.rhs - multiplied.rhs,
            replaced.lhs - multiplied.lhs.subs(Phi_ddot, turning),
            of_block.rhs - sp.solve(replaced, X_ddot)[0],
            of_top.rhs - turning.subs(X_ddot, of_block.rhs),
        ]

    def insertion(at: Lines) -> list[sp.Expr]:
        with_block, *divided = at("insertion")
        return [
            difference(with_block) - difference(at("motion")[1]).subs(known(at("elimination"))),
            *(same_zero(e, with_block) for e in divided),
            *(difference(e).diff(phi_ddot) - 1 for e in divided),
        ]

    def frequency(at: Lines) -> list[sp.Expr]:
        oscillator, found = at("frequency")
        turned = difference(oscillator).subs(phi, sp.cos(sp.sqrt(Omega_squared) * t)).doit()
        return [turned, found.rhs - difference(at("insertion")[-1]).diff(phi)]

    operations = (collected, momenta, rates, motion, eliminated, insertion, frequency)
    return [lambda at, do=do: do(lambda name: at(f"{prefix}{name}")) for do in operations]


def lagrangian_energies(at: Lines) -> list[sp.Expr]:
    *kinetic, spring, potential = at("energies")
    of_body = [
        mass * sp.Symbol(f"v_{name}") ** 2 / 2
        + (sp.Symbol(f"I_{name}") * ANGLES[name].diff(t) ** 2 / 2 if name in ANGLES else 0)
        for name, mass in BODIES.items()
    ]
    return [
        *(e.rhs - energy for e, energy in zip(kinetic, of_body, strict=True)),
        spring.rhs - k * x**2 / 2,
        potential.rhs - spring.rhs.subs(known(at("inertia"))),
    ]


def unit(at: Lines) -> list[sp.Expr]:
    (_, in_parts, _), (to_one, cancelled, multiplied, quadratic) = at("ratio"), at("unit")
    plain = sp.Eq(in_parts.lhs.subs(Omega_squared, k / m), in_parts.rhs, evaluate=False)
    return [
        to_one.rhs / to_one.lhs.doit() - plain.rhs / plain.lhs,
        difference(cancelled) - difference(to_one),
        sp.diff(sp.cancel(difference(multiplied) / (difference(cancelled) * (6 * epsilon + 7))), epsilon),
        difference(quadratic) - difference(multiplied),
        cancelled.rhs,
    ]


def root(at: Lines) -> list[sp.Expr]:
    (square, value), condition = at("root"), at("unit")[-1]
    return [
        sp.diff(sp.cancel(difference(square) / difference(condition)), epsilon),
        difference(square).subs(epsilon, value.rhs),
        sp.Integer(0 if value.rhs.is_positive else 1),
    ]


def ratio(at: Lines) -> list[sp.Expr]:
    definition, in_parts, together = at("ratio")
    denominator = at("insertion")[1].lhs.diff(phi)
    return [
        definition.rhs - m_prime / m,
        (in_parts.rhs.subs(epsilon, definition.rhs) - denominator * m / k),
        in_parts.rhs - together.rhs,
    ]


def the_sum(at: Lines) -> list[sp.Expr]:
    *kinetic, _spring, potential = (e.rhs for e in at("energies"))
    return [at("sum")[0].rhs - sum(kinetic).subs(known(at("velocities"), at("inertia"))) + potential]


def equal_close(at: Lines) -> list[sp.Expr]:
    return [inserted(at("equal_close")[0], at("equal_frequency"))]


def velocities(at: Lines) -> list[sp.Expr]:
    return [e.rhs - VELOCITY[e.lhs.name[2:]] for e in at("velocities")]


def moments_of_inertia(at: Lines) -> list[sp.Expr]:
    *of_bodies, compression = at("inertia")
    return [*(e.rhs - INERTIA[e.lhs.name[2:]] for e in of_bodies), compression.rhs - 2 * R * phi]


WALK = dict(
    zip(
        (step.key for step in ROUTES["euler_lagrange"].steps),
        (
            *(velocities, moments_of_inertia, lagrangian_energies, the_sum),
            *elimination_steps("equal_"),
            equal_close,
            *elimination_steps(""),
            *(ratio, unit, root),
        ),
        strict=True,
    )
)


def lines(key: str = "", place: int = 0) -> Lines:
    """Return what gives the equations of a step as they are displayed; that of a place is spoiled."""
    route = ROUTES["euler_lagrange"]
    return lambda step: [spoiled(e) if (step, n) == (key, place) else e for n, e in enumerate(route[step].equations)]


@pytest.mark.parametrize("key", WALK)
def test_each_equation_follows_and_a_spoiled_one_does_not(key):
    assert all(map(is_zero, WALK[key](lines())))
    for place in range(len(ROUTES["euler_lagrange"][key].equations)):
        assert not all(map(is_zero, WALK[key](lines(key, place)))), place
