"""A figure as the dictionary that a page sends, without the checks of `go.Figure`.

Plotly checks every property when a figure is made, and again when it is sent. For two panels that takes tens of
milliseconds, many times as long as computing the numbers. Every figure is therefore written as the dictionary
that Plotly would produce. A test lets Plotly check each of them.
"""

import base64
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import plotly.graph_objects as go
from plotly.basedatatypes import BaseFigure

_TYPES = {"float32": "f4", "float64": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "int32": "i4"}
"""NumPy's name of a number type → Plotly's, for arrays that are sent as bytes."""


class Drawn(BaseFigure):
    """A finished figure: `to_dict` returns what is sent. Streamlit accepts it as a figure of Plotly's."""

    def __init__(self, sent: dict[str, Any]) -> None:
        # The base class would check, copy and index every property.
        self._sent = sent

    def to_dict(self) -> dict[str, Any]:
        """Return the figure's dictionary, the same at every call; it must not be changed."""
        return self._sent

    def checked(self) -> go.Figure:
        """Return the figure as Plotly checks it; a property that Plotly does not know raises ValueError."""
        return go.Figure(self._sent)

    def __repr__(self) -> str:
        return f"Drawn({len(self._sent['data'])} traces)"


def drawn(traces: Iterable[Mapping[str, Any]], layout: Mapping[str, Any]) -> Drawn:
    """Return a figure of these traces; their arrays become Plotly's typed arrays, bytes in base 64."""
    data = [{name: _typed(value) for name, value in trace.items()} for trace in traces]
    return Drawn({"data": data, "layout": dict(layout)})


def line(x: Any, y: Any, **look: Any) -> dict[str, Any]:
    """Return a trace that joins points; color, width, dash and shape are the look of its line."""
    return {"type": "scatter", "x": x, "y": y, "mode": "lines", "line": look}


def marks(x: Any, y: Any, symbol: str, size: float, fill: str, **outline: Any) -> dict[str, Any]:
    """Return a trace of marks at points; color and width are the look of their outlines."""
    marker = {"symbol": symbol, "size": size, "color": fill} | ({"line": outline} if outline else {})
    return {"type": "scatter", "x": x, "y": y, "mode": "markers", "marker": marker}


def _typed(value: Any) -> Any:
    if not isinstance(value, np.ndarray) or value.dtype.name not in _TYPES:
        return value
    little = value.astype(value.dtype.newbyteorder("<"), copy=False)
    return {"dtype": _TYPES[value.dtype.name], "bdata": base64.b64encode(little.tobytes()).decode()}
