"""Printed pages: no sidebar, no controls, complete formulas and figures, always in light colours."""

import os
import re
from ctypes import c_double
from itertools import cycle

import pypdfium2.raw as pdfium
import pytest
from PIL import ImageOps
from pypdfium2 import PdfDocument, PdfPage

from tests.test_worksheet import MACHINES, key_of, name_of

CONTROLS = (
    "Share",
    "Equal masses",
    "Projector",
    "Position in the period",
    "Print this page",
)
CUT = """() => ['.katex-display > .katex, .main-svg, .st-key-worksheet_picture img, [class*=st-key-question-] .base']
  .flatMap((selector) => [...document.querySelectorAll(selector)])
  .filter((node) => node.checkVisibility())
  .filter((node) => node.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map((node) => node.textContent.slice(0, 40))"""
"""Formulas and figures that extend beyond the edge of the paper."""
PAPERS = {"A4": (794, 595.9), "Letter": (816, 612.0)}
MARGINS = 113
"""Width of both margins of 15 mm [px]."""


CLOSEST = 1.5
"""Smallest distance between glyphs of different lines [pt]."""


def printed(page, paper: str) -> PdfDocument:
    return PdfDocument(page.pdf(format=paper))


def words(sheet: PdfPage) -> str:
    """Return the text of a page, without its number."""
    return sheet.get_textpage().get_text_bounded(bottom=MARGINS * 3 / 8).replace("\r", "").strip()


def touching(sheet: PdfPage) -> list[str]:
    """Return the pairs of glyphs of different lines whose ink is too close."""
    text, glyphs = sheet.get_textpage(), []
    for place in range(text.count_chars()):
        pdfium.FPDFText_GetCharOrigin(text, place, c_double(), baseline := c_double())
        left, bottom, right, top = text.get_charbox(place)
        if right > left:
            glyphs.append((top, bottom, left, right, baseline.value, place))
    glyphs.sort(reverse=True)
    pairs = []
    for i, (_, bottom, left, right, baseline, place) in enumerate(glyphs):
        for top, _, other_left, other_right, other_baseline, other in glyphs[i + 1 :]:
            if top < bottom - CLOSEST:
                break
            # Not counted: accents, indices and powers. Their baseline is within 4 points of that of their letter, or
            # they are within 9 characters of it.
            overlap = min(right, other_right) > max(left, other_left)
            if baseline - other_baseline > 4 and abs(place - other) > 9 and overlap:
                pairs.append(f"{text.get_text_range(place, 9)} is too close to {text.get_text_range(other, 9)}")
    return pairs


def filled(sheet: PdfPage) -> float:
    """Return the share of a sheet's height, between its margins, down to the last ink."""
    (width, height), margin = sheet.get_size(), MARGINS * 3 / 8
    ink = ImageOps.invert(sheet.render(grayscale=True).to_pil()).crop((0, margin, width, height - margin))
    return ink.getbbox()[3] / ink.height


def check_paper(page) -> None:
    """Check that on paper nothing is cut or dark, and that the sidebar is hidden."""
    page.emulate_media(media="print", color_scheme="dark", reduced_motion="reduce")
    for width, _points in PAPERS.values():
        page.set_viewport_size({"width": width - MARGINS, "height": 1000})
        assert page.evaluate(CUT) == []
    paint = "(selector, what) => getComputedStyle(document.querySelector(selector))[what]"
    assert page.evaluate(f"({paint})('.stMain', 'backgroundColor')") == "rgb(255, 255, 255)"
    assert page.evaluate(f"({paint})('.stMain h1', 'color')") == "rgb(17, 17, 17)"
    assert not page.locator("section[data-testid=stSidebar]").is_visible()
    page.emulate_media(media="null")


SHEETS = {"oscillator": 6, "derivation": 11, "motion": 3, "taxicab": 6, "speed": 4}
"""Page → largest number of sheets of A4; three of the first page's six sheets contain its six open steps."""


def check_printed(page, most: int) -> None:
    """Check the number of sheets of a page, in the dark theme and with its steps open, if any.

    Nothing is cut or dark, no sheet is empty, and each step is on one sheet with its equations.
    """
    pdf = list(printed(page, "A4"))
    sheets = [words(each) for each in pdf]
    assert not [name for name in CONTROLS if name in "".join(sheets)]
    assert min(map(filled, pdf)) > 0.1, "a sheet with nothing but its number"
    assert len(sheets) <= most
    if page.locator(".st-key-steps summary").count():
        (sheet,) = (each for each in sheets if "6. Find" in each)
        assert "1729" in sheet
        width = page.locator(".js-plotly-plot").evaluate("figure => figure.clientWidth")
        share = float(page.evaluate("document.documentElement.style.getPropertyValue('--printed')"))
        assert 600 < width * share <= PAPERS["A4"][0] - MARGINS
    # A printing browser does not report the width of the paper to scripts, and redraws no figure.
    client, screen = page.context.new_cdp_session(page), page.viewport_size
    client.send("Emulation.setScriptExecutionDisabled", {"value": True})
    check_paper(page)
    page.set_viewport_size(screen)
    page.wait_for_timeout(100)
    client.detach()


SHEETS_TRIED = 15 if os.environ.get("RAMANUJAN_DEEP") else 1
"""Number of tested codes. Each code has three sheets: derivations of the first and the last level, and the key."""


def test_a_worksheet_fills_its_pages_and_its_lines_do_not_touch(visit):
    for number, machine in zip(range(SHEETS_TRIED), cycle(MACHINES)):
        sheet = f"worksheet?seed={name_of(number)}&m={machine.m}&m_prime={machine.m_prime}&k={machine.k}"
        page = None
        for rest in ("level=1", "level=3", f"paper=key&key={key_of(number)}"):
            page = visit(f"{sheet}&{rest}", theme="dark", within=page)
            page.wait_for_selector(".st-key-worksheet_picture img")
            for paper, (_width, width) in PAPERS.items():
                check_worksheet(printed(page, paper), width)
            check_paper(page)
    page.add_style_tag(content=".strut { margin: 0 !important; }")
    assert any(map(touching, printed(page, "A4"))), "the test does not see lines that touch"


def check_worksheet(pdf: PdfDocument, width: float) -> None:
    """Check a printed worksheet or key: its points, its pages, and the distance of its lines."""
    assert pdf[0].get_width() == pytest.approx(width, abs=1)
    assert [lines for sheet in pdf for lines in touching(sheet)] == []
    texts = [words(sheet) for sheet in pdf]
    assert texts[0].startswith("Ramanujan’s oscillator")
    assert not [name for name in CONTROLS if name in "".join(texts)]
    assert 3 <= len(pdf) <= 7
    points = re.findall(r"^\d+\. \((\d+) point", "\n".join(texts), re.MULTILINE)
    total = re.findall(r"Points\s+of (\d+)", texts[0])
    assert len(points) == 17
    assert sum(map(int, points)) == sum(map(int, total or points))
    # A question is never split. Of 120 sheets, one on Letter has two pages filled to 0.782; all others to at least 0.8.
    assert [share for share in map(filled, list(pdf)[:-1]) if share < 0.78] == []
