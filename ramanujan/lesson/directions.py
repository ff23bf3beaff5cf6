"""Stops 6 to 9: the directions of motion, and the distribution of the energy."""

from ramanujan.lesson.stop import COMPRESSION, EQUAL, FREQUENCY, Onward, Stop, choose_by_sign, state_after
from ramanujan.physics.energy import energies
from ramanujan.physics.motion import ground_positions, ground_velocities, relative_positions, relative_velocities
from ramanujan.text.translation import _

_CM = 100.0
_BODIES = ("slab", "block", "hoop", "top")
_MIDDLE, _TURNING_POINT = 0.25, 0.5
"""Parts of a period: when the spring is relaxed, and when the slab has reached its other turning point."""


def _velocity_numbers() -> dict[str, float]:
    """Return velocities and a momentum at a quarter of a period, when the slab moves to the left.

    Returns
    -------
    slab : velocity relative to the block, positive to the left [cm/s]
    block : velocity relative to the ground, positive to the right [cm/s]
    momentum : momentum of slab and lower rollers to the left if the block were at rest [kg m/s]
    """
    _q, q_dot = state_after(_MIDDLE)
    slab = -float(relative_velocities(EQUAL, q_dot)["slab"])
    return {
        "slab": _CM * slab,
        "block": _CM * float(ground_velocities(EQUAL, q_dot)["block"]),
        # The two lower rollers are half as fast as the slab.
        "momentum": (EQUAL.m + EQUAL.m_prime) * slab,
    }


def _find_direction_of_block() -> str:
    """Return the option for the block's direction while the slab moves to the left."""
    velocities = _velocity_numbers()
    ratio = velocities["block"] / velocities["slab"]
    return choose_by_sign(ratio if abs(ratio) > 1e-3 else 0, "same", "rest", "opposite")


def _path_numbers() -> dict[str, float]:
    """Return distances that are covered in half a period [cm].

    Returns
    -------
    over_block, over_ground : path of a lower roller's centre relative to the block, and relative to the ground
    block : path of the block
    half : path that the block would have if the centre moved half as far over the ground as over the block
    """
    start, _q_dot = state_after(0.0)
    end, _q_dot = state_after(_TURNING_POINT)
    over_block = _CM * abs(float(relative_positions(EQUAL, start)["hoop"] - relative_positions(EQUAL, end)["hoop"]))
    over_ground = _CM * abs(float(ground_positions(EQUAL, start)["hoop"] - ground_positions(EQUAL, end)["hoop"]))
    return {
        "over_block": over_block,
        "over_ground": over_ground,
        "block": over_block - over_ground,
        "half": over_block / 2,
    }


def _compare_paths() -> str:
    """Return the option for the path over the ground as a share of the path over the block."""
    paths = _path_numbers()
    share = paths["over_ground"] / paths["over_block"]
    if share > 1.1:
        return "more"
    if share > 0.9:
        return "all"
    return "half" if share > 0.25 else "tenth"


def _energy_shares(part: float) -> dict[str, float]:
    """Return the shares of the energy in the bodies and in the spring after this part of a period."""
    terms = {name: float(value) for name, value in energies(EQUAL, *state_after(part)).items()}
    total = sum(terms.values())
    shares = {}
    for body in (*_BODIES, "spring"):
        energies_of_body = [value for name, value in terms.items() if name.partition("_")[0] == body]
        shares[body] = sum(energies_of_body) / total
    return shares


def _turning_point_numbers() -> dict[str, float]:
    """Return the spring's share of the energy, and its stretch [cm], half a period after the release."""
    q, _q_dot = state_after(_TURNING_POINT)
    stretch = abs(float(relative_positions(EQUAL, q)["slab"]))
    return {"spring": _energy_shares(_TURNING_POINT)["spring"], "stretch": _CM * stretch}


def _middle_numbers() -> dict[str, float]:
    """Return the shares of the energy, and the block's speed [cm/s], a quarter of a period after the release."""
    _q, q_dot = state_after(_MIDDLE)
    block_speed = abs(float(ground_velocities(EQUAL, q_dot)["block"]))
    return {**_energy_shares(_MIDDLE), "block_speed": _CM * block_speed}


def _find_energy_at_turning_point() -> str:
    """Return the option for the spring's share of the energy half a period after the release."""
    share = _energy_shares(_TURNING_POINT)["spring"]
    if share > 0.99:
        return "spring"
    return "half" if share > 0.4 else "bodies"


