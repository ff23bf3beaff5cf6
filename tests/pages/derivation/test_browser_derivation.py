"""Page 2 in a browser: keys, links, files, colours, and formulas on a phone."""

import json
import re
from pathlib import Path

from playwright.sync_api import expect

from ramanujan.derivation import ROUTES
from ramanujan.shell.theme import BODY_COLORS
from tests.checks.bare import THEME
from tests.checks.browser import script, settle, traffic, until
from tests.checks.look import RING, rgb, switch

STEP = ".st-key-lecture h2:visible"
MORE = ".st-key-more button"
"""The expander that contains the choices."""


def step(page) -> int:
    return int(page.locator(STEP).inner_text().split(".")[0])


def choose(page, title: str) -> None:
    """Choose a route."""
    page.locator(".st-key-route button").click()
    page.get_by_role("option", name=title).click()


def bottom(place) -> float:
    box = place.bounding_box()
    return box["y"] + box["height"]


def press(page, key: str) -> int:
    page.keyboard.press(key)
    settle(page)
    return step(page)


def test_a_lecturer_turns_steps_and_chooses_by_keys_and_clickers(visit):
    page = visit("derivation?m=2")
    check_back_and_arrows(page)
    check_clickers(visit("derivation?step=9", tab=page))


def check_back_and_arrows(page) -> None:
    """Check that Back undoes a choice, arrow keys turn the steps, and a choice can be made by keys."""
    for route in ("hamilton", "newton"):
        choose(page, route.capitalize())
        page.wait_for_url(f"**route={route}**")
        settle(page)
    page.go_back()
    page.wait_for_url("**route=hamilton**")
    settle(page)
    assert page.get_by_label("Route").input_value() == "Hamilton"
    page.go_back()
    settle(page)
    assert "route" not in page.url
    assert page.get_by_label("Route").input_value() == "Euler–Lagrange"
    assert page.locator(".st-key-m input[type=range]").input_value() == "2"
    # A click on a choice does not keep the focus, so the arrow keys turn steps again.
    choose(page, "Newton")
    settle(page)
    assert step(page) == 1
    assert press(page, "ArrowRight") == 2
    page.wait_for_url("**step=2**")
    page.locator(MORE).click()
    for view in (1, 0):
        page.locator(".st-key-show button").nth(view).click()
        settle(page)
    assert press(page, "ArrowRight") == 3
    # In other controls the arrow keys keep their own meaning.
    page.locator(".st-key-m input[type=range]").focus()
    assert press(page, "ArrowRight") == 3
    assert "m=2.01" in page.url
    assert "route=newton" in page.url
    # A choice can be made by keys.
    if not page.locator(".st-key-values").is_visible():
        page.locator(MORE).click()
    page.locator(".st-key-values button").first.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Space")
    page.wait_for_url("**values=numbers**")
    assert page.evaluate("document.activeElement.getAttribute('role')") == "radio"


def check_clickers(page) -> None:
    """Check that clickers and the space bar turn steps, that typing does not, and that the step is announced."""
    status = page.locator(".st-key-unseen-services [role=status]")
    assert "Step 10 of " not in status.text_content()
    page.get_by_role("button", name="Next").click()
    heading = page.locator(STEP).inner_text().split(". ", 1)[1]
    expect(status).to_contain_text(re.compile(rf"^Step 10 of .*{re.escape(heading)}$"))
    assert page.get_by_role("slider", name="Step").get_attribute("aria-valuetext").startswith("Step 10 of ")
    page.evaluate("document.activeElement.blur()")
    for key, expected in (("PageDown", 11), ("Space", 12), ("PageUp", 11), ("Shift+Space", 10), ("ArrowLeft", 9)):
        page.keyboard.press(key)
        assert step(page) == expected, key
    # In a box, a key types text. This page contains none.
    page.evaluate("document.querySelector('.st-key-questions').append(document.createElement('input'))")
    answer = page.locator(".st-key-questions input")
    answer.fill("k")
    for key in ("ArrowRight", "Space", "PageDown", "ArrowLeft"):
        page.keyboard.press(key)
    assert step(page) == 9
    assert answer.input_value() == "k "
    # A focused button uses the space bar itself, and turns one step.
    page.get_by_role("button", name="Next").focus()
    page.keyboard.press("Space")
    assert step(page) == 10
    # While the lecture is not in view, these keys scroll the page as usual.
    page.evaluate("document.activeElement.blur()")
    answer.scroll_into_view_if_needed()
    page.keyboard.press("PageUp")
    assert step(page) == 10


