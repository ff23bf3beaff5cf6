"""Stops 12 to 15: the mass ratio in step, by hand and exactly, the reason for 1729, and other bodies."""

import math
from fractions import Fraction

import sympy as sp

from ramanujan import number_theory
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.derivation.printers import latex
from ramanujan.lesson.stop import EQUAL, FREQUENCY, Onward, Run, Stop
from ramanujan.number_theory import BodyChoice
from ramanujan.physics.frequency import UNIT_MASS_RATIO
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import filled, number, quantity, unbroken, with_unit
from ramanujan.text.translation import _

IN_STEP = Oscillator(m=1.0, m_prime=UNIT_MASS_RATIO, k=10.0)

BRACKETS = {
    "half": (Fraction(1, 2), Fraction(1)),
    "quarter": (Fraction(1), Fraction(5, 4)),
    "double": (Fraction(5, 4), Fraction(2)),
    "five": (Fraction(2), Fraction(5)),
}
"""Option → two mass ratios; one of the options encloses the mass ratio in step."""

CANDIDATES = {"eighths": Fraction(9, 8), "decimal": Fraction(1127, 1000)}
"""Option → a fraction close to the mass ratio in step."""
RANGE = Fraction(112, 100), Fraction(113, 100)
"""Two mass ratios that enclose the mass ratio in step."""

OTHER = BodyChoice(top="sphere")
"""The bodies of the stop “Another body, another number?”."""

A, B, C = map(int, unit_frequency_condition().quadratic.all_coeffs())
"""The coefficients of the quadratic equation aε² + bε + c = 0 for the mass ratio in step."""


def write_quadratic(a: int, b: int, c: int) -> str:
    """Return the equation aε² + bε + c = 0 as text.

    >>> write_quadratic(18, 1, -24).replace("\xa0", " "), write_quadratic(3, 0, -4).replace("\xa0", " ")
    ('18ε² + ε − 24 = 0', '3ε² − 4 = 0')
    """
    text = f"{a}ε²"
    for coefficient, power in ((b, "ε"), (c, "")):
        if coefficient:
            sign = "−" if coefficient < 0 else "+"
            size = "" if power and abs(coefficient) == 1 else abs(coefficient)
            text += f" {sign} {size}{power}"
    return unbroken(f"{text} = 0")


_QUADRATIC = write_quadratic(A, B, C)
_QUADRATIC_OF_OTHER = write_quadratic(*OTHER.quadratic)
_NUMBER = int(unit_frequency_condition().discriminant)
_ROOT = unbroken(f"(√{_NUMBER} − {B})/{2 * A}")
_QUADRATIC_SLOTS = {"quadratic": _QUADRATIC, "a": A, "b": B, "c": -C}
"""The quadratic equation and its coefficients, by their slots in the sentences."""
_EQUATIONS = (
    rf"\frac{{\Omega^2m}}{{k}}={latex(unit_frequency_condition().normalized_frequency_squared)}=1",
    f"{latex(unit_frequency_condition().quadratic.as_expr())}=0",
)
"""The condition Ω²m/k = 1 and its quadratic equation, as LaTeX."""
_SUMS = number_theory.sums_of_two_cubes(_NUMBER)


def _display_equations(*equations: str) -> str:
    """Return equations as Markdown, left-aligned below each other, so that the display is as wide as the longest."""
    return r"$$\begin{{aligned}}&{}\end{{aligned}}$$".format(r"\\[2pt]&".join(equations))


def exact_frequency_squared(ratio: Fraction) -> Fraction:
    """Return Ω²m/k at a mass ratio, exactly."""
    return number_theory.normalized_frequency_squared_exact(*BodyChoice().bodies, ratio)


def _write_decimal(ratio: Fraction) -> str:
    return number(float(ratio), 4, strip=True)


def _bracket_numbers(name: str) -> dict[str, object]:
    """Return the two mass ratios of a bracket and the one in the middle, and Ω²m/k at each of them."""
    low, high = BRACKETS[name]
    middle = (low + high) / 2
    return {
        "low": _write_decimal(low),
        "high": _write_decimal(high),
        "fast": float(exact_frequency_squared(low)),
        "slow": float(exact_frequency_squared(high)),
        "middle": _write_decimal(middle),
        "value": float(exact_frequency_squared(middle)),
    }


