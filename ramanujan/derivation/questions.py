"""The questions: prompt, right answer, the results of typical mistakes, and the next question after a wrong answer.

The right answers come from the bodies and their elimination, the wrong ones from the same derivation with one mistake
(`wrong_answers`). A new question is one entry of `_ASKED`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial

import sympy as sp

from ramanujan.derivation import decimals, mistakes
from ramanujan.derivation.elimination import (
    Phi_ddot,
    X_ddot,
    phi_ddot,
)
from ramanujan.derivation.expansion import NormalForm
from ramanujan.derivation.expressions import NAMES, Expression, length, names, spelled
from ramanujan.derivation.normal_form import expression_of, normal_form
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import R, epsilon, machine, phi
from ramanujan.derivation.wrong_answers import (
    Variants,
    elimination,
    elimination_mistakes,
    energy_mistakes,
    equation_mistakes,
    frequency_mistakes,
    ratio_mistakes,
    spring_mistakes,
    unit,
)
from ramanujan.translation import _

POLYNOMIAL, QUOTIENT, NUMBER = "polynomial", "quotient", "number"
"""How an answer is compared: term by term, as one fraction, or as a number."""

MOTION = ("X", "X'", "phi", "phi'", "Phi", "Phi'")


@dataclass(frozen=True)
class Question:
    """A question.

    Parameters
    ----------
    name : the name in `QUESTIONS`
    quantity : the quantity asked for, in a few words of plain text
    prompt : one or two sentences, Markdown with $…$
    names : the names that the answer may contain, as typed
    example : a formula that shows how to type; it is not the answer
    """

    name: str
    quantity: str
    prompt: str
    names: tuple[str, ...]
    example: str


@dataclass(frozen=True)
class _Asked:
    """A question before its answer is derived.

    `mistakes` takes the answer and the quantity asked for; `hints` maps a product of velocities, as shown, to the next
    question.
    """

    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    mistakes: Callable[[sp.Expr, str], Variants]
    example: str
    kind: str
    leads_on: str
    hints: Mapping[str, str]


def question(name: str) -> Question:
    """Return the question of that name.

    Raises
    ------
    ValueError : name is not one of `QUESTIONS`.
    """
    if not isinstance(name, str) or name not in _ASKED:
        raise ValueError(_("name must be one of {known}").format(known=", ".join(QUESTIONS)))
    asked = _ASKED[name]
    return Question(name, asked.quantity, asked.prompt(), allowed_names(name), asked.example)


def kind(question: str) -> str:
    """Return how the answers to a question are compared."""
    return _ASKED[question].kind


def variables(question: str) -> tuple[str, ...]:
    """Return the names in whose products an answer is written term by term: an energy in the motion, others in all."""
    return MOTION if question in _ENERGIES else NAMES


def quantity(question: str) -> str:
    """Return the name of the quantity asked for, as a sentence uses it."""
    return _ASKED[question].quantity


def leads_on(question: str, term: str | None = None) -> str:
    """Return the question that a lecturer would ask next about a term, or about the whole answer."""
    asked = _ASKED[question]
    return asked.hints.get(term or "", asked.leads_on)


@cache
def answer(question: str) -> Expression:
    """Return the right answer as a tree."""
    return spelled(_ASKED[question].answer())


@cache
def right_form(question: str) -> NormalForm:
    """Return the normal form of the right answer."""
    return normal_form(answer(question))


@cache
def wrong_forms(question: str) -> dict[NormalForm, str]:
    """Return result → hint of the typical mistakes; if two lead to the same result, the more common one counts."""
    found: dict[NormalForm, str] = {}
    for hint, result in _wrong_results(question):
        form = NormalForm.of(result) if isinstance(result, sp.Expr) else result
        if form is not None and form != right_form(question) and not form.is_zero:
            found.setdefault(form, hint)
    return found


@cache
def wrong_values(question: str) -> tuple[tuple[decimals.Values, str], ...]:
    """Return the values of the results of typical mistakes, and the hints."""
    return tuple((decimals.values(expression_of(form)), hint) for form, hint in wrong_forms(question).items())


@cache
def longest_form(question: str) -> int:
    """Return the length of the longest form that counts as simplified."""
    answer = _ASKED[question].answer()
    numerator, denominator = sp.fraction(sp.together(answer))
    forms = (answer, sp.factor(answer), sp.expand(answer, frac=True), sp.expand(numerator) / denominator)
    return max(length(spelled(form)) for form in forms)


@cache
def allowed_names(question: str) -> tuple[str, ...]:
    """Return the names in the answer; ε may stand for m′/m where both masses do."""
    present = names(answer(question))
    allowed = present | {"eps"} if question in _COUPLED else present
    return tuple(name for name in NAMES if name in allowed)


def _wrong_results(question: str) -> Variants:
    right = _ASKED[question].answer()
    yield from _ASKED[question].mistakes(right, quantity(question))
    if right.has(R):
        yield _("You get this result if you leave out R. Which length belongs to an angle?"), right.subs(R, 1)


# The questions


def _body_question(body: str) -> _Asked:
    called = mistakes.CALLED[body]
    rate = {"block": "", "top": "Φ′"}.get(body, "φ′")
    hints = {
        "X′²": _("What is the kinetic energy of {body} while only the block moves, with {rate} = 0?"),
        f"X′{rate}": _("What is the mixed term when you square the velocity of {body}?"),
        f"{rate}²": _("What is the kinetic energy of {body} while the block is at rest, with X′ = 0?"),
    }
    leads_on = (
        _("How fast does {body} move relative to the ground, and how fast does it rotate?")
        if machine()[body].angle != 0
        else _("How fast does {body} move relative to the ground?")
    )
    return _Asked(
        _("the kinetic energy of {body}").format(body=called),
        lambda: machine()[body].kinetic_energy,
        lambda: _("What is the kinetic energy of {body} relative to the ground?").format(body=called),
        partial(energy_mistakes, body),
        "3/5 m' (X' + 3 R phi')^2",
        POLYNOMIAL,
        leads_on.format(body=called),
        {term: hint.format(body=called, rate=rate) for term, hint in hints.items()} if rate else {},
    )


def _coupling_question(name: str, quantity: str, acceleration: sp.Expr, solved: str) -> _Asked:
    return _Asked(
        quantity,
        lambda: getattr(elimination(), solved).coeff(phi_ddot),
        lambda: _("The equations of motion of $X$ and $\\Phi$ give {relation}. What is $c$?").format(
            relation=f"${latex(acceleration)}=c\\,{latex(phi_ddot)}$"
        ),
        partial(elimination_mistakes, name),
        "R (2m + m')/(5m)" if solved == "X_from_phi" else "(2m + m')/(5m)",
        QUOTIENT,
        _("What do the equations of motion of X and Φ say about the three accelerations?"),
        {},
    )


def _equation_prompt() -> str:
    equation = elimination().motion[phi]
    written = equation - equation.coeff(phi_ddot) * phi_ddot + sp.Symbol("a") * phi_ddot
    prompt = _("The equation of motion of {coordinate} is {equation}. What is $a$?")
    return prompt.format(coordinate=f"${latex(phi)}$", equation=f"${latex(written)}=0$")


_ENERGIES = (*(f"kinetic_energy_{body}" for body in mistakes.CALLED), "potential_energy")
_COUPLED = ("phi_equation", "block_coupling", "top_coupling", "natural_frequency_squared")

_ASKED: dict[str, _Asked] = {
    **{f"kinetic_energy_{body}": _body_question(body) for body in mistakes.CALLED},
    "potential_energy": _Asked(
        _("the potential energy"),
        lambda: machine().potential_energy,
        lambda: _("What is the potential energy of the spring when the lower rollers have turned by {angle}?").format(
            angle=f"${latex(phi)}$"
        ),
        spring_mistakes,
        "k (R phi)^2 / 5",
        POLYNOMIAL,
        _("How far is the spring compressed when the lower rollers have turned by φ?"),
        {},
    ),
    "phi_equation": _Asked(
        _("the factor of the acceleration"),
        lambda: elimination().motion[phi].coeff(phi_ddot),
        _equation_prompt,
        equation_mistakes,
        "R (2m + m')/5",
        POLYNOMIAL,
        _("Which kinetic energies contain φ′², and with which factors?"),
        {},
    ),
    "block_coupling": _coupling_question(
        "block_coupling", _("the factor in the block’s acceleration"), X_ddot, "X_from_phi"
    ),
    "top_coupling": _coupling_question(
        "top_coupling", _("the factor in the top cylinder’s acceleration"), Phi_ddot, "Phi_from_phi"
    ),
    "natural_frequency_squared": _Asked(
        "Ω²",
        lambda: elimination().natural_frequency_squared,
        lambda: _("What is $\\Omega^2$, the square of the natural frequency?"),
        frequency_mistakes,
        "2k/(3m + m')",
        QUOTIENT,
        _("What is left of the equation of motion of φ when you insert the other two accelerations?"),
        {},
    ),
    "unit_mass_ratio": _Asked(
        _("the mass ratio"),
        lambda: unit().root,
        lambda: _("For which mass ratio {ratio} is $\\Omega^2=k/m$ exactly?").format(ratio=f"${latex(epsilon)}=m'/m$"),
        ratio_mistakes,
        "(sqrt(5) - 1)/2",
        NUMBER,
        _("Which quadratic equation for ε follows from Ω² = k/m?"),
        {},
    ),
}

QUESTIONS: tuple[str, ...] = tuple(_ASKED)
"""The names of the questions, in the order of the derivation."""
