"""A lecturer's view in the browser: what is hidden is nowhere, a projector shows large words and nothing to scroll."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from ramanujan import Oscillator
from tests.browser import next_frame, settle

MACHINE = Oscillator(1.0, 2.0, 10.0)
LINK = "m=1&m_prime=2&k=10"
TELLTALE = {
    "Ω²m/k": f"{MACHINE.normalized_frequency_squared:.7f}"[:6],
    "Ω": f"{MACHINE.natural_frequency:.3f}",
    "period": f"{MACHINE.period:.2f}",
    "turns to part": f"{1 / abs(MACHINE.normalized_frequency_squared**0.5 - 1):.1f}",
    "slower": "slower",
}
DOCUMENT = """() => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll('*')].flatMap((node) => [node, ...inside(node)]);
  const told = (node) => [...node.childNodes].filter((each) => each.nodeType === 3).map((each) => each.data);
  return all(document.body).filter((node) => !node.closest('script, style')).flatMap((node) =>
    [...told(node), ...[...node.attributes].filter((each) => /^(aria|title)/.test(each.name)).map((each) => each.value)]
  ).join('\\n');
}"""
"""All words of the page, those for the eye and those for a screen reader, also inside the components."""

SAID = "globalThis.ramanujan?.last?.('machine/oscillator') && ramanujan.last('say') === undefined"
"""The stage has drawn, and the live region has said what it had to say."""


def use(page) -> str:
    """Do what a reader may do to find out, and return all that the page says meanwhile."""
    page.wait_for_function(SAID)
    said = [page.evaluate(DOCUMENT)]
    for name in ("Step forward", "Step back"):
        if page.get_by_role("button", name=name, exact=True).count():
            page.get_by_role("button", name=name, exact=True).click()
            next_frame(page)
            said.append(page.evaluate(DOCUMENT))
    entry = page.locator(".st-key-m_exact input")
    entry.fill("1.000")
    entry.press("Enter")
    settle(page)
    page.wait_for_function(SAID)
    return "\n".join([*said, page.evaluate(DOCUMENT)])


def test_what_a_link_hides_is_nowhere_on_the_page(visit):
    page = visit(f"?{LINK}&hide=numbers,curve,clocks")
    said = use(page)
    assert "Velocities" in said
    assert not [name for name, words in TELLTALE.items() if words in said]
    assert page.locator(".js-plotly-plot").count() == 0
    parts = ".dial, .gauge, .verdict, .parting, .readouts, .legend b"
    assert page.locator(f".st-key-stage :is({parts})").count() == 0
    assert page.evaluate("ramanujan.last('present/oscillator').normalized") is None
    assert page.locator(".st-key-stage [data-step]:not([data-step=''])").count() == 0


def test_without_the_link_all_of_it_is_said(visit):
    """Negative control: the same search finds every word on the page that hides nothing."""
    said = use(visit(f"?{LINK}"))
    assert [name for name, words in TELLTALE.items() if words not in said] == []


@pytest.mark.parametrize("hide", ["motion", "motion,plain,numbers"])
def test_a_machine_whose_motion_is_hidden_stands_still(visit, hide):
    page = visit(f"?{LINK}&hide={hide}", motion="no-preference")
    where = "node => node.getAttribute('transform')"
    slab = page.locator(".st-key-stage .moving .body.slab")
    expect(slab).to_have_attribute("transform", re.compile(r"^translate\(8,? -?0\)$"))
    before = slab.evaluate(where)
    page.locator(".st-key-stage .stage").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(200)
    assert slab.evaluate(where) == before
    assert page.get_by_role("button", name="Pause", exact=True).count() == 0


# ---- on a projector

SIZES = """(small) => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll('*')].flatMap((node) => [node, ...inside(node)]);
  const around = ['.controls, .katex-mathml, .note, .pager, .bartext, [data-away]',
    '.stSlider, label, button, style, .mtight, tspan[style*="font-size:70%"]'];
  const drawn = { visibilityProperty: true, opacityProperty: true };
  const seen = (node) => node.checkVisibility(drawn) && !node.closest(around);
  const size = (node) => {
    const svg = node.ownerSVGElement, scale = svg && node.getScreenCTM ? node.getScreenCTM().d : 1;
    return parseFloat(getComputedStyle(node).fontSize) * (scale || 1);
  };
  const said = (each) => each.nodeType === 3 && each.data.replaceAll('\u200b', '').trim();
  const words = (node) => [...node.childNodes].some(said);
  const small_words = all(document.querySelector('.stMainBlockContainer'))
    .filter((node) => words(node) && seen(node) && size(node) < small);
  return small_words.map((node) => `${size(node).toFixed(1)} px: ${node.textContent.trim().slice(0, 30)}`);
}"""
"""The words of the present picture that are smaller than this; an index or an exponent is smaller by nature."""
TOO_HIGH = """() => {
  const main = document.querySelector('[data-testid=stMain]');
  return [main.scrollHeight - main.clientHeight, main.scrollWidth - main.clientWidth];
}"""
PICTURES = """() => {
  const pictures = [...document.querySelectorAll('.js-plotly-plot, [data-testid=stBidiComponentIsolated]')];
  const drawn = pictures.filter((node) => !node.shadowRoot || node.shadowRoot.querySelector('svg.machine'));
  return drawn.filter((node) => node.checkVisibility({ visibilityProperty: true })).length;
}"""
FIGURE = """() => {
  const seen = (node) => node.checkVisibility({ visibilityProperty: true });
  const figure = [...document.querySelectorAll('.js-plotly-plot')].find(seen);
  if (!figure) return null;
  const lines = [...figure.querySelectorAll('.main-svg :is(text:not(:has(.line)), .line)')];
  const words = lines.filter((line) => seen(line) && line.textContent.trim());
  // A line of letters is higher than its letters.
  const boxes = words.map((text) => [text.textContent, text.getBoundingClientRect()])
    .map(([text, { left, right, top, bottom }]) => ({ text, left, right, top: top + 4, bottom: bottom - 4 }));
  const shared = (a, b, from, to) => Math.min(a[to], b[to]) - Math.max(a[from], b[from]);
  const cover = (a, b) => shared(a, b, "left", "right") > 1 && shared(a, b, "top", "bottom") > 1;
  const covered = boxes.flatMap((a, i) =>
    boxes.slice(i + 1).filter((b) => cover(a, b)).map((b) => `${a.text} / ${b.text}`));
  return { height: figure.clientHeight / innerHeight, covered };
}"""
"""The present figure: how much of the screen's height it takes, and which of its words cover each other."""
PLACE = ".st-key-pager .place"
DRAWN = """!document.querySelector("[data-testid=stSkeleton]")
    && [...document.querySelectorAll(".stPlotlyChart")].every((chart) => chart.querySelector(".main-svg"))"""