def test_three_machines_run_and_a_formula_is_judged_and_hostile_text_stays_text(visit):
    page = visit("derivation?step=3", motion="no-preference")
    check_three_machines(page)
    page.emulate_media(reduced_motion="reduce")
    # An open question is alone on the page: the steps and results contain its answer.
    page.get_by_role("button", name="The potential energy").click()
    settle(page)
    page = visit(page.url.rpartition("/")[2], within=page)
    assert page.locator("h1").inner_text() == "The potential energy"
    assert page.locator(".katex-display").count() == 0
    box = page.get_by_label("Your formula")
    for text, verdict in (
        ("4kR²φ²", "leave out the ½"),
        ("<img src=x onerror=alert(1)>", "Type only the right side of the equation"),
        (":red[x]", "“red” is not known here"),
        ("2kR²φ²", "Right!"),
    ):
        box.fill(text)
        assert not page.get_by_test_id("InputInstructions").is_visible()
        page.keyboard.press("Enter")
        settle(page)
        assert verdict in page.locator("[data-testid=stAlert]").inner_text()
        assert page.locator("[data-testid=stAlert] img").count() == 0
    # A right answer needs no hint, and is counted.
    assert page.get_by_role("button", name="Hint").count() == 0
    page.get_by_role("button", name="Next: The Lagrangian").wait_for()
    page.get_by_role("button", name="Back to the derivation").click()
    page.get_by_text("Solved so far: 1 of").wait_for()
    assert step(page) == 3


def check_three_machines(page) -> None:
    """Check that three machines run side by side, each in its mode."""
    # The view follows the centre of mass, so when the whole machine glides, the floor moves in the picture.
    for key, part in (("swing", ".moving .slab"), ("glide", ".ruler"), ("roll", ".moving .top")):
        moving = f"""document.querySelector('.st-key-mode_{key} [data-testid=stBidiComponentIsolated]')
          ?.shadowRoot.querySelector('{part}')?.getAttribute('transform')"""
        page.wait_for_function(moving)
        page.wait_for_function(f"(before) => {moving} !== before", arg=page.evaluate(moving))


def test_the_present_route_can_be_downloaded_and_its_formulas_fit_a_phone(visit):
    page = visit("derivation?route=energy&values=numbers")
    assert press(page, "ArrowRight") == 2
    heading = page.locator(STEP).inner_text().partition(". ")[2].partition("’")[0]
    page.locator(".st-key-files button").first.click()
    settle(page)
    suffixes = {"latex": "tex", "notebook": "ipynb"}
    for kind, suffix in suffixes.items():
        page.wait_for_selector(f".st-key-file_{kind} button")
        sent = len(traffic(page).sent)
        with page.expect_download() as download:
            page.locator(f".st-key-file_{kind} button").click()
        assert download.value.suggested_filename == f"ramanujan-energy-numbers.{suffix}"
        text = Path(download.value.path()).read_text(encoding="utf-8")
        assert heading in text
        assert ROUTES["energy"]["spring_mass"].heading in text
        if kind == "notebook":
            assert json.loads(text)["nbformat"] == 4
        settle(page)
        assert len(traffic(page).sent) == sent, kind
    check_scrolling(page)
    check_long_formulas(visit("derivation?route=matrix&show=reading", width=320, height=640, within=page))


def check_scrolling(page) -> None:
    """Check that a key scrolls a formula on a narrow screen without turning a step, and shows its focus."""
    page.set_viewport_size({"width": 200, "height": 844})
    box, before = page.locator(".katex-display[data-scrolls]:visible").first, step(page)
    box.wait_for()
    settle(page)
    assert box.evaluate(RING)[0] == 3
    box.press("ArrowRight")
    page.wait_for_function("(box) => box.scrollLeft > 0", arg=box.element_handle())
    assert step(page) == before


def check_long_formulas(page) -> None:
    """Check that long formulas scroll in their own box on a phone."""
    page.wait_for_selector(".st-key-questions")
    page.evaluate("document.fonts.ready")
    settle(page)
    boxes = page.evaluate("""() => [...document.querySelectorAll('.katex-display')].map(box =>
        [box.getBoundingClientRect().right <= innerWidth, box.scrollWidth > box.clientWidth,
         getComputedStyle(box).overflowX, box.scrollHeight <= box.clientHeight + 1])""")
    assert all(inside and overflow == "auto" and whole for inside, _, overflow, whole in boxes)
    assert any(long for _, long, *_ in boxes)
    main = page.locator("[data-testid=stMain]")
    assert main.evaluate("main => main.scrollWidth <= main.clientWidth")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


