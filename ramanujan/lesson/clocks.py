"""Stops 1 to 5: the machine's clock hand beside that of a plain mass m on the same spring."""

import math

from ramanujan.lesson.stop import EQUAL, Onward, Run, Stop, choose_by_sign, state_after
from ramanujan.physics.energy import energies
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import filled
from ramanujan.text.translation import _

LIGHT = Oscillator(m=1.0, m_prime=0.1, k=10.0)
HEAVY = Oscillator(m=1.0, m_prime=5.0, k=10.0)
STIFF = Oscillator(m=1.0, m_prime=1.0, k=40.0)
LARGE = Oscillator(m=1.0, m_prime=1.0, k=10.0, radius=0.2)

_PERIODS = 10
"""Periods of the plain mass after which the hands are compared."""
_RADIUS = "R = {radius:2 cm}"
_TOTAL = 3 * EQUAL.m + 2 * EQUAL.m_prime
"""Mass of the five bodies [kg]."""


def turns_ahead(machine: Oscillator) -> float:
    """Return the machine's lead over the plain mass after `_PERIODS` periods of the plain mass [turns]."""
    return _PERIODS * (math.sqrt(machine.normalized_frequency_squared) - 1)


def rotation_share(machine: Oscillator) -> float:
    """Return the share of the lower rollers' rotation in the kinetic energy. The share is the same at all times."""
    stored = energies(machine, *state_after(1 / 4, machine))
    kinetic = sum(float(value) for name, value in stored.items() if name != "spring")
    return float(stored["hoop_rotation"] + stored["cylinder_rotation"]) / kinetic


def _compare_with_plain_mass() -> str:
    """Return the right option for the machine with equal masses. No option is for a machine a full turn ahead."""
    turns = turns_ahead(EQUAL)
    return ("far_" if abs(turns) > 1 else "") + choose_by_sign(turns, "behind", "together", "ahead")


def _compare_stiffer() -> str:
    gain = STIFF.normalized_frequency_squared - EQUAL.normalized_frequency_squared
    return choose_by_sign(gain, "less", "same", "more")


