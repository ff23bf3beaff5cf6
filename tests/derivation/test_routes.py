"""All routes lead to the same Ω², also for other bodies."""

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES, newton
from ramanujan.derivation.elimination import eliminate
from ramanujan.derivation.energy_conservation import least_inertia
from ramanujan.derivation.hamilton import legendre_transform, reduce_to_one_degree
from ramanujan.derivation.matrix import find_modes
from ramanujan.derivation.model import (
    Omega_squared,
    R,
    epsilon_star,
    k,
    m,
    m_prime,
    machine,
    phi,
)
from tests.checks import reference
from tests.checks.reference import equal

OTHER_BODIES = {
    "top that does not resist turning": {"top": 0},
    "two hoops": {"hoop": 1, "cylinder": 1},
    "sphere on top": {"top": sp.Rational(2, 5)},
    "shell, sphere, hoop": {"hoop": sp.Rational(2, 3), "cylinder": sp.Rational(2, 5), "top": 1},
}


@pytest.mark.parametrize("name", ROUTES)
def test_every_route_ends_in_the_same_expression(name):
    assert ROUTES[name].natural_frequency_squared == ROUTES["euler_lagrange"].natural_frequency_squared
    assert equal(ROUTES[name].natural_frequency_squared, reference.natural_frequency_squared())
    assert any(
        relation == sp.Eq(Omega_squared, ROUTES[name].natural_frequency_squared, evaluate=False)
        for step in ROUTES[name].steps
        for relation in step.equations
    )


@pytest.mark.parametrize("name", ROUTES)
def test_the_last_step_uses_one_symbol_for_the_ratio(name):
    last = ROUTES[name].steps[-1]
    assert r"\varepsilon_*" not in last.reason or any(epsilon_star in line.free_symbols for line in last.equations)


@pytest.mark.parametrize("bodies", OTHER_BODIES.values(), ids=OTHER_BODIES)
def test_the_routes_agree_for_other_bodies_too(bodies):
    other = machine(**bodies)
    expected = eliminate(other).natural_frequency_squared
    assert expected != ROUTES["matrix"].natural_frequency_squared
    by_hamilton = 4 * k / reduce_to_one_degree(legendre_transform(other)[2])[0]
    by_newton = -newton.solve_free_bodies(other).solution[newton.angular_acceleration("hoop")] / phi
    by_energy = 4 * k / least_inertia(other)[2]
    for result in (by_hamilton, by_newton, by_energy, find_modes(other).natural_frequency_squared):
        assert equal(result, expected)


def test_thirteen_equations_for_thirteen_unknowns():
    cut = newton.solve_free_bodies(machine())
    assert (len(cut.forces), len(cut.torques), len(cut.rolling)) == (5, 3, 5)
    assert len(cut.solution) == 13
    coefficients, _ = sp.linear_eq_to_matrix(cut.forces + cut.torques + cut.rolling, list(cut.solution))
    assert coefficients.subs({m: 2, m_prime: 3, R: 5}).rank() == 13
