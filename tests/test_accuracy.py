"""The experiments: their errors against theory and exact arithmetic, their conduct as pieces, the command line."""

import csv
import io
import math
import re
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.accuracy import (
    FORMS,
    SOLVERS,
    Piece,
    arithmetics,
    caching,
    cheapest,
    closed_form,
    curve_sampling,
    eigen_solvers,
    error_history,
    extremes,
    measure,
    phase_errors,
    results,
    runs,
    work_precision,
)
from ramanujan.accuracy.__main__ import main
from ramanujan.integrators import METHODS

MACHINE = Oscillator(m=1.3, m_prime=0.7, k=40.0)


@pytest.fixture(scope="module")
def curves():
    """A small diagram of all methods: {(method, dtype): curve}."""
    found = results(work_precision(MACHINE, periods=10, steps_per_period=(64, 16, 32)))
    return {(curve.method, curve.dtype): curve for curve in found}


def test_diagram_is_complete_and_in_ascending_order(curves):
    assert set(curves) == {(method, dtype) for method in METHODS for dtype in ("float32", "float64")}
    for curve in curves.values():
        assert curve.steps_per_period.tolist() == [16, 32, 64]
        assert np.all((curve.seconds_low > 0) & (curve.seconds_low <= curve.seconds))
        assert np.all(curve.seconds <= curve.seconds_high)


@pytest.mark.parametrize("method", METHODS)
def test_evaluations_are_counted_where_they_happen(monkeypatch, method):
    calls = []
    make = runs._harmonic

    def counted(*given):
        harmonic = make(*given)
        return lambda q: calls.append(np.size(q)) or harmonic(q)

    monkeypatch.setattr(runs, "_harmonic", counted)
    # More steps than fit into one block of work: the force at a step's end still serves the next step.
    history = results(error_history(MACHINE, method, 100, 50))[0]
    assert history.evaluations == len(calls)
    first_step = method in ("velocity_verlet", "yoshida4", "yoshida6")
    assert len(calls) == 5000 * METHODS[method].evaluations + first_step
    curve = results(work_precision(MACHINE, 50, [7, 100], [method], ["float64"]))[0]
    assert curve.evaluations.tolist() == [n * METHODS[method].evaluations + first_step for n in (350, 5000)]
    # By itself a run is stepped in plain floats, in the diagram beside others in an array: the same to the last bit.
    assert (curve.phase_error[1], curve.energy_error[1]) == (history.phase_error[-1], history.energy_error[-1])


# Numeric minus exact phase per radian for small z = hΩ: the leading term of each method's expansion.
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
def test_phase_error_is_what_theory_says(curves, method):
    curve = curves[method, "float64"]
    z = 2 * np.pi / curve.steps_per_period
    # At n = 64, z = 0.1; the next term is about z² smaller than the first.
    assert curve.phase_error[-1] == pytest.approx(20 * np.pi * PHASE_ERROR[method](z[-1]), rel=0.02)


@pytest.mark.parametrize(
    ("method", "growth_per_step"),
    [("explicit_euler", lambda z: 1 + z**2), ("rk4", lambda z: 1 - z**6 / 72 + z**8 / 576)],
)
def test_energy_error_is_what_theory_says(curves, method, growth_per_step):
    curve = curves[method, "float64"]
    n = curve.steps_per_period
    expected = growth_per_step(2 * np.pi / n) ** (10 * n) - 1
    np.testing.assert_allclose(curve.energy_error, expected, rtol=1e-6)  # rounding: 640 steps against 1e-5
    np.testing.assert_allclose(curve.largest_energy_error, abs(expected), rtol=1e-6)


@pytest.mark.parametrize("method", METHODS)
def test_state_error_is_the_error_of_a_plain_loop(curves, method):
    omega, h = MACHINE.natural_frequency, MACHINE.period / 32
    q, v = 1.0, 0.0
    for _ in range(320):
        q, v = METHODS[method].step(lambda q: -(omega**2) * q, q, v, h)
    expected = math.hypot(q - 1, v / omega)
    assert curves[method, "float64"].state_error[1] == pytest.approx(expected, rel=1e-6, abs=1e-12)


