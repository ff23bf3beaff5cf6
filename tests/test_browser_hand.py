"""The hand in a browser: what it does to sliders and slab is followed at once, and can be taken back."""

import pytest

from ramanujan import Oscillator
from tests.browser import inside, next_frame, settle, slab_over_block, thumb

SLAB = ".st-key-stage .moving .body.slab"
TOLD = "globalThis.ramanujan.last('machine/oscillator').parameters"
PRESENT = "globalThis.ramanujan.last('present/oscillator').parameters"
COMPRESSION = ".st-key-compression input[type=range]"


@pytest.fixture
def visit(visit):
    """As everywhere, with the stage alone, and wait until it has drawn."""

    def open_page(address="?hide=curve,steps", **options):
        page = visit(address, **options)
        page.wait_for_selector(".st-key-stage .readouts dd:not(:empty)", state="attached")
        next_frame(page)
        return page

    return open_page


def normalized(page) -> float:
    return float(inside(page, "root.querySelector('[data-read=normalized]').textContent"))


def note(page) -> str:
    return inside(page, "root.querySelector('.note').textContent")


def centre(page) -> tuple[float, float]:
    box = page.locator(f"{SLAB} rect:not(.grip)").first.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def scale(page) -> float:
    """Pixels per centimetre of the picture."""
    return inside(page, "root.querySelector('.machine').getScreenCTM().a")


HINT = "getComputedStyle(root.querySelector('.slab .handle text')).display !== 'none'"
"""Whether the slab shows that it can be dragged."""


def take_slab(page, centimetres: float) -> tuple[float, float]:
    """Press on the slab and drag it; return where the pointer is."""
    x, y = centre(page)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + centimetres * scale(page), y, steps=5)
    next_frame(page)
    return x + centimetres * scale(page), y


# ---- the sliders


def test_a_slider_dragged_away_and_back_to_its_start_ends_where_it_began(visit):
    page = visit()
    before = normalized(page)
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 80, y, steps=8)
    next_frame(page)
    assert normalized(page) < before - 0.1
    page.mouse.move(x, y, steps=8)
    next_frame(page)
    assert normalized(page) == before
    page.mouse.up()
    settle(page)
    assert normalized(page) == before
    # Where the start is off the slider's steps, it is not rounded as long as no hand is on that slider.
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    page.locator(".st-key-k input[type=range]").press("ArrowRight")
    settle(page)
    assert normalized(page) == 1
    assert page.locator(".st-key-m_prime input[type=range]").input_value() == "1.13"
    assert "m_prime=1.1272568270162107" in page.url
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=6)
    page.mouse.move(x, y, steps=6)
    next_frame(page)
    # Away and back, the thumb is on a step of its own: that is what is drawn, and what letting go sends.
    stepped = Oscillator(m_prime=1.13).normalized_frequency_squared
    box = page.locator(".st-key-m_prime_exact input")
    for let_go in (lambda: None, page.mouse.up):
        let_go()
        assert normalized(page) == pytest.approx(stepped, abs=1e-6)
        assert box.input_value() == "1.13"
        settle(page)
    assert "m_prime=1.13" in page.url
    assert page.evaluate(TOLD)["m_prime"] == 1.13
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    assert normalized(page) == 1


# ---- the slab


def test_a_click_on_the_slab_changes_nothing(visit):
    page = visit(motion="no-preference")
    sent = len(page.frames_sent)
    for button in ("left", "right", "middle"):
        # The slab swings on under the pointer, which stays where it is.
        page.mouse.move(*centre(page))
        page.mouse.down(button=button)
        page.mouse.up(button=button)
    page.keyboard.press("Escape")
    page.wait_for_timeout(600)
    assert len(page.frames_sent) == sent
    assert page.locator(COMPRESSION).input_value() == "8"
    # Neither does a drag by another button.
    x, y = centre(page)
    page.mouse.move(x, y)
    page.mouse.down(button="right")
    page.mouse.move(x - 80, y, steps=4)
    page.mouse.up(button="right")
    page.wait_for_timeout(300)
    assert len(page.frames_sent) == sent


def test_the_slider_follows_the_held_slab_and_nothing_is_sent(visit):
    page = visit()
    page.get_by_role("button", name="Release again").click()
    assert inside(page, HINT)
    sent = len(page.frames_sent)
    take_slab(page, -3)
    assert float(page.locator(COMPRESSION).input_value()) == pytest.approx(5, abs=0.11)
    assert page.evaluate(PRESENT)["compression"] == pytest.approx(0.05, abs=1e-3)
    page.wait_for_timeout(500)
    assert slab_over_block(page) == pytest.approx(5, abs=0.1)
    assert "x₀ = 5.0" in note(page)
    assert len(page.frames_sent) == sent
    page.mouse.up()
    page.wait_for_url("**compression=5**")
    settle(page)
    assert not inside(page, HINT), "it goes with the first drag"
    assert float(page.locator(COMPRESSION).input_value()) == pytest.approx(5, abs=0.11)


