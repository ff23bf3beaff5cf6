"""Page 5: its texts agree with the measurements, and its work is divided into interruptible parts."""

import functools
import json
import math
import re
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import islice, pairwise

import numpy as np
import plotly.graph_objects as go
import pytest
import streamlit as st
from streamlit.testing.v1 import AppTest

from ramanujan import Oscillator, lesson
from ramanujan.accuracy import work_precision
from ramanujan.accuracy.extremes import FORMS, USED_FORM
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.runs import error_history
from ramanujan.accuracy.work_precision import WorkPrecision, find_cheapest_runs
from ramanujan.figures import speed_page as figures
from ramanujan.pages.speed import cache, costs, downsampling, verdicts
from ramanujan.physics.integrators import METHODS, trajectory
from ramanujan.shell import theme
from ramanujan.shell.widgets import escape
from ramanujan.text.numerals import duration, number, power_of_ten
from tests.checks.reference import frequency_squared
from tests.settings import PATIENCE

PAGE = "ramanujan/pages/speed/page.py"
TITLES = {method.title for method in METHODS.values()}


def page(app: AppTest, **link: str) -> AppTest:
    """Open page 5 by a link."""
    app.run()
    for key, value in link.items():
        app.query_params[key] = value
    return app.switch_page(PAGE).run()


def words(app: AppTest) -> str:
    """Return all words of the page."""
    assert not app.exception
    return " ".join(element.value for kind in (app.markdown, app.caption, app.header) for element in kind)


def one_run(method: str, steps: int, periods: int) -> downsampling.SampledRun:
    return downsampling.downsample(error_history(method, steps, periods), steps, periods)


# ---- the page


def test_the_page_opens_without_measuring_the_diagram_and_ignores_the_parameters_of_old_links(app, monkeypatch):
    monkeypatch.setattr(cache, "diagram_curve", None)
    page(app, periods="300", compare="all", precision="float32", method="rk4")
    assert "says how many turns the computed machine is ahead or behind" in words(app)
    assert not app.warning
    assert dict(app.query_params) == {"method": "rk4"}


def test_every_topic_begins_with_its_sentence_and_each_method_is_explained_where_it_is_chosen(app):
    leads = []
    page(app)
    for topic in ("race", "price", "limits"):
        app.session_state["topic"] = topic
        app.run()
        leads.append(app.markdown[0].value)
        assert len(app.tabs) == 3
        assert all("?" in tab.label for tab in app.tabs)
    assert len(set(leads)) == 3
    assert all(lead.endswith((".", "?")) for lead in leads)
    app.session_state["topic"] = "race"
    app.run()
    app.selectbox(key="method").set_value("rk4").run()
    [labels] = [menu.options for menu in app.selectbox if menu.key == "method"]
    assert labels == [f"{method.title}: {method.idea}" for method in METHODS.values()]
    rows = [row.split(" | ") for row in words(app).splitlines() if row.startswith("| ")]
    for method in METHODS.values():
        [(idea, evaluations, factor)] = [row[1:4] for row in rows if row[0] == f"| {method.title}"]
        assert idea == method.idea
        assert int(evaluations) == method.evaluations
        assert factor == f"1/{2**method.order} of the error (order {method.order})"
    assert f"**{METHODS['rk4'].title}** {METHODS['rk4'].idea}." in words(app)


@pytest.mark.parametrize("method", METHODS)
def test_the_least_number_of_steps_in_the_table_is_the_first_stable_one(method):
    [stable] = [row[-1] for row in verdicts.method_table() if row[0] == METHODS[method].title]
    is_stable = {n: error_history(method, n, 400).energy_error.max() < 1e3 for n in range(3, 9)}
    first = next((n for n, bounded in is_stable.items() if bounded), None)
    # Three is the least number of steps on the page.
    expected = {"always": 3, "never": None}.get(stable) if stable in ("always", "never") else int(stable.split()[-1])
    assert first == expected


