"""Stops 6 to 9: which body moves where, and where the energy is."""

from __future__ import annotations

import numpy as np

from ramanujan.energy import energies
from ramanujan.lesson.stop import FREQUENCY, Run, Stop, options
from ramanujan.motion import (
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    released,
)
from ramanujan.numerals import percent, quantity
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
COMPRESSION = 0.08
_CM = 100.0

_BODIES = {"slab": _("slab"), "block": _("block"), "hoop": _("hoop"), "top": _("top cylinder")}


def at(part: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the state (q, q̇) of the released machine after this part of a period."""
    return motion(EQUAL, released(EQUAL, COMPRESSION), part * EQUAL.period)


def _velocities() -> tuple[float, float]:
    """Return the velocities of slab (relative to the block) and block (to the ground) while the slab moves right."""
    rates = at(3 / 4)[1]
    return float(relative_velocities(EQUAL, rates)["slab"]), float(ground_velocities(EQUAL, rates)["block"])


def _block() -> str:
    slab, block = _velocities()
    return "rest" if abs(block) < 1e-3 * abs(slab) else "same" if block * slab > 0 else "opposite"


def _why_block() -> str:
    slab, block = _velocities()
    return _(
        "The floor has no friction, so nothing outside pushes the machine to either side. Its momentum stays zero. "
        "The slab moves right at {slab} relative to the block, so the block moves left at {block}. The centre of "
        "mass stays where it is."
    ).format(slab=quantity(_CM * slab, "cm/s", 3), block=quantity(-_CM * block, "cm/s", 3))


def _paths() -> tuple[float, float]:
    """Return how far a lower roller's centre travels in half a period [m], relative to the block and to the ground."""
    ends = at(0.0)[0], at(0.5)[0]
    return tuple(
        abs(float(places(EQUAL, ends[0])["hoop"] - places(EQUAL, ends[1])["hoop"]))
        for places in (relative_positions, ground_positions)
    )


def _rollers() -> str:
    over_block, over_ground = _paths()
    share = over_ground / over_block
    return "more" if share > 1.1 else "all" if share > 0.9 else "half" if share > 0.25 else "tenth"


def _why_rollers() -> str:
    over_block, over_ground = _paths()
    return _(
        "A centre moves {over_block} to the left relative to the block. Meanwhile the block moves {block} to the "
        "right. Relative to the ground, only {over_ground} is left. The lower rollers spin almost on the spot."
    ).format(
        over_block=quantity(_CM * over_block, "cm", 3),
        block=quantity(_CM * (over_block - over_ground), "cm", 3),
        over_ground=quantity(_CM * over_ground, "cm", 3),
    )


def _stored(part: float) -> dict[str, float]:
    """Return the share of the energy in each body, and in the spring, after this part of a period."""
    terms = {name: float(value) for name, value in energies(EQUAL, *at(part)).items()}
    total = sum(terms.values())
    shares: dict[str, float] = {}
    for name, value in terms.items():
        body = name.partition("_")[0]
        shares[body] = shares.get(body, 0.0) + value / total
    return shares


def _turning() -> str:
    spring = _stored(0.5)["spring"]
    return "spring" if spring > 0.99 else "half" if spring > 0.4 else "bodies"


def _why_turning() -> str:
    return _(
        "Half a period after the release the spring holds {spring} of the energy. Released from rest, all bodies "
        "follow the same cosine. They all stop at the same instants, so none of them has kinetic energy then."
    ).format(spring=percent(_stored(0.5)["spring"], 3))


def _middle() -> str:
    shares = _stored(0.25)
    return max(_BODIES, key=shares.__getitem__)


def _why_middle() -> str:
    shares = _stored(0.25)
    return _(
        "In the middle the slab holds {slab} of the energy and the hoop {hoop}. The block holds {block}, the top "
        "cylinder {top}. The slab is the fastest body. The hoop hardly travels, but it spins and has the largest "
        "moment of inertia for its mass."
    ).format(**{body: percent(shares[body]) for body in _BODIES})


STOPS = (
    Stop(
        id="block",
        heading=_("Which way does the block move?"),
        question=_(
            "The floor has no friction, and the machine starts at rest. At some later moment the slab moves to the "
            "right relative to the block. Which way does the block move relative to the ground?"
        ),
        options=options(
            same=_("To the right: the slab carries it along."),
            rest=_("It stays at rest: the rollers decouple it from the slab."),
            opposite=_("To the left."),
        ),
        answer=_block,
        explanation=_why_block,
        hints=(_("Which horizontal forces act on the machine as a whole?"),),
        minutes=3,
        runs=(Run(EQUAL),),
        layers=("arrows",),
        page="motion",
        link={"figure": "momentum"},
        link_label=_("See the momenta on the page Motion"),
    ),
    Stop(
        id="rollers",
        heading=_("How far do the lower rollers travel?"),
        question=_(
            "All bodies have the same mass. In half a period the slab moves {slab} relative to the block. The centres "
            "of the lower rollers move half as far, {centre}. How far do these centres move relative to the ground?"
        ).format(slab=quantity(2 * _CM * COMPRESSION, "cm", 2), centre=quantity(_CM * COMPRESSION, "cm", 1)),
        options=options(
            all=_("Just as far."),
            tenth=_("Less than a tenth of it."),
            half=_("About half of it."),
            more=_("Farther, because the block moves, too."),
        ),
        answer=_rollers,
        explanation=_why_rollers,
        hints=(
            _(
                "Add two velocities: that of a centre relative to the block, and that of the block relative to the "
                "ground."
            ),
        ),
        minutes=2,
        runs=(Run(EQUAL),),
        layers=("traces",),
        page="motion",
        link={"figure": "displacements"},
        link_label=_("Compare the displacements on the page Motion"),
    ),
    Stop(
        id="turning-point",
        heading=_("The energy at the turning point"),
        question=_(
            "Half a period after the release the slab reaches its other turning point. It stands still relative to "
            "the block for an instant. Where is the energy then?"
        ),
        options=options(
            spring=_("All of it is in the spring."),
            half=_("About half is in the spring, the other half in the moving block and top cylinder."),
            bodies=_("Most of it is in the spinning rollers."),
        ),
        answer=_turning,
        explanation=_why_turning,
        hints=(_("If the slab rests relative to the block, how fast do the lower rollers turn?"),),
        minutes=2,
        runs=(Run(EQUAL),),
        layers=("energy",),
        page="motion",
        link={"figure": "energy"},
        link_label=_("See the energies on the page Motion"),
    ),
    Stop(
        id="middle",
        heading=_("The energy in the middle"),
        question=_(
            "A quarter of a period after the release the spring is relaxed, and all energy is kinetic. Each body "
            "has a mass of {mass}. Which of these bodies has the most energy?"
        ).format(mass=quantity(EQUAL.m, "kg", 1)),
        options=options(
            hoop=_("The hoop: it spins, and all of its mass is at the rim."),
            block=_("The block: it carries all the others."),
            slab=_("The slab."),
            top=_("The top cylinder: it rolls without being driven by the spring."),
        ),
        answer=_middle,
        explanation=_why_middle,
        hints=(
            _("Kinetic energy grows with the square of the speed. Which body is the fastest relative to the ground?"),
        ),
        minutes=3,
        runs=(Run(EQUAL),),
        hides=(*FREQUENCY, "energy", "arrows"),
        layers=("energy",),
        page="motion",
        link={"figure": "energy"},
        link_label=_("See the energies on the page Motion"),
    ),
)
