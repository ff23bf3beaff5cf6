"""Axes, marks and ranges of the logarithmic figures of errors and costs on the speed page."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ramanujan.figures import WITHOUT_HOVER, line

Colors = Mapping[str, str]

SYMBOLS = ("circle", "square", "diamond", "triangle-up", "triangle-down", "pentagon", "hexagon2")
"""The symbols of the methods, in order."""


def axis(title: str, ends: Sequence[float], **more: Any) -> dict[str, Any]:
    """Return an axis in the common look, with its title and its range in Plotly's units."""
    look = {"tickfont": {"size": 12}, "ticklabelstandoff": 3, "exponentformat": "power", "fixedrange": True}
    return {"title": {"text": title, "standoff": 8}, "range": list(ends), **look, **more}


def log_axis(title: str, limits: tuple[float, float], decades: int = 1) -> dict[str, Any]:
    """Return a logarithmic axis with a line at every power of ten, or after several decades."""
    return axis(title, np.log10(limits).tolist(), type="log", dtick=decades)


def level_line(ends: Sequence[float], level: float, name: str, colors: Colors) -> dict[str, Any]:
    """Return a horizontal line for comparison with the curves."""
    trace = line(list(ends), [level] * 2, color=colors["ink"], dash="dash", width=1.5)
    return trace | {"name": name, **WITHOUT_HOVER}


def select_drawable(values: np.ndarray, upper: float) -> np.ndarray:
    """Return the values in single precision; nonpositive and very large values become NaN, a gap in the curve.

    Parameters
    ----------
    values : the values of a curve
    upper : the upper end of its axis. Values up to a thousand times this remain, so the curve leaves the figure.
    """
    values = np.asarray(values, float)
    is_drawn = (values > 0) & (values <= 1e3 * upper)
    return np.where(is_drawn, values, np.nan).astype(np.float32)
