"""The lesson in a browser: nothing reveals the answer before the prediction, then the machine runs."""

import itertools
import math
import re
from urllib.parse import unquote

import pytest
from playwright.sync_api import expect

from ramanujan import lesson
from ramanujan.lesson import computing
from tests.checks.browser import go, next_frame, script, settle

MACHINE = lesson.find_stop("two-clocks").machine
BY_HAND = lesson.find_stop("by-hand")
CHOSEN = "two-clocks.behind~by-hand.quarter"
STAGE = "[class*='st-key-stage_'] [data-testid=stBidiComponentIsolated]"
TEXTS, SLIDE = script("texts"), script("slide_size")
PLACE = f"document.querySelector(\"{STAGE}\").shadowRoot.querySelector('.body.slab').getAttribute('transform')"
WIDTH = "document.querySelector('[data-testid=stMain]').scrollWidth"
BUS = "JSON.stringify(ramanujan.last('drawn/stage_two-clocks_0'))"
TELLING = ("faster", "slower", "ahead by", "behind by", "in step", "gains one full turn")
NUMBERS = [
    f"{value:.{digits}g}"
    for value in (MACHINE.normalized_frequency_squared, MACHINE.natural_frequency, MACHINE.period)
    for digits in (4, 5, 7)
]


def inside(key: str) -> str:
    return f"document.querySelector('.st-key-{key} [data-testid=stBidiComponentIsolated]').shadowRoot"


def counted(page) -> list[str]:
    """Return the displayed number of the present stop, and the sentence for screen readers."""
    root = inside("turn")
    return page.evaluate(f"[{root}.querySelector('output').textContent, {root}.querySelector('input').ariaValueText]")


def predict(page, label: str) -> None:
    page.get_by_role("button", name=label, exact=True).click()
    settle(page)


def heading(page) -> str:
    return page.locator("h1").inner_text()


def test_a_student_takes_the_lesson_and_a_link_preserves_the_place(visit):
    page = visit("lesson", motion="no-preference")
    check_prediction(page)
    page.emulate_media(reduced_motion="reduce")
    check_turning(page)
    check_slider(page)
    # The address preserves all settings and choices.
    address = page.url.rpartition("/")[2]
    assert {"stop=by-hand", f"chosen={CHOSEN}", "m_prime=1.01"} <= set(re.split("[?&]", unquote(address)))
    check_waiting_mark(visit("lesson", motion="no-preference"))
    other = visit(address)
    number = 1 + lesson.STOPS.index(BY_HAND)
    assert heading(other) == f"{number}. {BY_HAND.heading}"
    assert other.locator(".st-key-m_prime input[type=range]").input_value() == "1.01"
    place = [f"{number}/{len(lesson.STOPS)}", f"Stop {number} of {len(lesson.STOPS)}: {BY_HAND.heading}"]
    assert counted(other) == place
    assert other.locator("strong", has_text="Your prediction was right.").is_visible()
    check_machines(visit("lesson?stop=zero-modes&chosen=zero-modes.two", within=other))
    check_stopwatch(visit("lesson?part=tasks&task=period", within=other))
    check_energies(visit("lesson?stop=steps", motion="no-preference"))
    # The ending is not a stop.
    assert counted(visit("lesson?stop=end", within=other)) == ["✓", "What you have seen"]


def check_prediction(page) -> None:
    """Check that before the prediction the machine is still and nothing reveals the answer; then it runs."""
    page.wait_for_selector(f"{STAGE} .body.slab[transform]", state="attached")
    # The live region announces half a second after the last change.
    page.wait_for_function("!ramanujan.last('announce')")
    before, place = page.evaluate(TEXTS), page.evaluate(PLACE)
    assert [word for word in (*TELLING, *NUMBERS) if word in before] == []
    assert "normalized" not in page.evaluate(BUS)
    next_frame(page)
    assert page.evaluate(PLACE) == place
    predict(page, "B. Behind by less than one full turn.")
    # The machine is still, and the choice can be changed.
    next_frame(page)
    assert page.evaluate(PLACE) == place
    predict(page, "Run the machine")
    # Negative control: now all of it is on the page.
    page.wait_for_function(f"{PLACE} !== '{place}'")
    # The result waits until the hands have been observed, or the machine is paused.
    expect(page.locator(".st-key-watch")).to_be_visible()
    expect(page.locator(".st-key-result_waits")).to_be_hidden()
    after = page.evaluate(TEXTS)
    assert TELLING[-1] in after
    assert f"{MACHINE.normalized_frequency_squared:.7g}" in after
    assert "normalized" in page.evaluate(BUS)
    # The clock is in view with the machine.
    dial = page.evaluate(f"{inside('stage_two-clocks_0')}.querySelector('.dial').getBoundingClientRect()")
    assert dial["width"] >= 180
    assert dial["bottom"] < 720
    expect(page.locator(".st-key-unseen-services [role=status]")).to_contain_text("You predicted: Behind by less")


