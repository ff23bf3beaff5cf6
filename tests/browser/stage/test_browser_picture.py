"""The drawn picture: bodies, hands, bars and arrows in the browser, against the numeric core.

With RAMANUJAN_DEEP, fifty random machines are drawn, in addition to those at the limits of the sliders.
"""

import math
import re
from itertools import combinations, product

import numpy as np
import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator, mass_ratio_for
from ramanujan.browser import stage
from ramanujan.pages.motion.cache import drawn_spacing
from ramanujan.physics.motion import InitialState, ground_positions, ground_velocities, released
from ramanujan.shell.theme import BODY_COLORS
from tests.checks.bare import THEME
from tests.checks.browser import STAGE, next_frame, script
from tests.checks.engines import ANY_ENGINE
from tests.checks.look import rgb
from tests.checks.picture import ROLLERS, SEED, Picture, difference, length, machines, middle, places
from tests.checks.reading import NUMBER, read
from tests.settings import DEEP

HALF_A_PIXEL = 0.5
FRAME = 0.05
"""Duration of a frame of the turned clock [s]."""
HANDS = f"""['machine', 'plain'].map((name) =>
  {STAGE}.querySelector('.hand.' + name).transform.baseVal[0].angle)"""
"""The drawn angles of both hands [degrees]."""
TURN_HANDS = f"""(moves) => moves.map(([key, value]) => {{
  const slider = document.querySelector(`.st-key-${{key}} input`);
  slider.value = value;
  slider.dispatchEvent(new Event("input"));
  turn(1);
  return {HANDS};
}})"""
"""Moves sliders, one in each frame; returns the angles of both hands after each frame."""
ONE_DEGREE = 1.0
MACHINES = 50 if DEEP else 1


TIMES = (0.0, 0.25, 0.5, 0.75, *np.random.default_rng(SEED).uniform(-1, 4, max(1, MACHINES)))
"""Times in periods: quarters of a period, and other moments before and after the release."""


@pytest.fixture
def picture(bare) -> Picture:
    return Picture(bare())


@pytest.fixture
def motion_picture(bare) -> Picture:
    """The stage of the motion page, whose view follows the centre of mass of a machine that was pushed."""
    return Picture(bare(), "motion", dials=False)


def homes(picture: Picture, drawn: dict) -> dict[str, float]:
    """The bodies' centres at q = 0 [m from the zero of the floor], derived from a picture of a known state."""
    moved = ground_positions(picture.machine, picture.q)
    return {name: (x - picture.zero) / picture.pixels - moved[name] for name, x in places(drawn).items()}


def check_bodies(picture: Picture, drawn: dict, home: dict[str, float]) -> None:
    """Check that every body has the core's position and angle, and touches the body that it rolls on."""
    machine, pixels = picture.machine, picture.pixels
    for value, x in drawn["ruler"]:
        assert x == pytest.approx(picture.zero + value / 100 * pixels, abs=2 * HALF_A_PIXEL), "the ruler is to scale"
    for name, moved in ground_positions(machine, picture.q).items():
        expected = picture.zero + (home[name] + moved) * pixels
        assert places(drawn)[name] == pytest.approx(expected, abs=HALF_A_PIXEL), name
    _, phi, Phi = picture.q
    R = machine.radius * pixels
    for name, angle in (("hoop", phi), ("cylinder", phi), ("top", Phi)):
        assert difference(drawn["rollers"][name]["angle"], math.degrees(angle)) < ONE_DEGREE, name
        assert drawn["rollers"][name]["radius"] == pytest.approx(R, abs=HALF_A_PIXEL), name
    slab, (left, upper, right, _) = drawn["slab"], drawn["block"]
    x = places(drawn)
    lower = drawn["rollers"]["hoop"]["centre"][1]
    assert drawn["rollers"]["cylinder"]["centre"][1] == pytest.approx(lower, abs=HALF_A_PIXEL)
    assert lower - R == pytest.approx(slab[3], abs=HALF_A_PIXEL), "the slab lies on the rollers"
    assert drawn["rollers"]["top"]["centre"][1] + R == pytest.approx(upper, abs=HALF_A_PIXEL)
    assert drawn["spring"][0] == pytest.approx(slab[2], abs=HALF_A_PIXEL), "the spring begins at the slab"
    assert left < x["hoop"] - R < x["cylinder"] - 3 * R < drawn["spring"][2] < x["top"] < right


