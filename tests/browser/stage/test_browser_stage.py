"""The stage in a browser: readouts, controls, reduced motion, hidden parts."""

import math
from itertools import pairwise

import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.browser import stage
from tests.checks.browser import next_frame
from tests.checks.engines import ANY_ENGINE
from tests.checks.picture import Picture

RECORD_ANNOUNCEMENTS = "() => bus.subscribe('announce', ({ sentence }) => (window.announced ??= []).push(sentence))"


@pytest.fixture
def picture(bare) -> Picture:
    return Picture(bare())


def slab(picture) -> float:
    return picture.find("root.querySelector('.moving .body.slab .form').getBoundingClientRect().x")


@ANY_ENGINE
def test_the_readouts_agree_with_the_core_and_fast_motion_is_slowed_with_a_note(picture):
    for m, m_prime, k in [(0.5, 10.0, 1.0), (0.5, 0.05, 200.0), (0.77, 1.3, 33.5)]:
        machine = Oscillator(m, m_prime, k)
        picture.show(machine, 0.08)
        for name, value, accuracy in (
            ("normalized", machine.normalized_frequency_squared, 1e-6),
            ("omega", machine.natural_frequency, 1e-4),
            ("period", machine.period, 1e-3),
        ):
            readout = picture.find(f"root.querySelector('[data-read={name}]').textContent")
            assert float(readout.split()[0]) == pytest.approx(value, rel=accuracy)
        assert ("times its real speed" in picture.find("root.querySelector('.note').textContent")) == (k == 200)


@ANY_ENGINE
def test_nothing_jumps_when_a_parameter_changes(picture):
    """The machine moves at once, and in every frame by at most twice the distance of its greatest speed."""
    page = picture.page
    page.evaluate("setReducedMotion(false)")
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
    # A change of shape by Δ fades with 70 ms. Δ is at most 3 cm: the difference of the couplings times x₀.
    fading = 0.03 / 0.07 * scale
    assert max(moved - 2 * (fastest + fading) * ms / 1000 for ms, moved in steps) < 2
    assert sum(moved for _, moved in steps) > 20
    picture.find("root.querySelector('[data-do=play]').click()")
    page.wait_for_timeout(500)  # until the offset has faded
    still = slab(picture)
    page.wait_for_timeout(300)
    assert slab(picture) == still


@ANY_ENGINE
def test_a_sentence_explains_that_k_and_equal_factors_of_both_masses_leave_the_drift(bare):
    machines = [Oscillator(1, 2, 10), Oscillator(1, 2, 20), Oscillator(1, 3, 20), Oscillator(2, 4, 20)]
    for dials in (True, False):
        picture, sentences = Picture(bare(), dials=dials), []
        for machine in machines:
            picture.show(machine, 0.08)
            sentences.append(picture.find("root.querySelector('.parting').textContent"))
        stiffer = "k makes both 1.41 times as fast, so the drift stays the same."
        heavier = "m and m′ make both 0.707 times as fast, so the drift stays the same."
        explanations = [sentence for sentence in sentences if "one full turn in" not in sentence]
        assert explanations == ([stiffer, heavier] if dials else [])
        assert "one full turn in" in sentences[2]


def test_the_motion_rests_at_the_moment_of_a_question_until_a_person_plays_on(bare):
    picture = Picture(bare(), rest_after=0.25)
    page, time = picture.page, "bus.last('time/oscillator')"
    page.evaluate("setReducedMotion(false)")
    resting = f"{time}.playing === false && {time}.periods === 0.25"
    page.wait_for_function(resting)
    # A new release also plays again.
    picture.bare.put(lambda: stage.publish(stage.payload(Oscillator(), 0.08) | {"releases": 1}, name="oscillator"))
    page.wait_for_function(f"{time}.playing")
    page.wait_for_function(resting)
    picture.find("root.querySelector('[data-do=play]').click()")
    page.wait_for_function(f"{time}.playing && {time}.periods > 0.4")
    # After a desk's release long ago the motion rests, too. After a desk has played on, it does not.
    view = {"layers": "none", "from": "ground", "speed": 1, "rates": "0.5,0.5", "ago": 100}
    for turns, state in (("0,0", resting), ("0.3,0.25", f"{time}.playing && {time}.periods > 50")):
        page.evaluate("(view) => bus.publish('view/oscillator', view)", view | {"turns": turns})
        page.wait_for_function(state)


