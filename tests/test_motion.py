"""The exact motion against an integrator, and its times. The whole range is in test_whole_range.py."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ramanujan import Oscillator
from ramanujan.energy import energies
from ramanujan.motion import InitialState, motion

mass = st.floats(-1.5, 1.5).map(lambda exponent: 10**exponent)
coordinate = st.floats(-1, 1)
oscillators = st.builds(Oscillator, mass, mass, mass, st.floats(0.05, 0.5))
states = st.builds(InitialState, *[coordinate] * 6)
PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)
"""Neither momentum is zero, and both zero modes are excited."""


@settings(deadline=None, max_examples=40)
@given(oscillators, states)
def test_motion_agrees_with_an_integrator_and_begins_where_it_is_told(oscillator, initial):
    inverse = np.linalg.inv(oscillator.mass_matrix) @ oscillator.stiffness_matrix
    start = [initial.X, initial.phi, initial.Phi, initial.X_dot, initial.phi_dot, initial.Phi_dot]
    times = np.linspace(0, 3 * oscillator.period, 7)
    solved = solve_ivp(
        lambda _, y: np.concatenate([y[3:], -inverse @ y[:3]]),
        (0, times[-1]),
        start,
        "DOP853",
        times,
        rtol=1e-11,
        atol=1e-11,
    )
    state = np.concatenate(motion(oscillator, initial, times))
    assert np.allclose(state, solved.y, rtol=0, atol=1e-8 * (1 + np.abs(solved.y).max()))
    assert np.array_equal(state[:, 0], start)


@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (0,)])
def test_any_shape_of_times_goes_through(shape):
    t = np.arange(np.prod(shape), dtype=float).reshape(shape)
    q, q_dot = motion(Oscillator(), PUSHED, t)
    assert q.shape == q_dot.shape == (3, *shape)
    assert energies(Oscillator(), q, q_dot)["spring"].shape == shape
    for index in np.ndindex(*shape):
        # A single time goes another way through the code.
        single = motion(Oscillator(), PUSHED, float(t[index]))
        assert np.allclose(np.concatenate([q, q_dot])[:, *index], np.concatenate(single), rtol=0, atol=1e-15)


@pytest.mark.parametrize("t", [1.001e18, -1e30, 1e300, [0.0, 1e308]])
def test_farther_out_the_time_is_refused(t):
    with pytest.raises(ValueError, match=r"^t must not exceed 10¹⁸ periods"):
        motion(Oscillator(k=1e3), PUSHED, t)
