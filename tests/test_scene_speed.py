"""Page 5: what it says is what was measured, its work is done in pieces, and it can be left at any time."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import streamlit as st
from hypothesis import given, settings
from hypothesis import strategies as strategy
from streamlit.testing.v1 import AppTest

from ramanujan import Oscillator
from ramanujan.accuracy import Piece, cheapest, extremes, results
from ramanujan.accuracy.work_precision import WorkPrecision
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.motion import motion, released
from ramanujan.numerals import duration, number
from ramanujan.pages.speed import cache, downsampling, experiments, verdicts
from ramanujan.shell import messages, theme
from tests.test_scene_motion import numbers

PAGE = "ramanujan/pages/speed/page.py"
DEFAULTS = (1.0, 1.0, 10.0)
"""m, m′, k as the sliders stand at first."""


def page(app: AppTest, **link: str) -> AppTest:
    """Return page 5 as a link opens it."""
    app.run()
    for key, value in {"periods": "1", **link}.items():
        app.query_params[key] = value
    return app.switch_page(PAGE).run()


def words(app: AppTest) -> str:
    """Return all that the page says."""
    assert not app.exception
    return " ".join(element.value for kind in (app.markdown, app.caption, app.header) for element in kind)


def one_run(method: str, steps: int, periods: int, dtype: str = "float64") -> downsampling.Run:
    return results(downsampling.run_pieces(Oscillator(), method, steps, periods, dtype))[0]


# ---- the page


def test_opens_without_measuring_the_diagram(app):
    page(app)
    assert "How exact does this simulation have to be" in words(app)
    assert cache.diagram(*DEFAULTS, 1).results is None
    assert [button.label for button in app.button if button.key == "measure"] == ["Measure on this server"]


def test_page_is_whole_while_its_first_run_is_still_under_way(app, monkeypatch):
    """On a busy server the run is not over when the page is first drawn."""
    advance, calls = experiments.Job.advance, []

    def slow(job, seconds):
        calls.append(seconds)
        return len(calls) > 1 and advance(job, seconds)

    monkeypatch.setattr(experiments.Job, "advance", slow)
    page(app, method="yoshida4", steps="24", periods="10")
    assert len(calls) > 1
    assert "**Yoshida 4, 24 steps per period, float64**" in words(app)


@pytest.mark.parametrize(
    ("method", "steps", "precision"),
    [("explicit_euler", "3", "float32"), ("velocity_verlet", "3", "float64"), ("yoshida6", "192", "float32")],
)
def test_every_corner_is_shown(app, method, steps, precision):
    page(
        app,
        method=method,
        steps=steps,
        precision=precision,
        periods="30" if steps == "3" else "1",
        sweep="scale_float32",
    )
    assert f"**{METHODS[method].title}, {steps} steps per period, {precision}**" in words(app)
    # hΩ = 2π/3 lies beyond Verlet's limit of 2.
    assert ("**unstable here**" in words(app)) == (method == "velocity_verlet")


def test_phase_error_is_that_of_the_midpoint_rule(app):
    page(app, method="implicit_midpoint", steps="16", periods="10")
    # One step turns by exactly 2·atan(hΩ/2).
    z = 2 * math.pi / 16
    late = abs(160 * (2 * math.atan(z / 2) - z))
    assert f"**{number(late)} rad behind**" in words(app)


def test_bad_link_is_answered_with_a_sentence_and_ignored(app):
    page(app, method="magic", steps="-1", tolerance="nan")
    said = [warning.value for warning in app.warning]
    # Said once, and still there after the page has run itself again to show its experiments.
    assert len(said) == 1
    assert all(f"The value of {key} in the address was ignored" in said[0] for key in ("method", "steps", "tolerance"))
    assert "velocity Verlet, 12 steps per period" in words(app)
    assert not app.run().warning


def test_measures_shares_and_measures_again(app):
    k = 1729 / 10
    page(app)
    app.slider(key="k").set_value(k).run()
    app.button(key="measure").click().run()
    first = cache.diagram(1.0, 1.0, k, 1).results
    curves = [result for result in first if isinstance(result, WorkPrecision)]
    assert len(curves) == 2 * len(METHODS)
    best = cheapest(curves, 1e-3)[0]
    said = words(app)
    assert f"**{METHODS[best.method].title}** in {best.dtype} with **{best.steps_per_period} steps" in said
    assert duration(best.seconds) in said

    # A lower tolerance costs more, and the sentence follows.
    app.select_slider(key="tolerance").set_value(6).run()
    finer = cheapest(curves, 1e-6)[0]
    assert finer.evaluations > best.evaluations
    assert f"with **{finer.steps_per_period} steps" in words(app)

    other = AppTest.from_file(str(app._script_path), default_timeout=60)
    page(other).slider(key="k").set_value(k).run()
    other.select_slider(key="tolerance").set_value(3).run()
    assert duration(best.seconds) in words(other)

    app.button(key="measure").click().run()
    again = cache.diagram(1.0, 1.0, k, 1).results
    assert again is not first
    assert [c.seconds[0] for c in again if isinstance(c, WorkPrecision)] != [c.seconds[0] for c in curves]


def test_says_what_the_paper_form_returns_at_the_edge(app):
    page(app, sweep="scale_float64")
    s = 1e-200
    wrong = 8 * s / (7 * s + 8 * s - 8 * (s + s) ** 2 / (7 * s / 3 + 2 * s))
    right = 8 * (7 + 6) / (18 + 49 + 32)
    assert abs(wrong - right) > 0.1  # the negative control: it is wrong, and plausible
    assert f"a plausible wrong value, such as {number(wrong, 4)}" in words(app)


def test_every_figure_has_a_text_alternative_with_numbers(app):
    page(app, sweep="ratio_float32")
    charts = [element.proto for element in app.get("plotly_chart")]
    assert len(charts) == 3
    for chart in charts:
        assert any(character.isdigit() for character in chart.alt)


# ---- what the stage plays


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("steps", [3, 12, 192])
def test_stage_plays_whole_periods_in_few_bytes(method, steps):
    machine, compression = Oscillator(), 0.12
    run = one_run(method, steps, 10)
    played, first, last, _ = downsampling.samples(run, machine, compression, 0.12)
    assert 0 <= first < last <= 10
    assert len(played["phi"]) == (last - first) * run.per_period + 1
    assert played["step"] * run.per_period == pytest.approx(machine.period)
    numbers = np.array([played[name] for name in ("X", "phi", "Phi")])
    assert np.isfinite(numbers).all()
    # The slab stays in the picture; rounding is to 1e-5 rad.
    assert np.abs(numbers[1]).max() * 2 * machine.radius <= 1.5 * 0.12 + 1e-5
    assert len(json.dumps(played)) < 10_000


def test_a_fine_run_plays_the_exact_motion():
    machine, compression = Oscillator(m_prime=2.0), 0.05
    run = results(downsampling.run_pieces(machine, "yoshida6", 192, 3, "float64"))[0]
    played, first, _, leaves = downsampling.samples(run, machine, compression, 0.12)
    assert (first, leaves) == (0, False)
    times = np.arange(len(played["phi"])) * played["step"]
    q, _ = motion(machine, released(machine, compression), times)
    # Rounded to five digits after the point.
    np.testing.assert_allclose([played[name] for name in ("X", "phi", "Phi")], q, atol=6e-6)


def test_growing_run_is_shown_until_it_leaves():
    run = one_run("explicit_euler", 24, 30)
    _, _, last, leaves = downsampling.samples(run, Oscillator(), 0.08, 0.12)
    assert leaves
    assert last < 30
    _, _, last, leaves = downsampling.samples(one_run("velocity_verlet", 24, 30), Oscillator(), 0.08, 0.12)
    assert (last, leaves) == (30, False)


# ---- pieces


def counted(n: int) -> Iterator[Piece[int]]:
    return (Piece((i + 1) / n, i) for i in range(n))


def test_job_goes_on_where_it_was_left():
    record: experiments.Record[int] = experiments.Record()
    job = experiments.Job(record, counted(5), "counting")
    for done in range(1, 6):
        assert not job.advance(0.0)
        assert len(job.results) == done
        assert record.results is None
    assert job.advance(0.0)
    assert record.results == (0, 1, 2, 3, 4)


def test_two_runs_of_a_page_take_turns_at_one_experiment():
    """A click begins the page anew while its last run still works, in a thread of its own."""

    def slowly() -> Iterator[Piece[int]]:
        for piece in counted(40):
            time.sleep(0.002)
            yield piece

    record: experiments.Record[int] = experiments.Record()
    job = experiments.Job(record, slowly(), "counting")
    with ThreadPoolExecutor(2) as runs:
        ends = [runs.submit(job.advance, 30.0) for _ in range(2)]
        assert all(end.result() for end in ends)
    assert record.results == tuple(range(40))


def test_job_is_not_wanted_once_another_visitor_has_done_it():
    record: experiments.Record[int] = experiments.Record()
    mine, theirs = (experiments.Job(record, counted(2), "counting") for _ in range(2))
    mine.advance(0.0)
    assert mine.wanted
    theirs.advance(10.0)
    assert not mine.wanted
    # To measure again is wanted, though there are results.
    assert experiments.Job(record, counted(2), "counting").wanted


def test_visitors_measure_one_after_the_other_in_the_order_in_which_they_came(monkeypatch):
    line, jobs = experiments.Line(5.0), [experiments.Job(experiments.Record(), counted(2), "") for _ in range(10)]
    assert [len(line.before(job)) for job in jobs] == list(range(10))
    # Whoever asks again keeps the place, in whatever order.
    assert [len(line.before(job)) for job in reversed(jobs)] == list(reversed(range(10)))
    line.leave(jobs[4])
    while not jobs[0].advance(0):
        assert line.before(jobs[1]) == [jobs[0]]
    assert [len(line.before(job)) for job in jobs[1:4] + jobs[5:]] == list(range(8))
    # Who has closed the page is waited for no longer than a moment.
    clock = time.monotonic() + 6.0
    monkeypatch.setattr(experiments.time, "monotonic", lambda: clock)
    assert line.before(jobs[9]) == []


def test_a_visitor_who_has_to_wait_is_told_how_many_come_first(monkeypatch):
    waiting = [experiments.Job(experiments.Record(), counted(2), "") for _ in range(2)]
    told = []
    line = experiments.Line(5.0)
    for job in waiting:
        line.before(job)
    monkeypatch.setattr(experiments, "_MEASURING", line)

    class Place:
        def progress(self, done: float, words: str) -> None:
            told.append(words)
            if len(told) < 3:
                line.leave(waiting[len(told) - 1])

    mine = experiments.Job(experiments.Record(), counted(1), "counting", timed=True)
    monkeypatch.setattr(messages, "run_again", lambda: None)
    experiments.work([("mine", mine, Place())])
    assert [words.partition(".")[0] for words in told] == [
        "2 measurements come before yours",
        "1 measurement comes before yours",
        "counting",
    ]
    assert mine.complete


def test_what_a_class_wants_at_once_one_works_out_and_the_others_watch(monkeypatch):
    monkeypatch.setattr(messages, "run_again", lambda: None)
    record: experiments.Record[int] = experiments.Record()
    worked, told = [], []

    def slowly(visitor: int) -> Iterator[Piece[int]]:
        for piece in counted(40):
            worked.append(visitor)
            time.sleep(0.02)
            yield piece

    class Place:
        def progress(self, done: float, words: str) -> None:
            told.append((done, words))

    jobs = [experiments.Job(record, slowly(visitor), "counting") for visitor in range(5)]
    with ThreadPoolExecutor(5) as visitors:
        list(visitors.map(lambda job: experiments.work([("count", job, Place())]), jobs))
    assert record.results == tuple(range(40))
    assert len(worked) == 40
    assert len(set(worked)) == 1
    # All see the same bar grow.
    assert {words for _, words in told} == {"counting"}
    assert len({done for done, _ in told}) > 3


# ---- words


@settings(deadline=None, max_examples=200)
@given(strategy.floats(1e-300, 1e300), strategy.integers(1, 5))
def test_numbers_say_what_they_are(value, digits):
    superscripts = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    mantissa, times, power = number(value, digits).replace("\u202f", "").partition("×10")
    if not times and any(sign in mantissa for sign in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"):
        mantissa, power = "1", mantissa.removeprefix("10")
    read = float(mantissa) * 10.0 ** int(power.translate(superscripts) or 0)
    # Rounding to n digits moves a number by half a unit of the last one at most.
    assert read == pytest.approx(value, rel=0.51 * 10.0 ** (1 - digits))


@pytest.mark.parametrize(
    ("value", "text"), [(0.0, "0"), (math.inf, "∞"), (math.nan, "not a number"), (-0.5, "−0.50"), (1e15, "10¹⁵")]
)
def test_special_numbers(value, text):
    assert number(value) == text


def test_forms_that_never_fail_are_named_right():
    sweeps = [s for s in results(extremes(samples_per_decade=1)) if (s.along, s.dtype) == ("scale", "float64")]
    sentence = verdicts.where_forms_fail(sweeps, "s")
    right = sentence.splitlines()[-1]
    assert "effective mass" in right
    assert "the paper’s form" not in right


# ---- figures


def test_failures_are_gaps_and_plateaus(app):
    app.run()
    sweeps = [s for s in results(extremes(samples_per_decade=1)) if (s.along, s.dtype) == ("scale", "float64")]
    exponents, truth, forms = downsampling.sweep(sweeps)
    figure = figures.forms(exponents, truth, forms, quantity="s", colors=theme.colors()).checked()
    value, error = (numbers(trace.y) for trace in figure.data if trace.name == "the paper’s form")
    assert np.isnan(value[-1])  # it returns −0 there, which has no logarithm
    assert np.isfinite(value[0])
    assert np.ptp(value[:10]) == 0  # the plateau of the wrong value
    assert error[0] > 14  # ulp of float64 in a relative error near 1: more than 1e14


@pytest.fixture(autouse=True)
def fresh():
    """Every test measures for itself."""
    for record in (cache.run, cache.diagram):
        record.clear()
    yield
    st.cache_data.clear()
