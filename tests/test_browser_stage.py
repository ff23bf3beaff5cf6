"""The stage in a real browser: what it shows, what it costs, what a hand can do with it."""

import json
import math
from itertools import combinations, pairwise

import pytest
from playwright.sync_api import expect

from ramanujan import UNIT_MASS_RATIO, Oscillator, normalized_frequency_squared
from ramanujan.pages.oscillator.cache import CURVE_RANGE
from tests.browser import WATCH_LAG, inside, next_frame, settle, thumb
from tests.picture import Picture
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


@pytest.fixture
def picture(bare) -> Picture:
    return Picture(bare())


def slab(picture) -> float:
    return picture.find("root.querySelector('.moving .body.slab .form').getBoundingClientRect().x")


def test_the_readouts_are_the_core_s_numbers_and_fast_motion_is_slowed_and_says_so(picture):
    for m, m_prime, k in [(0.5, 10.0, 1.0), (0.5, 0.05, 200.0), (0.77, 1.3, 33.5)]:
        machine = Oscillator(m, m_prime, k)
        picture.show(machine, 0.08)
        for name, value, accuracy in (
            ("normalized", machine.normalized_frequency_squared, 1e-6),
            ("omega", machine.natural_frequency, 1e-4),
            ("period", machine.period, 1e-3),
        ):
            said = picture.find(f"root.querySelector('[data-read={name}]').textContent")
            assert float(said.split()[0]) == pytest.approx(value, rel=accuracy)
        assert ("times its real speed" in picture.find("root.querySelector('.note').textContent")) == (k == 200)


def test_a_copied_link_holds_the_machine(visit):
    page = visit("?m=0.77&k=33.5")
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


def test_nothing_jumps_when_a_parameter_changes(picture):
    """The machine moves at once, frame by frame across a preset never further than twice its greatest speed allows."""
    page = picture.page
    page.evaluate("wish(false)")
    picture.find("""(() => {
      const rect = root.querySelector(".moving .body.slab .form");
      window.places = [];
      const watch = (now) => {
        window.places.push([now, rect.getBoundingClientRect().x]);
        requestAnimationFrame(watch);
      };
      requestAnimationFrame(watch);
    })()""")
    for m_prime in (1, 0.1, 10):
        picture.show(Oscillator(1, m_prime, 10), 0.08)
        page.wait_for_timeout(700)
    places = page.evaluate("window.places")
    scale = picture.find("root.querySelector('.machine').getScreenCTM().a") * 100  # pixels per metre
    fastest = 0.08 * Oscillator(1, 0.1, 10).natural_frequency * scale  # x₀Ω of the fastest of the three
    steps = [(t1 - t0, abs(x1 - x0)) for (t0, x0), (t1, x1) in pairwise(places)]
    # A change of shape by Δ fades with 70 ms: Δ is at most the difference of the two couplings times x₀, 3 cm.
    fading = 0.03 / 0.07 * scale
    assert max(moved - 2 * (fastest + fading) * ms / 1000 for ms, moved in steps) < 2
    assert sum(moved for _, moved in steps) > 20
    picture.find("root.querySelector('[data-do=play]').click()")
    page.wait_for_timeout(500)  # what fades has faded
    still = slab(picture)
    page.wait_for_timeout(300)
    assert slab(picture) == still


def test_buttons_layers_and_keys_do_as_much(picture):
    """How far they move the picture is measured in test_browser_picture."""
    page, press = picture.page, picture.page.keyboard.press
    share = "Number(root.querySelector('.scrub input').value)"
    for action, expected in (("restart", 0), ("forward", 1 / 24), ("forward", 2 / 24), ("back", 1 / 24)):
        picture.find(f"root.querySelector('[data-do={action}]').click()")
        next_frame(page)
        assert picture.find(share) == pytest.approx(expected, abs=1e-9)
    picture.find("root.querySelector('.stage').focus()")
    for shown in ("Pause", "Play"):
        press(" ")
        assert picture.find("root.querySelector('[data-do=play]').ariaLabel") == shown
    press("Home")
    press("ArrowRight")
    next_frame(page)
    assert picture.find(share) == pytest.approx(1 / 24)
    # At a turning point an arrow has no length.
    for layer in ("arrows", "forces", "traces"):
        display = f"root.querySelector('.{layer}').style.display"
        assert picture.find(display) == "none"
        picture.layers(layer)
        assert picture.find(display) == ""
        drawn = f"[...root.querySelectorAll('.{layer} path')].map((path) => path.getAttribute('d')?.length ?? 0)"
        assert max(picture.find(drawn)) > 3
    # A click elsewhere closes what was opened.
    opened = "root.querySelector('[popover]').matches(':popover-open')"
    box = picture.find("root.querySelector('.show').getBoundingClientRect()")
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert picture.find(opened)
    page.mouse.click(3, 3)
    assert not picture.find(opened)


def test_less_motion_is_a_still_described_in_words_and_its_wish_is_followed_at_once(bare):
    here = bare()
    here.sliders(m=1, m_prime=1, k=10, compression=8, radius=10)
    here.page.evaluate("() => bus.subscribe('say', ({ sentence }) => (window.said ??= []).push(sentence))")
    picture = Picture(here)
    page = picture.page
    turns = 1 / (math.sqrt(Oscillator().normalized_frequency_squared) - 1)
    (said,) = page.evaluate("said")
    assert f"{Oscillator(1, 1, 10).period:.2f}" in said
    assert f"{turns:.1f}" in said
    play = "root.querySelector('[data-do=play]').ariaLabel"
    assert picture.find(play) == "Play"
    ghosts = "root.querySelectorAll('.ghosts > g').length"
    assert picture.find(ghosts) == 5
    # Another machine has exposures of its own, in place of those that were there, and they are silent.
    drawn = picture.find("root.querySelector('.ghosts').innerHTML")
    page.evaluate("document.querySelector('.st-key-m_prime input').focus()")
    page.keyboard.press("PageUp")
    next_frame(page)
    assert picture.find("root.querySelector('.ghosts').innerHTML") != drawn
    assert picture.find(ghosts) == 5
    assert picture.find("root.querySelectorAll('.ghosts :is([role], [tabindex], [aria-valuenow])').length") == 0
    # The last exposure is half a period on: the slab as far on the other side.
    x = "(ghost, name) => ghost.querySelector(name).transform.baseVal[0].matrix.e"
    first, last = picture.find(
        f"[0, 4].map((i) => root.querySelectorAll('.ghosts > g')[i])"
        f".map((ghost) => ({x})(ghost, '.slab') - ({x})(ghost, '.block'))",
    )
    assert (first, last) == (pytest.approx(8, abs=1e-3), pytest.approx(-8, abs=1e-3))
    place = slab(picture)
    page.wait_for_timeout(300)
    assert slab(picture) == place
    # Percentages are written for a machine that stands: nobody can read those that run.
    share = "getComputedStyle(root.querySelector('.legend b')).visibility"
    assert picture.find(share) == "visible"
    page.evaluate("wish(false)")
    next_frame(page)
    assert (picture.find(play), picture.find(share), picture.find(ghosts)) == ("Pause", "hidden", 0)
    page.wait_for_timeout(200)
    assert slab(picture) != place
    page.evaluate("wish(true)")
    next_frame(page)
    assert (picture.find(play), picture.find(ghosts)) == ("Play", 5)
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    page.evaluate("document.querySelectorAll('.stSlider').forEach((each) => each.remove())")
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    assert "in step" in page.evaluate("said.at(-1)")


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
