"""The story of the first page: its sentences and the hands at every moment, against the numeric core."""

import re
import time
from decimal import ROUND_DOWN, Decimal
from itertools import accumulate, pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from ramanujan import UNIT_MASS_RATIO, Oscillator, normalized_frequency_squared
from ramanujan.browser import stage
from ramanujan.browser.components import exact
from ramanujan.browser.components import story as story_button
from ramanujan.pages.oscillator import story
from ramanujan.pages.oscillator.story import SCREEN_PERIOD, STILL_PERIODS, make_story
from ramanujan.shell import widgets
from ramanujan.shell.parameters import PARAMETERS
from tests.checks.bare import Bare
from tests.checks.browser import STAGE, inside, next_frame, script, settle, thumb, traffic, until
from tests.checks.controls import write
from tests.checks.engines import ANY_ENGINE
from tests.settings import PATIENCE

GOAL = 1.5 * UNIT_MASS_RATIO
STORY = "document.querySelector('.st-key-story [data-testid=stBidiComponentIsolated]').shadowRoot"
NOW = f"""() => {{
  const text = (root, selector) => root.querySelector(selector).textContent;
  const angle = (name) => /[-.\\d]+/.exec({STAGE}.querySelector(`.hand.${{name}}`).getAttribute("transform"))[0];
  return {{ periods: ramanujan.last("time/oscillator").periods, ratio: ramanujan.last("drawn/oscillator").ratio,
    sentence: text({STORY}, ".sentence"), verdict: text({STAGE}, ".verdict"), parting: text({STAGE}, ".parting"),
    degrees: angle("machine") - angle("plain") }};
}}"""
IN_STEP = "In step: ε\u00a0=\u00a0(√1729\u00a0−\u00a01)/36. So (36ε\u00a0+\u00a01)²\u00a0=\u00a01729."
ANNOUNCED = "(globalThis.announced = [], bus.subscribe('announce', ({ sentence }) => announced.push(sentence)))"
"""Records the announcements of the live region."""
MARK = "document.querySelector('.st-key-m_prime').style.getPropertyValue('--mark')"


def ratio_at(scenes, periods: float) -> float:
    """The mass ratio after a number of periods of the plain mass."""
    ends = list(accumulate(scene.periods for scene in scenes))
    i = int(np.searchsorted(ends, periods))
    share = 1 - (ends[i] - periods) / scenes[i].periods
    return float(np.interp(share, np.linspace(0, 1, len(scenes[i].ratios)), scenes[i].ratios))


def gained(scenes, periods: float) -> float:
    """The lead of the machine's hand after these periods, in turns."""
    ends = [each for each in accumulate(scene.periods for scene in scenes) if each < periods]
    rate = lambda t: float(np.sqrt(normalized_frequency_squared(ratio_at(scenes, t)))) - 1  # noqa: E731
    return sum(quad(rate, start, end, limit=200, epsabs=1e-6)[0] for start, end in pairwise([0.0, *ends, periods]))


def figure(sentence: str) -> float:
    return float(re.search(r"\d+(\.\d+)?", sentence)[0])


def test_the_hands_meet_again_when_both_machines_are_in_step():
    scenes = make_story()
    machine = PARAMETERS["m_prime"].default / PARAMETERS["m"].default
    assert [scenes[0].ratios[0], scenes[-1].ratios[-1]] == [machine, UNIT_MASS_RATIO]
    for first, second in pairwise(scenes):
        assert first.ratios[-1] == second.ratios[0]
    # The hand is visibly ahead, and then loses a full turn.
    ends = [*accumulate(scene.periods for scene in scenes)]
    assert 0.05 < gained(scenes, ends[0]) < 0.5
    assert gained(scenes, ends[-1] - 1e-9) == pytest.approx(-1, abs=1e-3)


FRAME = 0.05 / SCREEN_PERIOD
"""Periods of the plain mass in a frame."""


@pytest.fixture
def started(bare) -> Bare:
    """The stage, the slider of m′ with its box, and the story, for m = 1.5 kg."""
    page = bare()
    page.sliders(m=1.5, m_prime=1, k=10, compression=8, radius=10)
    page.put(lambda: exact.mount("m_prime", widgets.box_settings(PARAMETERS["m_prime"]), lambda _text: None))
    page.page.evaluate("bus.publish('exact/m', { value: 1.5 })")
    page.page.evaluate("bus.publish('exact/m_prime', { value: 1, text: '1.0', processed: 0 })")
    page.stage(Oscillator(1.5, 1.0, 10.0))
    page.put(lambda: story_button.mount(story.collect_data()))
    return page


