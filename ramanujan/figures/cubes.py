"""The stacks of cubes of the page 1729, which a person can turn and count; and a still drawing of them for paper.

On paper a browser leaves out what a graphics card has drawn.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from plotly.colors import find_intermediate_color, hex_to_rgb, label_rgb

from ramanujan.figures import Drawn, figure, line

EYE = (0.85, 0.42)
"""Where the view is from: so far beside the middle, and so far above it."""
_UNIT = 2
"""Length of a unit cube's edge in the figure: half an edge is then an integer, too, and fits into one byte."""
_APART = 2
"""Unit cubes that would fit between two cubes."""
_TILT = np.arctan2(EYE[1], EYE[0])
"""How far the view looks down [rad]."""
_SHADES = {"top": 0.7, "x": 0.0, "y": 0.35}
"""How many steps lighter than its colour each face of a cube is on paper."""


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
    for n, (corner, shape, layers) in enumerate(_cubes(sides, apart)):
        lowest, rise = _UNIT * corner, np.array([0, 0, shape[2] * _UNIT + gap])
        origins = [lowest + layer * rise for layer in range(layers)]
        x, y, z = np.concatenate([o + _UNIT * _edges_of_unit_cubes(shape) for o in origins]).T.astype(np.int8)
        strokes = line(x, y, color=colors["paper"], width=2.5)
        traces.append(strokes | {"type": "scatter3d", "z": z, "hoverinfo": "skip"})
        for origin in origins:
            triangles.append(_BOX_TRIANGLES + 8 * len(corners))
            corners.append(origin + _box(_UNIT * shape))
            tints += [lighter(colors["primary"], n)] * len(_BOX_TRIANGLES)
    x, y, z = np.concatenate(corners).T.astype(np.float32)
    i, j, k = np.concatenate(triangles).T.astype(np.uint8)
    mesh = {"type": "mesh3d", "x": x, "y": y, "z": z, "i": i, "j": j, "k": k, "facecolor": tints, "flatshading": True}
    mesh["lighting"] = {"ambient": 0.75, "diffuse": 0.55, "specular": 0, "fresnel": 0}
    mesh |= {"lightposition": {"x": 4000, "y": -9000, "z": 14000}, "hoverinfo": "skip"}
    angle = np.radians(turn)
    half = (widest + 3) * _UNIT / 2
    tallest = max(sides)
    extent = _UNIT * (sum(sides) + _APART * (len(sides) - 1)), _UNIT * tallest, _UNIT * tallest + (tallest - 1) * gap
    # Of an axis that is not visible Plotly would still make triangles for the letters of its name and numbers, half a
    # second for each figure on a slow machine.
    nothing = dict.fromkeys(
        ("showgrid", "zeroline", "showline", "showticklabels", "showspikes", "showbackground"), False
    )
    empty = {**nothing, "title": {"text": ""}, "tickvals": []}
    ranges = {f"{axis}axis": [length / 2 - half, length / 2 + half] for axis, length in zip("xyz", extent, strict=True)}
    scene: dict[str, Any] = {axis: {**empty, "range": ends} for axis, ends in ranges.items()}
    # Larger than Plotly's box of one, since the cubes fill only the middle of it.
    scene |= {"aspectmode": "manual", "aspectratio": {"x": 1.7, "y": 1.7, "z": 1.7}, "dragmode": "turntable"}
    eye = {"x": float(EYE[0] * np.cos(angle)), "y": float(EYE[0] * np.sin(angle)), "z": EYE[1]}
    scene["camera"] = {"projection": {"type": "orthographic"}, "eye": eye}
    # A new direction from the slider is taken over; otherwise the view that a person has turned stays.
    return figure([*traces, mesh], colors, 384, margin=dict.fromkeys("lrtb", 0), uirevision=f"{turn:g}", scene=scene)


