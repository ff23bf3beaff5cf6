"""The figures of the motion page: panels with a common time axis, the phase plane, and the required friction."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import NO_NAME, EncodedFigure, build_figure, horizontal_bars, legend, line
from ramanujan.numerals import fixed, number
from ramanujan.translation import _

_HEIGHT = 420
"""The total height of the panels and the gaps between them [px]."""
_GAP = 0.12
"""The gap between two panels, in fractions of the plotting area."""
_BELOW = 48
_ABOVE = 28
"""The margins below and above the plotting area [px]."""
_PERIOD_HEIGHT = 0.1
"""The height of the words above the panels, in fractions of the plotting area. The legend lies above them."""


@dataclass(frozen=True)
class TimeCurve:
    """A curve against time, with its values at equal steps.

    `name` appears in the hover text, `label` in the legend, once for all curves with the same label. Curves that are
    `is_stacked` are filled and lie on top of each other.
    """

    name: str
    values: np.ndarray
    color: str
    label: str
    width: float = 2.5
    dash: str = "solid"
    is_stacked: bool = False
    is_hatched: bool = False

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
    panels: Sequence[Panel], *, period: float, periods: int, colors: Mapping[str, str]
) -> EncodedFigure:
    """Draw panels above each other with one time axis that starts at release.

    Parameters
    ----------
    panels : from top to bottom; every curve has its values at the same n equal steps from 0 to periods · period
    period : of the machine [s]; a line marks the end of the first period
    periods : number of periods on the time axis, at least one
    colors : ink, faint and paper
    """
    end = period * periods
    axes: dict[str, Any] = {}
    traces: list[dict[str, Any]] = []
    labels: set[str] = set()
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
    notes = [_text_above(period, _("one period"), font={"size": 12})]
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
        **legend(1 + _PERIOD_HEIGHT),
        # One small hover box for all panels hides little of the curves.
        hovermode="x unified",
        hoversubplots="axis",
        hoverlabel={"font": {"size": 11}},
    )


def draw_phase_plane(
    orbits: Sequence[TimeCurve],
    velocities: Sequence[np.ndarray],
    *,
    period: float,
    periods: int,
    colors: Mapping[str, str],
) -> EncodedFigure:
    """Draw velocity against displacement for several coordinates on common axes.

    Parameters
    ----------
    orbits : each with the displacements [cm] at n equal steps of time
    velocities : of the same coordinates at the same times [cm/s]
    period, periods : the period [s], and the number of periods in the n steps; for the cursor
    colors : ink, faint and paper
    """
    traces = [
        line(orbit.values.astype(np.float32), velocity.astype(np.float32), **orbit.look)
        | {"name": orbit.name, "hovertemplate": "%{x} cm, %{y} cm/s", "xhoverformat": ".3~g", "yhoverformat": ".3~g"}
        for orbit, velocity in zip(orbits, velocities, strict=True)
    ]
    centred = {**_zero_line(colors), "nticks": 7}
    return _lay_out(
        traces,
        colors,
        xaxis=_axis(_("displacement [cm]"), widen_range([orbit.values for orbit in orbits]), **centred),
        yaxis=_axis(_("velocity [cm/s]"), widen_range(velocities), **centred),
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
    bars = horizontal_bars(needed.values(), contacts, words, {"color": list(body_colors), "line": outlines})
    present = f"<b><i>μ</i> = {fixed(friction_coefficient, 2)}</b>"
    return _lay_out(
        [bars | {"width": 0.62, "hovertemplate": "%{x:.4~g}<extra></extra>"}],
        colors,
        height=260,
        shapes=[_vertical_line(friction_coefficient, {"color": colors["primary"], "width": 3})],
        annotations=[_text_above(friction_coefficient, present, font={"color": colors["primary"]})],
        yaxis={"autorange": "reversed", "ticks": "", "showgrid": False, "fixedrange": True},
        # The range leaves room for the word at the end of the longest bar on a phone.
        xaxis=_axis(_("friction coefficient"), (0, 1.4 * longest), nticks=5),
    )


def widen_range(arrays: Sequence[np.ndarray]) -> tuple[float, float]:
    """Return the range of all arrays, widened by a seventh on both sides."""
    least, most = min(map(np.min, arrays)), max(map(np.max, arrays))
    margin = (most - least) / 7 or 1.0
    return float(least - margin), float(most + margin)


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
