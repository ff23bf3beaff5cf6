"""Properties of the integrators, compared with theory and SciPy: order, stability, area, reversibility, types."""

import math
from itertools import islice

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ramanujan.physics.integrators import METHODS, YOSHIDA_6_WEIGHTS, trajectory

ALL = sorted(METHODS)
REVERSIBLE = ["implicit_midpoint", "velocity_verlet", "yoshida4", "yoshida6"]
SYMPLECTIC = [*REVERSIBLE, "symplectic_euler"]


def harmonic(q):
    return -q


def pendulum(q):
    return -math.sin(q)


def force_for(name):
    """Return a nonlinear acceleration, except for the implicit midpoint method, which requires a linear one."""
    return harmonic if name == "implicit_midpoint" else pendulum


def state_after(name, acceleration, q, v, h, steps):
    """Return the state after a number of steps."""
    return next(islice(trajectory(METHODS[name], acceleration, q, v, h), steps - 1, None))


def step_matrix(name, z):
    """Return the matrix of one step of x″ = −x with hΩ = z."""
    step = METHODS[name].step
    return np.array([step(harmonic, 1.0, 0.0, z), step(harmonic, 0.0, 1.0, z)], dtype=float).T


# With these steps the error of order h^p dominates both rounding and the next order.
STEPS_FOR_ORDER = {1: 800, 2: 100, 4: 80, 6: 60}


@pytest.mark.parametrize("name", ALL)
def test_observed_order(name):
    order, span = METHODS[name].order, 3.0
    # A linear problem would not test all order conditions.
    acceleration = force_for(name)
    exact = solve_ivp(lambda t, y: [y[1], acceleration(y[0])], (0, span), [1.0, 0.5], "DOP853", rtol=1e-13, atol=1e-15)
    exact = exact.y[:, -1]
    n = STEPS_FOR_ORDER[order]
    coarse, fine = (
        np.linalg.norm(np.array(state_after(name, acceleration, 1.0, 0.5, span / steps, steps)) - exact)
        for steps in (n, 2 * n)
    )
    assert math.log2(coarse / fine) == pytest.approx(order, abs=0.1)


def is_stable(name, z):
    """Return whether the powers of the step matrix are bounded, apart from rounding errors."""
    return max(abs(np.linalg.eigvals(step_matrix(name, z)))) < 1 + 1e-6


@pytest.mark.parametrize("name", ALL)
def test_stability_limit(name):
    limit = METHODS[name].stability_limit
    if limit in (0, math.inf):
        assert {is_stable(name, z) for z in np.geomspace(0.01, 1e3, 100)} == {limit == math.inf}
        return
    stable = 0.0
    unstable = next(z for z in np.arange(0.05, 10, 0.05) if not is_stable(name, z))
    while unstable - stable > 1e-9:
        middle = (stable + unstable) / 2
        stable, unstable = (middle, unstable) if is_stable(name, middle) else (stable, middle)
    assert limit == pytest.approx(unstable, rel=1e-6)


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("z", [0.1, 0.9])
def test_symplectic_methods_preserve_area(name, z):
    area = np.linalg.det(step_matrix(name, z))
    if name in SYMPLECTIC:
        assert area == pytest.approx(1, abs=1e-14)  # a few rounding errors
    else:
        assert abs(area - 1) > 1e-9  # RK4 at z = 0.1: z⁶/72 = 1.4e-8


@pytest.mark.parametrize("name", ALL)
def test_reversibility(name):
    q, v = state_after(name, force_for(name), 1.0, 0.3, 0.3, 200)
    q, v = state_after(name, force_for(name), q, v, -0.3, 200)
    distance = math.hypot(q - 1.0, v - 0.3)
    if name in REVERSIBLE:
        assert distance < 1e-12
    else:
        assert distance > 1e-4


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("per_run_step", [True, False])
def test_dtype_and_shape_are_preserved(name, dtype, per_run_step):
    q, v = np.ones((2, 3), dtype), np.zeros((2, 3), dtype)
    h = np.full((2, 3), 0.1, dtype) if per_run_step else 0.1
    for array in (q, v):
        array.flags.writeable = False  # a step function that modifies its arguments fails
    for q_new, v_new in islice(trajectory(METHODS[name], harmonic, q, v, h), 3):
        assert (q_new.dtype, v_new.dtype) == (dtype, dtype)
        assert (q_new.shape, v_new.shape) == ((2, 3), (2, 3))


def test_integer_initial_values_do_not_round_the_time_step():
    states = [
        next(trajectory(METHODS["rk4"], harmonic, np.array(q), np.array(v), np.array([0.1, 0.2])))
        for q, v in (([1, 2], [0, 0]), ([1.0, 2.0], [0.0, 0.0]))
    ]
    assert np.array_equal(*states)


def test_yoshida_6_weights_are_the_root_to_the_last_digit():
    # The conditions are Σw³ = 0, Σw⁵ = 0, and q = sin z up to order z⁵ for x″ = −x with q = 0 and v = 1 at the start.
    z = mpmath.mpf(10) ** -20

    def conditions(*side):
        weights = [*side, 1 - 2 * sum(side), *reversed(side)]
        q, v = mpmath.mpf(0), mpmath.mpf(1)
        for w in weights:
            v -= w * z / 2 * q
            q += w * z * v
            v -= w * z / 2 * q
        return sum(w**3 for w in weights), sum(w**5 for w in weights), (q - mpmath.sin(z)) / z**5

    with mpmath.workdps(160):
        root = mpmath.findroot(conditions, YOSHIDA_6_WEIGHTS[:3], tol=1e-50)
        assert tuple(float(w) for w in root) == YOSHIDA_6_WEIGHTS[:3]


@settings(deadline=None, max_examples=60)
@given(q=st.floats(-2, 2), v=st.floats(-2, 2), h=st.floats(-9, 9), slope=st.floats(-100, 0))
def test_implicit_midpoint_solves_its_equation_for_a_linear_force(q, v, h, slope):
    q_new, v_new = METHODS["implicit_midpoint"].step(lambda x: slope * x, q, v, h)
    middle = (q + q_new) / 2
    scale = 1e-14 * (abs(q) + abs(q_new) + abs(h) * (abs(v) + abs(v_new)))
    subnormal = 1e-300  # products of subnormal numbers lose digits
    assert abs(v_new - v - h * slope * middle) <= 1e-14 * (abs(v) + abs(v_new)) + abs(h * slope) * scale + subnormal
    assert abs(q_new - q - h * (v + v_new) / 2) <= scale * (1 + h * h * abs(slope)) + subnormal
