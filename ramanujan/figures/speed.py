"""The figures of the speed page: growing errors, work–precision diagram, forms of Ω² and phase at the extremes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import Drawn, drawn, template
from ramanujan.numerals import number
from ramanujan.words import _, ngettext

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

_ENERGY_SHOWN, _PHASE_SHOWN = (1e-17, 1e6), (1e-17, 1e4)
"""A run whose error grows further leaves the figure at the top, so that the others can be seen."""


@dataclass(frozen=True, eq=False)
class Growth:
    """Error curves of one method: name, numbers of periods, |energy error| and |phase error| [rad]."""

    name: str
    look: int
    reach: np.ndarray
    energy: np.ndarray
    phase: np.ndarray
    chosen: bool = False


@dataclass(frozen=True, eq=False)
class Cost:
    """A curve of the work–precision diagram: cost, error and step size of each run."""

    name: str
    look: int
    dtype: str
    cost: np.ndarray
    error: np.ndarray
    steps: np.ndarray


@dataclass(frozen=True, eq=False)
class Form:
    """One form of Ω² along a sweep: Ω² as returned and its error [ulp] at 10^exponents; NaN where there is none."""

    name: str
    value: np.ndarray
    error_ulp: np.ndarray


def error_growth(curves: Iterable[Growth], exact: tuple[np.ndarray, np.ndarray], colors: Colors) -> Drawn:
    """Draw the energy error above, the phase error below, against the number of periods; all axes logarithmic.

    Parameters
    ----------
    curves : one for each method, the chosen one drawn strongly
    exact : numbers of periods and the closed form's phase error there [rad]
    colors : the theme's
    """
    hover = _AFTER.format(periods="%{x:.4g}", error="%{y:.3g}") + _EXTRA
    traces = []
    # The chosen one is drawn last, on top.
    curves = sorted(curves, key=lambda curve: curve.chosen)
    for curve in curves:
        color = _look(curve.look, colors)[0]
        line = {"color": color, "width": 4 if curve.chosen else 1.6}
        shared = {"type": "scatter", "x": curve.reach, "mode": "lines", "line": line, "name": curve.name}
        shared |= {"legendgroup": curve.name, "legendrank": curve.look, "opacity": 1 if curve.chosen else 0.75}
        for values, shown, axis in ((curve.energy, _ENERGY_SHOWN, "y"), (curve.phase, _PHASE_SHOWN, "y2")):
            own = {"y": _within(values, shown), "yaxis": axis, "showlegend": axis == "y2", "hovertemplate": hover}
            traces.append(shared | own)
    dashed = {"color": colors["ink"], "width": 2, "dash": "dash"}
    traces.append(
        {"type": "scatter", "x": exact[0], "y": exact[1], "yaxis": "y2", "mode": "lines+markers", "line": dashed}
        | {"name": _("closed form"), "legendrank": 99, "hovertemplate": hover}
    )
    return _figure(
        traces,
        colors,
        520,
        yaxis=_log_axis(_("energy error<br>|E/E₀ − 1|"), _range([c.energy for c in curves], _ENERGY_SHOWN)) | _UPPER,
        yaxis2=_log_axis(_("phase error<br>[rad]"), _range([*(c.phase for c in curves), exact[1]], _PHASE_SHOWN))
        | _LOWER,
        xaxis={"type": "log", "title": _title(_("periods")), "anchor": "y2", "fixedrange": True, "dtick": 1} | _TICKS,
    )


def work_precision(
    curves: Iterable[Cost],
    *,
    cost_title: str,
    tolerance: float,
    cheapest: tuple[float, float] | None,
    exact: tuple[float, float] | None,
    colors: Colors,
) -> Drawn:
    """Draw error against cost, both logarithmic: solid with filled marks in float64, dotted with open ones in float32.

    Parameters
    ----------
    curves : one for each method and precision
    cost_title : title of the cost axis
    tolerance : the largest error allowed
    cheapest : cost and error of the cheapest run
    exact : cost and error of the closed form
    colors : the theme's
    """
    curves, traces = list(curves), []
    hover = _("cost {cost}, error {error}").format(cost="%{x:.3g}", error="%{y:.3g}") + _EXTRA
    marked = [np.array([tolerance])] + [np.array([point[1]]) for point in (cheapest, exact) if point]
    shown = _range([curve.error for curve in curves] + marked, (1e-17, 1e3))
    for curve in curves:
        color, symbol = _look(curve.look, colors)
        double = curve.dtype == "float64"
        traces.append(
            {
                "type": "scatter",
                "x": curve.cost.astype(np.float32),
                "y": _within(curve.error, shown),
                "text": [_steps(curve.dtype, int(n)) for n in curve.steps],
                "mode": "lines+markers",
                "line": {"color": color, "width": 2.5 if double else 1.5, "dash": "solid" if double else "dot"},
                "marker": {"symbol": symbol if double else f"{symbol}-open", "size": 8},
                "name": curve.name,
                "legendgroup": curve.name,
                "legendrank": curve.look,
                "showlegend": double,
                "hovertemplate": f"%{{text}}<br>{hover}",
            }
        )
    marks = ((cheapest, _("cheapest"), "circle-open", 22, "primary"), (exact, _("closed form"), "star", 15, "ink"))
    for point, name, symbol, size, color in marks:
        if point is not None:
            traces.append(
                {
                    "type": "scatter",
                    "x": [point[0]],
                    "y": [max(point[1], shown[0])],
                    "mode": "markers",
                    "marker": {"symbol": symbol, "size": size, "color": colors[color], "line": {"width": 3}},
                    "name": name,
                    "legendrank": 99,
                    "hovertemplate": hover,
                }
            )
    reached = [cost for curve in curves for cost in (curve.cost[0], curve.cost[-1])]
    reached += [point[0] for point in (cheapest, exact) if point]
    traces.append(_level([min(reached), max(reached)], tolerance, _("largest error allowed"), colors))
    return _figure(
        traces,
        colors,
        480,
        xaxis={**_TICKS, "type": "log", "title": _title(cost_title), "dtick": 1, "fixedrange": True},
        yaxis=_log_axis(_("error at the end, relative to the amplitude"), shown),
    )


def forms(exponents: np.ndarray, truth: np.ndarray, curves: Sequence[Form], *, quantity: str, colors: Colors) -> Drawn:
    """Draw the Ω² that each form returns above, and its error in ulp below, against powers of ten of the quantity.

    The axes are linear in the logarithm, because 1e-300 itself is too small for single precision.

    Parameters
    ----------
    exponents : log₁₀ of ε or of the scale s, equally spaced, shape (n,)
    truth : Ω², shape (n,)
    curves : the forms, each of shape (n,); the first ones are drawn on top
    quantity : title of the horizontal axis
    colors : the theme's
    """
    along = {"type": "scatter", "x0": float(exponents[0]), "dx": float(exponents[1] - exponents[0]), "mode": "lines"}
    band = {"color": colors["faint"], "width": 12}
    traces = [{**along, "y": _logarithm(truth), "line": band, "name": _("exact"), "hoverinfo": "skip"}]
    widths = np.linspace(2, 6, len(curves))
    for place, curve in reversed(list(enumerate(curves))):
        color = _look(place, colors)[0]
        line = {"color": color, "width": float(widths[place])}
        shared = {**along, "line": line, "name": curve.name, "legendgroup": curve.name}
        traces.append(shared | {"y": _logarithm(curve.value), "hovertemplate": "Ω² = 10<sup>%{y:.2f}</sup>" + _EXTRA})
        # An error of zero has no logarithm: it is drawn at the lower edge.
        ulp = {"y": _logarithm(np.maximum(curve.error_ulp, 0.1)), "yaxis": "y2", "showlegend": False}
        traces.append(shared | ulp | {"hovertemplate": "10<sup>%{y:.1f}</sup> ulp" + _EXTRA})
    logarithms = np.concatenate([_logarithm(truth), *(_logarithm(curve.value) for curve in curves)])
    low, high = float(np.nanmin(logarithms)), float(np.nanmax(logarithms))
    room = 0.08 * (high - low) + 0.1
    worst = max(3.0, *(float(np.nanmax(_logarithm(curve.error_ulp), initial=0.0)) for curve in curves))
    return _figure(
        traces,
        colors,
        520,
        xaxis=_power_axis(quantity, exponents[0], exponents[-1]) | {"anchor": "y2"},
        yaxis=_power_axis("Ω² [rad²/s²]", low - room, high + room, ticks=4) | _UPPER,
        yaxis2=_power_axis(_("error [ulp]"), -1.2, worst + 1, ticks=4) | _LOWER,
    )


def phase_errors(periods: Sequence[float], curves: Mapping[str, Sequence[float]], colors: Colors) -> Drawn:
    """Draw the phase error against the number of periods for each method; both axes logarithmic.

    Parameters
    ----------
    periods : 1, 10, 100, …
    curves : name → phase error [rad]
    colors : the theme's
    """
    traces = []
    for (name, errors), look in zip(curves.items(), (1, 2, 3), strict=True):
        color, symbol = _look(look, colors)
        traces.append(
            {
                "type": "scatter",
                "x": list(periods),
                "y": list(errors),
                "mode": "lines+markers",
                "line": {"color": color, "width": 3},
                "marker": {"symbol": symbol, "size": 8},
                "name": name,
                "hovertemplate": _AFTER.format(periods="%{x:.0e}", error="%{y:.3g} rad") + _EXTRA,
            }
        )
    traces.append(_level([periods[0], periods[-1]], np.pi, _("π: the phase is lost"), colors))
    return _figure(
        traces,
        colors,
        380,
        xaxis={**_TICKS, "type": "log", "title": _title(_("periods")), "dtick": 3, "fixedrange": True},
        yaxis=_log_axis(_("phase error [rad]"), (1e-17, 200.0)),
    )


_EXTRA = "<extra>%{fullData.name}</extra>"
"""Plotly's second box, which names the curve."""

