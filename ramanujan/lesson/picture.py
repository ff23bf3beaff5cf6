"""The machine as a still picture: its release, to scale, drawn from the core's geometry, as SVG or as TikZ."""

import math
import re
from collections.abc import Mapping
from itertools import pairwise
from xml.sax.saxutils import escape

from ramanujan.motion import ground_positions, motion, released
from ramanujan.oscillator import Oscillator, drawn_spacing
from ramanujan.translation import _

_CM = 100.0
_DECK, _THICK, _STEP, _GAP = 8.0, 4.5, 3.0, 2.5
"""Heights of the block's lower step and of the slab, the upper step over the slab, the gaps [cm]; as on the stage."""
_LETTER = 5.0
"""Size of a letter [cm of the picture]."""
_IN_TEX = str.maketrans({"′": "'", "φ": r"\varphi", "Φ": r"\Phi", "₀": "_0"})
_TIKZ_WIDTH = 340.0
"""Width of the picture as TikZ [pt]; a slide of beamer, 16:9, has 398 for its content."""


def machine_svg(machine: Oscillator, compression: float, colors: Mapping[str, str]) -> str:
    """Return the machine at its release as SVG, with its symbols.

    Parameters
    ----------
    machine : the machine
    compression : x₀ [m]
    colors : body → its colour, as rgb(…, …, …)
    """
    view, outlines, letters = _drawn(machine, compression)
    title = escape(_("The machine at its release"))
    parts = [
        f'<path d="{d}" fill="{colors.get(body, "none")}" fill-rule="evenodd" stroke="#000" stroke-width=".4" '
        f'data-body="{body}"/>'
        for d, body in outlines
    ]
    parts += [
        f'<text x="{x:g}" y="{y:g}" font-size="{_LETTER:g}" font-style="italic" font-family="serif" '
        f'text-anchor="middle" dominant-baseline="central">{text}</text>'
        for text, x, y in letters
    ]
    box = " ".join(f"{each:g}" for each in view)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" role="img"><title>{title}</title>'
    return "".join((head, *parts, "</svg>"))


def machine_tikz(machine: Oscillator, compression: float, colors: Mapping[str, str]) -> str:
    r"""Return the same picture as TikZ, for a document with \usepackage{tikz} and \usetikzlibrary{svg.path}.

    Parameters
    ----------
    machine : the machine
    compression : x₀ [m]
    colors : body → its colour, as rgb(…, …, …)
    """
    view, outlines, letters = _drawn(machine, compression)
    scale = _TIKZ_WIDTH / view[2]
    lines = [f"\\begin{{tikzpicture}}[xscale={scale:.4f}, yscale=-{scale:.4f}, line join=round]"]
    for d, body in outlines:
        channels = (round(float(each)) for each in re.findall(r"[\d.]+", colors[body])) if body else ()
        fill = body and ", fill={{rgb,255:red,{};green,{};blue,{}}}".format(*channels)
        lines.append(f"  \\path[draw, line width=0.5pt, even odd rule{fill}] svg {{{d}}};")
    lines += [f"  \\node at ({x:g}pt,{y:g}pt) {{${text.translate(_IN_TEX)}$}};" for text, x, y in letters]
    return "\n".join([*lines, "\\end{tikzpicture}\n"])


