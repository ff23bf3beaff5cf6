"""Dragging the slab: stage and slider follow at once, and Escape cancels the drag."""

import pytest

from tests.checks.browser import drawn_deformation, next_frame
from tests.checks.engines import ANY_ENGINE
from tests.checks.picture import Picture

SLIDER = "document.querySelector('.st-key-compression input')"
HINT = "root.querySelector('.slab .handle text').textContent"
"""The label on the slab, with the hint to drag it and x₀."""


@pytest.fixture
def picture(bare) -> Picture:
    """A stage of equal masses, whose sliders show x₀ = 8 cm."""
    return opened(bare)


def opened(bare, **options) -> Picture:
    page = bare(**options)
    page.sliders(m=1, m_prime=1, k=10, compression=8, radius=10)
    page.page.evaluate("bus.publish('exact/compression', { value: 8, text: '8.0', processed: 0 })")
    return Picture(page)


def slider(picture) -> float:
    """The value of the slider of x₀."""
    return float(picture.page.evaluate(f"{SLIDER}.value"))


def drawn(picture) -> float:
    """The drawn x₀ [cm]."""
    return 100 * picture.page.evaluate("bus.last('drawn/oscillator').parameters.compression")


def note(picture) -> str:
    return picture.find("root.querySelector('.note').textContent")


def centre(picture) -> tuple[float, float]:
    box = picture.find("root.querySelector('.moving .body.slab .form').getBoundingClientRect()")
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def take_slab(picture, centimetres: float) -> tuple[float, float]:
    """Press on the slab and drag it. Return the position of the pointer."""
    (x, y), scale = centre(picture), picture.find("root.querySelector('.machine').getScreenCTM().a")
    mouse = picture.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + centimetres * scale, y, steps=5)
    next_frame(picture.page)
    return x + centimetres * scale, y


def let_go(picture) -> float:
    """Release the button. Return the value that the slider sends."""
    picture.page.mouse.up()
    return sent(picture)


def sent(picture) -> float:
    """Wait until the slider has sent a value. Return the last value."""
    picture.page.wait_for_function("sent.length > 0")
    *_, (key, event, value) = picture.page.evaluate("sent.splice(0)")
    assert (key, event) == ("compression", "slider")
    return value


def press(picture, control: str) -> None:
    picture.find(f"root.querySelector('[data-do={control}]').click()")
    next_frame(picture.page)


def test_a_click_or_another_button_on_the_slab_changes_nothing(picture, engine):
    mouse = picture.page.mouse
    picture.page.evaluate("setReducedMotion(false)")
    # In WebKit the right button opens a menu, and the middle button is never released.
    others = () if engine == "webkit" else ("right", "middle")
    for button in ("left", *others):
        # The slab keeps oscillating under the resting pointer.
        mouse.move(*centre(picture))
        mouse.down(button=button)
        mouse.up(button=button)
    picture.page.keyboard.press("Escape")
    for button in others:
        x, y = centre(picture)
        mouse.move(x, y)
        mouse.down(button=button)
        mouse.move(x - 80, y, steps=4)
        mouse.up(button=button)
    picture.page.wait_for_timeout(600)
    assert slider(picture) == 8
    assert picture.bare.sent == []


@ANY_ENGINE
def test_the_slider_follows_the_dragged_slab_and_sends_its_last_value(picture):
    assert picture.find(HINT) == "↔ drag: x₀ = 8\u202fcm"
    take_slab(picture, -3)
    assert slider(picture) == pytest.approx(5, abs=0.11)
    assert drawn(picture) == slider(picture)
    picture.page.wait_for_timeout(500)
    assert drawn_deformation(picture.page) == pytest.approx(5, abs=0.1)
    assert f"x₀ = {slider(picture):.1f}" in note(picture)
    assert picture.bare.sent == []
    assert let_go(picture) == slider(picture) == pytest.approx(5, abs=0.11)
    assert f"x₀ = {slider(picture):g}" in picture.find(HINT)
    # The mouse focuses the slab without the frame, which is for the keyboard.
    assert picture.find("root.activeElement.matches('.body.slab:not(:focus-visible)')")


