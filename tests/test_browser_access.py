"""Accessibility and typesetting of every page: on a laptop in dark colours, on paper, and on a phone in light colours.

axe-core reports no violation, headings skip no level, and the focus is visible. Typesetting: the page's typeface in its
figures, short lines, no line that begins with a full stop, labels inside figures. The server's content security policy
is in effect and allows all of this.
"""

import re
from importlib.resources import files
from itertools import pairwise

import pytest

from ramanujan.shell.menu import PAGES
from tests.checks.bare import THEME
from tests.checks.browser import script, settle, traffic, until
from tests.checks.engines import REFUSED
from tests.checks.layout import (
    ADDRESSES,
    CUT_LABELS,
    MOST_SHIFT,
    OPEN,
    OVERLAPS,
    SHIFTS,
    check_calm,
    check_widths,
    shift,
)
from tests.checks.look import RING, rgb, switch
from tests.checks.paper import SHEETS, check_printed

OF_STREAMLIT = r"/Source(Sans|Serif)\w*-(Upright|Roman|Italic)"
"""Addresses of Streamlit's text fonts, which a browser loads for characters that the app's fonts lack."""
AXE = files("axe_playwright_python").joinpath("axe.min.js")
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
OF_THE_SCREEN = ["color-contrast", "link-in-text-block", "scrollable-region-focusable", "target-size"]
"""The rules that depend on the theme or on the width."""
VIOLATIONS = """([within, rules]) => axe.run({ include: within, exclude: ".katex-html" },
    { runOnly: rules, resultTypes: ["violations"], preload: false })
  .then((result) => result.violations.flatMap((each) => each.nodes.map((node) =>
    `${each.id}: ${node.target.flat().join(" ")} ${node.html.slice(0, 160)}`)))"""
"""The violations that axe-core reports outside of formulas; test_look checks the contrast of formulas.

With `preload: false`, axe-core does not load every style sheet again. Only its rule about the orientation of the screen
needs them.
"""
REACHED = """() => [...document.querySelectorAll(".stMarkdown *, [class*=st-key-]")].every((box) => box.tabIndex === 0
  || box.scrollWidth <= box.clientWidth || !/auto|scroll/.test(getComputedStyle(box).overflowX)
  || box.querySelector("button, input, a, [tabindex='0']"))"""
"""Whether every box that scrolls sideways takes the focus; reach.js sets this shortly after a change of the page."""
HEADINGS = """() => [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")]
  .filter((each) => each.checkVisibility()).map((each) => Number(each.tagName[1]))"""
"""The levels of the headings in their order."""

REGIONS = ":is(main, .stSidebar) :is([role=status], [aria-live]:not([aria-live=off]), output:not([aria-hidden=true]))"
"""Every landmark of the page, including the components."""

LINES = script("lines")
"""The lines of all paragraphs on the screen; a small index counts as a letter."""
TICKS = "[...document.querySelectorAll('.js-plotly-plot .xtick text')].map((each) => each.style.fill)"
FACES = """() => [...document.querySelectorAll(".js-plotly-plot text")].filter((each) => each.textContent.trim())
  .map((each) => getComputedStyle(each).fontFamily)"""
LOADED = """() => [...document.fonts].filter((each) => each.status === "loaded" && /Source Sans/.test(each.family))
  .map((each) => each.style)"""
FILES = ", ".join(f":is(button, a):visible:has-text('{name}')" for name in ("Save picture", "CSV", "Download"))


def audit(page, rules: list[str] = TAGS, within: str = "html") -> list[str]:
    """Return axe-core's violations in a part of the page, once the page is idle."""
    settle(page)
    until(page, REACHED)
    return page.evaluate(VIOLATIONS, [within, rules])


def check_title_and_headings(page, name: str) -> None:
    """Check that a page has a title, one h1, and headings that skip no level."""
    title = page.title()
    assert PAGES[name].title in title or not PAGES[name].path
    assert "Ramanujan’s oscillator" in title
    levels = page.evaluate(HEADINGS)
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    # Each page has another title, so that tabs can be distinguished.
    assert len({PAGES[each].title for each in PAGES}) == len(PAGES)


def check_requests(requested: list[str], server: str) -> None:
    """Check that no request went to another server, and none for Streamlit's large text fonts.

    A classroom may have no internet connection, and a visit to the app must stay private.
    """
    assert len(requested) > 1
    own = (server, server.replace("http", "ws"), "data:", "blob:")
    assert [url for url in requested if not url.startswith(own)] == []
    assert [url for url in requested if re.search(OF_STREAMLIT, url)] == []


def check_words(page, longest: int) -> None:
    """Check that lines are short and begin with no full stop, and that texts in diagrams have the page's typeface.

    No text is outside of its figure, and no two texts overlap.
    """
    lines = page.evaluate(LINES)
    assert len(lines) > 3
    assert [line for line in lines if len(line) > longest] == []
    assert [line for line in lines if line[:1] in (".", ",", ";", ":", ")")] == []
    faces = page.evaluate(FACES)
    assert set(faces) <= {'"Source Sans", sans-serif'}
    assert not faces or "normal" in page.evaluate(LOADED)
    assert page.evaluate(CUT_LABELS) == []
    assert page.evaluate(OVERLAPS) == []