def test_the_phases_of_symplectic_euler_and_verlet_meet():
    """The difference of their errors stays within a sixth of a turn, while the errors grow without limit."""
    names = "symplectic_euler", "velocity_verlet"
    for steps in (8, 12, 50):
        euler, verlet = (error_history(name, steps, 600).phase_error for name in names)
        assert np.abs(euler - verlet).max() < math.tau / 6
        assert abs(verlet[-1]) > 3 * np.abs(euler - verlet).max()
    sentence = verdicts.explain_equal_phases()
    assert all(METHODS[name].title in sentence for name in names)


def test_every_slide_has_a_heading_of_its_own(app, monkeypatch):
    monkeypatch.setattr(costs, "measure", lambda: None)
    monkeypatch.setattr(costs, "draw_diagram", lambda by, tolerance: "")
    page(app, view="projector")
    slides = [each.proto.body for each in app.get("html") if "data-slide" in each.proto.body]
    headings = [heading.value for heading in app.header]
    assert len(slides) == 5
    assert [f'<i data-slide="{heading}"></i>' for heading in headings] == slides


@pytest.mark.parametrize(("method", "steps"), [("explicit_euler", "3"), ("velocity_verlet", "3"), ("yoshida6", "192")])
def test_the_ends_of_every_option_are_shown(app, method, steps):
    page(app, method=method, steps=steps, error="energy")
    assert f"**{METHODS[method].title}, {steps} steps per period:**" in words(app)
    # hΩ = 2π/3 is above Verlet's limit of 2.
    assert ("**unstable here**" in words(app)) == (method == "velocity_verlet")
    if method == "explicit_euler":
        # Each of 90 steps multiplies q² + v² by 1 + (hΩ)².
        assert f"energy grew to **{number((1 + (2 * math.pi / 3) ** 2) ** 90)} times** the true value" in words(app)


def test_phase_error_is_that_of_the_midpoint_rule(app):
    page(app, method="implicit_midpoint", steps="16")
    # One step turns by exactly 2·atan(hΩ/2).
    z = 2 * math.pi / 16
    late = abs(480 * (2 * math.atan(z / 2) - z))
    assert f"{number(late / math.tau)} of a full turn behind**" in words(app)


def test_measurements_are_shared_and_repeated_on_request(app):
    page(app, topic="price")
    curves = cache.diagram()
    assert len(curves) == 2 * len(METHODS)
    best = find_cheapest_runs(curves, 1e-2)[0]
    text = words(app)
    sentence = f"**{METHODS[best.method].title}** with **{best.steps_per_period} steps per period** is the cheapest"
    assert f"{sentence}: it takes **{best.evaluations} evaluations** of the force." in text
    assert duration(best.seconds) in text
    # The figure marks the run of the sentence, with the same number.
    [spec] = [chart.proto.spec for chart in app.get("plotly_chart")]
    [ring] = [trace for trace in json.loads(spec)["data"] if trace.get("name") == "cheapest"]
    assert ring["x"] == [best.evaluations]
    assert f"<b>{best.evaluations}</b>" in [note["text"] for note in json.loads(spec)["layout"]["annotations"]]

    # A lower tolerance costs more, and the sentence is updated.
    app.select_slider(key="tolerance").set_value("1e-6").run()
    finer = find_cheapest_runs(curves, 1e-6)[0]
    assert finer.evaluations > best.evaluations
    assert f"with **{finer.steps_per_period} steps" in words(app)

    # Another visitor or another machine causes no new measurement.
    other = AppTest.from_file(str(app._script_path), default_timeout=PATIENCE)
    page(other, topic="price").slider(key="k").set_value(172.5).run()
    assert duration(best.seconds) in words(other)

    # The button measures the seconds again.
    app.button(key="measure").click().run()
    again = cache.diagram()
    assert [c.step_seconds for c in again] != [c.step_seconds for c in curves]
    assert [c.error is old.error for c, old in zip(again, curves, strict=True)] == [True] * len(curves)


def test_all_lines_of_the_diagram_end_at_one_cost():
    """Then the names at the right edge are beside their lines."""
    ends = np.array([work_precision.diagram_line(method).evaluations[-1] for method in METHODS])
    assert np.ptp(ends) < 0.01 * ends.max()


