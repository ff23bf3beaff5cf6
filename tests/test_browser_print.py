"""What the browser prints: no sidebar, no controls, formulas and figures whole, light from a dark theme."""

import io
import re

import pytest
from pypdf import PageObject, PdfReader

from tests.test_worksheet import key_of, name_of

CONTROLS = (
    "Copy link",
    "Equal masses",
    "Projector",
    "Position in the period",
    "Print this page",
)
CUT = """() => ['.katex-display > .katex, .main-svg, .st-key-worksheet_picture img, [class*=st-key-question_] .base']
  .flatMap((selector) => [...document.querySelectorAll(selector)])
  .filter((node) => node.checkVisibility())
  .filter((node) => node.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map((node) => node.textContent.slice(0, 40))"""
"""Formulas and figures that end beyond the edge of the paper."""
TOUCHING = """() => {
  const boxes = [...document.querySelectorAll("[class*=st-key-question_] .katex-html > .base")]
    .map((node) => [node, node.getBoundingClientRect()]);
  const inks = boxes.map(([node, box]) => [node.textContent, box, parseFloat(getComputedStyle(node).paddingTop)]);
  return inks.flatMap(([upper, above, gap]) => inks.filter(([, below]) =>
    below.top > above.top + above.height / 2 && below.top + gap < above.bottom - gap + 3 &&
    below.left < above.right && above.left < below.right).map(([lower]) => `${upper} / ${lower}`));
}"""
"""Formulas that have less than 3 px between them and the line below."""
PAPERS = {"A4": (794, 595.9), "Letter": (816, 612.0)}
MARGINS = 113
"""Width of both margins of 15 mm [px]."""


def printed(page, paper: str) -> PdfReader:
    return PdfReader(io.BytesIO(page.pdf(format=paper)))


def filled(sheet: PageObject) -> float:
    """Return how far down a sheet something is written or drawn, as a share of its height."""
    heights = []

    def draw(operator: bytes, operands: list, matrix: list, _text: list) -> None:
        if operator in (b"m", b"l", b"re"):
            x, y = map(float, operands[:2])
            heights.append(x * matrix[1] + y * matrix[3] + matrix[5])

    def write(text: str, matrix: list, place: list, *_font: object) -> None:
        if text.strip():
            heights.append(place[4] * matrix[1] + place[5] * matrix[3] + matrix[5])

    sheet.extract_text(visitor_operand_before=draw, visitor_text=write)
    # The number of the page stands in the margin.
    whole = float(sheet.mediabox.height)
    return 1 - min(height for height in heights if height > 42) / whole


def check_paper(page) -> None:
    """Check that on paper nothing is cut or dark, no formula touches another, and no sidebar is seen."""
    page.emulate_media(media="print", color_scheme="dark", reduced_motion="reduce")
    for width, _points in PAPERS.values():
        page.set_viewport_size({"width": width - MARGINS, "height": 1000})
        assert page.evaluate(CUT) == page.evaluate(TOUCHING) == []
    paint = "(selector, what) => getComputedStyle(document.querySelector(selector))[what]"
    assert page.evaluate(f"({paint})('.stMain', 'backgroundColor')") == "rgb(255, 255, 255)"
    assert page.evaluate(f"({paint})('.stMain h1', 'color')") == "rgb(17, 17, 17)"
    assert not page.locator("section[data-testid=stSidebar]").is_visible()
    page.emulate_media(media="null")


SHEETS = {"oscillator": 6, "derivation": 11, "motion": 3, "taxicab": 6, "speed": 4}
"""Page → how many sheets of A4 it takes at most; the six open steps of the first page take three of its six."""


def check_printed(page, most: int) -> None:
    """Check that a page, in the dark theme and with its six steps open if it has them, comes on so many sheets.

    Nothing is cut, nothing is dark, no sheet is empty, and a step stands on one sheet with its equations.
    """
    sheets = [each.extract_text().strip() for each in printed(page, "A4").pages]
    text = "\n".join(sheets)
    assert not [words for words in CONTROLS if words in text]
    assert all(sheets), "an empty sheet"
    assert len(sheets) <= most
    if page.locator(".st-key-steps summary").count():
        (sheet,) = (each for each in sheets if "6. Find" in each)
        assert "1729" in sheet
        width = page.locator(".js-plotly-plot").evaluate("figure => figure.clientWidth")
        share = float(page.evaluate("document.documentElement.style.getPropertyValue('--printed')"))
        assert 600 < width * share <= PAPERS["A4"][0] - MARGINS
    # A browser that prints tells no script how wide the paper is, and draws no figure anew.
    client, screen = page.context.new_cdp_session(page), page.viewport_size
    client.send("Emulation.setScriptExecutionDisabled", {"value": True})
    check_paper(page)
    page.set_viewport_size(screen)
    page.wait_for_timeout(100)
    client.detach()


def test_a_worksheet_fills_its_pages_and_tears_no_question(visit):
    page = None
    for query in ("level=1", "level=2", "level=3", f"seed={name_of(2)}&paper=key&key={key_of(2)}"):
        page = visit(f"worksheet?{query}", theme="dark", tab=page)
        page.wait_for_selector(".st-key-worksheet_picture img")
        page.emulate_media(media="print")
        assert page.locator(".st-key-worksheet").evaluate("(node) => getComputedStyle(node).borderWidth") == "0px"
        page.emulate_media(media="null")
        for paper, (_width, points) in PAPERS.items() if query == "level=1" else [("A4", PAPERS["A4"])]:
            pdf = printed(page, paper)
            assert float(pdf.pages[0].mediabox.width) == pytest.approx(points, abs=1)
            texts = [each.extract_text().strip() for each in pdf.pages]
            numbered = [re.sub(rf"^{number} / {len(texts)}\s", "", text) for number, text in enumerate(texts, start=1)]
            assert numbered[0].startswith("Ramanujan’s oscillator")
            assert all(re.match(r"\d+\. " if "level" in query else ".", text) for text in numbered[1:])
            assert not [words for words in CONTROLS if words in "".join(texts)]
            assert 3 <= len(texts) <= 7
            points = re.findall(r"^\d+\. \((\d+) point", "\n".join(numbered), re.MULTILINE)
            total = re.findall(r"Points\s+of (\d+)", numbered[0])
            assert sum(map(int, points)) == sum(map(int, total or points)) > 17
            # Of the printable height, from 0.05 to 0.95, at most a fifth stays empty.
            assert [share for share in map(filled, pdf.pages[:-1]) if share < 0.77] == []
        check_paper(page)
