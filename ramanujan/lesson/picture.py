"""The machine as a still picture for paper: an SVG of its release, to scale, drawn from the core's geometry."""

from __future__ import annotations

from xml.sax.saxutils import escape

from ramanujan.motion import ground_positions, motion, released
from ramanujan.oscillator import Oscillator, drawn_spacing
from ramanujan.translation import _

_CM = 100.0
_DECK, _THICK, _STEP, _GAP = 8.0, 4.5, 3.0, 2.5
"""Heights of the block's lower step and of the slab, the upper step over the slab, the gaps [cm]; as on the stage."""
_COLORS = {"block": "#d9dce0", "hoop": "#e19c19", "cylinder": "#9dbdd6", "slab": "#9ad0bb", "top": "#e4a3a7"}


def machine_svg(machine: Oscillator, compression: float) -> str:
    """Return the machine at its release as SVG, with its symbols.

    Parameters
    ----------
    machine : the machine
    compression : x₀ [m]
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
    parts = [
        f'<path d="M-6 0H{right + 6:g}" stroke="#000" stroke-width=".5"/>',
        _shape(f"M{at['block']:g} 0V{-_DECK:g}H{riser:g}V{-upper:g}H{right:g}V0z", "block"),
        _letter("m", (riser + right) / 2, upper / 2),
        *_roller("hoop", hoop + at["hoop"], _DECK + R, R, "m′"),
        *_roller("cylinder", lower + at["cylinder"], _DECK + R, R, "m′"),
        *_roller("top", top + at["top"], upper + R, R, "m"),
        _shape(
            f"M{slab[0] + at['slab']:g} {-deck:g}h{slab[1] - slab[0]:g}v{-_THICK:g}H{slab[0] + at['slab']:g}z", "slab"
        ),
        _letter("m", sum(slab) / 2 + at["slab"], deck + _THICK / 2),
        f'<path d="{_coil(*spring)}" fill="none" stroke="#000" stroke-width=".4"/>',
        _letter("k", (spring[0] + spring[1]) / 2, spring[2] + 4.5),
    ]
    view = f"-8 {-ceiling:g} {right + 16:g} {ceiling + 3:g}"
    title = escape(_("The machine at its release"))
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{view}" role="img"><title>{title}</title>'
    return "".join((head, *parts, "</svg>"))


def _shape(d: str, body: str) -> str:
    return (
        f'<path d="{d}" fill="{_COLORS[body]}" fill-rule="evenodd" stroke="#000" stroke-width=".4" data-body="{body}"/>'
    )


def _roller(body: str, x: float, y: float, R: float, letter: str) -> list[str]:
    def circle(r: float) -> str:
        return f"M{x:g} {-y - r:g}a{r:g} {r:g} 0 1 1 0 {2 * r:g}a{r:g} {r:g} 0 1 1 0 {-2 * r:g}z"

    rim = circle(R) + (circle(0.78 * R) if body == "hoop" else "")
    return [_shape(rim, body), _letter(letter, x, y)]


def _letter(text: str, x: float, y: float) -> str:
    return (
        f'<text x="{x:g}" y="{-y:g}" font-size="5" font-style="italic" font-family="serif" text-anchor="middle" '
        f'dominant-baseline="central">{text}</text>'
    )


def _coil(start: float, end: float, y: float) -> str:
    pitch = (end - start - 2) / 8
    wave = f"l{pitch / 4:g} -2l{pitch / 2:g} 4l{pitch / 4:g} -2"
    return f"M{start:g} {-y:g}h1{wave * 8}h1"
