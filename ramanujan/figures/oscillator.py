"""The figure of the first page: Ω²m/k against the mass ratio."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import plotly.graph_objects as go

from ramanujan.figures import MASS_RATIO, NORMALIZED, template
from ramanujan.translation import _


@dataclass(frozen=True)
class Mark:
    """A labelled point of the curve: ε, Ω²m/k, and its label (in Plotly's small HTML)."""

    ratio: float
    value: float
    label: str


def frequency_curve(
    ratios: np.ndarray,
    values: np.ndarray,
    *,
    light_limit: float,
    heavy_limit: np.ndarray,
    limit_labels: tuple[str, str],
    equal: Mark,
    unit: Mark,
    colors: Mapping[str, str],
) -> go.Figure:
    """Draw Ω²m/k against ε: the curve, its two limits, the two marked ratios, and the line “in step” at 1.

    The page moves a ring over the figure, which marks the present machine.

    Parameters
    ----------
    ratios, values : ε and Ω²m/k along the curve, dimensionless, shape (n,)
    light_limit : the value for ε → 0
    heavy_limit : the asymptote for ε → ∞ at the same ratios; drawn where the curve is close to it
    limit_labels : labels of the two limits
    equal, unit : the marked machines
    colors : ink, faint, paper, primary, marker, accent
    """
    hover = f"<i>ε</i> = %{{x:.5g}}<br>{NORMALIZED} = %{{y:.5g}}<extra>%{{fullData.name}}</extra>"
    # Single precision is a thousand times finer than a pixel, and half the bytes.
    ratios, values, heavy_limit = (array.astype(np.float32) for array in (ratios, values, heavy_limit))
    # Further up the asymptote is far from the curve and would cross a label.
    below = heavy_limit <= 0.75 * light_limit
    layout = {"template": template(colors, hover), "height": 336, "showlegend": False}
    figure = go.Figure(layout={**layout, "meta": {"ring": colors["primary"]}})
    limit = {"color": colors["ink"], "width": 1.5, "dash": "dot"}
    curve = {"color": colors["primary"], "width": 3, "shape": "spline"}
    lines = (
        ([ratios[0], ratios[-1]], [light_limit] * 2, limit, _("limit"), "skip"),
        (ratios[below], heavy_limit[below], limit, _("limit"), "skip"),
        (ratios, values, curve, _("any machine"), None),
    )
    for x, y, line, name, hoverinfo in lines:
        figure.add_scatter(x=x, y=y, mode="lines", line=line, name=name, hoverinfo=hoverinfo)
    figure.add_hline(unit.value, line={"color": colors["primary"], "width": 1.5, "dash": "dash"}, layer="below")
    shown = (
        (equal, _("equal masses"), "circle", 11, colors["marker"]),
        (unit, _("unit frequency"), "star", 15, colors["accent"]),
    )
    for mark, name, symbol, size, color in shown:
        figure.add_scatter(
            x=[mark.ratio],
            y=[mark.value],
            mode="markers",
            marker={"symbol": symbol, "size": size, "color": color, "line": {"width": 3, "color": color}},
            name=name,
        )
    label = {"xref": "x", "yref": "y", "arrowcolor": colors["ink"], "arrowwidth": 1, "arrowhead": 0, "standoff": 8}
    label |= {"bgcolor": colors["paper"], "align": "left"}
    # The labels are on opposite sides of the curve, so that they do not overlap on a narrow page.
    figure.add_annotation(label, x=_log(equal.ratio), y=equal.value, text=equal.label, ax=4, ay=-66, xanchor="left")
    figure.add_annotation(label, x=_log(unit.ratio), y=unit.value, text=unit.label, ax=-16, ay=62, xanchor="right")
    beside = {"showarrow": False, "font": {"size": 13}, "xanchor": "left", "yanchor": "bottom", "xshift": 6}
    light_label, heavy_label = limit_labels
    # Here the space to the right of the asymptote is empty, above the line “in step”.
    there = int(np.argmin(np.abs(heavy_limit - 0.59 * light_limit)))
    in_step = {"font": {"color": colors["primary"]}}
    notes = (
        (ratios[0], light_limit, light_label, {}),
        (ratios[0], unit.value, _("in step"), in_step),
        (ratios[there], heavy_limit[there], heavy_label, {"xshift": 8, "align": "left"}),
    )
    for x, y, text, own in notes:
        figure.add_annotation(beside | own, x=_log(x), y=y, text=text)
    figure.update_xaxes(
        type="log", title=MASS_RATIO, range=[_log(ratios[0]), _log(ratios[-1])], dtick=1, fixedrange=True
    )
    figure.update_yaxes(title=NORMALIZED, range=[0, 1.16 * light_limit], fixedrange=True)
    return figure


def _log(value: float) -> float:
    """Return the exponent of ten, by which Plotly places annotations on a logarithmic axis."""
    return float(np.log10(value))
