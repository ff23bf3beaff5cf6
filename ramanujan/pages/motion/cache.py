"""The caches of page 3: the motion and its figures for the current settings."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import streamlit as st

from ramanujan import Oscillator, drawn_edges, drawn_spacing
from ramanujan.figures import EncodedFigure
from ramanujan.figures.motion_page import (
    FASTEST,
    Panel,
    TimeCurve,
    draw_panels,
    draw_phase_plane,
    round_up,
    step_range,
)
from ramanujan.figures.motion_page import is_flat as is_flat_plane
from ramanujan.physics.record import Record
from ramanujan.physics.record import record as take_record
from ramanujan.shell import stages, theme
from ramanujan.text.names import CONTACTS as CONTACT_NAMES
from ramanujan.text.names import PARTS
from ramanujan.text.translation import _

PERIODS = 2
"""Number of periods of the machine in the figures."""

HEIGHT = 1080
"""Height of a figure that fills the screen [px]."""
POINTS = math.ceil(2 * math.pi * PERIODS / math.acos(1 - 1 / HEIGHT)) + 1
"""The fewest points that draw a cosine with two cycles per period, such as an energy, to within half a pixel.

The straight line between two points misses a crest of the cosine by ½·height·(1 − cos ½δ). Here δ is the phase between
two points.
"""

CONTACTS = {contact: names.pair for contact, names in CONTACT_NAMES.items()}
"""Contact → the two bodies that touch there."""
_CM = 100.0
"""Centimetres in a metre."""
FRAMES = {"ground": _("relative to the ground"), "block": _("relative to the block")}
"""Frame of reference → its name."""
FRICTION, NORMAL_FORCE = _("friction"), _("normal force")
"""The titles of the figures of the contact forces."""
_LOWER_ROLLERS = _("hoop, lower cylinder")
"""The name of the common curve of these two bodies, which always move together."""
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
    view: str,
    light_or_dark: str,
    machine: Oscillator,
    compression: float,
    glide: float,
    spin: float,
    limit: tuple[str, float] | None = None,
) -> dict[str, EncodedFigure]:
    """Return title → figure of a view over time in the current theme.

    Parameters
    ----------
    view : a key of `VIEWS`
    light_or_dark : name of the current theme, a key of the cache
    machine, compression, glide, spin : as for `record`
    limit : a contact and μ, to draw the limit of its friction
    """
    motion = record(machine, compression, glide, spin)
    return draw_over_time(view, motion, theme.colors(), limit)


def draw_over_time(
    view: str, motion: Record, colors: Mapping[str, str], limit: tuple[str, float] | None = None
) -> dict[str, EncodedFigure]:
    """Draw the figures of a view without the cache; parameters as for `figures`."""
    panels = VIEWS[view](motion, colors)
    if limit:
        [friction] = panels[FRICTION]
        panels[FRICTION] = [_with_limit(friction, motion, *limit)]
    draw = partial(draw_panels, period=motion.oscillator.period, periods=PERIODS, edge=edge_time(motion), colors=colors)
    return {title: draw(below_each_other) for title, below_each_other in panels.items()}


def edge_time(motion: Record) -> float | None:
    """Return the time at which the top cylinder reaches an edge of the block [s], or None if it stays between them."""
    last = _last_on_block(motion)
    return None if last == len(motion.t) - 1 else float(motion.t[last])


def _last_on_block(motion: Record) -> int:
    """Return the index of the last time before the top cylinder is beyond an edge of the block."""
    left, right = drawn_edges(motion.oscillator.radius, stages.LIMITS[1])
    x = motion.relative_positions["top"]
    is_beyond = np.append((x < left) | (x > right), True)
    return int(is_beyond.argmax()) - 1


@st.cache_resource(show_spinner=False, max_entries=64)
def phase_plane(
    frame: str,
    light_or_dark: str,
    machine: Oscillator,
    compression: float,
    glide: float,
    spin: float,
) -> EncodedFigure:
    """Return the phase plane in a frame of reference; the other parameters as for `figures`."""
    motion = record(machine, compression, glide, spin)
    return draw_orbits(frame, motion, theme.colors())


def _displacements(motion: Record, colors: Mapping[str, str]) -> dict[str, list[Panel]]:
    """Return the displacements of the bodies relative to the ground and to the block."""
    last = _last_on_block(motion)
    after_edge = PERIODS * (1 - last / (len(motion.t) - 1))
    panels = {}
    for frame, title in FRAMES.items():
        positions, _velocities = relative_to(frame, motion)
        curves = _body_curves({body: _CM * x for body, x in positions.items()}, colors)
        # The motion beyond the edge of the block does not flatten the motion before it, and may leave the panel.
        ends = step_range(curve.values[: last + 1] for curve in curves)
        panels[title] = [Panel(_("to the right"), "cm", curves, ends, named_before_end=after_edge)]
    return panels


def draw_orbits(frame: str, motion: Record, colors: Mapping[str, str]) -> EncodedFigure:
    """Draw the orbits of the bodies relative to the ground, or without the block relative to it."""
    positions, velocities = _orbits(frame, motion)
    to_cm = _CM / motion.oscillator.natural_frequency
    return draw_phase_plane(
        _body_curves({body: _CM * x for body, x in positions.items()}, colors),
        [to_cm * v for body, v in velocities.items() if body != "cylinder"],
        ranges=_ranges(frame, motion),
        period=motion.oscillator.period,
        periods=PERIODS,
        colors=colors,
    )


def is_flat(frame: str, motion: Record) -> bool:
    """Return whether a drift makes the phase plane in a frame of reference much wider than high."""
    return is_flat_plane(_ranges(frame, motion))


def relative_to(frame: str, motion: Record) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Return the displacements [m] and the velocities [m/s] of the bodies relative to the ground or to the block."""
    if frame == "ground":
        return motion.ground_positions, motion.ground_velocities
    return motion.relative_positions, motion.relative_velocities


