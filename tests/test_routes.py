"""Five routes, one Ω²: each step of the four other routes against an independent machine (tests/reference.py)."""

from __future__ import annotations

from itertools import product

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.derivation import ROUTES, newton
from ramanujan.derivation.elimination import eliminate
from ramanujan.derivation.hamilton import H_0, legendre_transform, reduce_to_one_degree
from ramanujan.derivation.matrix import Lambda, modes
from ramanujan.derivation.rayleigh import eta, least_inertia, spin_of_lower_rollers, xi
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
    X,
    k,
    m,
    m_prime,
    machine,
    phi,
    t,
)
from tests import reference
from tests.reference import equal, holds

MASS, STIFFNESS = reference.mass_and_stiffness()
MOMENTA_ON_MOTION = dict(zip(MOMENTA, MASS * sp.Matrix(VELOCITIES), strict=True))
LEAST = least_inertia(machine())
OTHER_BODIES = {
    "top that does not resist turning": {"top": 0},
    "two hoops": {"hoop": 1, "cylinder": 1},
    "sphere on top": {"top": sp.Rational(2, 5)},
    "shell, sphere, hoop": {"hoop": sp.Rational(2, 3), "cylinder": sp.Rational(2, 5), "top": 1},
}


def right_sides(name: str, key: str) -> dict[sp.Basic, sp.Basic]:
    return {relation.lhs: relation.rhs for relation in ROUTES[name][key].equations}


# All of them


def test_the_routes_in_the_order_of_a_course():
    assert list(ROUTES) == ["euler_lagrange", "hamilton", "newton", "energy", "matrix"]


@pytest.mark.parametrize("name", ROUTES)
def test_every_route_ends_in_the_very_same_expression(name):
    assert ROUTES[name].natural_frequency_squared == ROUTES["euler_lagrange"].natural_frequency_squared
    assert equal(ROUTES[name].natural_frequency_squared, reference.natural_frequency_squared())
    assert any(
        relation == sp.Eq(Omega_squared, ROUTES[name].natural_frequency_squared, evaluate=False)
        for step in ROUTES[name].steps
        for relation in step.equations
    )


def test_the_expression_is_that_of_the_floating_point_machine():
    value = ROUTES["matrix"].natural_frequency_squared.subs({m: 3, m_prime: sp.Rational(1, 4), k: 7})
    assert float(value) == pytest.approx(Oscillator(3, 0.25, 7).natural_frequency_squared, rel=1e-15)


@pytest.mark.parametrize("bodies", OTHER_BODIES.values(), ids=OTHER_BODIES)
def test_the_routes_agree_for_other_bodies_too(bodies):
    other = machine(**bodies)
    expected = eliminate(other).natural_frequency_squared
    assert expected != ROUTES["matrix"].natural_frequency_squared
    by_hamilton = 4 * k / reduce_to_one_degree(legendre_transform(other).hamiltonian).effective_mass
    by_newton = -newton.free_bodies(other).solution[newton.angular_acceleration("hoop")] / phi
    by_energy = 4 * k / least_inertia(other).least
    for found in (by_hamilton, by_newton, by_energy, modes(other).natural_frequency_squared):
        assert equal(found, expected)


# Hamilton


def test_momenta_are_mass_matrix_times_velocities():
    assert all(equal(value, MOMENTA_ON_MOTION[p]) for p, value in right_sides("hamilton", "momenta").items())


def test_velocities_invert_the_momenta():
    for velocity, value in right_sides("hamilton", "velocities").items():
        assert equal(value.subs(MOMENTA_ON_MOTION), velocity)


def test_hamiltonian_is_the_legendre_transform():
    (hamiltonian,) = right_sides("hamilton", "hamiltonian").values()
    definition = sum(p * v for p, v in zip(MOMENTA, VELOCITIES, strict=True)) - reference.lagrangian()
    velocities = right_sides("hamilton", "velocities")
    assert equal(hamiltonian, definition.subs(velocities))
    assert not equal(hamiltonian, definition.subs(velocities) + 4 * k * R**2 * phi**2)


