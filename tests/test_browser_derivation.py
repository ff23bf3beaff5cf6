"""Page 2 in a browser: keys, links, files, colours, and formulas that stay inside a phone."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from ramanujan.derivation import ROUTES
from tests.browser import settle
from tests.test_browser_access import switch
from tests.test_look import THEME, rgb

STEP = ".st-key-lecture h2:visible"
MORE = ".st-key-more button"
"""What opens the choices that are folded."""


def step(page) -> str:
    return page.locator(STEP).inner_text().split(".")[0]


def bottom(place) -> float:
    box = place.bounding_box()
    return box["y"] + box["height"]


def press(page, key: str) -> str:
    page.keyboard.press(key)
    page.wait_for_timeout(400)  # after a turn the page waits 300 ms before it tells the server
    settle(page)
    return step(page)


def test_arrow_keys_turn_the_steps_and_the_link_keeps_the_place(visit):
    page = visit("derivation?route=hamilton&step=4")
    assert step(page) == "4"
    assert press(page, "ArrowRight") == "5"
    assert "step=5" in page.url
    assert press(page, "ArrowLeft") == "4"
    # A click on a choice does not keep the keys: the lecturer goes straight on.
    page.locator(".st-key-route button", has_text="Newton").click()
    settle(page)
    assert step(page) == "1"
    assert press(page, "ArrowRight") == "2"
    page.locator(MORE).click()
    for view in (1, 0):
        page.locator(".st-key-show button").nth(view).click()
        settle(page)
    assert press(page, "ArrowRight") == "3"
    # Where the arrows have another meaning they keep it.
    page.locator(".st-key-m input[type=range]").focus()
    assert press(page, "ArrowRight") == "3"
    assert "m=1.01" in page.url
    page.get_by_label("Your formula").fill("k")
    assert press(page, "ArrowLeft") == "3"
    assert "route=newton" in page.url
    # A choice is made by keys alone.
    if not page.locator(".st-key-values").is_visible():
        page.locator(MORE).click()
    page.locator(".st-key-values button").first.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Space")
    page.wait_for_url("**values=numbers**")
    assert page.evaluate("document.activeElement.getAttribute('role')") == "radio"


def test_the_back_button_takes_a_choice_back_and_keeps_the_sliders(visit):
    page = visit("derivation?m=2")
    for place, route in ((1, "hamilton"), (2, "newton")):
        page.locator(".st-key-route button").nth(place).click()
        page.wait_for_url(f"**route={route}**")
        settle(page)
    page.go_back()
    page.wait_for_url("**route=hamilton**")
    settle(page)
    assert page.locator(".st-key-route button[aria-checked=true]").inner_text() == "Hamilton"
    page.go_back()
    settle(page)
    assert "route" not in page.url
    assert page.locator(".st-key-route button").first.get_attribute("aria-checked") == "true"
    assert "m=2" in page.url
    assert page.locator(".st-key-m input[type=range]").input_value() == "2"


def test_long_formulas_scroll_in_their_own_box_on_a_phone(visit):
    page = visit("derivation?route=matrix&show=reading&body=hoop", width=390, height=844)
    page.wait_for_selector(".st-key-question")
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


def test_a_chosen_body_has_the_same_ink_in_the_formula_as_in_the_theme(visit):
    page = visit("derivation?step=2&body=hoop")
    page.locator(STEP).wait_for()
    for theme in ("light", "dark"):
        switch(page, theme)
        settle(page)
        inks = page.evaluate("""() => [...document.querySelectorAll('.st-key-lecture .katex-html [style*="color"]')]
            .map(part => getComputedStyle(part).color)""")
        wanted = "rgb({}, {}, {})".format(*rgb(THEME[theme]["orangeTextColor"]))
        assert wanted in inks
        # Whatever is coloured has that ink, or none of its own.
        assert len(set(inks) - {wanted}) <= 1


def test_three_machines_run_side_by_side(visit):
    page = visit("derivation", motion="no-preference")
    # The view follows the centre of mass: where the whole machine glides, it is the floor that passes by.
    for key, part in (("swing", ".moving .slab"), ("glide", ".ruler"), ("roll", ".moving .top")):
        moving = f"""document.querySelector('.st-key-mode_{key} [data-testid=stBidiComponentIsolated]')
          ?.shadowRoot.querySelector('{part}')?.getAttribute('transform')"""
        page.wait_for_function(moving)
        page.wait_for_function(f"(before) => {moving} !== before", arg=page.evaluate(moving))


def test_the_route_as_it_stands_can_be_taken_home(visit):
    page = visit("derivation?route=energy&values=numbers")
    assert press(page, "ArrowRight") == "2"
    seen = page.locator(STEP).inner_text().partition(". ")[2].partition("’")[0]
    page.locator(".st-key-files button").first.click()
    settle(page)
    suffixes = {"latex": "tex", "slides": "slides.tex", "step": "step.tex", "markdown": "md", "notebook": "ipynb"}
    for kind, suffix in suffixes.items():
        page.wait_for_selector(f".st-key-file_{kind} button")
        sent = len(page.frames_sent)
        with page.expect_download() as download:
            page.locator(f".st-key-file_{kind} button").click()
        assert download.value.suggested_filename == f"ramanujan-energy-numbers.{suffix}"
        text = Path(download.value.path()).read_text(encoding="utf-8")
        assert seen in text
        assert (ROUTES["energy"]["spring_mass"].heading in text) == (kind != "step")
        assert ("tikzpicture" in text) == (kind in ("slides", "step"))
        if kind == "notebook":
            assert json.loads(text)["nbformat"] == 4
        settle(page)
        assert len(page.frames_sent) == sent, kind
    another = visit("derivation?route=newton")
    for _ in range(3):
        press(another, "ArrowRight")
        another.locator(".st-key-files button").first.click()
        settle(another)
    assert page.request.get(download.value.url).ok, "a slow browser would have lost it in a class"


def test_a_student_is_told_what_is_missing_and_hostile_text_stays_text(visit):
    page = visit("derivation")
    box = page.get_by_label("Your formula")
    for text, told in (
        ("m X'^2", "leave out the ½"),
        ("½ m X'²", "Right!"),
        ("<img src=x onerror=alert(1)>", "Type only the right side of the equation"),
        (":red[x]", "colon"),
    ):
        box.fill(text)
        page.keyboard.press("Enter")
        settle(page)
        assert told in page.locator("[data-testid=stAlert]").inner_text()
    assert page.locator("[data-testid=stAlert] img").count() == 0
    # A right answer is listed, and the question stays.
    page = visit("derivation?question=potential_energy")
    page.get_by_label("Your formula").fill("2kR²φ²")
    page.keyboard.press("Enter")
    page.get_by_text("Solved so far: 1 of").wait_for()
    for left in (3, 2, 1):
        page.get_by_role("button", name=f"Hint ({left} left)").click()
    page.get_by_role("button", name="Show me this step").wait_for()


BEFORE_THE_FIRST_EQUATION = """() => {
  const top = [...document.querySelectorAll('.st-key-lecture .katex-display')].find((each) => each.checkVisibility())
    .getBoundingClientRect().top;
  const found = [];
  const look = (root) => [...root.querySelectorAll('*')].forEach((node) => {
    if (node.shadowRoot) look(node.shadowRoot);
    const { width, height, top: y } = node.getBoundingClientRect();
    const seen = node.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && width > 1 && height > 1;
    if (seen && y < top && node.matches('button, input, select, summary')) found.push(node.ariaLabel ?? node.innerText);
  });
  look(document.querySelector('[data-testid=stMain]'));
  return found;
}"""
ALONE = """() => [...document.querySelectorAll('[data-testid=stMain] .katex')].filter((formula) => {
  const after = formula.nextSibling;
  if (after?.nodeType !== Node.TEXT_NODE || !/^[.,;:!?]/.test(after.data) || !formula.checkVisibility()) return false;
  const sign = document.createRange();
  sign.setStart(after, 0);
  sign.setEnd(after, 1);
  const last = [...formula.querySelectorAll('.base')].at(-1).getBoundingClientRect();
  return sign.getBoundingClientRect().top >= last.bottom - 4;
}).map((formula) => formula.textContent)"""
"""Formulas whose full stop or comma has gone to the next line."""


@pytest.mark.parametrize("view", ["", "&view=projector"])
def test_headings_stay_where_they_are_and_few_controls_come_before_the_first_equation(visit, view):
    page = visit(f"derivation?route=newton&body=hoop{view}")
    page.locator(STEP).wait_for()
    assert len(page.evaluate(BEFORE_THE_FIRST_EQUATION)) <= (11 if not view else 19)
    places = set()
    for number in range(1, len(ROUTES["newton"].steps) + 1):
        assert step(page) == str(number)
        places.add(page.locator(STEP).bounding_box()["y"])
        assert bottom(page.locator(".st-key-lecture .katex-display:visible").first) <= 720
        if view:
            # The machine and the choice of a body are seen beside the step.
            beside = page.locator(".st-key-beside").bounding_box(), page.locator(".st-key-body").bounding_box()
            assert all(box["x"] >= 800 and box["y"] > 0 and box["y"] + box["height"] <= 720 for box in beside)
        page.keyboard.press("ArrowRight")
    assert len(places) == 1
    if not view:
        alone = []
        for width in range(800, 1300, 20):
            page.set_viewport_size({"width": width, "height": 720})
            alone += page.evaluate(ALONE)
        assert alone == []


def test_the_first_page_leads_here(visit):
    page = visit()
    page.get_by_role("link", name="The whole derivation").click()
    page.locator(STEP).wait_for()
    settle(page)
    assert "/derivation" in page.url
    assert page.get_by_role("heading", name="Five ways to one frequency").is_visible()


def test_steps_of_many_equations_fit_on_a_screen(visit):
    """Those of Newton's route are looked at where their headings are."""
    page = visit("derivation?step=9")
    formula = page.locator(".st-key-lecture .katex-display:visible").first
    for number in range(9, 18):
        assert step(page) == str(number)
        assert bottom(formula) <= 720
        page.keyboard.press("ArrowRight")
    page.locator(".st-key-route button", has_text="Energy").click()
    page.wait_for_url("**route=energy**")
    settle(page)
    assert step(page) == "1"
    assert bottom(formula) <= 720
