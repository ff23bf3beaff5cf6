"""The contacts: against Newton's thirteen equations, solved as they stand, and against the worst instant of a cycle."""

import math
from fractions import Fraction

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
from tests.test_whole_range import CONTACTS, exact
from tests.test_whole_range import newton as newtons_equations


def decimals(low, high):
    """Numbers to nine decimals: products of denormal numbers lose digits, which says nothing about the machine."""
    return st.floats(low, high).map(lambda value: round(value, 9))


MASS = st.floats(0.05, 20)
MACHINES = st.builds(Oscillator, m=MASS, m_prime=MASS, k=st.floats(0.1, 1e3), radius=st.floats(0.01, 2))
ROOM = st.floats(2, 40).map(lambda room: math.nextafter(room, 50))
"""Spacing of the axes in radii; a product that is rounded down may not let the rollers overlap."""
PUSH = decimals(-2, 2)
STARTS = st.builds(InitialState, X=PUSH, phi=PUSH, Phi=PUSH, X_dot=PUSH, phi_dot=PUSH, Phi_dot=PUSH)
BRIEFLY = settings(max_examples=60, deadline=None)
PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)


def newton(oscillator, q):
    """Contact forces at the states q from Newton's thirteen equations, which are linear in the force of the spring."""
    spring = oscillator.k * 2 * oscillator.radius * q[1]
    unit = newtons_equations(exact(oscillator.m), exact(oscillator.m_prime))
    return {name: float(force) * spring for name, force in unit.items()}


def whole_cycle(oscillator, points=121):
    return np.linspace(0, oscillator.period, points)


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
    forces = newton(oscillator, q)
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


def test_equal_masses_far_apart_need_the_known_coefficients():
    # u = kA/(mg) = 1.
    required = required_friction(Oscillator(m=1, m_prime=1, k=1), 2 * 9.81)
    assert list(required.values()) == pytest.approx([112 / 99, 60 / 99, 48 / 148.5, 22 / 148.5, 32 / 99], rel=1e-14)
    known = [1.1313, 0.6061, 0.3232, 0.1481, 0.3232]
    assert [round(value, 4) for value in required.values()] == known


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


def test_no_compression_needs_no_friction():
    assert required_friction(Oscillator(), 0.0, spacing=0.3) == dict.fromkeys(CONTACTS, 0.0)
