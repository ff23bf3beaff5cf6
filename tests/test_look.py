"""One colour for each body, everywhere, and readable: the theme, the stage's style sheet and the figures agree."""

from __future__ import annotations

import re
import tomllib

import pytest

from ramanujan.scenes.look import BODY_COLORS
from tests.browser import ROOT

THEME = tomllib.loads((ROOT / ".streamlit" / "config.toml").read_text())["theme"]
STYLE = (ROOT / "ramanujan" / "stage" / "stage.css").read_text()


def luminance(color: str) -> float:
    """WCAG 2.2, relative luminance."""
    parts = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: str, b: str) -> float:
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize(("body", "color"), BODY_COLORS.items())
def test_the_stage_takes_a_body_s_colour_from_the_theme(body, color):
    assert re.search(rf"--{body}: var\(--st-{color}-color\)", STYLE)
    assert re.search(rf"--{body}-ink: var\(--st-{color}-text-color\)", STYLE)
    assert f"color: var(--{body})" in STYLE or body == "spring"


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("color", BODY_COLORS.values())
def test_words_in_a_body_s_colour_have_contrast_aa(theme, color):
    for paper in ("backgroundColor", "secondaryBackgroundColor"):
        assert contrast(THEME[theme][f"{color}TextColor"], THEME[theme][paper]) >= 4.5


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("ink", ["textColor", "primaryColor"])
def test_text_and_controls_have_contrast_aa(theme, ink):
    for paper in ("backgroundColor", "secondaryBackgroundColor"):
        assert contrast(THEME[theme][ink], THEME[theme][paper]) >= 4.5


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_no_two_bodies_share_a_colour(theme):
    colors = [THEME[theme][f"{color}Color"] for color in BODY_COLORS.values()]
    assert len(set(colors)) == len(BODY_COLORS)
