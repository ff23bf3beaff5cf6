"""Stops 10 and 11: the zero modes, and the contact that slips first."""

from dataclasses import replace

import numpy as np

from ramanujan.lesson.stop import COMPRESSION, EQUAL, FREQUENCY, Onward, Run, Stop
from ramanujan.physics.contact import first_to_slip, normal_forces, required_friction
from ramanujan.physics.motion import InitialState, released
from ramanujan.physics.oscillator import Oscillator, drawn_spacing
from ramanujan.text.names import CONTACTS
from ramanujan.text.translation import _

_SPEED = COMPRESSION / 2 / EQUAL.period
"""The speed of gliding and rolling [m/s], slow enough to watch."""
_SPACING = drawn_spacing(EQUAL.radius)


def _write_option(contact: str) -> str:
    """Return a contact as an option of the stop on friction."""
    place = CONTACTS[contact].between
    return f"{place[:1].upper()}{place[1:]}."


def count_zero_modes(machine: Oscillator) -> int:
    """Return the number of independent motions that do not deform the spring."""
    stiffness = machine.stiffness_matrix
    return stiffness.shape[0] - int(np.linalg.matrix_rank(stiffness))


def _friction_numbers() -> dict[str, object]:
    """Return the numbers of the stop on friction.

    Returns
    -------
    hoop_slab … : the coefficient of friction that each contact needs
    first, second : the contacts that need the most friction, in words
    most, next : their coefficients
    load : the hoop's share of the slab's weight
    light : the mass ratio below which the top cylinder slips first
    """
    needed = required_friction(EQUAL, COMPRESSION, spacing=_SPACING)
    first, second = sorted(needed, key=needed.__getitem__, reverse=True)[:2]
    loads = normal_forces(EQUAL, [0.0, released(EQUAL, COMPRESSION).phi, 0.0], spacing=_SPACING)
    return needed | {
        "first": CONTACTS[first].between,
        "second": CONTACTS[second].between,
        "most": needed[first],
        "next": needed[second],
        "load": float(loads["hoop_slab"] / (loads["hoop_slab"] + loads["cylinder_slab"])),
        "light": _lightest_without_top_slip(),
    }


def _lightest_without_top_slip() -> float:
    """Return the smallest mass ratio, in steps of 0.01, at which the top contact is not the first to slip."""
    for ratio in np.arange(0.01, 5.0, 0.01):
        machine = replace(EQUAL, m_prime=ratio * EQUAL.m)
        if first_to_slip(machine, COMPRESSION, _SPACING) != "top_block":
            return machine.mass_ratio
    raise RuntimeError("the top cylinder slips first at every mass ratio")


STOPS = (
    Stop(
        id="zero-modes",
        heading=_("Motion without oscillation"),
        question=_(
            "Imagine that you push the machine. In how many independent ways can it then keep moving for ever without "
            "oscillating?"
        ),
        options=dict(none=_("In no way."), one=_("In one way."), two=_("In two ways."), three=_("In three ways.")),
        replies={
            "none": _("Push the whole machine: the spring is not deformed. What could stop it on this floor?"),
            "one": _("The whole machine can glide. Which body can turn while all the others are at rest?"),
            "three": _(
                "There are three coordinates, but the spring does not leave all of them free. Which one does it resist?"
            ),
        },
        answer=lambda: ("none", "one", "two", "three")[count_zero_modes(EQUAL)],
        why=_(
            "The machine has three coordinates, X, φ and Φ, and one spring. The spring resists only φ. In the first "
            "zero mode the whole machine glides. In the second one the top cylinder rolls freely. That makes "
            "{count} zero modes beside one oscillating mode. To each zero mode belongs a conserved momentum."
        ),
        answer_numbers=lambda: {"count": count_zero_modes(EQUAL)},
        hints=(_("A motion oscillates only if it deforms the spring. Which motions leave the spring as it is?"),),
        purpose=_("The answer prepares the spectrum: one oscillating mode and two zero modes."),
        expect=_("“One” is common: the gliding machine is found first, the rolling top cylinder is overlooked."),
        minutes=3,
        runs=(
            Run(label=_("The machine oscillates")),
            Run(label=_("The whole machine glides"), initial=InitialState(X_dot=_SPEED)),
            Run(label=_("The top cylinder rolls freely"), initial=InitialState(Phi_dot=_SPEED / EQUAL.radius)),
        ),
        onward=Onward(_("See the three modes on the page Derivation"), "derivation"),
    ),
    Stop(
        id="contact",
        heading=_("Which contact slips first?"),
        question=_(
            "All bodies have the same mass, and every contact rolls without slipping. That takes friction. The floor "
            "stays frictionless, but the friction at all other contacts is made weaker and weaker. Where does the "
            "first slip happen?"
        ),
        options={
            contact: _write_option(contact) for contact in ("top_block", "hoop_slab", "cylinder_block", "cylinder_slab")
        },
        replies={
            "top_block": _(
                "This contact needs only μ = {top_block:3}. It would slip first if ε were less than {light:2↓}. Why "
                "does another contact need more here?"
            ),
            "cylinder_block": _(
                "This contact needs only μ = {cylinder_block:3}. The weight of the roller presses on the block, too. "
                "Where is a roller pressed less?"
            ),
            "cylinder_slab": _(
                "This contact needs μ = {cylinder_slab:3}, but another one needs {most:3}. Which lower roller is "
                "harder to spin up?"
            ),
        },
        answer=lambda: first_to_slip(EQUAL, COMPRESSION, _SPACING),
        why=_(
            "For rolling without slipping, the contact {first} needs μ = {most:3}. The contact {second} comes next, "
            "with μ = {next:3}. The hoop has the largest moment of inertia, so it needs the largest force to spin it "
            "up. At the release only {load:2 %} of the slab’s weight presses on it."
        ),
        answer_numbers=_friction_numbers,
        hints=(_("Friction has to spin each roller up. Which lower roller resists that more?"),),
        purpose=_("Friction has a purpose here: it makes the rollers turn."),
        expect=_(
            "Many choose the top cylinder, because nothing else drives it. For very light lower rollers they are right."
        ),
        minutes=3,
        runs=(Run(slipping=True),),
        hides=(*FREQUENCY, "forces", "motion"),
        layers=("forces",),
        onward=Onward(_("Change the friction on the page Motion"), "motion", {"figure": "forces"}),
    ),
)
