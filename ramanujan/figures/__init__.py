"""Plotly figures from arrays, with one function for each figure, and their common look.

The caller passes the numbers and the colours; these functions compute neither physics nor themes. Every figure fits a
phone: labels are anchored inside the axes and do not overlap.

Plotly validates every property when a figure is created, and again when it is sent. For two panels this takes tens of
milliseconds, many times as long as the computation of the numbers. These functions therefore return the dictionary that
Plotly would produce. A test validates each of them with Plotly.
"""

import base64
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from plotly.basedatatypes import BaseFigure

from ramanujan.text.numerals import DECIMAL, THIN
from ramanujan.text.translation import _

MASS_RATIO = _("mass ratio <i>ε</i> = <i>m</i>′/<i>m</i>")
NORMALIZED = "Ω²<i>m</i>/<i>k</i>"
"""The axes of the curve of Ω². Symbols are italic, as in formulas: capital Greek letters and units are upright."""
NO_NAME = "<extra></extra>"
"""The end of a hover text, to omit the name of the curve, which Plotly adds by default."""

_FAMILY = '"Source Sans", sans-serif'
"""The typeface of the page, from page.css."""


def template(colors: Mapping[str, str], hover: str | None = None) -> dict[str, Any]:
    """Return the common look of all figures: no box, a faint grid, room for labels.

    Parameters
    ----------
    colors : ink, faint, paper and primary
    hover : the text for a point under the pointer, unless a trace has its own
    """
    axis = {
        "showgrid": True,
        "gridcolor": colors["faint"],
        "zeroline": False,
        "showline": True,
        "linecolor": colors["ink"],
        "ticks": "outside",
        "title": {"standoff": 6, "font": {"size": 14}},
        "automargin": True,
    }
    shadow_offsets = ("2px 0", "-2px 0", "0 2px", "0 -2px")
    layout = {
        "font": {"color": colors["ink"], "size": 14, "family": _FAMILY},
        # With the background of the page, a figure saved in the dark theme is legible.
        "paper_bgcolor": colors["paper"],
        "plot_bgcolor": "rgba(0,0,0,0)",
        "margin": {"l": 56, "r": 16, "t": 12, "b": 48},
        "xaxis": axis,
        "yaxis": axis,
        "modebar": {"bgcolor": colors["paper"], "color": colors["ink"], "activecolor": colors["primary"]},
        "hoverlabel": {"bgcolor": colors["paper"], "font": {"color": colors["ink"]}},
        "separators": DECIMAL + THIN,
        # The shadow separates the letters of a label from lines, also in a saved file. Blur would darken dark paper.
        "annotationdefaults": {
            "font": {"shadow": ", ".join(f"{offset} {colors['paper']}" for offset in shadow_offsets)}
        },
    }
    scatter = {"type": "scatter"}
    if hover:
        scatter["hovertemplate"] = hover
    return {"layout": layout, "data": {"scatter": [scatter]}}


def build_figure(
    traces: Iterable[Mapping[str, Any]], colors: Mapping[str, str], height: int, hover: str | None = None, **layout: Any
) -> "EncodedFigure":
    """Return a figure in the common look.

    Parameters
    ----------
    traces : from `line` and `marks`, or any Plotly traces
    colors, hover : as in `template`
    height : of the figure [px]
    layout : further layout properties of Plotly
    """
    return encode_figure(traces, {"template": template(colors, hover), "height": height, "showlegend": False, **layout})


WITHOUT_HOVER = {"hoverinfo": "skip", "hovertemplate": ""}
"""Properties of a trace that the pointer does not find. The template's hover text would override the first one."""

_TYPES = {"float32": "f4", "float64": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "int32": "i4"}
"""NumPy dtype → Plotly dtype, for arrays in bytes."""


class EncodedFigure(BaseFigure):
    """A finished figure, which Streamlit accepts as a Plotly figure; `to_dict` returns its dictionary."""

    def __init__(self, sent: dict[str, Any]) -> None:
        # The constructor of the base class would validate, copy and index every property.
        self._sent = sent

    def to_dict(self) -> dict[str, Any]:
        """Return the figure's dictionary, which is the same object at every call and must not be modified."""
        return self._sent

    def __repr__(self) -> str:
        return f"EncodedFigure({len(self._sent['data'])} traces)"


def note(name: str, color: str | None, x: float, y: float) -> dict[str, Any]:
    """Return an annotation without an arrow, by default in the colour of the figure's text."""
    font = {"size": 13} | ({"color": color} if color else {})
    words = {"text": name, "font": font, "showarrow": False, "borderpad": 0}
    return words | {"x": float(x), "y": float(y), "xref": "x", "yref": "y"}


def spread(heights: Sequence[float], halves: Sequence[float], low: float, high: float) -> list[float]:
    """Return heights of names near the ends of their lines, without overlaps and between two edges.

    Parameters
    ----------
    heights : of the ends, from top to bottom
    halves : half the height of each name
    low, high : the edges

    >>> spread([9.0, 4.0, 4.0, 0.0], [1.0] * 4, 0.0, 10.0)
    [9.0, 5.0, 3.0, 1.0]
    """
    places = list(heights)
    # Move neighbours apart by equal distances until no two names overlap.
    for _step in range(200):
        for n in range(1, len(places)):
            overlap = max(0.0, places[n] + halves[n] + halves[n - 1] - places[n - 1])
            places[n - 1] += overlap / 2
            places[n] -= overlap / 2
        places[0] = min(places[0], high - halves[0])
        places[-1] = max(places[-1], low + halves[-1])
    return places


