"""Logarithmic figures of errors and costs: the axes, marks and ranges that those of the speed page share."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ramanujan.figures import Drawn, drawn, template
from ramanujan.numerals import number
from ramanujan.translation import _

Colors = Mapping[str, str]

_LOOKS = (
    ("top", "circle"),
    ("hoop", "square"),
    ("cylinder", "diamond"),
    ("slab", "triangle-up"),
    ("spring", "triangle-down"),
    ("primary", "pentagon"),
    ("block", "hexagon2"),
)
"""Colour and symbol of the first, second, … method or form: each differs from the others in both."""

EXTRA = "<extra>%{fullData.name}</extra>"
"""Plotly's second box, which names the curve."""

AFTER = _("after {periods} periods: {error}")

TICKS = {"tickfont": {"size": 12}, "automargin": True, "exponentformat": "power"}

UPPER = {"domain": [0.54, 1.0]}

LOWER = {"domain": [0.0, 0.46], "anchor": "x"}


def laid_out(traces: list[dict[str, Any]], colors: Colors, height: int, **axes: Any) -> Drawn:
    """Return the traces in the common look."""
    layout = {"template": template(colors), "height": height, "showlegend": True, **axes}
    layout["legend"] = {"orientation": "h", "y": -0.16, "yanchor": "top", "x": 0, "font": {"size": 13}}
    layout["legend"] |= {"itemclick": False, "itemdoubleclick": False}
    layout["margin"] = {"l": 60, "r": 12, "t": 12, "b": 20}
    return drawn(traces, layout)


def look_of(index: int, colors: Colors) -> tuple[str, str]:
    color, symbol = _LOOKS[index % len(_LOOKS)]
    return colors[color], symbol


def log_axis(title: str, shown: tuple[float, float]) -> dict[str, Any]:
    low, high = np.log10(shown)
    step = max(1, int(np.ceil((high - low) / 6)))
    range_ = [float(low), float(high)]
    axis = {"type": "log", "title": axis_title(title), "range": range_, "dtick": step, "fixedrange": True}
    return {**axis, **TICKS}


def level_line(ends: Sequence[float], level: float, name: str, colors: Colors) -> dict[str, Any]:
    """Return a level for comparison with the curves."""
    line = {"color": colors["ink"], "dash": "dash", "width": 1.5}
    trace = {"type": "scatter", "x": list(ends), "y": [level] * 2, "mode": "lines", "line": line}
    return {**trace, "name": name, "hoverinfo": "skip"}


def axis_title(text: str) -> dict[str, Any]:
    return {"text": text, "standoff": 8, "font": {"size": 14}}


def power_axis(title: str, low: float, high: float, ticks: int = 6) -> dict[str, Any]:
    """Return a linear axis of exponents whose ticks read 10ⁿ."""
    low, high = float(low), float(high)
    step = next(s for s in (1, 2, 3, 5, 10, 15, 20, 50, 100) if (high - low) / s <= ticks or s == 100)
    values: list[float] = [n for n in range(-400, 401) if n % step == 0 and low <= n <= high]
    texts = [f"10<sup>{n}</sup>".replace("-", "−") for n in values]
    if high - low < 2:
        # Powers of ten alone would give such an axis fewer than two ticks.
        marks = [mantissa * 10.0**n for n in range(int(low) - 1, int(high) + 2) for mantissa in (1, 2, 5)]
        values, texts = [float(np.log10(mark)) for mark in marks], [number(mark, 1) for mark in marks]
    return {
        "title": axis_title(title),
        "range": [low, high],
        "tickvals": values,
        "ticktext": texts,
        "fixedrange": True,
        **TICKS,
    }


def within(values: np.ndarray, shown: tuple[float, float]) -> np.ndarray:
    """Return the values in single precision; a value that a logarithmic axis cannot show becomes a gap."""
    values = np.asarray(values, float)
    top = 1e3 * shown[1]
    return np.where((values > 0) & (values <= top), values, np.nan).astype(np.float32)


def shown_range(curves: Iterable[np.ndarray], shown: tuple[float, float]) -> tuple[float, float]:
    """Return the range of an axis: all positive finite values, within the given limits."""
    # There are no values while the first run is still in progress.
    values = np.concatenate([np.empty(0), *curves])
    values = values[np.isfinite(values) & (values > 0)]
    low, high = (values.min(), values.max()) if values.size else shown
    return max(shown[0], float(low) / 2), max(min(shown[1], float(high) * 2), 10 * shown[0])


def logarithm(values: np.ndarray) -> np.ndarray:
    """Return log₁₀ in single precision, NaN where it does not exist."""
    values = np.asarray(values, float)
    good = (values > 0) & np.isfinite(values)
    return np.where(good, np.log10(np.where(good, values, 1.0)), np.nan).astype(np.float32)
