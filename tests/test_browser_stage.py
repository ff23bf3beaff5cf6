"""The stage in a real browser: what it shows, what it costs, what a hand can do with it."""

import json
import math
from itertools import combinations, pairwise

import pytest
from playwright.sync_api import expect

from ramanujan import UNIT_MASS_RATIO, Oscillator, normalized_frequency_squared
from ramanujan.pages.oscillator.cache import CURVE_RANGE
from tests.browser import STAGE, WATCH_LAG, inside, next_frame, settle, thumb
from tests.test_browser_speed import CUT


@pytest.fixture
def visit(visit):
    """As everywhere, with the stage alone unless the whole page is asked for, and wait until the stage has drawn."""

    def open_page(address="", *, whole=False, **options):
        alone = "" if whole else ("&" if "?" in address else "?") + "hide=curve,steps"
        page = visit(address + alone, **options)
        page.wait_for_selector(".st-key-stage .readouts dd:not(:empty)")
        page.wait_for_timeout(100)
        return page

    return open_page


def text(page, selector: str) -> str:
    return inside(page, f"root.querySelector({json.dumps(selector)}).textContent")


def slab(page) -> dict[str, float]:
    return page.locator(".st-key-stage .moving .body.slab rect:not(.grip)").first.bounding_box()


def test_the_readouts_are_the_core_s_numbers_and_the_link_holds_the_machine(visit):
    page = visit()
    for m, m_prime, k in [(0.5, 10.0, 1.0), (0.5, 0.05, 200.0), (0.77, 1.3, 33.5)]:
        for key, value in (("m", m), ("m_prime", m_prime), ("k", k)):
            entry = page.locator(f".st-key-{key}_exact input")
            entry.fill(str(value))
            entry.press("Enter")
            settle(page)
        machine = Oscillator(m, m_prime, k)
        for name, value, accuracy in (
            ("normalized", machine.normalized_frequency_squared, 1e-6),
            ("omega", machine.natural_frequency, 1e-4),
            ("period", machine.period, 1e-3),
        ):
            assert float(text(page, f"[data-read={name}]").split()[0]) == pytest.approx(value, rel=accuracy)
        # Fast motion is slowed, and says so.
        assert ("times its real speed" in text(page, ".note")) == (k == 200)
    page.locator(".st-key-link button").click()
    expect(page.locator(".st-key-link .told")).not_to_be_empty()
    said = page.locator(".st-key-link .told").inner_text()
    assert said in ("Copied.", "Copy the link from here:")
    assert said == "Copied." or page.locator(".st-key-link input").input_value() == page.url


def test_a_drag_of_a_slider_moves_the_stage_within_two_frames_and_sends_nothing(visit):
    page = visit(motion="no-preference")
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    next_frame(page)
    before = len(page.frames_sent)
    page.evaluate(WATCH_LAG)
    for i in range(1, 25):
        page.mouse.move(x + 4 * i, y)
        page.wait_for_timeout(40)
    lags = page.evaluate("window.lags")
    assert len(lags) >= 15
    assert max(lags) <= 2
    assert len(page.frames_sent) == before
    next_frame(page)
    live = float(text(page, "[data-read=normalized]"))
    page.mouse.up()
    settle(page)
    # Negative control: letting go does send, and the server agrees with what the stage showed.
    assert len(page.frames_sent) > before
    assert float(text(page, "[data-read=normalized]")) == live
    page.evaluate("delete window.lags")  # the watch ends


def test_nothing_jumps_when_a_parameter_changes(visit):
    """The machine moves at once, frame by frame across a preset never further than twice its greatest speed allows."""
    page = visit(motion="no-preference")
    page.evaluate(
        f"""() => {{
          const rect = {STAGE}.querySelector('.moving .body.slab rect:not(.grip)');
          window.places = [];
          const watch = (now) => {{
            window.places?.push([now, rect.getBoundingClientRect().x]);
            if (window.places) requestAnimationFrame(watch);
          }};
          requestAnimationFrame(watch);
        }}"""
    )
    page.wait_for_timeout(700)
    page.get_by_text("Light rollers", exact=True).click()
    settle(page)
    page.get_by_text("Heavy rollers", exact=True).click()
    settle(page)
    places = page.evaluate("window.places")
    scale = inside(page, "root.querySelector('.machine').getScreenCTM().a") * 100  # pixels per metre
    fastest = 0.08 * Oscillator(1, 0.1, 10).natural_frequency * scale  # x₀Ω of the fastest of the three
    steps = [(t1 - t0, abs(x1 - x0)) for (t0, x0), (t1, x1) in pairwise(places)]
    # A change of shape by Δ fades with 70 ms: Δ is at most the difference of the two couplings times x₀, 3 cm.
    fading = 0.03 / 0.07 * scale
    assert max(moved - 2 * (fastest + fading) * ms / 1000 for ms, moved in steps) < 2
    assert sum(moved for _, moved in steps) > 20
    page.evaluate("delete window.places")  # the watch ends
    page.get_by_role("button", name="Pause", exact=True).click()
    page.wait_for_timeout(500)  # what fades has faded
    still = slab(page)["x"]
    page.wait_for_timeout(300)
    assert slab(page)["x"] == still


