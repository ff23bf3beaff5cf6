"""A worksheet for one machine: stops of the lesson, a guided derivation, calculations with this machine, and the key.

The same machine and seed select the same questions, so a key printed later fits the worksheet. SymPy computes all
answers, those of the calculations exactly.
"""

import math
import random
import string
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import epsilon, k, m, m_prime
from ramanujan.derivation.numbers import Numbers, format_as_typed, format_with_decimal, unit_frequency_condition
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Step
from ramanujan.lesson import CHAPTERS, Stop
from ramanujan.number_theory import BodyChoice
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import in_latex, number, quantity
from ramanujan.text.translation import _

_TARGETS = tuple(Fraction(p, q) for p, q in ((1, 2), (2, 3), (3, 4), (4, 5), (9, 8), (5, 4), (4, 3), (3, 2)))
_STOPS = 4
_OMITTED = ("block", "huge-ratio")
"""Stops without a question on paper. The derivation reveals the sign of X, and an overflow is not physics."""
_STEPS = ("velocities", "inertia", "energies", "lagrangian", "motion", "elimination", "insertion", "frequency")
"""The steps of the route of Euler and Lagrange that become questions."""
_ADDITIONS = {"energies": _("Give $U$ as a function of the compression $x$ first, then of $\\varphi$.")}
"""Step → a sentence about the coordinates of its formulas, for ambiguous steps."""
_LONG = 150
"""A formula from this number of LaTeX characters may be too wide for paper."""
_LINE = 90
"""The number of LaTeX characters that fill one handwritten line."""


@dataclass(frozen=True)
class WorksheetQuestion:
    """One question, as Markdown.

    Parameters
    ----------
    text, answer : the question, and its answer in the key
    blanks : formulas to complete; the answer contains the complete formulas
    options : the options of a multiple choice, with letters
    working : the lines of the calculation
    space : the number of lines for writing, the same in every language and for every machine
    """

    text: str
    answer: str
    blanks: str = ""
    options: tuple[str, ...] = ()
    working: tuple[str, ...] = ()
    space: int = 2

    @property
    def points(self) -> int:
        """The points for a right answer: one for every two lines."""
        return self.space // 2


def make_questions(machine: Oscillator, seed: str, level: int = 1) -> tuple[WorksheetQuestion, ...]:
    """Return the questions of a worksheet.

    Parameters
    ----------
    machine : the machine of the calculations
    seed : any text; it selects the stops, the order of their options, and the target frequency
    level : how much of the derivation is left to complete: 1, one equation in each step; 2, all equations of a step;
        3, all equations of a step, without the reason as a hint

    >>> sheet = make_questions(Oscillator(), "1")
    >>> sheet == make_questions(Oscillator(), "1")
    True
    """
    source = random.Random(seed)
    chapters = [[stop for stop in chapter if stop.id not in _OMITTED] for chapter in CHAPTERS]
    # Stops of one chapter answer each other, so each selected chapter contributes one.
    selected = sorted(source.sample(range(len(chapters)), _STOPS))
    stops = [source.choice(chapters[i]) for i in selected]
    predictions = [_make_prediction(stop, source) for stop in stops]
    return (*predictions, *make_derivation(level), *_make_calculations(machine, source.choice(_TARGETS)))


def make_derivation(level: int) -> tuple[WorksheetQuestion, ...]:
    """Return the steps to Ω² by Lagrange’s equations as questions, with blanks for this level."""
    return tuple(_guided_step(step, level) for step in ROUTES["euler_lagrange"].steps if step.key in _STEPS)


def _guided_step(step: Step, level: int) -> WorksheetQuestion:
    """Return a step of the derivation as a question, with blanks for the equations to complete.

    `level` is that of `make_questions`: 1 leaves the last equation to complete, 2 leaves all, and 3 also omits the
    reason and the left sides.
    """
    equations = [latex(equation) for equation in step.equations]
    blanks = ["\\ldots=0" if equation.rhs == 0 else f"{latex(equation.lhs)}=\\ldots" for equation in step.equations]
    if level == 1:
        given, to_complete = equations[:-1], blanks[-1:]
    elif level == 2:
        given, to_complete = [], [blank.replace("\\ldots", "\\ldots\\hspace{4cm}") for blank in blanks]
    else:
        given, to_complete = [], []
    sentences = [f"**{step.heading}.**", "" if level == 3 else step.reason, _ADDITIONS.get(step.key, "")]
    return WorksheetQuestion(
        " ".join(filter(None, sentences)),
        set_in_a_row(equations),
        blanks="\n\n".join(filter(None, (set_in_a_row(given), set_in_a_row(to_complete)))),
        space=_count_lines(equations[-1:] if level == 1 else equations),
    )


def _count_lines(formulas: Sequence[str]) -> int:
    """Return the number of handwritten lines for these formulas, plus one for notes."""
    return 1 + math.ceil(sum(map(len, formulas)) / _LINE)


def set_in_a_row(formulas: Sequence[str]) -> str:
    """Return formulas as Markdown, several on a line if they fit. Braces prevent a break inside a short formula."""
    unbroken = [f"{{{formula}}}" if len(formula) < _LONG else formula for formula in formulas]
    return "\u2003 ".join(f"$$\\displaystyle {formula}$$" for formula in unbroken)


def _make_prediction(stop: Stop, source: random.Random) -> WorksheetQuestion:
    """Return a stop as a question with its options in random order."""
    shuffled = source.sample(list(stop.options), len(stop.options))
    letters = dict(zip(shuffled, string.ascii_uppercase, strict=False))
    return WorksheetQuestion(
        stop.question,
        f"**{letters[stop.right]}.** {stop.options[stop.right]}\\\n{stop.explanation()}",
        options=tuple(f"{letters[option]}. {stop.options[option]}" for option in shuffled),
    )