def test_hamiltons_equations_hold_along_the_motion():
    definitions = {p.diff(t): value.diff(t) for p, value in MOMENTA_ON_MOTION.items()} | MOMENTA_ON_MOTION
    relations = ROUTES["hamilton"]["motion"].equations
    assert all(holds(relation, definitions) for relation in relations)
    (hamiltonian,) = right_sides("hamilton", "hamiltonian").values()
    for p, q in zip(MOMENTA, COORDINATES, strict=True):
        assert equal(hamiltonian.diff(p).subs(MOMENTA_ON_MOTION), q.diff(t))


def test_two_momenta_are_conserved_and_the_third_is_not():
    conserved = [lhs for lhs, value in right_sides("hamilton", "motion").items() if value == 0]
    assert conserved == [MOMENTA[0].diff(t), MOMENTA[2].diff(t)]


def test_the_completed_square_is_the_same_hamiltonian():
    reduced = right_sides("hamilton", "reduction")
    (hamiltonian,) = right_sides("hamilton", "hamiltonian").values()
    (one_degree,) = (value for symbol, value in reduced.items() if symbol not in (M_e, H_0))
    assert equal(one_degree.subs({M_e: reduced[M_e], H_0: reduced[H_0]}), hamiltonian)
    assert not reduced[H_0].has(phi, MOMENTA[1])
    shift = sp.sqrt(one_degree.subs({H_0: 0, MOMENTA[1]: 0, phi: 0}) * 2 * M_e * R**2)
    printed = 2 * (m + m_prime) * (3 * R * MOMENTA[0] + 2 * MOMENTA[2]) / (7 * m + 6 * m_prime)
    assert equal(shift**2, printed**2)


def test_hamilton_ends_in_the_frequency():
    relations = ROUTES["hamilton"]["frequency"].equations
    effective = 4 * k / reference.natural_frequency_squared()
    definitions = {
        M_e: effective,
        M_x: effective / 4,
        Omega_squared: reference.natural_frequency_squared(),
    }
    assert all(holds(relation, definitions) for relation in relations)


# Newton


@pytest.fixture(scope="module")
def unknowns():
    """What the thirteen unknowns are along the motion: forces from each roller's own two balances."""
    X_ddot, phi_ddot, Phi_ddot = ACCELERATIONS
    centres = {
        "block": -X_ddot,
        "hoop": R * phi_ddot - X_ddot,
        "cylinder": R * phi_ddot - X_ddot,
        "slab": 2 * R * phi_ddot - X_ddot,
        "top": R * Phi_ddot - X_ddot,
    }
    spins = {"hoop": phi_ddot, "cylinder": phi_ddot, "top": Phi_ddot}
    # A roller needs one force for its centre (the sum of its contacts) and one for its spin (their difference).
    masses = {"hoop": m_prime, "cylinder": m_prime, "top": m}
    half = sp.Rational(1, 2)
    needs = {name: masses[name] * centres[name] for name in spins}
    turns = {"hoop": m_prime * R * phi_ddot, "cylinder": half * m_prime * R * phi_ddot, "top": half * m * R * Phi_ddot}
    forces = {"F_top": -turns["top"]}
    for name in ("hoop", "cylinder"):
        forces[f"S_{name}"] = (needs[name] + turns[name]) / 2
        forces[f"F_{name}"] = (needs[name] - turns[name]) / 2
    return (
        {newton.acceleration(name): value for name, value in centres.items()}
        | {newton.angular_acceleration(name): value for name, value in spins.items()}
        | {sp.Function(name)(t): value for name, value in forces.items()}
    )


def test_thirteen_equations_for_thirteen_unknowns(unknowns):
    cut = newton.free_bodies(machine())
    assert (len(cut.forces), len(cut.torques), len(cut.rolling)) == (5, 3, 5)
    assert set(cut.solution) == set(unknowns)
    assert len(unknowns) == 13
    coefficients, _ = sp.linear_eq_to_matrix(cut.equations, list(unknowns))
    assert coefficients.subs({m: 2, m_prime: 3, R: 5}).rank() == 13


@pytest.mark.parametrize("key", ["forces", "torques", "rolling", "solution", "contact", "frequency"])
def test_newtons_equations_hold_along_the_motion(key, unknowns):
    definitions = unknowns | {Omega_squared: reference.natural_frequency_squared()}
    for relation in ROUTES["newton"][key].equations:
        assert holds(relation, definitions)


