"""Page 5: its texts agree with the measurements, and its work is divided into interruptible parts."""

import json
import math
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import partial
from itertools import islice

import numpy as np
import plotly.graph_objects as go
import pytest
import streamlit as st
from streamlit.testing.v1 import AppTest

from ramanujan import Oscillator, lesson
from ramanujan.accuracy.exact import frequency_squared
from ramanujan.accuracy.extremes import FORMS, sweep_forms
from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.runs import error_history
from ramanujan.accuracy.work_precision import WorkPrecision, find_cheapest_runs
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS, trajectory
from ramanujan.numerals import duration, number, power_of_ten, unbroken
from ramanujan.pages.speed import cache, costs, downsampling, verdicts
from ramanujan.shell import theme
from ramanujan.shell.cache import responsive
from ramanujan.shell.widgets import escape

PAGE = "ramanujan/pages/speed/page.py"


def page(app: AppTest, **link: str) -> AppTest:
    """Open page 5 by a link."""
    app.run()
    for key, value in {"periods": "1", **link}.items():
        app.query_params[key] = value
    return app.switch_page(PAGE).run()


def words(app: AppTest) -> str:
    """Return all words of the page."""
    assert not app.exception
    return " ".join(element.value for kind in (app.markdown, app.caption, app.header) for element in kind)


def one_run(method: str, steps: int, periods: int, dtype: str = "float64") -> downsampling.SampledRun:
    return downsampling.downsample(error_history(method, steps, periods, dtype), steps, periods)


# ---- the page


def test_the_page_opens_without_measuring_the_diagram(app, monkeypatch):
    monkeypatch.setattr(cache, "work_precision", None)
    page(app)
    assert "How accurate does a simulation have to be" in words(app)
    assert [button.label for button in app.button if button.key == "measure"] == ["Measure on this server"]


@pytest.mark.parametrize(
    ("method", "steps", "precision"),
    [("explicit_euler", "3", "float32"), ("velocity_verlet", "3", "float64"), ("yoshida6", "192", "float32")],
)
def test_the_ends_of_every_option_are_shown(app, method, steps, precision):
    page(
        app,
        method=method,
        steps=steps,
        precision=precision,
        periods="30" if steps == "3" else "1",
        sweep="scale_float32",
    )
    assert f"**{METHODS[method].title}, {steps} steps per period, {precision}:**" in words(app)
    # hΩ = 2π/3 is above Verlet's limit of 2.
    assert ("**unstable here**" in words(app)) == (method == "velocity_verlet")
    if method == "explicit_euler":
        # Each of 90 steps multiplies q² + v² by 1 + (hΩ)².
        assert f"energy grew to **{number((1 + (2 * math.pi / 3) ** 2) ** 90)} times** the true value" in words(app)


def test_phase_error_is_that_of_the_midpoint_rule(app):
    page(app, method="implicit_midpoint", steps="16", periods="10")
    # One step turns by exactly 2·atan(hΩ/2).
    z = 2 * math.pi / 16
    late = abs(160 * (2 * math.atan(z / 2) - z))
    assert f"of a full turn behind** ({number(late)}\u202frad)" in words(app)


def test_measurements_are_shared_and_repeated_on_request(app):
    page(app)
    app.button(key="measure").click().run()
    curves = cache.diagram(1)
    assert len(curves) == 2 * len(METHODS)
    best = find_cheapest_runs(curves, 1e-3)[0]
    text = words(app)
    assert f"**{METHODS[best.method].title}** in {best.dtype} with **{best.steps_per_period} steps" in text
    assert duration(best.seconds) in text

    # A lower tolerance costs more, and the sentence is updated.
    app.select_slider(key="tolerance").set_value("1e-6").run()
    finer = find_cheapest_runs(curves, 1e-6)[0]
    assert finer.evaluations > best.evaluations
    assert f"with **{finer.steps_per_period} steps" in words(app)

    # Another visitor or another machine causes no new measurement.
    other = AppTest.from_file(str(app._script_path), default_timeout=60)
    page(other).slider(key="k").set_value(172.5).run()
    other.select_slider(key="tolerance").set_value("1e-3").run()
    other.button(key="measure").click().run()
    assert duration(best.seconds) in words(other)

    # The second press measures the seconds again.
    [button] = [button for button in app.button if button.label == "Measure again"]
    button.click().run()
    again = cache.diagram(1)
    assert [c.step_timing for c in again] != [c.step_timing for c in curves]
    assert [c.error is old.error for c, old in zip(again, curves, strict=True)] == [True] * len(curves)


def test_measuring_shows_progress_and_can_be_stopped(app, monkeypatch):
    monkeypatch.setattr(costs, "_PATIENCE", -1.0)
    taken = []
    # Streamlit stops the script in this way when the user changes a setting.
    monkeypatch.setattr(cache, "parts_of_diagram", lambda periods: [partial(taken.append, periods), st.stop, st.stop])
    page(app).button(key="measure").click().run()
    assert taken == [1]
    [bar] = app.get("progress")
    assert (bar.proto.value, bar.proto.text) == (33, "Measuring 1 period on this server …")
    # The rest of the page is already complete.
    assert "Extreme times: very many periods" in words(app)
    app.button(key="stop_measuring").click().run()
    assert not app.get("progress")
    assert "Press the button" in words(app)


