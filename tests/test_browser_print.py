"""What the browser prints: no sidebar, no controls, formulas and figures whole, light from a dark theme."""

from __future__ import annotations

import io

import pytest
from pypdf import PdfReader

CONTROLS = (
    "Copy link",
    "Equal masses",
    "Energy\nVelocities",
    "Projector",
    "Within one period",
    "Print this page",
)
CUT = """() => [...document.querySelectorAll('.katex-display > .katex, .main-svg, .st-key-sheet_picture img')]
  .filter((node) => node.checkVisibility())
  .filter((node) => node.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map((node) => node.textContent.slice(0, 40))"""
"""Formulas and figures that end beyond the edge of the paper."""
PAPERS = {"A4": (794, 595.9), "Letter": (816, 612.0)}
MARGINS = 113
"""Width of both margins of 15 mm [px]."""


def printed(page, paper: str) -> PdfReader:
    return PdfReader(io.BytesIO(page.pdf(format=paper)))


@pytest.mark.parametrize("paper", PAPERS)
def test_a_worksheet_comes_out_clean(visit, paper):
    page = visit("worksheet?seed=7", theme="dark")
    page.wait_for_selector(".st-key-sheet_picture img")
    pdf = printed(page, paper)
    assert float(pdf.pages[0].mediabox.width) == pytest.approx(PAPERS[paper][1], abs=1)
    text = "\n".join(each.extract_text() for each in pdf.pages)
    assert "worksheet" in text
    assert all(f"{number}." in text for number in range(1, 10))
    assert not [words for words in CONTROLS if words in text]
    assert 2 <= len(pdf.pages) <= 6


SHEETS = {"": 4, "derivation?show=reading": 11, "motion": 2, "1729": 6, "speed": 4, "worksheet?paper=key": 8}
"""Page → how many sheets of A4 it takes at most."""


@pytest.mark.parametrize("path", SHEETS)
def test_nothing_is_cut_and_nothing_dark_on_paper(visit, path):
    page = visit(path, theme="dark")
    sheets = [each.extract_text().strip() for each in printed(page, "A4").pages]
    text = "\n".join(sheets)
    assert not [words for words in CONTROLS if words in text]
    assert all(sheets), "an empty sheet"
    assert len(sheets) <= SHEETS[path]
    page.emulate_media(media="print", color_scheme="dark", reduced_motion="reduce")
    page.set_viewport_size({"width": PAPERS["A4"][0] - MARGINS, "height": 1000})
    assert page.evaluate(CUT) == []
    paint = "(selector, what) => getComputedStyle(document.querySelector(selector))[what]"
    assert page.evaluate(f"({paint})('.stMain', 'backgroundColor')") == "rgb(255, 255, 255)"
    assert page.evaluate(f"({paint})('.stMain h1', 'color')") == "rgb(17, 17, 17)"
    assert not page.locator("section[data-testid=stSidebar]").is_visible()
    page.emulate_media(media="null")


def test_a_step_and_its_equations_are_on_one_sheet(visit):
    (sheet,) = (each for each in printed(visit(""), "A4").pages if "6. Find" in each.extract_text())
    assert "1729" in sheet.extract_text()