def encode_figure(traces: Iterable[Mapping[str, Any]], layout: Mapping[str, Any]) -> EncodedFigure:
    """Return a figure with these traces; NumPy arrays become Plotly's typed arrays, bytes in base 64."""
    data = [{name: _encode(value) for name, value in trace.items()} for trace in traces]
    return EncodedFigure({"data": data, "layout": dict(layout)})


def line(x: Any, y: Any, **look: Any) -> dict[str, Any]:
    """Return a trace of joined points; color, width, dash and shape are properties of its line."""
    return {"type": "scatter", "x": x, "y": y, "mode": "lines", "line": look}


def marks(x: Any, y: Any, symbol: str, size: float, fill: str, **outline: Any) -> dict[str, Any]:
    """Return a trace of marks at points; color and width are properties of their outlines."""
    marker = {"symbol": symbol, "size": size, "color": fill} | ({"line": outline} if outline else {})
    return {"type": "scatter", "x": x, "y": y, "mode": "markers", "marker": marker}


_HEIGHT_BEFORE_GROWTH = 400
"""The largest height of a figure before it grows with the free space of a slide [px]."""
_TITLE_LENGTH = 18
"""The number of letters of an axis title that fit beside a panel."""
_MARGIN_ABOVE, _MARGIN_WITH_WORDS = 24, 54
"""The margin above the panels [px], without and with a line of words.

Without a margin Plotly omits the uppermost tick label.
"""
_LETTER_SIZE = 26
"""The size of letters for Plotly's layout [px]; type.css does not change it, and projector.css sets 20 to 39 px."""


def enlarge_letters(figure: BaseFigure) -> EncodedFigure:
    """Return the figure with room for large letters, and at most 400 px high.

    On a slide the figure then grows with the free space.

    >>> from ramanujan.figures import encode_figure
    >>> sent = encode_figure([], {"height": 620, "yaxis": {"title": {"text": "displacement relative to the block"}}})
    >>> layout = enlarge_letters(sent).to_dict()["layout"]
    >>> layout["height"], layout["yaxis"]["title"]["text"]
    (400, 'displacement relative<br>to the block')
    """
    sent = figure.to_dict()
    height = sent["layout"].get("height", _HEIGHT_BEFORE_GROWTH)
    layout = {**sent["layout"], "height": min(height, _HEIGHT_BEFORE_GROWTH)}
    axes = [name for name in layout if name.startswith(("xaxis", "yaxis"))]
    for name in axes:
        layout[name] = _enlarge_axis(layout[name], is_vertical=name.startswith("yaxis"))
    # Plotly caches the width of a text by its size. A new size forces a new measurement after a switch to a projector.
    notes = [{**note, "font": {**note.get("font", {}), "size": _LETTER_SIZE}} for note in layout.get("annotations", ())]
    has_note_above = any(note.get("yref") == "paper" and note["y"] == 1 for note in notes)
    margin_above = _MARGIN_WITH_WORDS if has_note_above else _MARGIN_ABOVE
    layout |= {"annotations": notes, "margin": {**layout.get("margin", {}), "t": margin_above}}
    return EncodedFigure({**sent, "layout": layout})


def _enlarge_axis(axis: dict[str, Any], is_vertical: bool) -> dict[str, Any]:
    # The standoff separates the first labels of both axes.
    axis = {**axis, "ticklabelstandoff": 6, "tickfont": {"size": _LETTER_SIZE}}
    text = axis.get("title", {}).get("text", "")
    if not text:
        return axis
    title = _break_title(text) if is_vertical else text
    # Plotly ignores the exponent of a power of ten and underestimates the height of a second line.
    has_powers = axis.get("type") == "log" or any("<sup>" in label for label in axis.get("ticktext", ()))
    standoff = 12
    if is_vertical and has_powers:
        standoff += 18
    if "<br>" in title:
        standoff += 28
    axis["title"] = {**axis["title"], "text": title, "standoff": standoff, "font": {"size": _LETTER_SIZE}}
    return axis


def without_tags(text: str) -> str:
    """Return a text of a figure without its HTML tags."""
    return re.sub("<.*?>", "", text)


def _break_title(text: str) -> str:
    """Break a long title once, at the space nearest to its middle."""
    if len(without_tags(text)) <= _TITLE_LENGTH or "<br>" in text:
        return text
    spaces = [index for index, letter in enumerate(text) if letter == " "]
    middle = min(spaces, key=lambda index: abs(index - len(text) / 2), default=None)
    return text if middle is None else f"{text[:middle]}<br>{text[middle + 1 :]}"


def _encode(value: Any) -> Any:
    """Return an array as Plotly's typed array, and any other value unchanged."""
    if not isinstance(value, np.ndarray) or value.dtype.name not in _TYPES:
        return value
    little_endian = value.astype(value.dtype.newbyteorder("<"), copy=False)
    return {"dtype": _TYPES[value.dtype.name], "bdata": base64.b64encode(little_endian.tobytes()).decode()}
