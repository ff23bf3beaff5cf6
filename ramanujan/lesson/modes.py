"""Stops 10 and 11: what can move without oscillating, and which contact slips first."""

from __future__ import annotations

import numpy as np

from ramanujan.contact import drawn_spacing, first_to_slip, normal_forces, required_friction
from ramanujan.lesson.stop import FREQUENCY, Run, Stop, options
from ramanujan.motion import motion, released
from ramanujan.numerals import number, percent
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
COMPRESSION = 0.08

_CONTACTS = {
    "hoop_slab": _("the hoop on the slab"),
    "cylinder_slab": _("the lower cylinder on the slab"),
    "hoop_block": _("the hoop on the block"),
    "cylinder_block": _("the lower cylinder on the block"),
    "top_block": _("the top cylinder on the block"),
}


def zero_modes(machine: Oscillator) -> int:
    """Return the number of independent motions that do not deform the spring."""
    stiffness = machine.stiffness_matrix
    return stiffness.shape[0] - int(np.linalg.matrix_rank(stiffness))


def _modes() -> str:
    return ("none", "one", "two", "three")[zero_modes(EQUAL)]


def _why_modes() -> str:
    return _(
        "The machine has three coordinates, X, φ and Φ, and one spring. The spring resists only φ. In the first "
        "zero mode the whole machine glides. In the second one the top cylinder rolls freely. That makes {count} "
        "zero modes beside one oscillating mode. To each zero mode belongs a conserved momentum."
    ).format(count=zero_modes(EQUAL))


def _contact() -> str:
    return first_to_slip(EQUAL, COMPRESSION, drawn_spacing(EQUAL.radius))


def _why_contact() -> str:
    spacing = drawn_spacing(EQUAL.radius)
    needed = required_friction(EQUAL, COMPRESSION, spacing=spacing)
    at_release = normal_forces(EQUAL, motion(EQUAL, released(EQUAL, COMPRESSION), 0.0)[0], spacing=spacing)
    on_hoop, on_cylinder = float(at_release["hoop_slab"]), float(at_release["cylinder_slab"])
    first, second = sorted(needed, key=needed.__getitem__, reverse=True)[:2]
    return _(
        "To roll without slipping, {first} needs μ = {most}. The next is {second} with μ = {next}. The hoop has "
        "the largest moment of inertia, so it needs the largest force to spin it up. At release, only {share} of the "
        "slab’s weight presses on it."
    ).format(
        first=_CONTACTS[first],
        most=number(needed[first], 3),
        second=_CONTACTS[second],
        next=number(needed[second], 3),
        share=percent(on_hoop / (on_hoop + on_cylinder)),
    )


STOPS = (
    Stop(
        id="zero-modes",
        heading=_("Motion without oscillation"),
        question=_(
            "You may push the machine in any way. In how many independent ways can it keep moving for ever without "
            "oscillating?"
        ),
        options=options(
            none=_("In none: the spring makes everything oscillate."),
            one=_("In one."),
            two=_("In two."),
            three=_("In three, one for each coordinate."),
        ),
        answer=_modes,
        explanation=_why_modes,
        hints=(_("A motion oscillates only if it deforms the spring. Which motions leave the spring as it is?"),),
        minutes=3,
        runs=(Run(EQUAL),),
        page="derivation",
        link_label=_("See the three modes on the page Derivation"),
    ),
    Stop(
        id="contact",
        heading=_("Which contact slips first?"),
        question=_(
            "All bodies have the same mass, and every contact rolls without slipping. That takes friction. The floor "
            "stays frictionless, but the friction at all other contacts is made weaker and weaker. Where does the "
            "first slip happen?"
        ),
        options=options(
            top_block=_("Between top cylinder and block: only friction drives that cylinder."),
            hoop_slab=_("Between hoop and slab."),
            cylinder_block=_("Between lower cylinder and block."),
            cylinder_slab=_("Between lower cylinder and slab: a cylinder is harder to turn than a hoop."),
        ),
        answer=_contact,
        explanation=_why_contact,
        hints=(_("Friction has to spin each roller up. Which lower roller resists that more?"),),
        minutes=3,
        runs=(Run(EQUAL, slipping=True),),
        hides=(*FREQUENCY, "forces", "motion"),
        layers=("forces",),
        page="motion",
        link={"figure": "forces"},
        link_label=_("Change the friction on the page Motion"),
    ),
)
