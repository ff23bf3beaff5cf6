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
from ramanujan.text.names import BODIES, CONTACTS, PARTS
from ramanujan.text.numerals import filled, fixed, quantity
from ramanujan.text.translation import _

_CONFIG = {"displaylogo": False}
"""Plotly's options for a figure with all its buttons."""


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


def draw_displacements(motion: Record, figure: EncodedFigure, name: str, frame: str) -> None:
    """Draw displacements over time below what they show, and state the drift that the initial velocities cause."""
    positions, _velocities = cache.relative_to(frame, motion)
    swing = {body: 100 * float(np.ptp(x)) for body, x in positions.items()}
    block = _drift(motion.ground_positions["block"], motion)
    top = _drift(motion.relative_positions["top"], motion)
    if frame == "block":
        finding = _("Relative to the block, the slab moves **twice as far** as the rollers below it: nothing slips.")
    elif block:
        finding = _("The whole machine glides. Slab and block swing about this drift **in opposite directions**.")
    else:
        finding = _(
            "Slab and block swing **in opposite directions**: {slab:2 cm} and {block:2 cm} from end to end, the lower "
            "rollers only {hoop:2 cm}."
        )
    st.markdown(filled(finding, **swing))
    alternative = [
        _("Displacements over time."),
        *([_("The top cylinder drifts along the block.")] if top else []),
        _("Greatest distance from the start, {frame}: {distances}."),
    ]
    farthest = {body: 100 * float(abs(x - x[0]).max()) for body, x in positions.items()}
    distances = list_values(PARTS, farthest, "cm")
    draw_chart(figure, name, " ".join(alternative).format(frame=cache.FRAMES[frame], distances=distances))
    edge = cache.edge_time(motion)
    # A slide has room for one of the two sentences.
    is_short = is_projector() and edge is not None
    sentences = [] if is_short else [_("Zero is each body’s place before the compression.")]
    if edge is not None:
        end = _(
            "After {time:2 s} the top cylinder reaches the block’s edge. The faint curves would need a longer block."
        )
        sentences.append(filled(end, time=edge))
    elif block or top:
        drift = _(
            "After whole periods only this drift is left: {block:3 cm/s} for the block, {top:3 cm/s} for the top "
            "cylinder relative to it."
        )
        sentences.append(filled(drift, block=block, top=top))
    elif not is_projector():
        sentences.append(_("Nothing drifts: after each period every body is back. An initial velocity changes this."))
    with st.container(key=f"drift_{name}"):
        st.caption(" ".join(sentences))


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
    """Explain the phase plane, and what to look for in it; on a slide only the latter."""
    sentences = [
        _("Change $-\\dot X_0$: relative to the ground the circles open, relative to the block they stay as they are.")
    ]
    if not is_projector():
        how_to_read = _(
            "Each dot of this **phase plane** shows where a body is and how fast it moves. Above zero it moves to the "
            "right, below zero to the left, so the dots run clockwise. With the velocity divided by Ω, an oscillation "
            "is a circle."
        )
        sentences.insert(0, how_to_read)
    st.caption(" ".join(sentences))


def _drift(x: np.ndarray, motion: Record) -> float:
    """Return the mean velocity over all periods [cm/s], without rounding errors."""
    return round(float((x[-1] - x[0]) / motion.t[-1] * 100), 9)


def draw_energy(motion: Record, figure: EncodedFigure) -> None:
    """Draw the energies, stacked."""
    total = motion.total_energy
    error = max(float(abs(total - total[0]).max() / total[0]), np.finfo(float).eps)
    peaks = {}
    for body in BODIES:
        kinds = [energy for key, energy in motion.energies.items() if key.startswith(body)]
        peaks[body] = float(np.sum(kinds, axis=0).max())
    greatest = max(peaks, key=peaks.__getitem__)
    values = {"total": 1e3 * total[0], "body": PARTS[greatest], "share": peaks[greatest] / total[0]}
    finding = _(
        "Spring and bodies exchange energy, but **the sum stays at {total:4 mJ}**. The {body} gets up to {share:2↑ %} "
        "of it, more than any other body."
    )
    st.markdown(filled(finding, **values))
    alternative = _(
        "Energies of all bodies, stacked: energy passes between the spring and the bodies, and the sum stays at "
        "{total:4 mJ}. No other body ever has as much kinetic energy as this one: {body}."
    )
    draw_chart(figure, "energy", filled(alternative, **values))
    sentences = [_("Solid areas: kinetic energy of translation relative to the ground; hatched: of rotation.")]
    spring = motion.energies["spring"][0]
    if not is_projector():
        sentences.append(_("The relative error of the sum is at most {error:1↑}."))
    if total[0] > spring and not is_projector():
        sentences.append(_("At release the spring holds {spring:4 mJ}. The initial velocities add the rest."))
    st.caption(filled(" ".join(sentences), error=error, spring=1e3 * spring))


