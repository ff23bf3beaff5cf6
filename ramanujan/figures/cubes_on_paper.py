"""Cubes of unit cubes as a still drawing for paper, where a browser leaves out what a graphics card has drawn."""

from collections.abc import Sequence

import numpy as np

from ramanujan.figures.cubes import EYE, lighter

_TILT = np.arctan2(EYE[1], EYE[0])
"""How far the view looks down [rad]."""
_SHADES = {"top": 0.7, "x": 0.0, "y": 0.35}
"""How many steps lighter than its colour each face of a cube is."""


def cubes_svg(sides: Sequence[int], *, widest: int, apart: bool, turn: float, color: str) -> str:
    """Return cubes side by side as SVG, each with its unit cubes, in the view of `cubes.cube_stack`.

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
    parts, corners, start = [], [], 0
    for n, side in enumerate(sides):
        layers = side if apart else 1
        origin, size = np.array([start, (max(sides) - side) // 2, 0]), np.array([side, side, side // layers])
        layer = "".join(_face(*face, view, color, n) for face in _seen(origin, size, angle))
        copies = (f'<use href="#c{side}" y="{rise[1] * up:.1f}"/>' for up in range(1, layers))
        parts.append(f'<g id="c{side}">{layer}</g>{"".join(copies)}')
        top = rise * (layers - 1)
        corners += [view @ (origin + size * corner) + shift for corner in np.ndindex(2, 2, 2) for shift in (0, top)]
        start += side + 2
    # What is farther away is drawn first.
    drawn = "".join(parts if np.cos(angle) > 0 else reversed(parts))
    least, most = np.min(corners, axis=0), np.max(corners, axis=0)
    width, height = 10 * (widest + 4), most[1] - least[1] + 10
    left, upper = (least + most - (width, height)) / 2
    box = f"{left:.0f} {upper:.0f} {width:.0f} {height:.0f}"
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{drawn}</svg>'


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
