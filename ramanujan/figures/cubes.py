"""The stacks of cubes of the page 1729, which a person can turn and count."""

from collections.abc import Mapping, Sequence

import numpy as np
from plotly.colors import find_intermediate_color, hex_to_rgb, label_rgb

from ramanujan.figures import Drawn, drawn, line, template

EYE = (0.85, 0.42)
"""Where the view is from: so far beside the middle, and so far above it."""
_UNIT = 2
"""Length of a unit cube's edge in the figure: half an edge is then an integer, too, and fits into one byte."""


def cube_stack(sides: Sequence[int], *, widest: int, apart: bool, turn: float, colors: Mapping[str, str]) -> Drawn:
    """Draw cubes of unit cubes side by side: the faces as one mesh, the edges as one line for each cube.

    Parameters
    ----------
    sides : number of unit cubes along an edge of each cube
    widest : common sum of the sides of several figures, so that a unit cube has the same size in all of them
    apart : whether the layers are pulled apart for counting
    turn : direction of view [degrees]
    colors : ink, paper, primary; every further cube has a lighter tint of primary
    """
    gap = _UNIT // 2 if apart else 0
    traces, corners, triangles, tints = [], [], [], []
    tallest = max(sides)
    start = 0
    for n, side in enumerate(sides):
        layers = side if apart else 1
        thickness = side // layers
        origin = np.array([start, (tallest - side) // 2 * _UNIT, 0])
        rise = np.array([0, 0, thickness * _UNIT + gap])
        shape = (side, side, thickness)
        path = np.concatenate([origin + layer * rise + _UNIT * _edges_of_unit_cubes(shape) for layer in range(layers)])
        x, y, z = path.T.astype(np.int8)
        strokes = line(x, y, color=colors["paper"], width=2.5)
        traces.append(strokes | {"type": "scatter3d", "z": z, "hoverinfo": "skip"})
        for layer in range(layers):
            triangles.append(_BOX_TRIANGLES + 8 * len(corners))
            corners.append(origin + layer * rise + _box(_UNIT * np.array(shape)))
            tints += [lighter(colors["primary"], n)] * len(_BOX_TRIANGLES)
        start += (side + 2) * _UNIT
    x, y, z = np.concatenate(corners).T.astype(np.float32)
    i, j, k = np.concatenate(triangles).T.astype(np.uint8)
    mesh = {"type": "mesh3d", "x": x, "y": y, "z": z, "i": i, "j": j, "k": k, "facecolor": tints, "flatshading": True}
    mesh["lighting"] = {"ambient": 0.75, "diffuse": 0.55, "specular": 0, "fresnel": 0}
    mesh |= {"lightposition": {"x": 4000, "y": -9000, "z": 14000}, "hoverinfo": "skip"}
    angle = np.radians(turn)
    half = (widest + 3) * _UNIT / 2
    height = tallest * _UNIT + (tallest - 1) * gap
    middle = {"x": (start - 2 * _UNIT) / 2, "y": tallest * _UNIT / 2, "z": height / 2}
    layout = {
        "template": template(colors),
        "height": 384,
        "showlegend": False,
        "margin": {"l": 0, "r": 0, "t": 0, "b": 0},
        # A new direction from the slider is taken over; otherwise the view that a person has turned stays.
        "uirevision": f"{turn:g}",
    }
    # Of an axis that is not visible Plotly would still make triangles for the letters of its name and numbers, half a
    # second for each figure on a slow machine.
    nothing = dict.fromkeys(
        ("showgrid", "zeroline", "showline", "showticklabels", "showspikes", "showbackground"), False
    )
    empty = {**nothing, "title": {"text": ""}, "tickvals": []}
    scene = {f"{axis}axis": {**empty, "range": [float(at - half), float(at + half)]} for axis, at in middle.items()}
    # Larger than Plotly's box of one, since the cubes fill only the middle of it.
    scene |= {"aspectmode": "manual", "aspectratio": {"x": 1.7, "y": 1.7, "z": 1.7}, "dragmode": "turntable"}
    eye = {"x": float(EYE[0] * np.cos(angle)), "y": float(EYE[0] * np.sin(angle)), "z": EYE[1]}
    scene["camera"] = {"projection": {"type": "orthographic"}, "eye": eye}
    return drawn([*traces, mesh], layout | {"scene": scene})


def lighter(color: str, steps: float) -> str:
    """Return a colour, so many steps on its way to white."""
    return label_rgb(find_intermediate_color(hex_to_rgb(color), (255, 255, 255), 0.4 * steps))


def _box(size: np.ndarray) -> np.ndarray:
    """Return the eight corners of a box, drawn in by a hair so that the lines on its faces are not hidden in them."""
    corners = np.array([[(n >> axis) & 1 for axis in range(3)] for n in range(8)])
    hair = 0.02
    return hair + corners * (size - 2 * hair)


_BOX_TRIANGLES = np.array(
    [
        *([0, 1, 3], [0, 3, 2], [4, 5, 7], [4, 7, 6]),
        *([0, 1, 5], [0, 5, 4], [2, 3, 7], [2, 7, 6]),
        *([0, 2, 6], [0, 6, 4], [1, 3, 7], [1, 7, 5]),
    ]
)


def _edges_of_unit_cubes(shape: Sequence[int]) -> np.ndarray:
    """Return one unbroken path over the surface of a box along all edges of its unit cubes, shape (n, 3).

    For each axis it goes round the box at every step along that axis, and back to the corner that it came from.
    """
    path = []
    for axis, count in enumerate(shape):
        one, other = (i for i in range(3) if i != axis)
        for step in range(count + 1):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0)):
                point = [0, 0, 0]
                point[axis], point[one], point[other] = step, a * shape[one], b * shape[other]
                path.append(point)
        path.append([0, 0, 0])
    return np.array(path)
