"""An exercise by link in a browser, from a phone's first answer to the submitted file."""

import re
from pathlib import Path

from playwright.sync_api import expect

from tests.browser import settle


def test_an_exercise_from_its_link_to_the_saved_sheet(visit):
    page = visit("lesson?exercise=block_momentum,half-energy&m=2", width=390, height=844)
    heading = page.locator("[data-testid=stMain] h1")
    expect(heading).to_have_text("The momentum of X")
    page.get_by_label("Your formula").fill("(3m+2m')Ẋ − 2(m+m')Rφ̇ − mRΦ̇")
    page.keyboard.press("Enter")
    settle(page)
    expect(page.locator("[data-testid=stAlert]")).to_contain_text("Right!")
    page.get_by_role("button", name="Next").click()
    expect(heading).to_have_text("Half of the energy")
    settle(page)
    # The link sets the machine of the task; a reload preserves the place.
    assert "m=2" in page.url
    assert "item=2" in page.url
    page.get_by_role("button", name="Next").click()
    expect(heading).to_have_text("Ramanujan’s oscillator: exercise")
    settle(page)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save this worksheet").click()
    assert download.value.suggested_filename == "exercise.md"
    text = Path(download.value.path()).read_text(encoding="utf-8")
    assert re.search(r"1\. \*\*The momentum of X\.\*\*.*\n.*`` \(3m\+2m'\)Ẋ .* ``\n.*Right since 20", text)
    assert re.search(r"2\. \*\*Half of the energy\.\*\*(.*\n)+.*Not done yet\.", text)
    # The page and the file agree.
    shown = " ".join(page.locator("[data-testid=stMain]").inner_text().split())
    assert re.search(r"Right since .*?\.", text)[0] in shown