def test_buttons_layers_and_keys_have_the_same_effects(picture):
    """test_browser_picture measures how far they move the picture."""
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
    # A click elsewhere closes an open menu.
    opened = "root.querySelector('[popover]').matches(':popover-open')"
    box = picture.find("root.querySelector('.show').getBoundingClientRect()")
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert picture.find(opened)
    page.mouse.click(3, 3)
    assert not picture.find(opened)


def test_the_layers_follow_the_view_and_the_slide_until_a_person_chooses_others(bare):
    picture = Picture(bare(), layers=("traces",))
    views = {"": {"layers": ["arrows"]}, "energy": {"layers": ["energy", "arrows"]}}

    def shown() -> list[str]:
        next_frame(picture.page)
        boxes = picture.find(
            "[...root.querySelectorAll('[data-layer]')].map((box) => [box.dataset.layer, box.firstChild.checked])"
        )
        for name in ("arrows", "traces"):
            assert (picture.find(f"root.querySelector('.{name}').style.display") == "") == dict(boxes)[name]
        return [name for name, is_checked in boxes if is_checked]

    def publish(**more: object) -> None:
        data = stage.payload(Oscillator(), 0.08, **more)
        picture.bare.put(lambda: stage.publish(data, name=picture.name))

    assert shown() == ["traces"]
    publish(views=views)
    assert shown() == ["arrows"]
    for slide, expected in (("energy", ["energy", "arrows"]), ("other", ["traces"]), (None, ["arrows"])):
        picture.page.evaluate("(slide) => bus.publish('slide', slide)", slide)
        assert shown() == expected
    toggle = "root.querySelector('[data-layer=traces] input').click()"
    picture.find(toggle)
    publish(views={"": {"layers": ["energy"]}})
    assert shown() == ["arrows", "traces"], "a person's choice stays"
    publish(views=views)
    picture.find(toggle)
    publish(views={"": {"layers": ["energy"]}})
    assert shown() == ["energy"], "the layers of the view are no choice"


@ANY_ENGINE
def test_reduced_motion_shows_a_described_still_and_the_preference_takes_effect_at_once(bare):
    here = bare()
    here.sliders(m=1, m_prime=1, k=10, compression=8, radius=10)
    here.page.evaluate(RECORD_ANNOUNCEMENTS)
    picture = Picture(here)
    page = picture.page
    turns = 1 / (math.sqrt(Oscillator().normalized_frequency_squared) - 1)
    (sentence,) = page.evaluate("announced")
    assert f"{Oscillator(1, 1, 10).period:.2f}" in sentence
    # The clock shows the same number.
    for text in (sentence, picture.find("root.querySelector('.parting').textContent")):
        assert f"one full turn in {turns:.0f} periods" in text
    play = "root.querySelector('[data-do=play]').ariaLabel"
    assert picture.find(play) == "Play"
    ghosts = "root.querySelectorAll('.ghosts > g').length"
    assert picture.find(ghosts) == 5
    # Another machine has other ghosts, which are hidden from screen readers.
    drawn = picture.find("root.querySelector('.ghosts').innerHTML")
    page.evaluate("document.querySelector('.st-key-m_prime input').focus()")
    page.keyboard.press("PageUp")
    next_frame(page)
    assert picture.find("root.querySelector('.ghosts').innerHTML") != drawn
    assert picture.find(ghosts) == 5
    assert picture.find("root.querySelectorAll('.ghosts :is([role], [tabindex], [aria-valuenow])').length") == 0
    # The last ghost is half a period later, with the opposite compression.
    x = "(ghost, name) => ghost.querySelector(name).transform.baseVal[0].matrix.e"
    first, last = picture.find(
        f"[0, 4].map((i) => root.querySelectorAll('.ghosts > g')[i])"
        f".map((ghost) => ({x})(ghost, '.slab') - ({x})(ghost, '.block'))",
    )
    assert (first, last) == (pytest.approx(8, abs=1e-3), pytest.approx(-8, abs=1e-3))
    place = slab(picture)
    page.wait_for_timeout(300)
    assert slab(picture) == place
    # Percentages are shown only for a paused machine, because running numbers cannot be read.
    share = "getComputedStyle(root.querySelector('.legend b')).visibility"
    assert picture.find(share) == "visible"
    page.evaluate("setReducedMotion(false)")
    next_frame(page)
    assert (picture.find(play), picture.find(share), picture.find(ghosts)) == ("Pause", "hidden", 0)
    page.wait_for_timeout(200)
    assert slab(picture) != place
    page.evaluate("setReducedMotion(true)")
    next_frame(page)
    assert (picture.find(play), picture.find(ghosts)) == ("Play", 5)
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    # Without sliders, the numbers of the message are described.
    page.evaluate("document.querySelectorAll('.slider').forEach((each) => each.remove())")
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    assert "in step" in page.evaluate("announced.at(-1)")