def _drawn(
    machine: Oscillator, compression: float
) -> tuple[tuple[float, float, float, float], list[tuple[str, str]], list[tuple[str, float, float]]]:
    """Return the view, the outlines, each with its body or "", and the letters, each with its place.

    x counts to the right and y downwards [cm].
    """
    start = motion(machine, released(machine, compression), 0.0)[0]
    at = {name: float(x) * _CM for name, x in ground_positions(machine, start).items()}
    R, x0 = machine.radius * _CM, compression * _CM
    hoop = x0 / 2 + R + _GAP
    lower = hoop + drawn_spacing(machine.radius) * _CM
    slab, deck = (hoop - x0 / 2 - 4, lower + x0 / 2 + 4), _DECK + 2 * R
    riser = slab[1] + x0 + 12
    upper = deck + _THICK + _STEP
    top = riser + R + _GAP
    right = top + R + _GAP
    ceiling = upper + 2 * R + 3
    spring = (slab[1] + at["slab"], riser + at["block"], deck + _THICK / 2)
    block = f"M{at['block']:g} 0V{-_DECK:g}H{riser:g}V{-upper:g}H{right:g}V0z"
    lying = f"M{slab[0] + at['slab']:g} {-deck:g}h{slab[1] - slab[0]:g}v{-_THICK:g}H{slab[0] + at['slab']:g}z"
    rollers = {
        "hoop": (hoop + at["hoop"], -_DECK - R),
        "cylinder": (lower + at["cylinder"], -_DECK - R),
        "top": (top + at["top"], -upper - R),
    }
    rims = {body: _circle(*centre, R) for body, centre in rollers.items()}
    rims["hoop"] += _circle(*rollers["hoop"], 0.78 * R)
    left, measured, (x, y) = at["block"], -deck - _THICK - 2.6, rollers["top"]
    marks = [
        f"M{left:g} {-_DECK:g}v-7M{left:g} {-_DECK - 4.5:g}h-6l2 -1.2m-2 1.2l2 1.2",
        f"M{slab[1]:g} {-deck - _THICK / 2:g}V{measured - 1:g}M{slab[1]:g} {measured:g}H{slab[1] + x0:g}",
        f"M{x:g} {y:g}l{-0.6 * R:g} {-0.8 * R:g}",
        *(_sense(*centre, 1.12 * R) for centre in rollers.values()),
    ]
    angles = [("Φ" if body == "top" else "φ", x + 1.12 * R + 3, y - 0.4 * R) for body, (x, y) in rollers.items()]
    return (
        (-8, -ceiling, right + 16, ceiling + 3),
        [
            (f"M-6 0H{right + 6:g}", ""),
            (block, "block"),
            *((rim, body) for body, rim in rims.items()),
            (lying, "slab"),
            (_coil(*spring), ""),
            *((mark, "") for mark in marks),
        ],
        [
            ("m", (riser + right) / 2, -upper / 2),
            *((letter, *rollers[body]) for body, letter in (("hoop", "m′"), ("cylinder", "m′"))),
            ("m", x, y + 0.4 * R),
            ("R", x - 0.55 * R, y - 0.25 * R),
            ("X", left - 4, -_DECK - 8.5),
            ("x₀", slab[1] - 4, measured),
            *angles,
            ("m", sum(slab) / 2 + at["slab"], -deck - _THICK / 2),
            ("k", (spring[0] + spring[1]) / 2, -spring[2] - 4.5),
        ],
    )


def _circle(x: float, y: float, r: float) -> str:
    # Four curves of Bézier, 0.03 % beside the circle: TikZ draws an arc of SVG with too few digits.
    ends, k = ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)), 0.5522847 * r
    quarters = (
        f"c{k * a:g} {k * b:g} {r * (a + c) - k * c:g} {r * (b + d) - k * d:g} {r * (a + c):g} {r * (b + d):g}"
        for (a, b), (c, d) in pairwise(ends)
    )
    return f"M{x:g} {y - r:g}{''.join(quarters)}z"


def _sense(x: float, y: float, r: float) -> str:
    """Return an arrow around a circle in the positive sense, clockwise, from 44° to 74° from the top."""
    (sin, cos), (end_sin, end_cos) = ((math.sin(a), math.cos(a)) for a in map(math.radians, (44, 74)))
    k = 4 / 3 * math.tan(math.radians(30) / 4) * r
    start, end = (x + r * sin, y - r * cos), (x + r * end_sin, y - r * end_cos)
    bent = f"{start[0] + k * cos:g} {start[1] + k * sin:g} {end[0] - k * end_cos:g} {end[1] - k * end_sin:g}"
    return f"M{start[0]:g} {start[1]:g}C{bent} {end[0]:g} {end[1]:g}l-2 -.7m2 .7l.5 -2"


def _coil(start: float, end: float, y: float) -> str:
    pitch = (end - start - 2) / 8
    wave = f"l{pitch / 4:g} -2l{pitch / 2:g} 4l{pitch / 4:g} -2"
    return f"M{start:g} {-y:g}h1{wave * 8}h1"
