"""Five journeys through the whole app in Firefox and in WebKit, each in a fresh window.

They use the common features of both drivers: evaluation of JavaScript, a mouse, a keyboard. Chromium is tested further
in the files of the pages.
"""

import time
from collections.abc import Callable
from io import BytesIO

import pytest
from PIL import Image

from ramanujan import UNIT_MASS_RATIO, Oscillator
from tests.checks.browser import STAGE, drawn_deformation, inside, next_frame, script
from tests.checks.layout import SCROLLED
from tests.checks.paper import CUT
from tests.settings import PATIENCE

BOTH = pytest.mark.parametrize("engine", ["firefox", "webkit"])

FIND = script("find")
"""The first visible element with this selector and name, or null. "A >> B" is B in the component in A."""


class Visitor:
    """A visitor of the app with a mouse and a keyboard."""

    def __init__(self, page: object, address: str) -> None:
        self.page = page
        page.goto(address)
        page.wait_for_function("Boolean(document.querySelector('[data-test-script-state=notRunning] h1'))")

    def find(self, selector: str, name: str = "") -> dict | None:
        return self.page.evaluate(FIND, [selector, name])

    def until(self, selector: str, name: str = "", timeout: float = 1000 * PATIENCE) -> dict:
        """Wait until an element is visible."""
        self.page.wait_for_function(FIND, arg=[selector, name], timeout=timeout)
        return self.find(selector, name)

    def wait(self, condition: str) -> None:
        """Wait until a JavaScript expression is true."""
        self.page.wait_for_function(f"Boolean({condition})", timeout=1000 * PATIENCE)

    def click(self, selector: str, name: str = "") -> None:
        """Click on an element once it is still and uncovered."""
        before, end = None, time.monotonic() + PATIENCE
        while (place := self.until(selector, name)) != before or not place["isSteady"]:
            assert time.monotonic() < end, f"{selector} {name} is covered, or never still"
            before = place
            next_frame(self.page)
        self.page.mouse.click(place["x"], place["y"])

    def hold(self, selector: str, dx: float) -> None:
        """Press on an element and drag it `dx` pixels to the right, without releasing the button."""
        place = self.until(selector)
        self.page.mouse.move(place["x"], place["y"])
        self.page.mouse.down()
        self.page.mouse.move(place["x"] + dx, place["y"], steps=6)
        next_frame(self.page)

    def write(self, selector: str, text: str) -> None:
        """Replace the text of a box, and press Enter."""
        self.click(selector)
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(text)
        self.page.keyboard.press("Enter")

    def read(self, selector: str, name: str = "") -> str:
        return self.until(selector, name)["text"]


@pytest.fixture
def at(window: Callable, server: str) -> Callable[..., Visitor]:
    """Open a page of the app, as in at("motion?m=2")."""
    return lambda address="", **options: Visitor(window(**options), f"{server}/{address}")


THUMB = ".st-key-m_prime [style*=left]"
RATIO = "ramanujan.last('drawn/oscillator').ratio"


def check_stage(visitor: Visitor) -> Oscillator:
    """Compare the stage's readouts with the core's values for the drawn machine. Return the machine."""
    known = visitor.page.evaluate("ramanujan.last('drawn/oscillator').parameters")
    machine = Oscillator(**{name: known[name] for name in ("m", "m_prime", "k", "radius")})
    normalized = inside(visitor.page, "root.querySelector('[data-read=normalized]').textContent")
    assert float(normalized) == pytest.approx(machine.normalized_frequency_squared, abs=1e-6)
    return machine


@BOTH
def test_first_page_drag_type_drag_the_slab_and_bring_both_into_step(at):
    visitor = at("?k=20&hide=curve,steps")
    page = visitor.page
    visitor.wait("globalThis.ramanujan?.last('time/oscillator')")
    visitor.hold(THUMB, 300)
    # The next frame shows the dragged value.
    assert check_stage(visitor).mass_ratio > 1.1
    page.mouse.up()
    visitor.wait("/m_prime=(1\\.[6-9]|2)/.test(location.search)")
    visitor.write(".st-key-m_prime_exact >> input", "3/2")
    visitor.wait(f"{RATIO} === 1.5")
    check_stage(visitor)
    place = visitor.until(".moving .body.slab .form")
    page.mouse.move(place["x"], place["y"])
    page.mouse.down()
    page.mouse.move(place["x"] - 60, place["y"], steps=5)
    next_frame(page)
    drawn = drawn_deformation(page)
    assert drawn == pytest.approx(page.evaluate("ramanujan.last('drawn/oscillator').parameters.compression") * 100)
    assert drawn < 7
    page.mouse.up()
    visitor.wait("location.search.includes('compression=')")
    visitor.click("button", "Bring them into step")
    visitor.wait(f"{STAGE}.querySelector('[data-step]').dataset.step === 'in-step'")
    assert check_stage(visitor).mass_ratio == pytest.approx(UNIT_MASS_RATIO, rel=1e-15)