def check_story(page) -> None:
    """Run the story, and compare its sentence, mass ratio and hands at every moment with the core."""
    scenes, shown = make_story(), set()
    ends = [*accumulate(scene.periods for scene in scenes)]
    page.evaluate(f"{STORY}.querySelector('button').click()")
    end = time.monotonic() + PATIENCE
    while (now := page.evaluate(f"() => (turn(8), ({NOW})())"))["sentence"] != IN_STEP:
        assert time.monotonic() < end, "the story does not end"
        shown.add(now["sentence"])
        first, last = (min(int(np.searchsorted(ends, now["periods"] + by)), len(ends) - 1) for by in (-FRAME, FRAME))
        assert now["sentence"] in [scene.sentence for scene in scenes[first : last + 1]]
        around = [ratio_at(scenes, min(now["periods"] + by * FRAME, ends[-1] - 1e-9)) for by in (-1, 0, 1)]
        assert min(around) - 0.01 < now["ratio"] < max(around) + 0.01  # within a step of the slider
        ahead = gained(scenes, now["periods"])
        off = (now["degrees"] / 360 - ahead) % 1
        assert min(off, 1 - off) < 0.1
        if " turns " in now["verdict"] and "agree" not in now["verdict"]:
            assert figure(now["verdict"]) == pytest.approx(abs(ahead), abs=0.1)
            assert bool(re.search("behind|lost", now["verdict"])) == (ahead < 0)
        rate = abs(float(np.sqrt(normalized_frequency_squared(now["ratio"]))) - 1)
        if rate > 1e-9:
            assert figure(now["parting"].replace("\u202f", "")) == pytest.approx(1 / rate, rel=0.05, abs=0.5)
    assert shown == {scene.sentence for scene in scenes}
    # It ends in step immediately, also with a slow server.
    now = page.evaluate(f"() => (turn(1), ({NOW})())")
    assert (now["sentence"], now["ratio"]) == (IN_STEP, pytest.approx(UNIT_MASS_RATIO, rel=1e-15))


def test_a_press_before_the_slider_is_drawn_begins_the_story(started):
    page, label = started.page, f"{STORY}.querySelector('button').textContent"
    page.evaluate("setReducedMotion(false)")
    page.evaluate("(globalThis.slider = document.querySelector('.st-key-m_prime')).remove()")
    page.evaluate(f"{STORY}.querySelector('button').click()")
    next_frame(page)
    assert page.evaluate(label) == "Bring them into step"
    page.evaluate("document.body.append(slider)")
    page.wait_for_function(f"{label} === 'Stop'")


@ANY_ENGINE
def test_the_story_is_true_at_every_moment_and_ends_in_step(started):
    page, evaluate = started.page, started.page.evaluate
    assert evaluate(MARK) == "", "the answer is not printed on the slider"
    evaluate(script("turned_clock"))
    evaluate(ANNOUNCED)
    evaluate("setReducedMotion(false)")
    check_story(page)
    page.wait_for_function("sent.length > 0")
    assert [each[-1] for each in started.sent] == [repr(GOAL)], "no message while it plays"
    assert evaluate("announced").count(IN_STEP) == 1
    evaluate(f"bus.publish('exact/m_prime', {{ value: {GOAL!r}, text: '{GOAL!r}', processed: 1 }})")
    started.put(lambda: stage.publish(stage.payload(Oscillator(1.5, GOAL, 10.0), 0.08), name="oscillator"))
    assert evaluate(f"() => (turn(1), ({NOW})())")["sentence"] == IN_STEP
    assert float(evaluate(MARK)) == pytest.approx((GOAL - 0.05) / (10 - 0.05))
    assert evaluate(f"{STORY}.querySelector('button').textContent") == "Again"
    page.set_viewport_size({"width": 390, "height": 844})
    check_story(page)
    # Any touch ends the story: the slider stays at its value and sends it.
    evaluate(f"{STORY}.querySelector('button').click()")
    until(page, f"() => (turn(8), ({NOW})().ratio >= 1.2)")
    page.keyboard.press("Shift")
    page.wait_for_function("sent.length === 3")
    key, event, value = started.sent[-1]
    assert (key, event) == ("m_prime", "slider")
    assert 1.2 <= value / 1.5 < 2.01
    # A change of the preference to reduced motion completes the story.
    evaluate(f"{STORY}.querySelector('button').click()")
    evaluate("() => (turn(8), setReducedMotion(true))")
    assert evaluate(f"() => (turn(8), ({NOW})())")["sentence"] == IN_STEP
    assert not evaluate(f"{STORY}.querySelector('.stills').hidden")