def _orbits(frame: str, motion: Record) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Return the same without the motion of the top cylinder beyond an edge of the block: its orbit ends there."""
    positions, velocities = relative_to(frame, motion)
    steps = np.minimum(np.arange(len(motion.t)), _last_on_block(motion))
    return positions | {"top": positions["top"][steps]}, velocities | {"top": velocities["top"][steps]}


def _ranges(frame: str, motion: Record) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the ranges of the axes of displacement [cm] and velocity [cm/s] in a frame.

    No initial velocity of the machine changes them relative to the block.
    """
    positions, velocities = _orbits(frame, motion)
    fastest = max(float(abs(v).max()) for v in velocities.values()) / motion.oscillator.natural_frequency
    highest = round_up(1.05 * _CM * fastest)
    return step_range(_CM * x for x in positions.values()), (-highest, highest)


def _energy(motion: Record, colors: Mapping[str, str]) -> dict[str, list[Panel]]:
    """Return the energies of all bodies by kind as a stack below their constant sum."""
    curves = []
    for key, values in motion.energies.items():
        body, _between, kind = key.partition("_")
        curve = _body_curve(body, values * 1e3, colors, is_stacked=True, is_hatched=kind == "rotation")
        curves.append(replace(curve, name=energy_name(key)))
    total = 1e3 * motion.total_energy
    curves.append(TimeCurve(_("total energy"), total, colors["ink"], _("total energy"), width=3, ink=colors["ink"]))
    # Leave a sixth above the total for the names of the periods.
    highest = round_up(float(total[0]) * 7 / 6)
    return {_("energy"): [Panel(_("energy"), "mJ", curves, (0.0, highest))]}


def _momentum(motion: Record, colors: Mapping[str, str]) -> dict[str, list[Panel]]:
    """Return for each conserved momentum its two parts, which oscillate against each other, and their constant sum.

    −p_X is the sum over all bodies. p_Φ/R is the momentum of the top cylinder and its angular momentum over R. On a
    common time axis the parts of both sums cross zero at the same times.
    """
    of, machine = motion.body_momenta, motion.oscillator
    rotation = machine.moments_of_inertia["top"] * motion.q_dot[2] / machine.radius
    bodies = [
        _part("block", of["block"] + of["top"], _("block, top cylinder"), colors),
        _part("slab", of["slab"] + of["hoop"] + of["cylinder"], _("slab, lower rollers"), colors),
    ]
    kinds = [
        _part("top", of["top"], _("translation"), colors),
        _part("top", rotation, _("rotation"), colors, is_hatched=True),
    ]
    total, top = -motion.momenta["p_X"], motion.momenta["p_Phi"] / machine.radius
    panels = [
        _sum_panel(_("whole machine"), bodies, total, _("sum: −<i>p</i><sub>X</sub>"), colors),
        _sum_panel(PARTS["top"], kinds, top, _("sum: <i>p</i><sub>Φ</sub>/<i>R</i>"), colors),
    ]
    return {_("momentum"): panels}


