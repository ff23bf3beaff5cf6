"""The figures of the speed page: growth of errors, work–precision diagram, and phase errors."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import WITHOUT_HOVER, EncodedFigure, build_figure, line, logarithmic, marks, note, spread
from ramanujan.figures.logarithmic import Colors, axis, level_line, log_axis, select_drawable
from ramanujan.text.numerals import number
from ramanujan.text.translation import _, ngettext

_NAMED = "<extra>%{fullData.name}</extra>"
"""The second hover box of Plotly, with the name of the curve."""
_AFTER = _("after {periods} periods: {error}")
_MARGIN = {"l": 60, "r": 28, "t": 12, "b": 48}
_STRONG, _GRAY = 4.0, 2.0
"""The widths of the line of the chosen method, and of the other methods [px]."""
_SYMBOL = 7
"""The size of the symbol of a method [px]."""
_LONGEST_NAME = 18
"""The largest number of letters of a name in one line at the right edge."""
_LINE_HEIGHT = 0.08
"""The height of a line of a name on a slide, in fractions of the plotting area."""


CurveArrays = tuple[np.ndarray, np.ndarray, np.ndarray]
"""The points of one method: three arrays of equal length."""


def draw_error_growth(
    curves: Mapping[str, tuple[np.ndarray, np.ndarray]],
    chosen: str | None,
    *,
    title: str,
    limits: tuple[float, float],
    allowed: float | None,
    colors: Colors,
) -> EncodedFigure:
    """Draw an error of all methods against the number of periods, both logarithmic; the axes never change.

    Each line has its name at the right edge, with an arrow if the line ends outside of the figure.

    Parameters
    ----------
    curves : name of each method → numbers of periods from 1, and the error after them
    chosen : the name of the method that is drawn strongly, if any, among gray ones
    title : of the error axis
    limits : of the error axis. A line with other errors leaves the figure.
    allowed : the largest error allowed, if any
    colors : the theme's
    """
    traces = []
    line_ends = {}
    chosen_label = None
    symbols = dict(zip(curves, logarithmic.SYMBOLS, strict=False))
    right = max(float(periods[-1]) for periods, _errors in curves.values())
    # Draw the chosen method last, above the others.
    for name in sorted(curves, key=lambda name: name == chosen):
        periods, errors = curves[name]
        look = {"color": colors["primary"], "width": _STRONG} if name == chosen else _gray(colors)
        curve = line(periods, select_drawable(errors, limits[1]), **look)
        properties = {
            "name": name,
            # Some lines end at the same point, so each has a symbol.
            "mode": "lines+markers",
            "marker": {"symbol": symbols[name], "size": _SYMBOL, "maxdisplayed": 5},
            "hovertemplate": _AFTER.format(periods="%{x}", error="%{customdata}") + _NAMED,
            "xhoverformat": ".4~g",
            "customdata": _format_numbers(errors),
        }
        traces.append(curve | properties)
        last = np.nan_to_num(errors[-1], nan=np.inf)
        arrow = " ↑" if last > limits[1] else " ↓" if last < limits[0] else ""
        line_ends[name + arrow] = right, float(np.clip(last, *limits))
        symbols[name + arrow] = symbols[name]
        if name == chosen:
            chosen_label = name + arrow
    band: dict[str, Any] = {}
    if allowed is not None:
        traces.append(level_line((1.0, right), allowed, _("error allowed"), colors))
        # Few lines reach the lower corner.
        band = _shade_allowed(allowed, limits, (1.0, limits[0]), colors)
    leaders, names = _name_lines(line_ends, chosen_label, right, limits, symbols, colors)
    x_axis = axis(_("periods"), (0.0, float(np.log10(right)) + 0.11), type="log", tickvals=[1, 3, 10, 30])
    return build_figure(
        [*leaders, *traces],
        colors,
        304,
        margin=_MARGIN,
        xaxis=x_axis,
        yaxis=log_axis(title, limits),
        yaxis2=names,
        **band,
    )


def _shade_allowed(
    allowed: float, limits: tuple[float, float], place: tuple[float, float], colors: Colors
) -> dict[str, Any]:
    """Return the layout of a tinted band of the errors that are allowed, with its name.

    Parameters
    ----------
    allowed : the upper edge of the band
    limits : of the error axis
    place : the lower left corner of the name
    colors : the theme's
    """
    edges = {"xref": "paper", "x0": 0, "x1": 1, "y0": limits[0], "y1": allowed, "line": {"width": 0}}
    band = {"type": "rect", **edges, "fillcolor": colors["primary"], "opacity": 0.1, "layer": "below"}
    name = note(_("error allowed"), colors["ink"], *np.log10(place))
    place_of_name = {"xanchor": "left", "yanchor": "bottom", "xshift": 6}
    return {"shapes": [band], "annotations": [name | place_of_name]}


def _gray(colors: Colors) -> dict[str, Any]:
    """Return the look of the line of a method that is not the chosen one."""
    return {"color": colors["block"], "width": _GRAY}


@dataclass(frozen=True)
class MarkedRun:
    """A run with a large mark in a work-precision diagram.

    Parameters
    ----------
    cost, error : position of the mark
    symbol, size : Plotly's name of the mark, and its size [px]
    color : key of the theme's colours
    is_named : whether its name is beside the mark, for one at the lower edge
    cost_text : the cost at the foot of a line from the mark to the cost axis, if any
    """

    cost: float
    error: float
    symbol: str
    size: int
    color: str
    is_named: bool = False
    cost_text: str = ""


def draw_work_precision(
    curves: Mapping[str, CurveArrays],
    *,
    chosen: str | None,
    titles: tuple[str, str],
    limits: tuple[float, float],
    tolerance: float,
    marked_runs: Mapping[str, MarkedRun],
    tried: Sequence[tuple[float, float]] = (),
    write_cost: Callable[[float], str] = number,
    colors: Colors,
) -> EncodedFigure:
    """Draw error against cost, both logarithmic.

    Parameters
    ----------
    curves : name of the method → cost, error and steps per period of each run
    chosen : the name of the method that is drawn strongly, if any; the others are gray
    titles : of the cost axis and of the error axis
    limits : of the error axis
    tolerance : the largest error allowed
    marked_runs : name → a run with a large mark
    tried : cost and error of runs with a small mark
    write_cost : a function that formats a cost
    colors : the theme's
    """
    hover = _("cost {cost}, error {error}").format(cost="%{customdata[0]}", error="%{customdata[1]}") + _NAMED
    costs: list[float] = [cost for cost, _error in tried]
    costs += [run.cost for run in marked_runs.values()]
    for costs_of_method, _error, _steps in curves.values():
        costs += [costs_of_method[0], costs_of_method[-1]]
    ends = min(costs), max(costs)
    line_ends = {name: (cost[-1], error[-1]) for name, (cost, error, _steps) in curves.items()}
    traces = _method_curves(curves, chosen, limits, hover, colors)
    leaders, names = _name_lines(line_ends, chosen, ends[1], limits, {}, colors)
    traces += leaders
    traces.append(level_line(ends, tolerance, _("error allowed"), colors))
    for cost, error in tried:
        mark = marks([cost], [error], "diamond-open", 11, colors["ink"], width=2)
        traces.append(mark | {"customdata": _points([cost], [error]), "hovertemplate": hover})
    notes = []
    for name, run in marked_runs.items():
        height = max(run.error, limits[0])
        mark = marks([run.cost], [height], run.symbol, run.size, colors[run.color], width=3)
        # A mark at an edge is not cut.
        properties = {"name": name, "hovertemplate": hover, "cliponaxis": False}
        traces.append(mark | properties | {"customdata": _points([run.cost], [run.error])})
        if run.cost_text:
            foot = line([run.cost] * 2, [height, limits[0]], color=colors[run.color], width=2)
            traces.append(foot | WITHOUT_HOVER)
            text = note(f"<b>{run.cost_text}</b>", colors[run.color], np.log10(run.cost), np.log10(limits[0]))
            notes.append(text | {"xanchor": "right", "yanchor": "bottom", "xshift": -4, "yshift": 4})
        if run.is_named:
            text = note(name, colors[run.color], np.log10(run.cost), np.log10(height))
            notes.append(text | {"xanchor": "left", "yanchor": "bottom", "xshift": run.size / 2})
    # No run is both cheap and accurate, so the left end of the band is free.
    band = _shade_allowed(tolerance, limits, (ends[0], tolerance), colors)
    [name_of_band] = band["annotations"]
    notes.append(name_of_band | {"text": _("allowed"), "yanchor": "top", "yshift": -8})
    x_range = float(np.log10(ends[0])) - 0.1, float(np.log10(ends[1])) + 0.11
    return build_figure(
        traces,
        colors,
        400,
        margin=_MARGIN,
        annotations=notes,
        shapes=band["shapes"],
        xaxis=axis(titles[0], x_range, type="log", **_decades(ends, write_cost)),
        yaxis=axis(titles[1], np.log10(limits).tolist(), type="log", **_decades(limits, _write_power)),
        yaxis2=names,
    )


def _decades(ends: tuple[float, float], write: Callable[[float], str]) -> dict[str, Any]:
    """Return the ticks of a logarithmic axis at the powers of ten, written as in the sentences of the page."""
    first, last = math.ceil(math.log10(ends[0])), math.floor(math.log10(ends[1]))
    values = [10.0**power for power in range(first, last + 1)]
    return {"tickvals": values, "ticktext": [write(value) for value in values]}


def _write_power(value: float) -> str:
    return number(value, 1)


def _method_curves(
    curves: Mapping[str, CurveArrays],
    chosen: str | None,
    limits: tuple[float, float],
    hover: str,
    colors: Colors,
) -> list[dict[str, Any]]:
    """Return the traces of the methods, the chosen one last."""
    traces = []
    for name, (cost, error, steps) in sorted(curves.items(), key=lambda entry: entry[0] == chosen):
        look = {"color": colors["primary"], "width": _STRONG} if name == chosen else _gray(colors)
        curve = line(cost.astype(np.float32), select_drawable(error, limits[1]), **look)
        properties: dict[str, Any] = {
            "name": name,
            "text": [_describe_steps(int(n)) for n in steps],
            "hovertemplate": f"%{{text}}<br>{hover}",
            "customdata": _points(cost, error),
        }
        traces.append(curve | properties)
    return traces


def _name_lines(
    line_ends: Mapping[str, tuple[float, float]],
    chosen: str | None,
    right: float,
    limits: tuple[float, float],
    symbols: Mapping[str, str],
    colors: Colors,
    leader: float = 0.1,
) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Return a leader from the end of each line to its symbol and name, and the axis at the right edge with the names.

    A leader has the width `leader`, in decades of the horizontal axis.

    Names are tick labels, because Plotly widens the margin for these, but not for annotations.
    """
    low, high = np.log10(limits)
    names = sorted(line_ends, key=lambda name: -line_ends[name][1])
    labels = [name if len(name) <= _LONGEST_NAME else name.replace(" ", "<br>", 1) for name in names]
    halves = [(high - low) * _LINE_HEIGHT * (label.count("<br>") + 1) / 2 for label in labels]
    ends = [float(np.clip(np.log10(line_ends[name][1]), low, high)) for name in names]
    levels = [10.0**height for height in spread(ends, halves, low, high)]
    edge = right * 10**leader
    leaders = []
    for name, level in zip(names, levels, strict=True):
        cost, error = line_ends[name]
        color = colors["primary"] if name == chosen else colors["block"]
        # A dotted leader is no part of the line.
        joint = line([float(cost), edge], [float(error), level], color=colors["faint"], width=1, dash="dot")
        # The symbol of the line is only at the name.
        look = {"opacity": 1, "color": color, "line": {"width": 0}}
        marker = {"symbol": symbols.get(name, "circle"), "size": [0, _SYMBOL * (name in symbols)], **look}
        properties = {"mode": "lines+markers", "marker": marker, "cliponaxis": False}
        leaders.append(joint | properties | WITHOUT_HOVER | {"yaxis": "y2"})
    texts = []
    for name, label in zip(names, labels, strict=True):
        texts.append(f'<b style="color:{colors["primary"]}">{label}</b>' if name == chosen else label)
    right_axis = log_axis("", limits) | {
        "overlaying": "y",
        "side": "right",
        "showgrid": False,
        "showline": False,
        "ticks": "",
        "ticklabelstandoff": 8,
        "tickvals": levels,
        "ticktext": texts,
    }
    return leaders, right_axis