def test_buttons_layers_and_keys_have_their_names(visit):
    """What they do to the picture, and how far, is measured in test_browser_picture."""
    page = visit()
    scrub = page.locator(".st-key-stage .scrub input")
    for name, expected in [
        ("Release again", 0),
        ("Step forward", 1 / 24),
        ("Step forward", 2 / 24),
        ("Step back", 1 / 24),
    ]:
        page.get_by_role("button", name=name).click()
        next_frame(page)
        assert float(scrub.input_value()) == pytest.approx(expected, abs=1e-9)
    # The keyboard does as much.
    page.locator(".st-key-stage .stage").evaluate("node => node.focus()")
    for shown in ("Pause", "Play"):
        page.keyboard.press(" ")
        page.get_by_role("button", name=shown, exact=True).wait_for()
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    next_frame(page)
    assert float(scrub.input_value()) == pytest.approx(1 / 24)
    page.get_by_role("button", name="Show", exact=True).click()
    # At a turning point an arrow has no length.
    for layer, selector in [("Velocities", ".arrows"), ("Forces", ".forces"), ("Traces", ".traces")]:
        assert inside(page, f"root.querySelector('{selector}').style.display") == "none"
        page.get_by_role("checkbox", name=layer).check()
        page.wait_for_function(
            f"[...{STAGE}.querySelectorAll('{selector} path')].some((path) => path.getAttribute('d')?.length > 3)"
        )
        assert inside(page, f"root.querySelector('{selector}').style.display") == ""
    # A click elsewhere closes what was opened.
    page.locator(".stMain h1").click()
    expect(page.get_by_role("checkbox", name="Energy")).to_be_hidden()


def test_less_motion_is_a_still_described_in_words_and_its_wish_is_followed_at_once(visit):
    page = visit(motion="reduce", anew=True)
    live = page.locator(".st-key-library [role=status]")
    expect(live).to_contain_text(f"{Oscillator(1, 1, 10).period:.2f}")
    turns = 1 / (math.sqrt(Oscillator().normalized_frequency_squared) - 1)
    expect(live).to_contain_text(f"{turns:.1f}")
    play, pause = (page.get_by_role("button", name=name, exact=True) for name in ("Play", "Pause"))
    play.wait_for()
    ghosts = "root.querySelectorAll('.ghosts > g').length"
    page.wait_for_function(f"{STAGE}.querySelectorAll('.ghosts > g').length === 5")
    # Another machine has exposures of its own, in place of those that were there, and they are silent.
    drawn = inside(page, "root.querySelector('.ghosts').innerHTML")
    page.locator(".st-key-m_prime input[type=range]").press("PageUp")
    next_frame(page)
    assert inside(page, "root.querySelector('.ghosts').innerHTML") != drawn
    assert inside(page, ghosts) == 5
    assert inside(page, "root.querySelectorAll('.ghosts :is([role], [tabindex], [aria-valuenow])').length") == 0
    # The last exposure is half a period on: the slab as far on the other side.
    x = "(ghost, name) => ghost.querySelector(name).transform.baseVal[0].matrix.e"
    first, last = inside(
        page,
        f"[0, 4].map((i) => root.querySelectorAll('.ghosts > g')[i])"
        f".map((ghost) => ({x})(ghost, '.slab') - ({x})(ghost, '.block'))",
    )
    assert (first, last) == (pytest.approx(8, abs=1e-3), pytest.approx(-8, abs=1e-3))
    place = slab(page)["x"]
    page.wait_for_timeout(300)
    assert slab(page)["x"] == place
    # Percentages are written for a machine that stands: nobody can read those that run.
    share = page.locator(".st-key-stage .legend b").first
    expect(share).to_be_visible()
    page.emulate_media(reduced_motion="no-preference")
    pause.wait_for()
    expect(share).to_be_hidden()
    assert inside(page, ghosts) == 0
    page.wait_for_timeout(200)
    assert slab(page)["x"] != place
    page.emulate_media(reduced_motion="reduce")
    play.wait_for()
    next_frame(page)
    assert inside(page, ghosts) == 5
    page.get_by_text("In step (1729)", exact=True).click()
    expect(live).to_contain_text("in step")


