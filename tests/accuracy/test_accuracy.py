"""The experiments: their errors, compared with theory and exact arithmetic."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.accuracy.arithmetics import measure_arithmetics
from ramanujan.accuracy.digits import DIGITS, EXPERIMENTS, compare
from ramanujan.accuracy.extremes import FORMS, sweep_forms
from ramanujan.accuracy.general_solvers import SOLVERS, sweep_solvers
from ramanujan.accuracy.measurement import measure
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.runs import error_history, seconds_per_step
from ramanujan.accuracy.work_precision import find_cheapest_runs, work_precision
from ramanujan.physics.integrators import METHODS, trajectory
from ramanujan.physics.motion import InitialState, motion
from tests.checks.reference import frequency_squared

pytestmark = pytest.mark.xdist_group("accuracy")

MACHINE = Oscillator(m=1.3, m_prime=0.7, k=40.0)


MACHINES = [
    Oscillator(m=1, m_prime=1.13, k=10),
    Oscillator(m=4.2, m_prime=0.3, k=77),
    Oscillator(m=5, m_prime=5, k=1),
    Oscillator(m=0.5, m_prime=0.1, k=100),
]


@pytest.fixture(scope="module")
def curves():
    """Return (method, dtype) → work-precision curve over ten periods."""
    pairs = [(method, dtype) for method in METHODS for dtype in ("float64", "float32")]
    return {pair: work_precision(*pair, periods=10) for pair in pairs}


def integrated(machine, method, steps, periods, kind):
    """Return φ/φ₀ and φ̇/(φ₀Ω) of a machine at every step, integrated in SI units."""
    squared = kind(machine.natural_frequency_squared)
    start = np.full(1, 0.03, kind), np.zeros(1, kind)
    states = trajectory(METHODS[method], lambda q: -squared * q, *start, np.full(1, machine.period / steps, kind))
    q, v = np.array([*islice(states, steps * periods)], dtype=float)[..., 0].T / float(start[0][0])
    return q, v / machine.natural_frequency


@pytest.mark.parametrize("dtype", ["float64", "float32"])
@pytest.mark.parametrize("method", METHODS)
def test_every_machine_has_the_same_errors(curves, method, dtype):
    steps, kind = 17, np.dtype(dtype).type
    t = 2 * np.pi * np.arange(1, 10 * steps + 1) / steps
    history, curve = error_history(method, steps, 10), curves[method, dtype]
    # Each of a few thousand rounding errors is at most half an ulp. That of hΩ occurs in every step.
    rounding = 4000 * np.finfo(kind).eps
    for machine in MACHINES:
        q, v = integrated(machine, method, steps, 10, kind)
        scale = 1 + np.hypot(q, v)
        # The history is in float64. It agrees with a run in either precision within the rounding of the latter.
        assert np.all(abs(history.q[1:] - q) <= rounding * scale)
        assert np.all(abs(history.energy_error[1:] - (q * q + v * v - 1)) <= 3 * rounding * scale**2)
        largest = abs(np.angle((q - 1j * v) * np.exp(-1j * t))).max() / (2 * np.pi)
        if np.hypot(q, v).max() > 2:
            largest = 0.5
        error = curve.error[curve.steps_per_period == steps].item()
        # The curve contains the largest error among all machines.
        assert largest * (1 - 1e-12) - rounding / 50 <= error <= largest + rounding * scale.max()


def fewest_steps(machine, method, periods, tolerance):
    """Return the fewest steps per period with an error within the tolerance at every step, from 3 to 192."""
    n, (omega, T) = np.arange(3, 193), (machine.natural_frequency, machine.period)
    step = METHODS[method].step
    # A step is linear in (q, v), so its effect on the states (1, 0) and (0, 1) determines it.
    step_of_q, step_of_v = (
        np.array(step(lambda q: -(omega**2) * q, *state, T / n)) for state in ((1.0, 0.0), (0.0, 1.0))
    )
    q, v, worst = np.ones(n.size), np.zeros(n.size), np.zeros(n.size)
    for i in range(1, n[-1] * periods + 1):
        with np.errstate(all="ignore"):
            q, v = q * step_of_q + v * step_of_v
            turns = abs(np.angle((q - 1j * v / omega) * np.exp(-2j * np.pi * i / n))) / (2 * np.pi)
            error = np.where(np.hypot(q, v / omega) < 2, turns, 0.5)
            worst = np.where(i <= n * periods, np.maximum(worst, error), worst)
    return int(n[worst <= tolerance][0]) if (worst <= tolerance).any() else None


@pytest.mark.parametrize(("periods", "tolerance"), [(10, 0.01), (10, 1e-7), (1, 1e-4)])
def test_no_other_whole_number_of_steps_is_cheaper(periods, tolerance):
    machine = Oscillator(k=10.0)
    fewest = {method: fewest_steps(machine, method, periods, tolerance) for method in METHODS}
    fewest = {method: steps for method, steps in fewest.items() if steps}
    choices = find_cheapest_runs([work_precision(method, periods=periods) for method in METHODS], tolerance)
    assert {choice.method: choice.steps_per_period for choice in choices} == fewest
    costs = {method: count_calls(method, steps * periods) for method, steps in fewest.items()}
    assert (choices[0].method, choices[0].evaluations) == min(costs.items(), key=lambda cost: cost[1])


def count_calls(method, steps):
    """Return the number of calls of the acceleration in a run."""
    calls = []
    states = trajectory(METHODS[method], lambda q: calls.append(q) or -q, 1.0, 0.0, 0.1)
    next(islice(states, steps - 1, None))
    return len(calls)


@pytest.mark.parametrize("method", METHODS)
def test_evaluations_are_those_of_a_whole_run(method):
    assert work_precision(method, periods=5, steps_per_period=[7, 60]).evaluations.tolist() == [
        count_calls(method, 35),
        count_calls(method, 300),
    ]
    assert error_history(method, 60, 5).evaluations == count_calls(method, 300)


@pytest.mark.parametrize("method", sorted(METHODS.keys() - {"explicit_euler"}))
def test_the_angle_to_the_exact_motion_is_that_of_a_single_run(method):
    errors = work_precision(method, periods=5, steps_per_period=[9, 30]).error
    for n, error in zip((9, 30), errors, strict=True):
        phases = error_history(method, n, 5).phase_error
        assert error == pytest.approx(np.abs((phases + np.pi) % (2 * np.pi) - np.pi).max() / (2 * np.pi), rel=1e-9)


# Leading term of the phase error per radian, for small z = hΩ.
PHASE_ERROR = {
    "explicit_euler": lambda z: -(z**2) / 3,
    "symplectic_euler": lambda z: z**2 / 24,
    "velocity_verlet": lambda z: z**2 / 24,
    "implicit_midpoint": lambda z: -(z**2) / 12,
    "rk4": lambda z: -(z**4) / 120,
    "yoshida4": lambda z: -0.06614 * z**4,
    "yoshida6": lambda z: 0.003768 * z**6,
}


@pytest.mark.parametrize("method", METHODS)
def test_phase_error_agrees_with_theory(method):
    # At n = 64, z ≈ 0.1. The next term is smaller by a factor of about z² = 0.01.
    expected = 20 * np.pi * PHASE_ERROR[method](2 * np.pi / 64)
    assert error_history(method, 64, 10).phase_error[-1] == pytest.approx(expected, rel=0.02)


def test_a_run_whose_amplitude_grows_is_half_a_turn_off():
    # With 192 steps the angle of explicit Euler is 0.0107 turns, but its amplitude grows to (1 + z²)^(15·192) = 22.
    assert work_precision("explicit_euler").error.tolist() == [0.5] * 190
    # Yoshida 4 is unstable with 3 steps per period and overflows.
    assert work_precision("yoshida4", "float32", 30, [3]).error == 0.5


def test_cheapest_is_sorted_and_within_the_tolerance(curves):
    timed = [replace(curve, step_seconds=seconds_per_step(*pair)) for pair, curve in curves.items()]
    for by in ("evaluations", "seconds"):
        choices = find_cheapest_runs(timed, 1e-2, by)
        assert [getattr(c, by) for c in choices] == sorted(getattr(c, by) for c in choices)
        assert all(0 < c.error <= 1e-2 and c.seconds > 0 for c in choices)
    assert not any(c.method == "explicit_euler" for c in choices)
    assert find_cheapest_runs(timed, 1e-30) == []


@cache
def all_sweeps():
    return {(s.form, s.dtype, s.sweep_name): s for s in sweep_forms()}


@pytest.fixture
def sweeps():
    return all_sweeps()


@pytest.mark.parametrize("form", ["scaled", "effective_mass", "partial_fractions", "integers"])
@pytest.mark.parametrize("dtype", ["float32", "float64"])
@pytest.mark.parametrize("along", ["ratio", "scale"])
def test_good_forms_are_right_everywhere(sweeps, form, dtype, along):
    sweep = sweeps[form, dtype, along]
    assert set(sweep.verdict) == {"right"}
    assert len(sweep.stretches) == 1
    # A float32 result of integers is rounded twice, first to float64.
    assert form != "integers" or sweep.worst_right_ulp <= 0.5 + 1e-6
    assert sweep.value.dtype == dtype


def test_the_papers_form_fails_where_the_exponent_range_ends(sweeps):
    first, *_, last = sweeps["paper", "float64", "scale"].stretches
    # If (m + m′)² = 4s² underflows to 0, the result is 8k/(15m) = 8/15, which is plausible but wrong.
    assert first.verdict == "wrong"
    assert sweeps["paper", "float64", "scale"].value[0] == pytest.approx(8 / 15, rel=1e-12)
    assert 1e-163 < first.last < 1e-161
    # 8(m + m′)² = 32s² overflows for s > √(max/32) = 2.4e153, and (m + m′)² for s > 6.7e153.
    assert last.verdict == "zero"
    assert math.copysign(1, sweeps["paper", "float64", "scale"].value[-1]) == -1
    assert 2e153 < last.first < 2e154
    assert [s.verdict for s in sweeps["paper", "float64", "ratio"].stretches] == ["right", "zero"]
    assert 1e18 < sweeps["paper", "float32", "scale"].stretches[-1].first < 2e19


@settings(deadline=None, max_examples=60)
@given(form=st.sampled_from(sorted(FORMS)), sample=st.integers(0, 1800), along=st.sampled_from(["ratio", "scale"]))
def test_errors_agree_with_exact_fractions(form, sample, along):
    sweep = all_sweeps()[form, "float64", along]
    x = Fraction(float(sweep.x[sample]))
    m, mp, k = (1, x, 1) if along == "ratio" else (x, x, x)
    exact = frequency_squared(m, mp, k)
    if np.isfinite(sweep.value[sample]):
        error = abs(Fraction(float(sweep.value[sample])) - exact) / Fraction(float(np.spacing(float(exact))))
        assert sweep.error_ulp[sample] == pytest.approx(float(error), rel=1e-9)
        assert (sweep.verdict[sample] == "right") == (error <= 4)
    else:
        assert sweep.verdict[sample] == "overflow"


def test_eigen_solvers_find_the_mode_but_not_two_zeros():
    results = {(s.solver, s.dtype): s for s in sweep_solvers()}
    assert {solver for solver, _ in results} == set(SOLVERS)
    for sweep in results.values():
        assert np.nanmax(sweep.error_ulp) < 32  # a solver for 3×3 matrices uses dozens of operations
        assert sweep.zero_modes.shape == (sweep.mass_ratio.size, 2)
    assert results["eigh_cholesky", "float64"].lacks_real_frequency.any()
    assert results["eigvals_ground", "float64"].lacks_real_frequency.any()
    # Negative control: with two zero columns in K the zero modes are exact, so the coordinates cause the failures.
    assert not results["eigvals", "float64"].lacks_real_frequency.any()


@pytest.mark.parametrize("machine", [MACHINE, Oscillator(), Oscillator(m=3.0, m_prime=1e-3, k=1e6)])
def test_phase_errors(machine):
    rows = phase_errors(machine)
    assert [row.periods for row in rows] == [10.0**decade for decade in range(16)]
    for row in rows:
        # Ω/2π has 106 bits, and a phase of at most π is rounded once.
        assert row.reduced < 1e-15
        # The error of Ω is about 3 ulp and that of t·Ω half an ulp, together at most 4·2⁻⁵²·2πn. No angle exceeds π.
        assert row.float64 <= min(2 * np.pi * (row.periods + 1) * 4 * 2.0**-52 + 1e-15, np.pi)
        assert row.float32 <= np.pi
    # Negative control: the plain product loses digits.
    assert rows[12].float64 > 1e-5
    assert rows[6].float32 > 1e-3


def test_errors_of_the_arithmetics_are_those_of_their_rounding():
    errors = {name: price.error for name, price in measure_arithmetics().items()}
    assert errors["fractions"] == 0
    assert 0 < errors["digits"] < 1e-49
    # Rounding to the nearest float changes a number by at most half an epsilon.
    assert 0 < errors["integers"] <= 2.0**-53
    assert errors["integers"] < errors["float64"] < 4 * 2.0**-52
    assert 2.0**-24 < errors["float32"] < 4 * 2.0**-23


def test_a_duration_is_measured_by_several_calls():
    calls = []
    seconds = measure(lambda: calls.append(1))
    assert len(calls) > 3
    assert seconds > 0


def test_only_the_plain_formula_loses_digits_and_the_other_one_is_that_of_the_core():
    for experiment in EXPERIMENTS:
        samples = compare(experiment)
        assert {sample.used.digits for sample in samples} == {DIGITS}
        assert min(sample.plain.digits for sample in samples) == 0 < DIGITS == max(s.plain.digits for s in samples)
        for sample in samples:
            # A value with n correct digits rounds to the same n digits as the exact one, or to neighbours.
            for digits, value in ((sample.plain.digits, sample.plain.value), (DIGITS, sample.used.value)):
                if digits:
                    assert abs(Fraction(value) - _fraction(sample.truth)) <= _fraction(sample.truth) / 10**digits / 2
    # X = κRφ₀(1 − cos Ωt), from X = 0.
    machine = Oscillator()
    samples = compare("time")
    q, _q_dot = motion(machine, InitialState(phi=-1.0), [sample.x * machine.period for sample in samples])
    share = q[0] / (machine.block_coupling * machine.radius)
    np.testing.assert_allclose(share, [sample.used.value for sample in samples], rtol=2e-15)


def _fraction(number) -> Fraction:
    """Return an mpmath number as a fraction."""
    sign, mantissa, exponent, _bits = number._mpf_
    return Fraction(-mantissa if sign else mantissa) * Fraction(2) ** exponent
