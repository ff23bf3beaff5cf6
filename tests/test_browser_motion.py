"""The motion page in a browser: bytes, the shared time cursor, the download, what stands where."""

import numpy as np
import pytest

from ramanujan import Oscillator, motion, released
from ramanujan.contact import contact_forces, normal_forces
from ramanujan.pages.motion import cache
from tests.browser import next_frame, settle

PLOT = ".js-plotly-plot .nsewdrag"
MARK = ".js-plotly-plot .time-cursor"


def open_motion(visit, query="", **more):
    page = visit(f"motion{query}", **more)
    page.wait_for_selector(PLOT, state="attached")
    settle(page)
    return page


def nudge(page, key, press="ArrowRight"):
    """Move a slider by one step, and return how many bytes the server sent for it."""
    before = len(page.frames_received)
    page.locator(f".st-key-{key} input[type=range]").first.focus()
    page.keyboard.press(press)
    page.wait_for_timeout(300)
    settle(page)
    return sum(page.frames_received[before:])


def cursor_times(page):
    """The times [s] that the lines of all figures over time stand at, by Plotly's own scale."""
    return page.evaluate(
        """() => [...document.querySelectorAll(".js-plotly-plot")]
          .filter((graph) => graph.layout.meta?.cursor === "time")
          .map((graph) => {
            const { left, width } = graph.querySelector(".time-cursor").getBoundingClientRect();
            const axis = graph._fullLayout.xaxis;
            return axis.p2l(left + width / 2 - graph.getBoundingClientRect().left - axis._offset);
          })"""
    )


def choose(page, view):
    """Open a view."""
    page.get_by_role("tab").nth(list(cache.VIEWS).index(view)).click()
    figure = "contact_forces" if view == "forces" else view
    page.locator(f".st-key-figure_{figure} .nsewdrag").first.wait_for(state="attached")
    settle(page)


def test_the_cursor_moves_all_figures_without_the_server(visit):
    page = open_motion(visit)
    slider = page.get_by_label("Time cursor")
    before = len(page.frames_sent)
    slider.fill("0.3")
    next_frame(page)
    period = page.evaluate("document.querySelector('.js-plotly-plot').layout.meta.period")
    # A pixel of the line is about a hundredth of a second.
    assert cursor_times(page) == [pytest.approx(0.3 * cache.PERIODS * period, abs=0.02)]
    assert page.locator(MARK).count() == 1 + 3
    slider.focus()
    page.keyboard.press("End")
    next_frame(page)
    assert cursor_times(page) == [pytest.approx(cache.PERIODS * period, abs=0.02)]
    assert slider.get_attribute("aria-valuetext").endswith("2.00 periods")
    assert len(page.frames_sent) == before


def test_a_click_takes_the_cursor_along_and_all_panels_answer(visit):
    page = open_motion(visit, height=1500)
    panel = page.locator(PLOT).first.bounding_box()
    page.mouse.move(panel["x"] + 0.5 * panel["width"], panel["y"] + 0.5 * panel["height"])
    page.mouse.move(panel["x"] + 0.6 * panel["width"], panel["y"] + 0.5 * panel["height"], steps=4)
    page.wait_for_timeout(400)
    # A pointer that only passes over a figure reads it; the machine that was frozen stays as it is.
    assert float(page.get_by_label("Time cursor").input_value()) < 0.6
    page.mouse.down()
    page.mouse.up()
    next_frame(page)
    assert float(page.get_by_label("Time cursor").input_value()) == pytest.approx(0.6, abs=0.01)
    # One label for both panels: five bodies over the ground, four over the block.
    assert page.locator(".hoverlayer .traces").count() == 9


