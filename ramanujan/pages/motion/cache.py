"""The caches of page 3: the motion and its figures for the current settings."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import streamlit as st

from ramanujan import Oscillator, drawn_spacing
from ramanujan.derivation.energies import PARTS
from ramanujan.figures import EncodedFigure
from ramanujan.figures.motion import Panel, TimeCurve, draw_phase_plane, draw_time_panels, widen_range
from ramanujan.record import Record
from ramanujan.record import record as take_record
from ramanujan.shell import theme
from ramanujan.translation import _

PERIODS = 2
"""Number of periods of the machine in the figures."""

HEIGHT = 1080
"""Height of a figure that fills the screen [px]."""
POINTS = math.ceil(2 * math.pi * PERIODS / math.acos(1 - 1 / HEIGHT)) + 1
"""The fewest points that draw a cosine with two cycles per period, such as an energy, to within half a pixel.

The straight line between two points misses a crest of the cosine by ½·height·(1 − cos ½δ). Here δ is the phase between
two points.
"""

CONTACTS = {
    # TRANSLATORS: two bodies that touch: hoop and slab.
    f"{body}_{other}": _("{body} and {other}").format(body=PARTS[body], other=PARTS[other])
    for other, bodies in (("slab", ("hoop", "cylinder")), ("block", ("hoop", "cylinder", "top")))
    for body in bodies
}
"""Contact → the two bodies that touch there."""
_CM = 100.0
"""Centimetres in a metre."""
_LINES: dict[str, dict[str, Any]] = {
    "hoop": {"width": 5.0},
    "cylinder": {"dash": "6px 6px"},
}
"""Styles of two lines that coincide, because hoop and lower cylinder move together: a broad and a dashed line."""
_ENERGIES = {"": _("{body}"), "translation": _("{body}, translation"), "rotation": _("{body}, rotation")}
"""Kind of energy → template for the name of a body's energy."""


ReleaseParameters = tuple[Oscillator, float, float, float]
"""The machine, the compression, and the initial velocities `glide` and `spin`, as for `record`."""


def energy_name(key: str) -> str:
    """Return the name of an energy of a record, such as "hoop, rotation"."""
    body, _between, kind = key.partition("_")
    return _ENERGIES[kind].format(body=PARTS[body])


@st.cache_resource(show_spinner=False, max_entries=128)
def record(machine: Oscillator, compression: float, glide: float, spin: float) -> Record:
    """Return the motion after a release with a push, as densely as the figures need it; parameters in SI units."""
    return take_record(
        machine,
        compression,
        glide=glide,
        spin=spin,
        spacing=drawn_spacing(machine.radius),
        periods=PERIODS,
        points=POINTS,
    )


@st.cache_resource(show_spinner=False, max_entries=64)
def figures(
    view: str, light_or_dark: str, machine: Oscillator, compression: float, glide: float, spin: float
) -> tuple[EncodedFigure, ...]:
    """Return the figures of a view in the current theme.

    Parameters
    ----------
    view : a key of `VIEWS`
    light_or_dark : name of the current theme, a key of the cache
    machine, compression, glide, spin : as for `record`
    """
    motion, colors = record(machine, compression, glide, spin), theme.colors()
    return tuple(draw(motion, colors) for draw in VIEWS[view])


def _displacements(motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the displacements of the bodies relative to the ground and to the block."""
    frames = {
        _("relative to the ground"): motion.ground_positions,
        _("relative to the block"): motion.relative_positions,
    }
    panels = []
    for title, positions in frames.items():
        curves = [_body_curve(body, _CM * x, colors, **_LINES.get(body, {})) for body, x in positions.items()]
        panels.append(_panel(title, "cm", curves))
    return _over_time(motion, panels, colors)


def _orbits(motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw one orbit for each coordinate: slab and top cylinder relative to the block, block relative to the ground."""
    relative = motion.relative_positions, motion.relative_velocities
    ground = motion.ground_positions, motion.ground_velocities
    curves, velocities = [], []
    for body, (x, v) in {"slab": relative, "block": ground, "top": relative}.items():
        curves.append(_body_curve(body, _CM * x[body], colors))
        velocities.append(_CM * v[body])
    return draw_phase_plane(curves, velocities, period=motion.oscillator.period, periods=PERIODS, colors=colors)


def _energy(motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the energies of all bodies by kind as a stack below their constant sum."""
    curves = []
    for key, values in motion.energies.items():
        body, _between, kind = key.partition("_")
        curve = _body_curve(body, values * 1e3, colors, is_stacked=True, is_hatched=kind == "rotation")
        curves.append(replace(curve, name=energy_name(key)))
    total = 1e3 * motion.total_energy
    curves.append(TimeCurve(_("total energy"), total, colors["ink"], _("total energy"), width=3))
    # Leave a sixth above the total for the names of the periods.
    return _over_time(motion, [Panel(_("energy"), "mJ", curves, (0.0, float(total[0]) * 7 / 6))], colors)


def _momentum(motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the momentum of each body, which oscillates, and the two conserved momenta, which are constant."""
    curves = []
    for body, values in motion.body_momenta.items():
        look = _LINES.get(body, {}) | {"width": 1.5}
        curves.append(_body_curve(body, values, colors, **look))
    conserved = {
        _("total: −<i>p</i><sub>X</sub>"): (-motion.momenta["p_X"], "ink", "solid"),
        "<i>p</i><sub>Φ</sub><i>/R</i>": (motion.momenta["p_Phi"] / motion.oscillator.radius, "primary", "10px 6px"),
    }
    for name, (values, color, dash) in conserved.items():
        curves.append(TimeCurve(name, values, colors[color], name, width=4, dash=dash))
    return _over_time(motion, [_panel(_("momentum"), "kg·m/s", curves)], colors)


def _contacts(motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the horizontal force on each roller at its contacts, and the normal forces there."""
    forces = [_contact_curve(name, values, colors) for name, values in motion.forces.items() if name != "spring"]
    normals = [_contact_curve(name, values, colors) for name, values in motion.normal_forces.items()]
    highest = max(float(curve.values.max()) for curve in normals)
    panels = [_panel(_("friction"), "N", forces), Panel(_("normal force"), "N", normals, (0.0, 1.1 * highest))]
    return _over_time(motion, panels, colors)


VIEWS = {
    "displacements": (_displacements, _orbits),
    "energy": (_energy,),
    "momentum": (_momentum,),
    "forces": (_contacts,),
}
"""View → function that draws its figures."""


def _contact_curve(contact: str, values: np.ndarray, colors: Mapping[str, str]) -> TimeCurve:
    """Return a curve in the colour of the roller at a contact; it is dashed for a lower roller on the block."""
    body, _between, other = contact.partition("_")
    dash = "solid" if other == "slab" or body == "top" else "7px 5px"
    # TRANSLATORS: the same in short: hoop–slab.
    label = _("{body}–{other}").format(body=PARTS[body], other=PARTS[other])
    return replace(_body_curve(body, values, colors, dash=dash), name=CONTACTS[contact], label=label)


def _body_curve(body: str, values: np.ndarray, colors: Mapping[str, str], **look: Any) -> TimeCurve:
    """Return a curve with the name and the colour of a body."""
    return TimeCurve(PARTS[body], values, colors[body], PARTS[body], **look)


def _panel(title: str, unit: str, curves: list[TimeCurve]) -> Panel:
    return Panel(title, unit, curves, widen_range([curve.values for curve in curves]))


def _over_time(motion: Record, panels: list[Panel], colors: Mapping[str, str]) -> EncodedFigure:
    return draw_time_panels(panels, period=motion.oscillator.period, periods=PERIODS, colors=colors)
