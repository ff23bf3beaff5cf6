"""The figures of the speed page: growth of errors, work–precision diagram, forms of Ω², and phase errors."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ramanujan.figures import EncodedFigure, build_figure, legend, line, logarithmic, marks, note
from ramanujan.figures.logarithmic import Colors, axis, level_line, log_axis, method_look, select_drawable
from ramanujan.numerals import number
from ramanujan.translation import _, ngettext

_NAMED = "<extra>%{fullData.name}</extra>"
"""The second hover box of Plotly, with the name of the curve."""
_AFTER = _("after {periods} periods: {error}")
_UPPER: dict[str, Any] = {"domain": [0.57, 1.0]}
_LOWER: dict[str, Any] = {"domain": [0.0, 0.43], "anchor": "x"}
"""The axes of two panels below each other."""
_ENERGY_MOST, _PHASE_MOST = 0.5, 2
"""The largest exponents of ten on the axes. A curve with larger errors leaves the figure at the top."""
_HEIGHT = 560
"""The height of two panels and the gap between them [px]."""
_STRIP_HEIGHT, _HALF_STRIP = 62, 0.24
"""The height of a form's strip with the name above it [px], and half the strip's fraction of that height."""
_MARGIN = {"l": 60, "r": 28, "t": 12, "b": 48}


CurveArrays = tuple[np.ndarray, np.ndarray, np.ndarray]
"""The points of one method: three arrays of equal length."""


@dataclass(frozen=True)
class Part:
    """A part of a form's strip between two exponents of ten, whether the form is right in it, and a label."""

    start: float
    end: float
    is_right: bool
    label: str


_MARKS = 8
"""Number of symbols on a curve with many points. They distinguish the methods without their colours."""


class _Line(NamedTuple):
    """A curve in a panel of `draw_error_growth`: its points, the symbol on some of them, and the look of its line."""

    name: str
    color: str
    symbol: str
    periods: np.ndarray
    errors: np.ndarray
    width: float
    opacity: float = 1.0
    dash: str = "solid"


def draw_error_growth(
    curves: Mapping[str, CurveArrays],
    chosen: str,
    exact: tuple[np.ndarray, np.ndarray],
    names: Sequence[str],
    colors: Colors,
) -> EncodedFigure:
    """Draw the energy error above, the phase error below, against the number of periods; all axes logarithmic.

    A gray band marks the compressed part of an axis.

    Parameters
    ----------
    curves : name of each method → numbers of periods, |energy error| and |phase error| [rad]
    chosen : the name of the method that is drawn strongly
    exact : numbers of periods and the closed form's phase error there [rad]
    names : of all methods, in the order of their colours
    colors : the theme's
    """
    hover = _AFTER.format(periods="%{x}", error="%{customdata}") + _NAMED
    looks = {name: method_look(number, colors) for number, name in enumerate(names)}
    exact_periods, exact_errors = exact
    # Draw the chosen method last, above the others.
    ordered = sorted(curves, key=lambda name: name == chosen)
    closed = _Line(_("closed form"), colors["ink"], "star", exact_periods, exact_errors, width=2, dash="dash")
    all_periods = [exact_periods, *(periods for periods, _energy, _phase in curves.values())]
    x_range = float(np.log10(min(map(np.min, all_periods)))), float(np.log10(max(map(np.max, all_periods))))
    traces, shapes = [], []
    axes: dict[str, Any] = {"xaxis": axis(_("periods"), x_range, type="log", dtick=1, anchor="y2")}
    for name_of_axis, place, title, most in (
        ("y", _UPPER, _("energy error<br>|<i>E</i>/<i>E</i>₀ − 1|"), _ENERGY_MOST),
        ("y2", _LOWER, _("phase error [rad]"), _PHASE_MOST),
    ):
        is_phase = name_of_axis == "y2"
        lines = []
        for name in ordered:
            periods, energy_errors, phase_errors = curves[name]
            width, opacity = (4, 1.0) if name == chosen else (2, 0.8)
            errors = phase_errors if is_phase else energy_errors
            lines.append(_Line(name, *looks[name], periods, errors, width, opacity))
        if is_phase:
            lines.append(closed)
        drawn_axis, scale, compressed_below = logarithmic.axis_with_room(title, [curve.errors for curve in lines], most)
        for curve in lines:
            properties = {
                "name": curve.name,
                "legendgroup": curve.name,
                "showlegend": is_phase,
                "yaxis": name_of_axis,
                "mode": "lines+markers",
                "marker": {"symbol": curve.symbol, "size": 8, "maxdisplayed": _MARKS},
                "opacity": curve.opacity,
                "hovertemplate": hover,
            }
            properties |= {"xhoverformat": ".4~g", "customdata": _format_numbers(curve.errors)}
            trace = line(curve.periods, scale(curve.errors), color=curve.color, width=curve.width, dash=curve.dash)
            traces.append(trace | properties)
        low_end, _high_end = drawn_axis["range"]
        shapes.append(_gray_band(low_end, compressed_below, colors) | {"yref": name_of_axis})
        axes[f"yaxis{name_of_axis[1:]}"] = drawn_axis | place
    return build_figure(traces, colors, _HEIGHT + 64, margin=_MARGIN, shapes=shapes, **legend(), **axes)


