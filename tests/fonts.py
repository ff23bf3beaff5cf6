"""Cut the fonts of the app, `ramanujan/browser/page/fonts/`, out of Streamlit's: Latin, Greek, signs, two weights.

    python -m tests.fonts

The ranges are those that page.css promises. The files bear other names than their originals, as the licence asks.
"""

from __future__ import annotations

import io
import re
from pathlib import Path

import streamlit
from fontTools import subset
from fontTools.ttLib import TTFont
from fontTools.varLib import instancer

from tests.browser import ROOT

PAGE = ROOT / "ramanujan" / "browser" / "page"
ORIGINALS = Path(streamlit.__file__).parent / "static" / "static" / "media"
FONTS = {
    "headings": ("SourceSerifVariable-Roman", {"wght": (600, 700), "opsz": 24}),
    "text": ("SourceSansVF-Upright", {"wght": (400, 700)}),
    "symbols": ("SourceSansVF-Italic", {"wght": 400}),
}
"""File → its original's name, and the part of each axis that is kept."""
COPYRIGHT_AND_LICENCE = [0, 13, 14]
FAMILY, STYLE, FULL, POSTSCRIPT = 1, 2, 4, 6
"""Numbers of a font's names."""


def main() -> None:
    for name, (original, axes) in FONTS.items():
        [source] = ORIGINALS.glob(f"{original}.*.woff2")
        font = _saved(instancer.instantiateVariableFont(TTFont(source), axes))
        options = subset.Options(hinting=False, name_IDs=COPYRIGHT_AND_LICENCE)
        options.layout_features = ["ccmp", "kern", "liga", "mark", "tnum"]
        cutter = subset.Subsetter(options)
        cutter.populate(unicodes=promised(name))
        cutter.subset(font)
        family = f"Ramanujan {name.title()}"
        names = {FAMILY: family, STYLE: "Regular", FULL: family, POSTSCRIPT: family.replace(" ", "")}
        for number, text in names.items():
            font["name"].setName(text, number, 3, 1, 0x409)
        font.flavor = "woff2"
        font.save(PAGE / "fonts" / f"{name}.woff2")


def promised(name: str) -> set[int]:
    """Return the characters that page.css promises of a font."""
    rules = (PAGE / "page.css").read_text(encoding="utf-8")
    ranges = re.findall(rf"{name}\.woff2[^}}]*unicode-range: ([^;]+);", rules)
    ends = (part.removeprefix("U+").partition("-") for part in ", ".join(ranges).split(", "))
    return {code for first, _, last in ends for code in range(int(first, 16), int(last or first, 16) + 1)}


def _saved(font: TTFont) -> TTFont:
    """Return a font as it is read after it has been saved: only then do all its tables know the kept part."""
    file = io.BytesIO()
    font.flavor = None
    font.save(file)
    file.seek(0)
    return TTFont(file)


if __name__ == "__main__":
    main()
