"""The figure of Ω²m/k against the mass ratio on the first page, and common parts for the figure on the page 1729."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.figures import (
    MASS_RATIO,
    NO_NAME,
    NORMALIZED,
    WITHOUT_HOVER,
    EncodedFigure,
    build_figure,
    line,
    marks,
    note,
)
from ramanujan.text.translation import _


@dataclass(frozen=True)
class Mark:
    """A labelled point of the curve: ε, Ω²m/k, and its label (in Plotly's small HTML)."""

    ratio: float
    value: float
    label: str


@dataclass(frozen=True)
class FrequencyCurve:
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


_INSET_RATIOS, _INSET_VALUES = (0.8, 1.4), (0.77, 1.26)
"""The ranges of ε and of Ω²m/k in the inset, which separates the marked ratios, even on a phone."""
_IN_INSET = {"xaxis": "x2", "yaxis": "y2"}
_INSET_ACROSS, _INSET_UP = (0.125, 0.53), (0.15, 0.6)
"""The horizontal and vertical domain of the inset, below the curve, in fractions of the panel."""
NEAR_MARK = 0.02
"""Largest relative distance from the ratio of a marked machine at which the pointer finds the mark, not the curve."""


def draw_frequency_curve(curve: FrequencyCurve, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw Ω²m/k against ε: the curve, its two limits, and an inset around the marked ratios.

    On the page, a moving ring in panel and inset marks the current machine.

    Parameters
    ----------
    curve : the curve and its limits, which are drawn only near the curve
    colors : ink, faint, paper, primary, hoop_ink, top
    """
    ratio_range = curve.ratios[[0, -1]].astype(np.float32).tolist()
    highest = 1.16 * curve.light_limit
    hover = f"%{{fullData.name}}<br><i>ε</i> = %{{x:.5g}}<br>{NORMALIZED} = %{{y:.5g}}{NO_NAME}"
    box = {"mirror": True, "showgrid": False, "fixedrange": True, "dtick": 0.2}
    return draw_over_ratios(
        [*_curves(curve, ratio_range, colors), *_marked_machines(curve, colors)],
        highest,
        hover,
        colors,
        {"type": "log", "range": np.log10(ratio_range).tolist(), "dtick": 1},
        height=384,
        meta={"ring": colors["primary"]},
        shapes=_inset_shapes(ratio_range, highest, curve.unit.value, colors),
        annotations=_curve_labels(curve, ratio_range, colors),
        xaxis2=box | {"range": list(_INSET_RATIOS), "domain": list(_INSET_ACROSS), "anchor": "y2"},
        yaxis2=box | {"range": list(_INSET_VALUES), "domain": list(_INSET_UP), "anchor": "x2"},
    )


def _curves(curve: FrequencyCurve, ratio_range: list[float], colors: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return the traces of the two limits, of the curve, and of the curve in the inset."""
    # Single precision is a thousand times finer than a pixel, with half the bytes.
    ratios, values = curve.ratios.astype(np.float32), curve.values.astype(np.float32)
    heavy_limit = curve.heavy_limit.astype(np.float32)
    # Above this value the asymptote is far from the curve and would cross a label.
    is_near_curve = heavy_limit <= 0.75 * curve.light_limit
    least, most = _INSET_RATIOS
    is_in_inset = (least <= ratios) & (ratios <= most)
    for mark in (curve.equal, curve.unit):
        is_in_inset &= ~np.isclose(ratios, mark.ratio, rtol=NEAR_MARK, atol=0)
    limit = {"color": colors["ink"], "width": 1.5, "dash": "dot"}
    look = {"color": colors["primary"], "width": 3, "shape": "spline"}
    named = {"name": _("machine with this mass ratio")}
    return [
        line(ratio_range, [curve.light_limit] * 2, **limit) | WITHOUT_HOVER,
        line(ratios[is_near_curve], heavy_limit[is_near_curve], **limit) | WITHOUT_HOVER,
        line(ratios, values, **look) | named,
        line(ratios[is_in_inset], values[is_in_inset], **look) | named | _IN_INSET,
    ]


def _marked_machines(curve: FrequencyCurve, colors: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return the marks in the inset: equal masses, and unit frequency."""
    traces = []
    for mark, name, symbol, size, color in (
        (curve.equal, _("equal masses"), "circle", 11, colors["hoop_ink"]),
        (curve.unit, _("in step with the plain mass"), "star", 15, colors["top"]),
    ):
        outlined = marks([mark.ratio], [mark.value], symbol, size, color, width=3, color=color)
        traces.append(outlined | {"name": name} | _IN_INSET)
    return traces


def _curve_labels(curve: FrequencyCurve, ratio_range: list[float], colors: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return the labels of the limits, and of the line and the machines in the inset."""
    ratios, heavy_limit = curve.ratios.astype(np.float32), curve.heavy_limit.astype(np.float32)
    # At this point the space to the right of the asymptote, above the line “in step”, is empty.
    free_index = int(np.argmin(np.abs(heavy_limit - 0.59 * curve.light_limit)))
    light, heavy = limit_labels(curve)
    least, most = _INSET_RATIOS
    low, _high = _INSET_VALUES
    beside = {"xanchor": "left", "yanchor": "bottom", "xshift": 6, "yshift": 3, "align": "left"}
    in_inset = beside | {"xref": "x2", "yref": "y2"}
    at_end = {"xanchor": "right", "xshift": -6}
    # On the panel's logarithmic axis the coordinate of a text is a logarithm; the axes of the inset are linear.
    return [
        note(light, None, np.log10(ratio_range[0]), curve.light_limit) | beside,
        note(heavy, None, np.log10(ratios[free_index]), heavy_limit[free_index]) | beside,
        note(_("in step"), colors["primary"], most, curve.unit.value) | in_inset | at_end,
        note(curve.equal.label, None, curve.equal.ratio, curve.equal.value) | in_inset | {"xshift": 8, "yshift": 6},
        note(curve.unit.label, colors["top"], least, low) | in_inset | {"yshift": 4},
    ]


def limit_labels(curve: FrequencyCurve) -> tuple[str, str]:
    """Return the labels of the limits for light and for heavy rollers."""
    light = _("light rollers: {value}").format(value=curve.light)
    heavy = _("heavy rollers:<br>{value}").format(value=curve.heavy)
    return light, heavy


def _inset_shapes(
    ratio_range: list[float], highest: float, unit: float, colors: Mapping[str, str]
) -> list[dict[str, Any]]:
    """Return the lines “in step”, the background of the inset, the frame of its region, and the joining lines."""
    least, most = _INSET_RATIOS
    low, high = _INSET_VALUES
    _left, inset_right = _INSET_ACROSS
    inset_bottom, inset_top = _INSET_UP
    dashed = {"color": colors["primary"], "width": 1.5, "dash": "dash"}
    in_step = {"type": "line", "line": dashed, "layer": "below", "x0": 0, "x1": 1, "y0": unit, "y1": unit}
    domains = {"xref": "x domain", "yref": "y domain"}
    thin = {"line": {"color": colors["ink"], "width": 1}, "opacity": 0.5} | domains
    # The region of the inset's ranges, in fractions of the panel.
    log_least, log_most = np.log(ratio_range)
    region_left, region_right = (np.log([least, most]) - log_least) / (log_most - log_least)
    region_bottom, region_top = low / highest, high / highest
    ground = {"type": "rect", "fillcolor": colors["paper"], "line": {"width": 0}, "layer": "below", "x1": 1, "y1": 1}
    return [
        in_step | {"xref": "x domain", "yref": "y"},
        # The background extends below and to the left of the inset, behind its tick labels.
        ground | {"x0": -0.2, "y0": -0.25, "xref": "x2 domain", "yref": "y2 domain"},
        in_step | {"xref": "x2 domain", "yref": "y2"},
        thin | {"type": "rect", "x0": region_left, "x1": region_right, "y0": region_bottom, "y1": region_top},
        # Two lines join the inset and its region.
        thin | {"type": "line", "x0": inset_right, "x1": region_left, "y0": inset_bottom, "y1": region_bottom},
        thin | {"type": "line", "x0": inset_right, "x1": region_left, "y0": inset_top, "y1": region_top},
    ]


def draw_over_ratios(
    traces: list[dict[str, Any]],
    highest: float,
    hover: str,
    colors: Mapping[str, str],
    ratio_axis: Mapping[str, Any],
    *,
    height: int,
    **more: Any,
) -> EncodedFigure:
    """Return a figure of Ω²m/k against the mass ratio.

    Parameters
    ----------
    traces, hover, colors : as in `build_figure`
    highest : the upper end of the axis of Ω²m/k, which begins at 0
    ratio_axis : properties of the axis of the mass ratio
    height : of the figure [px]
    more : further layout properties of Plotly
    """
    upward = {"title": {"text": NORMALIZED}, "range": [0, highest], "fixedrange": True}
    across = {"title": {"text": MASS_RATIO}, "fixedrange": True, **ratio_axis}
    return build_figure(traces, colors, height, hover, xaxis=across, yaxis=upward, **more)


def arrow_label(mark: Mark, offset: tuple[float, float], anchor: str, colors: Mapping[str, str]) -> dict[str, Any]:
    """Return the label of a mark, with an arrow to the mark.

    Parameters
    ----------
    mark : the mark
    offset : of the anchor from the mark, right and down [px]
    anchor : "left" or "right", the edge of the label at which the arrow begins
    colors : ink
    """
    right, down = offset
    words = {"text": mark.label, "xanchor": anchor, "align": "left"}
    arrow = {"ax": right, "ay": down, "arrowcolor": colors["ink"], "arrowwidth": 1, "arrowhead": 0, "standoff": 8}
    return {"x": mark.ratio, "y": mark.value, **words, **arrow}