def _explain_bracket(name: str) -> str:
    """Return the reply to a bracket that does not enclose the mass ratio in step."""
    too_fast = _("Ω²m/k is {fast:4} at ε = {low} and {slow:4} at ε = {high}: too fast at both. Which way must ε go?")
    too_slow = _("Ω²m/k is {fast:4} at ε = {low} and {slow:4} at ε = {high}: too slow at both. Which way must ε go?")
    _low, high = BRACKETS[name]
    return filled(too_fast if exact_frequency_squared(high) >= 1 else too_slow, **_bracket_numbers(name))


def _find_bracket() -> str:
    """Return the option whose two mass ratios enclose the mass ratio in step."""
    return next(
        name
        for name, (low, high) in BRACKETS.items()
        if exact_frequency_squared(low) > 1 > exact_frequency_squared(high)
    )


def evaluate_quadratic(ratio: Fraction) -> Fraction:
    """Return aε² + bε + c, which is zero at the mass ratio in step."""
    return A * ratio**2 + B * ratio + C


def periods_until_apart(ratio: Fraction) -> float:
    """Return the number of periods of the plain mass until the hands are one full turn apart."""
    return 1 / abs(float(exact_frequency_squared(ratio)) ** 0.5 - 1)


def _candidate_numbers() -> dict[str, object]:
    """Return the numbers of the candidates, of the range, and of the exact ratio."""
    root = unit_frequency_condition().root
    below, (low, high) = math.isqrt(_NUMBER), RANGE
    numbers: dict[str, object] = {name: float(evaluate_quadratic(ratio)) for name, ratio in CANDIDATES.items()}
    numbers |= {f"{name}_periods": periods_until_apart(ratio) for name, ratio in CANDIDATES.items()}
    return numbers | {
        "fast": float(exact_frequency_squared(low)),
        "slow": float(exact_frequency_squared(high)),
        "value": float(root) * EQUAL.m,
        "heavier": float(root) - 1,
        "below": below,
        "above": below + 1,
    }


def _find_exact_candidate() -> str:
    """Return the option for the exact mass ratio: a candidate, "irrational", or else "several"."""
    for name, ratio in CANDIDATES.items():
        if evaluate_quadratic(ratio) == 0:
            return name
    return "several" if unit_frequency_condition().root.is_rational else "irrational"


def _find_sum_of_cubes() -> str:
    """Return the option for the sum of cubes whose terms are b² and −4ac."""
    terms = sorted((B * B, -4 * A * C))
    is_first, is_second = (sorted(x**3 for x in pair) == terms for pair in _SUMS)
    if is_first and is_second:
        return "both"
    if is_first:
        return "first"
    return "second" if is_second else "neither"


def _compare_other_body() -> str:
    """Return the option for the discriminant with the other bodies."""
    paper, other = BodyChoice().discriminant, OTHER.discriminant
    if other == paper:
        return "same"
    return "square" if sp.sqrt(other).is_integer else "another"


def _other_body_numbers() -> dict[str, object]:
    """Return the numbers of the machine with the other bodies, and the counts of all machines."""
    all_machines = number_theory.machines()
    a, b, _c = OTHER.quadratic
    return {
        "number": OTHER.discriminant,
        "quadratic": _QUADRATIC_OF_OTHER,
        "ratio": (math.sqrt(OTHER.discriminant) - b) / (2 * a),
        "machines": len(all_machines),
        "cubes": sum(bool(machine.cubes) for machine in all_machines),
    }


