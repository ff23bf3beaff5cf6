"""The motion page under AppTest, and its figures: their texts, their precision, and their settings."""

import json
import re
from collections import defaultdict
from unittest import mock

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.pages.motion import cache
from ramanujan.physics.contact import first_to_slip, largest_compression, required_friction
from ramanujan.text.numerals import at_least, at_most
from tests.checks.reading import array

PAGE = "ramanujan/pages/motion/page.py"
VIEWS = ["displacements", "energy", "momentum", "forces"]
COLORS = defaultdict(lambda: "#808080")


def open_page(app, **state):
    app.run()
    for key, value in state.items():
        app.session_state[key] = value
    app.switch_page(PAGE).run()
    assert not app.exception
    return app


def charts(app):
    """Return the figures on the page, as sent to the browser, by text alternative."""
    return {chart.proto.alt: json.loads(chart.proto.spec) for chart in app.get("plotly_chart")}


def record_finely(m, m_prime, k, radius, *start, finer=1):
    """Return a record with `finer` times as many points."""
    with mock.patch.object(cache, "POINTS", finer * (cache.POINTS - 1) + 1):
        return cache.record.__wrapped__(Oscillator(m, m_prime, k, radius), *start)


def figures(view, *setting, limit=None, **more):
    """Return the figures of a view over time, as sent to the browser."""
    drawn = cache.draw_over_time(view, record_finely(*setting, **more), COLORS, limit)
    return [json.loads(figure.to_json()) for figure in drawn.values()]


def planes(*setting, **more):
    """Return the phase planes relative to the ground and to the block, as sent to the browser."""
    motion = record_finely(*setting, **more)
    return [json.loads(cache.draw_orbits(frame, motion, COLORS).to_json()) for frame in cache.FRAMES]


@pytest.mark.parametrize(("mu", "compression"), [(0.03, 8.0), (1.5, 12.0), (0.01, 0.5)])
def test_the_verdict_names_the_contact_and_the_compression(app, mu, compression):
    open_page(app, mu=mu, compression=compression, figure="forces")
    machine, spacing = Oscillator(1.0, 1.0, 10.0, 0.1), cache.drawn_spacing(0.1)
    needed = required_friction(machine, compression / 100, spacing=spacing)
    largest = largest_compression(machine, mu, spacing=spacing)
    slips = max(needed.values()) > mu
    (heading,) = (fold.label for fold in app.expander if "no longer holds" in fold.label or "Every" in fold.label)
    assert ("no longer holds" in heading) == slips
    (sentence,) = (text for text in app.markdown if "slips first." in text.value or " slips from " in text.value)
    assert ("slips from" in sentence.value) == slips
    # The sentences are "up to" and "slips from": each rounds x₀ so that it remains true.
    bound = at_most(100 * largest, 3) if slips else at_least(100 * largest, 3)
    assert f"{bound}\u202fcm" in sentence.value
    assert cache.CONTACTS[first_to_slip(machine, largest, spacing)] in sentence.value
    # The text at the bars, "Largest compression without slip", is a lower bound in both cases.
    assert any(f"slip: **{at_least(100 * largest, 3)}\u202fcm**" in text.value for text in app.markdown)


def test_the_stage_marks_the_slipping_contact_only_beyond_the_model(monkeypatch, app):
    from ramanujan.browser import stage

    payload_options = []
    monkeypatch.setattr(
        stage,
        "payload",
        lambda *args, original=stage.payload, **more: payload_options.append(more) or original(*args, **more),
    )
    open_page(app, mu=0.03, glide=4.0, spin=1.0)
    assert payload_options[-1]["slipping"] == "hoop_slab"
    assert (payload_options[-1]["initial"].X_dot, payload_options[-1]["initial"].Phi_dot) == (-0.04, 1.0)
    for glide in (4.0, 0.0):
        app.slider(key="glide").set_value(glide).run()
        (alternative,) = (alt for alt in charts(app) if alt.startswith("Displacements"))
        # A spin moves only the top cylinder.
        assert any("The whole machine glides" in text.value for text in app.markdown) == (glide > 0)
        assert "The top cylinder drifts" in alternative
    app.slider(key="mu").set_value(1.0).run()
    assert payload_options[-1]["slipping"] is None