STOPS = (
    Stop(
        id="two-clocks",
        heading=_("Two hands of one clock"),
        question=_(
            "The machine has five bodies of {machine.m:1 kg} each and one spring. A plain mass of {machine.m:1 kg} "
            "moves on an equal spring. Both are released at the same moment. Each has a clock hand that makes one full "
            "turn per period. Where is the machine’s hand after ten periods of the plain mass?"
        ),
        options=dict(
            far_behind=_("Behind by more than one full turn."),
            behind=_("Behind by less than one full turn."),
            together=_("Exactly where the other hand is."),
            ahead=_("Ahead by less than one full turn."),
        ),
        replies={
            "far_behind": _(
                "If the spring had to move all {total:1 kg} as one body, the hand would be {slow:2} turns behind. "
                "Which bodies move in opposite directions?"
            ),
            "behind": _(
                "In that case the machine’s hand would make less than one turn in each period of the plain mass. It "
                "makes {turn:4} turns. How fast would two bodies of {machine.m:1 kg} oscillate with the spring between "
                "them?"
            ),
            "together": _(
                "In that case the hands would never part. But in each period of the plain mass the machine’s hand "
                "makes {turn:4} turns, and the small difference adds up. After how many periods is it a full turn?"
            ),
        },
        answer=_compare_with_plain_mass,
        why=_(
            "After ten periods of the plain mass the machine’s hand is {turns:2} of a full turn ahead. All bodies "
            "together have a mass of {total:1 kg}, but the spring feels only {shown.effective_mass:3 kg}. Block and "
            "slab move in opposite directions."
        ),
        question_numbers={"total": _TOTAL, "ratio": _TOTAL / EQUAL.m},
        answer_numbers=lambda: {
            "turns": turns_ahead(EQUAL),
            "turn": 1 + turns_ahead(EQUAL) / _PERIODS,
            "slow": _PERIODS * (1 - math.sqrt(EQUAL.m / _TOTAL)),
        },
        hints=(
            _(
                "Suppose the spring had to move all five bodies as one. The period would then be √{ratio:1} times as "
                "long."
            ),
            _("Which bodies does the spring push apart? Which bodies can stay almost where they are?"),
        ),
        purpose=_("The question of the whole lesson is: how much mass does the spring feel?"),
        expect=_(
            "Many add up all masses and expect a far slower machine. The answer “exactly together” appeals to those "
            "who know the title."
        ),
        is_in_short_lesson=True,
        minutes=4,
        shows_dials=True,
        periods=_PERIODS,
        onward=Onward(_("See the two hands on the page Oscillator")),
    ),
    Stop(
        id="light-rollers",
        heading=_("Light rollers"),
        question=_(
            "Hoop and lower cylinder are replaced by light ones of {machine.m_prime:1 kg} each. All other bodies keep "
            "their {machine.m:1 kg}. How does the machine’s frequency change?"
        ),
        options=dict(same=_("It stays the same."), rises=_("It rises."), falls=_("It falls.")),
        replies={
            "same": _(
                "The centres of the rollers hardly move, but the rollers spin. Equal rollers take {spin:2 %} of the "
                "kinetic energy for that. How much can light ones take?"
            ),
            "falls": _(
                "Then the spring would feel more mass with lighter rollers. It feels {shown.effective_mass:3 kg} "
                "instead of {equal.effective_mass:3 kg}. Which body takes up less energy now?"
            ),
        },
        answer=lambda: choose_by_sign(
            LIGHT.natural_frequency_squared - EQUAL.natural_frequency_squared, "falls", "same", "rises"
        ),
        why=_(
            "Divide the machine’s frequency by that of the plain mass and square it: this is Ω²m/k. It rises from "
            "{equal.normalized_frequency_squared:4} to {shown.normalized_frequency_squared:4}. The lower rollers "
            "hardly travel, but they spin. With equal masses their spin holds {spin:2 %} of the kinetic energy. With "
            "light rollers it holds only {light_spin:2 %}, so the spring has less to set in motion."
        ),
        answer_numbers=lambda: {"spin": rotation_share(EQUAL), "light_spin": rotation_share(LIGHT)},
        hints=(_("What does a roller do besides moving from place to place?"),),
        purpose=_("Students learn to separate travelling from spinning."),
        expect=_("Those who noticed that the lower rollers hardly move often answer that their mass cannot matter."),
        runs=(Run(LIGHT),),
        shows_dials=True,
        onward=Onward(_("Change the rollers on the page Oscillator")),
    ),
    Stop(
        id="heavy-rollers",
        heading=_("Heavy rollers"),
        question=_(
            "Hoop and lower cylinder are replaced by heavy ones of {machine.m_prime:1 kg} each. All other bodies keep "
            "their {machine.m:1 kg}. Whose hand is ahead after ten periods of the plain mass?"
        ),
        options=dict(
            plain=_("The hand of the plain mass."),
            machine=_("The hand of the machine."),
            neither=_("Neither of the two hands."),
        ),
        replies={
            "machine": _(
                "Then the spring would feel less than {machine.m:1 kg}, but with these rollers it feels "
                "{shown.effective_mass:3 kg}. Which energy grows with the mass of the rollers?"
            ),
            "neither": _(
                "Then the spring would feel exactly {machine.m:1 kg}. With these rollers it feels "
                "{shown.effective_mass:3 kg}. What do the rollers do besides travelling?"
            ),
        },
        answer=lambda: choose_by_sign(turns_ahead(HEAVY), "plain", "neither", "machine"),
        why=_(
            "Ω²m/k is now {shown.normalized_frequency_squared:3}. After ten periods of the plain mass the machine’s "
            "hand is {turns:3} full turns behind. At ε = {equal.mass_ratio:1} the machine was faster, at ε = "
            "{shown.mass_ratio:1} it is slower. Somewhere between these ratios the two are in step."
        ),
        answer_numbers=lambda: {"turns": -turns_ahead(HEAVY)},
        hints=(_("With light rollers the machine became faster. What does that tell you about heavy ones?"),),
        purpose=_("The order of the two clocks changes, so there must be a ratio at which they agree."),
        expect=_("Most get it right after the previous stop. Ask for the argument with the intermediate value."),
        runs=(Run(HEAVY),),
        shows_dials=True,
        periods=_PERIODS,
        onward=Onward(_("Change the rollers on the page Oscillator")),
    ),
    Stop(
        id="stiffness",
        heading=_("A stiffer spring"),
        question=_(
            "All masses are equal. In each period of the plain mass the machine’s hand gains a small fraction of a "
            "turn. Both springs are replaced by springs that are four times as stiff. How large is that fraction now?"
        ),
        options=dict(more=_("Larger than before."), less=_("Smaller than before."), same=_("The same as before.")),
        replies={
            "more": _(
                "The machine’s period falls from {equal.period:3 s} to {shown.period:3 s}. By which factor does the "
                "period of the plain mass fall?"
            ),
            "less": _(
                "A period is shorter now, {shown.period:3 s} instead of {equal.period:3 s}. But both hands turn "
                "faster, too. By which factor does each of them turn faster?"
            ),
        },
        answer=_compare_stiffer,
        why=_(
            "The machine’s period falls from {equal.period:3 s} to {shown.period:3 s}, and that of the plain mass by "
            "the same factor. Ω² and k/m both contain k exactly once, so k drops out of their quotient. It is "
            "{shown.normalized_frequency_squared:4} for every spring. Who is faster is decided by the masses alone."
        ),
        hints=(
            _("The period of a plain mass is proportional to √(m/k). Which power of k is in the machine’s period?"),
        ),
        purpose=_("Dimensional analysis gives the answer: k can enter a period only as 1/√k."),
        expect=_("“Larger” is common: a stiff spring is thought to favour the complicated machine."),
        changed_machine=STIFF,
        shows_dials=True,
        onward=Onward(_("Drag k on the page Oscillator")),
    ),
    Stop(
        id="radius",
        heading=_("Larger rollers"),
        question=_(
            "All three rollers get twice the radius but keep their masses. Their moments of inertia are then four "
            "times as large. How does the period of the machine change?"
        ),
        options=dict(longer=_("It becomes longer."), same=_("It stays the same."), shorter=_("It becomes shorter.")),
        replies={
            "longer": _(
                "The moment of inertia is four times as large. But over the same distance a roller turns half as far. "
                "What does that do to the energy ½Iω²?"
            ),
            "shorter": _(
                "At the same speed a larger roller turns half as fast. But its moment of inertia is four times as "
                "large. What does that do to the energy ½Iω²?"
            ),
        },
        answer=lambda: choose_by_sign(
            EQUAL.natural_frequency_squared - LARGE.natural_frequency_squared, "shorter", "same", "longer"
        ),
        why=_(
            "The period is {runs[0].machine.period:3 s} with {runs[0].label} and {runs[1].machine.period:3 s} with "
            "{runs[1].label}. A roller of twice the radius has four times the moment of inertia. But it turns half as "
            "fast when it rolls the same distance. Its energy of rotation is the same, and so is the frequency."
        ),
        hints=(_("Through which angle does a roller of twice the radius turn when it rolls the same distance?"),),
        purpose=_("Rolling couples spin to travel, so R drops out."),
        expect=_("“Longer” is common, because the moment of inertia is four times as large."),
        runs=tuple(Run(machine, label=filled(_RADIUS, radius=100 * machine.radius)) for machine in (EQUAL, LARGE)),
        onward=Onward(_("Drag R on the page Oscillator, under “More”")),
    ),
)