BEFORE_THE_FIRST_EQUATION = script("before_equation")
ALONE = script("separated_punctuation")
"""Formulas whose punctuation mark is on the next line."""


BESIDE = "document.querySelector('.st-key-beside [data-testid=stBidiComponentIsolated]').shadowRoot"
CUT_OFF = """() => [...document.querySelectorAll('.st-key-lecture .katex-display')].flatMap((box) =>
  [...box.querySelectorAll('.sizing.reset-size6.size4')].map((part) => part.getBoundingClientRect())
    .filter(({ right }) => right > box.getBoundingClientRect().right + 1))"""
"""Parts of operations that are outside of the box and need scrolling."""
INKS = """[...new Set([...document.querySelectorAll('.st-key-lecture .katex-html [style*="color"]')]
  .map((part) => part.style.color).filter(Boolean))].sort()"""


def walk(page, route: str) -> None:
    """Page through all steps of a route, and check each: the place of its heading, and all of its equations in view.

    The machine is beside the step, and covers no formula. The result of all routes is shown at the first step.
    """
    places = set()
    for number in range(1, len(ROUTES[route].steps) + 1):
        assert step(page) == number
        places.add(page.locator(STEP).bounding_box()["y"])
        first, machine = page.locator(".st-key-lecture .katex-display:visible").first, page.locator(".st-key-beside")
        formula, picture = first.bounding_box(), machine.bounding_box()
        assert bottom(first) <= 722
        assert bottom(page.locator(".st-key-lecture .katex-display:visible").last) <= 720
        assert page.locator(".st-key-goal").is_visible() == (number == 1)
        assert picture["width"] >= 400
        assert picture["x"] > page.locator(STEP).bounding_box()["x"] + 400
        is_beside = formula["x"] + formula["width"] <= picture["x"]
        assert is_beside or formula["y"] >= picture["y"] + picture["height"] - 1
        assert is_beside or route != "euler_lagrange"
        assert page.evaluate(CUT_OFF) == []
        if number < len(ROUTES[route].steps):
            page.keyboard.press("ArrowRight")
    assert len(places) == 1


def test_headings_keep_their_place_beside_the_machine_and_every_body_has_its_ink(visit):
    page = visit("derivation?route=newton")
    page.locator(STEP).wait_for()
    assert len(page.evaluate(BEFORE_THE_FIRST_EQUATION)) <= 12
    walk(page, "newton")
    check_symbols_and_forces(page)
    choose(page, "Matrix")
    page.wait_for_url("**route=matrix**")
    settle(page)
    walk(page, "matrix")
    choose(page, "Euler–Lagrange")
    page.wait_for_function("!location.search.includes('route=')")
    settle(page)
    walk(page, "euler_lagrange")
    for theme in ("dark", "light"):
        switch(page, theme)
        settle(page)
        names = [*(f"{body}Text" for body in BODY_COLORS.values()), "primary"]
        wanted = {"rgb({}, {}, {})".format(*rgb(THEME[theme][f"{name}Color"])) for name in names}
        page.wait_for_function(f"(wanted) => {INKS}.join() === wanted", arg=",".join(sorted(wanted)))
    # The pointer on a term highlights its body and the body's arrow. On a body it highlights the terms.
    for _turn in range(10):
        page.keyboard.press("ArrowLeft")
    page.locator(".st-key-step-4 .katex-html [style*=color]", has_text="m").first.hover()
    assert page.evaluate(f"{BESIDE}.querySelectorAll('.moving > .block.lit, [data-mark=X_sense].lit').length") == 2
    page.locator(".st-key-beside .moving > .body.slab").focus()
    green = "rgb({}, {}, {})".format(*rgb(THEME["light"]["greenTextColor"]))
    glows = """() => [...document.querySelectorAll('.st-key-step-4 .katex-html [style*="color"]')]
        .filter((term) => getComputedStyle(term).textShadow !== "none").map((term) => term.style.color)"""
    assert set(page.evaluate(glows)) == {green}
    broken = []
    for width in range(800, 1300, 90):
        page.set_viewport_size({"width": width, "height": 720})
        broken += page.evaluate(ALONE)
    assert broken == []
    page.get_by_role("slider", name="Step").fill("14")
    page.get_by_role("button", name="Next").click()
    page.wait_for_url("**/1729*")
    check_projector(visit("derivation?route=newton&view=projector", within=page))


