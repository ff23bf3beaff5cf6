"""Names beside the curves that they belong to, where there is most room: no figure needs a legend.

A place holds on a narrow screen and on a projector, whose words are larger. Lengths are in sizes of these words.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

_PHONE, _LAPTOP, _LOW = 20, 1.15, 0.5
"""Width of a panel on a phone; on a laptop, compared with a projector; and its height there, compared with a laptop."""
_SIZE, _LETTER, _LINE, _GAP, _FAR, _ON = 15, 0.52, 1.2, 0.2, 2.0, 0.5
"""Size of the words [px] at a figure's full height; a letter's width, a name's height, its gap to its curve, what is
far from others, and how much more room a name must have on its curve than beside it to stand there."""
_BAND_HIGH, _BAND_WIDE = 0.4, 0.06
"""The shares of a name’s height and width that must be clear of a band’s edges: the name itself stands on paper."""
_POINTS, _EVERY = 120, 5
"""Points of a curve that a name must keep clear of; it stands at every so many of them at most."""
_SIDES = [*((across, up) for up in (1, -1) for across in (0, -1, 1)), (0, 0)]
"""Where a name may stand: above or below its curve, to the left, in the middle or to the right; or on the curve."""

Named = tuple[str, str, np.ndarray, np.ndarray]
"""Name, colour, and the curve's x and y in the units of the axes: exponents of ten on logarithmic ones."""
Range = tuple[float, float]


@dataclass(frozen=True)
class Area:
    """A panel: curves that bear a name, what its axes show, its height [px], and Plotly's name of its vertical axis.

    `width` is that on a projector, in sizes of its words. `bands` lie upon one another: name → lower and upper edge at
    equal steps over the whole of x.
    """

    curves: Sequence[Named]
    x_range: Range
    y_range: Range
    height: float
    axis: str = "y"
    width: float = 43
    bands: Mapping[str, Sequence[np.ndarray]] = field(default_factory=dict)


def beside(*areas: Area) -> list[dict[str, Any]]:
    """Return annotations: a curve's name in each area where nothing touches it, else where it is touched least.

    The areas are panels that share their names. Where a band has no room for its name, that is missing.
    """
    found = [each for area in areas for each in _placed(area)]
    most = {words["text"]: -np.inf for _room, words in found}
    for room, words in found:
        most[words["text"]] = max(room, most[words["text"]])
    return [words for room, words in found if room >= 0 or (room == most[words["text"]] and "color" in words["font"])]


def note(name: str, color: str | None, x: float, y: float, axis: str = "y") -> dict[str, Any]:
    """Return an annotation, in the figure's own colour if none is given."""
    font = {"size": 13} | ({"color": color} if color else {})
    words = {"text": name, "font": font, "showarrow": False, "borderpad": 0}
    return words | {"x": float(x), "y": float(y), "xref": "x", "yref": axis}


class _Places(NamedTuple):
    """Where a name may stand: points in shares of the axes, side of each; the name’s middle and room on each screen."""

    half: np.ndarray
    at: np.ndarray
    side: np.ndarray
    middles: np.ndarray
    room: np.ndarray


def _placed(area: Area) -> list[tuple[float, dict[str, Any]]]:
    """Return of each name the room in its best place, negative where something touches it, and its annotation."""
    high = area.height / _SIZE
    laptop = _LAPTOP * area.width
    screens = np.array([(min(_PHONE, laptop), high), (laptop, high), (area.width, _LOW * high)])
    # A method that has failed everywhere has a curve without points.
    curves = [each for each in area.curves if np.isfinite(each[2] + each[3]).any()]
    paths = [_path(x, y, area) for _name, _color, x, y in curves]
    found = [
        (name, {"color": color}, _places(_half(name), path, _SIDES, [*paths[:i], *paths[i + 1 :]], screens))
        for i, ((name, color, _x, _y), path) in enumerate(zip(curves, paths, strict=True))
    ]
    for name, (low, high) in area.bands.items():
        x = np.linspace(*area.x_range, len(low))
        middle, *edges = (_path(x, y, area, 4 * _POINTS) for y in ((low + high) / 2, low, high))
        low_name = _half(name) * (1, _BAND_HIGH)
        found.append((name, {}, _places(low_name, middle, [(0, 0)], edges, screens, _BAND_WIDE)))
    best: dict[int, int] = {}
    rooms: dict[int, float] = {}
    # Long names first, then all of them once more: now the others have their places.
    for i in sorted(range(len(found)), key=lambda i: -found[i][2].half[0]) * 2:
        half, at, side, middles, room = found[i][2]
        for other in best.keys() - {i}:
            there = found[other][2]
            apart = np.abs(middles - there.middles[:, [best[other]]]) - half - there.half
            room = np.minimum(room, apart.max(axis=2))
        # A name that something touches on one screen anyway keeps clear on the other.
        room = np.where(room.min(axis=0) < 0, np.minimum(room, 0).sum(axis=0), room.min(axis=0))
        # Where it is touched anyway, it must not hide what touches it.
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
        # Its own curve may come nearer than the others, or be interrupted by it.
        own = np.where(side[:, 1] == 0, 0.0, _clear(middle, half, path * screen))
        room = np.where(np.minimum(inside, own) < 0, np.minimum(inside, own), _FAR)
        if len(others):
            room = np.minimum(room, _clear(middle, half * (middle_part, 1), np.concatenate(others) * screen))
        rooms.append(room)
    return _Places(half, at, side, middles, np.array(rooms))


def _clear(middles: np.ndarray, half: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return how far each name is from the nearest of the points, negative where one lies inside."""
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
    (across, up), shares = places.side[best], zip(places.at[best], (area.x_range, area.y_range), strict=True)
    words = note(name, font.get("color"), *(low + share * (high - low) for share, (low, high) in shares), area.axis)
    anchors = {"xanchor": ("center", "left", "right")[across], "yanchor": ("middle", "bottom", "top")[up]}
    return words | anchors | {"yshift": 4 * int(up)}
