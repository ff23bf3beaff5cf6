"""Printed pages: no sidebar, no controls, complete formulas and figures, always in light colours."""

import re
from ctypes import c_double
from itertools import cycle

import pypdfium2.raw as pdfium
import pytest
from PIL import ImageOps
from pypdfium2 import PdfDocument, PdfPage

from tests.checks.paper import (
    CONTROLS,
    PAPERS,
    check_paper,
    filled,
    printed,
    words,
)
from tests.checks.worksheets import MACHINES, key_of, name_of
from tests.settings import DEEP

CLOSEST = 1.5
"""Smallest distance between glyphs of different lines [pt]."""


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


def begins_with_text(sheet: PdfPage) -> bool:
    """Return whether the first ink of a sheet is a text, and not a line that belongs to the sheet before."""
    text = sheet.get_textpage()
    highest = max(text.get_charbox(place)[3] for place in range(text.count_chars()))
    _left, first_ink, _right, _bottom = ImageOps.invert(sheet.render(grayscale=True).to_pil()).getbbox()
    return sheet.get_height() - highest - first_ink < 6


SHEETS_TRIED = 15 if DEEP else 1
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
    assert all(map(begins_with_text, pdf))