def _part(body: str, values: np.ndarray, name: str, colors: Mapping[str, str], **look: Any) -> TimeCurve:
    """Return a part of a conserved momentum in the colour of a body."""
    return replace(_body_curve(body, values, colors, is_filled=True, **look), name=name, label=name)


def _sum_panel(title: str, parts: list[TimeCurve], total: np.ndarray, name: str, colors: Mapping[str, str]) -> Panel:
    """Return a panel of the parts of a conserved momentum, with their sum as a wide line."""
    flat = TimeCurve(name, total, colors["ink"], name, width=4, ink=colors["ink"])
    return replace(_panel(title, "kg·m/s", [*parts, flat]), named_before_end=FASTEST)


def _contacts(motion: Record, colors: Mapping[str, str]) -> dict[str, list[Panel]]:
    """Return the horizontal force on each roller at its contacts, and the normal forces there."""
    forces = [_contact_curve(name, values, colors) for name, values in motion.forces.items() if name != "spring"]
    normals = [_contact_curve(name, values, colors) for name, values in motion.normal_forces.items()]
    highest = max(float(curve.values.max()) for curve in normals)
    return {
        FRICTION: [_panel(FRICTION, "N", forces)],
        NORMAL_FORCE: [Panel(NORMAL_FORCE, "N", normals, (0.0, 1.1 * highest))],
    }


def _with_limit(panel: Panel, motion: Record, contact: str, friction_coefficient: float) -> Panel:
    """Return the panel of friction with the limit of static friction at a contact, whose curve is drawn strongly."""
    name = CONTACTS[contact]
    curves = [replace(curve, width=4 if curve.name == name else 1.5) for curve in panel.curves]
    (curve,) = (curve for curve in curves if curve.name == name)
    values = friction_coefficient * motion.normal_forces[contact]
    # TRANSLATORS: the limit of static friction at a contact, such as hoop and slab.
    limit = replace(curve, name=_("limit μN, {contact}").format(contact=name), values=values, width=1)
    # A limit far above all forces does not flatten their curves.
    greatest = max(float(abs(curve.values).max()) for curve in curves)
    highest = round_up(max(1.3 * greatest, min(float(values.max()), 2 * greatest)))
    # TRANSLATORS: in the shaded area, where this contact does not slip: hoop–slab: no slip.
    label = _("{contact}: no slip").format(contact=curve.label)
    return replace(panel, curves=curves, range=(-highest, highest), limit=limit, limit_label=label)


VIEWS: Mapping[str, Callable[[Record, Mapping[str, str]], dict[str, list[Panel]]]] = {
    "displacements": _displacements,
    "energy": _energy,
    "momentum": _momentum,
    "forces": _contacts,
}
"""View → function that returns title → panels over time of a figure, from the top."""


def _contact_curve(contact: str, values: np.ndarray, colors: Mapping[str, str]) -> TimeCurve:
    """Return a curve in the colour of the roller at a contact; it is dashed for a lower roller on the block."""
    body, _between, other = contact.partition("_")
    dash = "solid" if other == "slab" or body == "top" else "7px 5px"
    # TRANSLATORS: the same in short: hoop–slab.
    label = _("{body}–{other}").format(body=PARTS[body], other=PARTS[other])
    return replace(_body_curve(body, values, colors, dash=dash), name=CONTACTS[contact], label=label)


def _body_curves(values: Mapping[str, np.ndarray], colors: Mapping[str, str]) -> list[TimeCurve]:
    """Return a curve for each body, and one for both lower rollers, whose values are equal."""
    curves = {body: _body_curve(body, each, colors) for body, each in values.items() if body != "cylinder"}
    curves["hoop"] = replace(curves["hoop"], name=_LOWER_ROLLERS, label=_LOWER_ROLLERS)
    return list(curves.values())


def _body_curve(body: str, values: np.ndarray, colors: Mapping[str, str], **look: Any) -> TimeCurve:
    """Return a curve with the name and the colour of a body."""
    return TimeCurve(PARTS[body], values, colors[body], PARTS[body], ink=colors[f"{body}_ink"], **look)


def _panel(title: str, unit: str, curves: list[TimeCurve]) -> Panel:
    return Panel(title, unit, curves, step_range(curve.values for curve in curves))