def test_all_that_is_drawn_agrees_with_the_core(picture, sample):
    picture.layers("arrows")
    known: dict[float, dict[str, float]] = {}
    for machine, compression in sample([*machines(MACHINES), (Oscillator(1.0, UNIT_MASS_RATIO), 0.08)]):
        picture.show(machine, compression)
        for periods in TIMES:
            drawn = picture.at(periods)
            # The positions at q = 0 depend only on R. They are read once and must fit every x₀ and every state.
            home = known.setdefault(machine.radius, homes(picture, drawn))
            check_bodies(picture, drawn, home)
            check_clock(picture, drawn, home, periods)
            for name in ROLLERS:
                arrow = drawn["arrows"][name]
                if arrow:
                    tail, _y = arrow["tail"]
                    assert tail == pytest.approx(places(drawn)[name], abs=HALF_A_PIXEL), "it begins at the axis"
        assert home["cylinder"] - home["hoop"] == pytest.approx(drawn_spacing(machine.radius), rel=1e-3)
        assert home["slab"] == pytest.approx((home["cylinder"] + home["hoop"]) / 2, rel=1e-3)


@ANY_ENGINE
def test_in_the_frame_of_the_block_it_is_still_and_the_velocities_of_rolling_are_drawn(picture, sample):
    """The floor moves, and the velocities on a lower roller are 0, Rφ̇ and 2Rφ̇ for any motion of the block."""
    switch = "root.querySelector('.viewpoint input').click()"
    picture.layers("arrows")
    picture.find(switch)
    for machine, compression in sample(machines(MACHINES)[-2:]):
        picture.show(machine, compression)
        blocks, zeros = [], []
        for periods in (0.1, 0.25, 0.6, 0.95):
            drawn = picture.at(periods)
            check_bodies(picture, drawn, homes(picture, drawn))
            blocks.append(drawn["block"])
            zeros.append(picture.zero - picture.q[0] * picture.pixels)
            ground = ground_velocities(machine, picture.q_dot)
            relative = {name: velocity - ground["block"] for name, velocity in ground.items()}
            scale = drawn["scales"]["speed"]
            assert "relative to the block" in scale["text"]
            check_arrows(drawn["arrows"], relative, scale)
            rolling = machine.radius * picture.q_dot[1]
            check_arrows(drawn["rolling"], {"contact": 0, "centre": rolling, "top": 2 * rolling}, scale)
            (x, y), R = drawn["rollers"]["hoop"]["centre"], drawn["rollers"]["hoop"]["radius"]
            tails = [drawn["rolling"][point]["tail"] for point in ("contact", "centre", "top")]
            assert np.array(tails) == pytest.approx(np.array([[x, y + R], [x, y], [x, y - R]]), abs=2 * HALF_A_PIXEL)
        assert np.ptp(blocks, axis=0).max() < HALF_A_PIXEL
        assert np.ptp(zeros) < 2 * HALF_A_PIXEL, "the floor moves by X"
    picture.find(switch)
    # Negative control: in the frame of the ground the block moves.
    assert np.ptp([picture.at(periods)["block"][0] for periods in (0.1, 0.6)]) > 2


def check_clock(picture: Picture, drawn: dict, home: dict[str, float], periods: float) -> None:
    """Check both hands, and the plain mass, which oscillates with the amplitude x₀."""
    phase = math.sqrt(picture.machine.k / picture.machine.m) * picture.time
    assert difference(drawn["hands"]["machine"], 360 * periods) < ONE_DEGREE
    assert difference(drawn["hands"]["plain"], math.degrees(phase)) < ONE_DEGREE
    gained = 360 * 3 * (math.sqrt(picture.machine.normalized_frequency_squared) - 1)
    arrow = drawn["drift"]
    assert difference(arrow["tail"], 360 * periods) < ONE_DEGREE
    assert difference(arrow["tip"] - arrow["tail"], max(gained, -0.96 * 360)) < ONE_DEGREE
    assert arrow["shaft"] <= min(abs(gained), 360) <= arrow["shaft"] + 20 or gained < -340
    moved = picture.compression * math.cos(phase)
    rest = home.setdefault("plain", (middle(drawn["plain"]) - picture.zero) / picture.pixels - moved)
    expected = picture.zero + (rest + moved) * picture.pixels
    assert middle(drawn["plain"]) == pytest.approx(expected, abs=HALF_A_PIXEL)


