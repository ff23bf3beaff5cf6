"""The motion page in a browser: bytes, the shared time cursor, the download, the layout."""

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.pages.motion import cache
from ramanujan.text.names import PARTS
from tests.checks.browser import drawn_deformation, inside, next_frame, settle, traffic

PLOT = ".js-plotly-plot .nsewdrag"
MARK = ".js-plotly-plot .time-cursor"


def open_motion(visit, query="", **more):
    page = visit(f"motion{query}", **more)
    page.wait_for_selector(PLOT, state="attached")
    return page


def nudge(page, key, press="ArrowRight"):
    """Move a slider by one step. Return the number of bytes that the server sent."""
    before = len(traffic(page).received)
    page.locator(f".st-key-{key} input[type=range]").first.focus()
    page.keyboard.press(press)
    settle(page)
    return sum(traffic(page).received[before:])


def cursor_times(page):
    """Wait until all figures over time have a line. Return the lines' times [s] by Plotly's scale."""
    page.wait_for_function(
        """[...document.querySelectorAll(".js-plotly-plot")]
          .every(({ layout }, i, graphs) => layout &&
            (layout.meta?.cursor !== "time" || graphs[i].querySelector(".time-cursor")))"""
    )
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
    page.locator(f".st-key-figure_{view} .nsewdrag").first.wait_for(state="attached")
    settle(page)


def test_one_cursor_moves_machine_and_figures_and_follows_to_another_view_and_machine(visit):
    page = open_motion(visit, height=1500)
    page.locator(".st-key-fold_phase_plane summary").click()
    page.locator(".st-key-figure_phase_plane .nsewdrag").wait_for(state="attached")
    check_cursor_by_keys(page)
    check_orbit(page)
    check_hover_and_click(page)
    check_dragged_cursor(page)
    choose(page, "momentum")
    page.get_by_label("Time cursor").fill("0.5")
    nudge(page, "m", "End")
    (time,) = cursor_times(page)
    period = page.evaluate("document.querySelector('.js-plotly-plot').layout.meta.period")
    assert time == pytest.approx(0.5 * cache.PERIODS * period, rel=0.02)
    assert "figure=momentum" in page.url
    choose(page, "energy")
    assert cursor_times(page) == [pytest.approx(time, rel=0.02)]
    check_energy(page)


def check_cursor_by_keys(page):
    """Check that the cursor moves all figures without the server."""
    slider = page.get_by_label("Time cursor")
    before = len(traffic(page).sent)
    slider.fill("0.3")
    next_frame(page)
    period = page.evaluate("document.querySelector('.js-plotly-plot').layout.meta.period")
    # A pixel is about a hundredth of a second.
    assert cursor_times(page) == [pytest.approx(0.3 * cache.PERIODS * period, abs=0.02)]
    assert page.locator(MARK).count() == 1 + 4
    slider.focus()
    page.keyboard.press("End")
    next_frame(page)
    assert cursor_times(page) == [pytest.approx(cache.PERIODS * period, abs=0.02)]
    assert slider.get_attribute("aria-valuetext").endswith("2.00 periods")
    assert len(traffic(page).sent) == before


def check_orbit(page):
    """Check that the dots on the orbits agree with the state at the cursor."""
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
    # Released at rest: block and top cylinder at 0, the slab at 8 cm, the lower rollers half as far. A pixel is at most
    # 0.1 cm.
    for place, expected in zip(places, ((0, 0), (4, 0), (8, 0), (0, 0)), strict=True):
        assert place == pytest.approx(expected, abs=0.4)


def check_hover_and_click(page):
    """Check that a pointer shows the values without covering the figure, and that a click moves the cursor."""
    panels = page.locator(".js-plotly-plot").first.locator(".nsewdrag")
    panel = panels.first.bounding_box()
    for share in (0.4, 0.45):
        page.mouse.move(panel["x"] + share * panel["width"], panel["y"] + 0.5 * panel["height"], steps=2)
    hover = page.locator(".js-plotly-plot .hoverlayer .bg").first
    hover.wait_for(state="attached")
    covered = hover.bounding_box()
    area = sum(each["width"] * each["height"] for each in map(lambda panel: panel.bounding_box(), panels.all()))
    assert 0 < covered["width"] * covered["height"] < 0.4 * area
    # The label is beside the moment of the nearest drawn point, on either side.
    moment, margin = panel["x"] + 0.45 * panel["width"], 0.05 * panel["width"]
    assert covered["x"] > moment - margin or covered["x"] + covered["width"] < moment + margin
    page.mouse.move(panel["x"] + 0.6 * panel["width"], panel["y"] + 0.5 * panel["height"], steps=4)
    page.wait_for_timeout(400)
    # A pointer without a click only shows values; the paused machine does not move.
    assert float(page.get_by_label("Time cursor").input_value()) == 0
    page.mouse.down()
    page.mouse.up()
    next_frame(page)
    assert float(page.get_by_label("Time cursor").input_value()) == pytest.approx(0.6, abs=0.01)
    # One label for all four curves relative to the ground.
    assert page.locator(".hoverlayer .traces").count() == 4


