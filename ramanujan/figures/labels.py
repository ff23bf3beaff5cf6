"""Names beside the curves that they belong to, where there is most room: no figure needs a legend.

The places hold on the narrowest screen and on a wide one, where the same curve is flatter.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np

_WIDTH, _WIDE, _LETTER, _LINE, _GAP, _FAR = 260, 780, 6.2, 28, 3, 24
"""Pixels: the narrowest plotting area, a wide one, a letter and a line of a name, from curve to name, and what counts
as far. A line is as high as on a projector, whose words are larger."""
_POINTS, _EVERY = 180, 7
"""Points of a curve that a name must keep clear of; it stands at every so many of them at most."""

Named = tuple[str, str, np.ndarray, np.ndarray]
"""Name, colour, and the curve's x and y in the units of the axes: exponents of ten on logarithmic ones."""
Range = tuple[float, float]


def beside(
    curves: Sequence[Named], x_range: Range, y_range: Range, height: float, axis: str = "y", seen: Collection[str] = ()
) -> list[dict[str, Any]]:
    """Return annotations with the names of curves, above or below them where other curves and names are far.

    Parameters
    ----------
    curves : those that bear a name
    x_range, y_range : what the axes show
    height : of the panel [px]
    axis : Plotly's name of its vertical axis
    seen : names that stand in another panel; here they may be missing
    """
    paths = {
        width: [_pixels(x, y, x_range, y_range, (width, height)) for _name, _color, x, y in curves]
        for width in (_WIDTH, _WIDE)
    }
    placed, notes = dict.fromkeys(paths, np.empty((0, 2))), []
    for number, (name, color, _x, _y) in enumerate(curves):
        half, path = _half(name), paths[_WIDTH][number]
        # Above or below the curve, to the left, in the middle or to the right: a curve that rises has room on the left.
        sides = [(across, up) for up in (1, -1) for across in (0, -1, 1)]
        side = np.repeat(sides, len(path[::_EVERY]), axis=0)
        found = [_room(drawn, number, side, half, (width, height), placed[width]) for width, drawn in paths.items()]
        room, far = (np.min([each[i] for each in found], axis=0) for i in (0, 1))
        at = np.concatenate([path[::_EVERY]] * len(sides))
        best = int(np.argmax(room + 1e-3 * at[:, 0]))
        # What finds no place of its own is named by the pointer alone, or in another panel.
        if room[best] < 0 or (not far[best] and name in seen):
            continue
        for width, (*_others, middle) in zip(paths, found, strict=True):
            placed[width] = np.concatenate([placed[width], middle[best] + half * [*np.ndindex(3, 3)] - half])
        x, y = _on_axes(at[best], x_range, y_range, height)
        notes.append(note(name, color, x, y, axis) | _anchor(*side[best]))
    return notes


