"""The exact motion against mpmath, against an integrator, and against its own equation."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ramanujan import Oscillator
from ramanujan.motion import InitialState, motion, released

mass = st.floats(-1.5, 1.5).map(lambda exponent: 10**exponent)
coordinate = st.floats(-1, 1)
oscillators = st.builds(Oscillator, mass, mass, mass, st.floats(0.05, 0.5))
states = st.builds(InitialState, *[coordinate] * 6)


def exact_state(oscillator: Oscillator, initial: InitialState, t: float) -> list[mpmath.mpf]:
    """q(t) by the spectral decomposition of M⁻¹K in 50 digits, from the matrices' definition in the paper."""
    mpmath.mp.dps = 50
    m, mp, k, R = map(mpmath.mpf, (oscillator.m, oscillator.m_prime, oscillator.k, oscillator.radius))
    M = mpmath.matrix(
        [
            [3 * m + 2 * mp, -2 * (m + mp) * R, -m * R],
            [-2 * (m + mp) * R, (4 * m + 7 * mp / 2) * R**2, 0],
            [-m * R, 0, 3 * m * R**2 / 2],
        ]
    )
    response = mpmath.lu_solve(M, mpmath.matrix([0, 4 * k * R**2, 0]))  # q̈ = −response·φ
    omega = mpmath.sqrt(response[1])
    q0 = [mpmath.mpf(x) for x in (initial.X, initial.phi, initial.Phi)]
    v0 = [mpmath.mpf(x) for x in (initial.X_dot, initial.phi_dot, initial.Phi_dot)]
    t = mpmath.mpf(t)
    phi = q0[1] * mpmath.cos(omega * t) + v0[1] / omega * mpmath.sin(omega * t)
    # Twice integrated: q = q₀ + v₀t − response·∬φ, and ∬φ = (φ₀ + φ̇₀t − φ)/Ω².
    double_integral = (q0[1] + v0[1] * t - phi) / omega**2
    return [q0[i] + v0[i] * t - response[i] * double_integral for i in range(3)]


@settings(deadline=None, max_examples=150)
@given(oscillators, states, st.floats(0, 1000))
def test_state_stays_within_1e12_of_its_scale_for_a_thousand_periods(oscillator, initial, periods):
    t = periods * oscillator.period
    q, _ = motion(oscillator, initial, t)
    exact = exact_state(oscillator, initial, t)
    amplitude = math.hypot(initial.phi, initial.phi_dot / oscillator.natural_frequency)
    scale = [
        abs(float(value)) + shape * amplitude + 1e-300
        for value, shape in zip(exact, oscillator.mode_shape, strict=True)
    ]
    drift = [abs(v) * t for v in (initial.X_dot, 0, initial.Phi_dot)]
    coupled = [shape * abs(initial.phi_dot) * t for shape in oscillator.mode_shape * [1, 0, 1]]
    for value, truth, size, moved, carried in zip(q, exact, scale, drift, coupled, strict=True):
        assert abs(float(mpmath.mpf(float(value)) - truth)) <= 1e-12 * (size + moved + carried)


@settings(deadline=None, max_examples=40)
@given(oscillators, states)
def test_motion_agrees_with_an_integrator(oscillator, initial):
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
    q, q_dot = motion(oscillator, initial, times)
    size = 1 + np.abs(solved.y).max()
    assert np.allclose(np.concatenate([q, q_dot]), solved.y, rtol=0, atol=1e-8 * size)


@settings(deadline=None, max_examples=100)
@given(oscillators, states)
def test_motion_begins_where_it_is_told(oscillator, initial):
    q, q_dot = motion(oscillator, initial, 0.0)
    assert np.allclose(q, [initial.X, initial.phi, initial.Phi], rtol=0, atol=1e-15)
    assert np.allclose(q_dot, [initial.X_dot, initial.phi_dot, initial.Phi_dot], rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("power", [3, 6, 9, 12, 15])
def test_phase_is_right_after_ten_to_the_many_periods(power):
    oscillator = Oscillator(1.3, 0.7, 11.0)
    t = 10.0**power * oscillator.period * 1.23456789012
    q, _ = motion(oscillator, released(oscillator, 0.08), t)
    exact = exact_state(oscillator, released(oscillator, 0.08), t)
    assert abs(float(mpmath.mpf(float(q[1])) - exact[1])) < 1e-15
    # Negative control: the plain product loses the phase.
    plain = 0.08 / 0.2 * math.cos(oscillator.natural_frequency * t)
    assert power < 9 or abs(plain - float(exact[1])) > 1e-9


def test_release_sets_the_rollers_by_half_the_compression():
    oscillator = Oscillator(radius=0.25)
    assert released(oscillator, 0.1) == InitialState(phi=0.2)


@pytest.mark.parametrize("shape", [(), (5,), (2, 3)])
def test_shapes(shape):
    q, q_dot = motion(Oscillator(), InitialState(phi=0.1), np.ones(shape))
    assert q.shape == q_dot.shape == (3, *shape)


@pytest.mark.parametrize("field", ["X", "phi", "Phi", "X_dot", "phi_dot", "Phi_dot"])
@pytest.mark.parametrize("bad", [math.nan, math.inf, "0", None])
def test_a_bad_initial_value_is_refused_by_name(field, bad):
    with pytest.raises(ValueError, match=rf"^{field} must be"):
        InitialState(**{field: bad})


@pytest.mark.parametrize("bad", [math.nan, [0, math.inf], "soon", None])
def test_a_bad_time_is_refused(bad):
    with pytest.raises(ValueError, match=r"^t must be"):
        motion(Oscillator(), InitialState(), bad)


def test_a_bad_compression_is_refused():
    with pytest.raises(ValueError, match=r"^compression must be"):
        released(Oscillator(), math.nan)
