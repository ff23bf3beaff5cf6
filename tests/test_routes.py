"""Five routes, one Ω², for other bodies too; what the routes hand to the numeric core."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.derivation import ROUTES, newton
from ramanujan.derivation.elimination import eliminate
from ramanujan.derivation.hamilton import legendre_transform, reduce_to_one_degree
from ramanujan.derivation.matrix import modes
from ramanujan.derivation.rayleigh import eta, least_inertia, xi
from ramanujan.derivation.symbols import (
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
from tests.reference import equal

MASS, STIFFNESS = reference.mass_and_stiffness()
LEAST = least_inertia(machine())
OTHER_BODIES = {
    "top that does not resist turning": {"top": 0},
    "two hoops": {"hoop": 1, "cylinder": 1},
    "sphere on top": {"top": sp.Rational(2, 5)},
    "shell, sphere, hoop": {"hoop": sp.Rational(2, 3), "cylinder": sp.Rational(2, 5), "top": 1},
}


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


# Newton


def test_thirteen_equations_for_thirteen_unknowns():
    cut = newton.free_bodies(machine())
    assert (len(cut.forces), len(cut.torques), len(cut.rolling)) == (5, 3, 5)
    assert len(cut.solution) == 13
    coefficients, _ = sp.linear_eq_to_matrix(cut.equations, list(cut.solution))
    assert coefficients.subs({m: 2, m_prime: 3, R: 5}).rank() == 13


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


positive = st.fractions(min_value="1/50", max_value=50, max_denominator=50)
any_share = st.fractions(min_value=-5, max_value=5, max_denominator=50)


@settings(deadline=None, max_examples=50)
@given(positive, positive, any_share, any_share)
def test_no_other_share_has_less_inertia(mass, roller_mass, block, top):
    values = {m: sp.Rational(mass), m_prime: sp.Rational(roller_mass)}
    inertia = LEAST.inertia.subs(values | {xi: sp.Rational(block), eta: sp.Rational(top)})
    assert inertia >= LEAST.least.subs(values)


# Matrix


def test_matrices_are_those_of_the_floating_point_machine():
    values = {m: 3, m_prime: 2, k: 7, R: sp.Rational(1, 8)}
    machine_in_floats = Oscillator(3, 2, 7, 0.125)
    mass, stiffness = (relation.rhs.subs(values) for relation in ROUTES["matrix"]["matrices"].equations)
    assert [float(x) for x in mass] == machine_in_floats.mass_matrix.ravel().tolist()
    assert [float(x) for x in stiffness] == machine_in_floats.stiffness_matrix.ravel().tolist()


def test_the_mode_shape_is_an_eigenvector():
    (relation,) = ROUTES["matrix"]["mode_shape"].equations
    residual = (STIFFNESS - reference.natural_frequency_squared() * MASS) * relation.rhs
    assert all(equal(entry, sp.S.Zero) for entry in residual)
    assert relation.rhs[1] == 1
    shape = relation.rhs.subs({m: 3, m_prime: 2, R: sp.Rational(1, 8)})
    assert [float(x) for x in shape] == pytest.approx(Oscillator(3, 2, 7, 0.125).mode_shape.tolist(), rel=1e-15)
    assert {X, Phi}.isdisjoint(relation.rhs.free_symbols)