def test_float32_is_coarser_where_rounding_rules(curves):
    fine = {dtype: curves["yoshida6", dtype].state_error[-1] for dtype in ("float32", "float64")}
    assert fine["float32"] > 1e-6 > fine["float64"]


def test_steps_that_do_not_divide_a_block_and_single_runs_agree():
    together = results(work_precision(MACHINE, 7, (11, 100, 257), ["rk4"], ["float64"]))[0]
    for i, n in enumerate((11, 100, 257)):
        alone = results(work_precision(MACHINE, 7, [n], ["rk4"], ["float64"]))[0]
        for field in ("state_error", "phase_error", "energy_error", "largest_energy_error"):
            assert getattr(together, field)[i] == getattr(alone, field)[0]


def test_a_run_that_blows_up_is_a_result():
    curve = results(work_precision(Oscillator(), 1000, [6], ["explicit_euler"], ["float32"]))[0]
    assert not np.isfinite(curve.state_error[0])
    assert cheapest([curve], 1e9) == []


def test_history_ends_where_the_diagram_ends(curves):
    history = results(error_history(MACHINE, "velocity_verlet", 32, 10))[0]
    curve = curves["velocity_verlet", "float64"]
    assert history.t.shape == history.q.shape == history.q_exact.shape == (321,)
    assert (history.t[0], history.q[0], history.phase_error[0]) == (0, 1, 0)
    assert history.t[-1] == pytest.approx(10 * MACHINE.period, rel=1e-15)
    assert history.phase_error[-1] == curve.phase_error[1]
    assert abs(history.energy_error).max() == curve.largest_energy_error[1]
    np.testing.assert_allclose(history.q_exact, np.cos(MACHINE.natural_frequency * history.t), atol=1e-13)
    thinned = results(error_history(MACHINE, "velocity_verlet", 32, 10, every=7))[0]
    np.testing.assert_array_equal(thinned.phase_error, history.phase_error[::7])


def test_cheapest_is_sorted_and_within_the_tolerance(curves):
    choices = cheapest(curves.values(), 1e-2)
    assert choices
    assert [c.evaluations for c in choices] == sorted(c.evaluations for c in choices)
    assert all(c.state_error <= 1e-2 for c in choices)
    by_seconds = cheapest(curves.values(), 1e-2, by="seconds")
    assert [c.seconds for c in by_seconds] == sorted(c.seconds for c in by_seconds)
    assert not any(c.method == "explicit_euler" for c in choices)
    assert cheapest(curves.values(), 1e-30) == []


def test_cheapest_is_not_taken_in_by_a_run_that_is_late_by_a_whole_turn(curves):
    curve = curves["velocity_verlet", "float64"]
    late = replace(curve, state_error=curve.state_error * 0, phase_error=curve.phase_error * 0 + 2 * np.pi)
    assert cheapest([late], 0.1) == []
    assert cheapest([replace(late, phase_error=curve.phase_error * 0)], 0.1) != []


