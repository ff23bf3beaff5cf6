"""Cut the fonts of the app, `ramanujan/browser/fonts/`, out of Streamlit's.

The result contains Latin, Greek, signs and two weights.

    python -m tests.fonts

page.css defines the ranges of characters. The files have other names than their originals, as the licence requires.

The font of icons contains the icons whose names occur in the app's modules, or as `:material/name:` in Streamlit's
scripts.

The fonts draw symbols with KaTeX's letters: Greek letters and the prime always, single Latin letters by context. They
use OpenType's contextual alternates. Therefore Ω²m/k looks like a formula in texts, on buttons and in figures. The text
remains plain for screen readers, searches and copies. Letters of words, units and initials are not changed.

The formulas of the standalone file are MathML. Without a font that has the table MATH, Chromium draws the bar of a root
on its digits. Such fonts are large and rarely installed, so a small one is built from KaTeX's letters.
"""

import html
import io
import re
import subprocess
import sys
import unicodedata
from functools import cache
from pathlib import Path

import streamlit
from fontTools import subset
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.otlLib.builder import buildMathTable
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont
from fontTools.ttLib.tables._c_m_a_p import CmapSubtable
from fontTools.ttLib.tables.TupleVariation import TupleVariation
from fontTools.varLib import instancer
from fontTools.varLib.hvar import add_HVAR

from ramanujan.text.catalogue import COMPLETE
from tests.checks.browser import ROOT

STANDALONE = ROOT / "ramanujan/standalone"
PAGE = ROOT / "ramanujan/browser"
ORIGINALS = Path(streamlit.__file__).parent / "static" / "static" / "media"
FONTS = {
    "headings": ("SourceSerifVariable-Roman", "Bold", {"wght": (600, 700), "opsz": 24}),
    "text": ("SourceSansVF-Upright", "", {"wght": (400, 700)}),
    "symbols": ("SourceSansVF-Italic", "", {"wght": 400}),
}
"""File → name of its original, weight of KaTeX's letters for its symbols, and range of each axis."""
SCALE, RAISED = 1.05, (0.7, 0.363)
"""Size of a formula relative to the text (type.css); size and height of a prime in KaTeX [em]."""
BESIDE = 140
"""Space to the right of a raised glyph, for each em of its height; in KaTeX 0.05 em."""
SLOPE = 0.25
"""The slope of KaTeX's italics."""
LATIN = "KMRTXbchkmpqtvx"
"""Letters that are symbols when they are not part of a word; a is also a word."""
SYMBOLS = """
languagesystem DFLT dflt; languagesystem latn dflt; languagesystem grek dflt;
@letter = [{letters}]; @small = [{small}]; @capital = [{capitals}]; @digit = [{digits}];
@symbol = [{symbols}]; @italic = [{italics}];
{dots}
feature calt {{
  lookup formulas {{
    sub @digit R' period by R.italic;
    sub @small space R' period by R.italic;
    sub m' m {prime} by m.italic;
    sub a' periodcentered by a.italic; sub a' space equal by a.italic; sub @digit a' [parenright c] by a.italic;
  }} formulas;
  lookup single {{
    ignore sub [@letter quotesingle quoteright] @symbol', @symbol' [@letter @digit quoteright hyphen];
    ignore sub {thin_space} @symbol', bracketleft m', N slash m', [g N] periodcentered m', @capital' period;
    sub @symbol' by @italic;
  }} single;
}} calt;
"""
PRIME, RADICAL = 0x2032, 0x221A
ITALICS = {
    chr(int(unicodedata.decomposition(sign).removeprefix("<font> "), 16)): sign
    for sign in map(chr, range(0x1D434, 0x1D71C))
    if unicodedata.name(sign, "").startswith("MATHEMATICAL ITALIC ")
}
"""Letter → its italic in MathML, for Latin and Greek letters and ∂."""
MATH = {
    "AxisHeight": 250,
    "AccentBaseHeight": 431,
    "FlattenedAccentBaseHeight": 664,
    "SubscriptShiftDown": 247,
    "SubscriptTopMax": 344,
    "SubscriptBaselineDropMin": 50,
    "SuperscriptShiftUp": 413,
    "SuperscriptShiftUpCramped": 289,
    "SuperscriptBottomMin": 108,
    "SuperscriptBaselineDropMax": 500,
    "SubSuperscriptGapMin": 160,
    "SuperscriptBottomMaxWithSubscript": 344,
    "SpaceAfterScript": 50,
    "FractionNumeratorShiftUp": 394,
    "FractionNumeratorDisplayStyleShiftUp": 677,
    "FractionDenominatorShiftDown": 345,
    "FractionDenominatorDisplayStyleShiftDown": 686,
    "FractionNumeratorGapMin": 40,
    "FractionNumDisplayStyleGapMin": 120,
    "FractionRuleThickness": 40,
    "FractionDenominatorGapMin": 40,
    "FractionDenomDisplayStyleGapMin": 120,
    "RadicalVerticalGap": 110,
    "RadicalDisplayStyleVerticalGap": 148,
    "RadicalRuleThickness": 40,
    "RadicalExtraAscender": 40,
}
"""The distances in a formula of TeX and KaTeX [em/1000], by their names in the table MATH.

Two are larger: SuperscriptBaselineDropMax, so that a dot does not raise an exponent, and RadicalVerticalGap, which must
be visible on a screen with large pixels.
"""
COPYRIGHT_AND_LICENCE = [0, 13, 14]
FAMILY, STYLE, FULL, POSTSCRIPT = 1, 2, 4, 6
"""Ids of a font's names."""


