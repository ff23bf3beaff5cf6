"""The app on a phone: swipes change nothing, and sliders and machine are visible together."""

from collections.abc import Callable
from itertools import pairwise

import pytest
from playwright.sync_api import Page, expect

from tests.checks.browser import ROOT, clock_rate, go, inside, next_frame, running, settle

SIZES = ((667, 375), (844, 390))
"""Height and width of a small and of a common phone."""
THUMB = ".st-key-m_prime [style*=left]"
SCROLLED = "document.querySelector('[data-testid=stMain]').scrollTop"
CENTRED = "(node) => node.scrollIntoView({ block: 'center' })"


class Phone:
    """A page with touch input."""

    def __init__(self, page) -> None:
        self.page = page
        self.client = page.context.new_cdp_session(page)

    def box(self, selector: str) -> dict[str, float]:
        return self.page.locator(selector).first.bounding_box()

    def swipe(
        self,
        place: dict[str, float],
        dx: float,
        dy: float,
        at: tuple[float, float] = (0.5, 0.5),
        meanwhile: Callable[[], object] = lambda: None,
    ) -> None:
        x, y = place["x"] + at[0] * place["width"], place["y"] + at[1] * place["height"]
        for n in range(13):
            points = [{"x": x + dx * n / 12, "y": y + dy * n / 12}]
            self.client.send(
                "Input.dispatchTouchEvent", {"type": "touchMove" if n else "touchStart", "touchPoints": points}
            )
            self.page.wait_for_timeout(16)
        meanwhile()
        self.client.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        self.page.wait_for_timeout(400)

    def scrolled(self, top: float) -> None:
        """Wait until the page has been scrolled down from this position."""
        self.page.wait_for_function(f"{SCROLLED} > {top} + 50")

    def handle(self) -> None:
        """Open or close the drawer, and wait for the end of its movement."""
        self.page.locator(".st-key-handle button").tap()
        self.page.wait_for_timeout(100)
        self.page.wait_for_function("!document.querySelector('[data-testid=stSidebar]').getAnimations().length")

    def go_to(self, name: str, selector: str) -> None:
        """Choose a page in the bar, and wait for it."""
        self.page.locator("[data-testid=stSidebarNavLink]", has_text=name).tap()
        self.page.locator(selector).first.wait_for(state="attached")
        settle(self.page)

    @property
    def top(self) -> float:
        return self.page.evaluate(SCROLLED)

    @property
    def sliders(self) -> list[str]:
        return self.page.evaluate("[...document.querySelectorAll('.stSlider input')].map((input) => input.value)")


def check_arrival(phone: Phone) -> None:
    """Check that question, button, machine, slider and clock are visible together, also on a small phone."""
    places = (".st-key-story button", ".st-key-stage svg.machine", ".st-key-m_prime", ".st-key-stage svg.dial")
    story = phone.page.locator(places[0])

    def check_visible() -> None:
        expect(phone.page.get_by_text("Each clock hand turns once in a period")).to_be_in_viewport(ratio=1)
        boxes = [phone.box(each) for each in places]
        assert all(a["y"] + a["height"] <= b["y"] + 1 for a, b in pairwise(boxes))
        assert boxes[-1]["y"] + boxes[-1]["height"] <= phone.page.viewport_size["height"]

    for height, width in reversed(SIZES):
        phone.page.set_viewport_size({"width": width, "height": height})
        phone.swipe(phone.box(THUMB), 30, 2, meanwhile=check_visible)
    # During the story on the small phone. On a slow machine the checks take longer than a scene of three seconds.
    phone.page.evaluate(clock_rate(1 / 3))
    phone.page.emulate_media(reduced_motion="no-preference")
    story.tap()
    for sentence in ("Equal masses", "Heavier rollers"):
        expect(phone.page.locator(".st-key-story .sentence")).to_contain_text(sentence)
        check_visible()
    story.tap()
    expect(story).to_have_text("Bring them into step")
    phone.page.evaluate(clock_rate(3))
    phone.page.emulate_media(reduced_motion="reduce")
    phone.page.set_viewport_size({"width": 390, "height": 844})
    settle(phone.page)
    # On a common phone the machine is as large as the width allows, and its controls are in view, too.
    controls = phone.box(".st-key-stage .controls")
    assert controls["y"] + controls["height"] <= 844
    # The unit of the picture is 1 cm, and a roller has a diameter of 20 cm.
    assert 20 * inside(phone.page, "root.querySelector('svg.machine').getScreenCTM().a") >= 52
    assert phone.box(".st-key-m_prime")["width"] >= 350


