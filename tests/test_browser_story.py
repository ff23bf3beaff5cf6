"""The story of the first page: its sentences and the hands at every moment, against the numeric core."""

import re
from itertools import accumulate, pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from ramanujan import UNIT_MASS_RATIO, Oscillator, normalized_frequency_squared
from ramanujan.browser import stage
from ramanujan.browser.components import exact
from ramanujan.pages.oscillator.page import draw_story_button
from ramanujan.pages.oscillator.story import SCREEN_PERIOD, STARTS, STILL_PERIODS, make_story
from ramanujan.shell import widgets
from ramanujan.shell.parameters import PARAMETERS
from tests.bare import Bare
from tests.browser import STAGE, inside, next_frame, script, settle, thumb, traffic
from tests.engines import ANY_ENGINE
from tests.test_browser_controls import write

GOAL = 1.5 * UNIT_MASS_RATIO
STORY = "document.querySelector('.st-key-story [data-testid=stBidiComponentIsolated]').shadowRoot"
NOW = f"""() => {{
  const text = (root, selector) => root.querySelector(selector).textContent;
  const angle = (name) => /[-.\\d]+/.exec({STAGE}.querySelector(`.hand.${{name}}`).getAttribute("transform"))[0];
  return {{ periods: ramanujan.last("time/oscillator").periods, ratio: ramanujan.last("drawn/oscillator").ratio,
    sentence: text({STORY}, ".sentence"), verdict: text({STAGE}, ".verdict"), parting: text({STAGE}, ".parting"),
    degrees: angle("machine") - angle("plain") }};
}}"""
IN_STEP = "In step: ε = (√1729 − 1)/36. So (36ε + 1)² = 1729."
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


@pytest.mark.parametrize("start", STARTS)
def test_the_hands_meet_again_when_both_machines_are_in_step(start):
    scenes = make_story(start)
    assert [scenes[0].ratios[0], scenes[2].ratios[0], scenes[-1].ratios[-1]] == [
        start,
        UNIT_MASS_RATIO,
        UNIT_MASS_RATIO,
    ]
    for first, second in pairwise(scenes):
        assert first.ratios[-1] == second.ratios[0]
    arrives, ends = sum(scene.periods for scene in scenes[:2]), sum(scene.periods for scene in scenes)
    turns = gained(scenes, arrives)
    assert turns == pytest.approx(round(turns), abs=1e-3)
    assert turns <= -0.999
    assert gained(scenes, ends - 1e-9) == pytest.approx(round(turns), abs=1e-3)


FRAME = 0.05 / SCREEN_PERIOD
"""Periods of the plain mass in a frame."""


@pytest.fixture
def started(bare) -> Bare:
    """The stage, the slider of m′ with its box, and the story, for m = 1.5 kg."""
    page = bare()
    page.sliders(m=1.5, m_prime=1, k=10, compression=8, radius=10)
    page.put(lambda: exact("m_prime", widgets.box_settings(PARAMETERS["m_prime"]), lambda _text: None))
    page.page.evaluate("bus.publish('exact/m_prime', { value: 1, text: '1.0', processed: 0 })")
    page.stage(Oscillator(1.5, 1.0, 10.0))
    page.put(draw_story_button)
    return page


def check_story(page) -> None:
    """Run the story, and compare its sentence, mass ratio and hands at every moment with the core."""
    scenes, shown = make_story(STARTS[0]), set()
    ends = [*accumulate(scene.periods for scene in scenes)]
    page.evaluate(f"{STORY}.querySelector('button').click()")
    while (now := page.evaluate(f"() => (turn(8), ({NOW})())"))["sentence"] != IN_STEP:
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
            assert ("behind" in now["verdict"]) == (ahead < 0)
        rate = abs(float(np.sqrt(normalized_frequency_squared(now["ratio"]))) - 1)
        if rate > 1e-9:
            assert figure(now["parting"].replace("\u202f", "")) == pytest.approx(1 / rate, rel=0.05, abs=0.5)
    assert shown == {scene.sentence for scene in scenes}
    # It ends in step immediately, also with a slow server.
    now = page.evaluate(f"() => (turn(1), ({NOW})())")
    assert (now["sentence"], now["ratio"]) == (IN_STEP, pytest.approx(UNIT_MASS_RATIO, rel=1e-15))


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
    while evaluate(f"() => (turn(8), ({NOW})())")["ratio"] > 4.5:
        pass
    page.keyboard.press("Shift")
    page.wait_for_function("sent.length === 3")
    key, event, value = started.sent[-1]
    assert (key, event) == ("m_prime", "slider")
    assert 2 < value / 1.5 < 4.6
    # A change of the preference to reduced motion completes the story.
    evaluate(f"{STORY}.querySelector('button').click()")
    evaluate("() => (turn(8), setReducedMotion(true))")
    assert evaluate(f"() => (turn(8), ({NOW})())")["sentence"] == IN_STEP
    assert not evaluate(f"{STORY}.querySelector('.stills').hidden")