def test_an_error_that_falls_faster_than_the_order_is_explained(app):
    page(app, periods="30").button(key="measure").click().run()
    largest = []
    for n in (96, 192):
        states = islice(trajectory(METHODS["symplectic_euler"], lambda q: -q, 1.0, 0.0, 2 * math.pi / n), 30 * n)
        t = 2 * np.pi * np.arange(1, 30 * n + 1) / n
        largest.append(np.hypot(*(np.array([*states]).T - (np.cos(t), -np.sin(t)))).max())
    factor = largest[0] / largest[1]
    assert factor > 2.5
    assert "symplectic Euler has order 1, so twice as many steps should divide its error by 2." in words(app)
    assert f"They divide it by {factor:.1f}." in words(app)
    # One step turns by arccos(1 − z²/2), z = hΩ, so its phase error is of order 2.
    assert "They divide that part by 4.0." in words(app)
    # The errors of all other methods agree with their order; in one period, this one's too.
    assert words(app).count("has order") == 2  # the other sentence is about the selected method
    app.select_slider(key="periods").set_value(1).run()
    assert "twice as many steps" not in words(app)


def test_the_result_of_the_papers_form_at_the_edge_is_stated(app):
    page(app, sweep="scale_float64")
    s = 1e-200
    wrong = 8 * s / (7 * s + 8 * s - 8 * (s + s) ** 2 / (7 * s / 3 + 2 * s))
    right = 8 * (7 + 6) / (18 + 49 + 32)
    assert abs(wrong - right) > 0.1  # negative control: a wrong but plausible value
    assert f"the paper’s form | s from {number(1e-300)} to " in words(app)
    assert f"| {number(wrong, 4)}: wrong" in words(app)
    assert "effective mass | nowhere" in words(app)


# ---- the motion on the stage


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("steps", [3, 12, 192])
def test_the_stage_plays_a_run_in_few_bytes_with_its_cost(method, steps):
    history, run = error_history(method, steps, 30), one_run(method, steps, 30)
    played = downsampling.stage_payload(run)
    q, every = np.array(played["q"]), steps // played["per_period"]
    inside = abs(history.q[::every]) < downsampling.ROOM
    np.testing.assert_allclose(q[inside], history.q[::every][inside], atol=6e-5)
    assert abs(q).max() <= downsampling.ROOM
    assert played["log"][-1] == [number(history.evaluations, 6), number(np.abs(history.phase_error).max() / math.tau)]
    assert len(played["log"]) == 31
    assert len(json.dumps(played)) < 10_000


def test_the_challenge_shows_the_methods_after_a_try_and_judges_as_the_lesson_does(app):
    page(app)
    drawn = len(app.get("plotly_chart"))
    app.selectbox(key="method").set_value("rk4").run()
    for steps, done in ((13, False), (14, True)):
        app.number_input(key="steps").set_value(steps).run()
        app.button(key="run").click().run()
        assert len(app.get("plotly_chart")) == drawn + 1
        verdict = lesson.find_task("cheapest").judge(lesson.Attempt(method="rk4", steps=steps))
        assert verdict.is_done == done
        [text] = [text.value for text in app.markdown if escape(verdict.sentence) in text.value]
        assert ("Done." in text, "Not yet." in text) == (done, not done)
    assert app.query_params["tries"] == "rk4.13,rk4.14"
    figure = json.loads(next(chart.proto.spec for chart in app.get("plotly_chart") if "your run" in chart.proto.spec))
    [own] = [trace for trace in figure["data"] if trace.get("name") == "your run"]
    assert (own["x"], own["y"]) == (
        [30 * 14 * 4],
        [pytest.approx(error_history("rk4", 14, 30).phase_error[-1] / -math.tau)],
    )


# ---- simultaneous visitors


def test_simultaneous_requests_share_one_computation_and_measurements_take_turns(monkeypatch):
    worked, under_way, usual = [], [], sys.getswitchinterval()

    def work(*curve, previous, after_block):
        worked.append(curve)
        with responsive():  # a second visitor, with less work
            pass
        assert sys.getswitchinterval() < usual  # other sessions get turns
        time.sleep(0.05)
        return WorkPrecision(*curve, *[np.ones(1)] * 4)

    def measure(*curve):
        under_way.append(curve)
        time.sleep(0.01)
        assert under_way == [curve]
        return under_way.pop() and Timing(1.0, 1.0, 1.0)

    monkeypatch.setattr(cache, "work_precision", work)
    monkeypatch.setattr(cache, "seconds_per_step", measure)
    with ThreadPoolExecutor(5) as visitors:
        diagrams = list(visitors.map(lambda _visitor: cache.diagram(1), range(5)))
    assert sys.getswitchinterval() == usual
    assert len(worked) == len(set(worked)) == 2 * len(METHODS)
    assert all(curve.step_timing == Timing(1.0, 1.0, 1.0) for diagram in diagrams for curve in diagram)