@pytest.mark.parametrize("tolerance", [0.1, 1e-4])
def test_the_error_of_the_spring_is_that_of_the_phase(tolerance):
    phases = np.linspace(0, math.tau, 100_001)
    most = 0.08 * np.abs(np.cos(phases + math.tau * tolerance) - np.cos(phases)).max()
    size, unit = (1e-2, "cm") if most > 1e-2 else (1e-6, "µm")
    sentence = verdicts.describe_tolerance(tolerance, 0.08)
    written = float(re.search(rf"off by ([\d.]+)\u202f{unit}", sentence)[1])
    assert most / size <= written * (1 + 1e-6)
    assert written == pytest.approx(most / size, rel=0.05)


def test_an_interrupted_measurement_shows_its_progress_and_continues(app, monkeypatch):
    parts = cache.parts_of_diagram()
    computed = []

    def interrupt():
        # Streamlit stops the script in this way when the visitor changes a setting.
        if len(computed) < 2:
            st.stop()

    monkeypatch.setattr(cache, "parts_of_diagram", lambda: [partial(computed.append, 1), interrupt, *parts])
    page(app, topic="price")
    [bar] = app.get("progress")
    assert (bar.proto.value, bar.proto.text) == (100 // (2 + len(parts)), "Measuring 30 periods on this server …")
    # The rest of the page is already complete.
    assert "What exactness costs" in [expander.label for expander in app.expander]
    app.select_slider(key="tolerance").set_value("1e-6").run()
    assert not app.get("progress")
    assert "For an error of at most 10⁻⁶ of a turn" in words(app)


def test_the_result_of_the_papers_form_at_the_edge_is_stated(app):
    app.session_state["fold_forms"] = True
    page(app, topic="limits")
    s = 1e-200
    wrong = 8 * s / (7 * s + 8 * s - 8 * (s + s) ** 2 / (7 * s / 3 + 2 * s))
    right = frequency_squared(1, 1, 1)
    assert abs(wrong - right) > 0.1  # negative control: a wrong but plausible value
    paper, used = FORMS["paper"], FORMS[USED_FORM]
    assert f"**{paper.title}:** {paper.formula} | float64 | s from {number(1e-300)} to " in words(app)
    assert f"| gives {number(wrong, 4)}" in words(app)
    for dtype in ("float32", "float64"):
        assert words(app).count(f"**{used.title}:** {used.formula} | {dtype} | nowhere") == 2


def test_the_digits_of_both_formulas_wait_for_a_prediction_and_then_show_where_the_first_one_fails(app):
    def data() -> dict:
        [element] = [each.proto for each in app.get("bidi_component") if "digits" in each.proto.component_name]
        return json.loads(element.json)

    page(app, topic="limits")
    for name, asked, note in (("time", "10⁻⁹", "nothing"), ("ratio", "10²⁰⁰", "gives 0"), ("scale", "10⁻²⁰⁰", "wrong")):
        app.segmented_control(key="extreme").set_value(name).run()
        before = data()
        assert before["locked"]
        assert not any("used by" in row for row in before["rows"])
        app.button_group(key=f"predict_{name}").set_value("both").run()
        shown = data()
        assert not shown["locked"]
        assert "used by this app" in shown["rows"][1]
        # At the start both are right. At the asked extreme, the first one has no correct digit.
        _x, cells, _note = shown["samples"][shown["start"]]
        assert [digits for *_texts, digits in cells] == [15, 15, None]
        [(cells, number_of_note)] = [sample[1:] for sample in shown["samples"] if sample[0] == asked]
        assert [digits for *_texts, digits in cells] == [0, 15, None]
        assert note in shown["notes"][number_of_note]
        assert "Not right. You predicted: both." in shown["notes"][number_of_note]
        app.button_group(key=f"predict_{name}").set_value("used").run()
        assert "Your prediction was right." in data()["notes"][number_of_note]
        assert cells[1][1:4] == cells[2][1:4], "the right digits are those of the exact value"


# ---- the motion on the stage


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("steps", [3, 12, 37, 192])
def test_the_stage_plays_a_run_in_few_bytes_with_its_cost(method, steps):
    history, run = error_history(method, steps, 30), one_run(method, steps, 30)
    played = downsampling.stage_payload(run)
    q, places = np.array(played["q"]), np.arange(30 * played["per_period"] + 1) * steps / played["per_period"]
    joined, energy_error = (
        np.interp(places, np.arange(history.q.size), values) for values in (history.q, history.energy_error)
    )
    # Straight lines between the steps miss a curve of the amplitude 3 by at most 3h²/8.
    missed = np.where(places % 1 == 0, 6e-5, 6e-5 + downsampling.ROOM * (math.tau / steps) ** 2 / 8)
    inside = 1 + energy_error < downsampling.ROOM**2
    assert (abs(q - joined) <= missed)[inside].all()
    assert abs(q).max() <= downsampling.ROOM
    assert (played["evaluations"][0], played["evaluations"][-1]) == ("0", number(history.evaluations, 6))
    assert len(played["evaluations"]) == len(played["turns"]) == 31
    assert len(json.dumps(played)) < 10_000


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("steps", [8, 12, 50])
def test_the_computed_hand_has_the_angle_of_position_and_velocity(method, steps):
    """After a whole period the exact hand is at the start, so the other one is there by the phase error."""
    states = islice(trajectory(METHODS[method], lambda q: -q, 1.0, 0.0, math.tau / steps), 30 * steps)
    q, v = np.array([(1.0, 0.0), *states])[::steps].T
    run = one_run(method, steps, 30)
    turns = np.array(downsampling.stage_payload(run)["turns"])
    # In the exact motion, q + i·(−v) turns like e^{it}, and the hand clockwise from the top.
    np.testing.assert_allclose(np.exp(2j * np.pi * turns), (q - 1j * v) / np.hypot(q, v), atol=1e-4)
    assert all(abs(after - before) < 0.5 for before, after in pairwise(turns)), "no whole turn is lost"
    assert turns[-1] == pytest.approx(run.phase_at_end / math.tau, abs=1e-5)


def test_the_challenge_judges_as_the_lesson_does_and_the_diagram_marks_each_attempt(app):
    page(app)
    app.selectbox(key="method").set_value("rk4").run()
    for steps, done in ((13, False), (14, True)):
        app.number_input(key="steps").set_value(steps).run()
        app.button(key="run").click().run()
        verdict = lesson.find_task("cheapest").judge(lesson.Attempt(method="rk4", steps=steps))
        assert verdict.is_done == done
        [text] = [text.value for text in app.markdown if escape(verdict.sentence) in text.value]
        assert ("Done." in text, "Not yet." in text) == (done, not done)
        assert ("Your best run: none yet." in words(app)) == (not done)
    assert app.query_params["tries"] == "rk4.13,rk4.14"
    assert "**1680 evaluations**, by Runge–Kutta 4 with 14 steps" in words(app)
    app.session_state["topic"] = "price"
    app.run()
    figure = json.loads(next(chart.proto.spec for chart in app.get("plotly_chart") if "your run" in chart.proto.spec))
    marks = {trace["x"][0]: trace for trace in figure["data"] if len(trace["x"]) == 1}
    for steps in (13, 14):
        error = error_history("rk4", steps, 30).phase_error[-1] / -math.tau
        assert marks[30 * steps * 4]["y"] == [pytest.approx(error)]
    assert marks[30 * 14 * 4]["name"] == "your run"
    [text] = [text.value for text in app.markdown if "**Your run**" in text.value]
    assert "14 steps per period, takes 1680 evaluations" in text
    assert "small enough" in text


def test_many_attempts_do_not_remove_the_best_one(app):
    page(app, method="rk4", tries="rk4.14," + ",".join(f"rk4.{steps}" for steps in range(20, 31)))
    assert "**1680 evaluations**" in words(app)
    app.button(key="run").click().run()
    tries = app.query_params["tries"].split(",")
    assert (len(tries), tries[0], tries[1], tries[-1]) == (12, "rk4.14", "rk4.21", "rk4.12")
    assert "**1680 evaluations**" in words(app)


# ---- simultaneous visitors


def test_simultaneous_requests_share_one_computation_and_measurements_take_turns(monkeypatch):
    worked, under_way = [], []

    def work(*curve):
        worked.append(curve)
        time.sleep(0.02)
        return WorkPrecision(*curve, 30, *[np.ones(1)] * 3)

    def measure(*curve):
        under_way.append(curve)
        time.sleep(0.01)
        assert under_way == [curve]
        return under_way.pop() and 1.0

    work_precision._diagram_curve.cache_clear()
    monkeypatch.setattr(work_precision, "work_precision", work)
    monkeypatch.setattr(cache, "_measure_step", functools.cache(measure))
    with ThreadPoolExecutor(5) as visitors:
        diagrams = list(visitors.map(lambda _visitor: cache.diagram(), range(5)))
    assert len(worked) == len(set(worked)) == 2 * len(METHODS)
    assert all(curve.step_seconds == 1.0 for diagram in diagrams for curve in diagram)
    work_precision._diagram_curve.cache_clear()


# ---- figures


def test_a_number_under_the_pointer_is_written_as_in_a_sentence():
    """Plotly would write 3.2e-7, with a hyphen, in every language."""
    colors, x, errors = theme.colors(), np.array([1.0, 1e7]), np.array([3.2e-7, 0.0125])
    more = {"titles": ("cost", "error"), "limits": (1e-8, 1.0), "tolerance": 1e-3, "tried": [(1e7, 3.2e-7)]}
    marked_runs = {"cheapest": figures.MarkedRun(cost=1.0, error=3.2e-7, symbol="star", size=15, color="ink")}
    drawings = (
        figures.draw_error_growth(
            {"a": (x, errors)}, "a", title="error", limits=(1e-8, 1.0), allowed=1e-2, colors=colors
        ),
        figures.draw_work_precision({"a": (x, errors, x)}, chosen="a", marked_runs=marked_runs, colors=colors, **more),
        figures.draw_phase_errors(x, dict.fromkeys("abc", errors), "a", colors),
    )
    shown = [
        trace for drawing in drawings for trace in go.Figure(drawing.to_dict()).data if trace.customdata is not None
    ]
    assert len(shown) == 7
    for trace in shown:
        assert ":" not in re.sub(r"%\{text\}|periods: ", "", trace.hovertemplate)
        texts = {str(text) for text in np.ravel(trace.customdata)}
        assert "3.2×10⁻⁷" in texts
        assert texts <= {"1", "10⁷", "3.2×10⁻⁷", "0.0125"}


def test_the_growth_of_errors_has_fixed_axes_and_names_all_methods_and_a_run_makes_one_strong(app):
    def draw_growth() -> dict:
        [chart] = app.get("plotly_chart")
        return json.loads(chart.proto.spec)

    page(app)
    assert "Each line up is 10 times the one below." in words(app)
    axes = []
    for method, steps in (("rk4", 12), ("explicit_euler", 3), ("yoshida6", 192)):
        app.selectbox(key="method").set_value(method)
        app.number_input(key="steps").set_value(steps).run()
        # A prediction comes first: no line is strong until the method has run with these steps.
        before = draw_growth()
        assert "Which line belongs to your run?" in words(app)
        assert len({trace["line"]["color"] for trace in before["data"] if trace.get("name") in TITLES}) == 1
        assert not any("<b" in text for text in before["layout"]["yaxis2"]["ticktext"])
        app.button(key="run").click().run()
        assert "Which line belongs to your run?" not in words(app)
        drawn = draw_growth()
        axes.append([drawn["layout"][axis]["range"] for axis in ("xaxis", "yaxis")])
        assert drawn["layout"]["yaxis"]["dtick"] == 1
        # Each line has a symbol of its own, also at its name.
        marked = [trace for trace in drawn["data"] if "marker" in trace]
        in_lines = {trace["marker"]["symbol"] for trace in marked if "name" in trace}
        assert len(in_lines) == len(METHODS)
        assert sorted(trace["marker"]["symbol"] for trace in marked if "name" not in trace) == sorted(in_lines)
        lines = {trace["name"]: trace["line"] for trace in drawn["data"] if "name" in trace}
        title = METHODS[method].title
        assert {each.title for each in METHODS.values()} < set(lines)
        grays = {lines[each.title]["color"] for each in METHODS.values() if each.title != title}
        assert len(grays) == 1
        assert lines[title]["color"] not in grays
        labels = [text.replace("<br>", " ") for text in drawn["layout"]["yaxis2"]["ticktext"]]
        for each in METHODS.values():
            [label] = [label for label in labels if each.title in label]
            assert ("<b" in label) == (each.title == title)
            # A line that ends outside of the figure has an arrow.
            if each.title == title:
                arrow = {"rk4": "", "explicit_euler": " ↑", "yoshida6": " ↓"}[method]
                assert f"{title}{arrow}</b>" in label
    assert axes[0] == axes[1] == axes[2]


def test_the_names_at_the_ends_of_lines_never_overlap():
    """Three lines end at the same point, and one at the lower edge."""
    cost, colors = np.array([1.0, 10.0]), theme.colors()
    ends = {"explicit Euler": 1e-3, "symplectic Euler": 1e-3, "implizite Mittelpunktsregel": 1e-3, "Yoshida 6": 1e-8}
    curves = {name: (cost, np.array([0.5, end]), cost) for name, end in ends.items()}
    figure = figures.draw_work_precision(
        curves,
        chosen="Yoshida 6",
        titles=("cost", "error"),
        limits=(1e-8, 1.0),
        tolerance=1e-3,
        marked_runs={},
        colors=colors,
    )
    axis = go.Figure(figure.to_dict()).layout.yaxis2
    assert len(axis.tickvals) == len(ends), "the error allowed is no method"
    heights = np.log10(axis.tickvals)
    lines = np.array([1 + text.count("<br>") for text in axis.ticktext])
    # The highest letters, on a phone, have 0.07 of the height of the axis.
    room = 0.075 * 8 * (lines[:-1] + lines[1:]) / 2
    assert (-np.diff(heights) >= room).all()
    assert -8 <= heights.min() < heights.max() <= 0
    assert [colors["primary"] in text for text in axis.ticktext] == [False] * 3 + [True]


@pytest.fixture(autouse=True)
def fresh():
    """Clear the measured times before and after each test."""
    cache.forget_seconds()
    yield
    cache.forget_seconds()


def test_the_stated_loss_of_phase_in_float32_is_true():
    """This machine loses the phase at 3·10⁶ periods. The test computes in float32 between the decades."""
    machine = Oscillator(k=10.0)
    omega, periods = machine.natural_frequency, 10.0 ** np.linspace(0, 9, 2001)
    times = machine.period * periods
    single = (np.float32(omega) * times.astype(np.float32)).astype(float)
    lost = periods[np.argmax(np.abs(np.angle(np.exp(1j * (single - omega * times)))) > 1)]
    before, after = math.floor(math.log10(lost)), math.ceil(math.log10(lost))
    sentence = verdicts.describe_phases(phase_errors(machine), machine.period)
    assert f"between {power_of_ten(before)} and {power_of_ten(after)} periods" in sentence


def test_the_cost_of_exact_arithmetic_is_listed(app):
    app.session_state["fold_arithmetics"] = True
    text = words(page(app, topic="price"))
    [own, *others] = re.findall(r"\| (.+) \| ([\d.]+\u202f(?:ns|µs)) \| (.+) \|", text[text.index("Time for one Ω²") :])
    assert [arithmetic for arithmetic, _time, _error in (own, *others)] == [
        "float64, as in this app",
        "float32",
        "integers of any length, rounded once",
        "fractions",
        "50 digits",
    ]
    assert others[2][2] == "0"
    times = float(re.search(r"would take ([\d.]+) times as long", text)[1])
    prices = cache.arithmetics()
    assert times == pytest.approx(prices["fractions"].seconds / prices["float64"].seconds, rel=0.05)
