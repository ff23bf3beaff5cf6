"""Stops 16 and 17: the errors of two integrators, and the formula for Ω² at ε = 10²⁰⁰ in double precision."""

import math
import re
from functools import cache, partial

import numpy as np

from ramanujan.accuracy.extremes import FORMS
from ramanujan.accuracy.runs import History, error_history
from ramanujan.lesson.stop import Onward, Run, Stop
from ramanujan.physics.frequency import UNIT_MASS_RATIO
from ramanujan.physics.integrators import METHODS
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import power_of_ten, unbroken
from ramanujan.text.translation import _

# In step, so that its periods are those of the plain mass. The stiff spring makes them short: the reader waits for 20.
MACHINE = Oscillator(m=1.0, m_prime=UNIT_MASS_RATIO, k=80.0)
COMPRESSION = 0.04
PERIODS = 20
STEPS_PER_PERIOD = {"explicit_euler": 1000, "velocity_verlet": 10}
"""The two methods to compare → their steps per period."""
HUGE = 1e200
"""ε, with m = k = 1."""
_RATIO = power_of_ten(round(math.log10(HUGE)))
# The stage squares masses, too, which would overflow. With this smaller mass the picture is the same: nothing moves.
_DRAWN = Oscillator(m=1.0, m_prime=math.sqrt(HUGE), k=1.0)
_LABEL = _("Nobody lives to see it move: m = 1 kg, m′ = {ratio} kg.").format(ratio=_RATIO)
_LARGEST = float(np.finfo(float).max)

_SAMPLES_PER_PERIOD = 50
"""Number of samples that the stage receives of a period with more steps than that."""


@cache
def compute_history(method: str) -> History:
    """Return the run of one of the two methods."""
    return error_history(method, STEPS_PER_PERIOD[method], PERIODS)


def final_energy_ratio(method: str) -> float:
    """Return the energy after the run as a multiple of the initial energy; the exact value is 1."""
    return 1 + float(compute_history(method).energy_error[-1])


