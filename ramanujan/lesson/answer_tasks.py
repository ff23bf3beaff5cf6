"""Tasks with an answer to type or to choose: a time, a measurement, a formula, a method, three bodies."""

from ramanujan.accuracy.work_precision import LARGEST_ERROR, PERIODS, diagram_curve, find_cheapest_runs
from ramanujan.answers import judge as judge_formula
from ramanujan.lesson.stop import FREQUENCY, state_after
from ramanujan.lesson.task import Attempt, Task, TaskVerdict, compare_with_goal, miss_goal
from ramanujan.number_theory import BodyChoice, machines, sums_of_two_cubes
from ramanujan.physics.energy import energies
from ramanujan.physics.integrators import METHODS
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

WITHIN = 0.01
"""The largest allowed error of an integrator [turns]."""
HALF_TOLERANCE = 0.005
NEGLIGIBLE = 1e-6
"""A share of the energy below this limit cannot be drawn, so the sentence treats it as zero."""
STOPWATCH_TOLERANCE = 0.01
TOO_FAST = 0.7
"""The stage shows a shorter period in slow motion, so a stopwatch cannot measure it [s]."""


def judge_half_energy(attempt: Attempt) -> TaskVerdict:
    """Judge the spring's share of the energy after a part of a period."""
    if attempt.part is None or not 0 <= attempt.part <= 1:
        instruction = _("Type a number between 0 and 1, such as 0.3 or 1/3.")
        return TaskVerdict(is_done=False, sentence=instruction, is_judged=False)
    stored = energies(attempt.machine, *state_after(attempt.part, attempt.machine, attempt.compression))
    share = float(stored["spring"]) / sum(map(float, stored.values()))
    sentences = (
        _("At that moment the spring holds {share:3 %} of the energy."),
        _("At that moment the spring holds {share:3 %} of the energy. That is {off} of the total too much."),
        _("At that moment the spring holds {share:3 %} of the energy. That is {off} of the total too little."),
    )
    # TRANSLATORS: the spring holds none of the energy.
    return compare_with_goal(
        share - 0.5, HALF_TOLERANCE, sentences, "%", share=share if share > NEGLIGIBLE else _("none")
    )


def judge_measured_period(attempt: Attempt) -> TaskVerdict:
    """Judge a measurement of the period with a stopwatch."""
    period = attempt.machine.period
    if period < TOO_FAST:
        return miss_goal(_("This machine is so fast that it is shown in slow motion. Make the spring softer."))
    if attempt.seconds is None or attempt.seconds <= 0:
        instruction = _("Start the stopwatch at a turning point, and stop it after as many periods as you like.")
        return TaskVerdict(is_done=False, sentence=instruction, is_judged=False)
    measured = attempt.seconds / attempt.periods
    sentences = (
        _("You measured {measured:4 s} for one period. Your error is {off}."),
        _("You measured {measured:4 s} for one period. That is {off} too long."),
        _("You measured {measured:4 s} for one period. That is {off} too short."),
    )
    return compare_with_goal(measured / period - 1, STOPWATCH_TOLERANCE, sentences, "%", measured=measured)


def judge_exact_ratio(attempt: Attempt) -> TaskVerdict:
    """Judge a formula for the mass ratio with `answers.judge`."""
    if not attempt.formula.strip():
        instruction = _("Type a formula, such as (sqrt(5) − 1)/2.")
        return TaskVerdict(is_done=False, sentence=instruction, is_judged=False)
    verdict = judge_formula("unit_mass_ratio", attempt.formula)
    return TaskVerdict(verdict.kind in ("right", "unsimplified"), verdict.message)


def judge_cheapest(attempt: Attempt) -> TaskVerdict:
    """Judge a method and its number of steps: the error first, then the cost."""
    run = diagram_curve(attempt.method).select(attempt.steps)
    if run.error > WITHIN:
        sentence = _(
            "The computed machine is up to {error:2↑} of a turn away from the exact one. At most {goal:1↑} is allowed."
        )
        if round(run.error, 2) >= LARGEST_ERROR:
            sentence = _(
                "The computed machine is at least half a turn off, or swings more than twice as far. At most {goal:1↑} "
                "of a turn is allowed."
            )
        return miss_goal(sentence, error=run.error, goal=WITHIN)
    sentences = (
        _("It stays within {error:2↑} of a turn. No method here needs fewer than {cost} evaluations of the force."),
        _("It stays within {error:2↑} of a turn. But {cost} evaluations are {times:3} times as many as necessary."),
    )
    best, *_others = find_cheapest_runs(map(diagram_curve, METHODS), WITHIN)
    cost, fewest = run.evaluations, best.evaluations
    return compare_with_goal(cost - fewest, 0, sentences, error=run.error, cost=cost, times=cost / fewest)


