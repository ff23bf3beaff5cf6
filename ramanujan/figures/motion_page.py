"""The figures of the motion page: panels with a common time axis, the phase plane, and the required friction."""

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby, product
from typing import Any

import numpy as np

from ramanujan.figures import NO_NAME, EncodedFigure, build_figure, legend, line, note
from ramanujan.text.numerals import fixed, number
from ramanujan.text.translation import _

_HEIGHT = 420
"""The total height of the panels and the gaps between them [px]."""
_GAP = 0.12
"""The gap between two panels, in fractions of the plotting area."""
_BELOW = 48
_ABOVE = 28
"""The margins below and above the plotting area [px]."""
_LEAST_HEIGHT = 0.07
"""The least height of an area with a name, in fractions of the axis: the letters of a slide."""

_LETTER_WIDTH = 0.0105
"""The width of a letter on a line of a slide, in fractions of the plotting area."""


@dataclass(frozen=True)
class TimeCurve:
    """A curve against time, with its values at equal steps.

    `name` appears in the hover text, `label` in the legend, once for all curves with the same label, or on the line in
    the colour `ink`. Curves that are `is_stacked` are filled and lie on top of each other.
    """

    name: str
    values: np.ndarray
    color: str
    label: str
    width: float = 2.5
    dash: str = "solid"
    is_stacked: bool = False
    is_hatched: bool = False
    ink: str | None = None

    @property
    def look(self) -> dict[str, Any]:
        """The line properties for Plotly."""
        return {"color": self.color, "width": self.width, "dash": self.dash, "shape": "spline"}


@dataclass(frozen=True)
class Panel:
    """Curves with a common vertical axis: its title, its unit, its curves and its range."""

    title: str
    unit: str
    curves: Sequence[TimeCurve]
    range: tuple[float, float]


def draw_time_panels(
    panels: Sequence[Panel], *, period: float, periods: int, colors: Mapping[str, str], names_lines: bool = False
) -> EncodedFigure:
    """Draw panels above each other with one time axis that starts at release.

    Parameters
    ----------
    panels : from top to bottom; every curve has its values at the same n equal steps from 0 to periods · period
    period : of the machine [s]; a line marks the end of the first period
    periods : number of periods on the time axis, at least one
    colors : ink, faint and paper
    names_lines : whether the names are on the lines of the first panel instead of in the legend, if there is room
    """
    end = period * periods
    axes: dict[str, Any] = {}
    traces: list[dict[str, Any]] = []
    named: dict[tuple[str, ...], dict[str, Any]] = {}
    first = panels[0]
    if first.curves[0].is_stacked:
        named = _name_stack(first, end, colors)
    elif names_lines:
        times = np.linspace(0, end, len(first.curves[0].values))
        values = [curve.values for curve in first.curves]
        named = _name_lines(first.curves, [times] * len(values), values, (0, end), first.range, 0.1)
    labels = set().union(*named)
    for place, (panel, domain) in enumerate(zip(panels, _domains(len(panels)), strict=True), start=1):
        axis = "y" if place == 1 else f"y{place}"
        for curve in panel.curves:
            traces.append(
                _trace(curve, panel, axis, end, has_several_panels=len(panels) > 1, is_named=curve.label not in labels)
            )
            labels.add(curve.label)
        title = _("{quantity} [{unit}]").format(quantity=panel.title, unit=panel.unit)
        axes[f"yaxis{axis[1:]}"] = _axis(title, panel.range, domain=domain, nticks=6, **_zero_line(colors))
    end_of_first_period = _vertical_line(period, {"color": colors["ink"], "width": 1, "dash": "dot"}, layer="below")
    notes = [_text_above(period, _("one period"), font={"size": 12}), *named.values()]
    hover_title = {"text": "<i>t</i> = %{x:.4~g} s"}
    time_axis = _axis(
        _("time after release <i>t</i> [s]"), (0, end), anchor="free", position=0, unifiedhovertitle=hover_title
    )
    return _lay_out(
        traces,
        colors,
        shapes=[end_of_first_period],
        annotations=notes,
        meta={"cursor": "time", "period": period, "periods": periods},
        xaxis=time_axis,
        **axes,
        **legend(),
        # One small hover box for all panels hides little of the curves.
        hovermode="x unified",
        hoversubplots="axis",
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
    displacement_range, (low, high) = ranges
    # A long drift does not flatten the plane: it is at least as high as a third of its width.
    margin = max(0.0, float(np.ptp(displacement_range)) / 3 - (high - low)) / 2
    velocity_range = low - margin, high + margin
    return _lay_out(
        traces,
        colors,
        xaxis=_axis(_("displacement [cm]"), displacement_range, **centred),
        yaxis=_axis(_("velocity <i>v</i>/Ω [cm]"), velocity_range, scaleanchor="x", **centred),
        hovermode="closest",
        meta={"cursor": "orbit", "period": period, "periods": periods},
        **legend(),
    )


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
    traces: list[dict[str, Any]], colors: Mapping[str, str], *, height: int = _HEIGHT, **layout: Any
) -> EncodedFigure:
    margin = {"t": _ABOVE, "b": _BELOW, "l": 64}
    return build_figure(traces, colors, height + _BELOW + _ABOVE, margin=margin, uirevision="stay", **layout)