def check_symbols_and_forces(page) -> None:
    """Check that the symbol of a force highlights both of its arrows, and each arrow the symbol.

    A step with forces pauses the machine at its release. The next step without forces plays it again.
    """
    settle(page)  # until the server knows the step
    page.emulate_media(reduced_motion="no-preference")
    playback = page.locator(".st-key-beside [data-do=play]")
    expect(playback).to_have_accessible_name("Pause")
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(f"{BESIDE}.querySelectorAll('.forces [data-line] text').length === 12")
    expect(playback).to_have_accessible_name("Play")
    place = f"(name) => {BESIDE}.querySelector('.moving ' + name).transform.baseVal[0].matrix.e"
    until(page, f"() => ['.slab', '.block'].map({place}).reduce((slab, block) => slab - block) > 7.99")  # x₀ is 8 cm
    page.locator(".st-key-step-8 .katex-html:visible .mathnormal", has_text="F").nth(2).hover()
    lit = f"[...{BESIDE}.querySelectorAll('.forces .lit')].map((force) => force.dataset.line)"
    assert page.evaluate(lit) == ["top_block top", "top_block block"]
    page.locator(".st-key-beside [data-line='hoop_slab slab'] .line").hover()
    assert page.evaluate(lit) == ["hoop_slab hoop", "hoop_slab slab"]
    symbols = page.locator(".st-key-step-8 [data-lit]")
    assert {text.replace("\u200b", "") for text in symbols.all_text_contents()} == {"Shoop"}
    # A step without friction forces shows none.
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(f"getComputedStyle({BESIDE}.querySelector('.forces')).display === 'none'")
    expect(playback).to_have_accessible_name("Pause")
    page.emulate_media(reduced_motion="reduce")


def check_projector(page) -> None:
    """Check that on a projector the machine is visible beside a step. test_browser_view checks the slides."""
    page.locator(STEP).wait_for()
    assert len(page.evaluate(BEFORE_THE_FIRST_EQUATION)) <= 13

    def beside() -> None:
        box = page.locator(".st-key-beside").bounding_box()
        assert 0 < box["y"] <= 720 - box["height"]

    for _step in range(3):
        beside()
        page.keyboard.press("ArrowRight")
    beside()


ON_A_PHONE = """() => [...document.querySelectorAll('.katex-display')].filter((box) => box.offsetParent).map((box) => {
  const operations = [...box.querySelectorAll('.sizing.reset-size6.size4')];
  const signs = [...box.querySelectorAll('.mrel')].filter((sign) => !sign.closest('.sizing'));
  const height = (part) => { const { top, bottom } = part.getBoundingClientRect(); return (top + bottom) / 2; };
  return {
    letters: parseFloat(getComputedStyle(box.querySelector('.katex')).fontSize),
    operations: operations.length,
    behind: operations.filter((part) => signs.some((sign) => Math.abs(height(sign) - height(part)) < 8)).length,
    marked: box.scrollWidth <= box.clientWidth + 1 || 'scrolls' in box.dataset,
  };
})"""
"""For each formula: size of its letters, its operations, those after an equals sign, and whether it scrolls."""


def test_on_a_phone_formulas_are_large_and_operations_are_below_their_lines(visit):
    page = visit("derivation?route=energy&show=reading", width=390, height=844, figures=False)
    check_formulas_on_a_phone(page, 15)
    page = visit("", width=390, height=844, within=page)
    page.locator(".st-key-summary_4 summary").click()
    check_formulas_on_a_phone(page, 16)


def check_formulas_on_a_phone(page, letters: float) -> None:
    """Check the size of the letters on a phone, and that operations are beside their lines only on a tablet."""
    page.locator(".katex-display:visible").first.wait_for()
    settle(page)
    boxes = page.evaluate(ON_A_PHONE)
    assert min(box["letters"] for box in boxes) >= letters
    assert all(box["marked"] for box in boxes)
    assert sum(box["operations"] for box in boxes) > 1
    assert sum(box["behind"] for box in boxes) == 0
    page.set_viewport_size({"width": 820, "height": 1180})
    settle(page)
    assert any(box["behind"] for box in page.evaluate(ON_A_PHONE))
