"""The figures of the page 1729: the target on the Ω² curve, the 40 machines, counts of sums."""

from collections.abc import Mapping, Sequence

import numpy as np
import plotly.graph_objects as go

from ramanujan.figures import MASS_RATIO, NORMALIZED, Drawn, drawn, template
from ramanujan.translation import _


def level_crossing(
    ratios: np.ndarray,
    values: np.ndarray,
    *,
    level: float,
    level_label: str,
    root: float,
    root_label: str,
    present: tuple[float, float],
    colors: Mapping[str, str],
) -> Drawn:
    """Draw Ω²m/k against ε, the target level, and the one mass ratio at which the curve has that value.

    Parameters
    ----------
    ratios, values : ε and Ω²m/k along the curve, dimensionless, shape (n,)
    level, level_label : the target w and its label
    root, root_label : the mass ratio with Ω²m/k = w and its label
    present : ε and Ω²m/k of the present machine
    colors : ink, faint, paper, primary, top
    """
    yours, hover = _("your machine"), f"<i>ε</i> = %{{x:.6g}}<br>{NORMALIZED} = %{{y:.6g}}<extra></extra>"
    traces = [
        {
            "x": [ratios[0], ratios[-1]],
            "y": [level] * 2,
            "mode": "lines",
            "line": {"color": colors["ink"], "dash": "dot"},
        },
        {
            "x": np.float32(ratios),
            "y": np.float32(values),
            "mode": "lines",
            "line": {"color": colors["primary"], "width": 3, "shape": "spline"},
        },
        {
            "x": [present[0]],
            "y": [present[1]],
            "mode": "markers",
            "marker": {"symbol": "circle-open", "size": 20, "color": colors["primary"], "line": {"width": 3}},
            "hovertemplate": f"{yours}<br>{hover}",
        },
        {
            "x": [root],
            "y": [level],
            "mode": "markers",
            "marker": {"symbol": "star", "size": 16, "color": colors["top"]},
        },
    ]
    left, right = float(np.log10(ratios[0])), float(np.log10(ratios[-1]))
    at = float(np.log10(root))
    # The label avoids the falling curve: to the right above its flat start, to the left above its flat end, else to
    # the left below it.
    at_start = at < left + 0.4 * (right - left)
    above = at_start or level < 0.35 * values[0]
    root_note = {
        "x": at,
        "y": level,
        "text": root_label,
        "ax": 22 if at_start else -22,
        "ay": -34 if above else 40,
        "xanchor": "left" if at_start else "right",
        "arrowcolor": colors["ink"],
        "arrowwidth": 1,
        "arrowhead": 0,
        "standoff": 8,
        "bgcolor": colors["paper"],
    }
    level_note = {
        "x": right if at_start else left,
        "y": level,
        "text": level_label,
        "showarrow": False,
        "xanchor": "right" if at_start else "left",
        "yanchor": "bottom",
        "xshift": -6 if at_start else 6,
        "font": {"size": 13},
    }
    ratio_axis = {"type": "log", "title": {"text": MASS_RATIO}, "range": [left, right], "dtick": 1}
    layout = {
        "template": template(colors, hover),
        "height": 336,
        "showlegend": False,
        "annotations": [root_note, level_note],
        "xaxis": {**ratio_axis, "fixedrange": True},
        "yaxis": {"title": {"text": NORMALIZED}, "range": [0, 1.3 * float(values[0])], "fixedrange": True},
    }
    return drawn(({"type": "scatter", **trace} for trace in traces), layout)