@ANY_ENGINE
def test_a_pushed_machine_and_the_view_that_follows_it(motion_picture, sample):
    known: dict[float, dict[str, float]] = {}
    corners = machines(MACHINES)
    for machine, compression in sample(corners[1:2] + corners[-1:]):
        far = 0.02 / machine.period
        start = released(machine, compression).phi
        for pushes in ({"X_dot": -0.2}, {"X_dot": 0.1}, {"Phi_dot": far / machine.radius}, {"phi_dot": -far}):
            motion_picture.show(machine, compression, InitialState(phi=start, **pushes))
            centres = []
            for periods in (0.0, 0.3, 0.95):
                drawn = motion_picture.at(periods)
                centres.append(drawn["centre"][0])
                home = known.setdefault(machine.radius, homes(motion_picture, drawn))
                check_bodies(motion_picture, drawn, home)
                assert home["cylinder"] - home["hoop"] == pytest.approx(drawn_spacing(machine.radius), rel=1e-3)
            assert max(centres) - min(centres) < HALF_A_PIXEL, "the centre of mass stands still in the view"


@ANY_ENGINE
def test_the_smallest_push_moves_the_picture_least(motion_picture):
    """The view has no threshold for the change from the floor to the centre of mass."""
    machine = Oscillator(2.0, 0.7, 30.0)
    start = released(machine, 0.1).phi
    blocks = []
    for push in (0.0, 1e-13, 1e-10, 1e-6):
        motion_picture.show(machine, 0.1, InitialState(phi=start, X_dot=push))
        blocks.append([middle(motion_picture.at(periods)["block"]) for periods in (0.25, 0.5, 0.9)])
    assert np.ptp(blocks, axis=0).max() < HALF_A_PIXEL
    # Negative control: the block moves by more than half a pixel.
    assert np.ptp(blocks, axis=1).min() > 10


def check_arrows(arrows: dict, expected: dict, scale: dict) -> None:
    """Check the lengths of horizontal arrows by their scale arrow."""
    per_unit = length(scale["arrow"]) / scale["value"]
    assert arrows.keys() == expected.keys()
    for name, value in expected.items():
        assert length(arrows[name]) == pytest.approx(float(value) * per_unit, abs=2 * HALF_A_PIXEL), name


def test_every_body_is_painted_in_its_colour_with_a_density_that_grows_with_its_mass(bare, sample):
    """Compare pixels: a body's fill is a mixture of the background and its colour."""
    for theme in sample(["light", "dark"]):
        check_paint(Picture(bare(theme=theme)), theme)


def check_paint(picture: Picture, theme: str) -> None:
    paper = rgb(THEME[theme]["backgroundColor"])
    fill = {name: rgb(THEME[theme][f"{color}Color"]) for name, color in BODY_COLORS.items()}
    fullness: dict[str, list[float]] = {}
    # Hide the shading and the inlays, which are drawn over the body's colour.
    picture.page.evaluate(f"{STAGE}.querySelectorAll('.shade, .inlay').forEach((each) => each.remove())")
    for m, m_prime in ((0.5, 0.1), (4.0, 6.0)):
        picture.show(Oscillator(m, m_prime), 0.08)
        drawn = picture.at(0.25)
        painted = picture.painted()
        R = drawn["rollers"]["top"]["radius"]
        block, slab = drawn["block"], drawn["slab"]
        # Use points without letters, lines and marks. The hoop is painted only in its ring.
        spots = {name: (drawn["rollers"][name]["centre"], 0.7) for name in ("cylinder", "top")}
        spots["hoop"] = (drawn["rollers"]["hoop"]["centre"], 0.89)
        pixels = {name: (x - share * R, y) for name, ((x, y), share) in spots.items()}
        pixels["block"] = (block[2] - 10, block[1] + 20)
        pixels["slab"] = (slab[0] + 20, (slab[1] + slab[3]) / 2)
        for name, (x, y) in pixels.items():
            colour = painted[round(y), round(x)]
            way = np.array(fill[name]) - paper
            share = float((colour - paper) @ way / (way @ way))
            assert np.abs(paper + share * way - colour).max() < 4, name
            fullness.setdefault(name, []).append(share)
        hole = drawn["rollers"]["hoop"]["centre"]
        assert painted[round(hole[1] - 0.4 * R), round(hole[0] - 0.4 * R)] == pytest.approx(np.array(paper), abs=2)
    assert all(0.1 < light < heavy < 1 for light, heavy in fullness.values())


