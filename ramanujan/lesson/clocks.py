"""Stops 1 to 5: the machine's clock beside that of a plain mass m on the same spring."""

from __future__ import annotations

import math

from ramanujan.energy import energies
from ramanujan.lesson.stop import Run, Stop, options
from ramanujan.motion import motion, released
from ramanujan.numerals import number, percent, quantity
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
LIGHT = Oscillator(m=1.0, m_prime=0.1, k=10.0)
HEAVY = Oscillator(m=1.0, m_prime=5.0, k=10.0)
STIFF = Oscillator(m=1.0, m_prime=1.0, k=40.0)
LARGE = Oscillator(m=1.0, m_prime=1.0, k=10.0, radius=0.2)

_PERIODS = 10
"""Periods of the plain mass after which the hands are compared."""


def lead(machine: Oscillator) -> float:
    """Return by how many turns the machine's hand is ahead after the compared periods of the plain mass."""
    return _PERIODS * (math.sqrt(machine.normalized_frequency_squared) - 1)


def spin_share(machine: Oscillator) -> float:
    """Return the share of the kinetic energy that is rotation of the lower rollers; it is the same at all times."""
    start = released(machine, 0.08)
    stored = energies(machine, *motion(machine, start, machine.period / 4))
    kinetic = sum(float(value) for name, value in stored.items() if name != "spring")
    return float(stored["hoop_rotation"] + stored["cylinder_rotation"]) / kinetic


def _total(machine: Oscillator) -> float:
    return 3 * machine.m + 2 * machine.m_prime


def _kilograms(mass: float) -> str:
    return quantity(mass, "kg", 1)


def _radius(machine: Oscillator) -> str:
    return _("R = {radius}").format(radius=quantity(100 * machine.radius, "cm", 2))


def _first_lead() -> str:
    turns = lead(EQUAL)
    if turns == 0:
        return "together"
    if turns < 0:
        return "far_behind" if turns < -1 else "behind"
    return "ahead" if turns < 1 else "far_ahead"


def _why_ahead() -> str:
    return _(
        "After ten periods of the plain mass the machine’s hand is {turns} of a full turn ahead. All bodies "
        "together have a mass of {total}, but the spring feels only {felt}. Block and slab move in opposite "
        "directions. The centres of the lower rollers hardly move at all."
    ).format(
        turns=number(lead(EQUAL), 2),
        total=_kilograms(_total(EQUAL)),
        felt=quantity(EQUAL.effective_mass, "kg", 3),
    )


def _light() -> str:
    before, after = EQUAL.exact_frequency_squared, LIGHT.exact_frequency_squared
    return "rises" if after > before else "falls" if after < before else "same"


def _why_light() -> str:
    return _(
        "Ω²m/k rises from {before} to {after}. The lower rollers hardly travel, but they spin. With equal masses "
        "their spin holds {spin} of the kinetic energy. With light rollers it holds only {light_spin}, so the "
        "spring has less to set in motion."
    ).format(
        before=number(EQUAL.normalized_frequency_squared, 4),
        after=number(LIGHT.normalized_frequency_squared, 4),
        spin=percent(spin_share(EQUAL)),
        light_spin=percent(spin_share(LIGHT)),
    )


def _heavy() -> str:
    turns = lead(HEAVY)
    return "machine" if turns > 0 else "plain" if turns < 0 else "neither"


def _why_heavy() -> str:
    return _(
        "Ω²m/k is now {value}. After ten periods of the plain mass the machine’s hand is {turns} full turns "
        "behind. At ε = {equal} the machine was faster, at ε = {heavy} it is slower. Somewhere between these "
        "ratios the two are in step."
    ).format(
        value=number(HEAVY.normalized_frequency_squared, 3),
        turns=number(-lead(HEAVY), 3),
        equal=number(EQUAL.mass_ratio, 1),
        heavy=number(HEAVY.mass_ratio, 1),
    )


def _stiffer() -> str:
    soft, stiff = (m.exact_frequency_squared / m.exact[2] for m in (EQUAL, STIFF))
    return "more" if stiff > soft else "less" if stiff < soft else "same"


def _why_stiffness() -> str:
    return _(
        "The machine’s period falls from {soft} to {stiff}, and that of the plain mass by the same factor. Ω² and "
        "k/m both contain k exactly once, so k drops out of their quotient. It is {value} for every spring. Who is "
        "faster is decided by the masses alone."
    ).format(
        soft=quantity(EQUAL.period, "s", 3),
        stiff=quantity(STIFF.period, "s", 3),
        value=number(STIFF.normalized_frequency_squared, 4),
    )


def _larger() -> str:
    before, after = EQUAL.exact_frequency_squared, LARGE.exact_frequency_squared
    return "longer" if after < before else "shorter" if after > before else "same"


