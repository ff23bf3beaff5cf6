"""Page 5 in a browser: a computed machine over the exact one, the measured diagram, the layout."""

import math
import re

import pytest
from playwright.sync_api import expect

from ramanujan.accuracy.runs import error_history
from tests.checks.layout import CUT


def test_a_run_is_drawn_no_control_is_cut_and_the_diagram_is_measured(visit):
    """In a window of 900 pixels, the page beside the sidebar has 560 pixels."""
    page = visit("speed?steps=8", width=900, figures=False)
    run, label = page.locator(".st-key-run button"), page.locator(".st-key-stage_race .label")
    result = page.locator(".st-key-race_result p").first
    places = "['race', 'growth', 'race_result'].map((key) => document.querySelector(`.st-key-${key}`).offsetTop)"
    height = "document.querySelector('.st-key-race').offsetHeight"
    reserved = page.evaluate(f"[...{places}, {height}]")
    run.click()
    expect(label).to_contain_text("After 30 of 30 periods: 241 evaluations", timeout=60_000)
    expect(result).to_contain_text("Not yet.", timeout=60_000)
    assert page.evaluate(f"[...{places}, {height}]") == pytest.approx(reserved, abs=1), "nothing has jumped"
    # The slab is at x₀ + (cos Ωt − 1)(8 + 6ε)/(7 + 6ε) x₀/2; the outline has q instead of cos Ωt.
    x = "(node) => node.transform.baseVal[0].matrix.e"
    exact, computed = (
        page.locator(f".st-key-stage_race {each} .slab").evaluate(x) for each in (".moving", ".computed")
    )
    q = error_history("velocity_verlet", 8, 30).q[-1]
    gap = page.locator(".st-key-stage_race .gap text").text_content()
    assert gap == f"{abs(computed - exact):.1f}\u202fcm apart"
    assert (exact, computed) == (pytest.approx(8), pytest.approx(8 + (q - 1) * 14 / 13 * 4, abs=1e-3))
    # Seen after whole periods, the exact hand is at the start, and the computed one is ahead by the phase error.
    lead = math.degrees(error_history("velocity_verlet", 8, 30).phase_error[-1])
    hand = page.locator(".st-key-stage_race .hand.machine").get_attribute("transform")
    assert float(hand.removeprefix("rotate(").removesuffix(")")) == pytest.approx(lead, abs=0.01)
    assert page.locator(".st-key-stage_race .hand.plain").get_attribute("transform") == "rotate(0)"
    dial = page.locator(".st-key-stage_race .verdict")
    assert dial.text_content() == f"The computed machine is {lead / 360:.2f} turns ahead."
    # Without reduced motion, the run is shown before its verdict.
    page.emulate_media(reduced_motion="no-preference")
    run.click()
    expect(label).to_contain_text(re.compile("After [1-9]"), timeout=60_000)
    expect(result).to_be_hidden()
    growth = page.locator(".st-key-growth")
    expect(growth).to_have_css("visibility", "hidden")
    page.emulate_media(reduced_motion="reduce")
    expect(result).to_be_visible()
    expect(growth).to_have_css("visibility", "visible")
    page.get_by_role("tab", name="Limits").click()
    digits = page.locator(".st-key-digits_time")
    expect(digits.locator("input")).to_be_hidden()
    page.get_by_role("radio", name="both").or_(page.get_by_role("button", name="both")).click()
    expect(digits.get_by_text("Both are right to 15 digits.")).to_be_visible()
    digits.get_by_role("slider").press("Home")
    expect(digits.locator("tbody .count span")).to_have_text(["0", "15", ""])
    expect(digits.get_by_text("exactly 1")).to_be_visible()
    assert page.evaluate(CUT) == []
    page.get_by_text("A general eigen-solver").click()
    page.get_by_text("Negative or complex", exact=True).wait_for(timeout=60_000)
    assert page.evaluate(CUT) == []
    page.get_by_role("tab", name="Price").click()
    page.get_by_text("For an error of at most 0.01 of a turn").wait_for(timeout=60_000)
    expect(page.get_by_text("Measuring 30 periods")).to_have_count(0)
    assert "topic=price" in page.url
    assert page.evaluate(CUT) == []