def judge_two_cubes(attempt: Attempt) -> TaskVerdict:
    """Judge a choice of bodies: its discriminant must be a sum of two cubes, and not the paper's 1729."""
    choice = BodyChoice(*attempt.bodies)
    value = choice.discriminant
    if value == BodyChoice().discriminant:
        return miss_goal(_("This is the paper’s machine with its {number}. Can you find another one?"), number=value)
    if choice.cubes:
        sentence = _("The number of this machine is {n} = {pair[0]}³ + {pair[1]}³.")
        return TaskVerdict(is_done=True, sentence=filled(sentence, n=value, pair=choice.cubes[0]))
    off = _distance_to_sum_of_cubes(value)
    sentence = _("The number of this machine is {number}. The nearest sum of two positive cubes is {off} away.")
    return miss_goal(sentence, number=value, off=off)


def _distance_to_sum_of_cubes(value: int) -> int:
    """Return the distance of a number from the nearest sum of two positive cubes."""
    distance = 1
    while not (sums_of_two_cubes(value + distance) or (value > distance and sums_of_two_cubes(value - distance))):
        distance += 1
    return distance


TASKS = (
    Task(
        id="half-energy",
        heading=_("Half of the energy"),
        text=_(
            "After which part of a period does the spring hold half of the energy? Type it as a number or a fraction."
        ),
        hints=(
            _("At release the spring holds all of the energy. A quarter of a period later it holds none."),
            _(
                "The spring’s energy is proportional to the square of its compression, and the compression follows a "
                "cosine."
            ),
            _("Where is cos² equal to ½?"),
        ),
        judge=judge_half_energy,
        fields=("part",),
        hides=("energy", *FREQUENCY),
    ),
    Task(
        id="period",
        heading=_("The period, by hand"),
        text=_("Can you measure the period of the machine to one percent with the stopwatch?"),
        hints=(
            _("The slab is at rest for an instant at its turning points. They are easy to see."),
            _("Your reaction time spoils a single period. Measure ten of them."),
            _("Say “zero” when you start the stopwatch, then count. Stop it at “ten”."),
        ),
        judge=judge_measured_period,
        fields=("seconds", "periods"),
        hides=FREQUENCY,
    ),
    Task(
        id="exact-ratio",
        heading=_("The exact ratio"),
        text=_("For which mass ratio ε = m′/m is Ω² = k/m? Type the exact number, with a root."),
        hints=(
            _("Set Ω²m/k equal to 1 and multiply by the denominator."),
            _("Solve the quadratic equation for ε. Only one of its roots is positive."),
        ),
        judge=judge_exact_ratio,
        fields=("formula",),
        hides=FREQUENCY,
    ),
    Task(
        id="cheapest",
        heading=_("The cheapest integrator"),
        text=_(
            "A computed machine has to stay within {within} of a turn of the exact one for {periods} periods. Can you "
            "do it with as few evaluations of the force as possible?"
        ).format(within=number(WITHIN, 1), periods=PERIODS),
        hints=(
            _("A method of higher order costs more per step but needs fewer steps."),
            _(
                "For each method, find the smallest number of steps that is accurate enough. Then compare the "
                "evaluations."
            ),
            _("The work–precision diagram on the page Speed and accuracy shows which method wins."),
        ),
        judge=judge_cheapest,
        fields=("method", "steps"),
        has_stage=False,
    ),
    Task(
        id="two-cubes",
        heading=_("Another sum of two cubes"),
        text=_(
            "Every choice of bodies has its own number under the root. Can you find a machine other than the paper’s "
            "whose number is a sum of two positive cubes?"
        ),
        hints=(
            filled(
                _("Of all {machines} choices, {cubes} have this property, the paper’s included."),
                machines=len(machines()),
                cubes=sum(bool(machine.cubes) for machine in machines()),
            ),
            _("Try a machine with a spherical shell in it."),
            _("One of them has two solid spheres below."),
        ),
        judge=judge_two_cubes,
        fields=("bodies",),
        has_stage=False,
    ),
)
