"""The app under a finger: what is swiped over stays as it was, and sliders and machine are seen together."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser import CHROMIUM, count_anew, listen, settle

SCROLLED = "document.querySelector('[data-testid=stMain]').scrollTop"


class Phone:
    """A page with touch, and what a finger does on it."""

    def __init__(self, page, server: str) -> None:
        self.page, self.server, self.path = page, server, None
        self.client = page.context.new_cdp_session(page)

    def open(self, path: str, selector: str, *, anew: bool = True):
        """Open a page; with anew=False it may be as the test before has left it, scrolled somewhere."""
        if (self.path, anew) == (path, False):
            return self.page
        self.path = path
        count_anew(self.page)
        self.page.goto(f"{self.server}/{path}")
        self.page.locator(selector).first.wait_for(state="attached", timeout=60_000)
        settle(self.page)
        return self.page

    def swipe(self, place: dict[str, float], dx: float, dy: float, at: tuple[float, float] = (0.5, 0.5)) -> None:
        x, y = place["x"] + at[0] * place["width"], place["y"] + at[1] * place["height"]
        for n in range(13):
            points = [{"x": x + dx * n / 12, "y": y + dy * n / 12}]
            self.client.send(
                "Input.dispatchTouchEvent", {"type": "touchMove" if n else "touchStart", "touchPoints": points}
            )
            self.page.wait_for_timeout(16)
        self.client.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        self.page.wait_for_timeout(400)

    def scrolled(self, top: float) -> None:
        """Wait until the page has been scrolled down from there."""
        self.page.wait_for_function(f"{SCROLLED} > {top} + 50")

    def handle(self) -> None:
        """Open or close the sheet, and wait until it has come to rest."""
        self.page.locator(".st-key-handle button").tap()
        self.page.wait_for_timeout(100)
        self.page.wait_for_function("!document.querySelector('[data-testid=stSidebar]').getAnimations().length")

    @property
    def top(self) -> float:
        return self.page.evaluate(SCROLLED)

    @property
    def sliders(self) -> list[str]:
        return self.page.evaluate("[...document.querySelectorAll('.stSlider input')].map((input) => input.value)")


@pytest.fixture(scope="module")
def phone(server, profile):
    if CHROMIUM is None:
        pytest.skip("no browser")
    context = profile.browser.new_context(
        viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True, reduced_motion="reduce"
    )
    page = context.new_page()
    listen(page)
    yield Phone(page, server)
    context.close()


def test_only_a_horizontal_move_or_a_tap_is_meant_for_a_slider(phone):
    page = phone.open("", ".st-key-k input[type=range]")
    phone.handle()
    track = page.locator(".st-key-k .stSlider [role=group]")
    before = phone.sliders
    for dx, dy, at in ((5, -120, (0.7, 0.5)), (40, -110, (0.6, 0.5)), (4, 60, (0.09, 0.5))):
        phone.swipe(track.bounding_box(), dx, dy, at)
        page.evaluate("document.querySelector('[data-testid=stSidebarContent]').scrollTop = 0")
        assert phone.sliders == before
    phone.swipe(page.locator(".st-key-k [style*=left]").first.bounding_box(), 50, 3)
    moved = phone.sliders
    assert [old == new for old, new in zip(before, moved, strict=True)] == [True, False, True, True, True, True]
    where = track.bounding_box()
    page.touchscreen.tap(where["x"] + 0.9 * where["width"], where["y"] + where["height"] / 2)
    page.wait_for_function(f"document.querySelectorAll('.stSlider input')[1].value > {moved[1]}")
    settle(page)


def test_sliders_and_machine_are_seen_together_and_choosing_a_page_closes_the_sheet(phone):
    page = phone.open("", ".st-key-k input[type=range]")
    handle = page.locator(".st-key-handle button")
    # One who arrives reads the question first, with the machine below it.
    assert handle.get_attribute("aria-expanded") == "false"
    for words in ("When does this machine", "Take the lesson"):
        expect(page.get_by_text(words)).to_be_in_viewport(ratio=1)
    machine, slider = (page.locator(each).bounding_box() for each in (".st-key-stage svg.machine", ".st-key-m_prime"))
    # The slider that the question names stands above the whole machine.
    assert slider["y"] < machine["y"]
    assert machine["y"] + machine["height"] < handle.bounding_box()["y"]
    phone.handle()
    sheet = page.locator("[data-testid=stSidebar]").bounding_box()
    for key in ("m", "k", "compression"):
        place = page.locator(f".st-key-{key} .stSlider").bounding_box()
        assert sheet["y"] < place["y"]
        assert place["y"] + place["height"] <= 844
    machine = page.locator(".st-key-stage svg.machine").bounding_box()
    clock = page.locator(".st-key-stage svg.dial").bounding_box()
    play = page.get_by_role("button", name="Play", exact=True).bounding_box()
    assert machine["y"] >= 48
    assert max(each["y"] + each["height"] for each in (machine, clock, play)) <= sheet["y"]
    assert play["height"] >= 44
    page.locator("[data-testid=stSidebarNavLink]", has_text="Motion").tap()
    page.locator(".js-plotly-plot .nsewdrag").first.wait_for(state="attached")
    settle(page)
    assert handle.get_attribute("aria-expanded") == "false"
    assert handle.bounding_box()["y"] > 780
    # Far down the page, opening the sheet brings the machine back, and closing it the place where one read.
    page.evaluate("document.querySelector('[data-testid=stMain]').scrollTop = 900")
    phone.handle()
    assert page.locator(".st-key-stage svg.machine").bounding_box()["y"] >= 0
    phone.handle()
    page.wait_for_function(f"Math.abs({SCROLLED} - 900) <= 2")


def test_figures_let_swipes_through_and_never_zoom(phone):
    page = phone.open("motion", ".js-plotly-plot .nsewdrag")
    figure = page.locator(".js-plotly-plot .nsewdrag").first
    page.evaluate("document.querySelector('.js-plotly-plot').scrollIntoView({block: 'center'})")
    ranges = (
        "JSON.stringify(['xaxis', 'yaxis'].map((axis) => document.querySelector('.js-plotly-plot').layout[axis].range))"
    )
    before, top = page.evaluate(ranges), phone.top
    phone.swipe(figure.bounding_box(), 70, -200, (0.3, 0.6))
    phone.scrolled(top)
    assert page.evaluate(ranges) == before


@pytest.mark.parametrize(
    "path", ["", "motion", "derivation?show=reading", "speed?periods=1", "1729?p=1000&q=999&digits=1000&left=sphere"]
)
def test_nothing_scrolls_sideways_on_a_narrow_phone(phone, path):
    page = phone.open(path, "[data-testid=stMain] h1", anew=False)
    page.set_viewport_size({"width": 320, "height": 640})
    wide = []
    for view in page.get_by_role("tab").all() or [page.locator("h1")]:
        view.click()
        page.wait_for_timeout(500)
        settle(page)
        wide += page.evaluate(
            "[document.documentElement, document.querySelector('[data-testid=stMain]')].map((n) => n.scrollWidth)"
        )
    small = page.evaluate("""() => [...document.querySelectorAll('main button, [data-testid=stSidebarNavLink]')]
        .filter((node) => node.offsetParent && node.tabIndex >= 0)
        .filter((node) => !node.closest('.modebar, .stTooltipIcon, [role=tablist]'))
        .filter((node) => node.getBoundingClientRect().height < 43.5).map((node) => node.outerHTML.slice(0, 160))""")
    page.set_viewport_size({"width": 390, "height": 844})
    assert max(wide) <= 320
    assert small == []


def test_cubes_let_swipes_and_wheels_through(phone):
    page = phone.open("1729?p=1000&q=999&digits=1000&left=sphere", ".st-key-cubes_12 canvas", anew=False)
    page.locator(".st-key-cubes_12 canvas").first.wait_for(state="attached")
    cubes = page.locator(".st-key-cubes_12")
    cubes.evaluate("node => node.scrollIntoView({block: 'center'})")
    page.wait_for_timeout(300)
    top = phone.top
    phone.swipe(cubes.bounding_box(), 5, -150)
    phone.scrolled(top)
    top, place = phone.top, cubes.bounding_box()
    page.mouse.move(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
    page.mouse.wheel(0, 120)
    phone.scrolled(top)