def _axis(title: str, ends: tuple[float, float], **more: Any) -> dict[str, Any]:
    """Return an axis with its title and its range."""
    return {"title": {"text": title}, "range": list(ends), **more}


def _zero_line(colors: Mapping[str, str]) -> dict[str, Any]:
    """Return the properties of an axis that draw its zero as a thin line."""
    return {"zeroline": True, "zerolinecolor": colors["ink"], "zerolinewidth": 0.5}


def _vertical_line(x: float, line: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Return a vertical line at x through its panel."""
    ends = {"x0": x, "x1": x, "xref": "x", "y0": 0, "y1": 1, "yref": "y domain"}
    return {"type": "line", **ends, "line": line, **more}


def _text_above(x: float, text: str, **more: Any) -> dict[str, Any]:
    """Return words above the panels at x."""
    return {"x": x, "y": 1, "yref": "paper", "yanchor": "bottom", "text": text, "showarrow": False, **more}


def _name_stack(panel: Panel, end: float, colors: Mapping[str, str]) -> dict[tuple[str, ...], dict[str, Any]]:
    """Return label → annotation for each stacked area of a panel, and for its last curve, their constant sum.

    The name of an area is where it is highest, in front of the line after one period. An area that is too low for
    letters has its name above the sum, with a line to the area.
    """
    *areas, total = panel.curves
    last = len(total.values) - 1
    above = (total.values[0] + panel.range[1]) / 2
    sum_name = note(_in_ink(total), None, 0, total.values[0])
    names: dict[tuple[str, ...], dict[str, Any]] = {}
    names[(total.label,)] = sum_name | {"xanchor": "left", "yanchor": "bottom", "xshift": 6}
    # A name above the sum takes a quarter of the time axis. The first quarter has the name of the sum.
    free_quarters = [2, 3, 1]
    floor = np.zeros_like(total.values)
    for label, parts in groupby(areas, key=lambda curve: curve.label):
        height = np.sum([curve.values for curve in parts], axis=0)
        # The first fifth contains the crest beside the axis, which is too narrow for a long name.
        crest = _crest(height, last // 5, last // 2)
        if height[crest] > _LEAST_HEIGHT * panel.range[1]:
            # Near the top of a high area, a name does not touch the names in the areas beside it.
            above_floor = max(height[crest] / 2, height[crest] - panel.range[1] / 10)
            names[(label,)] = note(label, None, end * crest / last, floor[crest] + above_floor)
        elif free_quarters and height.any():
            quarter = free_quarters.pop(0)
            crest = _crest(height, quarter * last // 4, (quarter + 1) * last // 4)
            time = end * crest / last
            line_to_area = {"showarrow": True, "arrowhead": 6, "arrowwidth": 1.5, "arrowcolor": colors["ink"]}
            start = {"axref": "x", "ayref": "y", "ax": time, "ay": float(above)}
            names[(label,)] = note(label, None, time, floor[crest] + height[crest] / 2) | line_to_area | start
        floor = floor + height
    return names


def _crest(values: np.ndarray, first: int, last: int) -> int:
    """Return the index of the largest value from `first` up to and without `last`."""
    return first + int(values[first:last].argmax())


def _in_ink(curve: TimeCurve) -> str:
    """Return the label of a curve in its colour for words."""
    return f'<span style="color:{curve.ink}">{curve.label}</span>'


def _name_lines(
    curves: Sequence[TimeCurve],
    abscissas: Sequence[np.ndarray],
    ordinates: Sequence[np.ndarray],
    abscissa_range: tuple[float, float],
    ordinate_range: tuple[float, float],
    letter_height: float,
) -> dict[tuple[str, ...], dict[str, Any]]:
    """Return labels → annotation just above or below its curve, where it has the most room.

    Curves that coincide share one annotation. A curve without room for its label has none.

    Parameters
    ----------
    curves : their labels and inks
    abscissas, ordinates : their points, for each curve two arrays of equal length
    abscissa_range, ordinate_range : of the axes
    letter_height : in fractions of the plotting area
    """
    left, right = abscissa_range
    bottom, top = ordinate_range
    paths = [
        np.array([(x - left) / (right - left), (y - bottom) / (top - bottom)])
        for x, y in zip(abscissas, ordinates, strict=True)
    ]
    groups: list[list[int]] = []
    for index, path in enumerate(paths):
        same = next((group for group in groups if np.allclose(paths[group[0]], path, atol=2e-3)), None)
        if same:
            same.append(index)
        else:
            groups.append([index])
    names: dict[tuple[str, ...], dict[str, Any]] = {}
    taken: list[tuple[np.ndarray, np.ndarray]] = []
    for group in groups:
        letters = re.sub("<.*?>", "", ", ".join(curves[index].label for index in group))
        size = np.array([_LETTER_WIDTH * (len(letters) + 2), letter_height])
        path = paths[group[0]]
        others = np.concatenate([other for index, other in enumerate(paths) if index not in group] or [path], axis=1)
        place = _find_place(path, others, size, taken)
        if place is None:
            continue
        index, side = place
        taken.append((_centre(path, index, side, size), size))
        text = ", ".join(_in_ink(curves[each]) for each in group)
        words = note(text, None, abscissas[group[0]][index], ordinates[group[0]][index])
        anchor = {"yanchor": "bottom" if side > 0 else "top", "yshift": 4 * side}
        names[tuple(curves[each].label for each in group)] = words | anchor
    return names


def _find_place(
    path: np.ndarray, others: np.ndarray, size: np.ndarray, taken: Sequence[tuple[np.ndarray, np.ndarray]]
) -> tuple[int, int] | None:
    """Return the point of a curve, and the side (1 above, −1 below), at which a label has the most room, or None.

    Parameters
    ----------
    path, others : the points of the curve, and those of all other curves, in fractions of the plotting area
    size : width and height of the label
    taken : centre and size of the other labels
    """
    best = None
    for index, side in product(range(0, path.shape[1], 4), (1, -1)):
        centre = _centre(path, index, side, size)
        is_inside = np.all(centre >= size / 2) and np.all(centre <= 1 - size / 2)
        if not is_inside or any(np.all(abs(centre - place) < (size + extent) / 2) for place, extent in taken):
            continue
        touched = _count_inside(path, centre, size) + _count_inside(others, centre, size)
        # Among equal places, choose the one that is farthest from other curves.
        cost = touched, _count_inside(others, centre, size * [1, 3])
        if best is None or cost < best[0]:
            best = cost, (index, side)
    return best and best[1]


def _centre(path: np.ndarray, index: int, side: int, size: np.ndarray) -> np.ndarray:
    """Return the centre of a label above or below a point of a curve."""
    return path[:, index] + [0, side * 0.7 * size[1]]


def _count_inside(points: np.ndarray, centre: np.ndarray, size: np.ndarray) -> int:
    """Return the number of points in a rectangle."""
    return int(np.sum(np.all(abs(points - centre[:, None]) < size[:, None] / 2, axis=0)))


def _domains(panels: int) -> list[list[float]]:
    """Return the vertical domain of each panel, from top to bottom, in fractions of the plotting area."""
    height = (1 - _GAP * (panels - 1)) / panels
    domains = []
    for number_from_below in reversed(range(panels)):
        low = number_from_below * (height + _GAP)
        domains.append([low, min(1.0, low + height)])
    return domains


def _trace(
    curve: TimeCurve, panel: Panel, axis: str, end: float, *, has_several_panels: bool, is_named: bool
) -> dict[str, Any]:
    # TRANSLATORS: at a curve under the pointer: "hoop: 3.2 cm".
    hover = _("{name}: {value} {unit}").format(name=curve.name, value="%{y}", unit=panel.unit) + NO_NAME
    if has_several_panels and curve is panel.curves[0]:
        # In the common hover box the first curve of each panel adds the panel's title.
        hover = f"<b>{panel.title}</b><br>{hover}"
    trace: dict[str, Any] = {
        "type": "scatter",
        # Equal steps need no array of times. Single precision is much finer than a pixel.
        "x0": 0,
        "dx": end / (len(curve.values) - 1),
        "y": curve.values.astype(np.float32),
        "yaxis": axis,
        "name": curve.label,
        "legendgroup": curve.label,
        "showlegend": is_named,
        "mode": "lines",
        "line": curve.look,
        # By default Plotly writes a space before the colon.
        "hovertemplate": hover,
        # Plotly writes a minus sign with this property, but a hyphen with a format in the template.
        "yhoverformat": ".3~g",
    }
    if curve.is_stacked:
        trace |= {"stackgroup": "stack", "fillcolor": curve.color, "line": curve.look | {"width": 0.5}}
        if curve.is_hatched:
            trace["fillpattern"] = {"shape": "/", "size": 5, "solidity": 0.35, "fgcolor": curve.color}
    return trace