# ---- figures


def test_a_strip_shows_where_its_form_is_right_and_its_other_results(app):
    app.run()
    sweeps = [s for s in sweep_forms() if (s.sweep_name, s.dtype) == ("scale", "float64")]
    strips = {FORMS[sweep.form].title: verdicts.strip(sweep) for sweep in sweeps}
    for sweep, parts in zip(sweeps, strips.values(), strict=True):
        # A strip covers the whole range without a gap, and agrees with the sweep at every sample.
        assert (parts[0].start, parts[-1].end) == pytest.approx((-300, 300))
        assert [part.start for part in parts[1:]] == [part.end for part in parts[:-1]]
        for x, verdict in zip(sweep.x, sweep.verdict, strict=True):
            [part] = [each for each in parts if each.start - 0.01 <= math.log10(x) < each.end - 0.01][:1] or parts[-1:]
            assert part.is_right == (verdict == "right")
    words = [part.label for part in strips["the paper’s form"]]
    assert words[-1] == "−0"
    figure = go.Figure(figures.draw_forms(strips, quantity="s", colors=theme.colors()).to_dict())
    assert set(words) < set(figure.data[0].customdata)
    assert [note.text for note in figure.layout.annotations] == list(strips)


def test_a_number_under_the_pointer_is_written_as_in_a_sentence():
    """Plotly would write 3.2e-7, with a hyphen, in every language."""
    colors, x, errors = theme.colors(), np.array([1.0, 1e7]), np.array([3.2e-7, 0.0125])
    titles = {"titles": ("cost", "error"), "tolerance": 1e-3, "tried": [(1e7, 3.2e-7)]}
    marked_runs = {"cheapest": figures.MarkedRun(cost=1.0, error=3.2e-7, symbol="star", size=15, color="ink")}
    drawings = (
        figures.draw_error_growth({"a": (x, errors, errors)}, "a", (x, errors), ["a"], colors),
        figures.draw_work_precision(
            {("a", "float64"): (x, errors, x)}, marked_runs=marked_runs, colors=colors, **titles
        ),
        figures.draw_phase_errors(x, dict.fromkeys("abc", errors), colors),
    )
    shown = [
        trace for drawing in drawings for trace in go.Figure(drawing.to_dict()).data if trace.customdata is not None
    ]
    assert len(shown) == 9
    for trace in shown:
        assert ":" not in re.sub(r"%\{text\}|periods: ", "", trace.hovertemplate)
        texts = {str(text) for text in np.ravel(trace.customdata)}
        assert "3.2×10⁻⁷" in texts
        assert texts <= {"1", "10⁷", "3.2×10⁻⁷", "0.0125"}


@pytest.fixture(autouse=True)
def fresh():
    """Clear all cached measurements before and after each test."""
    cache.errors.clear()
    cache.forget_seconds()
    yield
    cache.errors.clear()
    cache.forget_seconds()


def test_the_stated_loss_of_phase_in_float32_is_true():
    """This machine loses the phase at 3·10⁶ periods. The test computes in float32 between the decades."""
    machine = Oscillator(k=10.0)
    omega, periods = machine.natural_frequency, 10.0 ** np.linspace(0, 9, 2001)
    times = machine.period * periods
    single = (np.float32(omega) * times.astype(np.float32)).astype(float)
    lost = periods[np.argmax(np.abs(np.angle(np.exp(1j * (single - omega * times)))) > 1)]
    before, after = math.floor(math.log10(lost)), math.ceil(math.log10(lost))
    sentence = verdicts.describe_phases(phase_errors(machine))
    assert f"between {power_of_ten(before)} and {power_of_ten(after)} periods" in sentence


def test_the_cost_of_exact_arithmetic_is_listed(app):
    app.session_state["fold_choices"] = True
    text = next(each.value for each in page(app).markdown if "of a machine, and" in each.value)
    own = next(line for line in text.splitlines() if "of a machine, and" in line)
    claimed, integers = map(float, re.findall(r"at most ([\d.]+) ulp", own))
    assert integers <= 0.5 < claimed < 5
    for m, m_prime, k in ((1.8732999652319045, 7.5490236095328624, 7.557978417122431), (1e-200, 1e100, 1e-150)):
        exact = frequency_squared(*map(Fraction, (m, m_prime, k)))
        value = Oscillator(m, m_prime, k).natural_frequency_squared
        assert abs(Fraction(value) - exact) <= Fraction(claimed) * Fraction(math.ulp(value))
    assert unbroken(FORMS["effective_mass"].formula) in own
    assert len(re.findall(r"[\d.]+\u202f(?:ns|µs)", own)) == 4
    closed = next(line for line in text.splitlines() if "the closed form" in line)
    assert re.search(r"below [\d.]+×10⁻¹⁶\u202frad, but each state would take [\d.]+\u202f(ns|µs) more", closed)