@pytest.mark.parametrize("engine", ["chromium"])
def test_bars_and_swatches_keep_their_colours(picture):
    """Check this also with forced colours."""
    for forced in ("none", "active"):
        picture.page.emulate_media(forced_colors=forced)
        painted = picture.find("""[...root.querySelectorAll(".bar i")].map((bar, i) => {
          const colour = (node, pseudo) => getComputedStyle(node, pseudo).backgroundColor;
          const entry = root.querySelectorAll(".legend li")[i];
          return [bar.dataset.body, colour(bar), colour(entry, "::before"), entry.textContent];
        })""")
        assert len(painted) == len(BODY_COLORS)
        for name, bar, swatch, label in painted:
            assert bar == swatch == "rgb({}, {}, {})".format(*rgb(THEME["light"][f"{BODY_COLORS[name]}Color"])), name
            assert name in label


@ANY_ENGINE
def test_in_step_is_shown_if_and_only_if_it_is_true(picture):
    """The stage lights up only for a separation of the hands below 0.01 turns in a million periods."""
    seen = {}
    for off in (0.0, -1e-9, 1e-7, 1e-3, -0.0024, 0.05, -0.2):
        # Ω/√(k/m) = 1 + off
        machine = Oscillator(2.0, 2.0 * mass_ratio_for((1 + off) ** 2), 30.0)
        picture.show(machine, 0.05)
        expected = "in-step" if abs(off) < 1e-8 else "nearly" if abs(off) < 1 / 400 else "apart"
        assert picture.find("root.querySelector('[data-step]').dataset.step") == expected
        lit = f"{STAGE}.querySelector('.face').getAnimations().every(each => each.playState === 'finished')"
        picture.page.wait_for_function(lit)
        seen[expected] = picture.find("getComputedStyle(root.querySelector('.face')).fill")
        sentence = picture.find("root.querySelector('.parting').textContent")
        arrow = picture.at(0.0)["drift"]
        drift = (arrow["tip"] - arrow["tail"] + 180) % 360 - 180
        assert difference(drift, 3 * 360 * off) < 0.1 * abs(3 * 360 * off) + 1e-5, "the arrow grows with the drift"
        assert (arrow["head"] > 1e-5) == (expected != "in-step"), "it vanishes only in step"
        if expected == "in-step":
            words = "the drift is less than 0.01 turns in a million periods" if off else "the hands never part"
            assert words in sentence
            continue
        verb = "gains" if off > 0 else "loses"
        periods = read(re.fullmatch(f"The machine {verb} one full turn in {NUMBER} periods.", sentence)[1])
        assert periods == pytest.approx(1 / abs(off), rel=0.05)
    assert seen["in-step"] != seen["apart"]


@ANY_ENGINE
def test_the_verdict_is_the_angle_between_the_hands(picture):
    def verdict(periods: float) -> str:
        picture.at(periods)
        return picture.find("root.querySelector('.verdict').textContent")

    for machine, sides in ((Oscillator(1.0, 0.1), "behind ahead"), (Oscillator(1.0, 9.0), "ahead behind")):
        picture.show(machine, 0.05)
        ratio = machine.natural_frequency / math.sqrt(machine.k / machine.m)
        assert verdict(0.0) == "Both hands start together."
        for periods in (-1.5, 0.6, 3.2):
            side = sides.split()[periods > 0]
            turns = abs(periods - periods / ratio)
            assert verdict(periods) == f"Now the machine is {turns:.2f} turns {side}."
        done = "gained" if ratio > 1 else "lost"
        assert verdict(2 / abs(1 - 1 / ratio)) == f"Now the hands meet. Full turns {done}: 2."