_AFTER = _("after {periods} periods: {error}")
_TICKS = {"tickfont": {"size": 12}, "automargin": True, "exponentformat": "power"}
_UPPER = {"domain": [0.54, 1.0]}
_LOWER = {"domain": [0.0, 0.46], "anchor": "x"}


def _figure(traces: list[dict[str, Any]], colors: Colors, height: int, **axes: Any) -> Drawn:
    """Return the traces in the common look."""
    layout = {"template": template(colors), "height": height, "showlegend": True, **axes}
    layout["legend"] = {"orientation": "h", "y": -0.16, "yanchor": "top", "x": 0, "font": {"size": 13}}
    layout["legend"] |= {"itemclick": False, "itemdoubleclick": False}
    layout["margin"] = {"l": 60, "r": 12, "t": 12, "b": 20}
    return drawn(traces, layout)


def in_large_print(figure: Drawn) -> Drawn:
    """Return a figure with room for words that a lecture hall can read: higher, and with its legend farther down."""
    sent = figure.to_dict()
    layout = sent["layout"]
    height = min(layout["height"] + 80, 570)
    return Drawn(
        {**sent, "layout": {**layout, "height": height, "legend": {**layout["legend"], "y": -95 / (height - 200)}}}
    )


def _steps(dtype: str, n: int) -> str:
    sentence = ngettext("{dtype}, {n} step per period", "{dtype}, {n} steps per period", n)
    return sentence.format(dtype=dtype, n=n)