@pytest.mark.parametrize(
    "make",
    [
        lambda: work_precision(MACHINE, 5, (8, 700), ["rk4", "yoshida4"]),
        lambda: error_history(MACHINE, "rk4", 300, 5),
        lambda: extremes(["paper", "scaled"]),
        lambda: eigen_solvers(),
        lambda: phase_errors(MACHINE, 3),
        lambda: curve_sampling((9, 17)),
        lambda: closed_form(MACHINE, (1, 2)),
        lambda: arithmetics(),
        lambda: caching(MACHINE),
    ],
)
def test_every_experiment_comes_in_pieces(make):
    pieces = list(make())
    assert all(isinstance(piece, Piece) for piece in pieces)
    done = [float(piece.done) for piece in pieces]
    assert done == sorted(done)
    assert 0 < done[0] < done[-1] == pytest.approx(1)
    assert pieces[-1].result is not None
    # Whoever watches may leave at any time.
    interrupted = make()
    next(interrupted)
    interrupted.close() if hasattr(interrupted, "close") else None


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda: work_precision(MACHINE, 0), "periods"),
        (lambda: work_precision(MACHINE, 2.5), "periods"),
        (lambda: work_precision(MACHINE, "many"), "periods"),
        (lambda: work_precision(MACHINE, math.inf), "periods"),
        (lambda: work_precision(MACHINE, 10, [2]), "steps_per_period"),
        (lambda: work_precision(MACHINE, 10, []), "steps_per_period"),
        (lambda: work_precision(MACHINE, 10**6, [10**6]), "steps_per_period"),
        (lambda: work_precision(MACHINE, methods=["magic"]), "methods"),
        (lambda: work_precision(MACHINE, dtypes=["float16"]), "dtypes"),
        (lambda: error_history(MACHINE, "magic", 10, 10), "method"),
        (lambda: error_history(MACHINE, "rk4", 10, 10, dtype="int"), "dtype"),
        (lambda: error_history(MACHINE, "rk4", 10, 10, every=0), "every"),
        (lambda: cheapest([], 0), "tolerance"),
        (lambda: cheapest([], math.nan), "tolerance"),
        (lambda: cheapest([], 1, by="beauty"), "by"),
        (lambda: extremes(["magic"]), "forms"),
        (lambda: extremes(dtypes=["float16"]), "dtypes"),
        (lambda: extremes(samples_per_decade=0), "samples_per_decade"),
        (lambda: eigen_solvers(samples_per_decade=10**6), "samples_per_decade"),
        (lambda: phase_errors(MACHINE, 16), "largest_decade"),
        (lambda: phase_errors(MACHINE, 3, 0), "samples"),
        (lambda: curve_sampling((1,)), "points"),
        (lambda: curve_sampling(height=0), "height"),
        (lambda: closed_form(MACHINE, [0]), "periods"),
        (lambda: arithmetics(-1.0), "mass_ratio"),
        (lambda: arithmetics(1.0, [0]), "digits"),
    ],
)
def test_bad_arguments_are_named_at_once(call, name):
    with pytest.raises(ValueError, match=rf"^{name} must"):
        call()


@cache
def all_sweeps():
    return {(s.form, s.dtype, s.along): s for s in results(extremes(samples_per_decade=2))}


@pytest.fixture
def sweeps():
    return all_sweeps()


@pytest.mark.parametrize("form", ["scaled", "effective_mass", "partial_fractions"])
@pytest.mark.parametrize("dtype", ["float32", "float64"])
@pytest.mark.parametrize("along", ["ratio", "scale"])
def test_good_forms_are_right_everywhere(sweeps, form, dtype, along):
    sweep = sweeps[form, dtype, along]
    assert set(sweep.verdict) == {"right"}
    assert len(sweep.stretches) == 1
    assert sweep.value.dtype == dtype


@pytest.mark.parametrize(("dtype", "decades"), [("float64", 300), ("float32", 37)])
def test_the_sweeps_span_the_range(sweeps, dtype, decades):
    x = sweeps["paper", dtype, "scale"].x
    assert (x[0], x[-1]) == (np.dtype(dtype).type(10.0**-decades), np.dtype(dtype).type(10.0**decades))
    assert np.all(np.diff(x.astype(float)) > 0)


def test_the_papers_form_fails_as_the_exponent_range_says(sweeps):
    first, *_, last = sweeps["paper", "float64", "scale"].stretches
    # (m + m′)² = 4s² and below half the smallest subnormal it is 0: 8k/(15m) is left, which looks like an answer.
    assert first.verdict == "plausible"
    assert first.first_value == pytest.approx(8 / 15, rel=1e-12)
    assert 1e-163 < first.last < 1e-161
    # 8(m + m′)² = 32s² overflows from s = √(max/32) = 2.4e153 or, (m + m′)² first, 6.7e153 on.
    assert last.verdict == "zero"
    assert math.copysign(1, last.last_value) == -1
    assert 2e153 < last.first < 2e154
    assert [s.verdict for s in sweeps["paper", "float64", "ratio"].stretches] == ["right", "zero"]
    assert 1e18 < sweeps["paper", "float32", "scale"].stretches[-1].first < 2e19


