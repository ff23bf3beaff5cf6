"""Tasks that need only the sliders of the machine: its masses, its spring, its release."""

import math
from fractions import Fraction

import numpy as np

from ramanujan.lesson.stop import FREQUENCY, state_after
from ramanujan.lesson.task import Attempt, Task, TaskVerdict, compare_with_goal, miss_goal
from ramanujan.physics.contact import first_to_slip, largest_compression
from ramanujan.physics.frequency import UNIT_MASS_RATIO, mass_ratio_for
from ramanujan.physics.motion import ground_positions, ground_velocities, motion, with_initial_velocities
from ramanujan.physics.oscillator import drawn_spacing
from ramanujan.text.names import CONTACTS
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

# The goals of the tasks and their tolerances.
IN_STEP_TOLERANCE = 1e-3
BY_EAR_TOLERANCE = 0.02
NINE_EIGHTHS = 9 / 8
EXACTLY, NEARLY = 1e-9, 1e-3
_FRACTION = Fraction(float(mass_ratio_for(NINE_EIGHTHS))).limit_denominator(1000)
HALF_WAY_TOLERANCE = 0.01
PARTING, PARTING_TOLERANCE = 10, 0.01
_PARTED = {"fast": (1 + 1 / PARTING) ** 2, "slow": (1 - 1 / PARTING) ** 2}
PERIOD, PERIOD_TOLERANCE = 2.0, 1e-3
FRICTION, NO_SLIP_TOLERANCE = 0.15, 1e-3
MOVING, RESTING = 0.01, 1e-6
"""A block counts as moving from 1 cm/s; a body counts as resting if it moves by at most a micrometre."""
_CM = 100.0
_JUDGED_PERIODS = 20


def judge_in_step(attempt: Attempt) -> TaskVerdict:
    """Judge |Ω²m/k − 1|."""
    value = attempt.machine.normalized_frequency_squared
    sentences = (
        _("Ω²m/k = {value:6}. The machine is in step to a thousandth."),
        _("Ω²m/k = {value:5}. The machine is too fast by {off}; the goal is {goal:1}."),
        _("Ω²m/k = {value:5}. The machine is too slow by {off}; the goal is {goal:1}."),
    )
    return compare_with_goal(value - 1, IN_STEP_TOLERANCE, sentences, value=value, goal=IN_STEP_TOLERANCE)


def judge_by_ear(attempt: Attempt) -> TaskVerdict:
    """Judge |ε/ε* − 1|. The sentence on a miss gives no number, because the ear is to find the way."""
    off = attempt.machine.mass_ratio / UNIT_MASS_RATIO - 1
    if abs(off) > BY_EAR_TOLERANCE:
        return miss_goal(_("Press Listen, and change m′ until the beats become slower and stop."))
    sentence = _("ε is {off:2 %} away from the mass ratio in step. You have tuned the machine by ear.")
    return TaskVerdict(is_done=True, sentence=filled(sentence, off=abs(off)))


def judge_nine_eighths(attempt: Attempt) -> TaskVerdict:
    """Judge |Ω²m/k − 9/8|. The tolerance is so small that only a fraction typed into the box of m′ meets it."""
    value = attempt.machine.normalized_frequency_squared
    off = abs(value - NINE_EIGHTHS)
    if off <= EXACTLY:
        sentence = _("Ω²m/k is 9/8. The mass ratio is a fraction here, without any root.")
        return TaskVerdict(is_done=True, sentence=sentence)
    if off > NEARLY:
        return miss_goal(_("Ω²m/k = {value:7}. That is {off:2} away from 9/8."), value=value, off=off)
    return miss_goal(
        _("Ω²m/k = {value:7}, only {off:2} away. Which fraction is that mass ratio? Type it into the box of m′."),
        value=value,
        off=off,
    )


def judge_half_way(attempt: Attempt) -> TaskVerdict:
    """Judge the slab's share of the compression when the spring is relaxed, relative to the ground."""
    machine = attempt.machine
    q, _q_dot = state_after(np.array([0, 1 / 4]), machine, attempt.compression)
    travel = {}
    for body, (start, relaxed) in ground_positions(machine, q).items():
        travel[body] = abs(float(relaxed - start))
    share = travel["slab"] / (travel["slab"] + travel["block"])
    sentences = (
        _("Slab and block go equally far: the slab covers {slab:4 %} of x₀, the block {block:4 %}."),
        _("The slab covers {slab:4 %} of x₀, the block {block:4 %}. The slab goes {off} farther than half of x₀."),
    )
    return compare_with_goal(2 * share - 1, HALF_WAY_TOLERANCE, sentences, "%", slab=share, block=1 - share)


