"""Sliders, boxes, presets and the curve under a hand; test_browser_lost uses a slow network."""

import math
import re

import pytest
from playwright.sync_api import expect

from ramanujan import UNIT_MASS_RATIO, Oscillator, normalized_frequency_squared
from ramanujan.browser.components import link
from ramanujan.pages.oscillator.cache import CURVE_RANGE
from tests.checks.browser import inside, next_frame, press_preset, script, settle, traffic
from tests.checks.controls import box, hold, normalized, slider, write
from tests.checks.engines import ANY_ENGINE
from tests.checks.layout import CUT

PANEL = ".st-key-curve .nsewdrag >> nth=0"
POINT = ".st-key-curve .scatterlayer .trace >> nth={} >> .point"
DRAWN = """() => [".st-key-stage", ".st-key-stage_beside_curve"].map((stage) => {
  const { shadowRoot } = document.querySelector(`${stage} [data-testid=stBidiComponentIsolated]`);
  return [".hoop", ".slab", ".hoop .spin", ".hand.machine", ".hand.plain"].map((part) => {
    const node = shadowRoot.querySelector(`:is(.moving, .dial) ${part}`);
    return node.getAttribute("transform") + node.style.cssText + node.checkVisibility();
  });
})"""
"""The positions and weights of the visible bodies and hands, at the top of the page and beside the curve."""

PRESS = """async (name) => {
  const root = document.querySelector(".st-key-link [data-testid=stBidiComponentIsolated]").shadowRoot;
  root.querySelector(`[data-do=${name}]`).click();
  await new Promise((done) => setTimeout(done));
  return root.querySelector(".report").textContent;
}"""
"""Presses a button of the menu *Share*, and returns the report."""


def press(page, preset: str) -> None:
    press_preset(page, preset)
    settle(page)


def middle(page, place: str) -> list[float]:
    box = page.locator(place).bounding_box()
    return [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]


# ---- the sliders


def test_stage_boxes_and_address_follow_a_hand_on_the_sliders(visit):
    page = visit("?k=20&hide=curve,steps")
    page.emulate_media(reduced_motion="no-preference")
    check_drag(page)
    page.emulate_media(reduced_motion="reduce")
    check_bad_entry(page)
    check_copied_link(page)
    press(page, "Reset")
    check_away_and_back(page)
    check_box_follows(page)


def check_drag(page) -> None:
    """Check that a drag moves the stage within two frames and sends no message before its end."""
    before = len(traffic(page).sent)
    page.evaluate(script("watch_lag"))
    hold(page, "m_prime", 96, steps=24)
    lags = page.evaluate("window.lags")
    assert len(lags) >= 15
    assert max(lags) <= 2
    assert len(traffic(page).sent) == before
    live = normalized(page)
    page.mouse.up()
    settle(page)
    # Negative control: the end of the drag sends a message, and the server agrees with the stage.
    assert len(traffic(page).sent) > before
    assert normalized(page) == live
    page.evaluate("delete window.lags")  # stops the script


def check_bad_entry(page) -> None:
    """Check that the message about an invalid entry appears at its box."""
    write(page, "k", "1e9")
    sentence = page.get_by_text("k must be between 1 and 200 N/m. The old value, 20 N/m, was kept.")
    sentence.wait_for()
    at, entry = sentence.bounding_box(), box(page, "k").bounding_box()
    assert 0 <= at["y"] - entry["y"] - entry["height"] < 80
    assert at["y"] + at["height"] <= 720
    expect(box(page, "k")).to_have_value("20.0")


def check_copied_link(page) -> None:
    page.locator(".st-key-link").get_by_role("button", name="Share").click()
    page.locator(".st-key-link").get_by_role("button", name="Copy link").click()
    expect(page.locator(".st-key-link .report")).not_to_be_empty()
    report = page.locator(".st-key-link .report").inner_text()
    copied = "Copied. Only this computer can open the address."  # the tests' app does not listen in the network
    assert report in (copied, "Copy this text:")
    assert report == copied or page.locator(".st-key-link input").input_value() == page.url


@pytest.mark.parametrize(
    ("host", "is_only_here", "copied"),
    [
        ("192.168.1.7:8501", False, "Copied."),
        ("", True, "Copied. Only this computer can open the address."),
    ],
)
@ANY_ENGINE
def test_a_copied_address_has_the_host_that_other_computers_open(bare, host, is_only_here, copied):
    opened = bare("?k=20&key=secret")
    opened.put(lambda: link.mount(["key"], ["k"], host, is_only_here))
    opened.page.evaluate("() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; }")
    place = re.escape(host or opened.page.evaluate("location.host"))
    for button, text in (("copy", rf"http://{place}/light\?k=20"), ("embed", rf'.* src="http://{place}/.*#k=20".*')):
        assert opened.page.evaluate(PRESS, button) == copied
        assert re.fullmatch(text, opened.page.evaluate("copied"))


