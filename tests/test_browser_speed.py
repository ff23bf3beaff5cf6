"""Page 5 in a browser: two stages on one clock, work that can be stopped and left, room on a phone."""

from playwright.sync_api import expect

from tests.browser import settle

CUT = """[...document.querySelectorAll(".stMain .stColumn")].flatMap((column) =>
    [...column.querySelectorAll("button, label, [data-testid=stPageLink] a, [role=combobox]")]
        .filter((node) => node.getBoundingClientRect().right > column.getBoundingClientRect().right + 1)
        .map((node) => node.textContent))"""
"""What reaches out of its column."""
IDLE = "[data-testid=stApp][data-test-script-state=notRunning]"


def measure(page):
    """Start a measurement that takes long."""
    page.get_by_role("button", name="Measure").click(timeout=120_000)
    page.get_by_text("Measuring 300 periods").wait_for(timeout=120_000)


def test_stages_move_no_control_is_cut_and_measuring_can_be_watched_stopped_and_left(visit):
    """A window of 900 pixels beside another one: the sidebar leaves the page 560 of them."""
    page = visit("speed?periods=300&steps=8", width=900, motion="no-preference")
    for key in ("exact", "stepped"):
        slab = page.locator(f".st-key-stage_{key} .moving .body.slab").first
        expect(slab).not_to_have_attribute("transform", slab.get_attribute("transform"))
    page.emulate_media(reduced_motion="reduce")
    page.get_by_role("radio", name="float32", exact=True).click()
    settle(page)
    assert "precision=float32" in page.url
    page.get_by_text("A general eigen-solver").click()
    page.get_by_text("Negative or complex", exact=True).wait_for(timeout=60_000)
    assert page.evaluate(CUT) == []
    # The page answers while it measures, and the measurement goes on.
    measure(page)
    page.get_by_role("radio", name="seconds", exact=True).click()
    page.wait_for_url("**cost=seconds**", timeout=60_000)
    page.get_by_text("Measuring 300 periods").wait_for(timeout=120_000)
    page.get_by_role("button", name="Stop").click()
    page.wait_for_selector(IDLE, timeout=60_000)
    assert page.get_by_role("button", name="Measure").is_enabled()
    assert page.get_by_text("Measuring 300 periods").count() == 0
    # To leave the page ends the work.
    measure(page)
    page.set_viewport_size({"width": 1280, "height": 720})
    page.get_by_role("link", name="Oscillator").first.click()
    page.wait_for_selector(".st-key-curve", timeout=60_000)
    settle(page)
    assert page.get_by_text("Measuring 300 periods").count() == 0