def _why_radius() -> str:
    return _(
        "The period is {before} with R = {small} and {after} with R = {large}. A roller of twice the radius has "
        "four times the moment of inertia. But it turns half as fast when it rolls the same distance. Its energy "
        "of rotation is the same, and so is the frequency."
    ).format(
        before=quantity(EQUAL.period, "s", 3),
        after=quantity(LARGE.period, "s", 3),
        small=quantity(100 * EQUAL.radius, "cm", 2),
        large=quantity(100 * LARGE.radius, "cm", 2),
    )


STOPS = (
    Stop(
        id="two-clocks",
        heading=_("Two clocks"),
        question=_(
            "The machine has five bodies of {mass} each and one spring. A plain mass of {mass} moves on an equal "
            "spring. Both are released at the same moment. Each has a clock hand that makes one full turn per "
            "period. Where is the machine’s hand after ten periods of the plain mass?"
        ).format(mass=_kilograms(EQUAL.m)),
        options=options(
            far_behind=_("More than one full turn behind: the machine has five times the mass."),
            behind=_("Behind, but by less than one full turn."),
            together=_("Exactly where the other hand is."),
            ahead=_("Ahead, but by less than one full turn."),
        ),
        answer=_first_lead,
        explanation=_why_ahead,
        hints=(
            _(
                "Suppose the spring had to move all five bodies as one. The period would then be √{ratio} times as "
                "long."
            ).format(ratio=number(_total(EQUAL) / EQUAL.m, 1)),
            _("Which bodies does the spring push apart? Which bodies can stay almost where they are?"),
        ),
        minutes=4,
        runs=(Run(EQUAL),),
        dials=True,
        page="oscillator",
        link_label=_("See the two clocks on the page Oscillator"),
    ),
    Stop(
        id="light-rollers",
        heading=_("Light rollers"),
        question=_(
            "Hoop and lower cylinder are replaced by light ones of {rollers} each. All other bodies keep their "
            "{others}. How does the machine’s frequency change?"
        ).format(rollers=_kilograms(LIGHT.m_prime), others=_kilograms(LIGHT.m)),
        options=options(
            same=_("It stays the same: the centres of the lower rollers hardly move."),
            rises=_("It rises."),
            falls=_("It falls: light rollers let the slab move farther."),
        ),
        answer=_light,
        explanation=_why_light,
        hints=(_("What does a roller do besides moving from place to place?"),),
        minutes=2,
        runs=(Run(LIGHT),),
        dials=True,
        page="oscillator",
        link_label=_("Change the rollers on the page Oscillator"),
    ),
    Stop(
        id="heavy-rollers",
        heading=_("Heavy rollers"),
        question=_(
            "Hoop and lower cylinder are replaced by heavy ones of {rollers} each. All other bodies keep their "
            "{others}. Whose hand is ahead after ten periods of the plain mass?"
        ).format(rollers=_kilograms(HEAVY.m_prime), others=_kilograms(HEAVY.m)),
        options=options(
            plain=_("The hand of the plain mass."),
            machine=_("The hand of the machine."),
            neither=_("Neither: the mass of the lower rollers makes no difference."),
        ),
        answer=_heavy,
        explanation=_why_heavy,
        hints=(_("With light rollers the machine became faster. What does that tell you about heavy ones?"),),
        minutes=2,
        runs=(Run(HEAVY),),
        dials=True,
        page="oscillator",
        link_label=_("Change the rollers on the page Oscillator"),
    ),
    Stop(
        id="stiffness",
        heading=_("A stiffer spring"),
        question=_(
            "All masses are equal, and the machine is a little faster than the plain mass. Both springs are replaced "
            "by springs that are four times as stiff. How much does the machine gain in one period then?"
        ),
        options=options(
            more=_("More than before: the spring now dominates the masses."),
            less=_("Less than before: there is less time to gain in."),
            same=_("The same part of a turn as before."),
        ),
        answer=_stiffer,
        explanation=_why_stiffness,
        hints=(
            _("The period of a plain mass is proportional to √(m/k). Which power of k is in the machine’s period?"),
        ),
        minutes=2,
        runs=(Run(EQUAL),),
        then=STIFF,
        dials=True,
        page="oscillator",
        link_label=_("Drag k on the page Oscillator"),
    ),
    Stop(
        id="radius",
        heading=_("Larger rollers"),
        question=_(
            "All three rollers get twice the radius but keep their masses. Their moments of inertia are then four "
            "times as large. How does the period of the machine change?"
        ),
        options=options(
            longer=_("It becomes longer: more inertia has to turn."),
            same=_("It stays the same."),
            shorter=_("It becomes shorter: larger rollers turn less."),
        ),
        answer=_larger,
        explanation=_why_radius,
        hints=(_("Through which angle does a roller of twice the radius turn when it rolls the same distance?"),),
        minutes=2,
        runs=(
            Run(EQUAL, label=_radius(EQUAL)),
            Run(LARGE, label=_radius(LARGE)),
        ),
        page="oscillator",
        link_label=_("Drag R on the page Oscillator, under “More”"),
    ),
)