def check_drawer(phone: Phone) -> None:
    """Check that all sliders are visible in the open drawer, and the machine and its button above it."""
    drawer = phone.box("[data-testid=stSidebar]")
    for key in ("m", "k", "compression"):
        place = phone.box(f".st-key-{key} .stSlider")
        assert drawer["y"] < place["y"]
        assert place["y"] + place["height"] <= 844
    machine = phone.box("svg.machine")
    play = phone.page.get_by_role("button", name="Play", exact=True).bounding_box()
    assert machine["y"] >= 48
    assert max(each["y"] + each["height"] for each in (machine, play)) <= drawer["y"]
    assert play["height"] >= 44


def check_sliders(phone: Phone) -> None:
    """Check that only a horizontal move or a tap changes a slider."""
    track, before = ".st-key-k .stSlider [role=group]", phone.sliders
    for dx, dy, at in ((5, -120, (0.7, 0.5)), (40, -110, (0.6, 0.5)), (4, 60, (0.09, 0.5))):
        phone.swipe(phone.box(track), dx, dy, at)
        phone.page.evaluate("document.querySelector('[data-testid=stSidebarContent]').scrollTop = 0")
        assert phone.sliders == before
    phone.swipe(phone.box(".st-key-k [style*=left]"), 50, 3)
    moved = phone.sliders
    assert [n for n, (old, new) in enumerate(zip(before, moved, strict=True)) if old != new] == [2]
    where = phone.box(track)
    phone.page.touchscreen.tap(where["x"] + 0.9 * where["width"], where["y"] + where["height"] / 2)
    phone.page.wait_for_function(f"document.querySelectorAll('.stSlider input')[2].value > {moved[2]}")
    settle(phone.page)


def check_return(phone: Phone) -> None:
    """Check that opening the drawer scrolls to the machine, and closing it scrolls back to the text."""
    phone.page.evaluate(f"{SCROLLED} = 400")
    phone.handle()
    assert phone.box("svg.machine")["y"] >= 0
    phone.handle()
    phone.page.wait_for_function(f"Math.abs({SCROLLED} - 400) <= 2")


def check_stop(phone: Phone) -> None:
    """Check that machine, clock and slider of a stop are visible together during a drag, without a drawer."""
    go(phone.page, "lesson?stop=by-hand&chosen=by-hand.quarter")
    parting = phone.page.locator(".parting")
    expect(phone.page.locator(".st-key-handle")).not_to_be_in_viewport()

    def check_visible() -> None:
        machine, dial, slider = map(phone.box, ("svg.machine", "svg.dial", ".st-key-stop_slider"))
        assert machine["y"] >= 48
        assert machine["y"] + machine["height"] <= dial["y"]
        assert dial["y"] + dial["height"] <= slider["y"]
        assert slider["y"] + slider["height"] <= phone.page.viewport_size["height"]
        assert parting.inner_text() != before

    for height, width in SIZES:
        phone.page.set_viewport_size({"width": width, "height": height})
        next_frame(phone.page)
        top = phone.box("svg.machine")["y"] - 60
        phone.page.evaluate(f"document.querySelector('[data-testid=stMain]').scrollBy(0, {top})")
        before = parting.inner_text()
        phone.swipe(phone.box(THUMB), 30, 2, meanwhile=check_visible)


def check_figure(phone: Phone) -> None:
    """Check that a swipe on a figure scrolls the page and does not zoom."""
    ranges = "(graph) => JSON.stringify(['xaxis', 'yaxis'].map((axis) => graph.layout[axis].range))"
    graph = phone.page.locator(".js-plotly-plot").first
    graph.evaluate(CENTRED)
    before, top = graph.evaluate(ranges), phone.top
    phone.swipe(phone.box(".js-plotly-plot .nsewdrag"), 70, -200, (0.3, 0.6))
    phone.scrolled(top)
    assert graph.evaluate(ranges) == before


