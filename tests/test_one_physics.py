"""The numeric core against the derivation: every matrix, energy, momentum, force and motion, number for number.

The symbolic side is printed to functions of 50-digit numbers by SymPy and evaluated at random machines and states.
"""

from __future__ import annotations

from functools import cache
from itertools import islice

import mpmath
import numpy as np
import pytest
import sympy as sp

from ramanujan import (
    METHODS,
    InitialState,
    Oscillator,
    contact_forces,
    energies,
    ground_positions,
    ground_velocities,
    momenta,
    motion,
    normal_forces,
    relative_positions,
    relative_velocities,
    released,
    trajectory,
    with_initial_velocities,
)
from ramanujan.derivation import ROUTES
from ramanujan.derivation.newton import contact_forces as derived_contact_forces
from ramanujan.derivation.solution import INITIAL, INITIAL_RATE, Omega, coefficients, mode_shape
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, Phi, R, X, k, m, m_prime, machine, phi, t
from ramanujan.energy import body_momenta

CASES = 60
EXACT = 3e-15
"""A dozen roundings of the largest term."""


def cases():
    """Random machines with a random state and a random time."""
    rng = np.random.default_rng(1729)
    for _ in range(CASES):
        oscillator = Oscillator(*(10.0 ** rng.uniform([-1, -2, -1, -2], [1, 1, 3, 0])).tolist())
        yield oscillator, rng.normal(size=3), rng.normal(size=3), float(rng.uniform(-20, 20))


@cache
def printed(expression):
    """An expression of the derivation as a function of mpmath numbers, and of the sizes of its terms."""
    plain = expression.doit()
    rates = dict(zip([q.diff(t, 2) for q in COORDINATES], sp.symbols("aX aphi aPhi"), strict=True))
    rates |= dict(zip(VELOCITIES, sp.symbols("vX vphi vPhi"), strict=True))
    names = rates | dict(zip(COORDINATES, sp.symbols("qX qphi qPhi"), strict=True))
    plain = plain.xreplace(rates).xreplace(names)
    symbols = sorted(plain.free_symbols, key=str)
    return sp.lambdify(symbols, plain, "mpmath"), [str(symbol) for symbol in symbols]


def derived(expression, oscillator, q=(0, 0, 0), q_dot=(0, 0, 0), **more):
    """The value of an expression of the derivation for a machine in a state, to 50 digits."""
    function, names = printed(sp.sympify(expression))
    values = {str(m): oscillator.m, str(m_prime): oscillator.m_prime, str(k): oscillator.k, str(R): oscillator.radius}
    values |= dict(zip(("qX", "qphi", "qPhi"), q, strict=True)) | dict(zip(("vX", "vphi", "vPhi"), q_dot, strict=True))
    values |= more
    with mpmath.workdps(50):
        return +mpmath.mpf(function(*(mpmath.mpf(values[name]) for name in names)))


def close(value, truth, scale=None):
    scale = abs(truth) if scale is None else scale
    return abs(mpmath.mpf(float(value)) - truth) <= EXACT * scale


def test_the_mass_and_stiffness_matrices_are_the_second_derivatives_of_the_energies():
    bodies = machine()
    mass = sp.hessian(sp.expand(bodies.kinetic_energy), VELOCITIES)
    stiffness = sp.hessian(sp.expand(bodies.potential_energy), COORDINATES)
    for oscillator, *_ in cases():
        for i in range(3):
            for j in range(3):
                assert close(oscillator.mass_matrix[i, j], derived(mass[i, j], oscillator))
                assert close(oscillator.stiffness_matrix[i, j], derived(stiffness[i, j], oscillator))