def draw_momentum(motion: Record, figure: EncodedFigure) -> None:
    """Draw the two conserved momenta, each with its parts."""
    p_X, p_Phi = (float(motion.momenta[name][0]) for name in ("p_X", "p_Phi"))
    st.markdown(_("**Both sums stay flat:** what one part gains, the other loses."))
    alternative = _(
        "Two momenta over time, each with its two parts. The parts change in opposite directions, and their sum is a "
        "flat line: all bodies together {all:3 kg m/s}, the top cylinder p_Φ/R = {top:3 kg m/s}."
    )
    draw_chart(figure, "momentum", filled(alternative, all=-p_X, top=p_Phi / motion.oscillator.radius))
    if not is_projector():
        p_X_symbol, _p_phi_symbol, p_Phi_symbol = map(latex, MOMENTA)
        sentence = _(
            "The Lagrangian contains neither $X$ nor $\\Phi$, so ${p_X}$ and ${p_Phi}$ are conserved. ${p_Phi}$ is the "
            "top cylinder’s angular momentum about its line of contact. Initial velocities move the flat lines."
        )
        st.caption(sentence.format(p_X=p_X_symbol, p_Phi=p_Phi_symbol))


def draw_friction(motion: Record, figure: EncodedFigure, friction: Friction) -> None:
    """Draw the friction at the contacts over time, with the limit of the contact that slips first."""
    if motion.compression <= friction.largest:
        finding = _(
            "**First to slip: the contact {between}.** Its friction stays in the shaded area, below μ times the normal "
            "force."
        )
    else:
        finding = _(
            "**The contact {between} slips.** Its friction leaves the shaded area: it exceeds μ times the normal force."
        )
    st.markdown(finding.format(between=CONTACTS[friction.first].between))
    strongest = {name: float(abs(force).max()) for name, force in motion.forces.items() if name in CONTACTS}
    alternative = _("Friction over time: it follows the motion of the spring. Greatest friction: {forces}.")
    draw_chart(figure, "forces", alternative.format(forces=list_values(cache.CONTACTS, strongest, "N")))
    if not is_projector():
        sentence = _(
            "Friction on the rollers, positive to the right; the arrows in the picture show it. It vanishes whenever "
            "the spring is relaxed. No initial velocity changes it. Dashed: a lower roller on the block."
        )
        st.caption(sentence)


def draw_normal_forces(motion: Record, figure: EncodedFigure) -> None:
    """Draw the normal forces over time."""
    greatest = {name: float(force.max()) for name, force in motion.normal_forces.items()}
    alternative = _("Normal forces over time. Greatest: {forces}.")
    draw_chart(figure, "normal_forces", alternative.format(forces=list_values(cache.CONTACTS, greatest, "N")))
    sentence = _(
        "The slab weighs on the two lower rollers. As it moves, its weight shifts from one to the other: their axes "
        "are {spacing} apart, as drawn."
    )
    st.caption(sentence.format(spacing=quantity(100 * motion.spacing, "cm", 3)))


def explain_friction() -> None:
    """Explain the bars of the required friction."""
    st.caption(
        _(
            "The bars show the least μ that each contact needs at the worst instant. Below the slab it grows faster "
            "than x₀, because the slab’s weight shifts between its rollers."
        )
    )


def draw_required_friction(motion: Record, friction: Friction) -> None:
    """Draw the required friction of each contact as bars, the largest on top, and the current μ."""
    coefficients = required_friction(motion.oscillator, motion.compression, spacing=motion.spacing)
    needed = dict(sorted(coefficients.items(), key=lambda item: item[1], reverse=True))
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
