"""A still picture of the machine at its release, to scale, from the geometry of the core, as SVG."""

import math
from collections.abc import Mapping
from typing import NamedTuple
from xml.sax.saxutils import escape

from ramanujan.physics.motion import ground_positions, motion, released
from ramanujan.physics.oscillator import Oscillator, drawn_spacing
from ramanujan.text.translation import _

_CM = 100.0
_DECK, _THICK, _STEP, _GAP = 8.0, 4.5, 3.0, 2.5
"""Dimensions as on the stage [cm]: height of the block's lower step, thickness of the slab, height of the upper step
above the slab, smallest gap between a roller and an edge of the block."""
_LETTER = 5.0
"""Height of a letter, in the scale of the machine [cm]."""


class _Outline(NamedTuple):
    """A path in SVG's notation; `body` is empty for a path without a fill."""

    path: str
    body: str = ""


class _Letter(NamedTuple):
    """A symbol and the place of its centre."""

    text: str
    x: float
    y: float


class _Drawing(NamedTuple):
    """A drawing [cm]; x is positive to the right and y downwards. `view` is left, top, width and height."""

    view: tuple[float, float, float, float]
    outlines: list[_Outline]
    letters: list[_Letter]


def draw_svg(machine: Oscillator, compression: float, colors: Mapping[str, str]) -> str:
    """Return the machine with its symbols as SVG.

    Parameters
    ----------
    machine : the machine
    compression : x₀ [m]
    colors : body → its colour, as rgb(…, …, …)
    """
    drawing = _draw(machine, compression)
    title = escape(_("The machine at its release"))
    parts = [
        f'<path d="{path}" fill="{colors.get(body, "none")}" fill-rule="evenodd" stroke="#000" stroke-width=".4" '
        f'data-body="{body}"/>'
        for path, body in drawing.outlines
    ]
    parts += [
        f'<text x="{x:g}" y="{y:g}" font-size="{_LETTER:g}" font-style="italic" font-family="serif" '
        f'text-anchor="middle" dominant-baseline="central">{text}</text>'
        for text, x, y in drawing.letters
    ]
    box = " ".join(f"{side:g}" for side in drawing.view)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" role="img"><title>{title}</title>'
    return "".join((head, *parts, "</svg>"))


def _draw(machine: Oscillator, compression: float) -> _Drawing:
    """Draw the machine at its release.

    x is measured from the left edge that the block has while the spring is relaxed, y from the floor.
    """
    q, _q_dot = motion(machine, released(machine, compression), 0.0)
    shift = {name: float(x) * _CM for name, x in ground_positions(machine, q).items()}
    R, x0 = machine.radius * _CM, compression * _CM
    # x of the centres of the rollers and of vertical edges with the spring relaxed; the shifts lead to the release.
    hoop_x = x0 / 2 + R + _GAP
    cylinder_x = hoop_x + drawn_spacing(machine.radius) * _CM
    slab_left, slab_right = hoop_x - x0 / 2 - 4, cylinder_x + x0 / 2 + 4
    riser = slab_right + x0 + 12
    top_x = riser + R + _GAP
    right = top_x + R + _GAP
    # Heights of the slab's lower side, of the block's upper step, and of the upper side of the drawing.
    deck = _DECK + 2 * R
    upper = deck + _THICK + _STEP
    ceiling = upper + 2 * R + 3
    block_left, slab_start = shift["block"], slab_left + shift["slab"]
    spring_start, spring_end = slab_right + shift["slab"], riser + shift["block"]
    spring_height = deck + _THICK / 2
    centres = {
        "hoop": (hoop_x + shift["hoop"], -_DECK - R),
        "cylinder": (cylinder_x + shift["cylinder"], -_DECK - R),
        "top": (top_x + shift["top"], -upper - R),
    }
    rims = {body: _circle(*centre, R) for body, centre in centres.items()}
    rims["hoop"] += _circle(*centres["hoop"], 0.78 * R)
    x, y = centres["top"]
    x0_height = -deck - _THICK - 2.6
    outlines = [
        # The floor, the bodies and the spring.
        _Outline(f"M-6 0H{right + 6:g}"),
        _Outline(f"M{block_left:g} 0V{-_DECK:g}H{riser:g}V{-upper:g}H{right:g}V0z", "block"),
        *(_Outline(rim, body) for body, rim in rims.items()),
        _Outline(f"M{slab_start:g} {-deck:g}h{slab_right - slab_left:g}v{-_THICK:g}H{slab_start:g}z", "slab"),
        _Outline(_coil(spring_start, spring_end, spring_height)),
        # The arrow of X, from the left edge of the block to the left.
        _Outline(f"M{block_left:g} {-_DECK:g}v-7M{block_left:g} {-_DECK - 4.5:g}h-6l2 -1.2m-2 1.2l2 1.2"),
        # The length x₀ above the spring: the slab's right edge with the spring relaxed, and at release.
        _Outline(
            f"M{slab_right:g} {-spring_height:g}V{x0_height - 1:g}M{slab_right:g} {x0_height:g}H{slab_right + x0:g}"
        ),
        # A radius of the top cylinder, and the arrows of φ and Φ.
        _Outline(f"M{x:g} {y:g}l{-0.6 * R:g} {-0.8 * R:g}"),
        *(_Outline(_rotation_arrow(*centre, 1.12 * R)) for centre in centres.values()),
    ]
    letters = [
        _Letter("m", (riser + right) / 2, -upper / 2),
        _Letter("m′", *centres["hoop"]),
        _Letter("m′", *centres["cylinder"]),
        _Letter("m", x, y + 0.4 * R),
        _Letter("R", x - 0.55 * R, y - 0.25 * R),
        _Letter("X", block_left - 4, -_DECK - 8.5),
        _Letter("x₀", slab_right - 4, x0_height),
        *(_Letter("Φ" if body == "top" else "φ", x + 1.12 * R + 3, y - 0.4 * R) for body, (x, y) in centres.items()),
        _Letter("m", (slab_left + slab_right) / 2 + shift["slab"], -deck - _THICK / 2),
        _Letter("k", (spring_start + spring_end) / 2, -spring_height - 4.5),
    ]
    return _Drawing((-8, -ceiling, right + 16, ceiling + 3), outlines, letters)


def _circle(x: float, y: float, r: float) -> str:
    """Return a circle as a path of two arcs."""
    return f"M{x:g} {y - r:g}a{r:g} {r:g} 0 0 1 0 {2 * r:g}a{r:g} {r:g} 0 0 1 0 {-2 * r:g}z"


def _rotation_arrow(x: float, y: float, r: float) -> str:
    """Return an arrow around a circle, clockwise from 44° to 74°, measured from the top of the circle."""
    begin, end = math.radians(44), math.radians(74)
    begin_x, begin_y = x + r * math.sin(begin), y - r * math.cos(begin)
    end_x, end_y = x + r * math.sin(end), y - r * math.cos(end)
    return f"M{begin_x:g} {begin_y:g}A{r:g} {r:g} 0 0 1 {end_x:g} {end_y:g}l-2 -.7m2 .7l.5 -2"


def _coil(start: float, end: float, y: float) -> str:
    """Return a spring from x = start to x = end as a path of eight waves."""
    pitch = (end - start - 2) / 8
    wave = f"l{pitch / 4:g} -2l{pitch / 2:g} 4l{pitch / 4:g} -2"
    return f"M{start:g} {-y:g}h1{wave * 8}h1"