LET_GO = """(at) => ["pointermove", "pointerup"].forEach((type) =>
    dispatchEvent(new PointerEvent(type, { ...at, pageX: at.clientX, pointerId: 1, pointerType: "mouse" })))"""
"""Moves a thumb and releases it before the page has drawn the move, as on a slow machine."""
BOX = "document.querySelector('.st-key-m_prime_exact [data-testid]').shadowRoot.querySelector('input').value"
NUMBER = f"Number({BOX}.replace('…', ''))"
"""The number in the box, without the dots for further digits."""
DRAWN = "ramanujan.last('drawn/oscillator').ratio"


def shorten(value: float) -> str:
    """A number between 1 and 10 as in a box without the focus: five digits, and dots for the others."""
    digits = str(Decimal(value).quantize(Decimal("1.0000"), ROUND_DOWN))
    return f"{value:.5g}" if float(f"{value:.5g}") == value else f"{digits}…"


def ratio_and_box(page) -> tuple[float, str]:
    """The drawn mass ratio, and the text of the box."""
    return page.evaluate(DRAWN), page.evaluate(BOX)


def check_end(page) -> None:
    """Check that slider, session and address end with the exact value."""
    settle(page)
    page.wait_for_url(f"**m_prime={UNIT_MASS_RATIO!r}*")
    settle(page)
    assert page.evaluate("ramanujan.last('machine/oscillator').parameters.m_prime") == UNIT_MASS_RATIO
    assert ratio_and_box(page) == (UNIT_MASS_RATIO, shorten(UNIT_MASS_RATIO))
    assert inside(page, "root.querySelector('[data-step]').dataset.step") == "in-step"


def check_stills(page) -> None:
    """Check that with reduced motion five clocks replace the story."""
    page.get_by_role("button", name="Bring them into step", exact=True).click()
    check_end(page)
    angles = page.evaluate(
        f"[...{STORY}.querySelectorAll('.stills svg')].map((clock) => [...clock.querySelectorAll("
        "'line')].map((hand) => Number(/[-.\\d]+/.exec(hand.getAttribute('transform') ?? '0')[0])))"
    )
    assert [plain for plain, _ in angles] == [0] * 5
    labels = page.locator(".st-key-story li").all_inner_texts()
    for label, (_, degrees) in zip(labels, angles, strict=True):
        turns = STILL_PERIODS * (np.sqrt(normalized_frequency_squared(figure(label))) - 1)
        assert degrees == pytest.approx(360 * turns, abs=0.1), label


class Mouse:
    """The mouse on the thumb of m′."""

    def __init__(self, page) -> None:
        self.page = page

    def press(self, x: float, y: float) -> None:
        self.page.mouse.move(x, y)
        self.page.mouse.down()

    def move(self, x: float, y: float) -> None:
        self.page.mouse.move(x, y)

    def release(self) -> None:
        self.page.mouse.up()


class Finger:
    """A finger on the thumb of m′."""

    def __init__(self, page) -> None:
        self.client = page.context.new_cdp_session(page)

    def send(self, kind: str, *points: dict[str, float]) -> None:
        self.client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def press(self, x: float, y: float) -> None:
        self.send("touchStart", {"x": x, "y": y})

    def move(self, x: float, y: float) -> None:
        self.send("touchMove", {"x": x, "y": y})

    def release(self) -> None:
        self.send("touchEnd")


def track(page) -> tuple[float, float]:
    """The left end and the length of the track of m′, between the centres of the thumb [px]."""
    box = page.locator(".st-key-m_prime").bounding_box()
    return box["x"] + 6, box["width"] - 12


def drag(page, to: float) -> None:
    """Drag the thumb of m′ to a place on the screen with the mouse."""
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(to, y, steps=4)
    next_frame(page)
    page.mouse.up()
    settle(page)


def check_range(page) -> None:
    """Check that the slider ends at 2.2m, and that only a larger value extends its range."""
    start, length = track(page)
    for text, most in (("2.2", 2.2), ("10", 10)):
        write(page, "m_prime", text)
        assert thumb(page, "m_prime")[0] == pytest.approx(start + length, abs=0.5)
        for share in (0.4, 1.05):
            drag(page, start + share * length)
            assert page.evaluate(NUMBER) == pytest.approx(0.05 + min(share, 1) * (most - 0.05), abs=0.02)
            assert thumb(page, "m_prime")[0] == pytest.approx(start + min(share, 1) * length, abs=2)
    drag(page, start + 0.1 * length)
    mass = page.evaluate(NUMBER)
    assert mass == pytest.approx(0.05 + 0.1 * (10 - 0.05), abs=0.02)
    assert thumb(page, "m_prime")[0] == pytest.approx(start + (mass - 0.05) / 2.15 * length, abs=0.5)


