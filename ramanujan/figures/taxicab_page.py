"""The figures of the page 1729: the target on the Ω² curve, the 40 machines, and the curve of the two sums."""

from collections.abc import Mapping, Sequence

import numpy as np

from ramanujan.figures import NO_NAME, NORMALIZED, WITHOUT_HOVER, EncodedFigure, build_figure, line, marks, note
from ramanujan.figures.oscillator_page import Mark, arrow_label, draw_over_ratios
from ramanujan.text.translation import _


def draw_level_crossing(
    ratios: np.ndarray,
    values: np.ndarray,
    *,
    level: float,
    level_label: str,
    root: float,
    root_label: str,
    present: tuple[float, float],
    colors: Mapping[str, str],
) -> EncodedFigure:
    """Draw Ω²m/k against ε, the target level, and the one mass ratio at which the curve has that value.

    Parameters
    ----------
    ratios, values : ε and Ω²m/k along the curve, dimensionless, shape (n,)
    level, level_label : the target w and its label
    root, root_label : the mass ratio with Ω²m/k = w, and its label
    present : ε and Ω²m/k of the present machine
    colors : ink, faint, paper, primary, top
    """
    yours = _("your machine")
    hover = f"<i>ε</i> = %{{x:.6g}}<br>{NORMALIZED} = %{{y:.6g}}<extra></extra>"
    present_ratio, present_value = present
    ring = marks([present_ratio], [present_value], "circle-open", 20, colors["primary"], width=3)
    traces = [
        line([ratios[0], ratios[-1]], [level] * 2, color=colors["ink"], dash="dot"),
        line(np.float32(ratios), np.float32(values), color=colors["primary"], width=3, shape="spline"),
        ring | {"hovertemplate": f"{yours}<br>{hover}"},
        marks([root], [level], "star", 16, colors["top"]),
    ]
    # The curve falls, so the place above the level and to the right of the root is free.
    right = float(ratios[-1])
    notes = [
        arrow_label(Mark(root, level, root_label), (22, -50), "left", colors),
        note(level_label, None, right, level) | {"xanchor": "right", "xshift": -6, "yanchor": "bottom", "yshift": 3},
    ]
    highest, ratio_axis = 1.3 * float(values[0]), {"range": (0, right)}
    return draw_over_ratios(traces, highest, hover, colors, ratio_axis, height=304, annotations=notes)


def draw_machine_grid(
    rows: Sequence[str],
    columns: Sequence[str],
    numbers: Sequence[int],
    ways: Sequence[int],
    chosen: tuple[int, int],
    colors: Mapping[str, str],
) -> EncodedFigure:
    """Draw the discriminants of all machines as a clickable table; sums of two cubes are highlighted.

    Parameters
    ----------
    rows, columns : the pairs of lower rollers, the top bodies
    numbers : the discriminants, row by row
    ways : for each discriminant, the number of ways to write it as a sum of two positive cubes
    chosen : row and column of the marked machine
    colors : ink, faint, paper, primary, hoop, on_hoop, block_ink
    """
    # The cells row by row, as column and row. A cell's colour shows 0, 1, or at least 2 ways.
    cells = [(x, y) for y in range(len(rows)) for x in range(len(columns))]
    ways = np.minimum(ways, 2).tolist()
    # A color scale with steps has each colour at both ends of its interval. Most cells are pale, so that the eye sees
    # the few highlighted ones first.
    color_scale = []
    for step, color in enumerate(("rgba(128,128,128,.1)", colors["hoop"], colors["primary"])):
        color_scale += [[step / 3, color], [(step + 1) / 3, color]]
    table = {
        "type": "heatmap",
        "z": np.reshape(ways, (len(rows), len(columns))).tolist(),
        "colorscale": color_scale,
        **{"zmin": 0, "zmax": 2, "xgap": 3, "ygap": 3, "showscale": False, **WITHOUT_HOVER},
    }
    # The numbers belong to marks, because a heatmap does not report clicks.
    # TRANSLATORS: {lower} is a pair such as hoop + cylinder, {top} is a body such as cylinder.
    hover = _("{lower} below, {top} on top<br>discriminant {number}")
    inks = [colors["block_ink"], colors["on_hoop"], colors["paper"]]
    clickable = {
        "type": "scatter",
        "x": [x for x, _y in cells],
        "y": [y for _x, y in cells],
        "mode": "markers+text",
        "text": [f"<b>{n}</b>" if way else str(n) for n, way in zip(numbers, ways, strict=True)],
        "textfont": {"size": 13, "color": [inks[way] for way in ways]},
        "marker": {"symbol": "square", "size": 32, "opacity": 0},
        "customdata": [[rows[y], columns[x]] for x, y in cells],
        "hovertemplate": hover.format(lower="%{customdata[0]}", top="%{customdata[1]}", number="%{text}") + NO_NAME,
    }
    row, column = chosen
    around = {"x0": column - 0.49, "x1": column + 0.49, "y0": row - 0.47, "y1": row + 0.47}
    plain = {"showgrid": False, "showline": False, "ticks": "", "fixedrange": True}
    across = {"ticktext": columns, "range": [-0.55, len(columns) - 0.45], "side": "top", "title": {"text": _("on top")}}
    below = {"tickvals": list(range(len(rows))), "ticktext": list(rows), "range": [len(rows) - 0.4, -0.6]}
    return build_figure(
        [table, clickable],
        colors,
        64 + 32 * len(rows),
        margin={"l": 128, "r": 4, "t": 52, "b": 4},
        shapes=[{"type": "rect", "line": {"color": colors["ink"], "width": 3}, **around}],
        xaxis={**plain, "tickvals": list(range(len(columns))), **across},
        yaxis={**plain, **below, "tickfont": {"size": 13}},
    )


def draw_sums_of_cubes(number: int, sums: Sequence[tuple[int, int]], colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the curve x³ + y³ = number and its points with whole coordinates.

    Parameters
    ----------
    number : the sum of two cubes
    sums : pairs of integers whose cubes add up to the number
    colors : ink, faint, paper, primary, top
    """
    x = np.cbrt(np.linspace(0, number, 121))
    smaller, larger = zip(*sums, strict=True)
    lines = range(int(x[-1]) + 2)
    # Every whole number has a line, and those of the points have a label.
    ticks = {"tickvals": list(lines), "ticktext": [str(n) if n in (0, *smaller, *larger) else "" for n in lines]}
    axis = {"range": [0, len(lines)], **ticks, "constrain": "domain", "fixedrange": True}
    beside = {"xanchor": "left", "yanchor": "bottom", "xshift": 8, "yshift": 3}
    labels = [note(f"{one}³ + {other}³", None, one, other) | beside for one, other in sums]
    curve_label = note(f"<i>x</i>³ + <i>y</i>³ = {number}", colors["primary"], x[-1] / 2, x[-1] / 2)
    return build_figure(
        [
            line(np.float32(x), np.float32(x[::-1]), color=colors["primary"], width=3),
            marks(smaller + larger, larger + smaller, "star", 16, colors["top"]),
        ],
        colors,
        336,
        annotations=[*labels, curve_label],
        hovermode=False,
        xaxis={**axis, "title": {"text": "<i>x</i>"}},
        yaxis={**axis, "title": {"text": "<i>y</i>"}, "scaleanchor": "x"},
    )