STOPS = (
    Stop(
        id="block",
        heading=_("Which way does the block move?"),
        question=_(
            "The floor has no friction, and the machine starts at rest. At first the slab moves to the left relative "
            "to the block. Which way does the block move relative to the ground?"
        ),
        options=dict(
            opposite=_("It moves to the right."), rest=_("It stays where it is."), same=_("It moves to the left.")
        ),
        replies={
            "rest": _(
                "Then slab and lower rollers alone would carry a momentum of {momentum:2 kg·m/s} to the left. Which "
                "body can carry as much to the right?"
            ),
            "same": _(
                "Then every body would carry momentum to the left. At the release there was none. Which force from "
                "outside could have changed that?"
            ),
        },
        answer=_find_direction_of_block,
        why=_(
            "The floor has no friction, so nothing outside pushes the machine to either side. Its momentum stays zero. "
            "When the spring is relaxed, the slab moves left at {slab:3 cm/s} relative to the block, so the block "
            "moves right at {block:3 cm/s}. The centre of mass stays where it is."
        ),
        answer_numbers=_velocity_numbers,
        hints=(_("Which horizontal forces act on the machine as a whole?"),),
        purpose=_("Conservation of momentum gives the answer, without any calculation."),
        expect=_("Some let the slab carry the block along, as friction would on a rough floor."),
        minutes=3,
        layers=("arrows",),
        onward=Onward(_("See the momenta on the page Motion"), "motion", {"figure": "momentum"}),
    ),
    Stop(
        id="rollers",
        heading=_("How far do the lower rollers travel?"),
        question=_(
            "All bodies have the same mass. In half a period the slab moves {whole:2 cm} relative to the block. The "
            "centres of the lower rollers move half as far, {centre:1 cm}. How far do these centres move relative to "
            "the ground?"
        ),
        question_numbers={"whole": 2 * _CM * COMPRESSION, "centre": _CM * COMPRESSION},
        options=dict(
            all=_("Exactly {centre:1 cm}."),
            tenth=_("Less than a tenth of {centre:1 cm}."),
            half=_("About half of {centre:1 cm}."),
            more=_("Farther than {centre:1 cm}."),
        ),
        replies={
            "all": _(
                "Then the block would stay at rest. It moves {block:3 cm} the other way. What is left of the path?"
            ),
            "half": _(
                "Then the block would move about {half:1 cm} the other way, but it moves {block:3 cm}. Whose momentum "
                "does it have to balance?"
            ),
            "more": _(
                "Then block and rollers would move to the same side. While the centres move left on the block, which "
                "way does the block move?"
            ),
        },
        answer=_compare_paths,
        why=_(
            "A centre moves {over_block:3 cm} to the left relative to the block. Meanwhile the block moves {block:3 "
            "cm} to the right. Relative to the ground, only {over_ground:3 cm} is left. The lower rollers spin almost "
            "on the spot."
        ),
        answer_numbers=_path_numbers,
        hints=(
            _(
                "Add two velocities: that of a centre relative to the block, and that of the block relative to the "
                "ground."
            ),
        ),
        purpose=_("Students practise relative velocities, with a surprising result."),
        expect=_(
            "Few expect that the two velocities nearly cancel. Let the class watch the centre of the hoop against the "
            "ruler."
        ),
        layers=("traces",),
        is_in_short_lesson=True,
        onward=Onward(_("Compare the displacements on the page Motion"), "motion", {"figure": "displacements"}),
    ),
    Stop(
        id="turning-point",
        heading=_("The energy at the turning point"),
        question=_(
            "Half a period after the release the slab reaches its other turning point. It stands still relative to the "
            "block for an instant. Where is the energy then?"
        ),
        options=dict(
            spring=_("All of it is in the spring."),
            half=_("About half of it is in the spring."),
            bodies=_("Most of it is in the bodies."),
        ),
        replies={
            "half": _(
                "Then some body would still move. The lower rollers do not turn, and the machine has no momentum. "
                "Which body could it be?"
            ),
            "bodies": _(
                "At this instant the spring is stretched by {stretch:1 cm}, as much as it was compressed at the "
                "release. How much energy does that take?"
            ),
        },
        answer=_find_energy_at_turning_point,
        why=_(
            "Half a period after the release the spring holds {spring:3 %} of the energy. Released from rest, all "
            "bodies follow the same cosine. They all stop at the same instants, so none of them has kinetic energy "
            "then."
        ),
        answer_numbers=_turning_point_numbers,
        hints=(_("If the slab rests relative to the block, how fast do the lower rollers turn?"),),
        purpose=_("Released from rest, only one mode is excited, so all bodies stop together."),
        expect=_("Some expect that the free top cylinder still moves."),
        layers=("energy",),
        onward=Onward(_("See the energies on the page Motion"), "motion", {"figure": "energy"}),
    ),
    Stop(
        id="middle",
        heading=_("The energy in the middle"),
        question=_(
            "A quarter of a period after the release the spring is relaxed, and all energy is kinetic. Each body has a "
            "mass of {machine.m:1 kg}. Which of these bodies has the most energy?"
        ),
        options=dict(hoop=_("The hoop."), block=_("The block."), slab=_("The slab."), top=_("The top cylinder.")),
        replies={
            "hoop": _(
                "It spins with all of its mass at the rim, and that takes {hoop:2 %} of the energy. But it hardly "
                "travels. Which body is the fastest relative to the ground?"
            ),
            "block": _(
                "It holds {block:2 %} of the energy and moves at {block_speed:2 cm/s}. How fast is the slab, which "
                "moves the other way?"
            ),
            "top": _(
                "It holds {top:2 %} of the energy. The block drives it by friction alone, so it is slower than the "
                "block. Which body does the spring push directly?"
            ),
        },
        answer=lambda: max(_BODIES, key=_energy_shares(_MIDDLE).__getitem__),
        why=_(
            "In the middle the slab holds {slab:2 %} of the energy and the hoop {hoop:2 %}. The block holds {block:2 "
            "%}, the top cylinder {top:2 %}. The slab is the fastest body. The hoop hardly travels, but it spins and "
            "has the largest moment of inertia for its mass."
        ),
        answer_numbers=_middle_numbers,
        hints=(
            _("Kinetic energy grows with the square of the speed. Which body is the fastest relative to the ground?"),
        ),
        purpose=_("Students compare kinetic energy of translation and of rotation."),
        expect=_("The hoop is a popular answer, and it comes second. The machine may run while the class thinks."),
        is_in_short_lesson=True,
        minutes=3,
        hides=(*FREQUENCY, "energy", "arrows"),
        layers=("energy",),
        onward=Onward(_("See the energies on the page Motion"), "motion", {"figure": "energy"}),
    ),
)
