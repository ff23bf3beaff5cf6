"""Stops 12 to 15: the mass ratio at which the machine is in step, by hand, exactly, why it holds 1729, other bodies."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from ramanujan import number_theory
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.frequency import UNIT_MASS_RATIO, frequency_squared
from ramanujan.lesson.stop import FREQUENCY, Run, Stop, options
from ramanujan.number_theory import BodyChoice
from ramanujan.numerals import number
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
IN_STEP = Oscillator(m=1.0, m_prime=UNIT_MASS_RATIO, k=10.0)

BRACKETS = {
    "half": (Fraction(1, 2), Fraction(1)),
    "quarter": (Fraction(1), Fraction(5, 4)),
    "double": (Fraction(5, 4), Fraction(2)),
    "five": (Fraction(2), Fraction(5)),
}
"""Option → the two mass ratios between which the machine may be in step."""

_ROOT = sp.sqrt(1729)
CANDIDATES = {
    "plus": (_ROOT + 1) / 36,
    "without": _ROOT / 36,
    "minus": (_ROOT - 1) / 36,
    "double": (_ROOT - 1) / 18,
}
"""Option → a mass ratio that may be the exact one; all of them hold 1729, so that no label gives the answer away."""

OTHER_TOP = "sphere"


def normalized(ratio: Fraction) -> Fraction:
    """Return Ω²m/k, exactly."""
    return frequency_squared(Fraction(1), ratio, Fraction(1))


def _plainly(ratio: Fraction) -> str:
    return number(float(ratio), 4, strip=True)


def _by_hand() -> str:
    return next(name for name, (low, high) in BRACKETS.items() if normalized(low) > 1 > normalized(high))


def _why_by_hand() -> str:
    low, high = BRACKETS[_by_hand()]
    return _(
        "At ε = {low} the machine is faster, with Ω²m/k = {fast}. At ε = {high} it is slower, with Ω²m/k = {slow}. "
        "The frequency falls steadily as the rollers become heavier, so the two are in step exactly once. Halve "
        "the interval, and you come closer with every step. The next ratio to try is {middle}, where Ω²m/k = "
        "{value}."
    ).format(
        low=_plainly(low),
        high=_plainly(high),
        fast=number(float(normalized(low)), 4),
        slow=number(float(normalized(high)), 4),
        middle=_plainly((low + high) / 2),
        value=number(float(normalized((low + high) / 2)), 4),
    )


def _exactly() -> str:
    (a, b, c), epsilon = unit_frequency_condition().quadratic.all_coeffs(), sp.Symbol("epsilon")
    return next(
        name
        for name, value in CANDIDATES.items()
        if sp.simplify((a * epsilon**2 + b * epsilon + c).subs(epsilon, value)) == 0
    )


def _quadratic() -> str:
    """Return the condition as text, such as 18ε² + ε − 24 = 0."""
    a, b, c = map(int, unit_frequency_condition().quadratic.all_coeffs())
    middle = "ε" if b == 1 else f"{b}ε"
    return f"{a}ε² + {middle} − {-c} = 0"


def _why_exactly() -> str:
    condition = unit_frequency_condition()
    a, b, c = map(int, condition.quadratic.all_coeffs())
    return _(
        "Ω² = k/m leads to {quadratic}. With a = {a}, b = {b} and c = −{c}, the positive root is (√{root} − "
        "{b})/{twice}, about {value}. A mass ratio cannot be negative, so the other root does not count."
    ).format(
        quadratic=_quadratic(),
        a=a,
        b=b,
        c=-c,
        root=int(condition.discriminant),
        twice=2 * a,
        value=number(float(condition.root), 7),
    )


def _spelled() -> str:
    """Return which of the two sums of cubes has b² and −4ac as its terms."""
    a, b, c = map(int, unit_frequency_condition().quadratic.all_coeffs())
    cubes = _sums()
    spelled = [pair for pair in cubes if sorted(x**3 for x in pair) == sorted((b * b, -4 * a * c))]
    return {0: "neither", 2: "both"}.get(len(spelled), "first" if spelled == cubes[:1] else "second")


def _why_spelled() -> str:
    condition = unit_frequency_condition()
    a, b, c = map(int, condition.quadratic.all_coeffs())
    (x, y), second = _sums()
    p, q = number_theory.norm_form()
    return _(
        "Under the root is b² − 4ac = {b}² + 4·{a}·{c}. Here {b}² = {x}³ and 4·{a}·{c} = {y}³. The other sum, "
        "{second}, does not appear in the coefficients. There is a reason for {number} = {p}² + 3·{q}²: this form "
        "follows from the moments of inertia. No reason is known why it is also the smallest sum of two positive "
        "cubes in two ways."
    ).format(a=a, b=b, c=-c, x=x, y=y, second=_cubes(second), number=int(condition.discriminant), p=p, q=q)


def _sums() -> list[tuple[int, int]]:
    """Return the two ways to write the number under the root as a sum of two positive cubes."""
    return number_theory.sums_of_two_cubes(int(unit_frequency_condition().discriminant))


def _cubes(pair: tuple[int, int]) -> str:
    return f"{pair[0]}³ + {pair[1]}³"


def _other() -> BodyChoice:
    return BodyChoice(top=OTHER_TOP)


def _other_body() -> str:
    paper, other = BodyChoice().discriminant, _other().discriminant
    if other == paper:
        return "same"
    return "whole" if sp.sqrt(other).is_integer else "another"


def _why_other_body() -> str:
    a, b, c = _other().quadratic
    ratio = float(number_theory.positive_root_digits(a, b, c, 10))
    cubes = sum(bool(machine.cubes) for machine in number_theory.machines())
    return _(
        "With a solid sphere on top the number under the root is {number}. The machine is then in step at ε = "
        "{ratio}. The top body is not idle: friction makes it turn, and its moment of inertia counts. Of all "
        "{machines} choices of bodies, only {cubes} lead to a sum of two positive cubes."
    ).format(
        number=_other().discriminant,
        ratio=number(ratio, 4),
        machines=len(number_theory.machines()),
        cubes=cubes,
    )


STOPS = (
    Stop(
        id="by-hand",
        heading=_("In step, by hand"),
        question=_(
            "With equal masses the machine is a little faster than the plain mass. With rollers five times as "
            "heavy it is slower. Between which two mass ratios ε = m′/m is it in step?"
        ),
        options=options(
            **{
                name: _("Between {low} and {high}").format(low=_plainly(low), high=_plainly(high))
                for name, (low, high) in BRACKETS.items()
            }
        ),
        answer=_by_hand,
        explanation=_why_by_hand,
        hints=(
            _(
                "At equal masses it takes {periods} periods of the plain mass until the hands are one full turn apart."
            ).format(periods=round(1 / abs(EQUAL.normalized_frequency_squared**0.5 - 1))),
            _("How much heavier must the rollers be to slow the machine down by so little?"),
        ),
        minutes=3,
        runs=(Run(EQUAL),),
        presets=("unit",),
        dials=True,
        page="oscillator",
        link_label=_("Find it with the slider on the page Oscillator"),
    ),
    Stop(
        id="exactly",
        heading=_("In step, exactly"),
        question=_(
            "Set Ω² equal to k/m. This gives a quadratic equation for the mass ratio: {quadratic}. Which mass "
            "ratio is it exactly?"
        ).format(quadratic=_quadratic()),
        options=options(
            plus="ε = (√1729 + 1)/36",
            without="ε = √1729/36",
            minus="ε = (√1729 − 1)/36",
            double="ε = (√1729 − 1)/18",
        ),
        answer=_exactly,
        explanation=_why_exactly,
        hints=(_("The roots of aε² + bε + c = 0 are (−b ± √(b² − 4ac))/(2a)."),),
        minutes=3,
        runs=(Run(EQUAL),),
        presets=("unit",),
        then=IN_STEP,
        dials=True,
        size="small",
        page="taxicab",
        link_label=_("See the solution on the page 1729"),
    ),
    Stop(
        id="1729",
        heading=_("Why 1729?"),
        question=_(
            "The machine is in step where {quadratic}. The number under the root is {number} = {first} = {second}. "
            "Which of these two sums can you read off the coefficients as b² plus −4ac?"
        ).format(
            quadratic=_quadratic(),
            number=int(unit_frequency_condition().discriminant),
            first=_cubes(_sums()[0]),
            second=_cubes(_sums()[1]),
        ),
        options=options(
            second=_("The second one."),
            both=_("Both."),
            neither=_("Neither: the cubes have nothing to do with the coefficients."),
            first=_("The first one."),
        ),
        answer=_spelled,
        explanation=_why_spelled,
        hints=(_("Work out b² and −4ac separately."),),
        minutes=3,
        runs=(Run(IN_STEP),),
        hides=FREQUENCY,
        size="small",
        page="taxicab",
        link_label=_("Count the cubes on the page 1729"),
    ),
    Stop(
        id="other-body",
        heading=_("Another body, another number?"),
        question=_(
            "The top cylinder is replaced by a solid sphere of the same mass and radius. The spring does not touch "
            "it, and it rolls freely. Which number is now under the root of the exact mass ratio?"
        ),
        options=options(
            same=_("Again 1729: the top body does not matter."),
            another=_("Another number, and the ratio still contains a root."),
            whole=_("A square number, so that the ratio is a fraction."),
        ),
        answer=_other_body,
        explanation=_why_other_body,
        hints=(_("What turns the top body when the block moves under it?"),),
        minutes=3,
        runs=(Run(IN_STEP, bodies=("hoop", "cylinder", OTHER_TOP)),),
        dials=True,
        page="taxicab",
        link={"top": OTHER_TOP},
        link_label=_("Choose the bodies on the page 1729"),
    ),
)
