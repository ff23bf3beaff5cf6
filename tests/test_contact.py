"""The contacts: against Newton's thirteen equations, solved as they stand, and against the worst instant of a cycle."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

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


def newton(oscillator):
    """Contact forces at φ = 1 from Newton's thirteen equations, which are linear in the force of the spring."""
    spring = oscillator.k * 2 * oscillator.radius
    unit = newtons_equations(exact(oscillator.m), exact(oscillator.m_prime))
    return np.array([float(unit[name]) * spring for name in CONTACTS])


def whole_cycle(oscillator, points=121):
    return np.linspace(0, oscillator.period, points)


def loads(oscillator, q, g, spacing):
    """The normal forces in a state: every body in balance, the slab also about the point halfway at φ = 0."""
    travel, weight, roller = oscillator.radius * q[1], oscillator.m * g, oscillator.m_prime * g
    axes = travel - spacing / 2, travel + spacing / 2
    on_hoop, on_cylinder = np.linalg.solve([[1, 1], axes], [weight, weight * 2 * travel])
    return np.array([on_hoop, on_cylinder, on_hoop + roller, on_cylinder + roller, weight])


@BRIEFLY
@given(MACHINES, decimals(-0.98, 0.98), ROOM, st.floats(1, 30))
def test_normal_forces_balance_every_body_and_friction_is_that_of_the_worst_instant(oscillator, fraction, room, g):
    spacing = room * oscillator.radius
    compression = fraction * min(spacing, 1.0)
    forces, needed = newton(oscillator), np.zeros(5)
    # The grid holds both ends of the swing, where every contact has its maximum.
    for t in whole_cycle(oscillator, 41):
        q, _ = motion(oscillator, released(oscillator, compression), t)
        expected, normals = loads(oscillator, q, g, spacing), normal_forces(oscillator, q, g, spacing)
        assert list(normals) == CONTACTS
        # The moments cancel near tipping: compare on the scale of the slab's weight.
        np.testing.assert_allclose(list(normals.values()), expected, rtol=1e-13, atol=1e-13 * oscillator.m * g)
        assert min(normals.values()) > 0
        needed = np.maximum(needed, np.abs(forces * q[1]) / expected)
    required = required_friction(oscillator, compression, g, spacing)
    assert list(required) == CONTACTS
    # 2 % from tipping costs two digits.
    np.testing.assert_allclose(list(required.values()), needed, rtol=1e-11, atol=1e-290)


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
    assert set(required_friction(oscillator, 0.0, spacing=spacing + 0.2).values()) == {0.0}


@pytest.mark.parametrize("room", [1e-3, 1e-9, 1e-15])
def test_no_digit_is_lost_close_to_tipping(room):
    spacing = 0.2 * (1 + room)
    far_apart = required_friction(Oscillator(), 0.2)["hoop_slab"]
    growth = 1 / (1 - Fraction(0.2) / Fraction(spacing))
    found = required_friction(Oscillator(), 0.2, spacing=spacing)["hoop_slab"]
    assert found == pytest.approx(far_apart * float(growth), rel=1e-14)


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
