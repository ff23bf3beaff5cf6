"""The figures of page 3 with their explanations: displacements, energy, momentum, contact forces."""

from dataclasses import dataclass

import numpy as np
import streamlit as st

from ramanujan.derivation.model import MOMENTA
from ramanujan.derivation.printers import latex
from ramanujan.figures import EncodedFigure
from ramanujan.figures.motion_page import draw_friction_bars
from ramanujan.pages.motion import cache
from ramanujan.physics.contact import required_friction
from ramanujan.physics.record import Record
from ramanujan.shell import drawings, theme
from ramanujan.shell.display_mode import is_projector
from ramanujan.text.names import PARTS
from ramanujan.text.numerals import filled, fixed, quantity
from ramanujan.text.translation import _

_CONFIG = {"displaylogo": False}
"""Plotly's options for a figure with all its buttons."""

FIRST_DISPLACEMENTS, FIRST_FORCES = "displacements", "forces"
"""Names of the figures whose words the next slide does not repeat."""


@dataclass(frozen=True)
class Friction:
    """The limit of static friction.

    Parameters
    ----------
    coefficient : μ
    largest : largest compression without slip [m]
    first : the contact that slips first
    """

    coefficient: float
    largest: float
    first: str


def explain_zero_modes() -> None:
    """Explain the two initial velocities."""
    st.caption(
        _(
            "Each initial velocity excites a **zero mode**: a motion that does not deform the spring, so nothing pulls "
            "it back. With $-\\dot X_0$ the whole machine glides. With $\\dot\\Phi_0$ only the top cylinder rolls away."
        )
    )


def draw_displacements(motion: Record, figure: EncodedFigure, name: str) -> None:
    """Draw displacements over time, and state the drift that the initial velocities cause."""
    farthest = {}
    for body in PARTS:
        if body != "spring":
            x = motion.ground_positions[body]
            farthest[body] = 100 * abs(x - x[0]).max()
    block = _drift(motion.ground_positions["block"], motion)
    top = _drift(motion.relative_positions["top"], motion)
    alternative = [
        _("Displacements over time."),
        _("The whole machine glides steadily, and the slab oscillates about this drift.")
        if block
        else _("The slab oscillates; the centres of the lower rollers move least."),
        *([_("The top cylinder drifts along the block.")] if top else []),
        _("Greatest distance from the start, relative to the ground: {distances}."),
    ]
    distances = list_values(PARTS, farthest, "cm")
    if name != FIRST_DISPLACEMENTS:
        draw_chart(figure, name, " ".join(alternative).format(distances=distances))
        st.caption(
            _("Relative to the block, the slab moves twice as far as the axes of the rollers below it: nothing slips.")
        )
        return
    st.caption(_("Zero is each body’s place before compression. Up is to the right."))
    draw_chart(figure, name, " ".join(alternative).format(distances=distances))
    if block or top:
        sentence = _(
            "After whole periods only this drift is left: {block:3 cm/s} for the block, {top:3 cm/s} for the top "
            "cylinder relative to it."
        )
    else:
        sentence = _(
            "Nothing drifts: after each period every body is back where it started. An initial velocity changes this."
        )
    with st.container(key=f"drift_{name}"):
        st.caption(filled(sentence, block=block, top=top))


def draw_phase_plane(motion: Record, frame: str, figure: EncodedFigure) -> None:
    """Draw the phase plane relative to the ground or to the block."""
    alternative = _(
        "Phase plane: velocity over displacement, {frame}. The slab reaches a displacement of {displacement:3 cm} and "
        "a speed of {velocity:3 cm/s}."
    )
    positions, velocities = cache.relative_to(frame, motion)
    displacement = 100 * float(abs(positions["slab"]).max())
    velocity = 100 * float(abs(velocities["slab"]).max())
    words = filled(alternative, frame=cache.FRAMES[frame], displacement=displacement, velocity=velocity)
    draw_chart(figure, "flat_phase_plane" if cache.is_flat(frame, motion) else "phase_plane", words)


def explain_phase_plane() -> None:
    """Explain the phase plane, and what to look for in it."""
    st.caption(
        _(
            "Each dot of this **phase plane** shows where a body is and how fast it moves. The velocity is divided by "
            "the natural frequency Ω: both axes are lengths, and an oscillation is a circle. Change $-\\dot X_0$: the "
            "curves relative to the ground open, those relative to the block do not change."
        )
    )


def _drift(x: np.ndarray, motion: Record) -> float:
    """Return the mean velocity over all periods [cm/s], without rounding errors."""
    return round(float((x[-1] - x[0]) / motion.t[-1] * 100), 9)


