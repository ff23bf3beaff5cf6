"""The figures of the motion page: curves over time, the phase plane, and the required friction."""

import math
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import numpy as np
from plotly.colors import hex_to_rgb

from ramanujan.figures import (
    NO_NAME,
    WITHOUT_HOVER,
    EncodedFigure,
    build_figure,
    line,
    note,
    spread,
    without_tags,
)
from ramanujan.text.numerals import fixed, number
from ramanujan.text.translation import _

_HEIGHT, _PLANE_HEIGHT = 356, 420
"""The height of curves over time, and of a phase plane [px]."""
_FLAT_HEIGHT, _FLATTEST = 280, 1.6
"""The height of a phase plane as flat as possible [px], and the ratio of its width to its height."""
_BELOW = 48
_ABOVE = 28
"""The margins below and above the plotting area [px]."""
_LEAST_HEIGHT = 0.07
"""The least height of an area with a name, in fractions of the axis: the letters of a slide."""
_GAP = 0.09
"""The gap between two panels, in fractions of the plotting area."""
_LEADER = 16
"""The length of the line from the end of a curve to its name [px]."""
_LINE_HEIGHT, _PLANE_LINE_HEIGHT, _FLAT_LINE_HEIGHT = 0.095, 0.13, 0.16
"""The height of a line of a name on a slide, in fractions of the plotting area, of a phase plane, and of a flat one."""
_LONGEST_NAME, _NARROW_NAME = 17, 11
"""The largest number of letters of a name in one line, and beside a phase plane, which needs the width itself."""
_Marks = tuple[list[dict[str, Any]], list[dict[str, Any]]]
"""Annotations and shapes."""
FASTEST = 0.25
"""The time before the end of a whole period at which a body that was released at rest is fastest [periods]."""


@dataclass(frozen=True)
class TimeCurve:
    """A curve against time, with its values at equal steps.

    `name` appears in the hover text, and `label` in the colour `ink` beside the curve. Curves that are
    `is_stacked` are filled and lie on top of each other. The area from zero to a curve that `is_filled` is tinted.
    """

    name: str
    values: np.ndarray
    color: str
    label: str
    width: float = 2.5
    dash: str = "solid"
    is_stacked: bool = False
    is_hatched: bool = False
    is_filled: bool = False
    ink: str | None = None

    @property
    def look(self) -> dict[str, Any]:
        """The line properties for Plotly."""
        return {"color": self.color, "width": self.width, "dash": self.dash, "shape": "spline"}


@dataclass(frozen=True)
class Panel:
    """Curves with a common vertical axis: its title, its unit, its curves and its range.

    The area from −`limit` to `limit` is shaded. `limit_label` names it in the figure. The leader to the name of a line
    starts `named_before_end` periods before the end of the line, where lines with a common end differ.
    """

    title: str
    unit: str
    curves: Sequence[TimeCurve]
    range: tuple[float, float]
    limit: TimeCurve | None = None
    limit_label: str = ""
    named_before_end: float = 0.0


