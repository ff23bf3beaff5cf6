"""A worksheet for one machine: stops of the lesson, a guided derivation, calculations with this machine, and the key.

The seed chooses: the same machine and seed give the same questions, so that a key fits those that were handed out.
All answers are worked out, the calculations exactly, by SymPy.
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
from ramanujan.derivation.numbers import Numbers, as_typed, unit_frequency_condition, with_decimal
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Step
from ramanujan.lesson import CHAPTERS, Stop
from ramanujan.number_theory import BodyChoice
from ramanujan.numerals import in_latex, number, quantity
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

_TARGETS = tuple(Fraction(p, q) for p, q in ((1, 2), (2, 3), (3, 4), (4, 5), (9, 8), (5, 4), (4, 3), (3, 2)))
_STOPS = 4
_NAMED = ("block",)
"""Stops whose answer the derivation names: on which side X is positive."""
_STEPS = ("velocities", "inertia", "energies", "lagrangian", "motion", "elimination", "insertion", "frequency")
"""The steps of the route of Euler and Lagrange in which there is something to find."""
_WHERE = {"energies": _("Give $U$ as a function of the compression $x$ first, then of $\\varphi$.")}
"""Step → in which coordinates its formulas are wanted, where that is not plain."""
_LONG = 150
"""A formula with so many letters of LaTeX may be too wide for paper."""
_LINE = 90
"""The number of LaTeX characters that fill one handwritten line."""


@dataclass(frozen=True)
class Question:
    """One question, as Markdown.

    Parameters
    ----------
    text, answer : the question, and its answer in the key
    blanks : formulas to complete; the answer contains the whole formulas
    options : the options of a multiple choice, with letters
    working : the lines of a calculation that lead to the answer
    space : the number of lines to write on, the same in every language and for every machine
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


def questions(machine: Oscillator, seed: str, level: int = 1) -> tuple[Question, ...]:
    """Return the questions of a worksheet.

    Parameters
    ----------
    machine : the machine of the calculations
    seed : any text; it chooses the stops, the order of their options, and the frequency that is asked for
    level : of the derivation: 1, a blank in each step; 2, every equation is to be completed; 3, a blank page

    >>> sheet = questions(Oscillator(), "1")
    >>> sheet == questions(Oscillator(), "1")
    True
    """
    draw = random.Random(seed)
    # Stops of one chapter would answer each other.
    kept = [[stop for stop in chapter if stop.id not in _NAMED] for chapter in CHAPTERS]
    chosen = [draw.choice(kept[i]) for i in sorted(draw.sample(range(len(kept)), _STOPS))]
    asked = [_predicted(stop, draw) for stop in chosen]
    return (*asked, *derivation(level), *_calculations(machine, draw.choice(_TARGETS)))


def derivation(level: int) -> tuple[Question, ...]:
    """Return the steps to Ω² by Lagrange’s equations as questions, with blanks for this level."""
    return tuple(_guided(step, level) for step in ROUTES["euler_lagrange"].steps if step.key in _STEPS)


def _guided(step: Step, level: int) -> Question:
    """Return a step as a question: what is to be found is left blank."""
    whole = [latex(equation) for equation in step.equations]
    blanks = ["\\ldots=0" if equation.rhs == 0 else f"{latex(equation.lhs)}=\\ldots" for equation in step.equations]
    wide = [blank.replace("\\ldots", "\\ldots\\hspace{4cm}") for blank in blanks]
    given, asked = {1: (whole[:-1], blanks[-1:]), 2: ([], wide), 3: ([], [])}[level]
    said = ("" if level == 3 else step.reason, _WHERE.get(step.key, ""))
    return Question(
        " ".join(filter(None, (f"**{step.heading}.**", *said))),
        in_a_row(whole),
        blanks="\n\n".join(filter(None, (in_a_row(given), in_a_row(asked)))),
        space=_lines(whole[-1:] if level == 1 else whole),
    )


def _lines(formulas: Sequence[str]) -> int:
    """Return the number of handwritten lines for these formulas, and one line to think."""
    return 1 + math.ceil(sum(map(len, formulas)) / _LINE)


def in_a_row(formulas: Sequence[str]) -> str:
    """Return formulas as Markdown, as many in a line as fit; in braces a formula is not broken, unless it is long."""
    whole = (f"{{{formula}}}" if len(formula) < _LONG else formula for formula in formulas)
    return "\u2003 ".join(f"$$\\displaystyle {formula}$$" for formula in whole)