def check_figures_follow(page, inks: list[str]) -> None:
    """Check that no figure has a colour of the previous theme, and that reruns come to an end."""
    until(page, f"(before) => !{TICKS}.some((ink) => before.includes(ink))", inks)
    settle(page)
    sent = len(traffic(page).sent)
    page.wait_for_timeout(800)
    assert len(traffic(page).sent) == sent


def check_control(page) -> None:
    """Negative control: axe-core, the list of requests and the policy detect violations."""
    page.evaluate("document.querySelector('h1').insertAdjacentHTML('afterend', '<h4 style=color:#555>faint</h4><img>')")
    assert {each.partition(":")[0] for each in audit(page)} == {"color-contrast", "heading-order", "image-alt"}
    with page.expect_request(lambda request: re.search(OF_STREAMLIT, request.url)):
        page.evaluate("document.querySelector('h1').append(' Ж')")
    page.evaluate("fetch('https://example.org').catch(() => 0)")
    assert page.evaluate("refused") != []


FOCUSED = (
    "[data-testid=stExpander] summary",
    ".st-key-more button",
    ".st-key-route input",
    ".st-key-questions button",
)
IN_A_QUESTION = ".stTextInput input", "[data-testid=stFormSubmitButton] button"


def check_focus(page, theme: str, focused: tuple[str, ...]) -> None:
    """Check that the focus is visible in the theme's colour."""
    ring = [3, "rgb({}, {}, {})".format(*rgb(THEME[theme]["primaryColor"]))]
    for selector in focused:
        assert page.locator(f"{selector} >> visible=true").first.evaluate(RING) == ring, selector


@pytest.mark.parametrize("name", PAGES)
def test_everyone_can_use_and_read_a_page(visit, server, name):
    requested: list[str] = []
    page = visit(PAGES[name].path, REFUSED, SHIFTS, note=requested.append, bypass_csp=False, theme="dark")
    check_requests(requested, server)
    check_calm(page, name)
    check_widths(page)
    page.set_viewport_size({"width": 1920, "height": 1080})
    check_title_and_headings(page, name)
    page.evaluate(OPEN)
    settle(page)
    # On a worksheet, the lines of text are as long as the lines for answers.
    check_words(page, 115 if name == "worksheet" else 75)
    page.wait_for_load_state("networkidle")  # the fonts of formulas load last and change their widths
    assert page.locator(REGIONS).count() == 1
    page.evaluate(AXE.read_text(encoding="utf-8"))
    assert audit(page) == []
    for tab in page.get_by_role("tab").all()[1:]:
        tab.click()
        assert audit(page, within="[role=tabpanel]") == []
    if name == "derivation":
        check_focus(page, "dark", FOCUSED)
        page.locator(".st-key-more button").click()
        page.locator(".st-key-show button").nth(1).click()
        page.keyboard.press("Escape")
        settle(page)
        page.locator(".st-key-questions button").first.click()
        settle(page)
        assert audit(page) == []
        check_focus(page, "dark", IN_A_QUESTION)
        page.locator(".st-key-close_question button").click()
        settle(page)
    if name in SHEETS:
        check_printed(page, SHEETS[name])
    if name == "motion":
        inks = page.evaluate(TICKS)
        switch(page, "light")
        check_figures_follow(page, inks)
    for button in page.locator(FILES).all():
        button.click(force=True)
    settle(page)
    assert page.evaluate("refused") == []
    if name == "lesson":
        check_wall(page, server)
    if name == "worksheet":
        check_control(page)


def check_wall(page, server: str) -> None:
    """Check that the policy allows the wall of a class, which contains an image with a data: address."""
    page.goto(f"{server}/lesson")
    for name in ("door", "open"):
        page.locator(f".st-key-class_{name} button").first.click()
    page.goto(page.get_by_role("link", name="Open the wall").get_attribute("href"))
    page.locator(".st-key-class_wall img").wait_for()
    settle(page)
    assert page.evaluate("refused") == []


def test_a_page_is_calm_and_readable_on_a_phone_in_the_light_theme(visit):
    """Check the pages without figures, for which they reserve the space. On a laptop, drawing them causes no jump.

    A theme changes only colours, and a width no colours, so two of the four combinations suffice.
    """
    page, moved = None, {}
    for name, address in ADDRESSES.items():
        first = () if page else [SHIFTS]
        page = visit(address, *first, width=390, height=844, tab=page, figures=bool(page))
        moved[name] = shift(page)
        page.evaluate(OPEN)
        settle(page)
        page.evaluate(AXE.read_text(encoding="utf-8"))
        assert audit(page, OF_THE_SCREEN) == []
        assert page.evaluate(OVERLAPS) == []
        if name == "derivation":
            check_focus(page, "light", FOCUSED[1:])  # the sidebar is closed
    assert max(moved.values()) < MOST_SHIFT, moved