def check_away_and_back(page) -> None:
    """Check that a slider dragged away and back returns to its value, or to the nearest step."""
    before = normalized(page)
    x, y = hold(page, "m_prime", 240, steps=8)
    assert normalized(page) < before - 0.1
    page.mouse.move(x, y, steps=8)
    next_frame(page)
    assert normalized(page) == before
    page.mouse.up()
    settle(page)
    assert normalized(page) == before
    # A value between the slider's steps is not rounded before a person moves the slider.
    write(page, "m_prime", "1.234")
    slider(page, "k").press("ArrowRight")
    settle(page)
    between = Oscillator(m_prime=1.234).normalized_frequency_squared
    assert normalized(page) == pytest.approx(between, abs=1e-6)
    assert slider(page, "m_prime").input_value() == "1.23"
    assert "m_prime=1.234" in page.url
    x, y = hold(page, "m_prime", 60, steps=6)
    page.mouse.move(x, y, steps=6)
    next_frame(page)
    # After a drag away and back, the thumb is at a step. That value is drawn, and sent at the end of the drag.
    stepped = Oscillator(m_prime=1.23).normalized_frequency_squared
    for is_released in (False, True):
        if is_released:
            page.mouse.up()
        assert normalized(page) == pytest.approx(stepped, abs=1e-6)
        assert box(page, "m_prime").input_value() == "1.23"
        settle(page)
    assert page.url.endswith("m_prime=1.23") or "m_prime=1.23&" in page.url
    assert page.evaluate("ramanujan.last('machine/oscillator').parameters")["m_prime"] == 1.23
    press(page, "In step (1729)")
    assert normalized(page) == 1


def check_box_follows(page) -> None:
    """Check that the box follows the thumb without the server."""
    sent = len(traffic(page).sent)
    x, y = hold(page, "m", 60, steps=5)
    expect(box(page, "m")).to_have_value(slider(page, "m").input_value())
    assert float(box(page, "m").input_value()) > 1.5
    assert len(traffic(page).sent) == sent
    page.mouse.move(x, y, steps=5)
    page.mouse.up()
    settle(page)
    assert float(box(page, "m").input_value()) == 1.0


# ---- the curve


def test_the_curve_shows_the_machine_and_a_click_sets_one(visit):
    page = visit(height=1400)
    page.locator(PANEL).wait_for(state="attached")
    check_size_of_a_change(page)
    press(page, "Reset")
    check_ring(page)
    check_click(page)
    check_second_click(page)
    check_first_screen(page)


def check_size_of_a_change(page) -> None:
    """Check that a change sends at most twenty-two kilobytes."""
    press(page, "In step (1729)")
    start = len(traffic(page).received)
    press(page, "Light rollers")
    assert 1000 < sum(traffic(page).received[start:]) <= 22_000
    # A slider redraws only the elements that depend on it; a whole page has four times as many messages.
    start = len(traffic(page).received)
    slider(page, "k").focus()
    page.keyboard.press("ArrowRight")
    settle(page)
    assert 1000 < sum(traffic(page).received[start:]) <= 10_000
    assert len(traffic(page).received[start:]) <= 15


def check_ring(page) -> None:
    """Check that both rings mark the present machine and follow a drag without the server. The inset has an end."""
    ring, in_inset = (f".st-key-curve .present-machine >> nth={i}" for i in (0, 1))
    equal, unit = (POINT.format(i) for i in (4, 5))
    # Plotly's marks are at equal masses and at the unit ratio. The star is not centred in its box.
    assert middle(page, in_inset) == pytest.approx(middle(page, equal), abs=0.6)
    assert math.dist(middle(page, equal), middle(page, unit)) > 50
    for mark, words in ((equal, "equal massesε = 1.0000"), (unit, "in step with the plain massε = 1.1273")):
        page.mouse.move(*middle(page, mark))
        expect(page.locator(".st-key-curve .hovertext").filter(has_text=words)).to_be_visible()
    # What 1729 is becomes visible when the hands are locked.
    assert page.locator(".st-key-why").is_hidden()
    press(page, "In step (1729)")
    expect(page.locator(".st-key-why")).to_contain_text("1729 = 1³\u00a0+\u00a012³ = 9³\u00a0+\u00a010³")
    expect(page.locator(".st-key-why svg").first).to_be_visible()
    assert middle(page, in_inset) == pytest.approx(middle(page, unit), abs=2)
    assert "Ω²m/k = 1.00000" in page.locator(ring).get_attribute("aria-label")
    before, sent = middle(page, ring), len(traffic(page).sent)
    hold(page, "m_prime", 300, steps=4)
    after = middle(page, ring)
    assert after[0] > before[0] + 20
    assert after[1] > before[1] + 10
    assert page.locator(in_inset).is_hidden()
    assert len(traffic(page).sent) == sent
    page.mouse.up()
    settle(page)


