"""What the motion page keeps: its motion, and the figures of it, for the settings that were asked for."""

from __future__ import annotations

from collections.abc import Mapping

import streamlit as st

from ramanujan import Oscillator, drawn_spacing
from ramanujan.figures import Drawn
from ramanujan.figures.motion import Curve, Panel, phase_plane, roomy, time_panels
from ramanujan.record import Record
from ramanujan.record import record as take_record
from ramanujan.sampling import points_for_half_pixel
from ramanujan.scenes import look

PERIODS = 2
"""How many periods of the machine the figures show."""

POINTS = points_for_half_pixel(2 * PERIODS)
"""An energy goes up and down twice in a period; and any figure can be opened to fill the screen."""

NAMES = {
    "block": "block",
    "hoop": "hoop",
    "cylinder": "cylinder",
    "slab": "slab",
    "top": "top cylinder",
    "spring": "spring",
}
CONTACTS = {
    "hoop_slab": "hoop on slab",
    "cylinder_slab": "cylinder on slab",
    "hoop_block": "hoop on block",
    "cylinder_block": "cylinder on block",
    "top_block": "top cylinder on block",
}
_CM = 100.0
# Hoop and lower cylinder move alike: one is drawn broad, the other dashed upon it.
_LINES = {"hoop": {"width": 5.0}, "cylinder": {"dash": "6px 6px"}}
_KINDS = {"translation": "travels", "rotation": "turns"}


@st.cache_resource(show_spinner=False, max_entries=128)
def record(m: float, m_prime: float, k: float, radius: float, compression: float, glide: float, spin: float) -> Record:
    """Return the motion after a release with a push, as densely as the figures need it; parameters in SI units."""
    return take_record(
        Oscillator(m, m_prime, k, radius),
        compression,
        glide=glide,
        spin=spin,
        spacing=drawn_spacing(radius),
        periods=PERIODS,
        points=POINTS,
    )


@st.cache_resource(show_spinner=False, max_entries=64)
def figures(view: str, theme: str, *setting: float) -> tuple[Drawn, ...]:
    """Return the figures of a view, a key of `VIEWS`, in the present theme; the setting is that of `record`."""
    motion, colors = record(*setting), look.colors()
    return tuple(draw(motion, colors) for draw in VIEWS[view])


def _displacements(motion: Record, colors: Mapping[str, str]) -> Drawn:
    """Draw where the bodies are, over the ground and over the block."""
    places = (("over the ground", motion.over_ground), ("over the block", motion.over_block))
    panels = [
        _panel(
            title,
            "cm",
            [Curve(NAMES[body], _CM * x, colors[body], **_LINES.get(body, {})) for body, x in bodies.items()],
        )
        for title, bodies in places
    ]
    return _over_time(motion, panels, colors)


def _orbits(motion: Record, colors: Mapping[str, str]) -> Drawn:
    """Draw one orbit for each coordinate: the slab and the top cylinder over the block, the block over the ground."""
    shown = {
        "slab": ("slab over block", motion.over_block, motion.velocity_over_block),
        "block": ("block over ground", motion.over_ground, motion.velocity_over_ground),
        "top": ("top cylinder over block", motion.over_block, motion.velocity_over_block),
    }
    curves = [Curve(name, _CM * x[body], colors[body]) for body, (name, x, _) in shown.items()]
    velocities = [_CM * v[body] for body, (_, _, v) in shown.items()]
    return phase_plane(curves, velocities, period=motion.oscillator.period, periods=PERIODS, colors=colors)


def _energy(motion: Record, colors: Mapping[str, str]) -> Drawn:
    """Draw the energies of all bodies by kind, one upon the other, below their constant sum."""
    curves = []
    for key, values in motion.energies.items():
        body, _, kind = key.partition("_")
        turns = kind == "rotation"
        name = f"{NAMES[body]} {_KINDS[kind]}" if kind else NAMES[body]
        curves.append(Curve(name, values * 1e3, colors[body], stacked=True, hatched=turns))
    total = 1e3 * motion.total_energy
    curves.append(Curve("total", total, colors["ink"], width=3))
    # A sixth above the total is room for the names of the periods.
    return _over_time(motion, [Panel("energy", "mJ", curves, (0.0, float(total[0]) * 7 / 6))], colors)


def _momentum(motion: Record, colors: Mapping[str, str]) -> Drawn:
    """Draw each body's momentum, swinging, and the two conserved ones, flat."""
    curves = [
        Curve(f"mv of {NAMES[body]}", values, colors[body], width=1.5, dash=_LINES.get(body, {}).get("dash", "solid"))
        for body, values in motion.body_momenta.items()
    ]
    curves += [
        Curve("sum of all, −p<sub>X</sub>", -motion.momenta["p_X"], colors["ink"], width=4),
        Curve(
            "p<sub>Φ</sub>/R",
            motion.momenta["p_Phi"] / motion.oscillator.radius,
            colors["primary"],
            width=4,
            dash="10px 6px",
        ),
    ]
    return _over_time(motion, [_panel("momentum", "kg m/s", curves)], colors)


def _contacts(motion: Record, colors: Mapping[str, str]) -> Drawn:
    """Draw the horizontal force on each roller at its contacts, and the normal forces there."""
    forces = [_contact_curve(name, values, colors) for name, values in motion.forces.items() if name != "spring"]
    normals = [_contact_curve(name, values, colors) for name, values in motion.normal_forces.items()]
    highest = max(float(curve.values.max()) for curve in normals)
    panels = [_panel("friction", "N", forces), Panel("normal force", "N", normals, (0.0, 1.1 * highest))]
    return _over_time(motion, panels, colors)


VIEWS = {
    "Displacements": (_displacements, _orbits),
    "Energy": (_energy,),
    "Momentum": (_momentum,),
    "Contact forces": (_contacts,),
}


def contact_color(contact: str, colors: Mapping[str, str]) -> str:
    """Return the colour of a contact: that of its roller."""
    return colors[contact.partition("_")[0]]


def _contact_curve(contact: str, values: object, colors: Mapping[str, str]) -> Curve:
    dash = "solid" if contact.endswith("slab") or contact.startswith("top") else "7px 5px"
    return Curve(CONTACTS[contact], values, contact_color(contact, colors), dash=dash)


def _panel(title: str, unit: str, curves: list[Curve]) -> Panel:
    return Panel(title, unit, curves, roomy([curve.values for curve in curves]))


def _over_time(motion: Record, panels: list[Panel], colors: Mapping[str, str]) -> Drawn:
    return time_panels(panels, period=motion.oscillator.period, periods=PERIODS, colors=colors)