def test_rolling_is_an_identity_of_the_coordinates(unknowns):
    for relation in ROUTES["newton"]["rolling"].equations:
        assert sp.expand((relation.lhs - relation.rhs).subs(unknowns)) == 0


def test_internal_forces_cancel():
    relations = ROUTES["newton"]["forces"].equations
    assert sp.expand(sum(relation.rhs for relation in relations)) == 0
    assert sp.expand(sum(relation.rhs for relation in relations[1:])) != 0


def test_contact_forces_are_the_shares_of_the_acceleration():
    kappa = 6 * (m + m_prime) / (7 * m + 6 * m_prime)
    a = R * phi.diff(t, 2)
    expected = {"top_block": -kappa * m * a / 3}
    for name, beta in (("hoop", 1), ("cylinder", sp.Rational(1, 2))):
        expected[f"{name}_slab"] = m_prime * a * (1 + beta - kappa) / 2
        expected[f"{name}_block"] = m_prime * a * (1 - beta - kappa) / 2
    forces = newton.contact_forces()
    assert forces.keys() == expected.keys()
    assert all(equal(forces[name], expected[name]) for name in expected)


def test_equal_rollers_share_the_contact_forces_equally():
    forces = newton.contact_forces(machine(hoop=1, cylinder=1))
    assert forces["hoop_slab"] == forces["cylinder_slab"]
    assert forces["hoop_block"] == forces["cylinder_block"]
    ours = newton.contact_forces()
    assert ours["hoop_slab"] != ours["cylinder_slab"]


# Energy


def test_energies_are_the_quadratic_forms():
    for name, key in product(("energy", "matrix"), ("energies",)):
        energy = right_sides(name, key)
        assert equal(energy[sp.Symbol("T")] - energy[sp.Symbol("U")], reference.lagrangian())


def test_the_quotient_is_twice_the_energy_over_the_squared_path():
    v = sp.Matrix([xi * R, 1, eta])
    by_spring, by_mass = ROUTES["energy"]["quotient"].equations
    assert equal(by_spring.rhs, (v.T * STIFFNESS * v)[0] / R**2)
    assert equal(by_mass.rhs, (v.T * MASS * v)[0] / R**2)


def test_least_inertia_is_the_schur_complement():
    others = [0, 2]
    b = MASS.extract(others, [1])
    complement = MASS[1, 1] - (b.T * MASS.extract(others, others).inv() * b)[0]
    assert equal(right_sides("energy", "frequency")[M_e] * R**2, complement)


def test_stationary_shares_are_the_mode_shape():
    stationary_xi, stationary_eta, *rest = ROUTES["energy"]["least"].equations
    shares = {relation.lhs: relation.rhs for relation in rest[:2]}
    assert set(shares) == {xi, eta}
    assert equal(stationary_xi.lhs.subs(shares), sp.S.Zero)
    assert equal(stationary_eta.lhs.subs(shares), sp.S.Zero)
    v = sp.Matrix([shares[xi] * R, 1, shares[eta]])
    residual = STIFFNESS * v - reference.natural_frequency_squared() * MASS * v
    assert all(equal(entry, sp.S.Zero) for entry in residual)
    assert equal(rest[2].lhs.doit(), rest[2].rhs)


positive = st.fractions(min_value="1/50", max_value=50, max_denominator=50)
any_share = st.fractions(min_value=-5, max_value=5, max_denominator=50)


@settings(deadline=None, max_examples=50)
@given(positive, positive, any_share, any_share)
def test_no_other_share_has_less_inertia(mass, roller_mass, block, top):
    values = {m: sp.Rational(mass), m_prime: sp.Rational(roller_mass)}
    inertia = LEAST.inertia.subs(values | {xi: sp.Rational(block), eta: sp.Rational(top)})
    assert inertia >= LEAST.least.subs(values)


