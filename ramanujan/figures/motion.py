"""The figures of the motion page: panels over one time axis, the phase plane, and the friction that contacts need."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import plotly.graph_objects as go

from ramanujan.figures import template

_HEIGHT = {1: 330, 2: 370}
"""Number of panels → height that they and the gaps between them get [px]."""

_GAP = 0.12
_BELOW = 100
_ABOVE = 26


@dataclass(frozen=True)
class Curve:
    """A curve over time: its name in the legend, its values at equal steps, and how it is drawn.

    Curves that share a `group` are switched together and named once. `stacked` curves are filled, one on the other,
    hatched if they are `hatched`.
    """

    name: str
    values: np.ndarray
    color: str
    width: float = 2.5
    dash: str = "solid"
    group: str | None = None
    stacked: bool = False
    hatched: bool = False


@dataclass(frozen=True)
class Panel:
    """Curves over one axis: the axis's title and unit, and the least range that it shows."""

    title: str
    unit: str
    curves: Sequence[Curve]
    range: tuple[float, float]


def time_panels(panels: Sequence[Panel], *, period: float, periods: int, colors: Mapping[str, str]) -> go.Figure:
    """Draw panels above each other over one time axis that starts at release.

    Parameters
    ----------
    panels : from top to bottom; every curve has its values at the same n equal steps from 0 to periods · period
    period : of the machine [s]; the end of the first is marked
    periods : how many are shown, at least one
    colors : ink, faint and paper
    """
    end = period * periods
    figure = go.Figure(layout=_layout(colors, _HEIGHT[len(panels)]))
    named: set[str] = set()
    for number, (panel, domain) in enumerate(zip(panels, _domains(len(panels)), strict=True), start=1):
        axis = "y" if number == 1 else f"y{number}"
        for curve in panel.curves:
            figure.add_trace(_trace(curve, panel, axis, end, named, several=len(panels) > 1))
        figure.update_layout(
            {
                f"yaxis{axis[1:]}": {
                    "domain": domain,
                    "title": {"text": f"{panel.title} [{panel.unit}]"},
                    "automargin": True,
                    "range": panel.range,
                    "zeroline": True,
                    "zerolinecolor": colors["ink"],
                    "zerolinewidth": 0.5,
                    "nticks": 6,
                }
            }
        )
    figure.add_vline(period, line={"color": colors["ink"], "width": 1, "dash": "dot"}, layer="below")
    figure.add_annotation(
        x=period, y=1, yref="paper", text="one period", showarrow=False, yanchor="bottom", font={"size": 12}
    )
    figure.update_xaxes(
        title="time after release t [s]",
        automargin=True,
        range=[0, end],
        anchor="free",
        position=0,
        unifiedhovertitle={"text": "t = %{x:.4~g} s"},
    )
    figure.update_layout(
        # One small box for all panels, which must not hide what it speaks of.
        hoverlabel={"font": {"size": 11}, "namelength": 12},
        hovermode="x unified",
        hoversubplots="axis",
        meta={"cursor": "time", "period": period, "periods": periods},
    )
    return figure


def phase_plane(
    orbits: Sequence[Curve], velocities: Sequence[np.ndarray], *, period: float, periods: int, colors: Mapping[str, str]
) -> go.Figure:
    """Draw velocity over displacement for coordinates that share one scale.

    Parameters
    ----------
    orbits : each with the displacements [cm] at n equal steps of time
    velocities : of the same coordinates at the same times [cm/s]
    period, periods : the stretch of time that the steps divide [s], for the cursor
    colors : ink, faint and paper
    """
    figure = go.Figure(layout=_layout(colors, _HEIGHT[2]))
    for orbit, velocity in zip(orbits, velocities, strict=True):
        figure.add_scatter(
            x=orbit.values.astype(np.float32),
            y=velocity.astype(np.float32),
            name=orbit.name,
            mode="lines",
            line={"color": orbit.color, "width": orbit.width, "dash": orbit.dash},
            hovertemplate="%{x:.3~g} cm, %{y:.3~g} cm/s",
        )
    places = [orbit.values for orbit in orbits]
    centred = {"zeroline": True, "zerolinecolor": colors["ink"], "zerolinewidth": 0.5, "nticks": 7}
    figure.update_xaxes(centred, title="displacement [cm]", automargin=True, range=roomy(places))
    figure.update_yaxes(centred, title="velocity [cm/s]", range=roomy(velocities))
    figure.update_layout(hovermode="closest", meta={"cursor": "orbit", "period": period, "periods": periods})
    return figure