def _predicted(stop: Stop, draw: random.Random) -> Question:
    """Return a stop as a question with options in a drawn order."""
    shown = draw.sample(list(stop.options), len(stop.options))
    letters = dict(zip(shown, string.ascii_uppercase, strict=False))
    return Question(
        stop.question,
        f"**{letters[stop.right]}.** {stop.options[stop.right]}\\\n{stop.explanation()}",
        options=tuple(f"{letters[option]}. {stop.options[option]}" for option in shown),
    )


def _calculations(machine: Oscillator, target: Fraction) -> tuple[Question, ...]:
    """Return the questions about this machine, with exact answers.

    The number of lines is fixed for each question: with longer numbers or words it earns no more points.
    """
    values = Numbers.of(machine).exact
    ratio = sp.radsimp(values[m_prime] / values[m])
    formula = unit_frequency_condition().normalized_frequency_squared
    above, below = (sp.expand(part.subs(epsilon, ratio)) for part in sp.fraction(formula))
    normalized = sp.radsimp(above / below)
    typed = {symbol: as_typed(value) for symbol, value in values.items()}
    squared = sp.radsimp(normalized * values[k] / values[m])
    felt = sp.radsimp(values[k] / squared)
    a, b, c = BodyChoice(target=target).quadratic
    root = (sp.sqrt(b * b - 4 * a * c) - b) / (2 * a)
    return (
        Question(
            _("Calculate the mass ratio $\\varepsilon=m'/m$ and the normalized frequency squared $\\Omega^2m/k$."),
            f"$\\varepsilon={latex(ratio)}$, $\\Omega^2m/k={with_decimal(normalized)}$",
            working=(
                f"\\varepsilon=\\frac{{m'}}{{m}}=\\frac{{{typed[m_prime]}}}{{{typed[m]}}}={latex(ratio)}",
                f"\\frac{{\\Omega^2m}}{{k}}={latex(formula)}=\\frac{{{latex(above)}}}{{{latex(below)}}}",
            ),
            space=5,
        ),
        Question(
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
        Question(
            _("Which mass does the spring feel? Compare it with the mass of all five bodies together."),
            _("$M_x=k/\\Omega^2={felt}\\,\\mathrm{{kg}}$; all five bodies together have a mass of {total}.").format(
                felt=latex(felt), total=quantity(3 * machine.m + 2 * machine.m_prime, "kg", 4)
            ),
            working=(
                f"M_x=\\frac{{k}}{{\\Omega^2}}=\\frac{{{typed[k]}}}{{{latex(squared)}}}\\;\\mathrm{{kg}}",
                f"3m+2m'=3\\cdot{typed[m]}+2\\cdot{typed[m_prime]}\\;\\mathrm{{kg}}",
            ),
            space=4,
        ),
        Question(
            _("Is the machine faster or slower than the plain mass? After how many periods are they one turn apart?"),
            _parting(normalized),
            working=(f"\\frac{{\\Omega}}{{\\sqrt{{k/m}}}}=\\sqrt{{{latex(normalized)}}}",),
            space=4,
        ),
        Question(
            _("For which mass ratio is $\\Omega^2m/k={target}$? Give it exactly.").format(target=target),
            _("${quadratic}=0$, so $\\varepsilon={root}$.").format(
                quadratic=latex(a * epsilon**2 + b * epsilon + c), root=with_decimal(root)
            ),
            working=(
                f"{latex(formula)}={latex(sp.Rational(target))}",
                f"b^2-4ac=({latex(b)})^2-4\\cdot{latex(a)}\\cdot({latex(c)})={latex(b * b - 4 * a * c)}",
            ),
            space=4,
        ),
    )


def _parting(normalized: sp.Expr) -> str:
    if normalized == 1:
        return _("Neither: the two are in step for ever.")
    # Exactly at first: close to ε* the float of Ω√(m/k) is 1.
    gained = float(sp.N(sp.sqrt(normalized) - 1, 20))
    sentence = (
        _("Faster: $\\Omega>\\sqrt{{k/m}}$. They are one full turn apart after {periods} periods of the plain mass.")
        if gained > 0
        else _(
            "Slower: $\\Omega<\\sqrt{{k/m}}$. They are one full turn apart after {periods} periods of the plain mass."
        )
    )
    return sentence.format(periods=number(1 / abs(gained), 3))
