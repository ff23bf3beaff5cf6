"""Required friction, the first contact to slip, and the largest compression. test_whole_range.py tests the forces."""

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.physics.contact import (
    contact_forces,
    first_to_slip,
    largest_compression,
    normal_forces,
    required_friction,
    travel_amplitude,
)
from ramanujan.physics.motion import InitialState, motion, released
from tests.checks.derived import CONTACTS

MASS = st.floats(0.05, 20)
MACHINES = st.builds(Oscillator, m=MASS, m_prime=MASS, k=st.floats(0.1, 1e3), radius=st.floats(0.01, 2))
# Nine decimals avoid subnormal numbers, whose products lose digits.
SMALL = st.floats(-2, 2).map(lambda value: round(value, 9))
INITIAL_STATES = st.builds(InitialState, X=SMALL, phi=SMALL, Phi=SMALL, X_dot=SMALL, phi_dot=SMALL, Phi_dot=SMALL)


def whole_cycle(oscillator, points=121):
    return np.linspace(0, oscillator.period, points)


@pytest.mark.parametrize("radius", [0.1, 0.30000004, 1 / 3])
def test_the_bound_of_an_error_is_accepted(radius):
    oscillator = Oscillator(radius=radius)
    with pytest.raises(ValueError, match="spacing must be at least 2R") as refusal:
        largest_compression(oscillator, 0.3, spacing=1.9 * radius)
    least = float(re.search(r"2R, (\S+) m", str(refusal.value))[1])
    assert largest_compression(oscillator, 0.3, spacing=least) > 0


@pytest.mark.parametrize("spacing", [0.2, 0.1999, 0.05])
def test_a_slab_that_tips_raises_an_error(spacing):
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


@settings(max_examples=60, deadline=None)
@given(MACHINES, st.floats(0.01, 2), st.floats(2, 20))
def test_the_largest_compression_is_where_the_first_contact_slips(oscillator, mu, room):
    for spacing in (math.inf, room * oscillator.radius):
        largest = largest_compression(oscillator, mu, spacing=spacing)
        needed = required_friction(oscillator, largest, spacing=spacing)
        # Close to tipping, the required friction grows like 1/(1 − x₀/L), and so does its rounding error.
        assert max(needed.values()) == pytest.approx(mu, rel=1e-13 / (1 - largest / spacing))
        assert needed[first_to_slip(oscillator, largest, spacing)] == max(needed.values())


@settings(max_examples=60, deadline=None)
@given(MACHINES, INITIAL_STATES, st.floats(1.01, 20))
def test_a_pushed_machine_needs_the_friction_of_a_release_with_its_amplitude(oscillator, initial, room):
    amplitude = travel_amplitude(oscillator, initial)
    spacing = max(2 * amplitude * room, 2 * oscillator.radius)
    q, _ = motion(oscillator, initial, whole_cycle(oscillator, 2001))
    forces, loads = contact_forces(oscillator, q), normal_forces(oscillator, q, spacing=spacing)
    required = required_friction(oscillator, 2 * amplitude, spacing=spacing)
    for name in CONTACTS:
        largest = np.max(np.abs(forces[name]) / loads[name])
        assert largest <= required[name] * (1 + 1e-11)
        # The maximum is at most half a step away. This changes the force by (π/2000)²/2 ≈ 1.2e-6 of its value, and the
        # smallest load by up to 100 times as much at room = 1.01.
        assert largest >= required[name] * (1 - 3e-4)


def test_the_largest_compression_is_less_than_the_spacing_at_any_friction():
    for mu in 10.0 ** np.arange(-2, 51):
        for spacing in (0.2, 0.29, 0.3, 0.7, 1.1):
            largest = largest_compression(Oscillator(), mu, spacing=spacing)
            assert largest < spacing
            required_friction(Oscillator(), largest, spacing=spacing)
