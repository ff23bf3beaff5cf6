"""The figure of Ω²m/k against the mass ratio on the first page, and common parts for the figure on the page 1729."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import MASS_RATIO, NORMALIZED, Drawn, figure, line, marks, note
from ramanujan.translation import _


@dataclass(frozen=True)
class Mark:
    """A labelled point of the curve: ε, Ω²m/k, and its label (in Plotly's small HTML)."""

    ratio: float
    value: float
    label: str


@dataclass(frozen=True)
class Curve:
    """The curve of Ω²m/k with its limits and marked machines.

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


_LENS = (0.8, 1.4), (0.77, 1.24)
"""The ranges of ε and of Ω²m/k in the inset, which separates the marked ratios, even on a phone."""
_PLACE = (0.04, 0.5), (0.16, 0.61)
"""The horizontal and vertical domain of the inset, below the curve, in fractions of the panel."""


def frequency_curve(curve: Curve, colors: Mapping[str, str]) -> Drawn:
    """Draw Ω²m/k against ε: the curve, its two limits, and an inset around the marked ratios.

    On the page, a moving ring in panel and inset marks the current machine.

    Parameters
    ----------
    curve : the curve and its limits, which are drawn only near the curve
    colors : ink, faint, paper, primary, hoop_ink, top
    """
    # Single precision is a thousand times finer than a pixel, with half the bytes.
    ratios, values, heavy_limit = (
        array.astype(np.float32) for array in (curve.ratios, curve.values, curve.heavy_limit)
    )
    # Above this value the asymptote is far from the curve and would cross a label.
    below = heavy_limit <= 0.75 * curve.light_limit
    limit = {"color": colors["ink"], "width": 1.5, "dash": "dot"}
    no_hover = {"name": _("limit"), "hoverinfo": "skip"}
    ends, highest = ratios[[0, -1]].tolist(), 1.16 * curve.light_limit
    (least, most), (low, high) = _LENS
    near, inset = (least <= ratios) & (ratios <= most), {"xaxis": "x2", "yaxis": "y2"}
    look = {"color": colors["primary"], "width": 3, "shape": "spline"}
    traces = [
        line(ends, [curve.light_limit] * 2, **limit) | no_hover,
        line(ratios[below], heavy_limit[below], **limit) | no_hover,
        line(ratios, values, **look) | {"name": _("any machine")},
        line(ratios[near], values[near], **look) | {"name": _("any machine")} | inset,
    ]
    shown = (
        (curve.equal, _("equal masses"), "circle", 11, colors["hoop_ink"]),
        (curve.unit, _("unit frequency"), "star", 15, colors["top"]),
    )
    for mark, name, symbol, size, color in shown:
        outlined = marks([mark.ratio], [mark.value], symbol, size, color, width=3, color=color)
        traces.append(outlined | {"name": name} | inset)
    # At this point the space right of the asymptote, above the line “in step”, is empty.
    there = int(np.argmin(np.abs(heavy_limit - 0.59 * curve.light_limit)))
    light, heavy = limit_labels(curve)
    beside = {"xanchor": "left", "yanchor": "bottom", "xshift": 6, "yshift": 3, "align": "left"}
    in_lens, at_end = beside | {"xref": "x2", "yref": "y2"}, {"xanchor": "right", "xshift": -6}
    notes = [
        note(light, None, np.log10(ends[0]), curve.light_limit) | beside,
        note(heavy, None, np.log10(ratios[there]), heavy_limit[there]) | beside,
        note(_("in step"), colors["primary"], most, curve.unit.value) | in_lens | at_end,
        note(curve.equal.label, None, curve.equal.ratio, curve.equal.value) | in_lens | {"xshift": 8, "yshift": 3},
        note(curve.unit.label, colors["top"], least, low) | in_lens | {"yshift": 4},
    ]
    hover = f"<i>ε</i> = %{{x:.5g}}<br>{NORMALIZED} = %{{y:.5g}}<extra>%{{fullData.name}}</extra>"
    (left, right), (bottom, top) = _PLACE
    box = {"mirror": True, "showgrid": False, "fixedrange": True}
    return over_ratios(
        traces,
        highest,
        hover,
        colors,
        {"type": "log", "range": np.log10(ends).tolist(), "dtick": 1},
        meta={"ring": colors["primary"]},
        shapes=_lens(ends, highest, curve.unit.value, colors),
        annotations=notes,
        xaxis2=box | {"range": [least, most], "domain": [left, right], "anchor": "y2", "dtick": 0.2},
        yaxis2=box | {"range": [low, high], "domain": [bottom, top], "anchor": "x2", "tickvals": []},
    )


def limit_labels(curve: Curve) -> tuple[str, str]:
    """Return the labels of the limits for light and for heavy rollers."""
    light = _("light rollers: {value}").format(value=curve.light)
    heavy = _("heavy rollers:<br>{value}").format(value=curve.heavy)
    return light, heavy


def _lens(ends: list[float], highest: float, unit: float, colors: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return the lines “in step” of panel and inset, the background of the inset, and the frame of its region."""
    (least, most), (low, high) = _LENS
    (_left, right), (bottom, top) = _PLACE
    dashed = {"color": colors["primary"], "width": 1.5, "dash": "dash"}
    in_step = {"type": "line", "line": dashed, "layer": "below", "x0": 0, "x1": 1, "y0": unit, "y1": unit}
    domains = {"xref": "x domain", "yref": "y domain"}
    thin = {"line": {"color": colors["ink"], "width": 1}, "opacity": 0.5} | domains
    # Fractions of the panel, because a shape on a logarithmic axis has linear coordinates.
    start, end = (np.log([least, most]) - np.log(ends[0])) / (np.log(ends[1]) - np.log(ends[0]))
    corners = ((bottom, low / highest), (top, high / highest))
    ground = {"type": "rect", "fillcolor": colors["paper"], "line": {"width": 0}, "layer": "below", "x0": 0, "x1": 1}
    return [
        in_step | {"xref": "x domain", "yref": "y"},
        # The background extends below the inset, behind its tick labels.
        ground | {"y0": -0.25, "y1": 1, "xref": "x2 domain", "yref": "y2 domain"},
        in_step | {"xref": "x2 domain", "yref": "y2"},
        thin | {"type": "rect", "x0": start, "x1": end, "y0": corners[0][1], "y1": corners[1][1]},
        *(thin | {"type": "line", "x0": right, "x1": start, "y0": at, "y1": to} for at, to in corners),
    ]


def over_ratios(
    traces: list[dict[str, Any]],
    highest: float,
    hover: str,
    colors: Mapping[str, str],
    along: Mapping[str, Any],
    **more: Any,
) -> Drawn:
    """Return a figure of Ω²m/k, from 0 to `highest`, against the mass ratio; `along` are properties of its axis."""
    upward = {"title": {"text": NORMALIZED}, "range": [0, highest], "fixedrange": True}
    across = {"title": {"text": MASS_RATIO}, "fixedrange": True, **along}
    return figure(traces, colors, 384, hover, xaxis=across, yaxis=upward, **more)


def pointed(mark: Mark, to: tuple[float, float], side: str, colors: Mapping[str, str]) -> dict[str, Any]:
    """Return the label of a mark with an arrow; `to` is the offset of the label to the right and down [px]."""
    words = {"text": mark.label, "xanchor": side, "align": "left"}
    arrow = {"ax": to[0], "ay": to[1], "arrowcolor": colors["ink"], "arrowwidth": 1, "arrowhead": 0, "standoff": 8}
    return {"x": mark.ratio, "y": mark.value, **words, **arrow}