def _gray_band(low: float, high: float, colors: Colors) -> dict[str, Any]:
    """Return the background of the compressed part of an axis."""
    ends = {"x0": 0, "x1": 1, "xref": "x domain", "y0": low, "y1": high}
    gray = {"type": "rect", "line": {"width": 0}, "fillcolor": colors["faint"], "opacity": 0.4, "layer": "below"}
    return gray | ends


@dataclass(frozen=True)
class MarkedRun:
    """A run with a large mark in a work-precision diagram.

    Parameters
    ----------
    cost, error : position of the mark
    symbol, size : Plotly's name of the mark, and its size [px]
    color : key of the theme's colours
    """

    cost: float
    error: float
    symbol: str
    size: int
    color: str


def draw_work_precision(
    curves: Mapping[tuple[str, str], CurveArrays],
    *,
    titles: tuple[str, str],
    tolerance: float,
    marked_runs: Mapping[str, MarkedRun],
    tried: Sequence[tuple[float, float]] = (),
    colors: Colors,
) -> EncodedFigure:
    """Draw error against cost, both logarithmic: solid with filled marks in float64, dotted with open ones in float32.

    Parameters
    ----------
    curves : name of the method and its precision → cost, error and steps per period of each run
    titles : of the cost axis and of the error axis
    tolerance : the largest error allowed
    marked_runs : name in the legend → a run with a large mark
    tried : cost and error of runs with a small mark
    colors : the theme's
    """
    hover = _("cost {cost}, error {error}").format(cost="%{customdata[0]}", error="%{customdata[1]}") + _NAMED
    errors = [error for _cost, error, _steps in curves.values()]
    marked_errors = [run.error for run in marked_runs.values()]
    shown = logarithmic.shown_range([*errors, np.array([tolerance, *marked_errors])], (1e-17, 1e3))
    traces = _method_curves(curves, shown, hover, colors)
    for cost, error in tried:
        mark = marks([cost], [error], "diamond-open", 11, colors["ink"], width=2)
        traces.append(mark | {"customdata": _points([cost], [error]), "hovertemplate": hover, "showlegend": False})
    lowest, _highest = shown
    for name, run in marked_runs.items():
        mark = marks([run.cost], [max(run.error, lowest)], run.symbol, run.size, colors[run.color], width=3)
        traces.append(mark | {"name": name, "customdata": _points([run.cost], [run.error]), "hovertemplate": hover})
    costs: list[float] = [cost for cost, _error in tried]
    costs += [run.cost for run in marked_runs.values()]
    for costs_of_method, _error, _steps in curves.values():
        costs += [costs_of_method[0], costs_of_method[-1]]
    ends = min(costs), max(costs)
    traces.append(level_line(ends, tolerance, _("largest error allowed"), colors))
    x_range = float(np.log10(ends[0])) - 0.1, float(np.log10(ends[1])) + 0.1
    return build_figure(
        traces,
        colors,
        544,
        margin=_MARGIN,
        **legend(),
        xaxis=axis(titles[0], x_range, type="log", dtick=1),
        yaxis=log_axis(titles[1], shown),
    )


def _method_curves(
    curves: Mapping[tuple[str, str], CurveArrays], shown: tuple[float, float], hover: str, colors: Colors
) -> list[dict[str, Any]]:
    """Return the traces of the methods, for the range `shown` of the error axis."""
    methods = list(dict.fromkeys(name for name, _dtype in curves))
    traces = []
    for (name, dtype), (cost, error, steps) in curves.items():
        color, symbol = method_look(methods.index(name), colors)
        is_double = dtype == "float64"
        width, dash = (2.5, "solid") if is_double else (1.5, "dot")
        curve = line(cost.astype(np.float32), select_drawable(error, shown[1]), color=color, width=width, dash=dash)
        properties: dict[str, Any] = {
            "mode": "lines+markers",
            "marker": {"symbol": symbol if is_double else f"{symbol}-open", "size": 8},
            "name": name,
            "text": [_describe_steps(dtype, int(n)) for n in steps],
            "hovertemplate": f"%{{text}}<br>{hover}",
            "customdata": _points(cost, error),
            # A click on a name in the legend hides the method in both precisions.
            "showlegend": is_double,
            "legendgroup": name,
        }
        traces.append(curve | properties)
    return traces