def main() -> None:
    for name, (original, bold, axes) in FONTS.items():
        font = cut(original, axes, code_points(name))
        set_symbols(font, original_of(f"KaTeX_Math-{bold}Italic"), original_of(f"KaTeX_Main-{bold or 'Regular'}"))
        family = f"Ramanujan {name.title()}"
        names = {FAMILY: family, STYLE: "Regular", FULL: family, POSTSCRIPT: family.replace(" ", "")}
        for number, text in names.items():
            font["name"].setName(text, number, 3, 1, 0x409)
        font.flavor = "woff2"
        font.save(PAGE / "fonts" / f"{name}.woff2")
    icons().save(PAGE / "icons.woff2")
    for name in FONTS:
        cut_for_standalone(name).save(STANDALONE / f"{name}.woff2")
    build_for_formulas().save(STANDALONE / "formulas.woff2")


def cut_for_standalone(name: str) -> TTFont:
    """Return one of the app's fonts with the characters of the standalone file in all complete languages."""
    files = [standalone(language) for language in ("en", *COMPLETE)]
    if name == "headings":
        files = [heading for file in files for heading in re.findall(r"<h[12]>(.*?)</h", file)]
    font = TTFont(PAGE / "fonts" / f"{name}.woff2")
    if name == "headings":
        font = _reload(instancer.instantiateVariableFont(font, {"wght": 600}))
    options = subset.Options(hinting=False, name_IDs=COPYRIGHT_AND_LICENCE, layout_features=["*"])
    cutter = subset.Subsetter(options)
    cutter.populate(text="".join(files))
    cutter.subset(font)
    font.flavor = "woff2"
    return font


def build_for_formulas() -> TTFont:
    """Return a font with KaTeX's letters for the formulas of the standalone file, and with the table MATH."""
    upright, italic = original_of("KaTeX_Main-Regular"), original_of("KaTeX_Math-Italic")
    files = "".join(standalone(language) for language in ("en", *COMPLETE))
    formulas = "".join(re.findall(r"<math.*?</math>", files))
    # A browser replaces a symbol of one letter by its italic. Words are set in the font of the text.
    formulas = re.sub("<mi>(.)</mi>", lambda match: ITALICS.get(match[1], match[1]), formulas)
    characters = set(re.sub(r"<mtext>.*?</mtext>|<[^>]*>", "", formulas)) | {chr(RADICAL)}
    font = original_of("KaTeX_Main-Regular")
    cutter = subset.Subsetter(subset.Options(hinting=False, name_IDs=COPYRIGHT_AND_LICENCE, layout_features=[]))
    cutter.populate(text=" ")
    cutter.subset(font)
    names = dict(font.getBestCmap())
    originals = {own: (italic, letter) for letter, own in ITALICS.items()} | {
        "ℒ": (original_of("KaTeX_Caligraphic-Regular"), "L"),
        "𝜕": (upright, "∂"),
        "\u0307": (upright, "˙"),
        "\u0308": (upright, "¨"),
    }
    for character in sorted(characters - set(map(chr, names))):
        source, letter = originals.get(character, (upright, character))
        names[ord(character)] = f"u{ord(character):04X}"
        place = RAISED if ord(character) == PRIME else ()
        _put(font, names[ord(character)], source, source.getBestCmap()[ord(letter)], *place)
    font["cmap"].tables = [CmapSubtable.newSubtable(12)]
    vars(font["cmap"].tables[0]).update(platformID=3, platEncID=10, language=0, cmap=names)
    _add_dots(font, set(re.findall("(.)([\u0307\u0308])", formulas)))
    _add_math(font)
    font = _reload(font)
    font.flavor = "woff2"
    return font