def test_the_bars_show_the_required_friction(app):
    open_page(app, m_prime=3.0, mu=0.05, figure="forces")
    (bars,) = (figure for alt, figure in charts(app).items() if "that each contact needs" in alt)
    machine = Oscillator(1.0, 3.0, 10.0, 0.1)
    needed = required_friction(machine, 0.08, spacing=cache.drawn_spacing(0.1))
    values = sorted(needed.values(), reverse=True)
    assert array(bars["data"][0]["x"]) == pytest.approx(values, rel=1e-12)
    names = [contact.partition("<br>")[0] for contact in bars["data"][0]["y"]]
    assert names == [cache.CONTACTS[name] for name in sorted(needed, key=needed.__getitem__, reverse=True)]
    slipping = ["slips" in text for text in bars["data"][0]["text"]]
    assert slipping == [value > 0.05 for value in values]


CORNERS = [
    (0.5, 0.05, 200.0, 0.05, 0.12, -0.2, 3.0),
    (5.0, 10.0, 1.0, 0.2, 0.005, 0.2, -3.0),
    (0.5, 10.0, 200.0, 0.2, 0.12, 0.0, 0.0),
    (1.0, 1.0, 10.0, 0.1, 0.08, 0.05, 0.6),
]


@pytest.mark.parametrize("setting", CORNERS)
@pytest.mark.parametrize("view", VIEWS)
def test_every_curve_over_time_is_drawn_to_half_a_pixel_on_a_full_screen(view, setting):
    figures_with_exact = zip(*(figures(view, *setting, finer=times) for times in (1, 16)), strict=True)
    for figure, exact in figures_with_exact:
        check_precision(figure, exact)


def check_precision(figure, exact):
    """Check the curves of a figure against those with many more points."""
    height = 1080 / np.ptp(figure["layout"]["yaxis"]["range"])
    stacks = defaultdict(float)
    for drawn, fine in zip(figure["data"], exact["data"], strict=True):
        values, truth = array(drawn["y"]), array(fine["y"])
        if drawn.get("stackgroup"):
            stacks["drawn"], stacks["fine"] = stacks["drawn"] + values, stacks["fine"] + truth
            values, truth = stacks["drawn"], stacks["fine"]
        at = np.linspace(0, len(values) - 1, len(truth))
        gap = np.abs(np.interp(at, np.arange(len(values)), values) - truth) * height
        # Single precision adds less than a thousandth of a pixel.
        assert gap.max() < 0.501, drawn["name"]


@pytest.mark.parametrize("setting", CORNERS)
def test_every_orbit_is_drawn_to_half_a_pixel_on_a_full_screen(setting):
    orbits, exact = (planes(*setting, finer=times) for times in (1, 16))
    edge = cache.edge_time(record_finely(*setting))
    curves = [(curve, figure["layout"]) for figure in orbits for curve in figure["data"]]
    for (drawn, layout), fine in zip(curves, [curve for figure in exact for curve in figure["data"]], strict=True):
        gaps = []
        for letter, pixels in (("x", 1920), ("y", 1080)):
            values, truth = array(drawn[letter]), array(fine[letter])
            at = np.linspace(0, len(values) - 1, len(truth))
            scale = pixels / np.ptp(layout[f"{letter}axis"]["range"])
            gaps.append((np.interp(at, np.arange(len(values)), values) - truth) * scale)
        times = np.linspace(0, layout["meta"]["period"] * layout["meta"]["periods"], len(truth))
        # The orbit of the top cylinder ends at the edge of the block.
        is_drawn = times <= edge if edge and drawn["name"] == "top cylinder" else times >= 0
        assert np.hypot(*gaps)[is_drawn].max() < 0.501, drawn["name"]


@pytest.mark.parametrize("setting", CORNERS)
def test_the_stack_of_energies_ends_at_the_flat_total(setting):
    (figure,) = figures("energy", *setting)
    *parts, total = (array(trace["y"]) for trace in figure["data"])
    # Single precision: nine terms of 6e-8 each.
    assert sum(parts) == pytest.approx(total, rel=1e-6)
    assert np.ptp(total) <= 1e-6 * total[0]


