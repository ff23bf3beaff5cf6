"""How words are set: the page's own typeface in its figures, short lines, no lone full stop, labels inside figures."""

from __future__ import annotations

import io
from base64 import b64encode

import numpy as np
import pytest
from PIL import Image

from ramanujan.shell.navigation import PAGES
from tests.browser import ROOT, settle

SYMBOLS = (
    "Ω²m/k",
    "m′ = 2",
    "√(k/m)",
    "49mm′",
    "8m + 7",
    "2Rφ",
    "R drops",
    "out R. Which",
    "(T/2)²",
    "p/q",
    "hΩ",
    "x₀",
    "4ac",
)
UPRIGHT = (
    "5\u202fm/s",
    "N/m",
    "[m]",
    "kg·m²",
    "R. White",
    "a body",
    "mask kit",
    "x-ray",
    "m’s T’s",
    "BCD FHJ",
    "C and A4",
)
FONT = ROOT / "ramanujan/browser/page/fonts/text.woff2"
LINES_OF = """<!doctype html><style>@font-face {{ font-family: cut; src: url(data:font/woff2;base64,{font}) }}
body {{ margin: 0 }} p {{ margin: 0; font: 24px/40px cut; font-variant-ligatures: {ligatures} }}</style>{lines}"""
"""Texts in the page's font, each on a line of 40 px, with or without what the font changes by itself."""
INK = """(letters) => letters.map((text) => {
  const brush = document.createElement("canvas").getContext("2d");
  brush.font = '40px cut';
  return brush.measureText(text).actualBoundingBoxRight;
})"""
OPEN = "() => document.querySelectorAll('.stMain details:not([open]) > summary').forEach((each) => each.click())"
LINES = """() => [...document.querySelectorAll(".stMarkdown :is(p, li), [data-testid=stCaptionContainer] p")]
  .filter((each) => each.checkVisibility()).flatMap((each) => {
    const lines = [], range = document.createRange();
    const texts = document.createTreeWalker(each, NodeFilter.SHOW_TEXT);
    for (let text = texts.nextNode(); text; text = texts.nextNode()) {
      if (text.parentElement.closest(".katex-mathml, .katex-display, [role=img]")) continue;
      [...text.data].forEach((letter, at) => {
        range.setStart(text, at);
        range.setEnd(text, at + letter.length);
        const { top, bottom, width } = range.getBoundingClientRect(), middle = (top + bottom) / 2;
        if (!width) return;
        const line = lines.find((line) => Math.abs(line.middle - middle) < 9);
        line ? (line.text += letter) : lines.push({ middle, text: letter });
      });
    }
    return lines.map(({ text }) => text.trim());
  })"""
"""The lines of all paragraphs, as they are broken on the screen; a small index counts as a letter."""
FACES = """() => [...document.querySelectorAll(".js-plotly-plot text")].filter((each) => each.textContent.trim())
  .map((each) => getComputedStyle(each).fontFamily)"""
LOADED = """() => [...document.fonts].filter((each) => each.status === "loaded" && /Source Sans/.test(each.family))
  .map((each) => each.style)"""
MISPLACED = """() => [...document.querySelectorAll(".js-plotly-plot")].flatMap((graph) => {
  const home = graph.getBoundingClientRect(), labels = [...graph.querySelectorAll(".annotation-text")];
  const boxes = labels.map((label) => [label.textContent, label.getBoundingClientRect()]);
  return boxes.flatMap(([text, box], at) => [
    ...(box.left < home.left - 1 || box.right > home.right + 1 || box.top < home.top - 1 ? [`${text} is outside`] : []),
    ...boxes.slice(at + 1).filter(([, other]) => box.left < other.right - 1 && other.left < box.right - 1
      && box.top < other.bottom - 3 && other.top < box.bottom - 3).map(([other]) => `${text} lies on ${other}`),
  ]);
})"""
"""The labels of figures that are cut or lie on one another."""


@pytest.mark.parametrize("name", PAGES)
def test_lines_are_short_and_figures_are_set_as_the_page_is(visit, name):
    page = visit(PAGES[name].address, width=1920, height=1080)
    page.evaluate(OPEN)
    settle(page)
    lines = page.evaluate(LINES)
    assert len(lines) > 3
    assert [line for line in lines if len(line) > 84] == []
    assert [line for line in lines if line[:1] in (".", ",", ";", ":", ")")] == []
    faces = page.evaluate(FACES)
    assert set(faces) <= {'"Source Sans", sans-serif'}
    assert not faces or "normal" in page.evaluate(LOADED)
    assert page.evaluate(MISPLACED) == []
    if faces:
        page.set_viewport_size({"width": 390, "height": 844})
        page.wait_for_timeout(500)  # Plotly draws a figure anew some time after its width has changed
        assert page.evaluate(MISPLACED) == []


def test_a_letter_that_stands_alone_is_set_as_a_symbol(chromium):
    font, texts, pictures = b64encode(FONT.read_bytes()).decode(), [*SYMBOLS, *UPRIGHT], []
    with chromium.new_page(viewport={"width": 400, "height": 40 * len(texts)}) as page:
        for ligatures in ("normal", "none"):
            lines = "".join(f"<p>{text}</p>" for text in texts)
            page.set_content(LINES_OF.format(font=font, ligatures=ligatures, lines=lines))
            page.evaluate("document.fonts.ready")
            picture = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("L"), dtype=int)
            pictures.append(picture.reshape(len(texts), 40, -1))
        letter, dotted = page.evaluate(INK, ["Φ", "Φ\u0307"])
    changed = np.any(pictures[0] != pictures[1], axis=(1, 2))
    assert tuple(text for text, differs in zip(texts, changed, strict=True) if differs) == SYMBOLS
    assert dotted == letter