def draw_energy(motion: Record, figure: EncodedFigure, name: str) -> None:
    """Draw the energies, stacked."""
    total = motion.total_energy
    error = max(float(abs(total - total[0]).max() / total[0]), np.finfo(float).eps)
    peaks = {}
    for body in PARTS:
        if body != "spring":
            kinds = [energy for key, energy in motion.energies.items() if key.startswith(body)]
            peaks[body] = float(np.sum(kinds, axis=0).max())
    greatest = max(peaks, key=peaks.__getitem__)
    alternative = _(
        "Energies of all bodies, stacked: energy passes between the spring and the bodies, and the sum stays at "
        "{total:4 mJ}. No other body ever has as much kinetic energy as this one: {body}."
    )
    draw_chart(figure, name, filled(alternative, total=1e3 * total[0], body=PARTS[greatest]))
    sentences = [
        _(
            "Solid areas: kinetic energy of translation relative to the ground. Hatched areas: of rotation. The sum is "
            "{total:4 mJ} at every instant, with a relative error of at most {error:1↑}. At release the spring holds "
            "{spring:4 mJ}."
        )
    ]
    if total[0] > motion.energies["spring"][0]:
        sentences.append(_("The initial velocities add the rest."))
    spring = 1e3 * motion.energies["spring"][0]
    st.caption(filled(" ".join(sentences), total=1e3 * total[0], error=error, spring=spring))


def draw_momentum(motion: Record, figure: EncodedFigure, name: str) -> None:
    """Draw the momenta of the bodies and the two conserved momenta."""
    p_X, p_Phi = (float(motion.momenta[name][0]) for name in ("p_X", "p_Phi"))
    p_X_symbol, _p_phi_symbol, p_Phi_symbol = map(latex, MOMENTA)
    alternative = _(
        "Momentum of each body over time. The bodies exchange momentum, but two lines are flat, because two momenta "
        "are conserved: all bodies together {all:3 kg m/s}, p_Φ/R {top:3 kg m/s}."
    )
    draw_chart(figure, name, filled(alternative, all=-p_X, top=p_Phi / motion.oscillator.radius))
    sentences = [
        _(
            "The bodies exchange momentum, but two momenta are conserved, because the Lagrangian contains neither $X$ "
            "nor $\\Phi$."
        )
    ]
    if not is_projector():
        sentences.append(
            _(
                "$-{p_X}$ is the momentum of the whole machine; $X$ is positive to the left, hence the minus sign. "
                "${p_Phi}$ is the angular momentum of the top cylinder about its line of contact with the block. "
                "Change the initial velocities and watch both lines move."
            ).format(p_X=p_X_symbol, p_Phi=p_Phi_symbol)
        )
    st.caption(" ".join(sentences))


def draw_contact_forces(motion: Record, figure: EncodedFigure, name: str) -> None:
    """Draw and explain the contact forces over time."""
    strongest = {name: float(abs(force).max()) for name, force in motion.forces.items() if name in cache.CONTACTS}
    alternative = _(
        "Contact forces over time: friction follows the motion of the spring, and the slab’s weight shifts between the "
        "rollers. Greatest friction: {forces}."
    )
    draw_chart(figure, name, alternative.format(forces=list_values(cache.CONTACTS, strongest, "N")))
    if name != FIRST_FORCES:
        st.caption(_("The slab weighs on the two lower rollers. As it moves, its weight shifts from one to the other."))
        return
    sentence = _(
        "Forces on the rollers, positive to the right. The axes of the two lower rollers are {spacing} apart, as "
        "drawn. No initial velocity changes a contact force: in a zero mode nothing accelerates."
    )
    st.caption(sentence.format(spacing=centimetres(motion.spacing)))


def explain_friction() -> None:
    """Explain the bars of the required friction."""
    st.caption(
        _(
            "A contact does not slip while its friction stays below μ times its normal force. The bars show the least "
            "μ that this takes at the worst instant."
        )
    )


def draw_required_friction(motion: Record, friction: Friction) -> None:
    """Draw the required friction of each contact as bars, with the current μ and the largest compression."""
    needed = required_friction(motion.oscillator, motion.compression, spacing=motion.spacing)
    mu, colors = friction.coefficient, theme.colors()
    bars = draw_friction_bars(
        {cache.CONTACTS[name]: value for name, value in needed.items()},
        [colors[name.partition("_")[0]] for name in needed],
        friction_coefficient=mu,
        colors=colors,
    )
    alternative = _(
        "Friction coefficient that each contact needs; a contact that needs more than μ = {mu} slips. {needed}."
    )
    alternative = alternative.format(mu=fixed(mu, 2), needed=list_values(cache.CONTACTS, needed, ""))
    drawings.plot(bars, "friction_needed", alternative, config=_CONFIG)
    if not is_projector():
        sentence = _("Largest compression without slip: **{length:3↓ cm}**")
        st.markdown(filled(sentence, length=100 * friction.largest))
        explain_friction()


def draw_chart(figure: EncodedFigure, name: str, alt: str) -> None:
    """Draw a figure over time or a phase plane. Its key gives it the height of these figures (page.css)."""
    drawings.plot(figure, f"figure_{name}", alt, config=_CONFIG)


def list_values(names: dict[str, str], values: dict[str, float], unit: str) -> str:
    """Return names with their values as a list in one line, for a text alternative."""
    template = _("{name}: {value}")
    items = []
    for key, value in values.items():
        items.append(template.format(name=names[key], value=quantity(float(value), unit, 3)))
    return "; ".join(items)


def centimetres(metres: float) -> str:
    """Return a length in centimetres."""
    return quantity(100 * metres, "cm", 3)