def draw_panels(
    panels: Sequence[Panel], *, period: float, periods: int, edge: float | None, colors: Mapping[str, str]
) -> EncodedFigure:
    """Draw panels of equal height below each other, over a common time axis that starts at release.

    Each line has its name at its end, and each stacked area in the area or above it.

    Parameters
    ----------
    panels : every curve has its values at the same n equal steps from 0 to periods · period
    period : of the machine [s]; a line marks the end of the first period
    periods : number of periods on the time axis, at least one
    edge : the time at which the top cylinder is at an edge of the block [s], or None. Its line replaces that of the
        period, and what follows is faint.
    colors : ink, faint and paper
    """
    end = period * periods
    notes, shapes = _mark_time(period, _("one period"), colors) if edge is None else _mark_edge(edge, end, colors)
    traces: list[dict[str, Any]] = []
    axes: dict[str, Any] = {}
    height = (1 - _GAP * (len(panels) - 1)) / len(panels)
    for n, panel in enumerate(panels):
        bottom = (len(panels) - 1 - n) * (height + _GAP)
        y, y_of_names = (f"y{2 * n + 1}", f"y{2 * n + 2}") if n else ("y", "y2")
        traces += [curve | {"yaxis": y} for curve in _trace_panel(panel, end)]
        place = {"domain": [bottom, min(1.0, bottom + height)]}
        title = _("{quantity} [{unit}]").format(quantity=panel.title, unit=panel.unit)
        if len(panels) > 1:
            title = title.replace(" [", "<br>[")
        axis = _axis(title, panel.range, nticks=round(3 + 3 * height), **_zero_line(colors))
        axes[f"yaxis{y[1:]}"] = axis | place
        if panel.curves[0].is_stacked:
            notes += _name_stack(panel, end, colors)
        else:
            share = 1 - panel.named_before_end / periods
            starts = [(end * share, _at(share, curve.values)) for curve in panel.curves]
            row = _LINE_HEIGHT / height
            leaders, names = _name_lines(panel.curves, starts, end, panel.range, line_height=row, axes=(y, y_of_names))
            shapes += leaders
            axes[f"yaxis{y_of_names[1:]}"] = names | place
        if panel.limit:
            label = note(panel.limit_label, panel.limit.ink, 0, panel.range[1])
            notes.append(label | {"xanchor": "left", "xshift": 6, "yanchor": "top", "yshift": -2})
    time_axis = _axis(
        _("time after release <i>t</i> [s]"),
        (0, end),
        anchor=y,
        unifiedhovertitle={"text": "<i>t</i> = %{x:.4~g} s"},
    )
    return _lay_out(
        traces,
        colors,
        height=_HEIGHT,
        shapes=shapes,
        annotations=notes,
        meta={"cursor": "time", "period": period, "periods": periods},
        xaxis=time_axis,
        **axes,
        # One small hover box for all curves hides little of them.
        hovermode="x unified",
        hoverlabel={"font": {"size": 11}},
    )


def draw_phase_plane(
    orbits: Sequence[TimeCurve],
    velocities: Sequence[np.ndarray],
    *,
    ranges: tuple[tuple[float, float], tuple[float, float]],
    period: float,
    periods: int,
    colors: Mapping[str, str],
) -> EncodedFigure:
    """Draw v/Ω against displacement for several coordinates on common axes, so that an oscillation is a circle.

    The leader to the name of an orbit starts where a body that was released at rest is fastest for the last time.

    Parameters
    ----------
    orbits : each with the displacements [cm] at n equal steps of time
    velocities : v/Ω of the same coordinates at the same times [cm]
    ranges : of the displacements and of v/Ω [cm]; the scales are equal, so the axes leave a part of the figure free
    period, periods : the period [s], and the number of periods in the n steps; for the cursor
    colors : ink, faint and paper
    """
    traces = [
        line(orbit.values.astype(np.float32), velocity.astype(np.float32), **orbit.look)
        | {
            "name": orbit.name,
            "hovertemplate": "%{x} cm, <i>v</i>/Ω = %{y} cm",
            "xhoverformat": ".3~g",
            "yhoverformat": ".3~g",
        }
        for orbit, velocity in zip(orbits, velocities, strict=True)
    ]
    # With the constraint "range", each change of the window would widen the ranges further.
    centred = {**_zero_line(colors), "nticks": 7, "constrain": "domain"}
    scale = {"scaleanchor": "x", "constrain": "domain", "constraintoward": "top"}
    title = _text_above(0, _("velocity <i>v</i>/Ω [cm]"), xref="x domain", xanchor="left", xshift=-32, yshift=2)
    displacement_range, (low, high) = ranges
    # A long drift does not flatten the plane further than the height of its figure.
    margin = max(0.0, float(np.ptp(displacement_range)) / _FLATTEST - (high - low)) / 2
    velocity_range = low - margin, high + margin
    share = 1 - FASTEST / periods
    starts = [(_at(share, orbit.values), _at(share, v)) for orbit, v in zip(orbits, velocities, strict=True)]
    place = orbits, starts, displacement_range[1], velocity_range
    line_height = _FLAT_LINE_HEIGHT if is_flat(ranges) else _PLANE_LINE_HEIGHT
    leaders, names = _name_lines(*place, line_height=line_height, longest=_NARROW_NAME)
    return _lay_out(
        traces,
        colors,
        height=_FLAT_HEIGHT if is_flat(ranges) else _PLANE_HEIGHT,
        left=48,
        xaxis=_axis(_("displacement [cm]"), displacement_range, **centred),
        yaxis=_axis("", velocity_range, **centred | scale),
        # Plotly clips the leaders at the area of this axis, so the constraint is repeated.
        yaxis2=names | scale,
        shapes=leaders,
        # Above its axis the title leaves the plane more of the width. The shadow would cover a part of the letter v.
        annotations=[title | {"font": {"shadow": "none"}}],
        hovermode="closest",
        meta={"cursor": "orbit", "period": period, "periods": periods},
    )