@ANY_ENGINE
def test_each_hand_goes_on_from_its_angle_when_the_machine_changes(picture):
    """Change the machine in 200 consecutive frames by sliders, and compare both hands with the core after each."""
    random, page = np.random.default_rng(SEED), picture.page
    values = {"m": 1.0, "m_prime": 1.0, "k": 10.0}
    picture.bare.sliders(**values, radius=10, compression=8)
    next_frame(page)
    next_frame(page)
    page.evaluate(script("turned_clock"))
    page.evaluate("setReducedMotion(false)")
    # With these values no machine is so fast that the stage slows it.
    limits = {"m": (0.5, 5.0), "m_prime": (0.05, 10.0), "k": (1.0, 20.0)}
    moves = [(key, round(random.uniform(*limits[key]), 2)) for key in random.choice(list(limits), 200)]
    angles = page.evaluate(TURN_HANDS, moves)
    expected = np.zeros(2)
    for (key, value), hands in zip(moves, angles, strict=True):
        values[key] = value
        machine = Oscillator(**values)
        expected += np.degrees([machine.natural_frequency * FRAME, math.sqrt(machine.k / machine.m) * FRAME])
        assert max(map(difference, hands, expected)) < ONE_DEGREE
    assert abs(np.subtract(*expected)) > 90, "the hands are apart"
    # A message of the server moves no hand either, unless it releases the machine.
    picture.find("root.querySelector('[data-do=play]').click()")
    data = stage.payload(Oscillator(**values), 0.08)
    for message, is_released in ((data, False), ({**data, "releases": 1}, True)):
        picture.bare.put(lambda message=message: stage.publish(message, name=picture.name))
        hands = page.evaluate("turn(1), " + HANDS)
        assert max(map(difference, hands, 0 * expected if is_released else expected)) < ONE_DEGREE
    picture.find("(root.querySelector('[data-do=play]').click(), turn(9), root.querySelector('.together').click())")
    picture.find("(root.querySelector('[data-do=play]').click(), turn(1))")
    assert page.evaluate(HANDS) == [0, 0]
    assert picture.find("root.querySelector('.verdict').textContent") == "Both hands start together."


def test_on_a_stage_with_graphs_both_machines_move_as_since_one_release(bare):
    moments = []
    for periods in (2, None):
        picture = Picture(bare(), "motion", periods=periods)
        picture.show(Oscillator(1.0, 1.0, 10.0), 0.08)
        picture.at(0.7)
        machine = Oscillator(1.0, 3.0, 20.0)
        picture.show(machine, 0.08)
        now = picture.page.evaluate("ramanujan.last('time/motion')")
        moments.append(now["time"] * math.sqrt(machine.k / machine.m) / math.tau == pytest.approx(now["periods"]))
    assert moments == [True, False]


@ANY_ENGINE
def test_nothing_below_the_stage_moves_for_any_machine(bare, sample):
    for options, width in sample(product(({}, {"dials": False}), (1280, 390))):
        picture = Picture(bare(width=width, height=844), **options)
        seen = set()
        for machine, compression in machines(1)[1:4]:
            picture.show(machine, compression)
            box = "root.querySelector('{}').getBoundingClientRect()"
            top, height = (picture.find(box.format(name)) for name in (".controls", ".stage"))
            seen.add((top["y"], height["height"]))
        assert len(seen) == 1, (options, width)


@ANY_ENGINE
def test_words_grow_with_the_screen(picture):
    words = [".ruler text", ".together", ".verdict", ".legend li", ".readouts dd", ".controls button"]
    sizes = f"""(words) => words.map((selector) => {{
      const node = {STAGE}.querySelector(selector), scale = node.getScreenCTM?.().a ?? 1;
      return parseFloat(getComputedStyle(node).fontSize) * scale;
    }})"""
    seen = []
    for width, height in ((390, 844), (1280, 720), (1920, 1080)):
        picture.page.set_viewport_size({"width": width, "height": height})
        next_frame(picture.page)
        next_frame(picture.page)
        seen.append(dict(zip(words, picture.page.evaluate(sizes, words), strict=True)))
    phone, laptop, projector = seen
    assert min(phone.values()) >= 11.4
    assert min(laptop.values()) >= 12
    assert min(projector.values()) >= 16.5
    assert max(projector.values()) <= 26


