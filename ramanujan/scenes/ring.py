"""The ring around the present machine on a curve: it moves with the stage, and the figure under it never changes.

A figure takes part by its layout's `meta`: ring is the colour. Its axes are the mass ratio ε and Ω²m/k.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

from ramanujan.scenes.scripts import script


def ring() -> Any:
    """Let the ring follow the stage of the page; call it once, beside the figure."""
    return _component()(key="ring")


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_ring", js=script("marks.js", "ring.js"))
