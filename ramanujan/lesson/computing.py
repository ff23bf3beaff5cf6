"""Stops 16 and 17: what a computer makes of it, ten steps a period or a thousand, and ε = 10²⁰⁰."""

from __future__ import annotations

import math
from functools import cache
from itertools import islice

import numpy as np

from ramanujan.accuracy import FORMS
from ramanujan.integrators import METHODS, trajectory
from ramanujan.lesson.stop import FREQUENCY, Run, Stop, options
from ramanujan.motion import released
from ramanujan.numerals import number, percent
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
COMPRESSION = 0.04
PERIODS = 20
STEPS = {"explicit_euler": 1000, "velocity_verlet": 10}
"""The two methods that are compared, and their steps per period."""
HUGE = 1e200
"""ε, with m = k = 1."""
_RATIO = "10" + str(round(math.log10(HUGE))).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))

_SHOWN = 50
"""Samples per period that the stage needs of a run with many steps."""


@cache
def computed(method: str) -> tuple[np.ndarray, np.ndarray]:
    """Return φ/φ₀ and φ̇/(Ωφ₀) after every step of the method, the release included."""
    steps = STEPS[method]
    run = trajectory(METHODS[method], lambda q: -q, 1.0, 0.0, 2 * math.pi / steps)
    states = np.array([(1.0, 0.0), *islice(run, PERIODS * steps)])
    return states[:, 0], states[:, 1]


def energy_factor(method: str) -> float:
    """Return the energy after the run divided by that at the release; it is 1 for the exact motion."""
    q, v = computed(method)
    return float(q[-1] ** 2 + v[-1] ** 2)


def phase_error(method: str) -> float:
    """Return by how many turns the run is ahead of the exact motion at its end."""
    q, v = computed(method)
    return float(np.unwrap(np.arctan2(-v, q))[-1] / (2 * math.pi) - PERIODS)


def samples(method: str) -> dict[str, object]:
    """Return the computed motion as the stage draws it: X and Φ follow φ as in the mode shape."""
    every = max(STEPS[method] // _SHOWN, 1)
    phi = computed(method)[0][::every] * released(EQUAL, COMPRESSION).phi
    block, _phi, top = EQUAL.mode_shape
    follow = {"X": block * (phi - phi[0]), "phi": phi, "Phi": top * (phi - phi[0])}
    return {
        "step": EQUAL.period / STEPS[method] * every,
        **{name: [float(f"{value:.6g}") for value in values] for name, values in follow.items()},
    }


def _steps() -> str:
    errors = {method: abs(energy_factor(method) - 1) for method in STEPS}
    worst = max(errors, key=errors.__getitem__)
    if min(errors.values()) > errors[worst] / 2:
        return "both"
    return "euler" if worst == "explicit_euler" else "verlet"


def _why_steps() -> str:
    return _(
        "After {periods} periods explicit Euler has multiplied the energy by {grown}, although it takes {many} "
        "steps per period. Velocity Verlet takes {few}, and its energy is off by {off}. Explicit Euler adds energy "
        "in every step. Velocity Verlet preserves areas in the phase plane, so its energy error stays bounded. It "
        "is not exact either: its phase error has grown to {turns} of a full turn."
    ).format(
        periods=PERIODS,
        grown=number(energy_factor("explicit_euler"), 2),
        many=STEPS["explicit_euler"],
        few=STEPS["velocity_verlet"],
        off=percent(abs(energy_factor("velocity_verlet") - 1), 1),
        turns=number(abs(phase_error("velocity_verlet")), 2),
    )


def returned() -> float:
    """Return what the paper's form of Ω² gives at ε = `HUGE` in double precision."""
    with np.errstate(all="ignore"):
        return float(FORMS["paper"].evaluate(np.float64(1.0), np.float64(HUGE), np.float64(1.0)))


def _huge() -> str:
    value, truth = returned(), Oscillator(m=1.0, m_prime=HUGE, k=1.0).natural_frequency_squared
    if math.isnan(value) or math.isinf(value):
        return "message"
    if value == 0:
        return "zero"
    return "right" if math.isclose(value, truth, rel_tol=1e-9) else "wrong"


def _why_huge() -> str:
    return _(
        "The formula squares m + m′. At ε = {ratio} this square is larger than every double-precision number, so "
        "it becomes infinity. Division by infinity gives zero, and JavaScript says nothing about it. The right value "
        "is {truth}. It is small, but it is an ordinary number for a computer. A formula that first divides m by m′ "
        "finds it without trouble."
    ).format(
        ratio=_RATIO,
        truth=number(Oscillator(m=1.0, m_prime=HUGE, k=1.0).natural_frequency_squared, 3),
    )


STOPS = (
    Stop(
        id="steps",
        heading=_("Ten steps or a thousand?"),
        question=_(
            "Two programs compute the motion in small time steps. The first uses explicit Euler with {many} steps per "
            "period. The second uses velocity Verlet with {few}. In which run is the error of the energy larger after "
            "{periods} periods?"
        ).format(many=STEPS["explicit_euler"], few=STEPS["velocity_verlet"], periods=PERIODS),
        options=options(
            verlet=_("In the second one: ten steps per period are far too few."),
            euler=_("In the first one."),
            both=_("It is about the same in both."),
        ),
        answer=_steps,
        explanation=_why_steps,
        hints=(_("Does a method that is slightly wrong in every step err in the same direction each time?"),),
        minutes=3,
        runs=(
            Run(
                EQUAL,
                COMPRESSION,
                METHODS["explicit_euler"].title,
                samples=lambda: samples("explicit_euler"),
            ),
            Run(
                EQUAL,
                COMPRESSION,
                METHODS["velocity_verlet"].title,
                samples=lambda: samples("velocity_verlet"),
            ),
        ),
        page="speed",
        link={"method": "explicit_euler"},
        link_label=_("Measure the methods on the page Speed and accuracy"),
    ),
    Stop(
        id="huge-ratio",
        heading=_("A mass ratio of {ratio}").format(ratio=_RATIO),
        question=_(
            "A program in JavaScript evaluates the paper’s formula, Ω² = {formula}, in double precision. Someone "
            "enters m = 1, k = 1 and m′ = {ratio}. What does the program return?"
        ).format(formula=FORMS["paper"].formula, ratio=_RATIO),
        options=options(
            right=_("The right value, a very small number."),
            zero=_("Zero."),
            message=_("Infinity, or an error message."),
            wrong=_("A number that looks right but is wrong."),
        ),
        answer=_huge,
        explanation=_why_huge,
        hints=(
            _("The largest double-precision number is about {largest}. What is the square of {ratio}?").format(
                largest=number(float(np.finfo(float).max), 2), ratio=_RATIO
            ),
        ),
        minutes=2,
        runs=(Run(EQUAL),),
        hides=FREQUENCY,
        size="small",
        page="speed",
        link_label=_("See where each formula fails on the page Speed and accuracy"),
    ),
)
