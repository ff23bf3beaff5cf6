"""Page 5 in a browser: a computed machine over the exact one, measurements that can be stopped, the layout."""

import re

import pytest
from playwright.sync_api import expect

from ramanujan.accuracy.runs import error_history
from tests.browser import settle

CUT = """[...document.querySelectorAll(".stMain .stColumn")].filter((each) => each.clientWidth).flatMap((column) =>
    [...column.querySelectorAll("button, label, [data-testid=stPageLink] a, [role=combobox]")]
        .filter((node) => node.getBoundingClientRect().right > column.getBoundingClientRect().right + 1)
        .map((node) => node.textContent))"""
"""The controls that extend beyond their column."""
IDLE = "[data-testid=stApp][data-test-script-state=notRunning]"


def measure(page):
    """Start a long measurement."""
    page.get_by_role("button", name="Measure").click(timeout=120_000)
    page.get_by_text("Measuring 300 periods").wait_for(timeout=120_000)


def test_a_run_is_drawn_no_control_is_cut_and_measuring_can_be_watched_stopped_and_left(visit):
    """In a window of 900 pixels, the page beside the sidebar has 560 pixels."""
    page = visit("speed?periods=300&steps=8", width=900, figures=False)
    run, label = page.locator(".st-key-run button"), page.locator(".st-key-stage_race .label")
    result = page.locator(".st-key-race_result p").first
    run.click()
    expect(label).to_contain_text("Period 30 of 30: 241 evaluations", timeout=60_000)
    expect(result).to_be_visible(timeout=60_000)
    # The slab is at x₀ + (cos Ωt − 1)(8 + 6ε)/(7 + 6ε) x₀/2; the outline has q instead of cos Ωt.
    x = "(node) => node.transform.baseVal[0].matrix.e"
    exact, computed = (
        page.locator(f".st-key-stage_race {each} .slab").evaluate(x) for each in (".moving", ".computed")
    )
    q = error_history("velocity_verlet", 8, 30).q[-1]
    assert (exact, computed) == (pytest.approx(8), pytest.approx(8 + (q - 1) * 14 / 13 * 4, abs=1e-3))
    # Without reduced motion, the run is shown before its verdict.
    page.emulate_media(reduced_motion="no-preference")
    run.click()
    expect(label).to_contain_text(re.compile("Period [1-9]"), timeout=60_000)
    expect(result).to_be_hidden()
    page.emulate_media(reduced_motion="reduce")
    expect(result).to_be_visible()
    page.get_by_role("radio", name="float32", exact=True).click()
    settle(page)
    assert "precision=float32" in page.url
    page.get_by_text("A general eigen-solver").click()
    page.get_by_text("Negative or complex", exact=True).wait_for(timeout=60_000)
    assert page.evaluate(CUT) == []
    # The page responds during the measurement, and the measurement continues.
    measure(page)
    page.get_by_role("radio", name="seconds", exact=True).click()
    page.wait_for_url("**cost=seconds**", timeout=60_000)
    page.get_by_text("Measuring 300 periods").wait_for(timeout=120_000)
    page.get_by_role("button", name="Stop").click()
    page.wait_for_selector(IDLE, timeout=60_000)
    assert page.get_by_role("button", name="Measure").is_enabled()
    assert page.get_by_text("Measuring 300 periods").count() == 0
    # Leaving the page ends the measurement.
    measure(page)
    page.set_viewport_size({"width": 1280, "height": 720})
    page.get_by_role("link", name="Oscillator").first.click()
    page.wait_for_selector(".st-key-curve", timeout=60_000)
    settle(page)
    assert page.get_by_text("Measuring 300 periods").count() == 0