def test_the_spring_feels_a_quarter_of_it():
    mass, frequency = ROUTES["energy"]["spring_mass"].equations
    effective = right_sides("energy", "frequency")[M_e]
    assert equal(4 * mass.rhs, effective)
    assert equal(frequency.rhs.subs(M_x, mass.rhs), reference.natural_frequency_squared())
    assert spin_of_lower_rollers(machine()) == sp.Rational(3, 8) * m_prime


def test_the_held_block_gives_a_lower_bound():
    difference, clamped = ROUTES["energy"]["bound"].equations
    assert difference.rhs.is_positive
    assert equal(clamped.rhs, STIFFNESS[1, 1] / MASS[1, 1])
    assert sp.factor(reference.natural_frequency_squared() - clamped.rhs).is_positive


# Matrix


def test_matrices_are_those_of_kanes_method():
    mass, stiffness = (relation.rhs for relation in ROUTES["matrix"]["matrices"].equations)
    assert sp.expand(mass - MASS).is_zero_matrix
    assert sp.expand(stiffness - STIFFNESS).is_zero_matrix


def test_matrices_are_those_of_the_floating_point_machine():
    values = {m: 3, m_prime: 2, k: 7, R: sp.Rational(1, 8)}
    machine_in_floats = Oscillator(3, 2, 7, 0.125)
    mass, stiffness = (relation.rhs.subs(values) for relation in ROUTES["matrix"]["matrices"].equations)
    assert [float(x) for x in mass] == machine_in_floats.mass_matrix.ravel().tolist()
    assert [float(x) for x in stiffness] == machine_in_floats.stiffness_matrix.ravel().tolist()


def test_the_equation_of_motion_holds():
    (relation,) = ROUTES["matrix"]["motion"].equations
    difference = relation.lhs.as_explicit() - relation.rhs.as_explicit()
    assert all(equal(entry.subs(reference.accelerations()), sp.S.Zero) for entry in difference)


def test_the_determinant_is_that_of_the_pencil():
    unevaluated, factored = ROUTES["matrix"]["determinant"].equations
    pencil = (STIFFNESS - Lambda * MASS).det(method="berkowitz")
    assert equal(unevaluated.lhs.doit(), pencil)
    assert equal(factored.lhs, pencil)


def test_the_spectrum_is_one_oscillation_and_two_zeros():
    spectrum, frequency = ROUTES["matrix"]["spectrum"].equations
    assert list(spectrum.rhs)[:2] == [0, 0]
    assert spectrum.rhs[2] == frequency.rhs
    values = {m: 2, m_prime: 5, k: 3, R: 1}
    found = (MASS.inv() * STIFFNESS).subs(values).eigenvals()
    assert found == {sp.S.Zero: 2, frequency.rhs.subs(values): 1}


def test_zero_modes_cost_no_energy():
    vectors = [relation.lhs.args[1] for relation in ROUTES["matrix"]["zero_modes"].equations]
    assert vectors == [sp.Matrix([1, 0, 0]), sp.Matrix([0, 0, 1])]
    assert all((STIFFNESS * v).is_zero_matrix for v in vectors)
    assert all(relation.lhs.as_explicit() == relation.rhs for relation in ROUTES["matrix"]["zero_modes"].equations)


def test_the_shortcut_is_the_rank_one_formula():
    stiffness, inverse, frequency = ROUTES["matrix"]["shortcut"].equations
    assert stiffness.rhs.as_explicit() == sp.Matrix(STIFFNESS)
    assert STIFFNESS.rank() == 1
    assert (MASS * inverse.rhs).applyfunc(sp.simplify) == sp.eye(3)
    assert equal(frequency.rhs, reference.natural_frequency_squared())


def test_the_mode_shape_is_an_eigenvector():
    (relation,) = ROUTES["matrix"]["mode_shape"].equations
    residual = (STIFFNESS - reference.natural_frequency_squared() * MASS) * relation.rhs
    assert all(equal(entry, sp.S.Zero) for entry in residual)
    assert relation.rhs[1] == 1
    shape = relation.rhs.subs({m: 3, m_prime: 2, R: sp.Rational(1, 8)})
    assert [float(x) for x in shape] == pytest.approx(Oscillator(3, 2, 7, 0.125).mode_shape.tolist(), rel=1e-15)
    assert {X, Phi}.isdisjoint(relation.rhs.free_symbols)