def check_cubes(phone: Phone) -> None:
    """Check that swipes and the wheel on the stacks of cubes scroll the page."""
    cubes = phone.page.locator(".st-key-cubes svg").first
    cubes.evaluate(CENTRED)
    phone.page.wait_for_timeout(300)
    top = phone.top
    phone.swipe(cubes.bounding_box(), 5, -150)
    phone.scrolled(top)
    top, place = phone.top, cubes.bounding_box()
    phone.page.mouse.move(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
    phone.page.mouse.wheel(0, 120)
    phone.scrolled(top)


def test_a_visit_with_one_finger(visit):
    page = visit(width=390, height=844, has_touch=True, is_mobile=True)
    phone, handle = Phone(page), page.locator(".st-key-handle button")
    check_arrival(phone)
    assert handle.count() == 0
    phone.go_to("Motion", ".js-plotly-plot .nsewdrag")
    assert handle.get_attribute("aria-expanded") == "false"
    phone.handle()
    check_drawer(phone)
    check_sliders(phone)
    # The choice of a page closes the drawer.
    phone.go_to("Motion", ".js-plotly-plot .nsewdrag")
    assert handle.get_attribute("aria-expanded") == "false"
    assert handle.bounding_box()["y"] > 780
    check_return(phone)
    check_figure(phone)
    phone.go_to("1729", ".st-key-cubes svg")
    check_cubes(phone)
    phone.go_to("Lesson", "svg.dial")
    check_stop(phone)


def check_worksheet(page: Page) -> None:
    """Check that the formulas of the worksheet are legible."""
    lines = page.locator(".st-key-worksheet [class*=st-key-question-] p:not(:has(> :not(.katex)))")
    lines.first.wait_for(state="attached")
    settle(page)
    assert lines.count() > 5
    sizes = lines.locator("> .katex").evaluate_all("nodes => nodes.map((node) => getComputedStyle(node).fontSize)")
    assert min(float(size.removesuffix("px")) for size in sizes) >= 14
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    # On a phone of this width no formula has to be scrolled.
    assert lines.evaluate_all("nodes => nodes.every((node) => node.scrollWidth <= node.clientWidth)")


def check_bar_of_energies(page: Page) -> None:
    """Check that the bar of energies does not cover the slider."""
    bar = page.locator(".st-key-stage .energy .bar").bounding_box()
    box = page.locator(".st-key-m_prime_exact input").bounding_box()
    clock = page.locator(".st-key-stage svg.dial").bounding_box()
    assert box["y"] + box["height"] <= bar["y"]
    assert page.locator(".st-key-stage .energy").evaluate("(node) => node.getBoundingClientRect().bottom") <= clock["y"]


SMALL = ((390, 664), (844, 390))
"""Width and height of a small phone with the browser's bars, in both orientations."""
IN_ENGLISH = [("zero-modes", "none"), ("1729", "second")]
IN_GERMAN = [("exactly", "eighths")]
IN_HUNGARIAN = [("steps", "verlet")]
"""Stops with the least room, each with a wrong option."""


def check_stop_fits(page: Page, stop: str, wrong: str) -> None:
    """Check that an open question and its options are in view, and that the answered stop is two screens long."""
    for width, height in SMALL:
        page.set_viewport_size({"width": width, "height": height})
        next_frame(page)
        top = page.locator("[data-testid=stSidebar]").bounding_box()["y"]
        assert page.locator(".st-key-lead-question h1").bounding_box()["y"] >= 48
        for option in page.locator(".st-key-options button").all():
            box = option.bounding_box()
            assert box["y"] + box["height"] <= top
    for key in (f"option_{stop}_{wrong}", f"on_{stop}", f"on_{stop}"):
        page.locator(f".st-key-{key} button").tap()
        settle(page)
    assert page.locator(":is(.st-key-lead-marked, .st-key-lead-verdict) .stMarkdown").count() == 2
    for width, height in SMALL:
        page.set_viewport_size({"width": width, "height": height})
        next_frame(page)
        assert page.evaluate("document.querySelector('[data-testid=stMain]').scrollHeight") <= 2 * height, (width, stop)


def check_stops_fit(visit, address: str, stops: list[tuple[str, str]]) -> Page:
    """Check these stops of the app at an address. Return the page."""
    page = None
    for stop, wrong in stops:
        query, phone = f"lesson?stop={stop}", {"has_touch": True, "is_mobile": True}
        page = visit(query, within=page, network=address, width=390, height=664, **phone)
        check_stop_fits(page, stop, wrong)
    return page


def test_stops_formulas_and_the_bar_of_energies_fit_on_a_small_phone(visit, server):
    page = check_stops_fit(visit, server, IN_ENGLISH)
    check_worksheet(visit("worksheet", width=390, height=844, within=page))
    check_bar_of_energies(visit("?layers=energy", width=390, height=844, within=page))


@pytest.mark.xdist_group("german")
def test_a_german_stop_fits_on_a_small_phone(visit, german):
    check_stops_fit(visit, german, IN_GERMAN)


def test_a_hungarian_stop_fits_on_a_small_phone(visit):
    with running(ROOT / "app.py", RAMANUJAN_LANGUAGE="hu") as address:
        check_stops_fit(visit, address, IN_HUNGARIAN)
