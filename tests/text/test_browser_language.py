"""The app in German: longer words are neither cut nor covered, and numbers have decimal commas.

They also fit a narrow phone, on which nothing scrolls sideways.
"""

import re

import pytest

from tests.checks.browser import script, settle
from tests.checks.layout import ADDRESSES, OVERLAPS

pytestmark = pytest.mark.xdist_group("german")

CUT = script("cut")
"""Elements that are too wide and do not scroll. Streamlit's bar of pages moves long names into a menu."""
COVER = """() => {
  const [h1, tick] = [document.querySelector("h1"), document.querySelector(".js-plotly-plot svg .xtick text")];
  const over = h1.cloneNode();
  over.textContent = "over the title";
  over.style = `position:absolute;top:${h1.offsetTop}px;left:${h1.offsetLeft}px`;
  h1.after(over);
  if (tick) tick.parentElement.appendChild(tick.cloneNode()).textContent = "over a tick";
  return tick ? ["over the title", "over a tick"] : ["over the title"];
}"""
"""Covers the title and the label of a tick with texts, and returns these."""


BAR = """() => {
  const box = (node) => node.getBoundingClientRect(), names = [...document.querySelectorAll("header .rc-overflow > *")];
  return [Math.max(...names.map((node) => box(node).right)), box(document.querySelector(".st-key-bar")).left];
}"""
"""The right end of the names of the pages, and the left end of the bar beside them."""
SMALL = """() => [...document.querySelectorAll("main button, [data-testid=stSidebarNavLink]")]
  .filter((node) => node.offsetParent && node.tabIndex >= 0)
  .filter((node) => !node.closest(".modebar, .stTooltipIcon, [role=tablist]"))
  .filter((node) => node.getBoundingClientRect().height < 43.5).map((node) => node.outerHTML.slice(0, 160))"""
"""Targets that are too small for a finger."""
WIDTHS = (
    """[document.documentElement, document.querySelector("[data-testid=stMain]")].map((each) => each.scrollWidth)"""
)


def test_longer_words_fit_on_a_screen_and_on_a_narrow_phone(visit, german):
    page = None
    for address in ADDRESSES.values():
        page = visit(address, network=german, within=page)
        assert page.locator("html").get_attribute("lang") == "de"
        check_fit(page)
        pages, beside = page.evaluate(BAR)
        assert pages <= beside
        client = page.context.new_cdp_session(page)
        become_phone(client, 390, 844)
        settle(page)
        check_fit(page)
        become_phone(client, 320, 640)
        check_narrow(page)
        # Negative control: a text over another one is reported.
        covers = page.evaluate(COVER)
        overlaps = page.evaluate(OVERLAPS)
        assert all(any(cover in pair for pair in overlaps) for cover in covers), overlaps
        client.detach()


def test_hovers_and_sliders_have_decimal_commas_and_minus_signs(visit, german):
    page = visit("motion?glide=-4.5&mu=0.2", network=german)
    values = page.locator("[data-testid=stSliderThumbValue]")
    assert {"−4,5", "0,20"} <= {value.get_attribute("data-written") for value in values.all()}
    slider = page.locator(".st-key-glide input[type=range]")
    assert slider.get_attribute("aria-valuetext") == "−4,5"
    slider.press("ArrowLeft")
    settle(page)
    assert values.filter(has_text="-5.0").get_attribute("data-written") == "−5,0"
    shown = ""
    for graph in page.locator(".js-plotly-plot").all():
        graph.scroll_into_view_if_needed()
        panel = graph.locator(".nsewdrag").first
        box = panel.bounding_box()
        for share in (0.3, 0.45, 0.6):
            panel.hover(position={"x": share * box["width"], "y": box["height"] / 2})
            page.wait_for_timeout(300)
            shown += " ".join(page.locator(".hoverlayer").all_text_contents())
    assert re.search(r"−\d", shown), shown
    assert not re.search(r"-\d|\d\.\d", shown), shown


def become_phone(client, width: int, height: int) -> None:
    """Give a tab the size of a phone's screen, and touch input."""
    size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": True}
    client.send("Emulation.setDeviceMetricsOverride", size)
    client.send("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 5})


def check_fit(page) -> None:
    """Check that nothing is cut, and that no texts overlap."""
    assert page.evaluate(CUT) == []
    assert page.evaluate(OVERLAPS) == []


def check_narrow(page) -> None:
    """Check that no tab scrolls sideways down to 320 px, and that every target is large enough for a finger."""
    for tab in page.get_by_role("tab").all() or [page.locator("h1")]:
        tab.click()
        settle(page)
        assert max(page.evaluate(WIDTHS)) <= 320
        assert page.evaluate(SMALL) == []