def test_bounds_give_way_softly_and_say_so(visit):
    page = visit()
    page.get_by_role("button", name="Release again").click()
    take_slab(page, 9)
    page.wait_for_timeout(300)
    drawn = slab_over_block(page)
    assert 12.5 < drawn < 14
    assert "between 0.5\u202fcm and 12\u202fcm" in note(page)
    assert "12\u202fcm when you let go" in note(page)
    page.mouse.up()
    page.wait_for_timeout(400)
    assert slab_over_block(page) == pytest.approx(12, abs=0.02)
    page.wait_for_url("**compression=12**")
    settle(page)


def test_escape_gives_the_slab_back_and_undo_the_last_compression(visit):
    page = visit()
    page.get_by_role("button", name="Step forward").click()
    next_frame(page)
    before, sent = slab_over_block(page), len(page.frames_sent)
    take_slab(page, -4)
    page.keyboard.press("Escape")
    page.wait_for_timeout(500)
    assert slab_over_block(page) == pytest.approx(before, abs=0.01)
    assert page.locator(COMPRESSION).input_value() == "8"
    page.mouse.up()
    page.wait_for_timeout(300)
    assert len(page.frames_sent) == sent
    undo = page.locator(".st-key-stage .undo")
    assert undo.is_hidden()

    page.get_by_role("button", name="Release again").click()
    take_slab(page, -4)
    page.mouse.up()
    page.wait_for_url("**compression=4**")
    settle(page)
    assert undo.inner_text() == "Back to x₀ = 8\u202fcm"
    undo.click()
    page.wait_for_function("!location.search.includes('compression=4')")
    settle(page)
    assert slab_over_block(page) == pytest.approx(8, abs=0.01)
    # Whoever sets another x₀ has nothing to undo.
    page.locator(COMPRESSION).focus()
    page.keyboard.press("ArrowRight")
    settle(page)
    assert undo.is_hidden()


def test_a_lost_capture_lets_the_slab_go(visit):
    page = visit()
    page.get_by_role("button", name="Release again").click()
    take_slab(page, -2)
    inside(page, "root.querySelector('.moving .body.slab').releasePointerCapture(1)")
    x, y = centre(page)
    page.mouse.move(x - 100, y)
    page.mouse.move(x - 150, y)
    page.wait_for_url("**compression=6**")
    settle(page)
    assert slab_over_block(page) == pytest.approx(6, abs=0.1)
    page.mouse.up()


def test_home_and_end_and_arrows_move_the_slab(visit):
    page = visit()
    page.locator(SLAB).focus()
    for key, value in (("Home", 0.5), ("End", 12.0), ("ArrowLeft", 11.5), ("PageDown", 9.0)):
        page.keyboard.press(key)
        next_frame(page)
        assert slab_over_block(page) == pytest.approx(value, abs=0.01) or page.wait_for_timeout(300) is None
        assert float(page.locator(SLAB).get_attribute("aria-valuenow")) == pytest.approx(value)
    page.wait_for_url("**compression=9**")
    settle(page)


def finger(page, client, path, end: str = "touchEnd") -> None:
    """Put a finger on the screen, move it along a path and end the touch."""

    def touch(kind: str, *points) -> None:
        client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y} for x, y in points]})

    touch("touchStart", path[0])
    for point in path[1:]:
        touch("touchMove", point)
        page.wait_for_timeout(20)
    touch(end)
    page.wait_for_timeout(150)


def test_a_finger_on_the_slab_drags_it_and_a_finger_beside_it_scrolls(visit):
    page = visit(width=390, height=844)
    client = page.context.new_cdp_session(page)
    client.send("Emulation.setTouchEmulationEnabled", {"enabled": True})
    try:
        top = "document.querySelector('[data-testid=stMain]').scrollTop"
        page.get_by_role("button", name="Release again").click()
        x, y = centre(page)
        per_cm = scale(page)
        sent = len(page.frames_sent)
        finger(page, client, [(x, y)])  # a tap
        assert len(page.frames_sent) == sent
        finger(page, client, [(x - 5 * i, y - 12 * i) for i in range(12)])
        page.wait_for_url("**compression=**")
        settle(page)
        assert page.evaluate(top) == 0
        compression = float(page.url.split("compression=")[1].split("&")[0])
        assert compression == pytest.approx(max(0.5, 8 - 55 / per_cm), abs=4 / per_cm)
        # Taken back by the system, the finger leaves what was before.
        x, y = centre(page)
        finger(page, client, [(x + 4 * i, y) for i in range(8)], "touchCancel")
        settle(page)
        assert page.evaluate(PRESENT)["compression"] == pytest.approx(compression / 100)
        floor = page.locator(".st-key-stage svg.machine").bounding_box()
        beside = (floor["x"] + floor["width"] - 20, floor["y"] + 30)
        finger(page, client, [(beside[0], beside[1] + 150 - 15 * i) for i in range(12)])
        assert page.evaluate(top) > 20
    finally:
        client.send("Emulation.setTouchEmulationEnabled", {"enabled": False})
        client.detach()