@ANY_ENGINE
def test_the_slab_stops_at_its_bounds_and_a_note_explains_it(picture):
    take_slab(picture, 9)
    assert drawn_deformation(picture.page) == pytest.approx(12, abs=0.02)
    assert "between 0.5\u202fcm and 12\u202fcm" in note(picture)
    assert let_go(picture) == 12
    next_frame(picture.page)
    assert drawn_deformation(picture.page) == pytest.approx(12, abs=0.02)


@ANY_ENGINE
def test_escape_cancels_a_drag(picture):
    press(picture, "forward")
    before = drawn_deformation(picture.page)
    take_slab(picture, -4)
    picture.page.keyboard.press("Escape")
    next_frame(picture.page)
    assert drawn_deformation(picture.page) == pytest.approx(before, abs=0.01)
    assert slider(picture) == 8
    picture.page.mouse.up()
    picture.page.wait_for_timeout(300)
    assert picture.bare.sent == []


def test_a_lost_capture_ends_the_drag(picture):
    picture.find("root.addEventListener('pointerdown', ({ pointerId }) => (window.pointer = pointerId))")
    x, y = take_slab(picture, -2)
    picture.find("root.querySelector('.moving .body.slab').releasePointerCapture(window.pointer)")
    picture.page.mouse.move(x - 100, y)
    picture.page.mouse.move(x - 150, y)
    assert sent(picture) == pytest.approx(6, abs=0.1)
    assert drawn_deformation(picture.page) == pytest.approx(6, abs=0.1)
    picture.page.mouse.up()


@ANY_ENGINE
def test_home_and_end_and_arrows_move_the_slab(picture):
    picture.find("root.querySelector('.moving .body.slab').focus()")
    for key, value in (("Home", 0.5), ("End", 12.0), ("ArrowLeft", 11.5), ("PageDown", 9.0)):
        picture.page.keyboard.press(key)
        next_frame(picture.page)
        assert drawn_deformation(picture.page) == pytest.approx(value, abs=0.01)
        shown = picture.find("root.querySelector('.moving .body.slab').getAttribute('aria-valuenow')")
        assert float(shown) == pytest.approx(value)
    picture.page.wait_for_function("sent.at(-1)?.at(-1) === 9")


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


@pytest.mark.parametrize("engine", ["chromium"])
def test_a_finger_on_the_slab_drags_it_and_a_finger_elsewhere_scrolls(bare):
    picture = opened(bare, width=390, height=500)
    page = picture.page
    client = page.context.new_cdp_session(page)
    client.send("Emulation.setTouchEmulationEnabled", {"enabled": True})
    x, y = centre(picture)
    per_cm = picture.find("root.querySelector('.machine').getScreenCTM().a")
    finger(page, client, [(x, y)])  # a tap
    assert picture.bare.sent == []
    finger(page, client, [(x - 5 * i, y - 12 * i) for i in range(12)])
    compression = sent(picture)
    assert page.evaluate("scrollY") == 0
    assert compression == pytest.approx(max(0.5, 8 - 55 / per_cm), abs=4 / per_cm)
    # If the system cancels the touch, the old value is restored.
    x, y = centre(picture)
    finger(page, client, [(x + 4 * i, y) for i in range(8)], "touchCancel")
    assert drawn(picture) == pytest.approx(compression)
    floor = picture.find("root.querySelector('svg.machine').getBoundingClientRect()")
    beside = (floor["x"] + floor["width"] - 20, floor["y"] + 30)
    finger(page, client, [(beside[0], beside[1] + 150 - 15 * i) for i in range(12)])
    assert page.evaluate("scrollY") > 20