def cubes_svg(sides: Sequence[int], *, widest: int, apart: bool, turn: float, color: str) -> str:
    """Return cubes side by side as SVG, each with its unit cubes, in the view of `cube_stack`.

    Parameters
    ----------
    sides : number of unit cubes along an edge of each cube
    widest : common sum of the sides of several drawings, so that a unit cube has the same size in all of them
    apart : whether the layers are pulled apart for counting
    turn : direction of view [degrees]
    color : of the first cube; every further one has a lighter tint of it
    """
    angle = np.radians(turn)
    right = np.array([-np.sin(angle), np.cos(angle), 0])
    up = np.array([-np.cos(angle) * np.sin(_TILT), -np.sin(angle) * np.sin(_TILT), np.cos(_TILT)])
    # Pixels, ten to an edge; down is positive.
    view = 10 * np.array([right, -up])
    rise = view @ np.array([0, 0, 1.5])
    parts, corners = [], []
    for n, (origin, size, layers) in enumerate(_cubes(sides, apart)):
        side = size[0]
        layer = "".join(_face(*face, view, color, n) for face in _seen(origin, size, angle))
        copies = (f'<use href="#c{side}" y="{rise[1] * up:.1f}"/>' for up in range(1, layers))
        parts.append(f'<g id="c{side}">{layer}</g>{"".join(copies)}')
        top = rise * (layers - 1)
        corners += [view @ (origin + size * corner) + shift for corner in np.ndindex(2, 2, 2) for shift in (0, top)]
    # What is farther away is drawn first.
    drawn = "".join(parts if np.cos(angle) > 0 else reversed(parts))
    least, most = np.min(corners, axis=0), np.max(corners, axis=0)
    width, height = 10 * (widest + 4), most[1] - least[1] + 10
    left, upper = (least + most - (width, height)) / 2
    box = f"{left:.0f} {upper:.0f} {width:.0f} {height:.0f}"
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{drawn}</svg>'


def _cubes(sides: Sequence[int], apart: bool) -> Iterator[tuple[np.ndarray, np.ndarray, int]]:
    """Yield of each cube its corner and the size of a layer, in unit cubes, and the number of layers."""
    start = 0
    for side in sides:
        layers = side if apart else 1
        yield np.array([start, (max(sides) - side) // 2, 0]), np.array([side, side, side // layers]), layers
        start += side + _APART


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


def _seen(origin: np.ndarray, size: np.ndarray, angle: float) -> list[tuple[str, np.ndarray, np.ndarray, np.ndarray]]:
    """Return the three faces that are seen: name, corner and the two edges that leave it."""
    x, y, z = np.diag(size)
    near_x = origin + x * (np.cos(angle) > 0)
    near_y = origin + y * (np.sin(angle) > 0)
    return [("x", near_x, y, z), ("y", near_y, x, z), ("top", origin + z, x, y)]


def _face(
    name: str, corner: np.ndarray, first: np.ndarray, second: np.ndarray, view: np.ndarray, color: str, tint: int
) -> str:
    """Return a face with the edges of its unit cubes, so many tints lighter than the first cube."""
    along, across = (int(edge.max()) for edge in (first, second))
    lines = [_line(corner + first * n / along, second, view) for n in range(along + 1)]
    lines += [_line(corner + second * n / across, first, view) for n in range(across + 1)]
    outline = " ".join(_point(view @ (corner + edge)) for edge in (0 * first, first, first + second, second))
    return (
        f'<path d="M{outline}z" fill="{lighter(color, tint + _SHADES[name])}"/>'
        f'<path d="{"".join(lines)}" stroke="#fff" stroke-width=".8" data-face="{name}"/>'
    )


def _line(start: np.ndarray, edge: np.ndarray, view: np.ndarray) -> str:
    return f"M{_point(view @ start)}l{_point(view @ edge)}"


def _point(at: np.ndarray) -> str:
    return f"{at[0]:.1f} {at[1]:.1f}"