def is_flat(ranges: tuple[tuple[float, float], tuple[float, float]]) -> bool:
    """Return whether a drift makes the phase plane with these ranges as flat as possible."""
    displacements, velocities = map(np.ptp, ranges)
    return bool(displacements > _FLATTEST * velocities)


def draw_friction_bars(
    needed: Mapping[str, float], body_colors: Sequence[str], *, friction_coefficient: float, colors: Mapping[str, str]
) -> EncodedFigure:
    """Draw the coefficient of static friction that each contact needs as a bar, and the present one as a line.

    Parameters
    ----------
    needed : contact → least coefficient, dimensionless; the first is drawn on top
    body_colors : of the bars
    friction_coefficient : μ
    colors : ink, faint and paper
    """
    longest = max(*needed.values(), friction_coefficient)
    slips = [value > friction_coefficient for value in needed.values()]
    contacts = [f"{contact}<br><b>{number(value, 3)}</b>" for contact, value in needed.items()]
    outlines = {"color": colors["ink"], "width": [2.5 if slip else 0 for slip in slips]}
    words = [_("<b>slips</b>") if slip else "" for slip in slips]
    bars = {"type": "bar", "orientation": "h", "x": list(needed.values()), "y": contacts, "width": 0.62}
    looks = {"marker": {"color": list(body_colors), "line": outlines}, "hovertemplate": "%{x:.4~g}<extra></extra>"}
    labels = {"text": words, "textposition": "outside", "constraintext": "none", "cliponaxis": False}
    present = f"<b><i>μ</i> = {fixed(friction_coefficient, 2)}</b>"
    return _lay_out(
        [bars | looks | labels],
        colors,
        height=260,
        shapes=[_vertical_line(friction_coefficient, {"color": colors["primary"], "width": 3})],
        annotations=[_text_above(friction_coefficient, present, font={"color": colors["primary"]})],
        yaxis={"autorange": "reversed", "ticks": "", "showgrid": False, "fixedrange": True},
        # The range leaves room for the word at the end of the longest bar on a phone.
        xaxis=_axis(_("friction coefficient"), (0, 1.4 * longest), nticks=5),
    )


def step_range(arrays: Iterable[np.ndarray]) -> tuple[float, float]:
    """Return a range from below 0 to above 0 for all arrays, whose ends are numbers of `round_up`.

    Most changes of the values therefore leave an axis unchanged. The end without values of its sign is a small part of
    the other one.

    >>> step_range([np.array([-6.0, 8.0])])
    (-7.0, 10.0)
    >>> step_range([np.array([0.0, 99.0])])
    (-10.0, 150.0)
    """
    values = np.concatenate([np.ravel(array) for array in arrays])
    lowest, highest = 1.05 * float(values.min()), 1.05 * float(values.max())
    least = round_up(max(-lowest, highest)) / 15
    return -round_up(max(-lowest, least)), round_up(max(highest, least))


def round_up(value: float) -> float:
    """Return the least of 1, 1.5, 2, 3, 4, 5, 7, times a power of ten, that is not below a value; 1 for zero."""
    power = 10.0 ** math.floor(math.log10(value)) if value else 1.0
    return next((digit * power for digit in (1, 1.5, 2, 3, 4, 5, 7) if digit * power >= value), 10 * power)


def _lay_out(
    traces: list[dict[str, Any]], colors: Mapping[str, str], *, height: int, left: int = 64, **layout: Any
) -> EncodedFigure:
    margin = {"t": _ABOVE, "b": _BELOW, "l": left}
    return build_figure(traces, colors, height + _BELOW + _ABOVE, margin=margin, uirevision="stay", **layout)


def _axis(title: str, ends: tuple[float, float], **more: Any) -> dict[str, Any]:
    """Return an axis with its title and its range."""
    return {"title": {"text": title}, "range": list(ends), **more}


def _zero_line(colors: Mapping[str, str]) -> dict[str, Any]:
    """Return the properties of an axis that draw its zero as a thin line."""
    return {"zeroline": True, "zerolinecolor": colors["ink"], "zerolinewidth": 0.5}


