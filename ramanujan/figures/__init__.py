"""Arrays in, Plotly figures out: one function for each figure, one file for each page, and the look they share.

A figure gets its numbers and its colours from the caller; it computes neither physics nor themes. Every figure fits
a phone: labels are anchored inside the axes and never lie on each other.
"""

from __future__ import annotations

from collections.abc import Mapping

import plotly.graph_objects as go


def template(colors: Mapping[str, str], hover: str | None = None) -> go.layout.Template:
    """Return the look that all figures share: no box, a faint grid, room for labels.

    Parameters
    ----------
    colors : ink, faint and paper
    hover : what hovering over a point says, where a trace does not say otherwise
    """
    axis = {
        "showgrid": True,
        "gridcolor": colors["faint"],
        "zeroline": False,
        "showline": True,
        "linecolor": colors["ink"],
        "ticks": "outside",
        "title": {"standoff": 6},
        "automargin": True,
    }
    layout = go.Layout(
        font={"color": colors["ink"], "size": 14},
        paper_bgcolor="rgba(0,0,0,0)",
        plot_bgcolor="rgba(0,0,0,0)",
        margin={"l": 56, "r": 16, "t": 12, "b": 48},
        xaxis=axis,
        yaxis=axis,
        hoverlabel={"bgcolor": colors["paper"], "font": {"color": colors["ink"]}},
    )
    # Choosing a point must not dim the others.
    keep = {"marker": {"opacity": 1}}
    return go.layout.Template(
        layout=layout, data={"scatter": [{"selected": keep, "unselected": keep, "hovertemplate": hover}]}
    )
