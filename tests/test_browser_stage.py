"""The stage in a real browser: what it shows, what it costs, what a hand can do with it."""

import math
from itertools import pairwise

import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator
from tests.browser import next_frame
from tests.engines import ANY_ENGINE
from tests.picture import Picture


@pytest.fixture
def picture(bare) -> Picture:
    return Picture(bare())


def slab(picture) -> float:
    return picture.find("root.querySelector('.moving .body.slab .form').getBoundingClientRect().x")


@ANY_ENGINE
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


@ANY_ENGINE
def test_nothing_jumps_when_a_parameter_changes(picture):
    """The machine moves at once, frame by frame across a preset never further than twice its greatest speed allows."""
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
    here.page.evaluate("() => bus.subscribe('announce', ({ sentence }) => (window.said ??= []).push(sentence))")
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
    page.evaluate("setReducedMotion(false)")
    next_frame(page)
    assert (picture.find(play), picture.find(share), picture.find(ghosts)) == ("Pause", "hidden", 0)
    page.wait_for_timeout(200)
    assert slab(picture) != place
    page.evaluate("setReducedMotion(true)")
    next_frame(page)
    assert (picture.find(play), picture.find(ghosts)) == ("Play", 5)
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    page.evaluate("document.querySelectorAll('.stSlider').forEach((each) => each.remove())")
    picture.show(Oscillator(1, UNIT_MASS_RATIO, 10), 0.08)
    assert "in step" in page.evaluate("said.at(-1)")


MACHINE = Oscillator(1.0, 2.0, 10.0)
TELLING = {
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
"""All words of the stage, those for the eye and those for a screen reader."""


@ANY_ENGINE
def test_what_is_hidden_is_neither_drawn_nor_said(bare):
    """What the page says around the stage is in test_scene_view."""
    for hide in (("clocks", "numbers"), ()):
        here = bare()
        here.page.evaluate("() => bus.subscribe('announce', ({ sentence }) => (window.said ??= []).push(sentence))")
        picture = Picture(here, machine=MACHINE, hide=hide)
        words = [picture.find(WORDS)]
        for action in ("forward", "back"):
            picture.find(f"root.querySelector('[data-do={action}]').click()")
            next_frame(picture.page)
            words.append(picture.find(WORDS))
        said = "\n".join([*words, *here.page.evaluate("window.said ?? []")])
        # The negative control: where nothing is hidden, all of it is found.
        assert {text for text in TELLING if text in said} == (set() if hide else TELLING)
        parts = picture.find("root.querySelectorAll('.dial, .gauge, .verdict, .parting, .readouts, .legend b').length")
        assert (parts == 0) == bool(hide)
        assert (here.page.evaluate("bus.last('drawn/oscillator').normalized ?? null") is None) == bool(hide)
        assert (picture.find("root.querySelector('[data-step]')?.dataset.step ?? ''") == "") == bool(hide)


@ANY_ENGINE
def test_a_machine_whose_motion_is_hidden_stands_still(bare):
    picture = Picture(bare(), hide=("motion",))
    picture.page.evaluate("setReducedMotion(false)")
    place = slab(picture)
    picture.find("root.querySelector('.stage').focus()")
    picture.page.keyboard.press("ArrowRight")
    picture.page.wait_for_timeout(200)
    assert slab(picture) == place
    assert picture.find("root.querySelector('[data-do=play], .show')?.checkVisibility() ?? false") is False
