"""Colours of the theme in .streamlit/config.toml, for figures and for drawings on paper."""

from functools import cache

import streamlit as st
from plotly.colors import find_intermediate_color, hex_to_rgb, label_rgb

BODY_COLORS = {"block": "gray", "hoop": "orange", "cylinder": "blue", "slab": "green", "spring": "violet", "top": "red"}
"""Body → Streamlit's name of its colour. Markdown contains :orange[…], and the stage var(--st-orange-color)."""

_OPTIONS = {
    "ink": "textColor",
    "paper": "backgroundColor",
    "faint": "borderColor",
    "primary": "primaryColor",
    **{body: f"{color}Color" for body, color in BODY_COLORS.items()},
    **{f"{body}_ink": f"{color}TextColor" for body, color in BODY_COLORS.items()},
}

_GRAY = "#808080"


def current() -> str:
    """Return the theme that the visitor sees: light or dark."""
    return st.context.theme.type or "light"


def colors() -> dict[str, str]:
    """Return the theme's colours by use: ink, paper, faint, primary, and each body with its ink."""
    return _colors(current())


@cache
def _colors(theme: str) -> dict[str, str]:
    # Cached, because a call of `st.get_option` takes 0.1 ms and a page reads all options several times in a run.
    # A test that runs in another folder finds no .streamlit/config.toml.
    fallback = {"paper": "rgba(0,0,0,0)", "faint": "rgba(128,128,128,0.3)"}
    return {
        use: st.get_option(f"theme.{theme}.{option}") or fallback.get(use, _GRAY) for use, option in _OPTIONS.items()
    }


@cache
def paper_colors() -> dict[str, str]:
    """Return body → its colour in drawings for paper, which is light enough for letters on it."""
    light = _colors("light")
    white = (255, 255, 255)
    colors = {}
    for body in BODY_COLORS:
        mixed = find_intermediate_color(hex_to_rgb(light[body]), white, 0.56)
        colors[body] = label_rgb(mixed)
    return colors