def check_click(page) -> None:
    """Check that a click on the curve sets its mass ratio, within a pixel: a hundredth of the ratio."""

    def click(ratio: float) -> None:
        """Click on the curve at a mass ratio."""
        panel = page.locator(PANEL).bounding_box()
        x = math.log(ratio / CURVE_RANGE[0]) / math.log(CURVE_RANGE[1] / CURVE_RANGE[0])
        _, top = page.evaluate("document.querySelector('.st-key-curve .js-plotly-plot').layout.yaxis.range")
        y = 1 - float(normalized_frequency_squared(ratio)) / top
        page.mouse.move(panel["x"] + x * panel["width"], panel["y"] + y * panel["height"])
        next_frame(page)
        page.mouse.click(panel["x"] + x * panel["width"], panel["y"] + y * panel["height"])
        settle(page)

    _, before = page.evaluate(DRAWN)
    # Only machines answer the pointer, not the dotted limits.
    traces = page.evaluate(
        """document.querySelector(".st-key-curve .js-plotly-plot")._fullData
          .map(({ line, hoverinfo }) => [line?.dash, hoverinfo])"""
    )
    assert [hover for dash, hover in traces if dash == "dot"] == ["skip"] * 2
    click(0.4)
    assert float(box(page, "m_prime").input_value()) == pytest.approx(0.4, rel=0.02)
    # The small machine beside the curve is the one at the top of the page.
    inside(page, "root.querySelector('[data-do=forward]').click()")
    next_frame(page)
    first, small = page.evaluate(DRAWN)
    assert small == first
    assert all(now != then for now, then in zip(small, before, strict=True))
    click(UNIT_MASS_RATIO)
    check_digits(page)
    assert normalized(page) == 1


def check_digits(page) -> None:
    """Check that a framed box shows five digits and dots, and with the focus all digits, which a copy contains, too."""
    assert box(page, "m_prime").evaluate("(box) => getComputedStyle(box).borderColor").startswith("rgb(")
    for _ in range(2):
        expect(box(page, "m_prime")).to_have_value("1.1272…")
        box(page, "m_prime").click()
        expect(box(page, "m_prime")).to_have_value(str(UNIT_MASS_RATIO))
        box(page, "m_prime").blur()


def check_second_click(page) -> None:
    """Check that a second click on the same mark has an effect."""
    for other in ("2", "3"):
        write(page, "m_prime", other)
        page.wait_for_url(f"**m_prime={other}**")
        x, y = middle(page, POINT.format(5))
        page.mouse.move(x, y)
        next_frame(page)
        page.mouse.click(x, y)
        # The box still has the focus.
        expect(box(page, "m_prime")).to_have_value(str(UNIT_MASS_RATIO))
        settle(page)


def check_first_screen(page) -> None:
    """Check that stage and controls fit on the first screen, and that nothing is cut in half a window.

    test_browser_access checks that no labels of the curve overlap.
    """
    for width, height in ((900, 1080), (1280, 720), (1920, 1080)):
        page.set_viewport_size({"width": width, "height": height})
        next_frame(page)
        controls = page.locator(".st-key-stage .controls").bounding_box()
        assert controls["y"] + controls["height"] <= height
        assert page.evaluate(CUT) == []
        # The curve and its small machine fit in one screen.
        page.locator(".st-key-curve").scroll_into_view_if_needed()
        for place in (".st-key-curve", ".st-key-stage_beside_curve"):
            expect(page.locator(place)).to_be_in_viewport(ratio=1)
        page.locator("h1").scroll_into_view_if_needed()


# ---- the sidebar


def test_the_sidebar_fits_the_screen_and_is_open_only_where_it_matters(visit):
    # Equations in symbols hold for any numbers.
    page = visit("derivation", figures=False)
    controls = page.locator(".st-key-controls")
    expect(controls).not_to_be_in_viewport()
    page.locator(".st-key-more button").click()
    page.locator(".st-key-values button").nth(1).click()
    expect(controls).to_be_in_viewport(ratio=1)
    assert controls.bounding_box()["y"] < 45
    page.get_by_role("link", name="Oscillator", exact=True).first.click()
    expect(page.locator(".st-key-composition")).to_be_visible()
    expect(page.locator(".stSidebar")).to_be_hidden()
    # Machine and figures need the width.
    for name in ("Motion", "Speed and accuracy", "Worksheet"):
        page.get_by_role("link", name=name, exact=True).first.click()
        settle(page)
        expect(controls).not_to_be_in_viewport()
    # Once unfolded, it stays open as long as the page.
    page.locator("[data-testid=stExpandSidebarButton]").click()
    page.get_by_role("button", name="New worksheet with its key").click()
    settle(page)
    expect(controls).to_be_in_viewport()