def check_dragged_cursor(page):
    """Check that the cursor moves the machine and the machine the cursor, without the server."""
    slider = page.get_by_label("Time cursor")
    slider.fill("0.25")  # half a period of the two shown: the spring is stretched by 8 cm
    next_frame(page)
    assert drawn_deformation(page) == pytest.approx(-8, abs=0.02)
    sent = len(traffic(page).sent)
    page.get_by_role("button", name="Steps, speed, view").click()
    page.get_by_role("button", name="Step forward").click()
    page.keyboard.press("Escape")
    next_frame(page)
    assert float(slider.input_value()) == pytest.approx(13 / 48, abs=1e-3)
    # A click on a figure pauses the machine at that time; the line can be dragged.
    panel = page.locator(PLOT).first.bounding_box()
    page.mouse.click(panel["x"] + 0.5 * panel["width"], panel["y"] + 20)
    next_frame(page)
    assert drawn_deformation(page) == pytest.approx(8, abs=0.1)
    line = page.locator(".time-cursor").first.bounding_box()
    x, y = line["x"] + line["width"] / 2, line["y"] + line["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + panel["width"] / 4, y, steps=5)
    page.mouse.up()
    next_frame(page)
    assert drawn_deformation(page) == pytest.approx(-8, abs=0.1)
    assert float(slider.input_value()) == pytest.approx(0.75, abs=2e-3)
    assert len(traffic(page).sent) == sent


def check_energy(page):
    """Check that Plotly offers its zoom, and that each body has its name once: in its area or in the legend."""
    graph = page.locator(".js-plotly-plot")
    graph.hover()
    titles = [button.get_attribute("data-title") or "" for button in page.locator(".modebar-btn").all()]
    assert any("zoom" in title.lower() for title in titles)
    names = [label.text_content() for label in graph.locator(".infolayer :is(.legendtext, .annotation-text)").all()]
    names.remove("one period")
    assert sorted(names) == sorted({*PARTS.values(), "total energy"})


def test_the_limits_of_the_model_and_of_the_picture_are_reported_without_a_jump(visit):
    page = open_motion(visit, "?mu=0.07&figure=forces")
    # No bench of the plain mass crosses the block.
    assert not inside(page, "root.querySelector('.bench')")
    # Positions are relative to the page, because a key scrolls its slider into view.
    place = "document.querySelector('[role=tab]').getBoundingClientRect().top"
    place += " + document.querySelector('[data-testid=stMain]').scrollTop"
    top = page.evaluate(place)
    nudge(page, "mu", "Home")
    assert page.get_by_text("The model no longer holds.", exact=True).is_visible()
    assert page.evaluate(place) == pytest.approx(top, abs=1)
    check_views(page)
    check_edge(open_motion(visit, "?spin=3", within=page))


def check_views(page):
    """Check that the choice of a view moves nothing above its figure, and that machine and figure are in view."""
    tabs = page.get_by_role("tab")
    tabs.first.scroll_into_view_if_needed()
    # The tabs are at the top of the page. Further down, the bar would cover them.
    page.evaluate("document.querySelector('[data-testid=stMain]').scrollBy(0, 20)")
    next_frame(page)
    top = tabs.first.bounding_box()["y"]
    for i in (1, 3, 2, 0):
        tabs.nth(i).click()
        page.locator(PLOT).first.wait_for(state="attached")
        settle(page)
        assert tabs.first.bounding_box()["y"] == pytest.approx(top, abs=1)
        assert page.locator(".js-plotly-plot").first.bounding_box()["y"] < 720 - 200, "the figure is in view"
        machine = page.locator("svg.machine").bounding_box()
        assert machine["y"] > 0, "the machine is in view"
        assert machine["y"] + machine["height"] < 720 - 200


def test_machine_and_graph_are_on_one_small_screen(visit):
    page = open_motion(visit)
    page.set_viewport_size({"width": 1000, "height": 768})
    settle(page)
    machine, graph = (page.locator(each).first.bounding_box() for each in ("svg.machine", ".js-plotly-plot"))
    assert machine["x"] + machine["width"] < graph["x"]
    assert max(box["y"] + box["height"] for box in (machine, graph)) < 768
    # On a phone the curves begin below the machine, before the settings, and their first half is above the drawer.
    page.set_viewport_size({"width": 390, "height": 844})
    settle(page)
    page.evaluate("document.querySelector('[data-testid=stMain]').scrollTo(0, 0)")
    next_frame(page)
    places = ("svg.machine", ".js-plotly-plot", "[class*=st-key-fold_velocities]")
    machine, graph, settings = (page.locator(each).first.bounding_box() for each in places)
    assert machine["y"] + machine["height"] < graph["y"]
    assert graph["y"] + graph["height"] < settings["y"]
    assert graph["y"] + graph["height"] / 2 < 800


def test_the_initial_velocities_are_beside_the_momenta_that_they_change(visit):
    page = open_motion(visit, "?figure=momentum")
    places = (".js-plotly-plot", ".st-key-glide", ".st-key-spin")
    # On a phone, with the graph at the top, they are above the drawer.
    for width, height, lowest in ((1280, 720, 720), (390, 844, 800)):
        page.set_viewport_size({"width": width, "height": height})
        settle(page)
        if width == 390:
            graph = page.locator(".js-plotly-plot").bounding_box()
            assert graph["y"] + graph["height"] < lowest, "machine and both sums are on one screen"
            top = page.locator(".js-plotly-plot").bounding_box()["y"] - 60
            page.evaluate("(top) => document.querySelector('[data-testid=stMain]').scrollBy(0, top)", top)
            next_frame(page)
        boxes = [page.locator(place).bounding_box() for place in places]
        assert min(box["y"] for box in boxes) > 0
        assert max(box["y"] + box["height"] for box in boxes) < lowest


def check_edge(page):
    """Check that picture and time cursor stop at the edge with a note."""
    page.wait_for_selector(".time-cursor", state="attached")
    slider = page.get_by_label("Time cursor")
    slider.fill("0.999")
    next_frame(page)
    assert "The picture stops there" in inside(page, "root.querySelector('.note').textContent")
    end = float(slider.input_value())
    assert 0.1 < end < 0.9
    # The core's mark in the figure is at the moment at which the picture stops.
    marked = "({ layout: { shapes: [veil], xaxis } }) => veil.x0 / xaxis.range[1]"
    assert page.locator(".js-plotly-plot").first.evaluate(marked) == pytest.approx(end, abs=0.005)
    places = "['.top', '.block'].map((name) => root.querySelector('.moving ' + name).transform.baseVal[0].matrix.e)"
    top, block = inside(page, places)
    place = top - block
    slider.fill("0.9")
    next_frame(page)
    top, block = inside(page, places)
    assert top - block == pytest.approx(place, abs=0.05)
    assert float(slider.input_value()) == pytest.approx(end)
    slider.fill("0")
    next_frame(page)
    assert drawn_deformation(page) == pytest.approx(8, abs=0.02)


def test_the_csv_is_the_motion_shown(visit, tmp_path):
    page = visit("motion?m=2.5&glide=4&spin=-1.3&mu=0.11", figures=False)
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV").click()
    path = tmp_path / download.value.suggested_filename
    download.value.save_as(path)
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    numbers = np.loadtxt(path, delimiter=",", skiprows=lines.index("") + 2, encoding="utf-8")
    motion = cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3)
    expected = np.concatenate([motion.t[None], motion.q, motion.q_dot]).T
    assert numbers[:, :7] == pytest.approx(expected, rel=1e-11, abs=1e-11)
    assert any(line.endswith(",0.11") for line in lines)
    another = visit("motion", beside=page, figures=False)
    for _ in range(3):
        nudge(another, "m_prime", "ArrowRight")
    assert page.request.get(download.value.url).ok, "a slow browser would have lost it in a class"
