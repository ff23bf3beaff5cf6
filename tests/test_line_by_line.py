"""Nothing is left for the blackboard: each displayed equation follows from those before by what its step says.

`WALK` repeats the operation of each step by plain SymPy, on the equations that are displayed, and returns what must
vanish. A spoiled equation is noticed where it stands or in the next step that uses it.
"""

from collections.abc import Callable

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.matrix import omega
from ramanujan.derivation.rayleigh import eta, xi
from ramanujan.derivation.symbols import (
    ACCELERATIONS,
    COORDINATES,
    MOMENTA,
    VELOCITIES,
    M_e,
    M_x,
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

L, H_0, T, U, x = sp.symbols("L H_0 T U x")
(X_dot, phi_dot, Phi_dot), (X_ddot, phi_ddot, Phi_ddot) = VELOCITIES, ACCELERATIONS
p_phi = MOMENTA[1]
BODIES = {"block": m, "hoop": m_prime, "cylinder": m_prime, "slab": m, "top": m}
ANGLES = {"hoop": phi, "cylinder": phi, "top": Phi}
AT_REST = dict.fromkeys(VELOCITIES, 0)
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


def energies(at: Lines) -> list[sp.Expr]:
    by_bodies, collected, potential = (e.rhs for e in at("energies"))
    kinetic = sum(mass * VELOCITY[name] ** 2 for name, mass in BODIES.items())
    kinetic += sum(INERTIA[name] * angle.diff(t) ** 2 for name, angle in ANGLES.items())
    return [by_bodies - kinetic / 2, by_bodies - collected, potential - k * (2 * R * phi) ** 2 / 2]


# What the drawing says: rolling without slipping, all mass of a hoop at R, a disc as rings.
VELOCITY = {"block": -X_dot, "hoop": R * phi_dot - X_dot, "cylinder": R * phi_dot - X_dot, "top": R * Phi_dot - X_dot}
VELOCITY["slab"] = VELOCITY["hoop"] + R * phi_dot
r = sp.Symbol("r", positive=True)
DISC = sp.integrate(2 * r**3, (r, 0, R)) / R**2
INERTIA = {"hoop": m_prime * R**2, "cylinder": m_prime * DISC, "top": m * DISC}


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


def friction(at: Lines) -> list[sp.Expr]:
    own = [*at("forces")[1:3], *at("torques")]
    return [inserted(e, at("friction")) for e in own]


def three(at: Lines) -> list[sp.Expr]:
    forces = at("forces")
    spread = (at("friction"), at("accelerations"), at("rolling")[5:])
    return [inserted(forces[place], *spread) - difference(e) for place, e in zip((0, 3, 4), at("three"), strict=True)]


def newton_solution(at: Lines) -> list[sp.Expr]:
    (block, slab, top), (of_Phi, both, of_X, last) = at("three"), at("solution")
    return [
        difference(top).subs(Phi_ddot, of_Phi.rhs),
        difference(both) + difference(block) + difference(slab),
        difference(both).subs(Phi_ddot, of_Phi.rhs).subs(X_ddot, of_X.rhs),
        last.rhs - of_Phi.rhs.subs(X_ddot, of_X.rhs),
    ]


def newton_frequency(at: Lines) -> list[sp.Expr]:
    inserted_slab, solved, found = at("frequency")
    slab = difference(at("three")[1]).subs(X_ddot, known(at("solution"))[X_ddot])
    return [
        difference(inserted_slab) - slab,
        difference(inserted_slab).subs(phi_ddot, solved.rhs),
        found.rhs + solved.rhs / phi,
    ]


def inversion(at: Lines) -> list[sp.Expr]:
    of_Phi, second, of_X, third = at("inversion")
    P_X, P_phi, P_Phi = at("momenta")
    return [
        difference(P_Phi).subs(Phi_dot, of_Phi.rhs),
        difference(P_X).subs(Phi_dot, of_Phi.rhs) - difference(second),
        difference(second).subs(X_dot, of_X.rhs),
        difference(P_phi).subs(X_dot, of_X.rhs) - difference(third),
    ]


def reduction(at: Lines) -> list[sp.Expr]:
    square, mass, constant = at("reduction")
    return [square.rhs.subs({M_e: mass.rhs, H_0: constant.rhs}) - at("hamiltonian")[1].rhs, constant.rhs.diff(p_phi)]


def quotient(at: Lines) -> list[sp.Expr]:
    by_spring, by_mass = at("quotient")
    shares = {X_dot: xi * R * phi_dot, Phi_dot: eta * phi_dot}
    energy = known(at("energies"))
    return [difference(by_spring).subs(U, energy[U]), difference(by_mass).subs(T, energy[T]).subs(shares)]


def least(at: Lines) -> list[sp.Expr]:
    by_xi, by_eta, of_xi, of_eta, curvature = at("least")
    inertia, shares = at("quotient")[1].rhs, {xi: of_xi.rhs, eta: of_eta.rhs}
    return [
        difference(by_xi) - inertia.diff(xi),
        difference(by_eta) - inertia.diff(eta),
        *(difference(e).subs(shares) for e in (by_xi, by_eta)),
        difference(curvature),
        sp.hessian(inertia, (xi, eta)).det() - curvature.rhs,
    ]


def matrices(at: Lines) -> list[sp.Expr]:
    energy, (mass, stiffness) = known(at("energies")), at("matrices")
    q, q_dot = sp.Matrix(COORDINATES), sp.Matrix(VELOCITIES)
    return [(q_dot.T * mass.rhs * q_dot / 2)[0] - energy[T], (q.T * stiffness.rhs * q / 2)[0] - energy[U]]


def spectrum(at: Lines) -> list[sp.Expr]:
    roots, found = at("spectrum")
    polynomial = at("determinant")[1].lhs.subs(omega, sp.sqrt(Omega_squared))
    expected = sp.roots(polynomial, Omega_squared, multiple=True)
    return [*(a - b for a, b in zip(roots.rhs, expected, strict=True)), found.rhs - roots.rhs[-1]]


def shortcut(at: Lines) -> list[sp.Expr]:
    (mass, stiffness), (rank_one, inverse, found) = at("matrices"), at("shortcut")
    return [
        *(rank_one.rhs.as_explicit() - stiffness.rhs),
        *(mass.rhs * inverse.rhs - sp.eye(3)),
        found.rhs - stiffness.rhs[1, 1] * inverse.rhs[1, 1],
    ]


SLAB, BLOCK = (sp.Function(f"a_{name}")(t) for name in ("slab", "block"))


def rolling(at: Lines) -> list[sp.Expr]:
    """Where two bodies touch, their accelerations agree: at the top of a roller a + Rα, at its bottom a − Rα."""
    a, alpha = ({name: sp.Function(f"{letter}_{name}")(t) for name in ANGLES} for letter in ("a", "alpha"))
    touching = [a[n] + R * alpha[n] - SLAB for n in ("hoop", "cylinder")] + [
        a[n] - R * alpha[n] - BLOCK for n in ANGLES
    ]
    turning = [alpha[name] - angle.diff(t, 2) for name, angle in ANGLES.items()]
    return [difference(e) - expected for e, expected in zip(at("rolling"), touching + turning, strict=True)]


def newton_laws(at: Lines) -> list[sp.Expr]:
    """What a contact does to one body it does to the other with the opposite sign; so does the spring."""
    S, F = ({n: sp.Function(f"{letter}_{n}")(t) for n in ANGLES} for letter in "SF")
    S["top"] = 0
    spring = 2 * k * R * phi
    total = {
        "block": spring - sum(F.values()),
        **{n: S[n] + F[n] for n in ("hoop", "cylinder")},
        "slab": -spring - sum(S.values()),
        "top": F["top"],
    }
    return [
        *(
            difference(e) - BODIES[n] * sp.Function(f"a_{n}")(t) + total[n]
            for e, n in zip(at("forces"), total, strict=True)
        ),
        *(
            difference(e) - INERTIA[n] * sp.Function(f"alpha_{n}")(t) + R * (S[n] - F[n])
            for e, n in zip(at("torques"), ANGLES, strict=True)
        ),
    ]


def momenta(at: Lines) -> list[sp.Expr]:
    return [e.rhs - at("lagrangian")[0].rhs.diff(u) for e, u in zip(at("momenta"), VELOCITIES, strict=True)]


def the_sum(at: Lines) -> list[sp.Expr]:
    *kinetic, _spring, potential = (e.rhs for e in at("energies"))
    return [at("sum")[0].rhs - sum(kinetic).subs(known(at("velocities"), at("inertia"))) + potential]


def hamiltonian(at: Lines) -> list[sp.Expr]:
    (with_velocities, with_momenta), potential = at("hamiltonian"), -at("lagrangian")[0].rhs.subs(AT_REST)
    return [
        with_velocities.rhs - sum(p * u for p, u in zip(MOMENTA, VELOCITIES, strict=True)) / 2 - U,
        with_velocities.rhs.subs(known(at("velocities"))).subs(U, potential) - with_momenta.rhs,
    ]


def hamilton_motion(at: Lines) -> list[sp.Expr]:
    *rates, velocity = at("motion")
    function = at("hamiltonian")[1].rhs
    return [
        *(e.rhs + function.diff(q) for e, q in zip(rates, COORDINATES, strict=True)),
        velocity.rhs - function.diff(p_phi),
    ]


def hamilton_frequency(at: Lines) -> list[sp.Expr]:
    (reduced, mass, _), (motion, ratio, of_spring, found) = at("reduction"), at("frequency")
    return [
        motion.rhs + reduced.rhs.diff(phi),
        motion.lhs - phi_ddot / reduced.rhs.diff(p_phi, 2),
        ratio.rhs + motion.rhs / (M_e * R**2 * phi),
        of_spring.rhs - mass.rhs / 4,
        found.rhs - ratio.rhs.subs(M_e, mass.rhs),
    ]


def accelerations(at: Lines) -> list[sp.Expr]:
    found = at("accelerations")
    return [found[0].rhs + X_ddot, *(inserted(e, found, at("rolling")[5:]) for e in at("rolling"))]


def contact(at: Lines) -> list[sp.Expr]:
    forces, solved = known(at("friction")), at("solution")
    spread = (at("accelerations"), at("rolling")[5:], [solved[2], solved[3]])
    return [inserted(sp.Eq(e.rhs, forces[e.lhs], evaluate=False), *spread) for e in at("contact")]


def energy_frequency(at: Lines) -> list[sp.Expr]:
    (by_spring, by_mass), (mass, ratio, found) = at("quotient"), at("frequency")
    return [
        mass.rhs - by_mass.rhs.subs(known(at("least")[2:4])),
        ratio.rhs - by_spring.rhs / M_e,
        found.rhs - ratio.rhs.subs(M_e, mass.rhs),
    ]


def spring_mass(at: Lines) -> list[sp.Expr]:
    (mass, ratio, _), (of_spring, found) = at("frequency"), at("spring_mass")
    return [of_spring.rhs - mass.rhs / 4, found.rhs - ratio.rhs.subs(M_e, 4 * M_x)]


def bound(at: Lines) -> list[sp.Expr]:
    (by_spring, by_mass), (more, clamped) = at("quotient"), at("bound")
    held = by_mass.rhs.subs({xi: 0, eta: 0})
    return [more.rhs - held + at("frequency")[0].rhs, clamped.rhs - by_spring.rhs / held]


def matrix_motion(at: Lines) -> list[sp.Expr]:
    mass, stiffness = (e.rhs for e in at("matrices"))
    return list(difference(at("motion")[0]) - mass * sp.Matrix(ACCELERATIONS) - stiffness * sp.Matrix(COORDINATES))


def determinant(at: Lines) -> list[sp.Expr]:
    mass, stiffness = (e.rhs for e in at("matrices"))
    return [difference(e) - (stiffness - omega**2 * mass).det() for e in at("determinant")]


def zero_modes(at: Lines) -> list[sp.Expr]:
    found = []
    for relation, q in zip(at("zero_modes"), (0, 2), strict=True):
        stiffness, mode = relation.lhs.args
        found += [*(stiffness - at("matrices")[1].rhs), *(mode - sp.eye(3)[:, q]), *difference(relation)]
    return found


def mode_shape(at: Lines) -> list[sp.Expr]:
    inverse = at("shortcut")[1].rhs
    return list(at("mode_shape")[0].rhs - inverse[:, 1] / inverse[1, 1])


def equal_close(at: Lines) -> list[sp.Expr]:
    return [inserted(at("equal_close")[0], at("equal_frequency"))]


def newton_forces(at: Lines) -> list[sp.Expr]:
    return newton_laws(at)[:5]


def newton_torques(at: Lines) -> list[sp.Expr]:
    return newton_laws(at)[5:]


def same_lagrangian(at: Lines) -> list[sp.Expr]:
    return [at("lagrangian")[0].rhs - ROUTES["euler_lagrange"]["sum"].equations[0].rhs]


def solved_velocities(at: Lines) -> list[sp.Expr]:
    return [inserted(at("inversion")[place], at("velocities")) for place in (0, 2, 3)]


def velocities(at: Lines) -> list[sp.Expr]:
    return [e.rhs - VELOCITY[e.lhs.name[2:]] for e in at("velocities")]


def moments_of_inertia(at: Lines) -> list[sp.Expr]:
    *of_bodies, compression = at("inertia")
    return [*(e.rhs - INERTIA[e.lhs.name[2:]] for e in of_bodies), compression.rhs - 2 * R * phi]


def steps(name: str, *in_order: Callable[[Lines], list[sp.Expr]]) -> dict[str, Callable[[Lines], list[sp.Expr]]]:
    return dict(zip((step.key for step in ROUTES[name].steps), in_order, strict=True))


BEGINNING = (velocities, moments_of_inertia, lagrangian_energies, the_sum)
WALK = {
    "euler_lagrange": steps(
        "euler_lagrange",
        *BEGINNING,
        *elimination_steps("equal_"),
        equal_close,
        *elimination_steps(""),
        ratio,
        unit,
        root,
    ),
    "hamilton": steps(
        "hamilton",
        *(same_lagrangian, momenta, inversion, solved_velocities),
        *(hamiltonian, hamilton_motion, reduction, hamilton_frequency),
    ),
    "newton": steps(
        "newton",
        *(rolling, newton_forces, newton_torques, accelerations, friction),
        *(three, newton_solution, contact, newton_frequency),
    ),
    "energy": steps("energy", energies, quotient, least, energy_frequency, spring_mass, bound),
    "matrix": steps(
        "matrix", energies, matrices, matrix_motion, determinant, spectrum, zero_modes, shortcut, mode_shape
    ),
}


def lines(name: str, key: str = "", place: int = 0) -> Lines:
    """Return what gives the equations of a route's step as they are displayed; that of a place is spoiled."""
    return lambda step: [
        spoiled(e) if (step, n) == (key, place) else e for n, e in enumerate(ROUTES[name][step].equations)
    ]


STEPS = [(name, step.key) for name in ROUTES for step in ROUTES[name].steps]


@pytest.mark.parametrize(("name", "key"), STEPS)
def test_each_equation_follows_and_a_spoiled_one_does_not(name, key):
    assert all(map(is_zero, WALK[name][key](lines(name))))
    for place in range(len(ROUTES[name][key].equations)):
        residuals = WALK[name][key](lines(name, key, place))
        assert not all(map(is_zero, residuals)), place