@pytest.mark.parametrize(
    "path", ["?radius=5", "?radius=20", "derivation", "motion", "1729", "speed?periods=1", "lesson", "worksheet"]
)
def test_a_projector_shows_large_words_one_picture_at_a_time_and_no_scroll(visit, path):
    page = visit(f"{path}{'&' if '?' in path else '?'}view=projector")
    page.wait_for_selector(f"{PLACE}:not(:empty)")
    # Before the figures are there, other pieces make other sheets.
    page.wait_for_function(DRAWN)
    next_frame(page)
    next_frame(page)
    assert page.locator("[data-testid=stExpandSidebarButton]").is_visible()
    now, count = map(int, page.locator(PLACE).inner_text().split("/"))
    # What is asked in the lesson stands beside the machine, on one sheet; other pages take several.
    assert (now, count > 1) == (1, path != "lesson")
    for sheet in range(1, count + 1):
        assert page.evaluate(SIZES, 23.9) == [], sheet
        assert max(page.evaluate(TOO_HIGH)) <= 2, sheet
        shown = page.evaluate(PICTURES)
        assert shown <= 1, sheet
        if figure := page.evaluate(FIGURE):
            assert figure["covered"] == [], sheet
            assert figure["height"] > 0.6, sheet
        if sheet < count:
            page.locator(".st-key-pager .next").click()
            next_frame(page)
    page.set_viewport_size({"width": 1920, "height": 1080})
    next_frame(page)
    assert page.evaluate(SIZES, 23.9) == []


def test_a_figure_grows_with_the_projector(visit):
    page = visit("?view=projector", width=1920, height=1080)
    page.wait_for_selector(f"{PLACE}:not(:empty)")
    page.wait_for_function(DRAWN)
    page.keyboard.press("PageDown")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^2 /"))
    page.wait_for_function(f"({FIGURE})()?.height > 0.6")
    # Negative control: elsewhere a figure has a height of its own.
    page = visit("", width=1920, height=1080)
    page.wait_for_function(f"({FIGURE})()?.height < 0.4")


def test_on_a_projector_the_machine_stands_beside_what_is_asked_of_it_again(visit):
    page = visit("lesson?view=projector&chosen=two-clocks.ahead")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"/\s*2$"))
    page.get_by_role("button", name="Predict again").click()
    settle(page)
    expect(page.locator(PLACE)).to_have_text(re.compile(r"/\s*1$"))
    assert page.locator("[data-away]").count() == 0
    words, machine = (page.locator(place).first.bounding_box() for place in (".st-key-options button", "svg.machine"))
    assert words["x"] + words["width"] <= machine["x"]
    assert abs(words["y"] - machine["y"]) < machine["height"]


def test_a_clicker_turns_the_sheets_of_a_stop_and_then_the_stop(visit):
    page = visit("lesson?view=projector&chosen=two-clocks.ahead")
    stop = page.locator(".st-key-turn [data-testid=stBidiComponentIsolated] output")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^1 / 2$"))
    page.keyboard.press("PageDown")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^2 / 2$"))
    expect(stop).to_have_text(re.compile("^1/"))
    page.keyboard.press("PageDown")
    expect(stop).to_have_text(re.compile("^2/"))
    settle(page)
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^1 / "))
    page.keyboard.press("PageUp")
    expect(stop).to_have_text(re.compile("^1/"))
    settle(page)
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^1 / 2$"))


def test_without_a_projector_the_words_are_smaller_and_the_page_is_one(visit):
    """Negative control."""
    page = visit("motion")
    assert page.evaluate(SIZES, 23.9)
    assert page.evaluate(TOO_HIGH)[0] > 300
    assert page.locator(PLACE).count() == 0


def test_the_switch_puts_the_view_into_the_address_and_takes_it_out(visit):
    page = visit("motion")
    page.locator(".st-key-projector label").click()
    page.wait_for_url("**view=projector*")
    page.wait_for_selector(f"{PLACE}:not(:empty)")
    settle(page)
    page.keyboard.press("PageDown")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^2 /"))
    if page.locator("[data-testid=stExpandSidebarButton]").is_visible():
        page.locator("[data-testid=stExpandSidebarButton]").click()
    page.locator(".st-key-projector label").click()
    page.wait_for_function("!location.search.includes('projector')")
    page.wait_for_function("!document.querySelector('[data-away]')")
