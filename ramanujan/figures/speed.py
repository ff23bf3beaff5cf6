"""The figures of the speed page: growing errors, work–precision diagram, forms of Ω² and phase at the extremes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ramanujan.figures import Drawn
from ramanujan.figures.logarithmic import (
    AFTER,
    EXTRA,
    LOWER,
    TICKS,
    UPPER,
    Colors,
    axis_title,
    laid_out,
    level_line,
    log_axis,
    logarithm,
    look_of,
    power_axis,
    shown_range,
    within,
)
from ramanujan.translation import _, ngettext

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
    hover = AFTER.format(periods="%{x:.4g}", error="%{y:.3g}") + EXTRA
    traces = []
    # The chosen one is drawn last, on top.
    curves = sorted(curves, key=lambda curve: curve.chosen)
    for curve in curves:
        color = look_of(curve.look, colors)[0]
        line = {"color": color, "width": 4 if curve.chosen else 1.6}
        shared = {"type": "scatter", "x": curve.reach, "mode": "lines", "line": line, "name": curve.name}
        shared |= {"legendgroup": curve.name, "legendrank": curve.look, "opacity": 1 if curve.chosen else 0.75}
        for values, shown, axis in ((curve.energy, _ENERGY_SHOWN, "y"), (curve.phase, _PHASE_SHOWN, "y2")):
            own = {"y": within(values, shown), "yaxis": axis, "showlegend": axis == "y2", "hovertemplate": hover}
            traces.append(shared | own)
    dashed = {"color": colors["ink"], "width": 2, "dash": "dash"}
    traces.append(
        {"type": "scatter", "x": exact[0], "y": exact[1], "yaxis": "y2", "mode": "lines+markers", "line": dashed}
        | {"name": _("closed form"), "legendrank": 99, "hovertemplate": hover}
    )
    return laid_out(
        traces,
        colors,
        520,
        yaxis=log_axis(_("energy error<br>|E/E₀ − 1|"), shown_range([c.energy for c in curves], _ENERGY_SHOWN)) | UPPER,
        yaxis2=log_axis(_("phase error<br>[rad]"), shown_range([*(c.phase for c in curves), exact[1]], _PHASE_SHOWN))
        | LOWER,
        xaxis={"type": "log", "title": axis_title(_("periods")), "anchor": "y2", "fixedrange": True, "dtick": 1}
        | TICKS,
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
    hover = _("cost {cost}, error {error}").format(cost="%{x:.3g}", error="%{y:.3g}") + EXTRA
    marked = [np.array([tolerance])] + [np.array([point[1]]) for point in (cheapest, exact) if point]
    shown = shown_range([curve.error for curve in curves] + marked, (1e-17, 1e3))
    for curve in curves:
        color, symbol = look_of(curve.look, colors)
        double = curve.dtype == "float64"
        traces.append(
            {
                "type": "scatter",
                "x": curve.cost.astype(np.float32),
                "y": within(curve.error, shown),
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
    traces.append(level_line([min(reached), max(reached)], tolerance, _("largest error allowed"), colors))
    return laid_out(
        traces,
        colors,
        480,
        xaxis={**TICKS, "type": "log", "title": axis_title(cost_title), "dtick": 1, "fixedrange": True},
        yaxis=log_axis(_("largest error, relative to the amplitude"), shown),
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
    traces = [{**along, "y": logarithm(truth), "line": band, "name": _("exact"), "hoverinfo": "skip"}]
    widths = np.linspace(2, 6, len(curves))
    for place, curve in reversed(list(enumerate(curves))):
        color = look_of(place, colors)[0]
        line = {"color": color, "width": float(widths[place])}
        shared = {**along, "line": line, "name": curve.name, "legendgroup": curve.name}
        traces.append(shared | {"y": logarithm(curve.value), "hovertemplate": "Ω² = 10<sup>%{y:.2f}</sup>" + EXTRA})
        # An error of zero has no logarithm: it is drawn at the lower edge.
        ulp = {"y": logarithm(np.maximum(curve.error_ulp, 0.1)), "yaxis": "y2", "showlegend": False}
        traces.append(shared | ulp | {"hovertemplate": "10<sup>%{y:.1f}</sup> ulp" + EXTRA})
    logarithms = np.concatenate([logarithm(truth), *(logarithm(curve.value) for curve in curves)])
    low, high = float(np.nanmin(logarithms)), float(np.nanmax(logarithms))
    room = 0.08 * (high - low) + 0.1
    worst = max(3.0, *(float(np.nanmax(logarithm(curve.error_ulp), initial=0.0)) for curve in curves))
    return laid_out(
        traces,
        colors,
        520,
        xaxis=power_axis(quantity, exponents[0], exponents[-1]) | {"anchor": "y2"},
        yaxis=power_axis("Ω² [rad²/s²]", low - room, high + room, ticks=4) | UPPER,
        yaxis2=power_axis(_("error [ulp]"), -1.2, worst + 1, ticks=4) | LOWER,
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
        color, symbol = look_of(look, colors)
        traces.append(
            {
                "type": "scatter",
                "x": list(periods),
                "y": list(errors),
                "mode": "lines+markers",
                "line": {"color": color, "width": 3},
                "marker": {"symbol": symbol, "size": 8},
                "name": name,
                "hovertemplate": AFTER.format(periods="%{x:.0e}", error="%{y:.3g} rad") + EXTRA,
            }
        )
    traces.append(level_line([periods[0], periods[-1]], np.pi, _("half a turn: the phase is lost"), colors))
    return laid_out(
        traces,
        colors,
        380,
        xaxis={**TICKS, "type": "log", "title": axis_title(_("periods")), "dtick": 3, "fixedrange": True},
        yaxis=log_axis(_("phase error [rad]"), (1e-17, 200.0)),
    )


def _steps(dtype: str, n: int) -> str:
    sentence = ngettext("{dtype}, {n} step per period", "{dtype}, {n} steps per period", n)
    return sentence.format(dtype=dtype, n=n)
