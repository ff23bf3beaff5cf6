"""Figures of Ω²m/k against the mass ratio: that of the first page, and what it shares with that of the page 1729."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import MASS_RATIO, NORMALIZED, Drawn, figure, line, marks
from ramanujan.figures.labels import note
from ramanujan.translation import _


@dataclass(frozen=True)
class Mark:
    """A labelled point of the curve: ε, Ω²m/k, and its label (in Plotly's small HTML)."""

    ratio: float
    value: float
    label: str


@dataclass(frozen=True)
class Curve:
    """What the figure of the first page shows of all machines.

    Parameters
    ----------
    ratios, values : ε and Ω²m/k along the curve, dimensionless, shape (n,)
    light_limit, light : the value for ε → 0, as a number and as an exact expression
    heavy_limit, heavy : the asymptote for ε → ∞ at the same ratios, and as an expression
    equal, unit : the marked machines
    """

    ratios: np.ndarray
    values: np.ndarray
    light_limit: float
    light: str
    heavy_limit: np.ndarray
    heavy: str
    equal: Mark
    unit: Mark


def frequency_curve(curve: Curve, colors: Mapping[str, str]) -> Drawn:
    """Draw Ω²m/k against ε: the curve, its two limits, the two marked ratios, and the line “in step” at 1.

    The page moves a ring over the figure, which marks the present machine.

    Parameters
    ----------
    curve : what is drawn; each asymptote where the curve is close to it
    colors : ink, faint, paper, primary, hoop_ink, top
    """
    # Single precision is a thousand times finer than a pixel, and half the bytes.
    ratios, values, heavy_limit = (
        array.astype(np.float32) for array in (curve.ratios, curve.values, curve.heavy_limit)
    )
    # Further up the asymptote is far from the curve and would cross a label.
    below = heavy_limit <= 0.75 * curve.light_limit
    limit = {"color": colors["ink"], "width": 1.5, "dash": "dot"}
    no_hover = {"name": _("limit"), "hoverinfo": "skip"}
    ends = ratios[[0, -1]].tolist()
    traces = [
        line(ends, [curve.light_limit] * 2, **limit) | no_hover,
        line(ratios[below], heavy_limit[below], **limit) | no_hover,
    ]
    traces.append(line(ratios, values, color=colors["primary"], width=3, shape="spline") | {"name": _("any machine")})
    shown = (
        (curve.equal, _("equal masses"), "circle", 11, colors["hoop_ink"]),
        (curve.unit, _("unit frequency"), "star", 15, colors["top"]),
    )
    for mark, name, symbol, size, color in shown:
        traces.append(marks([mark.ratio], [mark.value], symbol, size, color, width=3, color=color) | {"name": name})
    in_step = {"type": "line", "line": {"color": colors["primary"], "width": 1.5, "dash": "dash"}, "layer": "below"}
    in_step |= {"x0": 0, "x1": 1, "xref": "x domain", "y0": curve.unit.value, "y1": curve.unit.value, "yref": "y"}
    # Here the space to the right of the asymptote is empty, above the line “in step”.
    there = int(np.argmin(np.abs(heavy_limit - 0.59 * curve.light_limit)))
    light = _("light rollers: {value}").format(value=curve.light)
    heavy = _("heavy rollers:<br>{value}").format(value=curve.heavy.replace("ε", "<i>ε</i>"))
    beside = {"xanchor": "left", "yanchor": "bottom", "xshift": 6}
    notes = [
        # The labels are on opposite sides of the curve, so that they do not overlap on a narrow page.
        pointed(curve.equal, (4, -66), "left", colors),
        pointed(curve.unit, (-16, 62), "right", colors),
        note(light, None, np.log10(ends[0]), curve.light_limit) | beside,
        note(_("in step"), colors["primary"], np.log10(ends[0]), curve.unit.value) | beside,
        note(heavy, None, np.log10(ratios[there]), heavy_limit[there]) | beside | {"xshift": 8, "align": "left"},
    ]
    hover = f"<i>ε</i> = %{{x:.5g}}<br>{NORMALIZED} = %{{y:.5g}}<extra>%{{fullData.name}}</extra>"
    more = {"shapes": [in_step], "annotations": notes, "meta": {"ring": colors["primary"]}}
    return over_ratios(traces, ends, 1.16 * curve.light_limit, hover, colors, **more)


def over_ratios(
    traces: list[dict[str, Any]],
    ends: tuple[float, float],
    highest: float,
    hover: str,
    colors: Mapping[str, str],
    **more: Any,
) -> Drawn:
    """Return a figure of Ω²m/k: the mass ratio between two ends, logarithmic, and Ω²m/k from 0 on."""
    along = {"type": "log", "range": np.log10(ends).tolist(), "dtick": 1, "title": {"text": MASS_RATIO}}
    upward = {"title": {"text": NORMALIZED}, "range": [0, highest], "fixedrange": True}
    return figure(traces, colors, 336, hover, xaxis={**along, "fixedrange": True}, yaxis=upward, **more)


def pointed(mark: Mark, to: tuple[float, float], side: str, colors: Mapping[str, str]) -> dict[str, Any]:
    """Return the label of a mark with an arrow to it; `to` is how far it stands to the right and below [px]."""
    words = {"text": mark.label, "xanchor": side, "align": "left", "bgcolor": colors["paper"]}
    arrow = {"ax": to[0], "ay": to[1], "arrowcolor": colors["ink"], "arrowwidth": 1, "arrowhead": 0, "standoff": 8}
    return {"x": float(np.log10(mark.ratio)), "y": mark.value, **words, **arrow}