def check_waiting_mark(page) -> None:
    """Check that a right prediction is marked only after its observation."""
    predict(page, "D. Ahead by less than one full turn.")
    predict(page, "Run the machine")
    expect(page.locator(".st-key-watch")).to_be_visible()
    mark = page.locator(".st-key-marked_waits [role=img]")
    expect(mark).to_be_attached()
    expect(mark).to_be_hidden()
    page.get_by_role("button", name="Pause", exact=True).click()
    expect(mark).to_be_visible()


def check_turning(page) -> None:
    """Check that arrow keys turn the stops, and that a stop without a slider offers none."""
    expect(page.locator(".st-key-watch")).to_be_hidden()
    predict(page, "Show the answer")
    expect(page.locator(".st-key-m_prime")).not_to_be_in_viewport()
    page.keyboard.press("ArrowRight")
    settle(page)
    assert heading(page) == f"2. {lesson.STOPS[1].heading}"
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowLeft")
    settle(page)
    assert heading(page) == f"3. {lesson.STOPS[2].heading}"
    assert page.locator(".st-key-m_prime input[type=range]").input_value() == "5"


def check_slider(page) -> None:
    """Check that the slider of m′ is below the clock, and that its arrow keys do not turn the stops."""
    go(page, f"lesson?stop=by-hand&chosen={CHOSEN}")
    slider, dial = page.locator(".st-key-stop_slider"), page.locator(".st-key-stage_by-hand_0 .dial")
    expect(slider).to_be_in_viewport(ratio=1)
    assert dial.bounding_box()["y"] + dial.bounding_box()["height"] <= slider.bounding_box()["y"]
    # The machine of a stop wins over a text that the click on a button enters.
    page.locator(".st-key-m_prime_exact input").fill("2")
    for button in ("button:not(.primary)", ".primary"):
        page.locator(f".st-key-turner {button}").click()
        settle(page)
        assert page.locator(".st-key-m_prime input[type=range]").input_value() == "1"
    page.locator(".st-key-m_prime input[type=range]").focus()
    page.keyboard.press("ArrowRight")
    settle(page)
    assert heading(page).endswith(BY_HAND.heading)
    assert page.get_by_text("You have changed the machine.").is_visible()


