"""The contacts: against Newton's thirteen equations, solved as they stand, and against the worst instant of a cycle."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from ramanujan import Oscillator
from ramanujan.contact import (
    contact_forces,
    first_to_slip,
    largest_compression,
    normal_forces,
    required_friction,
    travel_amplitude,
)
from ramanujan.motion import InitialState, motion, released


def decimals(low, high):
    """Numbers to nine decimals: products of denormal numbers lose digits, which says nothing about the machine."""
    return st.floats(low, high).map(lambda value: round(value, 9))


CONTACTS = ["hoop_slab", "cylinder_slab", "hoop_block", "cylinder_block", "top_block"]
MASS = st.floats(0.05, 20)
MACHINES = st.builds(Oscillator, m=MASS, m_prime=MASS, k=st.floats(0.1, 1e3), radius=st.floats(0.01, 2))
ROOM = st.floats(2, 40).map(lambda room: math.nextafter(room, 50))
"""Spacing of the axes in radii; a product that is rounded down may not let the rollers overlap."""
PUSH = decimals(-2, 2)
STARTS = st.builds(InitialState, X=PUSH, phi=PUSH, Phi=PUSH, X_dot=PUSH, phi_dot=PUSH, Phi_dot=PUSH)
BRIEFLY = settings(max_examples=60, deadline=None)
PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)


def newton_equations(m, m_prime, hoop_sign=1):
    """The thirteen equations in the unknowns below, as a matrix and the right side for a unit force of the spring.

    Accelerations over the ground of block b, hoop h, cylinder c, slab s and top cylinder t; Rα of the three rolling
    bodies; forces on the rollers. All count to the right, angles clockwise. A force to the right at the top of a body
    turns it clockwise, at its foot the other way. `hoop_sign` is there to spoil one torque.
    """
    b, h, c, s, t, spin_h, spin_c, spin_t, hs, cs, hb, cb, tb = range(13)
    equations = [
        # Five forces: mass × acceleration − contact forces = spring.
        ({b: m, hb: 1, cb: 1, tb: 1}, 1),
        ({h: m_prime, hs: -1, hb: -1}, 0),
        ({c: m_prime, cs: -1, cb: -1}, 0),
        ({s: m, hs: 1, cs: 1}, -1),
        ({t: m, tb: -1}, 0),
        # Three torques, divided by R.
        ({spin_h: m_prime, hs: -hoop_sign, hb: 1}, 0),
        ({spin_c: m_prime / 2, cs: -1, cb: 1}, 0),
        ({spin_t: m / 2, tb: 1}, 0),
        # Five rolling constraints: the two surfaces of each contact move alike.
        ({h: 1, spin_h: -1, b: -1}, 0),
        ({c: 1, spin_c: -1, b: -1}, 0),
        ({h: 1, spin_h: 1, s: -1}, 0),
        ({c: 1, spin_c: 1, s: -1}, 0),
        ({t: 1, spin_t: -1, b: -1}, 0),
    ]
    matrix = np.zeros((13, 13))
    for row, (terms, _) in enumerate(equations):
        for column, value in terms.items():
            matrix[row, column] = value
    return matrix, np.array([right for _, right in equations], dtype=float)


def newton(oscillator, q, **spoiled):
    """Contact forces and Rφ̈ at the states q, from a linear solve at each; masses in units of m keep it well scaled."""
    matrix, unit = newton_equations(1.0, oscillator.m_prime / oscillator.m, **spoiled)
    spring = oscillator.k * 2 * oscillator.radius * np.atleast_1d(q[1])
    solution = np.linalg.solve(matrix, unit[:, None] * spring)
    return dict(zip(CONTACTS, solution[8:], strict=True)), solution[5] / oscillator.m


def whole_cycle(oscillator, points=121):
    return np.linspace(0, oscillator.period, points)


@BRIEFLY
@given(MACHINES, STARTS)
def test_forces_solve_newtons_thirteen_equations_over_a_cycle(oscillator, initial):
    t = whole_cycle(oscillator)
    q, _ = motion(oscillator, initial, t)
    forces = contact_forces(oscillator, q)
    expected, acceleration = newton(oscillator, q)
    assert list(forces) == [*CONTACTS, "spring"]
    for name in CONTACTS:
        np.testing.assert_allclose(forces[name], expected[name], rtol=1e-12, atol=1e-290)
    np.testing.assert_allclose(forces["spring"], -oscillator.k * 2 * oscillator.radius * q[1], rtol=1e-14, atol=1e-290)
    omega_squared = oscillator.natural_frequency_squared
    np.testing.assert_allclose(acceleration, -omega_squared * oscillator.radius * q[1], rtol=1e-12, atol=1e-290)


def test_the_thirteen_equations_are_independent_and_a_wrong_torque_shows():
    matrix, _ = newton_equations(1.0, 1.0)
    assert np.linalg.matrix_rank(matrix) == 13
    oscillator = Oscillator()
    q, _ = motion(oscillator, PUSHED, 0.3)
    spoiled, _ = newton(oscillator, q, hoop_sign=-1)
    forces = contact_forces(oscillator, q)
    assert all(abs(spoiled[name][0] / forces[name] - 1) > 0.01 for name in CONTACTS)


@pytest.mark.parametrize("ratio", [1e-8, 1e-3, 1e3, 1e8])
def test_forces_keep_twelve_digits_for_extreme_rollers(ratio):
    oscillator = Oscillator(m=2.0, m_prime=2 * ratio, k=5.0, radius=0.2)
    forces = contact_forces(oscillator, motion(oscillator, released(oscillator, 0.1), 0.0)[0])
    with mpmath.workdps(50):
        matrix, unit = newton_equations(oscillator.m, oscillator.m_prime)
        spring = mpmath.mpf(oscillator.k) * mpmath.mpf(0.1)
        solution = mpmath.lu_solve(mpmath.matrix(matrix.tolist()), spring * mpmath.matrix(unit.tolist()))
        for name, exact in zip(CONTACTS, solution[8:], strict=True):
            assert abs(forces[name] / float(exact) - 1) < 1e-12, name


def test_the_forces_ignore_the_zero_modes():
    oscillator = Oscillator(m_prime=0.7)
    t = whole_cycle(oscillator)
    still = InitialState(phi=PUSHED.phi, phi_dot=PUSHED.phi_dot)
    drifting, resting = (contact_forces(oscillator, motion(oscillator, start, t)[0]) for start in (PUSHED, still))
    for name, force in drifting.items():
        np.testing.assert_array_equal(force, resting[name])


# --- normal forces ---------------------------------------------------------------------------------------------------


def slab_support(oscillator, travel, g, spacing):
    """The two rollers' loads from the slab's balance of forces and of moments about the point halfway at φ = 0."""
    weight = oscillator.m * g
    hoop_axis, cylinder_axis, center = -spacing / 2 + travel, spacing / 2 + travel, 2 * travel
    return np.linalg.solve([[1, 1], [hoop_axis, cylinder_axis]], [weight, weight * center])


@BRIEFLY
@given(MACHINES, decimals(-0.99, 0.99), ROOM, st.floats(1, 30))
def test_normal_forces_balance_every_body(oscillator, fraction, room, g):
    spacing = room * oscillator.radius
    initial = released(oscillator, fraction * spacing)
    for t in whole_cycle(oscillator, 9):
        q, _ = motion(oscillator, initial, t)
        travel = oscillator.radius * q[1]
        on_hoop, on_cylinder = slab_support(oscillator, travel, g, spacing)
        normals = normal_forces(oscillator, q, g, spacing)
        roller = oscillator.m_prime * g
        expected = [on_hoop, on_cylinder, on_hoop + roller, on_cylinder + roller, oscillator.m * g]
        assert list(normals) == CONTACTS
        # The moments cancel near tipping: compare on the scale of the slab's weight.
        np.testing.assert_allclose(list(normals.values()), expected, rtol=1e-13, atol=1e-13 * oscillator.m * g)
        assert min(normals.values()) > 0


def test_the_load_shifts_onto_the_roller_that_the_slab_moves_to():
    oscillator = Oscillator()
    initial = released(oscillator, 0.2)
    pushed_right = normal_forces(oscillator, motion(oscillator, initial, 0.0)[0], spacing=1.0)
    pushed_left = normal_forces(oscillator, motion(oscillator, initial, oscillator.period / 2)[0], spacing=1.0)
    assert pushed_right["cylinder_slab"] > pushed_right["hoop_slab"]
    assert pushed_left["cylinder_slab"] < pushed_left["hoop_slab"]
    far_apart = normal_forces(oscillator, motion(oscillator, initial, whole_cycle(oscillator))[0])
    np.testing.assert_array_equal(far_apart["hoop_slab"], oscillator.m * 9.81 / 2)
    assert all(values.shape == (121,) for values in far_apart.values())


@pytest.mark.parametrize("spacing", [0.2, 0.1999, 0.05])
def test_a_slab_that_tips_off_is_an_error_not_a_number(spacing):
    oscillator = Oscillator()
    for compression in (0.2, -0.2):
        with pytest.raises(ValueError, match="spacing must exceed the largest compression"):
            required_friction(oscillator, compression, spacing=spacing)
        with pytest.raises(ValueError, match="spacing must exceed the largest compression"):
            first_to_slip(oscillator, compression, spacing)
        q, _ = motion(oscillator, released(oscillator, compression), whole_cycle(oscillator))
        with pytest.raises(ValueError, match="spacing must exceed the largest compression"):
            normal_forces(oscillator, q, spacing=spacing)
    assert min(required_friction(oscillator, 0.2, spacing=0.2001).values()) > 0


@pytest.mark.parametrize("room", [1e-3, 1e-9, 1e-15])
def test_no_digit_is_lost_close_to_tipping(room):
    spacing = 0.2 * (1 + room)
    far_apart = required_friction(Oscillator(), 0.2)["hoop_slab"]
    growth = 1 / (1 - Fraction(0.2) / Fraction(spacing))
    found = required_friction(Oscillator(), 0.2, spacing=spacing)["hoop_slab"]
    assert found == pytest.approx(far_apart * float(growth), rel=1e-14)


# --- friction --------------------------------------------------------------------------------------------------------


@BRIEFLY
@given(MACHINES, decimals(-0.98, 0.98), st.one_of(st.just(math.inf), ROOM))
def test_required_friction_is_the_worst_instant_of_a_brute_force_cycle(oscillator, fraction, room):
    spacing = room * oscillator.radius
    compression = fraction * min(spacing, 1.0)
    t = whole_cycle(oscillator, 720 + 1)
    q, _ = motion(oscillator, released(oscillator, compression), t)
    travel = oscillator.radius * q[1]
    shift = 0 * travel if math.isinf(spacing) else travel / spacing
    slab, roller = oscillator.m * 9.81, oscillator.m_prime * 9.81
    on_hoop, on_cylinder = slab * (0.5 - shift), slab * (0.5 + shift)
    loads = [on_hoop, on_cylinder, on_hoop + roller, on_cylinder + roller, np.full_like(travel, slab)]
    forces, _ = newton(oscillator, q)
    required = required_friction(oscillator, compression, spacing=spacing)
    assert list(required) == CONTACTS
    for name, load in zip(CONTACTS, loads, strict=True):
        worst = np.max(np.abs(forces[name]) / load)
        # The grid holds both ends of the swing, where every contact has its maximum; 2 % from tipping costs two digits.
        np.testing.assert_allclose(required[name], worst, rtol=1e-11, atol=1e-290)


@BRIEFLY
@given(MACHINES, STARTS, st.floats(1.01, 20))
def test_a_pushed_machine_needs_the_friction_of_a_release_with_its_amplitude(oscillator, initial, room):
    amplitude = travel_amplitude(oscillator, initial)
    spacing = max(2 * amplitude * room, 2 * oscillator.radius)
    q, _ = motion(oscillator, initial, whole_cycle(oscillator, 2001))
    forces, loads = contact_forces(oscillator, q), normal_forces(oscillator, q, spacing=spacing)
    required = required_friction(oscillator, 2 * amplitude, spacing=spacing)
    for name in CONTACTS:
        largest = np.max(np.abs(forces[name]) / loads[name])
        assert largest <= required[name] * (1 + 1e-11)
        # Half a step from the crest loses (π/2000)²/2 ≈ 1.2e-6 of the force, up to 100-fold of the load at room = 1.01.
        assert largest >= required[name] * (1 - 3e-4)


def test_the_load_shift_matters_to_that_comparison():
    oscillator = Oscillator()
    level = required_friction(oscillator, 0.2)
    shifted = required_friction(oscillator, 0.2, spacing=0.5)
    for name in CONTACTS[:4]:
        assert shifted[name] > 1.1 * level[name]
    assert shifted["top_block"] == level["top_block"]


def test_equal_masses_far_apart_need_the_known_coefficients():
    # u = kA/(mg) = 1.
    required = required_friction(Oscillator(m=1, m_prime=1, k=1), 2 * 9.81)
    assert list(required.values()) == pytest.approx([112 / 99, 60 / 99, 48 / 148.5, 22 / 148.5, 32 / 99], rel=1e-14)
    known = [1.1313, 0.6061, 0.3232, 0.1481, 0.3232]
    assert [round(value, 4) for value in required.values()] == known


@BRIEFLY
@given(MACHINES, decimals(0, 0.99), ROOM, st.floats(1, 30))
def test_required_friction_is_the_rational_function_of_the_mass_ratio(oscillator, fraction, room, g):
    spacing = room * oscillator.radius
    compression = fraction * spacing
    e, A = oscillator.mass_ratio, compression / 2
    u = oscillator.k * A / (oscillator.m * g)
    D = 18 * e**2 + 49 * e + 32
    expected = [
        16 * e * (3 * e + 4) / D * u / (1 - 2 * A / spacing),
        12 * e * (2 * e + 3) / D * u / (1 - 2 * A / spacing),
        24 * e * (1 + e) / D * u / (0.5 - A / spacing + e),
        2 * e * (6 * e + 5) / D * u / (0.5 - A / spacing + e),
        16 * (1 + e) / D * u,
    ]
    required = required_friction(oscillator, compression, g, spacing)
    np.testing.assert_allclose(list(required.values()), expected, rtol=1e-12, atol=1e-290)
    assert required == required_friction(oscillator, -compression, g, spacing)


# --- the first slip --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("spacing", "compression"), [(math.inf, 0.0), (math.inf, 0.3), (0.5, 0.0)])
def test_the_first_contact_to_slip_changes_at_the_root_of_3e2_plus_3e_minus_1(spacing, compression):
    def lead(ratio):
        required = required_friction(Oscillator(m_prime=ratio), 0.01)
        return required["top_block"] - required["hoop_slab"]

    change = brentq(lead, 0.01, 10, xtol=1e-14)
    assert change == pytest.approx((math.sqrt(21) - 3) / 6, rel=1e-12)
    assert first_to_slip(Oscillator(m_prime=change * (1 - 1e-9)), compression, spacing) == "top_block"
    assert first_to_slip(Oscillator(m_prime=change * (1 + 1e-9)), compression, spacing) == "hoop_slab"


def test_a_shifting_load_makes_the_hoop_slip_at_a_smaller_ratio():
    oscillator = Oscillator(m_prime=0.2)
    assert first_to_slip(oscillator, 0.3) == "top_block"
    assert first_to_slip(oscillator, 0.3, spacing=0.5) == "hoop_slab"


@BRIEFLY
@given(MACHINES, decimals(-0.999, 0.999), st.one_of(st.just(math.inf), ROOM))
def test_no_other_contact_ever_slips_first(oscillator, fraction, room):
    spacing = room * oscillator.radius
    compression = fraction * min(spacing, 1.0)
    first = first_to_slip(oscillator, compression, spacing)
    assert first in ("top_block", "hoop_slab")
    required = required_friction(oscillator, compression, spacing=spacing)
    assert required[first] == max(required.values())


@BRIEFLY
@given(MACHINES, st.floats(1e-3, 5), st.floats(1, 30), st.one_of(st.just(math.inf), ROOM))
def test_just_within_the_largest_compression_all_roll_and_just_beyond_one_slips(oscillator, mu, g, room):
    spacing = room * oscillator.radius
    largest = largest_compression(oscillator, mu, g, spacing)
    assert 0 < largest < spacing
    # It is rounded down, so it needs no margin.
    assert max(required_friction(oscillator, largest, g, spacing).values()) <= mu
    beyond = largest * (1 + 1e-9)
    # Strong friction holds almost until the slab tips; then "just beyond" may be beyond the support itself.
    if beyond < spacing:
        outside = required_friction(oscillator, beyond, g, spacing)
        assert max(outside.values()) > mu
        assert max(outside, key=outside.get) == first_to_slip(oscillator, largest, spacing)


@pytest.mark.parametrize("spacing", [math.inf, 0.7])
def test_the_largest_compression_is_the_root_that_a_bracketing_solver_finds(spacing):
    oscillator = Oscillator(m=3.0, m_prime=2.0, k=40.0)
    found = brentq(lambda x: max(required_friction(oscillator, x, spacing=spacing).values()) - 0.4, 0, 0.69, xtol=1e-15)
    assert largest_compression(oscillator, 0.4, spacing=spacing) == pytest.approx(found, rel=1e-12)


# --- what is refused -------------------------------------------------------------------------------------------------

BAD = [0, -1, math.nan, None, "1", [1, 2]]


@pytest.mark.parametrize("bad", BAD)
def test_bad_parameters_are_named(bad):
    oscillator = Oscillator()
    for call in (
        lambda **wrong: required_friction(oscillator, 0.01, **wrong),
        lambda **wrong: largest_compression(oscillator, 0.3, **wrong),
        lambda **wrong: normal_forces(oscillator, [0, 0.1, 0], **wrong),
    ):
        with pytest.raises(ValueError, match="g must"):
            call(g=bad)
        with pytest.raises(ValueError, match="g must"):
            call(g=math.inf)
        with pytest.raises(ValueError, match="spacing must"):
            call(spacing=bad)
    with pytest.raises(ValueError, match="friction_coefficient must"):
        largest_compression(oscillator, bad)
    with pytest.raises(ValueError, match="friction_coefficient must"):
        largest_compression(oscillator, math.inf)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, None, "0.1"])
def test_a_bad_compression_is_named(bad):
    with pytest.raises(ValueError, match="compression must be a finite number"):
        required_friction(Oscillator(), bad)
    with pytest.raises(ValueError, match="compression must be a finite number"):
        first_to_slip(Oscillator(), bad)


def test_no_compression_needs_no_friction():
    assert required_friction(Oscillator(), 0.0, spacing=0.3) == dict.fromkeys(CONTACTS, 0.0)