def _vertical_line(x: float, line: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Return a vertical line at x through all panels."""
    ends = {"x0": x, "x1": x, "xref": "x", "y0": 0, "y1": 1, "yref": "paper"}
    return {"type": "line", **ends, "line": line, **more}


def _text_above(x: float, text: str, **more: Any) -> dict[str, Any]:
    """Return words above the panels at x."""
    return {"x": x, "y": 1, "yref": "paper", "yanchor": "bottom", "text": text, "showarrow": False, **more}


def _mark_edge(edge: float, end: float, colors: Mapping[str, str]) -> _Marks:
    """Return the mark of the time at which the top cylinder is at the edge, and a veil over all later times."""
    notes, shapes = _mark_time(
        edge, _("top cylinder at the edge"), colors, xanchor="left" if edge < end / 2 else "right"
    )
    ends = {"x0": edge, "x1": end, "y0": 0, "y1": 1, "yref": "paper"}
    veil = {"type": "rect", **ends, "fillcolor": colors["paper"], "opacity": 0.75, "line": {"width": 0}}
    return notes, [veil, *shapes]


def _mark_time(time: float, text: str, colors: Mapping[str, str], **more: Any) -> _Marks:
    """Return words above a time, and a dotted line below them."""
    line = _vertical_line(time, {"color": colors["ink"], "width": 1, "dash": "dot"}, layer="below")
    return [_text_above(time, text, font={"size": 12}, **more)], [line]


def _name_stack(panel: Panel, end: float, colors: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return an annotation for each stacked area of a panel, and for its last curve, their constant sum.

    The name of an area is where it is highest, in front of the line after one period or, for the area on top, behind
    it. An area that is too low for letters has its name above the sum, with a line to the area.
    """
    *areas, total = panel.curves
    last = len(total.values) - 1
    above = (total.values[0] + panel.range[1]) / 2
    sum_name = note(_in_ink(total), None, 0, total.values[0])
    names = [sum_name | {"xanchor": "left", "yanchor": "bottom", "xshift": 6}]
    # A name above the sum takes a quarter of the time axis. The first quarter has the name of the sum.
    free_quarters = [2, 3, 1]
    floor = np.zeros_like(total.values)
    for label, parts in groupby(areas, key=lambda curve: curve.label):
        height = np.sum([curve.values for curve in parts], axis=0)
        # The first fifth contains the crest beside the axis, which is too narrow for a long name. The area on top is
        # high where the others are low; a period later its name does not touch theirs.
        is_on_top = label == areas[-1].label
        crest = _crest(height, 5 * last // 8, 7 * last // 8) if is_on_top else _crest(height, last // 5, last // 2)
        if height[crest] > _LEAST_HEIGHT * panel.range[1]:
            # Near the top of a high area, a name does not touch the names in the areas beside it.
            above_floor = max(height[crest] / 2, height[crest] - panel.range[1] / 10)
            names.append(note(label, None, end * crest / last, floor[crest] + above_floor))
        elif free_quarters and height.any():
            quarter = free_quarters.pop(0)
            crest = _crest(height, quarter * last // 4, (quarter + 1) * last // 4)
            time = end * crest / last
            line_to_area = {"showarrow": True, "arrowhead": 6, "arrowwidth": 1.5, "arrowcolor": colors["ink"]}
            start = {"axref": "x", "ayref": "y", "ax": time, "ay": float(above)}
            names.append(note(label, None, time, floor[crest] + height[crest] / 2) | line_to_area | start)
        floor = floor + height
    return names


def _crest(values: np.ndarray, first: int, last: int) -> int:
    """Return the index of the largest value from `first` up to and without `last`."""
    return first + int(values[first:last].argmax())


def _in_ink(curve: TimeCurve, longest: int = _LONGEST_NAME) -> str:
    """Return the label of a curve in its colour for words, a long one in lines that end at a space or a dash."""
    lines = [curve.label]
    if len(without_tags(curve.label)) > longest:
        lines = textwrap.wrap(curve.label.replace("–", "– "), longest)
    return f'<span style="color:{curve.ink}">{"<br>".join(lines).replace("– ", "–")}</span>'


def _at(share: float, values: np.ndarray) -> float:
    """Return the value at a share of the time span, from values at equal steps."""
    return float(np.interp(share, np.linspace(0, 1, len(values)), values))


def _name_lines(
    curves: Sequence[TimeCurve],
    starts: Sequence[tuple[float, float]],
    end: float,
    heights: tuple[float, float],
    *,
    line_height: float = _LINE_HEIGHT,
    longest: int = _LONGEST_NAME,
    axes: tuple[str, str] = ("y", "y2"),
) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Return leaders from points of lines to their names, and the axis at the right whose tick labels are the names.

    Plotly widens the margin for tick labels, but not for annotations. Inside the plotting area a leader is level and
    dotted. Lines that are named at one point have their names in the order in which they arrive there.

    Parameters
    ----------
    curves : the lines
    starts : of the leaders, x and y
    end : of the plotting area, x
    heights : the range of the vertical axis
    line_height : of a name, in fractions of this range; less if the names would be higher than the range
    longest : the largest number of letters of a name in one line
    axes : the vertical axes of the lines and of the names
    """
    low, high = heights
    before_end = len(curves[0].values) * 15 // 16

    def order(named: tuple[TimeCurve, tuple[float, float]]) -> tuple[float, float]:
        curve, (_x, y) = named
        # Points that are closer together than a pixel are one point.
        return round(y / (high - low), 3), float(curve.values[before_end])

    named = sorted(zip(curves, starts, strict=True), key=order, reverse=True)
    texts = [_in_ink(curve, longest) for curve, _start in named]
    counts = [text.count("<br>") + 1 for text in texts]
    half = (high - low) * min(line_height, 1 / sum(counts)) / 2
    halves = [half * count for count in counts]
    levels = spread([y for _curve, (_x, y) in named], halves, low, high)
    y, y_of_names = axes
    outside = {"xref": "x domain", "xsizemode": "pixel", "xanchor": 1, "x0": 0, "x1": _LEADER}
    to_name = {"type": "line", "yref": y_of_names, **outside}
    leaders = []
    for (curve, (x, start)), level in zip(named, levels, strict=True):
        look = {"color": curve.color, "width": 1.5}
        if x < end:
            level_part = {"type": "line", "layer": "below", "yref": y, "x0": x, "x1": end, "y0": start, "y1": start}
            leaders.append(level_part | {"line": look | {"dash": "dot"}})
        leaders.append(to_name | {"y0": start, "y1": level, "line": look})
    room_for_leaders = {"ticks": "outside", "ticklen": _LEADER + 2, "tickcolor": "rgba(0,0,0,0)"}
    names = {"side": "right", "overlaying": y, "showgrid": False, "showline": False}
    ticks = {"tickvals": levels, "ticktext": texts}
    return leaders, _axis("", heights, **names, **ticks, **room_for_leaders)


def _trace_panel(panel: Panel, end: float) -> list[dict[str, Any]]:
    """Return the traces of the curves of a panel, and below them the area between −limit and limit."""
    curves = [_trace(curve, panel.unit, end) for curve in panel.curves]
    if panel.limit is None:
        return curves
    upper = _trace(panel.limit, panel.unit, end)
    lower = upper | {"y": -upper["y"], **WITHOUT_HOVER}
    return [lower, upper | {"fill": "tonexty", "fillcolor": _tint(panel.limit.color)}, *curves]


def _tint(color: str) -> str:
    """Return a transparent tint of a colour for an area."""
    red, green, blue = hex_to_rgb(color)
    return f"rgba({red},{green},{blue},0.15)"


def _trace(curve: TimeCurve, unit: str, end: float) -> dict[str, Any]:
    # TRANSLATORS: at a curve under the pointer: "hoop: 3.2 cm".
    hover = _("{name}: {value} {unit}").format(name=curve.name, value="%{y}", unit=unit) + NO_NAME
    trace: dict[str, Any] = {
        "type": "scatter",
        # Equal steps need no array of times. Single precision is much finer than a pixel.
        "x0": 0,
        "dx": end / (len(curve.values) - 1),
        "y": curve.values.astype(np.float32),
        "name": curve.label,
        "mode": "lines",
        "line": curve.look,
        # By default Plotly writes a space before the colon.
        "hovertemplate": hover,
        # Plotly writes a minus sign with this property, but a hyphen with a format in the template.
        "yhoverformat": ".3~g",
    }
    if curve.is_filled:
        trace |= {"fill": "tozeroy", "fillcolor": _tint(curve.color)}
    if curve.is_stacked:
        trace |= {"stackgroup": "stack", "fillcolor": curve.color, "line": curve.look | {"width": 0.5}}
    if curve.is_hatched:
        trace["fillpattern"] = {"shape": "/", "size": 5, "solidity": 0.35, "fgcolor": curve.color}
    return trace