def judge_parting(attempt: Attempt) -> TaskVerdict:
    """Judge the number of periods of the plain mass until both clock hands are one full turn apart."""
    gained = abs(math.sqrt(attempt.machine.normalized_frequency_squared) - 1)
    periods = 1 / gained if gained else math.inf
    if periods > 1e6:
        return miss_goal(
            _("The hands stay together: the machine is in step. The goal is one full turn in ten periods.")
        )
    # A number within the tolerance may differ from the goal only in its fourth digit.
    sentences = (
        _("The hands are one full turn apart after {periods:4} periods of the plain mass."),
        _("The hands are one full turn apart after {periods:3} periods of the plain mass, {off} too late."),
        _("The hands are one full turn apart after {periods:3} periods of the plain mass, {off} too early."),
    )
    return compare_with_goal(periods - PARTING, PARTING * PARTING_TOLERANCE, sentences, periods=periods)


def judge_two_seconds(attempt: Attempt) -> TaskVerdict:
    """Judge the period."""
    period = attempt.machine.period
    sentences = (
        _("The period is {period:5 s}."),
        _("The period is {period:4 s}, too long by {off}."),
        _("The period is {period:4 s}, too short by {off}."),
    )
    return compare_with_goal(period - PERIOD, PERIOD * PERIOD_TOLERANCE, sentences, "s", period=period)


def judge_no_slip(attempt: Attempt) -> TaskVerdict:
    """Judge whether x₀ is just below the largest compression without slip, for μ = `FRICTION`."""
    machine = attempt.machine
    spacing = drawn_spacing(machine.radius)
    room = largest_compression(machine, FRICTION, spacing=spacing) - attempt.compression
    if room < 0:
        contact = CONTACTS[first_to_slip(machine, attempt.compression, spacing)]
        return miss_goal(
            _("With this x₀ the contact {between} slips. x₀ is too large by {off:2 cm}."),
            between=contact.between,
            off=-_CM * room,
        )
    sentences = (
        _("Every contact rolls, and with {off} more the first one would slip."),
        _("Every contact rolls, but x₀ could be larger by {off}."),
    )
    return compare_with_goal(room, NO_SLIP_TOLERANCE, sentences, "cm")


def judge_top_at_rest(attempt: Attempt) -> TaskVerdict:
    """Judge the largest displacement of the top cylinder relative to the ground while the block moves."""
    machine = attempt.machine
    initial = with_initial_velocities(machine, attempt.release, attempt.glide, attempt.spin)
    times = np.linspace(0.0, _JUDGED_PERIODS * machine.period, 64 * _JUDGED_PERIODS + 1)
    q, q_dot = motion(machine, initial, times)
    path = ground_positions(machine, q)["top"]
    away = float(np.abs(path - path[0]).max())
    largest_velocity = float(np.abs(ground_velocities(machine, q_dot)["block"]).max())
    if largest_velocity < MOVING:
        return miss_goal(
            _("Everything is at rest. The block must move at {least:1 cm/s} or faster."), least=_CM * MOVING
        )
    sentences = (
        _("The top cylinder stays where it is relative to the ground, while the block moves below it."),
        _("Within {periods} periods the top cylinder moves up to {away:2↑ cm} away from its place."),
    )
    return compare_with_goal(away, RESTING, sentences, periods=_JUDGED_PERIODS, away=_CM * away)