@ANY_ENGINE
def test_the_floor_is_as_wide_as_its_ruler_and_no_label_is_cut(picture):
    for R in (0.05, 0.1, 0.2):
        picture.show(Oscillator(radius=R), 0.08)
        picture.at(0.0)
        seen = picture.page.evaluate(f"""() => {{
          const box = (node) => {{ const {{ left, right }} = node.getBoundingClientRect(); return [left, right]; }};
          const find = (selector) => {STAGE}.querySelector(selector);
          const labels = [...{STAGE}.querySelectorAll(".ruler text")].filter((node) => !node.style.visibility);
          return {{ svg: box(find("svg.machine")), ground: box(find(".ground")), labels: labels.map(box) }};
        }}""")
        left, right = seen["svg"]
        assert seen["ground"][0] <= left
        assert seen["ground"][1] >= right
        assert len(seen["labels"]) >= 2
        assert all(left <= a and b <= right for a, b in seen["labels"])


@ANY_ENGINE
def test_no_letter_is_covered_by_an_arrow_or_another_letter(picture, sample):
    """Check all layers, and the forces alone, at several moments, for the smallest and the largest machine."""
    everything = "energy", "displacements", "arrows", "forces", "traces", "coordinates"
    boxes = f"""() => {{
      // WebKit gives a hidden line the box that it had before.
      const visible = (selector) => [...{STAGE}.querySelectorAll(selector)].filter((node) => node.checkVisibility());
      const named = (selector) => visible(selector).map((node) => {{
        const {{ left, top, right, bottom }} = node.getBoundingClientRect();
        return [node.textContent, [left, top, right, bottom]];
      }}).filter(([, [left, , right]]) => right > left);
      return {{
        letters: named(".moving text, .coordinates text, .scales text, .plain text"),
        heads: named(":is(.displacements, .arrows, .forces) .line, [data-mark=slab_value], [data-mark=x0_value]"),
        forces: named(".forces .line"),
        own_letters: named(".forces text:not([style*=hidden])").filter(([letter]) => letter),
      }};
    }}"""
    releases = [(0.05, 0.04), (0.05, 0.12), (0.1, 0.08), (0.2, 0.12)]
    for layers, (R, compression) in sample(product((everything, ("forces",)), releases)):
        picture.layers(*layers)
        picture.show(Oscillator(1.0, 0.8, 10.0, R), compression)
        for periods in (0.08, 0.6, 0.9):
            picture.at(periods)
            seen = picture.page.evaluate(boxes)
            for (a, first), (b, second) in combinations(seen["letters"], 2):
                assert not overlap(first, second, 0.35), (R, compression, periods, a, b)
            for letter, box in seen["letters"]:
                for _, head in seen["heads"]:
                    assert not overlap(box, head, 0.25), (R, compression, periods, letter)
            for (_, first), (_, second) in combinations(seen["forces"], 2):
                assert not overlap(first, second, 0), (R, compression, periods)
    picture.layers(*stage.LAYERS)
    letters = picture.page.evaluate(boxes)["letters"]
    assert not [(a, b) for (a, first), (b, second) in combinations(letters, 2) if overlap(first, second, 0.35)]
    check_lettered_forces(picture, boxes)


SLIDES = ((676, "27.6px"), (578, "27.6px"))
"""Widths of windows with pictures as wide as on slides of 1280 × 720 pixels, and the size of their words."""
SMALLEST_LETTER = """Math.min(...[...root.querySelectorAll(".forces text")].map((text) =>
  parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a))"""
"""The smallest size of a force's letters [px]."""


def check_lettered_forces(picture, boxes: str) -> None:
    """Check that the letters of forces with their indices are clear of all letters and of each other's arrows.

    At the release of an ordinary machine every force has letters. Those on a slide are large.
    """
    picture.layers("coordinates")
    machines = [*product((0.05, 0.1, 1.0, 5.0, 8.0), (0.05, 0.1, 0.2), [(1280, "")])]
    machines += product((0.1, 1.0, 5.0), [0.1], [(390, ""), (820, ""), *SLIDES])
    for m_prime, R, (width, text) in machines:
        picture.page.set_viewport_size({"width": width, "height": 720})
        picture.page.evaluate("(text) => document.body.style.setProperty('--stage-text', text)", text)
        # The small stages beside equations have no plain mass.
        picture.find(f"root.querySelector('.stage').classList.toggle('compact', {width} < 1000)")
        next_frame(picture.page)
        machine = Oscillator(1.0, m_prime, 10.0, R)
        picture.show(machine, 0.08)
        data = stage.payload(machine, 0.08, forces=("spring",))
        picture.bare.put(lambda data=data: stage.publish(data, name=picture.name))
        for periods in (0.0, 0.35, 0.6):
            picture.at(periods)
            seen = picture.page.evaluate(boxes)
            for (a, first), (b, second) in combinations(seen["letters"] + seen["own_letters"], 2):
                assert not overlap(first, second, 0.35), (m_prime, R, periods, a, b)
            for letter, box in seen["own_letters"]:
                assert not [name for name, arrow in seen["forces"] if overlap(box, arrow, 0.25)], (m_prime, R, letter)
            if periods == 0.0 and m_prime >= 0.1 and R >= 0.1:
                assert len(seen["own_letters"]) == 12, (m_prime, R)
            if text:
                assert picture.find(SMALLEST_LETTER) >= 23.9


