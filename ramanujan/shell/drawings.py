"""Figures for pages, and still drawings for paper."""

from base64 import b64encode
from typing import Any

import streamlit as st
from plotly.basedatatypes import BaseFigure

from ramanujan.figures import enlarge_letters
from ramanujan.shell import display_mode
from ramanujan.text.translation import LANGUAGE, _

STILL = {"displaylogo": False, "modeBarButtons": [["toImage"]], "scrollZoom": False}
"""Plotly's options for a figure with a download button as its only button, and without scroll zoom."""


# Plotly's own texts in a figure: its buttons, and the notes about a saved file and a zoom.
_PLOTLY_WORDS = {
    "Download plot": _("Save the figure"),
    "Autoscale": _("Show everything"),
    "Reset axes": _("Reset axes"),
    "Zoom": _("Zoom"),
    "Pan": _("Pan"),
    "Zoom in": _("Zoom in"),
    "Zoom out": _("Zoom out"),
    "Double-click to zoom back out": _("Double-click to zoom back out"),
    "Preparing image - this may take a few seconds": _("The image is being prepared. This may take a few seconds."),
    "Image download succeeded": _("The image was saved."),
}
_LOCALE = {"locale": LANGUAGE, "locales": {LANGUAGE: {"dictionary": _PLOTLY_WORDS}}}


def plot(figure: BaseFigure, key: str, alt: str, *, config: dict[str, Any] = STILL, **options: Any) -> None:
    """Draw a figure, which can be saved as PNG and grows with the screen (type.css).

    Parameters
    ----------
    figure : Plotly figure
    key : key of the element
    alt : its text alternative
    config, options : arguments of Plotly and of `st.plotly_chart`
    """
    is_projector = display_mode.is_projector()
    download = {"toImageButtonOptions": {"format": "png", "filename": f"ramanujan-{key}", "scale": 3}}
    st.plotly_chart(
        enlarge_letters(figure) if is_projector else figure,
        height="stretch" if is_projector else "content",
        theme=None,
        key=key,
        config=_LOCALE | download | config,
        alt=alt,
        **options,
    )


def draw(svg: str, *, alt: str, style: str) -> None:
    """Draw an SVG as an image, so that no style of the page applies to it.

    Parameters
    ----------
    svg : the drawing
    alt : its text alternative; empty if another element of the page contains it
    style : CSS rules for its position and width
    """
    source = f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"
    # Streamlit's own rule, object-fit: scale-down, never draws an image larger than its size in the file. WebKit
    # assumes a small one for an SVG.
    style = f"object-fit:contain;{style}"
    st.markdown(f'<img alt="{alt}" src="{source}" style="{style}">', unsafe_allow_html=True)
