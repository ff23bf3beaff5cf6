"""Place the names of curves beside them, where the space is largest, so that no figure needs a legend.

A place must suit a narrow screen and a projector with its larger font. Lengths are in multiples of the font size.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

_PHONE, _LAPTOP, _LOW = 20, 1.15, 0.5
"""The width of a panel on a phone, the laptop width relative to the projector, and the projector height relative to the
laptop."""
_SIZE, _LETTER, _LINE, _GAP, _FAR, _ON = 15, 0.52, 1.2, 0.2, 2.0, 0.5
"""The font size [px] at a figure's full height; the width of a letter, the height of a name, and its gap to its curve;
the largest distance that counts; and the extra distance that makes a name on its curve better than one beside it."""
_BAND_HIGH, _BAND_WIDE = 0.4, 0.06
"""The shares of a name’s height and width that must not overlap a band’s edges, since a name has an outline."""
_POINTS, _EVERY = 120, 5
"""The number of points of a curve that a name must not overlap. Every fifth point is a candidate for a name."""
_SIDES = [*((across, up) for up in (1, -1) for across in (0, -1, 1)), (0, 0)]
"""The candidate positions: above or below the curve, to the left, in the middle or to the right; or on the curve."""

Named = tuple[str, str, np.ndarray, np.ndarray]
"""Name, colour, and the curve's x and y in the units of the axes: exponents of ten on logarithmic ones."""
Range = tuple[float, float]


@dataclass(frozen=True)
class Area:
    """A panel: curves with names, ranges of its axes, height [px], and Plotly's name of its vertical axis.

    `width` is the width on a projector, in font sizes. `bands` are stacked: name → lower and upper edge at equal steps
    over the range of x.
    """

    curves: Sequence[Named]
    x_range: Range
    y_range: Range
    height: float
    axis: str = "y"
    width: float = 43
    bands: Mapping[str, Sequence[np.ndarray]] = field(default_factory=dict)


def beside(*areas: Area) -> list[dict[str, Any]]:
    """Return annotations: the name of each curve in the area with the least overlap.

    The areas are panels with common names. Skip the name of a band that is too narrow for it.
    """
    found = [each for area in areas for each in _placed(area)]
    most = {words["text"]: -np.inf for _room, words in found}
    for room, words in found:
        most[words["text"]] = max(room, most[words["text"]])
    return [words for room, words in found if room >= 0 or (room == most[words["text"]] and "color" in words["font"])]


def note(name: str, color: str | None, x: float, y: float, axis: str = "y") -> dict[str, Any]:
    """Return an annotation, by default in the figure's colour."""
    font = {"size": 13} | ({"color": color} if color else {})
    words = {"text": name, "font": font, "showarrow": False, "borderpad": 0}
    return words | {"x": float(x), "y": float(y), "xref": "x", "yref": axis}


class _Places(NamedTuple):
    """Candidates for a name: points in shares of the axes, and their sides; its middle and room on each screen."""

    half: np.ndarray
    at: np.ndarray
    side: np.ndarray
    middles: np.ndarray
    room: np.ndarray