def check_hand(page, hand: Mouse | Finger, pixels: int) -> None:
    """Check that a hand sets every mass near the two marks, passes the ratio in step, and stops at it.

    The two marks have at least this number of pixels between them.
    """
    write(page, "m_prime", "1")
    start, length = track(page)
    per_pixel = 2.15 / length
    assert (UNIT_MASS_RATIO - 1) / per_pixel >= pixels
    (x, y), sent = thumb(page, "m_prime"), len(traffic(page).sent)
    assert x == pytest.approx(start + 0.95 / per_pixel, abs=0.5)
    hand.press(x, y)
    hand.move(x - 20, y)  # a finger moves the thumb only after some pixels
    for mass in np.linspace(0.8, 1.4, 20):
        hand.move(round(start + (mass - 0.05) / per_pixel), y)
        page.wait_for_function(f"Math.abs({NUMBER} - {mass}) <= 0.01")
    goal, snapped = start + (UNIT_MASS_RATIO - 0.05) / per_pixel, []
    for off in range(-8, 9):
        hand.move(goal + off, y)
        page.wait_for_function(f"Math.abs({NUMBER} - {UNIT_MASS_RATIO + off * per_pixel}) <= 0.01")
        next_frame(page)
        assert abs(thumb(page, "m_prime")[0] - goal - off) < 3
        if page.evaluate(DRAWN) == UNIT_MASS_RATIO:
            snapped.append(off)
    assert 0 in snapped
    assert max(map(abs, snapped)) <= 3
    assert len(traffic(page).sent) == sent
    hand.move(goal, y)
    page.wait_for_function(f"{DRAWN} === {UNIT_MASS_RATIO!r}")
    hand.release()
    check_end(page)


def test_a_hand_finds_the_ratio_on_a_desktop_and_on_a_phone(visit):
    """Check the mouse and a finger; the next test checks keys.

    Afterwards check the still clocks, because this page has reduced motion.
    """
    page = visit("?hide=curve,steps", has_touch=True)
    check_range(page)
    check_hand(page, Mouse(page), 36)
    write(page, "m_prime", "1")
    (x, y), (start, length) = thumb(page, "m_prime"), track(page)
    page.mouse.move(x, y)
    page.mouse.down()
    page.evaluate(LET_GO, {"clientX": start + (UNIT_MASS_RATIO - 0.05) / 2.15 * length, "clientY": y})
    page.mouse.up()
    check_end(page)
    page.set_viewport_size({"width": 390, "height": 844})
    check_hand(page, Finger(page), 20)
    write(page, "m_prime", "1")
    check_stills(page)


def test_in_every_engine_keys_snap_to_both_marks_and_pass_them(started):
    """A value from the server does not snap. With Shift, the keys move by a tenth of a step."""
    evaluate = started.page.evaluate
    evaluate(ANNOUNCED)
    started.put(lambda: stage.publish(stage.payload(Oscillator(1.5, 1.68, 10.0), 0.08), name="oscillator"))
    evaluate("bus.publish('exact/m_prime', { value: 1.68, text: '1.68', processed: 0 })")
    evaluate("document.querySelector('.st-key-m_prime input').value = 1.68")
    evaluate("document.querySelector('.st-key-m_prime input').focus()")

    def press(*keys_and_values: tuple[str, float]) -> None:
        for key, value in keys_and_values:
            started.page.keyboard.press(key)
            next_frame(started.page)
            assert evaluate(BOX) == shorten(value)

    press(("ArrowRight", GOAL), ("ArrowRight", 1.7), ("ArrowLeft", GOAL))
    started.page.wait_for_function(f"sent.at(-1)?.at(-1) === '{GOAL!r}'")
    assert evaluate("announced").count(IN_STEP) == 1
    press(("Shift+ArrowRight", 1.692), ("Shift+ArrowLeft", GOAL), ("Shift+ArrowLeft", 1.69), ("Shift+ArrowDown", 1.689))
    started.page.wait_for_function("sent.at(-1)?.at(-1) === '1.689'")
    evaluate("document.querySelector('.st-key-m input').value = 1.66")
    evaluate("bus.publish('exact/m', { value: 1.6612345 })")
    press(("ArrowLeft", 1.68), ("ArrowLeft", 1.67), ("ArrowLeft", 1.6612345), ("ArrowLeft", 1.65))