STOPS = (
    Stop(
        id="by-hand",
        heading=_("In step, by hand"),
        question=_(
            "The machine is in step with the plain mass where Ω²\u00a0=\u00a0k/m. This happens at only one mass ratio "
            "ε\u00a0=\u00a0m′/m. Between which two ratios is it?"
        ),
        options={name: filled(_("Between {low} and {high}"), **_bracket_numbers(name)) for name in BRACKETS},
        replies={name: _explain_bracket(name) for name in BRACKETS if name != _find_bracket()},
        question_numbers={"periods": round(1 / abs(EQUAL.normalized_frequency_squared**0.5 - 1))},
        answer=_find_bracket,
        why=_(
            "At ε = {low} the machine is faster, with Ω²m/k = {fast:4}. At ε = {high} it is slower, with Ω²m/k = "
            "{slow:4}. The frequency falls steadily as the rollers become heavier, so the two are in step exactly "
            "once. Halve the interval, and you come closer with every step. The next ratio to try is {middle}, where "
            "Ω²m/k = {value:4}."
        ),
        answer_numbers=lambda: _bracket_numbers(_find_bracket()),
        hints=(
            _("At equal masses it takes {periods} periods of the plain mass until the hands are one full turn apart."),
            _("How much heavier must the rollers be to slow the machine down by so little?"),
        ),
        purpose=_("Bisection finds a number without a formula."),
        expect=_(
            "Press “Run the machine”, then let students call out values of m′. Set them with the slider at the desk: "
            "machine and hands on the wall follow."
        ),
        sliders=_("Set m′ so that both hands stay together."),
        is_in_short_lesson=True,
        minutes=3,
        shows_dials=True,
        onward=Onward(_("Find it with the slider on the page Oscillator")),
    ),
    Stop(
        id="exactly",
        heading=_("In step, exactly"),
        question=_(
            "Block, slab and top cylinder have a mass of {machine.m:1 kg} each. Ω²\u00a0=\u00a0k/m leads to a "
            "quadratic equation for the mass ratio ε\u00a0=\u00a0m′/m: {quadratic}. Which mass of each lower roller "
            "keeps the machine in step for ever?"
        ),
        options=dict(
            eighths=_("Exactly {eighths_mass}."),
            decimal=_("Exactly {decimal_mass}."),
            irrational=_("A mass that no fraction gives exactly."),
            several=_("Every mass from {lightest} to {heaviest}."),
        ),
        replies={
            "eighths": _(
                "In the equation this ratio leaves {eighths:3} instead of 0. After {eighths_periods:3} periods of the "
                "plain mass the hands are one full turn apart. Must the rollers be lighter or heavier?"
            ),
            "decimal": _(
                "In the equation this ratio leaves {decimal:3} instead of 0. After {decimal_periods:3} periods of the "
                "plain mass the hands are one full turn apart. Are more decimals enough?"
            ),
            "several": _(
                "At the lower end Ω²m/k is {fast:5}, at the upper end {slow:5}. At how many masses between them is it "
                "exactly 1?"
            ),
        },
        question_numbers={
            **_QUADRATIC_SLOTS,
            "eighths_mass": with_unit(unbroken(str(CANDIDATES["eighths"])), "kg"),
            "decimal_mass": quantity(float(CANDIDATES["decimal"]), "kg", 4),
            "lightest": quantity(float(RANGE[0]), "kg", 3),
            "heaviest": quantity(float(RANGE[1]), "kg", 3),
            "root": _ROOT,
            "number": _NUMBER,
        },
        answer=_find_exact_candidate,
        why=_(
            "The positive root of {quadratic} is {root}. So each lower roller must have a mass of about {value:7 kg}, "
            "{heavier:3 %} more than the other bodies. As {number} lies between {below}² and {above}², its root is no "
            "fraction, and neither is this mass. A mass ratio cannot be negative, so the other root does not count."
        ),
        answer_numbers=_candidate_numbers,
        hints=(
            _("The roots of a·ε² + b·ε + c = 0 are (−b ± √(b² − 4ac))/(2a)."),
            _("Is the number under the root the square of a whole number?"),
        ),
        purpose=_("The search becomes a quadratic equation, and its root is irrational."),
        expect=_("Many trust the decimal number. Let students put their mass into the equation."),
        minutes=3,
        changed_machine=IN_STEP,
        shows_dials=True,
        onward=Onward(_("See the solution on the page 1729"), "taxicab"),
    ),
    Stop(
        id="1729",
        heading=_("Why 1729?"),
        question=_(
            "Ω²\u00a0=\u00a0k/m leads to a quadratic equation for the mass ratio ε\u00a0=\u00a0m′/m: {quadratic}. Its "
            "positive root is {root}. The number under the root is {number}\u00a0=\u00a0{first}\u00a0=\u00a0{second}. "
            "Which of these two sums can you read off the coefficients as b² plus −4ac?"
        ),
        options=dict(second="{second}", both=_("Both"), neither=_("Neither"), first="{first}"),
        replies={
            "second": _("Its terms are {terms[0]} and {terms[1]}, but b² is {square}. How large is −4ac?"),
            "both": _("b² is {square} and −4ac is {product}. Which two cubes are these, and which are left over?"),
            "neither": _("b² is {square} and −4ac is {product}. Is one of these numbers a cube?"),
        },
        answer=_find_sum_of_cubes,
        why=_(
            "Under the root is b² − 4ac = {b}² + 4·{a}·{c}. Here {b}² = {pairs[0][0]}³ and 4·{a}·{c} = {pairs[0][1]}³. "
            "The other sum, {second}, does not appear in the coefficients. There is a reason for {number} = {norm[0]}² "
            "+ 3·{norm[1]}²: this form follows from the moments of inertia. No reason is known why it is also the "
            "smallest sum of two positive cubes in two ways."
        ),
        question_numbers={
            **_QUADRATIC_SLOTS,
            "root": _ROOT,
            "number": _NUMBER,
            "first": unbroken("{}³ + {}³".format(*_SUMS[0])),
            "second": unbroken("{}³ + {}³".format(*_SUMS[1])),
            "pairs": _SUMS,
            "terms": [x**3 for x in _SUMS[1]],
            "norm": (41, 4),
            "square": B * B,
            "product": -4 * A * C,
        },
        hints=(_("Work out b² and −4ac separately."),),
        purpose=_("Students separate what follows from the coefficients from what is a coincidence."),
        expect=_("Many expect a deep reason for both sums. Say clearly that none is known."),
        is_in_short_lesson=True,
        minutes=3,
        runs=(Run(IN_STEP),),
        hides=FREQUENCY,
        exhibit=_display_equations(*_EQUATIONS),
        outcome=_display_equations(*_EQUATIONS, f"b^2-4ac={B * B}+{-4 * A * C}"),
        onward=Onward(_("Count the cubes on the page 1729"), "taxicab"),
    ),
    Stop(
        id="other-body",
        heading=_("Another body, another number?"),
        question=_(
            "The top cylinder is replaced by a solid sphere of the same mass and radius. The spring does not touch it, "
            "and it rolls freely. Which number is now under the root of the exact mass ratio?"
        ),
        options=dict(
            same=_("The same number, 1729."),
            another=_("Another number, not a square."),
            square=_("Another number, a square."),
        ),
        replies={
            "same": _(
                "Then the top body would not matter. But the block moves below it, and friction turns it. Which "
                "property of the body counts when it has to turn?"
            ),
            "square": _(
                "Then the exact mass ratio would be a fraction. The equation is now {quadratic}. Which fraction solves "
                "it?"
            ),
        },
        answer=_compare_other_body,
        why=_(
            "With a solid sphere on top the number under the root is {number}. The machine is then in step at ε = "
            "{ratio:4}. The top body is not idle: friction makes it turn, and its moment of inertia counts. Of all "
            "{machines} choices of bodies, only {cubes} lead to a sum of two positive cubes."
        ),
        answer_numbers=_other_body_numbers,
        hints=(_("What turns the top body when the block moves under it?"),),
        purpose=_("The number is fragile: with one other body, it is gone."),
        expect=_("Many believe that a body that rolls freely cannot matter."),
        minutes=3,
        runs=(Run(IN_STEP, bodies=OTHER.bodies),),
        shows_dials=True,
        onward=Onward(_("Choose the bodies on the page 1729"), "taxicab", {"top": OTHER.top}),
    ),
)