def sample_history(method: str) -> dict[str, object]:
    """Return every nth state of the computed motion for the stage with its energy, and their number per period."""
    history = compute_history(method)
    steps_per_sample = max(STEPS_PER_PERIOD[method] // _SAMPLES_PER_PERIOD, 1)
    return {
        "per_period": STEPS_PER_PERIOD[method] // steps_per_sample,
        "q": history.q[::steps_per_sample].round(5).tolist(),
        "energies": (1 + history.energy_error[::steps_per_sample]).round(4).tolist(),
    }


def largest_energy() -> float:
    """Return the largest energy in the two runs as a multiple of the initial energy."""
    return 1 + max(float(compute_history(method).energy_error.max()) for method in STEPS_PER_PERIOD)


def _find_worse_method() -> str:
    """Return the option for the run with the larger energy error; "both" if the errors are similar."""
    errors = {method: abs(final_energy_ratio(method) - 1) for method in STEPS_PER_PERIOD}
    worst = max(errors, key=errors.__getitem__)
    if min(errors.values()) > errors[worst] / 2:
        return "both"
    return "euler" if worst == "explicit_euler" else "verlet"


def _error_numbers() -> dict[str, object]:
    """Return the final energy with both methods, and the errors of velocity Verlet in energy and phase."""
    return {
        "grown": final_energy_ratio("explicit_euler"),
        "kept": final_energy_ratio("velocity_verlet"),
        "off": abs(final_energy_ratio("velocity_verlet") - 1),
        "turns": abs(float(compute_history("velocity_verlet").phase_error[-1])) / math.tau,
    }


def evaluate_paper_form() -> float:
    """Evaluate the paper's form of Ω² at ε = `HUGE` in double precision."""
    with np.errstate(all="ignore"):
        [value] = FORMS["paper"].evaluate(np.array([1.0]), np.array([HUGE]), np.array([1.0]))
    return float(value)


def _exact_value() -> float:
    return Oscillator(m=1.0, m_prime=HUGE, k=1.0).natural_frequency_squared


def _judge_returned_value() -> str:
    """Return the option that describes the value of the paper's form at ε = `HUGE`."""
    value = evaluate_paper_form()
    if math.isnan(value) or math.isinf(value):
        return "message"
    if value == 0:
        return "zero"
    return "right" if math.isclose(value, _exact_value(), rel_tol=1e-9) else "wrong"


def printed_output() -> str:
    """Return the output of the program; like JavaScript, Python prints the sign of a zero."""
    return f"{evaluate_paper_form():g}"


def program_text() -> str:
    """Return the program of the last stop, in JavaScript."""
    formula = FORMS["paper"].formula.replace("m′", "M").replace("²", "**2").replace("−", "-")
    formula = re.sub(r"(\d)([mMk(])", r"\1*\2", formula).replace(" - ", "\n    - ")
    return f"const m = 1, k = 1;\nconst M = {HUGE:g};  // M = m′\nconsole.log(\n  {formula}\n);"


STOPS = (
    Stop(
        id="steps",
        heading=_("Ten steps or a thousand?"),
        question=_(
            "Two programs compute the motion in small time steps. The first uses explicit Euler with {many} steps per "
            "period. The second uses velocity Verlet with {few}. In which run is the error of the energy larger after "
            "{periods} periods?"
        ),
        question_numbers={
            "many": STEPS_PER_PERIOD["explicit_euler"],
            "few": STEPS_PER_PERIOD["velocity_verlet"],
            "periods": PERIODS,
        },
        options=dict(euler=_("In the first run."), verlet=_("In the second run."), both=_("It is the same in both.")),
        replies={
            "verlet": _(
                "Its energy is off by {off:1 %}, and in the first run the energy is {grown:2} times as large as at the "
                "release. Which method errs in the same direction in every step?"
            ),
            "both": _(
                "At the end the first run has {grown:2} times the energy of the release, the second {kept:3} times. In "
                "which of them do the errors of the steps cancel?"
            ),
        },
        answer=_find_worse_method,
        why=_(
            "Explicit Euler adds energy in every step. After {periods} periods it has {grown:2} times the energy, with "
            "{many} steps per period. Velocity Verlet preserves areas in the phase plane, so its energy error stays "
            "bounded: {off:1 %}, with {few} steps. But its phase is off by {turns:2} of a full turn."
        ),
        answer_numbers=_error_numbers,
        hints=(_("Does a method that is slightly wrong in every step err in the same direction each time?"),),
        purpose=_("The structure of a method can matter more than its step size [4]."),
        expect=_("Nearly everyone trusts the thousand steps. Ask where the additional energy comes from."),
        is_in_short_lesson=True,
        minutes=3,
        runs=(
            Run(MACHINE, COMPRESSION, _("Exact motion"), most_energy=largest_energy),
            *(
                Run(
                    MACHINE,
                    COMPRESSION,
                    METHODS[method].title,
                    samples=partial(sample_history, method),
                    most_energy=largest_energy,
                )
                for method in STEPS_PER_PERIOD
            ),
        ),
        layers=("energy",),
        periods=PERIODS,
        onward=Onward(_("Measure the methods on the page Speed and accuracy"), "speed", {"method": "explicit_euler"}),
    ),
    Stop(
        id="huge-ratio",
        heading=_("A mass ratio of {ratio}"),
        question=_(
            "A program in JavaScript evaluates the paper’s formula, Ω²\u00a0=\u00a0{formula}, in double precision. "
            "Someone enters m\u00a0=\u00a01, k\u00a0=\u00a01 and m′\u00a0=\u00a0{ratio}. What does the program return?"
        ),
        question_numbers={"formula": unbroken(FORMS["paper"].formula), "ratio": _RATIO, "largest": _LARGEST},
        options=dict(
            message=_("Infinity or an error."), right=_("The right value."), zero=_("Zero."), wrong=_("Another number.")
        ),
        replies={
            "message": _(
                "The square of {ratio} becomes infinity, and the denominator becomes −∞. What does division by −∞ give?"
            ),
            "right": _(
                "The right value is {truth:3}. But on the way the program squares {ratio}. Is there a double-precision "
                "number that large?"
            ),
            "wrong": _(
                "That happens with other inputs. Here the denominator contains the square of {ratio}, which is larger "
                "than {largest:2}. What does the denominator become?"
            ),
        },
        answer=_judge_returned_value,
        why=_(
            "The formula squares m + m′. At ε = {ratio} this square is larger than every double-precision number, so "
            "it becomes infinity, and the denominator becomes −∞. Division by −∞ gives {printed}: a zero with a sign. "
            "JavaScript prints it without a warning. The right value is {truth:3}. It is small, but it is an ordinary "
            "number for a computer. A formula that first divides m by m′ finds it without trouble."
        ),
        answer_numbers=lambda: {"truth": _exact_value(), "printed": printed_output().replace("-", "−")},
        hints=(_("The largest double-precision number is about {largest:2}. What is the square of {ratio}?"),),
        purpose=_("A correct formula can fail without a warning."),
        expect=_(
            "“An error” is common, and some languages give one: Python’s power raises an OverflowError, NumPy warns. "
            "JavaScript, C and Fortran return −0 without a warning. Let the class name other programs in which this "
            "could happen."
        ),
        runs=(Run(_DRAWN, label=_LABEL),),
        exhibit=f"```js\n{program_text()}\n```",
        outcome=f"```js\n{program_text()}\n// {printed_output()}\n```",
        onward=Onward(_("See where each formula fails on the page Speed and accuracy"), "speed", {"topic": "limits"}),
    ),
)