def draw_phase_errors(
    periods: Sequence[float], curves: Mapping[str, Sequence[float]], chosen: str, colors: Colors
) -> EncodedFigure:
    """Draw the phase error against the number of periods for each method; both axes logarithmic.

    Each line has its name at the right edge.

    Parameters
    ----------
    periods : 1, 10, 100, …
    curves : name → phase error [rad]
    chosen : the name of the method that is drawn strongly, among gray ones
    colors : the theme's
    """
    hover = _AFTER.format(periods="%{customdata[0]}", error="%{customdata[1]}\u202frad") + _NAMED
    limits = 1e-17, 1e3
    symbols = dict(zip(curves, logarithmic.SYMBOLS, strict=False))
    traces = []
    for name, errors in curves.items():
        look = {"color": colors["primary"], "width": _STRONG} if name == chosen else _gray(colors)
        properties = {
            "name": name,
            "mode": "lines+markers",
            "marker": {"symbol": symbols[name], "size": _SYMBOL},
            "hovertemplate": hover,
            "customdata": _points(periods, errors),
        }
        traces.append(line(list(periods), list(errors), **look) | properties)
    line_ends = {name: (periods[-1], max(errors[-1], limits[0])) for name, errors in curves.items()}
    leaders, names = _name_lines(line_ends, chosen, periods[-1], limits, symbols, colors, leader=1.0)
    traces += leaders
    lost = _("phase lost")
    traces.append(level_line([periods[0], periods[-1]], 1.0, lost, colors))
    # An error of 1 rad is a sixth of a turn. No error is larger than half a turn.
    edges = {"xref": "paper", "x0": 0, "x1": 1, "y0": 1.0, "y1": limits[1], "line": {"width": 0}}
    band = {"type": "rect", **edges, "fillcolor": colors["top"], "opacity": 0.2, "layer": "below"}
    place = {"xanchor": "left", "yanchor": "bottom", "xshift": 6, "yshift": 2}
    notes = [note(f"<b>{lost}</b>", colors["top_ink"], np.log10(periods[0]), 0.0) | place]
    x_range = float(np.log10(periods[0])), float(np.log10(periods[-1])) + 1.1
    x_axis = axis(_("periods"), x_range, type="log", dtick=5)
    y_axis = log_axis(_("phase error [rad]"), limits, decades=3)
    return build_figure(
        traces, colors, 320, margin=_MARGIN, annotations=notes, shapes=[band], xaxis=x_axis, yaxis=y_axis, yaxis2=names
    )


def _points(x: Iterable[float], y: Iterable[float]) -> list[list[str]]:
    """Return the formatted coordinates of each point."""
    return [list(point) for point in zip(_format_numbers(x), _format_numbers(y), strict=True)]


def _format_numbers(values: Iterable[float]) -> list[str]:
    """Return the formatted numbers. Plotly would write 3.2e-7 in every language."""
    return [number(float(value), 3, strip=True) for value in values]


def _describe_steps(n: int) -> str:
    sentence = ngettext("{n} step per period", "{n} steps per period", n)
    return sentence.format(n=n)