LET_GO = """(at) => ["pointermove", "pointerup"].forEach((type) =>
    dispatchEvent(new PointerEvent(type, { ...at, pageX: at.clientX, pointerId: 1, pointerType: "mouse" })))"""
"""Moves a thumb and releases it before the page has drawn the move, as on a slow machine."""


def ratio_and_box(page) -> tuple[float, str]:
    """The drawn mass ratio, and the text of the box."""
    ratio = page.evaluate("ramanujan.last('drawn/oscillator').ratio")
    return ratio, page.locator(".st-key-m_prime_exact input").input_value()


def check_end(page) -> None:
    """Check that slider, session and address end with the exact value."""
    settle(page)
    page.wait_for_url(f"**m_prime={GOAL!r}*")
    settle(page)
    assert page.evaluate("ramanujan.last('machine/oscillator').parameters.m_prime") == GOAL
    assert ratio_and_box(page) == (pytest.approx(UNIT_MASS_RATIO, rel=1e-15), repr(GOAL))
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


def test_a_thumb_near_the_ratio_snaps_to_it_exactly(visit):
    """Check the mouse within six pixels, and a finger; the next test checks keys.

    Afterwards check the still clocks, because this page has reduced motion.
    """
    page = visit("?m=1.5&hide=curve,steps", has_touch=True)
    least, most = PARAMETERS["m_prime"].limits
    mass_per_pixel = (most - least) / page.locator(".st-key-m_prime [role=group]").first.bounding_box()["width"]
    (x, y), sent = thumb(page, "m_prime"), len(traffic(page).sent)
    goal = x + (GOAL - 1) / mass_per_pixel
    page.mouse.move(x, y)
    page.mouse.down()
    for off, near in ((-12, False), (-4, True), (4, True), (12, False)):
        page.mouse.move(goal + off, y, steps=3)
        next_frame(page)
        assert (ratio_and_box(page)[1] == repr(GOAL)) == near, off
    assert len(traffic(page).sent) == sent
    page.evaluate(LET_GO, {"clientX": goal + 3, "clientY": y})
    page.mouse.up()
    check_end(page)
    write(page, "m_prime", "1")
    client = page.context.new_cdp_session(page)
    for kind, at in (("Start", x), *(("Move", x + (goal - 3 - x) * n / 8) for n in range(1, 9)), ("End", None)):
        points = [] if at is None else [{"x": at, "y": y}]
        client.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})
        page.wait_for_timeout(30)
    check_end(page)
    write(page, "m_prime", "1")
    check_stills(page)


def test_in_every_engine_a_key_snaps_to_the_goal_and_this_is_announced_once(started):
    """A key snaps within a step of the goal; a value from the server does not snap."""
    evaluate = started.page.evaluate
    evaluate(ANNOUNCED)
    started.put(lambda: stage.publish(stage.payload(Oscillator(1.5, 1.68, 10.0), 0.08), name="oscillator"))
    evaluate("bus.publish('exact/m_prime', { value: 1.68, text: '1.68', processed: 0 })")
    evaluate("document.querySelector('.st-key-m_prime input').value = 1.68")
    box = "document.querySelector('.st-key-m_prime_exact [data-testid]').shadowRoot.querySelector('input').value"
    evaluate("document.querySelector('.st-key-m_prime input').focus()")
    for key, value in (("Right", repr(GOAL)), ("Right", "1.7"), ("Left", repr(GOAL))):
        started.page.keyboard.press(f"Arrow{key}")
        next_frame(started.page)
        assert evaluate(box) == value
    started.page.wait_for_function(f"sent.at(-1)?.at(-1) === '{GOAL!r}'")
    assert evaluate("announced").count(IN_STEP) == 1
