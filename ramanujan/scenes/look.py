"""How pages look beyond the theme: its colours for figures (they are set in .streamlit/config.toml) and the margins."""

from __future__ import annotations

from functools import cache

import streamlit as st

BODY_COLORS = {
    "block": "gray",
    "hoop": "orange",
    "cylinder": "blue",
    "slab": "green",
    "spring": "violet",
    "top": "red",
}
"""Body → Streamlit's name of its colour: Markdown writes :orange[…], the stage var(--st-orange-color)."""

_OPTIONS = {
    "ink": "textColor",
    "paper": "backgroundColor",
    "faint": "borderColor",
    "primary": "primaryColor",
    **{body: f"{color}Color" for body, color in BODY_COLORS.items()},
    **{f"{body}_ink": f"{color}TextColor" for body, color in BODY_COLORS.items()},
}


def theme() -> str:
    """Return the theme that the visitor sees: light or dark."""
    return st.context.theme.type or "light"


def colors() -> dict[str, str]:
    """Return the theme's colours by use: ink, paper, faint, primary, and one (and its ink) for each body."""
    return _colors(theme())


@cache
def _colors(shown: str) -> dict[str, str]:
    # To ask for an option takes a tenth of a millisecond, and a page asks for all of them several times a run.
    fallback = {"ink": "#808080", "paper": "rgba(0,0,0,0)", "faint": "rgba(128,128,128,0.3)"}
    return {
        use: st.get_option(f"theme.{shown}.{option}") or fallback.get(use, "#808080")
        for use, option in _OPTIONS.items()
    }


def tighten() -> None:
    """Take Streamlit's wide margins away, so that the machine stands on the first screen of a projector.

    This hangs on class names of the page; where they change, the margins are wide again and nothing else happens.
    """
    st.html(
        "<style>.stMainBlockContainer{padding:3.25rem 2.5rem 3rem}"
        "@media(max-width:760px){.stMainBlockContainer{padding:3.25rem 1rem 2rem}}"
        ".stMarkdown .katex-display{margin:.35em 0}"
        ".st-key-steps .katex-display{overflow:auto hidden;padding-bottom:.4em}"
        ".st-key-steps .katex-display>.katex{text-align:left}.stMarkdown h5{padding-top:1.1rem}"
        "[data-testid=stSidebarUserContent]{padding-top:0}</style>"
    )