def test_a_click_on_the_curve_takes_its_ratio(visit):
    page = visit(whole=True, height=1200)
    entry = page.locator(".st-key-m_prime_exact input")
    panel = page.locator(".st-key-curve .nsewdrag")
    panel.wait_for(state="attached")

    def click(ratio: float) -> None:
        """Click on the curve at a mass ratio, whatever lies there."""
        box = panel.bounding_box()
        x = math.log(ratio / CURVE_RANGE[0]) / math.log(CURVE_RANGE[1] / CURVE_RANGE[0])
        _, top = page.evaluate("document.querySelector('.st-key-curve .js-plotly-plot').layout.yaxis.range")
        y = 1 - float(normalized_frequency_squared(ratio)) / top
        page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"])
        next_frame(page)
        page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
        settle(page)

    # To a pixel of the curve, a hundredth of the ratio, and to three digits.
    click(0.4)
    assert float(entry.input_value()) == pytest.approx(0.4, rel=0.02)
    click(UNIT_MASS_RATIO)
    expect(entry).to_have_value(str(UNIT_MASS_RATIO))
    assert text(page, "[data-read=normalized]") == "1.000000"


def test_the_ring_lies_on_the_present_machine_and_follows_a_drag_without_the_server(visit):
    page = visit(whole=True, height=1200)
    ring = page.locator(".st-key-curve .present-machine")
    points = page.locator(".st-key-curve .scatterlayer .trace")

    def centre(place) -> list[float]:
        box = place.bounding_box()
        return [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]

    # Plotly itself has put a mark on equal masses and on the unit ratio; the star is not centred in its box.
    assert centre(ring) == pytest.approx(centre(points.nth(3).locator(".point")), abs=0.6)
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    assert centre(ring) == pytest.approx(centre(points.nth(4).locator(".point")), abs=2)
    assert "Ω²m/k = 1.00000" in ring.get_attribute("aria-label")

    before, sent = centre(ring), len(page.frames_sent)
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=4)
    next_frame(page)
    after = centre(ring)
    assert after[0] > before[0] + 20
    assert after[1] > before[1] + 10
    assert len(page.frames_sent) == sent
    page.mouse.up()


def test_no_page_is_wider_than_its_screen_and_no_name_of_a_curve_lies_on_another(visit):
    page = visit(whole=True)
    for key, value in (("m_prime", "1.234567890123"), ("k", "33.3")):
        page.locator(f".st-key-{key}_exact input").fill(value)
        page.locator(f".st-key-{key}_exact input").press("Enter")
        settle(page)
    names = page.locator(".st-key-curve .annotation-text")
    for width, height in ((900, 720), (1280, 720), (1920, 1080), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(600)
        assert page.evaluate("document.querySelector('[data-testid=stMain]').scrollWidth") <= width
        if width >= 1280:
            controls = page.locator(".st-key-stage .controls").bounding_box()
            assert controls["y"] + controls["height"] <= height, "the stage and its controls fit on the first screen"
        if width == 900:
            assert page.evaluate(CUT) == []
            link = page.locator("[data-testid=stPageLink] p >> nth=0")
            assert link.evaluate("(node) => node.scrollWidth <= node.clientWidth")
        names.first.wait_for()
        boxes = [name.bounding_box() for name in names.all()]
        assert len(boxes) == 5
        assert all(0 <= box["x"] <= width - box["width"] for box in boxes)
        for a, b in combinations(boxes, 2):
            assert (
                a["x"] + a["width"] <= b["x"] or b["x"] + b["width"] <= a["x"]
                or a["y"] + a["height"] <= b["y"] or b["y"] + b["height"] <= a["y"]
            )  # fmt: skip


def test_a_change_sends_at_most_twenty_kilobytes(visit):
    page = visit(whole=True)
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    start = len(page.frames_received)
    page.get_by_text("Light rollers", exact=True).click()
    settle(page)
    assert 1000 < sum(page.frames_received[start:]) <= 20_000
    # A slider draws anew what follows it, and nothing else: a whole page is four times as many messages.
    start = len(page.frames_received)
    page.locator(".st-key-k input[type=range]").focus()
    page.keyboard.press("ArrowRight")
    settle(page)
    assert 1000 < sum(page.frames_received[start:]) <= 10_000
    assert len(page.frames_received[start:]) <= 15
