"""The app in forced colours, a system's contrast theme: controls are visible in each state, and formulas legible.

The tests compare pixels. The system's colours replace those of the style sheets; backgrounds and shadows are not drawn.
"""

import io

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Locator, Page, expect

from ramanujan.shell.menu import PAGES
from tests.checks.browser import script, settle
from tests.checks.layout import OPEN

MARGIN = 7
"""Margin of a control [px]; it contains the ring of the focus."""
CONTROLS = script("controls")
BOX = """(i) => {
  const box = controls[i].shape.getBoundingClientRect();
  return { x: box.x, y: box.y, width: box.width, height: box.height };
}"""
SHOW = """(i) => {
  const { node, shape } = controls[i];
  shape.scrollIntoView({ block: "center" });
  node.blur();
}"""
FOCUS = "(i) => controls[i].node.focus({ focusVisible: true, preventScroll: true })"
CALM_PAGE = """[data-testid=stSliderThumbValue] { visibility: hidden }
*, ::before, ::after { transition: none !important; animation: none !important; caret-color: transparent !important }"""
"""Rules that hide the number beside a slider's thumb, so that it does not count as the control, and stop animations."""
AS_IT_IS = {"caret": "initial"}
"""Option of a screenshot without a style sheet that hides the caret: it would restyle the whole page twice."""


def painted(page: Page, control: int) -> np.ndarray:
    """Return the pixels of a control and of its margin."""
    box = page.evaluate(BOX, control)
    clip = {
        "x": max(round(box["x"]) - MARGIN, 0),
        "y": max(round(box["y"]) - MARGIN, 0),
        "width": round(box["width"]) + 2 * MARGIN,
        "height": round(box["height"]) + 2 * MARGIN,
    }
    picture = Image.open(io.BytesIO(page.screenshot(clip=clip, **AS_IT_IS))).convert("RGB")
    return np.asarray(picture, dtype=int)


def pixels(place: Locator) -> np.ndarray:
    """Return the pixels of an element."""
    return np.asarray(Image.open(io.BytesIO(place.screenshot(**AS_IT_IS))).convert("RGB"), dtype=int)


def differ(first: np.ndarray, second: np.ndarray) -> bool:
    """Whether two pictures differ visibly: in more than a few pixels, and by a large amount."""
    if abs(first.shape[0] - second.shape[0]) > 2 or abs(first.shape[1] - second.shape[1]) > 2:
        return True
    height, width = (min(sizes) for sizes in zip(first.shape[:2], second.shape[:2], strict=True))
    difference = np.abs(first[:height, :width] - second[:height, :width]).max(axis=2)
    return bool((difference > 60).sum() > 12)


def is_seen(picture: np.ndarray) -> bool:
    """Whether the control is visible: its pixels differ from the margin."""
    paper = np.median(picture[0], axis=0)
    inside = picture[MARGIN:-MARGIN, MARGIN:-MARGIN]
    return bool((np.abs(inside - paper).max(axis=2) > 60).sum() > 12)