def machine_grid(
    rows: Sequence[str],
    columns: Sequence[str],
    numbers: Sequence[Sequence[int]],
    ways: Sequence[Sequence[int]],
    chosen: tuple[int, int],
    colors: Mapping[str, str],
) -> go.Figure:
    """Draw the discriminants of all machines as a table that can be clicked; sums of two cubes are highlighted.

    Parameters
    ----------
    rows, columns : the pairs of lower rollers, the top bodies
    numbers : the discriminants, one row for each pair
    ways : in how many ways each is a sum of two positive cubes
    chosen : row and column of the machine that is marked
    colors : ink, faint, paper, primary, hoop, on_hoop
    """
    cells = [(x, y) for y in range(len(rows)) for x in range(len(columns))]
    flat_numbers = [number for row in numbers for number in row]
    flat_ways = [min(way, 2) for row in ways for way in row]
    figure = go.Figure(
        layout={
            "template": template(colors),
            "height": 48 + 40 * len(rows),
            "showlegend": False,
            "margin": {"l": 128, "r": 4, "t": 52, "b": 4},
        }
    )
    steps = [colors["faint"], colors["hoop"], colors["primary"]]
    figure.add_heatmap(
        z=np.reshape(flat_ways, (len(rows), len(columns))).astype(np.uint8),
        colorscale=[[(n + side) / 3, color] for n, color in enumerate(steps) for side in (0, 1)],
        zmin=0,
        zmax=2,
        xgap=3,
        ygap=3,
        showscale=False,
        hoverinfo="skip",
    )
    # A heatmap cannot be clicked, so the numbers are on markers, which can.
    hover = _("{lower} below, {top} on top<br>discriminant {number}")
    inks = [colors["ink"], colors["on_hoop"], colors["paper"]]
    unseen = {"marker": {"opacity": 0}}
    figure.add_scatter(
        x=[x for x, _y in cells],
        y=[y for _x, y in cells],
        mode="markers+text",
        text=[f"<b>{n}</b>" if way else str(n) for n, way in zip(flat_numbers, flat_ways, strict=True)],
        textfont={"size": 13, "color": [inks[way] for way in flat_ways]},
        marker={"symbol": "square", "size": 36, "opacity": 0},
        selected=unseen,
        unselected=unseen,
        customdata=[[rows[y], columns[x]] for x, y in cells],
        hovertemplate=hover.format(lower="%{customdata[0]}", top="%{customdata[1]}", number="%{text}")
        + "<extra></extra>",
    )
    row, column = chosen
    around = {"x0": column - 0.49, "x1": column + 0.49, "y0": row - 0.47, "y1": row + 0.47}
    figure.add_shape(type="rect", line={"color": colors["ink"], "width": 3}, **around)
    plain = {"showgrid": False, "showline": False, "ticks": "", "fixedrange": True}
    figure.update_xaxes(
        plain,
        tickvals=list(range(len(columns))),
        ticktext=columns,
        side="top",
        title=_("on top"),
        range=[-0.55, len(columns) - 0.45],
    )
    figure.update_yaxes(
        plain, tickvals=list(range(len(rows))), ticktext=rows, range=[len(rows) - 0.4, -0.6], tickfont={"size": 13}
    )
    return figure


def cube_counts(pairs: Sequence[str], counts: Sequence[int], highlighted: int, colors: Mapping[str, str]) -> go.Figure:
    """Draw, for each pair of lower rollers, how many discriminants are sums of two cubes.

    Parameters
    ----------
    pairs, counts : the pairs of lower rollers and their numbers
    highlighted : which of them is the paper's
    colors : ink, faint, paper, primary, block
    """
    figure = go.Figure(layout={"template": template(colors), "height": 336, "showlegend": False})
    figure.add_bar(
        x=list(counts),
        y=list(range(len(pairs))),
        orientation="h",
        marker={"color": [colors["primary"] if n == highlighted else colors["block"] for n in range(len(pairs))]},
        text=list(counts),
        textposition="outside",
        cliponaxis=False,
        customdata=list(pairs),
        hovertemplate=_("{lower} below: {number}").format(lower="%{customdata}", number="%{x}") + "<extra></extra>",
    )
    figure.update_layout(margin={"l": 128, "r": 30, "t": 4, "b": 44}, bargap=0.3)
    figure.update_xaxes(title=_("number of sums of two cubes"), fixedrange=True, rangemode="tozero")
    figure.update_yaxes(
        tickvals=list(range(len(pairs))),
        ticktext=pairs,
        range=[len(pairs) - 0.4, -0.6],
        showgrid=False,
        ticks="",
        fixedrange=True,
    )
    return figure