def _add_dots(font: TTFont, pairs: set[tuple[str, str]]) -> None:
    """Add letters with dots, and the rules that replace a letter and a combining character by one of them."""
    names, rules = font.getBestCmap(), []
    font["OS/2"].sxHeight = round(SCALE * MATH["AccentBaseHeight"])
    for letter, dot in sorted(pairs):
        base, above = names[ord(letter)], names[ord(dot)]
        _put_dot(font, f"{base}.{above}", base, above, SLOPE if ord(letter) > 0xFFFF else 0)
        rules.append(f"sub {base} {above} by {base}.{above};")
    addOpenTypeFeaturesFromString(font, f"feature ccmp {{ {' '.join(rules)} }} ccmp;", ["GSUB"])


def _add_math(font: TTFont) -> None:
    """Add the table MATH with the larger root signs of KaTeX."""
    root = font.getBestCmap()[RADICAL]
    sizes = [root]
    for name in ("KaTeX_Size1-Regular", "KaTeX_Size2-Regular"):
        source = original_of(name)
        sizes.append(f"{root}.{len(sizes)}")
        _put(font, sizes[-1], source, source.getBestCmap()[RADICAL])
    boxes = {name: font["glyf"][name] for name in [*font.getBestCmap().values(), *sizes]}
    font.getReverseGlyphMap(rebuild=True)
    over = {name: box.xMax - font["hmtx"][name][0] for name, box in boxes.items() if box.numberOfContours}
    buildMathTable(
        font,
        constants={name: SCALE * value for name, value in MATH.items()}
        | {"ScriptPercentScaleDown": 70, "ScriptScriptPercentScaleDown": 50},
        # Browsers reject a table without data about letters.
        italicsCorrections={name: excess for name, excess in over.items() if excess > 0},
        vertGlyphVariants={root: [(name, boxes[name].yMax - boxes[name].yMin) for name in sizes]},
    )


@cache
def standalone(language: str) -> str:
    """Return the standalone file in a language, without its fonts."""
    command = [sys.executable, "-m", "ramanujan.standalone", "--language", language]
    file = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", check=True).stdout
    text = html.unescape(re.sub(r"base64,[^)]*", "", file))
    # The escapes of scripts and of style sheets.
    return re.sub(r"\\u?([0-9a-f]{4})", lambda escape: chr(int(escape[1], 16)), text)


def icons() -> TTFont:
    """Return Streamlit's font of icons, reduced to the icons of the app and of Streamlit. A name is a ligature."""
    own = [path.read_text(encoding="utf-8") for path in (ROOT / "ramanujan").rglob("*.py")]
    scripts = [path.read_text(encoding="utf-8") for path in (ORIGINALS.parent / "js").glob("*.js")]
    used = set(re.findall(r":material/([a-z0-9_]+):", "\n".join(own + scripts)))
    used.update(re.findall(r"['\"]([a-z0-9_]+)['\"]", "\n".join(own)))
    font = original_of("MaterialSymbols-Rounded")
    glyphs = ligatures(font)
    options = subset.Options(layout_closure=False, hinting=False, name_IDs=[*COPYRIGHT_AND_LICENCE, FAMILY])
    cutter = subset.Subsetter(options)
    drawn = [glyphs[name] for name in used & set(glyphs)]
    cutter.populate(text="abcdefghijklmnopqrstuvwxyz0123456789_ ", glyphs=drawn)
    cutter.subset(font)
    font.flavor = "woff2"
    return font


def ligatures(font: TTFont) -> dict[str, str]:
    """Return name → glyph of the icons of a font, read from its ligatures."""
    letters = {glyph: chr(code) for code, glyph in font.getBestCmap().items()}
    glyphs = {}
    for lookup in font["GSUB"].table.LookupList.Lookup:
        for table in lookup.SubTable:
            extended = getattr(table, "ExtSubTable", table)
            for first, rest in getattr(extended, "ligatures", {}).items():
                for ligature in rest:
                    name = "".join(letters[part] for part in (first, *ligature.Component))
                    glyphs[name] = ligature.LigGlyph
    return glyphs


def original_of(name: str) -> TTFont:
    """Return one of Streamlit's fonts."""
    [source] = ORIGINALS.glob(f"{name}.*.woff2")
    return TTFont(source)


def cut(original: str, axes: dict[str, object], codes: set[int]) -> TTFont:
    """Return one of Streamlit's fonts with only these characters."""
    font = _reload(instancer.instantiateVariableFont(original_of(original), axes))
    options = subset.Options(hinting=False, name_IDs=COPYRIGHT_AND_LICENCE, glyph_names=True)
    options.layout_features = ["kern", "mark"]
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=codes)
    cutter.subset(font)
    return font