@pytest.mark.parametrize("route", list(ROUTES))
def test_every_route_gives_the_frequency_of_the_core(route):
    for oscillator, *_ in cases():
        squared = derived(ROUTES[route].natural_frequency_squared, oscillator)
        assert close(oscillator.natural_frequency_squared, squared)
        assert close(oscillator.natural_frequency, mpmath.sqrt(squared))
        assert close(oscillator.normalized_frequency_squared, squared * oscillator.m / oscillator.k)
        assert close(oscillator.effective_mass, oscillator.k / squared)


def test_the_mode_shape_is_the_derived_one():
    shape = mode_shape()
    for oscillator, *_ in cases():
        for value, q in zip(oscillator.mode_shape, COORDINATES, strict=True):
            assert close(value, derived(shape[q], oscillator))


def test_energies_by_body_are_those_of_the_derivation():
    bodies = machine()
    for oscillator, q, q_dot, _ in cases():
        found = energies(oscillator, q, q_dot)
        for body in bodies.bodies:
            for kind in ("translation", "rotation"):
                expression = getattr(body, kind)
                if expression != 0:
                    # A velocity is a difference: its error is one of the larger term.
                    scale = derived(expression, oscillator, q, [-abs(q_dot[0]), abs(q_dot[1]), abs(q_dot[2])])
                    truth = derived(expression, oscillator, q, q_dot)
                    assert close(found.pop(f"{body.name}_{kind}"), truth, scale), (body.name, kind)
        assert close(found.pop("spring"), derived(bodies.potential_energy, oscillator, q, q_dot))
        assert found == {}


def test_momenta_are_the_derivatives_of_the_lagrangian():
    bodies = machine()
    p_X, p_Phi = (sp.diff(bodies.lagrangian, q.diff(t)) for q in (X, Phi))
    for oscillator, _, q_dot, _ in cases():
        found = momenta(oscillator, q_dot)
        for name, expression in (("p_X", p_X), ("p_Phi", p_Phi)):
            scale = sum(abs(derived(expression, oscillator, q_dot=row)) for row in np.diag(q_dot))
            assert close(found[name], derived(expression, oscillator, q_dot=q_dot), scale)
        for body in bodies.bodies:
            truth = derived(body.mass * body.velocity, oscillator, q_dot=q_dot)
            scale = sum(abs(derived(body.mass * body.velocity, oscillator, q_dot=row)) for row in np.diag(q_dot))
            assert close(body_momenta(oscillator, q_dot)[body.name], truth, scale)


def test_places_and_velocities_are_those_of_the_bodies():
    bodies = machine()
    for oscillator, q, q_dot, _ in cases():
        places = ground_positions(oscillator, q), relative_positions(oscillator, q)
        rates = ground_velocities(oscillator, q_dot), relative_velocities(oscillator, q_dot)
        for body in bodies.bodies:
            for (ground, relative), name in ((places, "displacement"), (rates, "velocity")):
                expression, of_block = getattr(body, name), getattr(bodies["block"], name)
                state = q, q_dot
                scale = abs(q[0]) + abs(q_dot[0]) + 2 * oscillator.radius * float(np.abs([*q, *q_dot]).max())
                assert close(ground[body.name], derived(expression, oscillator, *state), scale)
                if body.name != "block":
                    assert close(relative[body.name], derived(expression - of_block, oscillator, *state), scale)
        assert close(places[1]["slab"], derived(bodies.deformation, oscillator, q))


def test_contact_forces_are_those_of_newtons_equations():
    omega_squared = ROUTES["newton"].natural_frequency_squared
    forces = {
        name: force.subs(phi.diff(t, 2), -omega_squared * phi) for name, force in derived_contact_forces().items()
    }
    spring = sp.diff(machine().potential_energy, phi) / (2 * R)
    for oscillator, q, _, _ in cases():
        found = contact_forces(oscillator, q)
        assert set(found) == {*forces, "spring"}
        for name, force in forces.items():
            assert close(found[name], derived(force, oscillator, q)), name
        assert close(found["spring"], -derived(spring, oscillator, q))