@pytest.mark.parametrize("m_prime", [0.05, 1.0, 10.0])
def test_the_name_of_an_energy_is_in_its_area_or_leads_to_it(m_prime):
    (figure,) = figures("energy", 1.0, m_prime, *CORNERS[3][2:])
    *parts, total = figure["data"]
    edges = np.cumsum([array(trace["y"]) for trace in parts], axis=0)
    sum_name, *names = [note for note in figure["layout"]["annotations"] if note["yref"] == "y"]
    assert "total energy" in sum_name["text"]
    assert {note["text"] for note in names} == {trace["name"] for trace in parts}
    assert not figure["layout"]["showlegend"]
    above = [note for note in names if note["showarrow"]]
    assert all(note["ay"] > array(total["y"])[0] for note in above)
    assert len({4 * note["ax"] // figure["layout"]["xaxis"]["range"][1] for note in above}) == len(above), "apart"
    for note in names:
        moment = round(note["x"] / parts[0]["dx"])
        lowest_above = int(np.searchsorted(edges[:, moment], note["y"]))
        assert parts[lowest_above]["name"] == note["text"]


def test_all_figures_over_time_share_one_axis_and_one_hover():
    for view in VIEWS:
        for figure in figures(view, *CORNERS[3], limit=("hoop_slab", 0.1) if view == "forces" else None):
            layout = figure["layout"]
            assert [name for name in layout if name.startswith("xaxis")] == ["xaxis"]
            assert layout["hovermode"] == "x unified"
            assert layout["meta"]["cursor"] == "time"
            ends = {round(trace["dx"] * (len(array(trace["y"])) - 1), 9) for trace in figure["data"]}
            assert ends == {round(layout["meta"]["period"] * cache.PERIODS, 9)}


def test_orbits_close_without_an_initial_velocity():
    closed = {}
    for push in (0.0, 0.1):
        drawn = planes(1.0, 1.0, 10.0, 0.1, 0.08, push, 10 * push)
        for frame, plane in zip(cache.FRAMES, drawn, strict=True):
            ends = {orbit["name"]: array(orbit["x"])[[0, -1]] for orbit in plane["data"]}
            closed[frame, push] = {name for name, (first, last) in ends.items() if abs(first - last) < 1e-5}
    assert closed["ground", 0.0] == {"slab", "block", "hoop, lower cylinder", "top cylinder"}
    assert closed["block", 0.0] == {"slab", "hoop, lower cylinder", "top cylinder"}
    assert closed["ground", 0.1] == set()
    assert closed["block", 0.1] == {"slab", "hoop, lower cylinder"}


def test_an_initial_velocity_of_the_machine_changes_nothing_relative_to_the_block():
    machine = 1.0, 1.0, 10.0, 0.1, 0.08
    (at_rest, still), (_, gliding) = (planes(*machine, glide, 0) for glide in (0, 0.2))
    over_ground, over_block = figures("displacements", *machine, 0, 0)
    for before, after in zip(still["data"], gliding["data"], strict=True):
        assert array(after["x"]) == pytest.approx(array(before["x"]), abs=1e-5)
        assert array(after["y"]) == pytest.approx(array(before["y"]), abs=1e-5)
    assert gliding["layout"] == still["layout"]
    # No panel and no plane has an empty half: each end of an axis has its own step.
    assert at_rest["layout"]["xaxis"]["range"] == pytest.approx([-0.7, 10])
    assert at_rest["layout"]["yaxis"]["range"] == [-5, 5]
    assert still["layout"]["xaxis"]["range"] == still["layout"]["yaxis"]["range"] == [-10, 10]
    assert over_ground["layout"]["yaxis"]["range"] == pytest.approx([-0.7, 10])
    assert over_block["layout"]["yaxis"]["range"] == [-10, 10]


@pytest.mark.parametrize("setting", CORNERS)
def test_an_oscillation_is_a_circle_in_the_phase_plane(setting):
    *machine, _glide, _spin = setting
    for plane in planes(*machine, 0.0, 0.0):
        assert (plane["layout"]["yaxis"]["scaleanchor"], plane["layout"]["yaxis"]["constrain"]) == ("x", "domain")
        for orbit in plane["data"]:
            x, y = array(orbit["x"]), array(orbit["y"])
            centre = (x.max() + x.min()) / 2
            assert np.hypot(x - centre, y) == pytest.approx(np.ptp(x) / 2, rel=1e-4)


def test_the_axes_have_few_ranges():
    ranges = {
        tuple(figures("displacements", 1, 1, 10, 0.1, 0.08, 0.002 * step, 0)[0]["layout"]["yaxis"]["range"])
        for step in range(101)
    }
    # The lower end changes only with the upper one.
    assert [end for _start, end in sorted(ranges, reverse=True)] == [10, 15, 20, 30, 40, 50, 70, 100]
    layouts = [planes(1, 1, 10, 0.1, 0.08, 0.002 * step, 0)[0]["layout"] for step in range(101)]
    assert len({(*layout["xaxis"]["range"], *layout["yaxis"]["range"]) for layout in layouts}) == 9


@pytest.mark.parametrize("setting", CORNERS)
@pytest.mark.parametrize(("view", "count"), [("displacements", 2), ("energy", 1), ("momentum", 1), ("forces", 2)])
def test_every_line_has_its_name_at_its_end_and_no_name_covers_another(view, count, setting):
    drawn = figures(view, *setting)
    assert len(drawn) == count
    for figure in drawn:
        assert not figure["layout"]["showlegend"]
        if view != "energy":
            ends = {line["name"]: array(line["y"])[-1] for line in figure["data"]}
            if view == "displacements":
                ends = at_edge(figure, cache.edge_time(record_finely(*setting)))
            if view == "momentum":
                for axis, names in (("y", "y2"), ("y3", "y4")):
                    curves = [line for line in figure["data"] if line["yaxis"] == axis]
                    assert len(curves) == 3
                    check_names(fastest(curves), figure["layout"], axis=axis, axis_of_names=names)
                continue
            check_names(ends, figure["layout"])


@pytest.mark.parametrize("setting", CORNERS)
def test_the_parts_of_both_conserved_momenta_are_mirror_images_with_a_flat_sum(setting):
    motion = record_finely(*setting)
    (figure,) = figures("momentum", *setting)
    p_X, p_Phi = (motion.momenta[name][0] for name in ("p_X", "p_Phi"))
    for axis, expected in (("y", -p_X), ("y3", p_Phi / motion.oscillator.radius)):
        first, second, total = (array(line["y"]) for line in figure["data"] if line["yaxis"] == axis)
        # Single precision.
        exact = {"abs": 1e-6 * max(abs(first).max(), abs(expected))}
        assert first + second == pytest.approx(total, **exact)
        assert total == pytest.approx(np.full_like(total, expected), **exact)
        # Each part is the other one, reflected at half the sum.
        assert first - expected / 2 == pytest.approx(expected / 2 - second, **exact)
        low, high = figure["layout"][axis.replace("y", "yaxis")]["range"]
        if not any(setting[5:]):
            assert np.ptp(first) > (high - low) / 2, "released at rest, the parts fill their panel"


@pytest.mark.parametrize(
    "setting", [*CORNERS, *((1.0, 1.0, 10.0, 0.1, 0.08, glide, 0.0) for glide in (0.0, 0.01, 0.2))]
)
def test_every_orbit_has_its_name_beside_its_crest_and_no_name_covers_another(setting):
    for plane in planes(*setting):
        assert not plane["layout"]["showlegend"]
        # The letters of a phone are at most 0.12 of its plane.
        check_names(fastest(plane["data"]), plane["layout"], room=0.12)
        # A level line joins each crest with the edge.
        levels = [shape for shape in plane["layout"]["shapes"] if shape.get("yref") == "y"]
        starts = [(level["x0"], level["y0"]) for level in levels]
        crests = zip(fastest(plane["data"], "x").values(), fastest(plane["data"]).values(), strict=True)
        assert len(levels) == len(plane["data"])
        assert all(pytest.approx(crest, rel=1e-5, abs=1e-6) in starts for crest in crests)
        assert all(
            (level["x1"], level["y1"]) == (plane["layout"]["xaxis"]["range"][1], level["y0"]) for level in levels
        )


def at_edge(figure, edge):
    """Return the values of lines by name at the edge of the block, or at their ends if the cylinder stays on it."""
    values = {line["name"]: array(line["y"]) for line in figure["data"]}
    end = figure["layout"]["xaxis"]["range"][1]
    return {name: np.interp(edge or end, np.linspace(0, end, len(y)), y) for name, y in values.items()}


@pytest.mark.parametrize(("glide", "spin"), [(0.1, 2.0), (0.2, 3.0), (0.0, -3.0)])
def test_the_displacements_before_the_edge_fill_their_panel(glide, spin):
    setting = (1.0, 1.0, 10.0, 0.1, 0.08, glide, spin)
    edge = cache.edge_time(record_finely(*setting))
    for figure in figures("displacements", *setting):
        low, high = figure["layout"]["yaxis"]["range"]
        before = [array(line["y"])[: int(edge / line["dx"])] for line in figure["data"]]
        # A step of the axis is at most one and a half times the step below it, on both sides of zero.
        assert np.ptp(np.concatenate(before)) > (high - low) / 1.7
        assert low <= np.concatenate(before).min() <= np.concatenate(before).max() <= high


def fastest(lines, letter="y"):
    """Return the values of lines by name at the last moment at which bodies released at rest are fastest."""
    values = {line["name"]: array(line[letter]) for line in lines}
    return {name: np.interp(7 / 8, np.linspace(0, 1, len(each)), each) for name, each in values.items()}


def check_names(starts, layout, room=0.09, axis="y", axis_of_names="y2"):
    """Check the names of lines, and the leaders to them.

    Parameters
    ----------
    starts : name → where its leader starts
    room : the height of a line of letters, in fractions of the figure; on a slide at most 0.09
    axis, axis_of_names : the vertical axes of a panel
    """
    lines, names = (layout[name.replace("y", "yaxis")] for name in (axis, axis_of_names))
    assert names["overlaying"] == axis
    assert names["range"] == lines["range"]
    leaders = [shape for shape in layout["shapes"] if shape.get("yref") == axis_of_names]
    starts = {re.sub("<.*?>", "", name): start for name, start in starts.items()}
    texts = [re.sub("<.*?>", "", text.replace("–<br>", "–").replace("<br>", " ")) for text in names["ticktext"]]
    assert sorted(texts) == sorted(starts)
    height = np.ptp(names["range"])
    for text, level, leader in zip(texts, names["tickvals"], leaders, strict=True):
        assert leader["y0"] == pytest.approx(starts[text], abs=1e-6 * height)
        assert leader["y1"] == level
    low, high = lines.get("domain", (0, 1))
    room = height * room / (high - low)
    rows = np.array([1 + text.count("<br>") for text in names["ticktext"]])
    assert (-np.diff(names["tickvals"]) >= room * (rows[:-1] + rows[1:]) / 2).all()
    assert names["range"][0] <= min(names["tickvals"]) <= max(names["tickvals"]) <= names["range"][1]


@pytest.mark.parametrize("spin", [-3.0, 1.0])
def test_a_line_marks_the_edge_of_the_block_and_the_orbit_of_the_top_cylinder_ends_there(spin):
    setting = (1.0, 1.0, 10.0, 0.1, 0.08, 0.04, spin)
    motion = record_finely(*setting)
    edge = cache.drawn_edges(0.1, 0.12)[int(spin > 0)]
    x = motion.relative_positions["top"]
    for view in VIEWS:
        for figure in figures(view, *setting):
            veil, line, *_ = figure["layout"]["shapes"]
            assert veil["x0"] == line["x0"] == line["x1"]
            assert np.interp(line["x0"], motion.t, x) == pytest.approx(edge, abs=0.005)
            assert veil["x1"] == figure["layout"]["xaxis"]["range"][1]
            assert "one period" not in [note["text"] for note in figure["layout"]["annotations"]]
    orbits = {orbit["name"]: orbit for orbit in planes(*setting)[1]["data"]}
    assert array(orbits["top cylinder"]["x"])[-1] == pytest.approx(100 * edge, abs=0.5)


def test_the_hover_text_names_a_curve_with_its_value():
    """Plotly appends the name of a curve, with a space before the colon, unless the template replaces it."""
    for figure in figures("forces", *CORNERS[3]):
        texts = [trace["hovertemplate"] for trace in figure["data"]]
        assert all(text.endswith("<extra></extra>") for text in texts)
        assert all(re.search(r"^[a-z, ]+: %\{y", text) for text in texts)


@pytest.mark.parametrize("setting", CORNERS)
def test_the_shaded_area_is_the_limit_of_the_contact_that_slips_first(setting):
    motion = record_finely(*setting)
    for mu in (0.01, 0.1, 1.5):
        largest = largest_compression(motion.oscillator, mu, spacing=motion.spacing)
        first = first_to_slip(motion.oscillator, largest, motion.spacing)
        friction, _normal = figures("forces", *setting, limit=(first, mu))
        lower, upper, *curves = friction["data"]
        assert array(upper["y"]) == pytest.approx(mu * motion.normal_forces[first], rel=1e-6)
        assert array(lower["y"]) == pytest.approx(-array(upper["y"]))
        (strong,) = (curve for curve in curves if curve["line"]["width"] > 3)
        assert array(strong["y"]) == pytest.approx(motion.forces[first], rel=1e-5, abs=1e-9)
        leaves = (abs(array(strong["y"])) > array(upper["y"])).any()
        slips = required_friction(motion.oscillator, motion.compression, spacing=motion.spacing)[first] > mu
        assert leaves == slips
        low, high = friction["layout"]["yaxis"]["range"]
        assert low <= min(array(curve["y"]).min() for curve in curves)
        assert high >= max(array(curve["y"]).max() for curve in curves)