def set_symbols(font: TTFont, italic: TTFont, upright: TTFont) -> None:
    """Add KaTeX's letters for symbols to a font, and centred dots over X and Φ.

    They have the same weight in bold text, as in KaTeX's formulas.
    """
    names = font.getBestCmap()
    italics, uprights = (each.getBestCmap() for each in (italic, upright))
    small, capital = range(0x3B1, 0x3CA), range(0x391, 0x3AA)
    for code in {ord(letter) for letter in LATIN + "a"} & names.keys():
        _put(font, f"{names[code]}.italic", italic, italics[code])
    for greek, source, known in ((small, italic, italics), (capital, upright, uprights)):
        for code in names.keys() & known.keys() & set(greek):
            _put(font, "mu.symbol" if code == 0x3BC else names[code], source, known[code])
    _put(font, names[PRIME], upright, uprights[PRIME], *RAISED)
    dotted = [("Phi", "Phi", 0), ("X", "X.italic", SLOPE)] if 0x307 in names else []
    for base, letter, slope in dotted:
        _put_dot(font, f"{base}.dot", letter, names[0x307], slope)
    for table in font["cmap"].tables:
        # Firefox prefers the precomposed character. The prefix µ (micro) is another character than the symbol μ.
        table.cmap |= {code: own for code, own in ((0x1E8A, "X.dot"), (0x3BC, "mu.symbol")) if code in table.cmap}
    letters = {code: name for code, name in names.items() if chr(code).isalpha() and code < 0x370}
    classes = {
        "letters": letters.values(),
        "small": (name for code, name in letters.items() if chr(code).islower()),
        "capitals": (name for code, name in letters.items() if chr(code) in LATIN and chr(code).isupper()),
        "digits": (name for code, name in names.items() if chr(code) in "0123456789"),
        "symbols": (names[ord(letter)] for letter in LATIN),
        "italics": (f"{names[ord(letter)]}.italic" for letter in LATIN),
    }
    dots = " ".join(f"sub {base} {names[0x307]} by {base}.dot;" for base, *_ in dotted)
    rules = SYMBOLS.format(
        dots=f"feature ccmp {{ {dots} }} ccmp;" if dots else "",
        prime=names[PRIME],
        thin_space=names.get(0x202F, "space"),
        **{key: " ".join(each) for key, each in classes.items()},
    )
    if "HVAR" in font:
        del font["HVAR"]
        add_HVAR(font)
    addOpenTypeFeaturesFromString(font, rules, ["GSUB"])


def _put(font: TTFont, name: str, source: TTFont, glyph: str, size: float = 1, up: float = 0) -> None:
    """Add a glyph of KaTeX to a font, in the size of a formula, with the same weight in every style."""
    pen = TTGlyphPen(None)
    scale = SCALE * size
    source.getGlyphSet()[glyph].draw(TransformPen(pen, (scale, 0, 0, scale, 0, SCALE * up * 1000)))
    font["glyf"][name] = pen.glyph()
    font["glyf"][name].recalcBounds(font["glyf"])
    font["hmtx"][name] = round(scale * source["hmtx"][glyph][0] + SCALE * BESIDE * up), font["glyf"][name].xMin
    if "gvar" in font:
        font["gvar"].variations[name] = []


def _put_dot(font: TTFont, name: str, letter: str, dot: str, slope: float) -> None:
    """Add a letter with a dot above its centre."""
    glyphs, (base, above) = font["glyf"], (font["glyf"][letter], font["glyf"][dot])
    up = base.yMax - font["OS/2"].sxHeight
    height = (above.yMin + above.yMax - base.yMin - base.yMax) / 2 + up
    across = (base.xMin + base.xMax - above.xMin - above.xMax) / 2 + slope * height
    pen = TTGlyphPen(glyphs.glyphs)
    pen.addComponent(letter, (1, 0, 0, 1, 0, 0))
    pen.addComponent(dot, (1, 0, 0, 1, round(across), up))
    glyphs[name], font["hmtx"][name] = pen.glyph(), font["hmtx"][letter]
    if "gvar" not in font:
        return
    # In bold text it has its letter's width: the last four deltas are those of the letter's frame.
    frames = [(each.axes, each.coordinates[-4:]) for each in font["gvar"].variations[letter]]
    font["gvar"].variations[name] = [TupleVariation(axes, [(0, 0), (0, 0), *frame]) for axes, frame in frames]


def code_points(name: str) -> set[int]:
    """Return the code points of a font in page.css."""
    rules = (PAGE / "page.css").read_text(encoding="utf-8")
    ranges = re.findall(rf"{name}\.woff2[^}}]*unicode-range: ([^;]+);", rules)
    ends = (part.removeprefix("U+").partition("-") for part in ", ".join(ranges).split(", "))
    return {code for first, _, last in ends for code in range(int(first, 16), int(last or first, 16) + 1)}


def _reload(font: TTFont) -> TTFont:
    """Save a font and load it again, so that all of its tables are reduced to the instance."""
    file = io.BytesIO()
    font.flavor = None
    font.save(file)
    file.seek(0)
    return TTFont(file)


if __name__ == "__main__":
    main()