def check_machines(page) -> None:
    """Check that machines to compare are below each other, beside the words, at all widths."""
    machines = page.locator(".st-key-observed-several-3 svg.machine")
    expect(machines).to_have_count(3)
    for width, height in ((1280, 720), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        next_frame(page)
        boxes = [machine.bounding_box() for machine in machines.all()]
        assert len({round(box["x"]) for box in boxes}) == 1
        assert all(a["y"] + a["height"] <= b["y"] for a, b in itertools.pairwise(boxes))
        assert page.evaluate(WIDTH) <= width
        # They have the controls of their clock once.
        assert page.locator(".st-key-observed-several-3 .controls:visible").count() == 1
    page.set_viewport_size({"width": 1280, "height": 720})
    next_frame(page)
    last, reason = machines.last.bounding_box(), page.locator(".st-key-explanation").bounding_box()
    assert last["y"] + last["height"] < 720
    assert reason["x"] + reason["width"] <= last["x"]
    # Machines with different rollers have one scale.
    go(page, "lesson?stop=radius&chosen=radius.same")
    pictures = page.locator(".st-key-observed-several-2 svg.machine").all()
    sizes = {(picture.bounding_box()["width"], *picture.get_attribute("viewBox").split()[2:]) for picture in pictures}
    assert len(pictures) == 2
    assert len(sizes) == 1


def check_energies(page) -> None:
    """Check that the bars are those of the counted period, and that the verdict waits for the last one."""
    picture = page.locator("[class*=st-key-observed-] .scene")
    predict(page, "A. In the first run.")
    alone = picture.bounding_box()["x"]
    predict(page, "Run the machine")
    # The picture stays beside the words.
    assert picture.first.bounding_box()["x"] == pytest.approx(alone, abs=1)
    sentences, bars = picture.locator(".total"), picture.locator(".bar")
    expect(sentences).to_have_count(3)
    expect(sentences.first).to_have_text(re.compile(r"^[1-9] of 20 periods"))
    expect(page.locator(".st-key-watch")).to_be_visible()
    expect(page.locator(".st-key-result_waits")).to_be_hidden()
    share = "(bar) => bar.firstElementChild.getBoundingClientRect().width / bar.getBoundingClientRect().width"
    # Between full periods, velocity Verlet's energy differs. Value and bar are those of the last full one.
    moments = picture.nth(2).evaluate(f"""async (scene) => {{
      const moments = [];
      for (let frame = 0; frame < 60; frame++) {{
        await new Promise(requestAnimationFrame);
        moments.push([scene.querySelector(".total").textContent, ({share})(scene.querySelector(".bar"))]);
      }}
      return moments;
    }}""")
    for text, drawn in moments:
        written = int(re.search(r"(\d+)\u202f%", text)[1]) / 100
        assert drawn * computing.largest_energy() == pytest.approx(written, abs=0.015)
    expect(page.locator(".st-key-result_waits")).to_be_visible(timeout=60_000)
    ratios = [1.0, *(computing.final_energy_ratio(method) for method in computing.STEPS_PER_PERIOD)]
    for ratio, sentence, bar in zip(ratios, sentences.all(), bars.all(), strict=True):
        # All machines rest at the same moment.
        assert sentence.inner_text() == f"20 of 20 periods. Energy: {100 * ratio:.0f}\u202f% of that at release."
        assert bar.evaluate(share) == pytest.approx(ratio / computing.largest_energy(), abs=0.01)


def check_stopwatch(page) -> None:
    """Check that the stopwatch measures, and that nothing reveals the period before."""
    before = page.evaluate(TEXTS)
    assert [text for text in NUMBERS if text in before] == []
    watch = page.locator(".st-key-task_stopwatch")
    watch.get_by_role("button", name="Start").click()
    page.wait_for_function(f"parseFloat({inside('task_stopwatch')}.querySelector('output').textContent) > 0.3")
    watch.get_by_role("button", name="Stop").click()
    settle(page)
    shown = float(re.match(r"[\d.]+", watch.locator("output").inner_text())[0])
    judged = re.search(r"You measured ([\d.]+)", page.locator(".st-key-task_verdict").inner_text())
    assert float(judged[1]) == pytest.approx(shown / 10, abs=1e-3)


@pytest.mark.xdist_group("german")
def test_a_slide_shows_machine_clock_verdict_and_reason_together(visit, german):
    """The longest stop in German: before and after the run all is on one slide, and nothing scrolls."""
    page = None
    drawn = ".st-key-stage_two-clocks_0 svg.machine", ".st-key-stage_two-clocks_0 .dial"
    for chosen in ("", "behind.predicted", "behind.missed", "behind", "ahead"):
        address = f"lesson?view=projector&chosen=two-clocks.{chosen}" if chosen else "lesson?view=projector"
        page = visit(address, within=page, network=german)
        for width, height in ((1280, 720), (1024, 768)):
            page.set_viewport_size({"width": width, "height": height})
            next_frame(page)
            assert page.evaluate(SLIDE)["over"] <= 2, (chosen, width)
            machine, dial = (page.locator(place).bounding_box() for place in drawn)
            # Both keep their size during the stop.
            assert machine["height"] >= 0.32 * height
            assert dial["height"] >= 0.24 * height
            assert dial["y"] + dial["height"] <= height
    words = page.locator(".st-key-slide-question").inner_text()
    assert "richtige Antwort" not in words
    assert "Ihre Vorhersage war richtig." in words
    assert "0,952" in words


def test_on_a_phone_the_verdict_is_visible_and_hands_are_compared_at_the_moment_of_the_question(visit):
    page = visit("lesson?chosen=two-clocks.ahead", width=390, height=844)
    verdict, machine = (page.locator(place).first.bounding_box() for place in (".st-key-lead-verdict", "svg.machine"))
    reason = page.get_by_role("link", name="See the two hands").bounding_box()
    assert verdict["height"] > 20
    assert verdict["y"] + verdict["height"] <= machine["y"] < 600
    assert machine["y"] + machine["height"] <= reason["y"]
    dial = page.locator(".dial").first.bounding_box()
    assert machine["y"] + machine["height"] <= dial["y"]
    assert dial["y"] + dial["height"] <= 844
    assert page.evaluate(WIDTH) <= 390
    page.get_by_role("button", name="Show the hands after 10 periods").click()
    page.wait_for_function("ramanujan.last('time/stage_two-clocks_0')?.time > 1")
    shown = page.evaluate("ramanujan.last('time/stage_two-clocks_0').time")
    assert shown == pytest.approx(10 * 2 * math.pi / math.sqrt(10.0), rel=1e-6)
    assert page.locator(".verdict").first.inner_text().startswith("10 of 10 periods.")
    for address in ("stop=contact", "part=tasks&task=top-at-rest", "part=notes"):
        page = visit(f"lesson?{address}", width=390, height=844, within=page)
        assert page.evaluate(WIDTH) <= 390, address
        if "contact" in address:
            # The options precede the machine, so a small phone shows them without scrolling.
            stage, options = (page.locator(place).first.bounding_box()["y"] for place in (STAGE, ".st-key-options"))
            assert options < stage