def has_outline(picture: np.ndarray) -> bool:
    """Whether the left edge of a control differs from the pixels beside it."""
    middle = picture[picture.shape[0] // 2]
    return bool((np.abs(middle[MARGIN - 1 : MARGIN + 3] - middle[MARGIN - 4]).max(axis=1) > 6).any())


def check_controls(page: Page, skipped: str, checked: set[str]) -> int:
    """Check that a control of each kind is visible, has its usual outline, and shows the focus.

    Skip the kinds in `checked`, and add the others to it. Return the number of controls.
    """
    controls, outlined, wrong = page.evaluate(CONTROLS, skipped), set(), []
    enabled = [i for i, control in enumerate(controls) if not control["isDisabled"]]
    firsts = {controls[i]["kind"]: i for i in reversed(enabled)}
    first_of_kind = [i for kind, i in firsts.items() if kind not in checked]
    checked.update(firsts)
    page.emulate_media(forced_colors="none")
    for i in first_of_kind:
        if controls[i]["tag"] == "button":
            page.evaluate(SHOW, i)
            if has_outline(painted(page, i)):
                outlined.add(i)
    page.emulate_media(forced_colors="active")
    for i in first_of_kind:
        page.evaluate(SHOW, i)
        picture = painted(page, i)
        if not is_seen(picture):
            wrong.append(("is invisible", controls[i]))
        if i in outlined and not has_outline(picture):
            wrong.append(("has lost its outline", controls[i]))
        if controls[i]["tag"] != "span":
            page.evaluate(FOCUS, i)
            if not differ(picture, painted(page, i)):
                wrong.append(("does not show the focus", controls[i]))
    assert wrong == []
    return len(controls)


def check_states(page: Page, skipped: str, checked: set[str]) -> set[str]:
    """Check that all states of a control look different, for a control of each kind. Return its types.

    Skip the kinds in `checked`, and add the others to it.
    """
    types, kinds = set(), {control["kind"] for control in page.evaluate(CONTROLS, skipped)} - checked
    checked |= kinds
    for kind in sorted(kinds):  # the options of a graph come before the tabs that hide them
        controls = page.evaluate(CONTROLS, skipped)
        of_kind = [i for i, each in enumerate(controls) if each["kind"] == kind and not each["isDisabled"]]
        states = ("checkbox", "switch", "range", "radio", "tab")
        i = next((i for i in of_kind if controls[i]["type"] in states and not is_on(page, i)), None)
        if i is None:
            continue
        page.evaluate(SHOW, i)
        pictures = both(page, i)
        turn_on(page, i, controls[i]["type"])
        # Streamlit may have drawn the control again, at another place of the list.
        name = (kind, controls[i]["words"])
        i = next(
            (j for j, each in enumerate(page.evaluate(CONTROLS, skipped)) if name == (each["kind"], each["words"])), i
        )
        if not is_on(page, i):  # such as a preset, which has no state
            continue
        types.add(controls[i]["type"])
        pictures += both(page, i)
        alike = [(a, b) for a in range(4) for b in range(a) if not differ(pictures[a], pictures[b])]
        assert alike == [], controls[i]
    return types


def both(page: Page, control: int) -> list[np.ndarray]:
    """Return the pixels of a control without the focus and with it."""
    page.evaluate("(i) => controls[i].node.blur()", control)
    pictures = [painted(page, control)]
    page.evaluate(FOCUS, control)
    return [*pictures, painted(page, control)]


def is_on(page: Page, control: int) -> bool:
    return page.evaluate(
        """(i) => ((node) => node.checked || node.ariaChecked === "true" || node.ariaSelected === "true"
          || node.type === "range" && node.value === node.max)(controls[i].node)""",
        control,
    )


def turn_on(page: Page, control: int, kind: str) -> None:
    """Press a control, or move a slider to its other end."""
    if kind == "range":
        page.evaluate(FOCUS, control)
        page.keyboard.press("End")
    else:
        page.evaluate("(i) => controls[i].node.click()", control)
    settle(page)


EVERYWHERE = ".stSidebar, header, .st-key-bar"
"""The common parts of all pages."""


def test_controls_and_dotted_letters_are_visible_in_forced_colours(visit):
    page, checked, with_states, types = None, set(), set(), set()
    for each in PAGES.values():
        page = visit(each.path, within=page, figures=False, forced_colors="active")
        page.evaluate(OPEN)
        settle(page)
        if not checked:
            page.add_style_tag(content=CALM_PAGE)
        assert check_controls(page, "[data-none]", checked) > 4
        types |= check_states(page, EVERYWHERE, with_states)
    assert types >= {"checkbox", "range", "tab", "radio"}
    check_slides_and_popovers(visit("motion", within=page))
    check_dotted_letters(visit("derivation?show=reading", within=page))


def check_slides_and_popovers(page: Page) -> None:
    """Check popovers, the projector's switch and slides."""
    for name, place in (("Share", ".st-key-bar"), ("Steps, speed, view", "[class*='st-key-stage']")):
        page.get_by_role("button", name=name).press("Enter")  # after a click, React Aria shows no focus
        assert check_controls(page, f"header, .stSidebar, main :not({place}, {place} *, :has({place}))", set()) > 4
        page.keyboard.press("Escape")
    if page.locator("[data-testid=stExpandSidebarButton]").is_visible():
        page.locator("[data-testid=stExpandSidebarButton]").click()
    switch = page.locator(".st-key-projector label")
    before = pixels(switch)
    switch.click()
    page.wait_for_url("**view=projector*")
    settle(page)
    assert differ(before, pixels(switch))
    assert check_controls(page, "header, .stSidebar", set()) > 4


def test_desk_phone_and_wall_show_the_chosen_option(visit):
    def screen(query: str, **options: object) -> Page:
        page = visit(f"lesson?{query}", forced_colors="active", **options)
        page.add_style_tag(content=CALM_PAGE)
        return page

    desk, checked = screen(""), set()
    desk.locator(".st-key-class_door button").first.click()
    desk.locator(".st-key-class_open button").wait_for()
    desk.get_by_test_id("stTextInputField").wait_for()
    assert check_controls(desk, f"{EVERYWHERE}, main", checked) > 2
    desk.locator(".st-key-class_open button").click()
    settle(desk)
    query = desk.locator("a[href*='wall=on']").get_attribute("href").partition("?")[2]
    wall, phone = screen(query, theme="dark"), screen(query.replace("&wall=on", ""), width=390, height=844)
    onward = desk.locator(".st-key-class_moves [data-testid=stBaseButton-primary]")
    onward.click()
    phone.locator(".st-key-class_phone [role=radiogroup]").wait_for()
    settle(phone)
    assert check_controls(desk, EVERYWHERE, checked) > 4
    assert check_controls(phone, "[data-none]", checked) > 4
    assert check_states(phone, EVERYWHERE, set()) == {"radio"}
    onward.click()
    # All votes are for another option than the first.
    bars, options = desk.locator("[data-testid=stProgressBarTrack]"), wall.locator("[class*=st-key-wall_options] li")
    bars.first.wait_for()
    expect(options.locator("strong", has_text="100")).to_be_visible()
    for shares in (bars, options):
        pictures = [Image.open(io.BytesIO(share.screenshot(**AS_IT_IS))).convert("RGB") for share in shares.all()]
        colors = [picture.getcolors(2**16) for picture in pictures]
        assert len({max(counted)[1] for counted in colors}) == 2
        assert all(len(counted) > 1 for counted in colors)
    texts = options.locator("strong").all_inner_texts()
    assert {"0 %", "100 %"} == {text.replace("\u202f", " ").replace("\u00a0", " ") for text in texts}


FORMULAS = ".stMarkdown .katex:has(.accent)"
"""Formulas with dotted letters."""


def ink(formula: Locator) -> np.ndarray:
    """Return the mask of the ink in a formula."""
    picture = np.asarray(Image.open(io.BytesIO(formula.screenshot(**AS_IT_IS))).convert("L"), dtype=float)
    contrast = np.abs(picture - np.median(picture))
    return contrast > contrast.max() / 2


def lost_share(usual: np.ndarray, forced: np.ndarray) -> float:
    """Return the share of the ink in `usual` that is missing in `forced`, also from the adjacent pixels."""
    height, width = (min(sizes) for sizes in zip(usual.shape, forced.shape, strict=True))
    around = np.pad(forced[:height, :width], 1)
    near = np.any([around[y : y + height, x : x + width] for y in range(3) for x in range(3)], axis=0)
    return (usual[:height, :width] & ~near).sum() / usual.sum()


def check_formulas(page: Page) -> None:
    """Check that every dotted letter is complete in forced colours."""
    formulas, inks = page.locator(f"{FORMULAS} >> visible=true"), []
    places = formulas.count()
    assert places > 10
    for colors in ("none", "active"):
        page.emulate_media(forced_colors=colors)
        inks.append([ink(formulas.nth(place)) for place in range(0, places, places // 3)])
    assert max(map(lost_share, *inks)) < 0.03


def check_dotted_letters(page: Page) -> None:
    """Check that dotted letters are complete on the screen and on paper."""
    check_formulas(page)
    page.emulate_media(media="print")
    page.add_style_tag(content=".stBidiComponent { display: none }")  # on a screen it would cover the text
    check_formulas(page)
    # Negative control: a backplate behind each letter.
    page.add_style_tag(content=".katex, .katex * { forced-color-adjust: auto !important }")
    with pytest.raises(AssertionError):
        check_formulas(page)