def test_two_polynomials_overflow_to_nan_and_divide_by_zero(sweeps):
    stretches = sweeps["polynomial", "float64", "scale"].stretches
    assert stretches[0].verdict == stretches[-1].verdict == "overflow"
    assert "right" in [s.verdict for s in stretches]


@settings(deadline=None, max_examples=60)
@given(form=st.sampled_from(sorted(FORMS)), sample=st.integers(0, 1200), along=st.sampled_from(["ratio", "scale"]))
def test_errors_agree_with_exact_fractions(form, sample, along):
    sweep = all_sweeps()[form, "float64", along]
    x = Fraction(float(sweep.x[sample]))
    m, mp, k = (1, x, 1) if along == "ratio" else (x, x, x)
    exact = 8 * k / (7 * mp + 8 * m - 8 * (mp + m) ** 2 / (Fraction(7, 3) * m + 2 * mp))
    if np.isfinite(sweep.value[sample]):
        error = abs(Fraction(float(sweep.value[sample])) - exact) / Fraction(float(np.spacing(float(exact))))
        assert sweep.error_ulp[sample] == pytest.approx(float(error), rel=1e-9)
        assert (sweep.verdict[sample] == "right") == (error <= 4)
    else:
        assert sweep.verdict[sample] == "overflow"


def test_eigen_solvers_find_the_mode_but_not_two_zeros():
    found = {(s.solver, s.dtype): s for s in results(eigen_solvers())}
    assert {solver for solver, _ in found} == set(SOLVERS)
    for sweep in found.values():
        assert np.nanmax(sweep.error_ulp) < 32  # a 3×3 solver's dozens of operations
        assert sweep.zero_modes.shape == (sweep.mass_ratio.size, 2)
    assert found["eigh_cholesky", "float64"].without_frequency.any()
    assert found["eigvals_ground", "float64"].without_frequency.any()
    # Negative control: with two zero columns in K the zero modes are exact, so the failures are the coordinates'.
    assert not found["eigvals", "float64"].without_frequency.any()


@pytest.mark.parametrize("machine", [MACHINE, Oscillator(), Oscillator(m=3.0, m_prime=1e-3, k=1e6)])
def test_phase_errors(machine):
    rows = results(phase_errors(machine))
    assert [row.periods for row in rows] == [10.0**decade for decade in range(16)]
    for row in rows:
        # cos and sin of the reduced phase are each good to an ulp or so of 1.
        assert row.reduced < 1e-15
        # Ω is good to about 2 ulp and t·Ω to half an ulp: at most 3·2⁻⁵³·2πn; on the circle never beyond π.
        assert row.float64 <= min(2 * np.pi * (row.periods + 1) * 3 * 2.0**-53 + 1e-15, np.pi)
        assert row.float32 <= np.pi
    # Negative control: the plain product does lose its digits.
    assert rows[12].float64 > 1e-5
    assert rows[6].float32 > 1e-3


def test_chords_of_a_cosine_miss_it_by_what_geometry_says():
    for sampling in results(curve_sampling((17, 65, 257), height=300)):
        if sampling.curve == "cosine":
            # An arc's chord under the crest: 1 − cos of half a step, times half the height; off the crest a bit less.
            most = (1 - math.cos(math.pi / (sampling.points - 1))) * 150
            assert 0.95 * most < sampling.pixels <= most * (1 + 1e-9)
        assert sampling.bytes == 16 * sampling.points


def test_more_points_miss_less():
    for name in ("cosine", "frequency"):
        pixels = [s.pixels for s in results(curve_sampling((5, 9, 17, 33, 65))) if s.curve == name]
        assert pixels == sorted(pixels, reverse=True)
        assert pixels[-2] / pixels[-1] == pytest.approx(4, rel=0.1)  # chords are of second order


def test_closed_form_does_not_lose_digits():
    rows = results(closed_form(MACHINE, (1, 1000, 10**12)))
    assert [row.periods for row in rows] == [1, 1000, 10**12]
    assert all(row.phase_error < 1e-15 for row in rows)