def draw_forms(strips: Mapping[str, Sequence[Part]], *, quantity: str, colors: Colors) -> EncodedFigure:
    """Draw a strip for each form of Ω², divided into the ranges where the form is right, and where it fails.

    Parameters
    ----------
    strips : name of the form → its parts, in order
    quantity : title of the horizontal axis, along which the parts are given as exponents of ten
    colors : the theme's
    """
    rows: list[int] = []
    parts: list[Part] = []
    for row, parts_of_form in enumerate(strips.values()):
        rows += [row] * len(parts_of_form)
        parts += parts_of_form
    start, end = min(part.start for part in parts), max(part.end for part in parts)
    shortest_with_label = (end - start) / 20
    bars = {
        "type": "bar",
        "orientation": "h",
        "y": rows,
        "base": [part.start for part in parts],
        "x": [part.end - part.start for part in parts],
        "width": 2 * _HALF_STRIP,
        "marker": {
            "color": [colors["primary"] if part.is_right else colors["ink"] for part in parts],
            "line": {"color": colors["paper"], "width": 2},
        },
        # A part that is too short for a legible label has only a hover text.
        "text": [part.label if part.end - part.start > shortest_with_label else "" for part in parts],
        "customdata": [part.label for part in parts],
        "textposition": "inside",
        "insidetextanchor": "middle",
        "textangle": 0,
        "constraintext": "none",
        "textfont": {"color": colors["paper"], "size": 13},
        "hovertemplate": "%{customdata}<extra></extra>",
    }
    above = {"xanchor": "left", "yanchor": "bottom"}
    notes = [note(name, colors["ink"], start, row - _HALF_STRIP) | above for row, name in enumerate(strips)]
    # The first strip is at the top. The margins, in strips, leave room for its name and below the last strip.
    hidden = {"visible": False, "range": [len(strips) - 0.65, -0.8], "fixedrange": True}
    x_axis = logarithmic.power_axis(quantity, start, end) | {"showgrid": False}
    height = 76 + _STRIP_HEIGHT * len(strips)
    return build_figure(
        [bars], colors, height, margin=_MARGIN | {"l": 28}, xaxis=x_axis, yaxis=hidden, annotations=notes
    )


def draw_phase_errors(periods: Sequence[float], curves: Mapping[str, Sequence[float]], colors: Colors) -> EncodedFigure:
    """Draw the phase error against the number of periods for each method; both axes logarithmic.

    Parameters
    ----------
    periods : 1, 10, 100, …
    curves : name → phase error [rad]
    colors : the theme's
    """
    hover = _AFTER.format(periods="%{customdata[0]}", error="%{customdata[1]}\u202frad") + _NAMED
    traces = []
    for index, (name, errors) in enumerate(curves.items(), start=1):
        color, symbol = method_look(index, colors)
        properties = {
            "name": name,
            "mode": "lines+markers",
            "marker": {"symbol": symbol, "size": 8},
            "hovertemplate": hover,
            "customdata": _points(periods, errors),
        }
        traces.append(line(list(periods), list(errors), color=color, width=3) | properties)
    lost = _("half a turn: phase lost")
    traces.append(level_line([periods[0], periods[-1]], np.pi, lost, colors))
    x_range = float(np.log10(periods[0])), float(np.log10(periods[-1]))
    x_axis = axis(_("periods"), x_range, type="log", dtick=3)
    y_axis = log_axis(_("phase error [rad]"), (1e-17, 200.0))
    return build_figure(traces, colors, 384, margin=_MARGIN, xaxis=x_axis, yaxis=y_axis, **legend(orientation="v"))


def _points(x: Iterable[float], y: Iterable[float]) -> list[list[str]]:
    """Return the formatted coordinates of each point."""
    return [list(point) for point in zip(_format_numbers(x), _format_numbers(y), strict=True)]


def _format_numbers(values: Iterable[float]) -> list[str]:
    """Return the formatted numbers. Plotly would write 3.2e-7 in every language."""
    return [number(float(value), 3, strip=True) for value in values]


def _describe_steps(dtype: str, n: int) -> str:
    sentence = ngettext("{dtype}, {n} step per period", "{dtype}, {n} steps per period", n)
    return sentence.format(dtype=dtype, n=n)