TASKS = (
    Task(
        id="in-step",
        heading=_("In step to a thousandth"),
        text=_("Can you set the masses so that Ω²m/k differs from 1 by at most a thousandth?"),
        hints=(
            _("Heavier lower rollers make the machine slower."),
            _("At ε = 1 it is too fast. Increase m′ a little and watch Ω²m/k."),
            _("The goal lies between ε = {low} and ε = {high}.").format(
                low=number(math.floor(100 * UNIT_MASS_RATIO) / 100, 3),
                high=number(math.ceil(100 * UNIT_MASS_RATIO) / 100, 3),
            ),
        ),
        judge=judge_in_step,
    ),
    Task(
        id="by-ear",
        heading=_("Tune it by ear"),
        text=_("Can you find the mass m′ in step by its tones alone, to two percent? Numbers and hands are hidden."),
        hints=(
            _("Two tones of almost the same frequency beat: together they become loud and soft in turn."),
            _("The nearer the two frequencies are, the slower the beats. If they become faster, go the other way."),
            _("Between two directions in which the beats become faster there is a place where they stop."),
        ),
        judge=judge_by_ear,
        hides=("hands", "numbers"),
    ),
    Task(
        id="nine-eighths",
        heading=_("Nine eighths"),
        text=_("Can you make Ω²m/k exactly 9/8? The boxes of the sliders take fractions such as 9/7."),
        hints=(
            _("9/8 is larger than the value at equal masses, so the rollers must be lighter."),
            _(
                "The page Derivation shows Ω² as a fraction of polynomials in m and m′. Set m = 1 and solve Ω²/k = 9/8 "
                "for m′."
            ),
            filled(_("m′/m is a fraction with the denominator {ratio.denominator}."), ratio=_FRACTION),
        ),
        judge=judge_nine_eighths,
    ),
    Task(
        id="two-seconds",
        heading=_("A period of two seconds"),
        text=_("Can you give the machine a period of two seconds, to a thousandth?"),
        hints=(
            _("A softer spring makes the period longer."),
            _("The period is proportional to 1/√k. By which factor must it change?"),
            _(
                "Keep the masses, read the period T, and multiply k by (T/2)², with T in seconds. Type the result into "
                "the box of k."
            ),
        ),
        judge=judge_two_seconds,
    ),
    Task(
        id="parting",
        heading=_("One full turn in ten periods"),
        text=_("Can you make the hands part by one full turn in ten periods of the plain mass, to one percent?"),
        hints=(
            _("There are two solutions: the machine may be faster or slower."),
            _("In one period the hands must part by a tenth of a turn. By which factor must Ω differ from √(k/m)?"),
            filled(_("Look for Ω²m/k = {fast:3} or {slow:2} on the curve of the page Oscillator."), **_PARTED),
        ),
        judge=judge_parting,
    ),
    Task(
        id="half-way",
        heading=_("Equally far"),
        text=_(
            "After the release, the compressed spring pushes slab and block apart until it is relaxed. Can you make "
            "both move equally far relative to the ground, to one percent?"
        ),
        hints=(
            _("The momentum of the machine is zero. Which other bodies carry momentum?"),
            _("The centres of the lower rollers move a little in the slab’s direction. Make them stand still."),
            _("The heavier the lower rollers, the less they move. How large can ε become with these sliders?"),
        ),
        judge=judge_half_way,
        hides=("numbers",),
    ),
    Task(
        id="no-slip",
        heading=_("As far as friction allows"),
        text=_(
            "Every contact has the coefficient of static friction μ = {mu}. Can you set the largest x₀, to a "
            "millimetre, from which every contact rolls?"
        ).format(mu=number(FRICTION, 2)),
        hints=(
            _("The friction that a contact needs is proportional to x₀."),
            _("If even the largest x₀ does not slip, take a stiffer spring."),
            _("The page Motion shows the friction that each contact needs, and compares it with μ."),
        ),
        judge=judge_no_slip,
    ),
    Task(
        id="top-at-rest",
        heading=_("A cylinder that stays behind"),
        text=_(
            "Can you let the block move for ever while the top cylinder’s centre stays at rest relative to the ground? "
            "Choose how the machine starts."
        ),
        hints=(
            _("As long as the spring oscillates, the block shakes the top cylinder. Can the spring be relaxed?"),
            _("Give the whole machine an initial velocity. Which spin of the top cylinder makes up for it?"),
            _(
                "A rolling cylinder moves relative to the block at R times its angular velocity. The sum of both "
                "velocities must be zero."
            ),
        ),
        judge=judge_top_at_rest,
        fields=("release", "glide", "spin"),
        hides=(*FREQUENCY, "energy"),
    ),
)