def test_arithmetics_have_the_error_of_their_digits():
    rows = {(row.kind, row.digits): row for row in results(arithmetics(1 / 3, (20, 40)))}
    assert rows["fraction", None].relative_error == 0
    assert 1e-9 < rows["float32", None].relative_error < 4 * 2.0**-23
    assert 0 < rows["float64", None].relative_error < 4 * 2.0**-52
    for digits in (20, 40):
        assert 0 < rows["mpmath", digits].relative_error < 10.0 ** (1 - digits)


def test_comparisons_and_timings_are_ordered():
    for row in results(caching(MACHINE)):
        assert row.ratio == row.slow_seconds.median / row.fast_seconds.median
    calls = []
    timing = measure(lambda: calls.append(1), repeats=3, shortest=1e-5)
    assert len(calls) > 3
    assert 0 < timing.low <= timing.median <= timing.high


def test_names_are_short_ids_and_not_words():
    named = {*FORMS, *SOLVERS, *METHODS}
    named |= {name for sweep in all_sweeps().values() for name in (sweep.form, sweep.along, *sweep.verdict)}
    named |= {row.kind for row in results(arithmetics())} | {row.name for row in results(caching(MACHINE))}
    named |= {row.curve for row in results(curve_sampling((9,)))}
    assert {name for name in named if not re.fullmatch(r"[a-z][a-z0-9_]{2,20}", name)} == set()


def rows_of(text):
    return list(csv.reader(io.StringIO(text)))


def test_command_line_prints_every_table(capsys):
    assert main(["--periods", "2", "--steps", "8", "16", "--dtype", "float64", "--tolerance", "0.5"]) == 0
    out = capsys.readouterr().out
    for words in (
        "after 2 periods",
        "fewest evaluations",
        "Fastest run",
        "Points of a curve",
        "Closed form",
        "Forms of Ω²",
        "Phase error",
        "eigh after a Cholesky factorization",
        "mpmath, 30 digits",
        "100 states in one call",
    ):
        assert words in out
    for method in METHODS.values():
        assert method.title in out
    assert "float32 " not in out.split("Points of a curve")[0]


def test_csv_carries_every_digit(capsys):
    assert main(["--experiment", "work-precision", "--periods", "3", "--steps", "10", "--csv"]) == 0
    header, *rows = rows_of(capsys.readouterr().out)
    assert header[:4] == ["table", "method", "dtype", "steps per period"]
    found = next(row for row in rows if row[1] == "velocity Verlet" and row[2] == "float64")
    expected = results(work_precision(Oscillator(), 3, [10], ["velocity_verlet"], ["float64"]))[0]
    assert float(found[header.index("state error")]) == expected.state_error[0]


@pytest.mark.parametrize(
    "arguments",
    [
        ["--periods", "x"],
        ["--periods", "0"],
        ["--steps", "2", "--experiment", "work-precision"],
        ["--tolerance", "nan", "--experiment", "work-precision"],
        ["--experiment", "magic"],
        ["--dtype", "float16"],
        ["--m", "-1"],
        ["--unknown"],
    ],
)
def test_bad_arguments_get_one_sentence_and_status_2(arguments, capsys):
    with pytest.raises(SystemExit) as exit_:
        main(arguments)
    assert exit_.value.code == 2
    message = capsys.readouterr().err
    assert message.startswith("Error: ")
    assert message.endswith(".\n")
    assert message.count("\n") == 1


def test_module_runs_as_a_program():
    done = subprocess.run(
        [sys.executable, "-m", "ramanujan.accuracy", "--help"], capture_output=True, text=True, check=True
    )
    assert "--experiment" in done.stdout
    assert "--csv" in done.stdout


def test_interrupting_a_long_run_costs_nothing():
    # Ten million steps would take minutes; three pieces of it do not.
    pieces = work_precision(MACHINE, 100_000, [100], ["yoshida6"], ["float64"])
    assert [piece.result for piece in islice(pieces, 3)] == [None] * 3