MACHINE = Oscillator(1.0, 2.0, 10.0)
REVEALING = {
    f"{MACHINE.normalized_frequency_squared:.7f}"[:6],
    f"{MACHINE.natural_frequency:.3f}",
    f"{MACHINE.period:.2f}",
    f"{1 / abs(MACHINE.normalized_frequency_squared**0.5 - 1):.1f}",
    "slower",
}
WORDS = """[...root.querySelectorAll(":not(script, style)")].flatMap((node) => [
  ...[...node.childNodes].filter((each) => each.nodeType === 3).map((each) => each.data),
  ...[...node.attributes].filter((each) => /^(aria|title)/.test(each.name)).map((each) => each.value),
]).join("\\n")"""
"""All texts of the stage, including those for screen readers."""


@ANY_ENGINE
def test_hidden_parts_are_neither_drawn_nor_announced(bare):
    """test_scene_view checks the texts around the stage."""
    for hide in (("clocks", "numbers"), ()):
        here = bare()
        here.page.evaluate(RECORD_ANNOUNCEMENTS)
        picture = Picture(here, machine=MACHINE, hide=hide)
        words = [picture.find(WORDS)]
        for action in ("forward", "back"):
            picture.find(f"root.querySelector('[data-do={action}]').click()")
            next_frame(picture.page)
            words.append(picture.find(WORDS))
        texts = "\n".join([*words, *here.page.evaluate("window.announced ?? []")])
        # Negative control: without hidden parts, all of these texts occur.
        assert {text for text in REVEALING if text in texts} == (set() if hide else REVEALING)
        clocks = ".dial, .together, .verdict, .parting, .readouts, .legend b"
        parts = picture.find(f"root.querySelectorAll('{clocks}').length")
        assert (parts == 0) == bool(hide)
        assert (here.page.evaluate("bus.last('drawn/oscillator').normalized ?? null") is None) == bool(hide)
        assert (picture.find("root.querySelector('[data-step]')?.dataset.step ?? ''") == "") == bool(hide)


@ANY_ENGINE
def test_a_running_machine_returns_to_its_release_when_its_motion_is_hidden(bare):
    picture, machine = Picture(bare()), Oscillator()
    picture.show(machine, 0.08)
    at_release = slab(picture)
    picture.at(0.3)
    assert slab(picture) != at_release
    data = stage.payload(machine, 0.08)
    picture.bare.put(lambda: stage.publish(data, name=picture.name, hide=("motion",)))
    picture.page.wait_for_timeout(1000)
    assert slab(picture) == pytest.approx(at_release, abs=0.5)


def test_a_machine_with_hidden_motion_is_still(bare):
    picture = Picture(bare(), hide=("motion",))
    picture.page.evaluate("setReducedMotion(false)")
    place = slab(picture)
    picture.find("root.querySelector('.stage').focus()")
    picture.page.keyboard.press("ArrowRight")
    picture.page.wait_for_timeout(200)
    assert slab(picture) == place
    assert picture.find("root.querySelector('[data-do=play], .show')?.checkVisibility() ?? false") is False
    # An arrow of the drift would reveal which machine is faster.
    assert picture.find("root.querySelector('.dial .drift path').getBoundingClientRect().width") == 0