def _room(
    paths: Sequence[np.ndarray],
    number: int,
    side: np.ndarray,
    half: np.ndarray,
    area: tuple[float, float],
    placed: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return of each place of a name how good it is, negative where it cannot stand, how far others are, its middle."""
    path = paths[number]
    middle = np.tile(path[::_EVERY], (len(side) // len(path[::_EVERY]), 1)) + side * np.add(half, (0, _GAP))
    inside = np.all((middle >= half) & (middle <= area - half), axis=1)
    far = _distance(middle, half, np.concatenate([other for other in paths if other is not path] or [placed]))
    apart = _distance(middle, half, placed)
    # Its own curve comes as near as the gap, further along it nearer.
    room = 10 * np.minimum(_distance(middle, half, path), _GAP) + np.minimum(far, _FAR) + 10 * np.minimum(apart, _GAP)
    return np.where(inside & (apart > 0), room, -1e3), far, middle


def _anchor(across: int, up: int) -> dict[str, Any]:
    anchors = {"xanchor": ("center", "left", "right")[across], "yanchor": ("middle", "bottom", "top")[up]}
    return {**anchors, "yshift": _GAP * int(up)}


def note(name: str, color: str | None, x: float, y: float, axis: str = "y") -> dict[str, Any]:
    """Return an annotation, in the figure's own colour if none is given."""
    font = {"size": 13} | ({"color": color} if color else {})
    words = {"text": name, "font": font, "showarrow": False, "borderpad": 0}
    return words | {"x": float(x), "y": float(y), "xref": "x", "yref": axis}


def in_bands(
    bands: Mapping[str, Sequence[np.ndarray]], paper: str, x_range: Range, y_range: Range, height: float
) -> list[dict[str, Any]]:
    """Return annotations with the names of bands that lie upon one another, each where its band is broad.

    Parameters
    ----------
    bands : name → the band's lower and upper edge at equal steps over the whole of x
    paper : what the name is written on
    x_range, y_range, height : as in `beside`
    """
    placed, notes = np.empty((0, 2)), []
    for name, (low, high) in bands.items():
        x = np.linspace(*x_range, len(low))
        path = _pixels(x, (low + high) / 2, x_range, y_range, (_WIDTH, height))
        breadth = np.interp(np.linspace(0, 1, len(path)), np.linspace(0, 1, len(low)), high - low)
        breadth *= height / (y_range[1] - y_range[0])
        if breadth.max() < _LINE / 2:
            continue
        half = _half(name)
        inside = np.abs(path[:, 0] - _WIDTH / 2) <= _WIDTH / 2 - half[0]
        # Broad along the whole name, not only in its middle.
        broad = np.min([np.interp(path[:, 0] + by * half[0], path[:, 0], breadth) for by in (-0.4, 0, 0.4)], axis=0)
        room = np.minimum(broad, 3 * _LINE) + 10 * np.minimum(_distance(path, half, placed), _GAP)
        best = int(np.argmax(np.where(inside, room, -1)))
        placed = np.concatenate([placed, path[best] + half * [*np.ndindex(3, 3)] - half])
        notes.append(
            note(name, None, *_on_axes(path[best], x_range, y_range, height)) | {"bgcolor": paper, "yanchor": "middle"}
        )
    return notes


def _half(name: str) -> np.ndarray:
    """Return half the width and half the height of a name [px]."""
    return np.array([min(_WIDTH, len(re.sub("<[^>]*>", "", name)) * _LETTER) / 2, _LINE / 2])


def _on_axes(point: np.ndarray, x_range: Range, y_range: Range, height: float) -> tuple[float, float]:
    """Return the place of a pixel on the axes."""
    shares = zip(point / (_WIDTH, height), (x_range, y_range), strict=True)
    return tuple(float(low + share * (high - low)) for share, (low, high) in shares)


def _pixels(x: np.ndarray, y: np.ndarray, x_range: Range, y_range: Range, area: tuple[float, float]) -> np.ndarray:
    """Return points along a curve in pixels from the lower left corner, shape (n, 2), without gaps."""
    good = np.isfinite(x) & np.isfinite(y)
    along = np.linspace(0, 1, _POINTS)
    shares = [
        np.interp(along, np.linspace(0, 1, good.sum()), (values[good] - low) / (high - low))
        for values, (low, high) in ((x, x_range), (y, y_range))
    ]
    points = np.column_stack(shares)
    shown = np.all((points >= 0) & (points <= 1), axis=1)
    return (points[shown] if shown.any() else np.clip(points[-1:], 0, 1)) * area


def _distance(middles: np.ndarray, half: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return how far each box is from the nearest of the points, along one axis or the other."""
    if not len(points):
        return np.full(len(middles), np.inf)
    (x, y), (to_x, to_y) = middles.T[..., None], points.T
    beyond = np.maximum(np.abs(x - to_x) - half[0], np.abs(y - to_y) - half[1])
    return np.maximum(beyond.min(axis=1), 0)
