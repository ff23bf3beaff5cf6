"""The lecture by keys, clickers and buttons: a press is a step, however fast."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from tests.browser import settle

HEADING = ".st-key-lecture h2:visible"


def step(page) -> int:
    return int(page.locator(HEADING).inner_text().split(".")[0])


@pytest.fixture
def lecture(visit):
    def open_page(query: str = "", **options):
        page = visit(f"derivation{query}", **options)
        expect(page.locator(HEADING)).to_have_count(1, timeout=60_000)
        page.get_by_role("button", name="Next").wait_for()
        return page

    return open_page


def test_fast_presses_are_all_kept_and_the_address_holds_the_step(lecture):
    page = lecture()
    for _ in range(4):
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(150)
    # Before the server has said anything.
    assert step(page) == 5
    page.wait_for_url("**step=5**")
    settle(page)
    assert step(page) == 5


def test_clickers_and_the_space_bar_turn_steps_and_typing_does_not(lecture):
    page = lecture()
    for key, expected in (("PageDown", 2), ("Space", 3), ("PageUp", 2), ("Shift+Space", 1), ("ArrowLeft", 1)):
        page.keyboard.press(key)
        assert step(page) == expected, key
    answer = page.get_by_label("Your formula")
    answer.fill("k")
    for key in ("ArrowRight", "Space", "PageDown"):
        page.keyboard.press(key)
    assert step(page) == 1
    assert answer.input_value() == "k "
    # A button that has the focus keeps the space bar, and turns once.
    page.get_by_role("button", name="Next").focus()
    page.keyboard.press("Space")
    assert step(page) == 2
    # Where the lecture cannot be seen, these keys scroll the page as they do everywhere.
    page.evaluate("document.activeElement.blur()")
    page.get_by_label("Your formula").scroll_into_view_if_needed()
    page.keyboard.press("PageUp")
    assert step(page) == 2


def test_a_screen_reader_hears_the_step_once_and_the_slider_says_where_it_is(lecture):
    page = lecture("?step=3")
    said = page.locator(".st-key-library [role=status]")
    before = said.text_content()
    page.get_by_role("button", name="Next").click()
    heading = page.locator(HEADING).inner_text().split(". ", 1)[1]
    assert "Step 4 of " not in before
    expect(said).to_contain_text(re.compile(rf"^Step 4 of .*{re.escape(heading)}$"))
    assert page.get_by_role("slider", name="Step").get_attribute("aria-valuetext").startswith("Step 4 of ")
