"""Still drawings on a page, for paper: SVG as an image, which no style of the page reaches."""

from __future__ import annotations

from base64 import b64encode

import streamlit as st


def draw(svg: str, *, alt: str, style: str) -> None:
    """Put a drawing on the page.

    Parameters
    ----------
    svg : the drawing
    alt : its text alternative; empty where something else on the page says it
    style : rules for its place and size
    """
    source = f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"
    st.markdown(f'<img alt="{alt}" src="{source}" style="{style}">', unsafe_allow_html=True)
