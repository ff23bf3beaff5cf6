"""Axes, marks and ranges of the logarithmic figures of errors and costs on the speed page."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ramanujan.figures import line

Colors = Mapping[str, str]
Scale = Callable[[np.ndarray], np.ndarray]

_SYMBOLS = ("circle", "square", "diamond", "triangle-up", "triangle-down", "pentagon", "hexagon2")
"""The symbols of the methods, in order."""
_COMPRESSION = 8
"""The factor by which the lower decades of an axis are compressed."""
_LEAST_GAP = 4
"""The smallest gap between two curves that makes an axis compressed [decades]."""


def method_look(index: int, colors: Colors) -> tuple[str, str]:
    """Return the colour and the symbol of a method."""
    return colors[f"method_{index}"], _SYMBOLS[index]


def axis(title: str, ends: Sequence[float], **more: Any) -> dict[str, Any]:
    """Return an axis in the common look, with its title and its range in Plotly's units."""
    look = {"tickfont": {"size": 12}, "ticklabelstandoff": 3, "exponentformat": "power", "fixedrange": True}
    return {"title": {"text": title, "standoff": 8}, "range": list(ends), **look, **more}


def log_axis(title: str, limits: tuple[float, float]) -> dict[str, Any]:
    """Return a logarithmic axis with at most seven ticks."""
    low, high = np.log10(limits).tolist()
    return axis(title, (low, high), type="log", dtick=max(1, math.ceil((high - low) / 6)))


def level_line(ends: Sequence[float], level: float, name: str, colors: Colors) -> dict[str, Any]:
    """Return a horizontal line for comparison with the curves."""
    trace = line(list(ends), [level] * 2, color=colors["ink"], dash="dash", width=1.5)
    return trace | {"name": name, "hoverinfo": "skip"}


def axis_with_room(title: str, curves: Sequence[np.ndarray], most: float) -> tuple[dict[str, Any], Scale, float]:
    """Return an axis of exponents, the function that places values on it, and the upper end of its compressed part.

    If some curves, such as rounding errors, are far below the others, the lower decades are compressed.

    Parameters
    ----------
    title : of the axis
    curves : the values of each curve
    most : the largest exponent on the axis
    """
    exponents = [values[np.isfinite(values)] for values in map(logarithm, curves)]
    exponents = [values for values in exponents if values.size] or [np.array([-1.0, 0.0])]
    least = min(map(np.min, exponents))
    high = min(most, max(map(np.max, exponents)))
    threshold = _find_compressed_end(exponents, least)

    def place(values: np.ndarray) -> np.ndarray:
        exponent = logarithm(values)
        compressed = threshold + (exponent - threshold) / _COMPRESSION
        return np.where(exponent < threshold, compressed, exponent).astype(np.float32)

    bottom = min(threshold, float(place(np.array([10.0**least]))[0]))
    step = max(1, round((high - threshold) / 3))
    # One tick in the compressed part, if it has more than three decades. It replaces the tick at the end of this part.
    lowest_tick = [int(least)] if least < threshold - 3 else []
    first_tick = int(threshold) + step if lowest_tick else int(threshold)
    other_ticks = [*range(first_tick, int(np.ceil(high)) + 1, step)]
    ticks = {
        "tickvals": [threshold + (exponent - threshold) / _COMPRESSION for exponent in lowest_tick] + other_ticks,
        "ticktext": _powers(lowest_tick + other_ticks),
    }
    # An axis with few decades has a tick at its end, too. The font size is that of Plotly's logarithmic axes.
    top = high + 0.2 if step > 1 else np.ceil(high) + 0.05
    lower_end = bottom - 0.2 if bottom < threshold else threshold
    return axis(title, (lower_end, top), tickfont={"size": 15}, **ticks), place, threshold


def _find_compressed_end(exponents: Sequence[np.ndarray], least: float) -> float:
    """Return the exponent below which an axis is compressed; without a wide gap between curves, the lower end."""
    medians = np.sort([np.median(values) for values in exponents])
    gaps = np.diff(medians)
    if gaps.size:
        widest = int(np.argmax(gaps))
        if gaps[widest] >= _LEAST_GAP:
            return float(np.floor(medians[widest + 1]) - 1)
    return float(np.floor(least))


def _powers(exponents: Iterable[int]) -> list[str]:
    return [f"10<sup>{n}</sup>".replace("-", "−") if n else "1" for n in exponents]


def power_axis(title: str, low: float, high: float) -> dict[str, Any]:
    """Return a linear axis of exponents with the tick labels 10ⁿ."""
    step = next(step for step in (10, 20, 50, 100) if (high - low) / step <= 6)
    values = [n for n in range(-400, 401, step) if low <= n <= high]
    return axis(title, (low, high), tickvals=values, ticktext=_powers(values))


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


def shown_range(curves: Iterable[np.ndarray], limits: tuple[float, float]) -> tuple[float, float]:
    """Return the range of an axis with all positive finite values, but not beyond the limits."""
    lower, upper = limits
    # The first run has no values yet.
    values = np.concatenate([np.empty(0), *curves])
    values = values[np.isfinite(values) & (values > 0)]
    low, high = (values.min(), values.max()) if values.size else limits
    return max(lower, float(low) / 2), max(min(upper, float(high) * 2), 10 * lower)


def logarithm(values: np.ndarray) -> np.ndarray:
    """Return log₁₀ in single precision, NaN for nonpositive and infinite values."""
    values = np.asarray(values, float)
    good = (values > 0) & np.isfinite(values)
    return np.where(good, np.log10(np.where(good, values, 1.0)), np.nan).astype(np.float32)
