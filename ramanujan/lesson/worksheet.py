"""A worksheet for one machine: some stops of the lesson and calculations with this machine, and the key to them.

The seed chooses: the same machine and seed give the same sheet, so that a key fits the questions that were handed out.
All answers are worked out, the calculations exactly, by SymPy.
"""

from __future__ import annotations

import random
import string
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from ramanujan.derivation.numbers import exact_values, unit_frequency_condition, with_decimal
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import epsilon, k, m, m_prime
from ramanujan.lesson import STOPS, Stop
from ramanujan.number_theory import BodyChoice
from ramanujan.numerals import number, quantity
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

_TARGETS = tuple(Fraction(p, q) for p, q in ((1, 2), (2, 3), (3, 4), (4, 5), (9, 8), (5, 4), (4, 3), (3, 2)))
_STOPS = 4
SPACE = 3.0
"""Room to write an answer to a calculation [cm]."""


@dataclass(frozen=True)
class Question:
    """One question, as Markdown: its text, its options with letters, its answer; and the room to write [cm]."""

    text: str
    answer: str
    options: tuple[str, ...] = ()
    space: float = SPACE


def questions(machine: Oscillator, seed: str) -> tuple[Question, ...]:
    """Return the questions of a worksheet.

    Parameters
    ----------
    machine : the machine of the calculations
    seed : any text; it chooses the stops, the order of their options, and the frequency that is asked for

    >>> sheet = questions(Oscillator(), "1")
    >>> sheet == questions(Oscillator(), "1")
    True
    """
    draw = random.Random(seed)
    chosen = sorted(draw.sample(range(len(STOPS)), _STOPS))
    return (*(_predicted(STOPS[i], draw) for i in chosen), *_calculations(machine, draw.choice(_TARGETS)))


def _predicted(stop: Stop, draw: random.Random) -> Question:
    """Return a stop as a question with options in a drawn order."""
    shown = draw.sample(stop.options, len(stop.options))
    letters = dict(zip((option.id for option in shown), string.ascii_uppercase, strict=False))
    right = stop.answer()
    label = stop.option(right).label
    return Question(
        stop.question,
        f"**{letters[right]}.** {label}\\\n{stop.explanation()}",
        tuple(f"{letters[option.id]}. {option.label}" for option in shown),
        space=1.6,
    )


def _calculations(machine: Oscillator, target: Fraction) -> tuple[Question, ...]:
    """Return the questions about this machine, with exact answers."""
    values = exact_values(machine.m, machine.m_prime, machine.k)
    ratio = sp.radsimp(values[m_prime] / values[m])
    normalized = sp.radsimp(unit_frequency_condition().normalized_frequency_squared.subs(epsilon, ratio))
    squared = sp.radsimp(normalized * values[k] / values[m])
    felt = sp.radsimp(values[k] / squared)
    a, b, c = BodyChoice(target=target).quadratic
    root = (sp.sqrt(b * b - 4 * a * c) - b) / (2 * a)
    return (
        Question(
            _("Calculate the mass ratio $\\varepsilon=m'/m$ and the normalized frequency squared $\\Omega^2m/k$."),
            f"$\\varepsilon={latex(ratio)}$, $\\Omega^2m/k={with_decimal(normalized)}$",
        ),
        Question(
            _("Calculate $\\Omega^2$ and the period."),
            _("$\\Omega^2={squared}\\,\\mathrm{{s^{{-2}}}}$, so the period is {period}.").format(
                squared=latex(squared), period=quantity(machine.period, "s", 4)
            ),
        ),
        Question(
            _("Which mass does the spring feel? Compare it with the mass of all five bodies together."),
            _("$M_x=k/\\Omega^2={felt}\\,\\mathrm{{kg}}$; all five bodies together have a mass of {total}.").format(
                felt=latex(felt), total=quantity(3 * machine.m + 2 * machine.m_prime, "kg", 4)
            ),
        ),
        Question(
            _("Is the machine faster or slower than the plain mass? After how many periods are they one turn apart?"),
            _parting(normalized),
        ),
        Question(
            _("For which mass ratio is $\\Omega^2m/k={target}$? Give it exactly.").format(target=target),
            _("${quadratic}=0$, so $\\varepsilon={root}$.").format(
                quadratic=latex(a * epsilon**2 + b * epsilon + c), root=with_decimal(root)
            ),
            space=4.0,
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
