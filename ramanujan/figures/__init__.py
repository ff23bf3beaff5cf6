"""Plotly figures from arrays: one function for each figure, a file or two for each page, and the look that they share.

The caller gives the numbers and the colours; the functions here compute neither physics nor themes. Every figure fits a
phone: labels are anchored inside the axes and do not overlap.
"""

from collections.abc import Mapping
from typing import Any

from ramanujan.figures.drawn import Drawn, drawn, line, marks
from ramanujan.translation import _

MASS_RATIO = _("mass ratio <i>ε</i> = <i>m</i>′/<i>m</i>")
NORMALIZED = "Ω²<i>m</i>/<i>k</i>"
"""The axes of the curve of Ω². Symbols are italic, as in formulas: capital Greek letters and units are upright."""


_FAMILY = '"Source Sans", sans-serif'
"""The typeface of the page, which page.css brings."""


def template(colors: Mapping[str, str], hover: str | None = None) -> dict[str, Any]:
    """Return the look that all figures share: no box, a faint grid, room for labels.

    Parameters
    ----------
    colors : ink, faint, paper and primary
    hover : the text for a point under the pointer, unless a trace has its own
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
    layout = {
        "font": {"color": colors["ink"], "size": 14, "family": _FAMILY},
        # The page's own ground, so that a figure that is saved in the dark theme can be read.
        "paper_bgcolor": colors["paper"],
        "plot_bgcolor": "rgba(0,0,0,0)",
        "margin": {"l": 56, "r": 16, "t": 12, "b": 48},
        "xaxis": axis,
        "yaxis": axis,
        "modebar": {"bgcolor": colors["paper"], "color": colors["ink"], "activecolor": colors["primary"]},
        "hoverlabel": {"bgcolor": colors["paper"], "font": {"color": colors["ink"]}},
        # A line that passes behind a name leaves its letters free, on paper and in a saved file as well.
        "annotationdefaults": {"font": {"shadow": ", ".join([f"0 0 3px {colors['paper']}"] * 4)}},
    }
    # A click on one point must not dim the others.
    keep = {"marker": {"opacity": 1}}
    scatter: dict[str, Any] = {"type": "scatter", "selected": keep, "unselected": keep}
    if hover:
        scatter["hovertemplate"] = hover
    return {"layout": layout, "data": {"scatter": [scatter]}}
