"""Every page at every width: no word lies on another one, nothing jumps, and little is offered."""

import pytest
from playwright.sync_api import TimeoutError

from tests.browser import script, settle
from tests.test_browser_language import ADDRESSES, OVERLAPS

WIDTHS = (
    *(320, 360, 390, 430, 480, 540, 600, 640, 700, 768, 820, 900),
    *(999, 1000, 1024, 1100, 1180, 1280, 1366, 1440, 1600, 1920, 2560, 3840),
)
SHIFTS = """window.shifts = [];
const patient = new CSSStyleSheet();
patient.replaceSync(":root { --patience: 3600s; }");
document.adoptedStyleSheets = [patient];
new PerformanceObserver((list) => window.shifts.push(...list.getEntries().map((entry) => entry.value)))
  .observe({ type: "layout-shift", buffered: true });"""
"""Notes how far what is seen has moved, as the browser measures it, however slow the machine is."""
MOST_SHIFT = 0.02
OFFERED = script("offered")
"""Counts what can be operated and is in view; a slider's box counts while it has its frame."""
MOST_OFFERED = {"oscillator": 23, "derivation": 28, "motion": 24, "taxicab": 14, "speed": 24}


def shift(page) -> float:
    return sum(page.evaluate("window.shifts"))


@pytest.mark.parametrize("name", ADDRESSES)
def test_a_page_is_calm_from_its_first_frame_and_no_word_lies_on_another_one_at_any_width(visit, name):
    page, found = visit(ADDRESSES[name].partition("?")[0], SHIFTS), {}
    assert shift(page) < MOST_SHIFT
    assert page.evaluate(OFFERED) <= MOST_OFFERED.get(name, 30)
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        try:
            # Figures follow a moment later.
            page.wait_for_function(f"!({OVERLAPS})().length", polling=200, timeout=5000)
        except TimeoutError:
            found[width] = page.evaluate(OVERLAPS)
    settle(page)
    assert found == {}


def test_a_page_whose_end_does_not_come_is_seen_without_it(visit):
    page = visit(ADDRESSES["worksheet"])
    title = page.locator("h1").first
    assert title.is_visible()
    page.evaluate("document.querySelector('.st-key-bar').remove()")
    assert not title.is_visible()
    title.wait_for()


@pytest.mark.parametrize("size", [(820, 1180), (390, 844)])
def test_on_a_tablet_and_on_a_phone_nothing_jumps_while_a_page_is_loaded(visit, size):
    page, moved = None, {}
    for name, address in ADDRESSES.items():
        page = visit(address, *(() if page else [SHIFTS]), width=size[0], height=size[1], tab=page)
        moved[name] = shift(page)
    assert max(moved.values()) < MOST_SHIFT, moved