def test_what_a_hover_tells_leaves_the_figure_in_sight(visit):
    page = open_motion(visit, height=900)
    panels = page.locator(".js-plotly-plot").first.locator(".nsewdrag")
    panels.last.scroll_into_view_if_needed()
    box = panels.first.bounding_box()
    for share in (0.4, 0.45):
        page.mouse.move(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"], steps=2)
    told = page.locator(".js-plotly-plot .hoverlayer .bg").first
    told.wait_for(state="attached")
    covered = told.bounding_box()
    area = sum(each["width"] * each["height"] for each in map(lambda panel: panel.bounding_box(), panels.all()))
    assert 0 < covered["width"] * covered["height"] < 0.4 * area
    # It stands beside the instant that it tells of, which is that of the nearest point drawn.
    assert covered["x"] > box["x"] + 0.4 * box["width"]


def test_the_dot_on_the_orbit_is_the_state_at_the_cursor(visit):
    page = open_motion(visit)
    page.get_by_label("Time cursor").fill("0")
    next_frame(page)
    places = page.evaluate(
        """() => {
          const graph = [...document.querySelectorAll(".js-plotly-plot")].at(-1);
          const { xaxis, yaxis } = graph._fullLayout, home = graph.getBoundingClientRect();
          return [...graph.querySelectorAll(".time-cursor")].map((dot) => {
            const { left, top, width, height } = dot.getBoundingClientRect();
            return [xaxis.p2l(left + width / 2 - home.left - xaxis._offset),
                    yaxis.p2l(top + height / 2 - home.top - yaxis._offset)];
          });
        }"""
    )
    # Released at rest: the slab at 8 cm, block and top cylinder at 0; a pixel is about 0.1 cm and 0.2 cm/s.
    for place, expected in zip(places, ((8, 0), (0, 0), (0, 0)), strict=True):
        assert place == pytest.approx(expected, abs=0.4)


def test_plotly_keeps_its_zoom_and_png_and_each_body_has_its_name_in_its_area(visit):
    page = open_motion(visit, "?figure=energy")
    graph = page.locator(".js-plotly-plot")
    graph.hover()
    titles = [button.get_attribute("data-title") or "" for button in page.locator(".modebar-btn").all()]
    assert any("png" in title.lower() for title in titles)
    assert any("zoom" in title.lower() for title in titles)
    names = [label.text_content() for label in graph.locator(".annotation-text").all()]
    assert {"block", "hoop", "slab", "top cylinder", "spring", "total energy"} < set(names)
    assert graph.locator(".infolayer .legendtext").count() == 0


def test_the_cursor_follows_to_another_view_and_another_machine(visit):
    page = open_motion(visit, "?figure=energy")
    page.get_by_label("Time cursor").fill("0.5")
    choose(page, "momentum")
    nudge(page, "m", "End")
    (time,) = cursor_times(page)
    period = page.evaluate("document.querySelector('.js-plotly-plot').layout.meta.period")
    assert time == pytest.approx(0.5 * cache.PERIODS * period, rel=0.02)
    assert "figure=momentum" in page.url


def test_one_button_freezes_machine_and_figures_at_the_greatest_friction(visit):
    page = open_motion(visit, "?mu=0.07&figure=forces", motion="no-preference")
    page.locator(".st-key-moment button").click()
    next_frame(page)
    now = page.evaluate("globalThis.ramanujan.last('time/motion')")
    assert not now["playing"]
    assert cursor_times(page) == [pytest.approx(now["time"], abs=0.02)]
    # No contact is nearer to slipping at any other instant: looked for among ten thousand, by the core.
    machine = Oscillator(1, 1, 10)
    spacing = cache.drawn_spacing(machine.radius)
    times = np.linspace(0, machine.period, 10_001)

    def worst(t):
        q, _ = motion(machine, released(machine, 0.08), t)
        friction, normal = contact_forces(machine, q), normal_forces(machine, q, spacing=spacing)
        return np.max([np.abs(friction[name]) / normal[name] for name in normal], axis=0)

    assert worst(now["time"]) == pytest.approx(worst(times).max(), rel=1e-3)


def test_nothing_jumps_when_the_model_stops_to_hold(visit):
    page = open_motion(visit, "?mu=0.07&figure=forces")
    # Measured in the page: a key brings the slider that it moves into view.
    place = "document.querySelector('[role=tab]').getBoundingClientRect().top"
    place += " + document.querySelector('[data-testid=stMain]').scrollTop"
    top = page.evaluate(place)
    nudge(page, "mu", "Home")
    assert page.get_by_text("The model no longer holds.", exact=True).is_visible()
    assert page.evaluate(place) == pytest.approx(top, abs=1)


def test_choosing_a_view_moves_nothing_above_its_figure(visit):
    page = open_motion(visit)
    tabs = page.get_by_role("tab")
    tabs.first.scroll_into_view_if_needed()
    page.evaluate("document.querySelector('[data-testid=stMain]').scrollBy(0, 250)")
    next_frame(page)
    top = tabs.first.bounding_box()["y"]
    for i in (1, 3, 2, 0):
        tabs.nth(i).click()
        page.locator(PLOT).first.wait_for(state="attached")
        settle(page)
        assert tabs.first.bounding_box()["y"] == pytest.approx(top, abs=1)
        assert page.locator(".js-plotly-plot").first.bounding_box()["y"] < 720 - 200, "the figure is in view"


def test_the_csv_is_the_motion_shown(visit, tmp_path):
    page = open_motion(visit, "?m=2.5&glide=4&spin=-1.3&mu=0.11")
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV").click()
    path = tmp_path / download.value.suggested_filename
    download.value.save_as(path)
    lines = path.read_text(encoding="utf-8").splitlines()
    header = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    numbers = np.loadtxt(path, delimiter=",", skiprows=header + 1)
    motion = cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3)
    assert np.array_equal(numbers[:, 0], motion.t)
    assert np.array_equal(numbers[:, 1:7], np.concatenate([motion.q, motion.q_dot]).T)
    assert "# mu = 0.11" in lines
    another = open_motion(visit)
    for _ in range(3):
        nudge(another, "m_prime", "ArrowRight")
    assert page.request.get(download.value.url).ok, "a slow browser would have lost it in a class"