def friction_bars(
    needed: Mapping[str, float],
    body_colors: Sequence[str],
    *,
    friction_coefficient: float,
    colors: Mapping[str, str],
) -> go.Figure:
    """Draw the coefficient of static friction that each contact needs as a bar, and the present one as a line.

    Parameters
    ----------
    needed : contact → least coefficient, dimensionless; the first is drawn on top
    body_colors : of the bars
    friction_coefficient : μ
    colors : ink, faint and paper
    """
    figure = go.Figure(layout=_layout(colors, 250))
    longest = max(*needed.values(), friction_coefficient)
    slips = [value > friction_coefficient for value in needed.values()]
    figure.add_bar(
        x=list(needed.values()),
        y=[f"{contact}<br><b>{value:.3g}</b>" for contact, value in needed.items()],
        orientation="h",
        marker={
            "color": list(body_colors),
            "line": {"color": colors["ink"], "width": [2.5 if slip else 0 for slip in slips]},
        },
        text=["<b>slips</b>" if slip else "" for slip in slips],
        textposition="outside",
        cliponaxis=False,
        width=0.62,
        hovertemplate="%{x:.4~g}<extra></extra>",
    )
    figure.add_vline(friction_coefficient, line={"color": colors["primary"], "width": 3})
    figure.add_annotation(
        x=friction_coefficient,
        y=1,
        yref="paper",
        yanchor="bottom",
        text=f"<b>μ = {friction_coefficient:.2f}</b>",
        showarrow=False,
        font={"color": colors["primary"]},
    )
    figure.update_yaxes(autorange="reversed", ticks="", showgrid=False, automargin=True, fixedrange=True)
    # What stands at the end of the longest bar needs room, on a phone too.
    figure.update_xaxes(title="friction coefficient needed", range=[0, 1.4 * longest], nticks=5)
    figure.update_layout(showlegend=False, height=250 + _ABOVE + 56, margin={"b": 56})
    return figure


def roomy(arrays: Sequence[np.ndarray]) -> tuple[float, float]:
    """Return a range that holds all the arrays, a twelfth wider on both sides."""
    least, most = min(map(np.min, arrays)), max(map(np.max, arrays))
    margin = (most - least) / 12 or 1.0
    return float(least - margin), float(most + margin)


def _layout(colors: Mapping[str, str], height: int) -> go.Layout:
    return go.Layout(
        template=template(colors),
        height=height + _BELOW + _ABOVE,
        margin={"t": _ABOVE, "b": _BELOW, "l": 64},
        uirevision="stay",
        legend={"orientation": "h", "x": 0, "y": 0, "yref": "container", "yanchor": "bottom", "font": {"size": 13}},
    )


def _domains(panels: int) -> list[list[float]]:
    """Return where each panel stands, from top to bottom, as fractions of the plotting area."""
    share = (1 - _GAP * (panels - 1)) / panels
    lowest_first = [[number * (share + _GAP), number * (share + _GAP) + share] for number in range(panels)]
    return [[low, min(1.0, high)] for low, high in reversed(lowest_first)]


def _trace(curve: Curve, panel: Panel, axis: str, end: float, named: set[str], several: bool) -> go.Scatter:
    # The last word tells two panels apart: "over the ground", "over the block".
    where = f", {panel.title.split()[-1]}" if several else ""
    group = curve.group or curve.name
    trace = go.Scatter(
        # Equal steps need no array, and single precision is far finer than a pixel.
        x0=0,
        dx=end / (len(curve.values) - 1),
        y=curve.values.astype(np.float32),
        yaxis=axis,
        name=curve.name,
        legendgroup=group,
        showlegend=group not in named,
        mode="lines",
        line={"color": curve.color, "width": curve.width, "dash": curve.dash},
        hovertemplate=f"%{{y:.3~g}} {panel.unit}{where}",
    )
    named.add(group)
    if curve.stacked:
        pattern = {"shape": "/", "size": 5, "solidity": 0.35, "fgcolor": curve.color} if curve.hatched else None
        trace.update(stackgroup="stack", fillcolor=curve.color, fillpattern=pattern, line={"width": 0.5})
    return trace