def _look(index: int, colors: Colors) -> tuple[str, str]:
    color, symbol = _LOOKS[index % len(_LOOKS)]
    return colors[color], symbol


def _log_axis(title: str, shown: tuple[float, float]) -> dict[str, Any]:
    low, high = np.log10(shown)
    step = max(1, int(np.ceil((high - low) / 6)))
    range_ = [float(low), float(high)]
    axis = {"type": "log", "title": _title(title), "range": range_, "dtick": step, "fixedrange": True}
    return {**axis, **_TICKS}


def _level(ends: Sequence[float], level: float, name: str, colors: Colors) -> dict[str, Any]:
    """Return a level for comparison with the curves."""
    line = {"color": colors["ink"], "dash": "dash", "width": 1.5}
    trace = {"type": "scatter", "x": list(ends), "y": [level] * 2, "mode": "lines", "line": line}
    return {**trace, "name": name, "hoverinfo": "skip"}


def _title(text: str) -> dict[str, Any]:
    return {"text": text, "standoff": 8, "font": {"size": 14}}


def _power_axis(title: str, low: float, high: float, ticks: int = 6) -> dict[str, Any]:
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
        "title": _title(title),
        "range": [low, high],
        "tickvals": values,
        "ticktext": texts,
        "fixedrange": True,
        **_TICKS,
    }


def _within(values: np.ndarray, shown: tuple[float, float]) -> np.ndarray:
    """Return the values in single precision; a value that a logarithmic axis cannot show becomes a gap."""
    values = np.asarray(values, float)
    top = 1e3 * shown[1]
    return np.where((values > 0) & (values <= top), values, np.nan).astype(np.float32)


def _range(curves: Iterable[np.ndarray], shown: tuple[float, float]) -> tuple[float, float]:
    """Return the range of an axis: all positive finite values, within the given limits."""
    # There are no values while the first run is still in progress.
    values = np.concatenate([np.empty(0), *curves])
    values = values[np.isfinite(values) & (values > 0)]
    low, high = (values.min(), values.max()) if values.size else shown
    return max(shown[0], float(low) / 2), max(min(shown[1], float(high) * 2), 10 * shown[0])


def _logarithm(values: np.ndarray) -> np.ndarray:
    """Return log₁₀ in single precision, NaN where it does not exist."""
    values = np.asarray(values, float)
    good = (values > 0) & np.isfinite(values)
    return np.where(good, np.log10(np.where(good, values, 1.0)), np.nan).astype(np.float32)