def _placed(area: Area) -> list[tuple[float, dict[str, Any]]]:
    """Return the room of each name in its best place, negative for an overlap, and its annotation."""
    high = area.height / _SIZE
    laptop = _LAPTOP * area.width
    screens = np.array([(min(_PHONE, laptop), high), (laptop, high), (area.width, _LOW * high)])
    # A method without any finite result has a curve without points.
    curves = [each for each in area.curves if np.isfinite(each[2] + each[3]).any()]
    paths = [_path(x, y, area) for _name, _color, x, y in curves]
    found = [
        (name, {"color": color}, _places(_half(name), path, _SIDES, [*paths[:i], *paths[i + 1 :]], screens))
        for i, ((name, color, _x, _y), path) in enumerate(zip(curves, paths, strict=True))
    ]
    for name, (lower, upper) in area.bands.items():
        x = np.linspace(*area.x_range, len(lower))
        middle = _path(x, (lower + upper) / 2, area, 4 * _POINTS)
        edges = [_path(x, edge, area, 4 * _POINTS) for edge in (lower, upper)]
        low_name = _half(name) * (1, _BAND_HIGH)
        found.append((name, {}, _places(low_name, middle, [(0, 0)], edges, screens, _BAND_WIDE)))
    best: dict[int, int] = {}
    rooms: dict[int, float] = {}
    # Place long names first, then place all names again, now relative to the other names.
    for i in sorted(range(len(found)), key=lambda i: -found[i][2].half[0]) * 2:
        half, at, side, middles, room = found[i][2]
        for other in best.keys() - {i}:
            there = found[other][2]
            apart = np.abs(middles - there.middles[:, [best[other]]]) - half - there.half
            room = np.minimum(room, apart.max(axis=2))
        # If an overlap on one screen is unavoidable, prevent an overlap on the other.
        room = np.where(room.min(axis=0) < 0, np.minimum(room, 0).sum(axis=0), room.min(axis=0))
        # A name with an unavoidable overlap must not hide the other curve.
        on = np.where(room < 0, 4, 1) * _ON * (side[:, 1] == 0)
        best[i] = int(np.argmax(room + 1e-3 * at[:, 0] - on))
        rooms[i] = float(room[best[i]])
    return [(rooms[i], _written(*found[i], best[i], area)) for i in range(len(found))]


def _half(name: str) -> np.ndarray:
    """Return half the width and half the height of a name."""
    lines = [re.sub("<[^>]*>", "", line) for line in name.split("<br>")]
    return np.array([max(map(len, lines)) * _LETTER, len(lines) * _LINE]) / 2


def _places(
    half: np.ndarray,
    path: np.ndarray,
    sides: Sequence[tuple[int, int]],
    others: Sequence[np.ndarray],
    screens: np.ndarray,
    middle_part: float = 1,
) -> _Places:
    at = np.concatenate([path[::_EVERY]] * len(sides))
    side = np.repeat(sides, len(path[::_EVERY]), axis=0)
    middles = np.stack([at * screen + side * np.add(half, (0, _GAP)) for screen in screens])
    rooms = []
    for screen, middle in zip(screens, middles, strict=True):
        inside = (np.minimum(middle, screen - middle) - half).min(axis=1)
        # A name may be nearer to its curve than to the others, or interrupt it.
        own = np.where(side[:, 1] == 0, 0.0, _clear(middle, half, path * screen))
        room = np.where(np.minimum(inside, own) < 0, np.minimum(inside, own), _FAR)
        if len(others):
            room = np.minimum(room, _clear(middle, half * (middle_part, 1), np.concatenate(others) * screen))
        rooms.append(room)
    return _Places(half, at, side, middles, np.array(rooms))


def _clear(middles: np.ndarray, half: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return the distance of each name from the nearest point, negative if a point is inside the name."""
    (x, y), (to_x, to_y) = middles.T[..., None], points.T
    return np.maximum(np.abs(x - to_x) - half[0], np.abs(y - to_y) - half[1]).min(axis=1)


def _path(x: np.ndarray, y: np.ndarray, area: Area, points: int = _POINTS) -> np.ndarray:
    """Return points along a curve in shares of the axes, shape (n, 2), without gaps."""
    good = np.isfinite(x) & np.isfinite(y)
    along, steps = np.linspace(0, 1, points), np.linspace(0, 1, good.sum())
    axes = ((x, area.x_range), (y, area.y_range))
    path = np.column_stack([np.interp(along, steps, (v[good] - low) / (high - low)) for v, (low, high) in axes])
    shown = np.all((path >= 0) & (path <= 1), axis=1)
    return path[shown] if shown.any() else np.clip(path[-1:], 0, 1)


def _written(name: str, font: dict[str, str], places: _Places, best: int, area: Area) -> dict[str, Any]:
    """Return the annotation of a name in one of its places."""
    across, up = places.side[best]
    x, y = (
        low + share * (high - low)
        for share, (low, high) in zip(places.at[best], (area.x_range, area.y_range), strict=True)
    )
    words = note(name, font.get("color"), x, y, area.axis)
    anchors = {"xanchor": ("center", "left", "right")[across], "yanchor": ("middle", "bottom", "top")[up]}
    return words | anchors | {"yshift": 4 * int(up)}
