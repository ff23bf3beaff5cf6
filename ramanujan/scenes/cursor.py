"""The time cursor: one instant, marked in every figure of the page, moved by pointer or keys without the server.

A figure takes part by its layout's `meta`: cursor ("time": t runs to the right; "orbit": points at equal steps of
time), period [s] and periods, the number of them that it shows. What is marked is the figure's own data.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

from ramanujan.scenes.scripts import script

_HTML = (
    '<label class="cursor"><span>Time cursor</span><input type="range" min="0" max="1" step="0.001" value="0.125">'
    '<output aria-hidden="true"></output></label>'
)
_CSS = """
.cursor { display: flex; flex-wrap: wrap; align-items: center; gap: 0 .75rem; color: var(--st-text-color);
  font: 400 14px/1.4 var(--st-font); }
.cursor span { white-space: nowrap; }
input { flex: 1 1 10rem; min-width: 5rem; height: 1.75rem; margin: 0; accent-color: var(--st-primary-color); }
input:focus-visible { outline: 3px solid var(--st-primary-color); outline-offset: 2px; }
output { min-width: 11.5em; font-variant-numeric: tabular-nums; }
"""


def cursor() -> Any:
    """Put the slider of the cursor on the page; call it once, beside the figures."""
    return _component()(key="cursor")


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_cursor", html=_HTML, css=_CSS, js=script("marks.js", "cursor.js"))