def test_the_motion_is_the_derived_solution():
    solution = coefficients()
    for oscillator, q, q_dot, time in cases():
        initial = InitialState(*q, *q_dot)
        with mpmath.workdps(50):
            omega = mpmath.sqrt(derived(ROUTES["matrix"].natural_frequency_squared, oscillator))
        names = {str(INITIAL[x]): value for x, value in zip(COORDINATES, q, strict=True)}
        names |= {str(INITIAL_RATE[x]): value for x, value in zip(COORDINATES, q_dot, strict=True)}
        names[str(Omega)] = omega
        found, found_rate = motion(oscillator, initial, time)
        for i, coordinate in enumerate(COORDINATES):
            a, b, c, d = (derived(part, oscillator, **names) for part in solution[coordinate])
            with mpmath.workdps(50):
                cosine, sine = mpmath.cos(omega * time), mpmath.sin(omega * time)
                truth = a + b * time + c * cosine + d * sine
                rate = b + omega * (d * cosine - c * sine)
                size = abs(q[i]) + abs(b * time) + abs(c) + abs(d)
                # The phase is reduced to 1e-15 rad, whatever the drift has done in that time.
                assert close(found[i], truth, size)
                assert close(found_rate[i], rate, abs(b) + omega * (abs(c) + abs(d)))


def test_a_spoiled_machine_would_be_found():
    """Negative control: with a hoop that is a solid cylinder, nearly everything above is wrong."""
    spoiled = machine(hoop=sp.Rational(1, 2))
    oscillator, q, q_dot, _ = next(cases())
    truth = derived(spoiled["hoop"].rotation, oscillator, q, q_dot)
    assert not close(energies(oscillator, q, q_dot)["hoop_rotation"], truth)
    forces = derived_contact_forces(spoiled)
    truth = derived(forces["hoop_slab"].subs(phi.diff(t, 2), -phi), oscillator, q)
    ratio = float(contact_forces(oscillator, q)["hoop_slab"]) / float(truth)
    assert abs(ratio / oscillator.natural_frequency_squared - 1) > 1e-3


def test_the_trajectory_of_an_integrator_has_contact_forces_too():
    oscillator = Oscillator(1.3, 0.7, 25.0, 0.12)
    response = np.linalg.solve(oscillator.mass_matrix, oscillator.stiffness_matrix)
    n = 500
    start = released(oscillator, 0.08)
    states = trajectory(
        METHODS["yoshida6"], lambda q: -response @ q, np.array([0, start.phi, 0]), np.zeros(3), oscillator.period / n
    )
    q = np.transpose([q for q, _ in islice(states, n)])
    t_ = oscillator.period * np.arange(1, n + 1) / n
    exact, _ = motion(oscillator, start, t_)
    for name, force in contact_forces(oscillator, q).items():
        np.testing.assert_allclose(force, contact_forces(oscillator, exact)[name], atol=1e-9)
    for name, load in normal_forces(oscillator, q, spacing=0.338).items():
        np.testing.assert_allclose(load, normal_forces(oscillator, exact, spacing=0.338)[name], rtol=1e-9)


def test_a_push_excites_the_zero_modes_alone():
    solution = coefficients()
    oscillator = Oscillator(1.3, 0.7, 25.0, 0.12)
    start = with_initial_velocities(oscillator, 0.0, glide=0.3, spin=-2.0)
    names = dict(zip(map(str, INITIAL.values()), (start.X, start.phi, start.Phi), strict=True))
    names |= dict(zip(map(str, INITIAL_RATE.values()), (start.X_dot, start.phi_dot, start.Phi_dot), strict=True))
    names[str(Omega)] = oscillator.natural_frequency
    for coordinate in COORDINATES:
        _, drift, cosine, sine = (derived(part, oscillator, **names) for part in solution[coordinate])
        assert cosine == sine == 0
        assert drift == {X: -0.3, phi: 0, Phi: -2}[coordinate]
