"""Every page at every width: no word lies on another one, and nothing jumps while a page is loaded."""

import pytest
from playwright.sync_api import TimeoutError

from tests.browser import settle
from tests.test_browser_language import ADDRESSES, OVERLAPS

WIDTHS = (
    *(320, 360, 390, 430, 480, 540, 600, 640, 700, 768, 820, 900),
    *(999, 1000, 1024, 1100, 1180, 1280, 1366, 1440, 1600, 1920, 2560, 3840),
)


@pytest.mark.parametrize("name", ADDRESSES)
def test_at_no_width_a_word_lies_on_another_one(visit, name):
    page, found = visit(ADDRESSES[name]), {}
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        try:
            # Figures follow a moment later.
            page.wait_for_function(f"!({OVERLAPS})().length", polling=200, timeout=5000)
        except TimeoutError:
            found[width] = page.evaluate(OVERLAPS)
    settle(page)
    assert found == {}