def overlap(a: list[float], b: list[float], inset: float) -> bool:
    """Whether two boxes overlap, each reduced by a share of its height: a line is higher than its letters."""

    def inner(box: list[float]) -> list[float]:
        margin = inset * (box[3] - box[1])
        return [box[0] + 1, box[1] + margin, box[2] - 1, box[3] - margin]

    (l1, t1, r1, b1), (l2, t2, r2, b2) = inner(a), inner(b)
    return l1 < r2 and l2 < r1 and t1 < b2 and t2 < b1


@ANY_ENGINE
def test_the_buttons_need_no_symbol_font(picture):
    picture.find("root.querySelector('[popover]').showPopover()")
    buttons = picture.find("""[...root.querySelectorAll(".controls button:has(svg)")].map((button) => {
      const icons = [...button.querySelectorAll("svg")].filter((icon) => icon.checkVisibility());
      return [button.textContent.trim(), icons.length];
    })""")
    assert buttons == [["", 1]] * 4


@ANY_ENGINE
def test_a_slider_s_thumb_changes_its_parameter_by_its_value(picture, sample):
    """Move each slider by two steps, without a server."""
    page = picture.page
    values = {"m": 2.0, "m_prime": 0.7, "k": 30.0, "radius": 8.0, "compression": 6.0}
    picture.bare.sliders(**values)
    picture.show(Oscillator(2.0, 0.7, 30.0, 0.08), 0.06)
    for key, before in sample(values.items()):
        thumb = f"document.querySelector('.st-key-{key} input')"
        page.evaluate(f"{thumb}.focus()")
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowRight")
        next_frame(page)
        values[key] = float(page.evaluate(f"{thumb}.value"))
        assert values[key] > before
        m, m_prime, k, R, x0 = values.values()
        picture.machine = Oscillator(m, m_prime, k, R / 100)
        picture.initial = released(picture.machine, x0 / 100)
        drawn, half = picture.at(0.0), picture.at(0.5)
        compressed, stretched = (each["slab"][2] - each["block"][0] for each in (drawn, half))
        assert compressed - stretched == pytest.approx(2 * x0 / 100 * picture.pixels, abs=2 * HALF_A_PIXEL), key
        check_bodies(picture, half, homes(picture, half))
        omega = picture.find("root.querySelector('[data-read=omega]').textContent")
        assert float(omega.split()[0]) == pytest.approx(picture.machine.natural_frequency, rel=1e-4), key


@ANY_ENGINE
def test_the_speed_menu_changes_the_speed(picture):
    """Divide the change of the phase by the time of the frames, at each speed."""
    picture.show(Oscillator(), 0.08)
    picture.page.evaluate("setReducedMotion(false)")
    rate = """() => new Promise((done) => {
      let last = null, elapsed = 0, from = 0;
      const look = (now) => {
        const { phase } = ramanujan.last("time/oscillator");
        // The page does not catch up: a late frame counts as at most a tenth of a second.
        if (last === null) from = phase;
        else elapsed += Math.min((now - last) / 1000, 0.1);
        last = now;
        if (elapsed > 0.4) done((phase - from) / elapsed);
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    })"""
    choose = """(name) => {
      const menu = root.querySelector(".speeds select");
      menu.value = [...menu.options].find((each) => each.text === name).value;
      menu.dispatchEvent(new Event("change"));
    }"""
    for name, speed in (("½×", 0.5), ("⅒×", 0.1), ("1×", 1)):
        picture.find(f"({choose})('{name}')")
        next_frame(picture.page)
        expected = speed * picture.machine.natural_frequency
        assert picture.page.evaluate(rate) == pytest.approx(expected, rel=0.15), name
