"""Readable and distinct colours of texts and bodies, and the icons in the font."""

import re
import warnings
from itertools import combinations

import numpy as np
import pytest
from daltonlens import convert, simulate
from fontTools.ttLib import TTFont

from ramanujan.shell.menu import PAGES
from ramanujan.shell.theme import BODY_COLORS
from tests.checks.bare import THEME
from tests.checks.browser import ROOT
from tests.checks.look import rgb
from tests.fonts import PAGE, ligatures


def luminance(color: str) -> float:
    """Return the relative luminance of WCAG 2.2."""
    parts = [part / 255 for part in rgb(color)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: str, b: str) -> float:
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_text_and_controls_have_contrast_aa(theme):
    for ink in ("textColor", "primaryColor", *(f"{color}TextColor" for color in BODY_COLORS.values())):
        for paper in ("backgroundColor", "secondaryBackgroundColor"):
            assert contrast(THEME[theme][ink], THEME[theme][paper]) >= 4.5, ink


EYES = {
    "Brettel, Viénot and Mollon 1997": simulate.Simulator_Brettel1997(convert.LMSModel_sRGB_SmithPokorny75()),
    "Machado, Oliveira and Fernandes 2009": simulate.Simulator_Machado2009(),
}


def differences(colors: list[str], model: str, deficiency: simulate.Deficiency | None) -> list[float]:
    """Return CIEDE2000 of each pair of colours, for an eye without one kind of cone, or for a normal eye."""
    with warnings.catch_warnings():  # warnings about the library's plotting functions
        warnings.simplefilter("ignore")
        import colour
    image = np.array([[rgb(color) for color in colors]], dtype=np.uint8)
    if deficiency is not None:
        image = EYES[model].simulate_cvd(image, deficiency, 1.0)
    lab = colour.XYZ_to_Lab(colour.sRGB_to_XYZ(image[0] / 255))
    return [float(colour.delta_E(lab[i], lab[j], method="CIE 2000")) for i, j in combinations(range(len(colors)), 2)]


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("kind", ["Color", "TextColor"])
@pytest.mark.parametrize("deficiency", [None, *simulate.Deficiency])
def test_the_colours_of_bodies_differ_for_colour_blind_readers(theme, kind, deficiency):
    colors = [THEME[theme][f"{color}{kind}"] for color in BODY_COLORS.values()]
    for model in EYES:
        apart = dict(zip(combinations(BODY_COLORS, 2), differences(colors, model, deficiency), strict=True))
        assert min(apart.values()) >= 10, (model, min(apart, key=apart.get))


def test_the_icon_font_contains_every_icon():
    sources = [path.read_text(encoding="utf-8") for path in (ROOT / "ramanujan").rglob("*.py")]
    named = set(re.findall(r":material/(\w+):", "".join(sources))) | {page.icon for page in PAGES.values()}
    assert len(named) > 20
    icons = PAGE / "icons.woff2"
    assert named <= set(ligatures(TTFont(icons)))
    assert icons.stat().st_size < 20_000