@BOTH
def test_motion_one_moment_in_every_figure(at):
    visitor = at("motion")
    visitor.until(".js-plotly-plot .nsewdrag")
    visitor.click(".cursor input")
    for key, periods, side in (("End", 2, "right"), ("Home", 0, "left")):
        visitor.page.keyboard.press(key)
        next_frame(visitor.page)
        lines, ends, now = visitor.page.evaluate(f"""(() => {{
          const graphs = [...document.querySelectorAll(".js-plotly-plot:has(.time-cursor)")];
          const overTime = graphs.filter((graph) => graph.layout.meta.cursor === "time");
          const box = (selector) => overTime.map((graph) => graph.querySelector(selector).getBoundingClientRect());
          const lines = box(".time-cursor").map(({{ x, width }}) => x + width / 2);
          return [lines, box(".nsewdrag").map((panel) => panel.{side}),
            ramanujan.last("time/motion").time];
        }})()""")
        assert now == pytest.approx(periods * Oscillator(1.0, 1.0, 10.0).period, rel=1e-6)
        assert lines
        assert lines == pytest.approx(ends, abs=2)


@pytest.mark.parametrize("engine", ["webkit"])
def test_a_lesson_with_a_vote_from_two_browsers(at):
    desk, says = at("lesson", name="chromium"), "document.body.innerText.includes({!r})".format
    for key in ("door", "open"):
        desk.click(f".st-key-class_{key} button")
    desk.wait("location.search.includes('lecturer=')")
    code = desk.page.url.partition("lecturer=")[2][:6]
    phone = at(f"lesson?class={code}", width=390, height=844)
    phone.wait(says("The first question will appear here"))
    desk.click(".st-key-class_ask button")
    phone.click(".st-key-class_phone [role=radiogroup] label")
    phone.wait(says("Your answer counts"))
    desk.wait(says("Answers: 1 of 1"))
    desk.click(".st-key-class_reveal button")
    for visitor in (desk, phone):
        visitor.wait(says("1 of 1, 100\u202f%"))


@BOTH
def test_a_projector_is_turned_by_keys(at):
    visitor = at("1729?view=projector")
    visitor.until(".st-key-pager >> select")
    visitor.until("[class*=st-key-slide-]:not([data-away]) .katex-display")
    # WebKit computes a wrong width of a formula with a negative space.
    assert visitor.page.evaluate(SCROLLED) == []
    for key, names_slide in (("PageDown", True), ("PageUp", False)):
        visitor.page.keyboard.press(key)
        visitor.wait(f"/slide=/.test(location.search) === {str(names_slide).lower()}")
        assert visitor.page.evaluate("document.querySelectorAll('[class*=st-key-slide-]:not([data-away])').length") == 1
        assert visitor.page.evaluate("document.querySelector('[data-testid=stMain]').scrollHeight <= innerHeight")


@BOTH
def test_worksheet_on_paper(at):
    visitor = at("worksheet?level=1", width=681, height=1000)  # A4 without its margins
    visitor.until(".st-key-worksheet_picture img")
    # Only one of the three browsers can print, so the test applies the rules for paper to the screen.
    visitor.page.evaluate("""() => {
      const on = { screen: "not all", print: "all" };
      const sheets = [...document.styleSheets], rules = sheets.flatMap((sheet) => [...sheet.cssRules]);
      for (const { media } of [...sheets, ...rules].filter((each) => each.media))
        media.mediaText = media.mediaText.replace(/^(screen|print)/, (word) => on[word]);
    }""")
    assert visitor.find("section[data-testid=stSidebar] *") is None
    assert visitor.find("button") is None
    picture, text = visitor.until(".st-key-worksheet_picture img"), visitor.until(".st-key-worksheet_picture")
    assert picture["width"] > 0.55 * text["width"]
    left, top = (picture[each] - picture[size] / 2 for each, size in (("x", "width"), ("y", "height")))
    whole = Image.open(BytesIO(visitor.page.screenshot())).convert("L")
    drawn = whole.crop((left, top, left + picture["width"], top + picture["height"])).point(lambda gray: gray < 160)
    across, _, end, _ = drawn.getbbox()
    assert end - across > 0.9 * picture["width"]
    assert visitor.page.evaluate(CUT) == []
