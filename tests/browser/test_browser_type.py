"""Typesetting: the page's font draws a single letter as a symbol."""

import io
from base64 import b64encode

import numpy as np
import pytest
from fontTools.ttLib import TTFont
from PIL import Image

from tests import fonts
from tests.checks.browser import ROOT

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
FONT = ROOT / "ramanujan/browser/fonts/text.woff2"
LINES_OF = """<!doctype html><style>@font-face {{ font-family: cut; src: url(data:font/woff2;base64,{font}) }}
body {{ margin: 0 }} p {{ margin: 0; font: 24px/40px cut; font-variant-ligatures: {ligatures} }}</style>{lines}"""
"""Texts in the page's font, each on a line of 40 px, with or without contextual alternates."""
INK = """(letters) => letters.map((text) => {
  const brush = document.createElement("canvas").getContext("2d");
  brush.font = '40px cut';
  return brush.measureText(text).actualBoundingBoxRight;
})"""


def test_a_single_letter_is_drawn_as_a_symbol(chromium):
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


@pytest.mark.parametrize("name", fonts.FONTS)
def test_symbols_are_letters_of_katex_in_the_size_of_a_formula(name):
    cut, bold = TTFont(FONT.with_name(f"{name}.woff2")), fonts.FONTS[name][1]
    katex = fonts.original_of(f"KaTeX_Math-{bold}Italic")
    for letter in "mkR":
        wide = katex["hmtx"][katex.getBestCmap()[ord(letter)]][0]
        assert cut["hmtx"][f"{cut.getBestCmap()[ord(letter)]}.italic"][0] == round(fonts.SCALE * wide)
    assert f"> .katex {{ font-size: {fonts.SCALE}em;" in (fonts.PAGE / "type.css").read_text(encoding="utf-8")