def _make_calculations(machine: Oscillator, target: Fraction) -> tuple[WorksheetQuestion, ...]:
    """Return the questions about this machine, with exact answers.

    `space` also sets the points for a right answer, so each question has a fixed `space`, the same for every machine.
    """
    values = Numbers.of(machine).exact
    ratio = sp.radsimp(values[m_prime] / values[m])
    formula = unit_frequency_condition().normalized_frequency_squared
    numerator, denominator = (sp.expand(part.subs(epsilon, ratio)) for part in sp.fraction(formula))
    normalized = sp.radsimp(numerator / denominator)
    typed = {symbol: format_as_typed(value) for symbol, value in values.items()}
    squared = sp.radsimp(normalized * values[k] / values[m])
    effective_mass = sp.radsimp(values[k] / squared)
    return (
        WorksheetQuestion(
            _("Calculate the mass ratio $\\varepsilon=m'/m$ and the normalized frequency squared $\\Omega^2m/k$."),
            f"$\\varepsilon={latex(ratio)}$, $\\Omega^2m/k={format_with_decimal(normalized)}$",
            working=(
                f"\\varepsilon=\\frac{{m'}}{{m}}=\\frac{{{typed[m_prime]}}}{{{typed[m]}}}={latex(ratio)}",
                f"\\frac{{\\Omega^2m}}{{k}}={latex(formula)}=\\frac{{{latex(numerator)}}}{{{latex(denominator)}}}",
            ),
            space=5,
        ),
        WorksheetQuestion(
            _("Calculate $\\Omega^2$ and the period."),
            _("$\\Omega^2={squared}\\,\\mathrm{{s^{{-2}}}}$, so the period is {period}.").format(
                squared=latex(squared), period=quantity(machine.period, "s", 4)
            ),
            working=(
                f"\\frac{{\\Omega^2m}}{{k}}\\cdot\\frac{{k}}{{m}}={latex(normalized)}\\cdot"
                f"\\frac{{{typed[k]}}}{{{typed[m]}}}\\,\\mathrm{{s^{{-2}}}}",
                f"T=\\frac{{2\\pi}}{{\\Omega}}=\\frac{{2\\pi}}{{{in_latex(f'{float(sp.sqrt(squared)):.5g}')}}}\\,\\mathrm{{s}}",
            ),
            space=4,
        ),
        WorksheetQuestion(
            _("Which mass does the spring feel? Compare it with the mass of all five bodies together."),
            _("$M_x=k/\\Omega^2={felt}\\,\\mathrm{{kg}}$; all five bodies together have a mass of {total}.").format(
                felt=latex(effective_mass), total=quantity(3 * machine.m + 2 * machine.m_prime, "kg", 4)
            ),
            working=(
                f"M_x=\\frac{{k}}{{\\Omega^2}}=\\frac{{{typed[k]}}}{{{latex(squared)}}}\\;\\mathrm{{kg}}",
                f"3m+2m'=3\\cdot{typed[m]}+2\\cdot{typed[m_prime]}\\;\\mathrm{{kg}}",
            ),
            space=4,
        ),
        WorksheetQuestion(
            _(
                "Is the machine faster or slower than the plain mass? After how many periods do they differ by one "
                "full oscillation?"
            ),
            _answer_faster_or_slower(normalized),
            working=(f"\\frac{{\\Omega}}{{\\sqrt{{k/m}}}}=\\sqrt{{{latex(normalized)}}}",),
            space=4,
        ),
        _make_target_question(target),
    )


def _make_target_question(target: Fraction) -> WorksheetQuestion:
    """Return the question about the mass ratio at which Ω²m/k has a target value."""
    formula = unit_frequency_condition().normalized_frequency_squared
    a, b, c = BodyChoice(target=target).quadratic
    discriminant = b * b - 4 * a * c
    root = (sp.sqrt(discriminant) - b) / (2 * a)
    return WorksheetQuestion(
        _("For which mass ratio is $\\Omega^2m/k={target}$? Give it exactly.").format(target=target),
        _("${quadratic}=0$, so $\\varepsilon={root}$.").format(
            quadratic=latex(a * epsilon**2 + b * epsilon + c), root=format_with_decimal(root)
        ),
        working=(
            f"{latex(formula)}={latex(sp.Rational(target))}",
            f"b^2-4ac=({latex(b)})^2-4\\cdot{latex(a)}\\cdot({latex(c)})={latex(discriminant)}",
        ),
        space=4,
    )


def _answer_faster_or_slower(normalized: sp.Expr) -> str:
    """Return the answer to the question which of the two is faster, and when they differ by one full oscillation."""
    if normalized == 1:
        return _("Neither: the two are in step for ever.")
    # Subtract before rounding: close to the mass ratio in step, the float of Ω√(m/k) is exactly 1.
    gained = float(sp.N(sp.sqrt(normalized) - 1, 20))
    if gained > 0:
        sentence = _(
            "Faster: $\\Omega>\\sqrt{{k/m}}$. They differ by one full oscillation after {periods} periods of the plain "
            "mass."
        )
    else:
        sentence = _(
            "Slower: $\\Omega<\\sqrt{{k/m}}$. They differ by one full oscillation after {periods} periods of the plain "
            "mass."
        )
    return sentence.format(periods=number(1 / abs(gained), 3))
