"""Printed pages."""

from PIL import ImageOps
from pypdfium2 import PdfDocument, PdfPage

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


def printed(page, paper: str) -> PdfDocument:
    return PdfDocument(page.pdf(format=paper))


def words(sheet: PdfPage) -> str:
    """Return the text of a page, without its number."""
    return sheet.get_textpage().get_text_bounded(bottom=MARGINS * 3 / 8).replace("\r", "").strip()


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
    if page.locator(".st-key-six_steps summary").count():
        (sheet,) = (each for each in sheets if "6. Find" in each)
        assert "1729" in sheet
        width = page.locator(".js-plotly-plot").evaluate("figure => figure.clientWidth")
        share = float(page.locator(".js-plotly-plot").evaluate("figure => figure.style.getPropertyValue('--printed')"))
        assert 600 < width * share <= PAPERS["A4"][0] - MARGINS
    # A printing browser does not report the width of the paper to scripts, and redraws no figure.
    client, screen = page.context.new_cdp_session(page), page.viewport_size
    client.send("Emulation.setScriptExecutionDisabled", {"value": True})
    check_paper(page)
    page.set_viewport_size(screen)
    page.wait_for_timeout(100)
    client.detach()
