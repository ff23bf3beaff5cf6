"""The questions: prompt, right answer, the results of typical mistakes, and the next question after a wrong answer.

The right answers come from the bodies and their elimination, the wrong ones from `mistakes`. A new question is one
entry of `_ASKED`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache, partial

import sympy as sp
from sympy.polys.fields import FracElement

from ramanujan.answers import mistakes
from ramanujan.answers.grammar import SYMBOLS, TEXTBOOK, leaves, length
from ramanujan.answers.machines import CALLED
from ramanujan.answers.mistakes import Variants, elimination
from ramanujan.answers.terms import NAMES, exact
from ramanujan.answers.values import Values, agree, at_points
from ramanujan.derivation.elimination import Phi_ddot, X_ddot, phi_ddot
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import R, epsilon, machine, phi, t
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
class Asked:
    """What belongs to a question: how its answer is derived, compared, spoiled by mistakes, and led to.

    Parameters
    ----------
    quantity, prompt, example : as in `Question`
    answer : derives the right answer
    mistakes : takes the answer, yields what typical mistakes give
    kind : POLYNOMIAL, QUOTIENT or NUMBER
    leads_on : the question that a lecturer would ask next
    hints : product of names, as shown → the next question about its coefficient
    letters : letters of the textbook → what each stands for here, and the question about it
    variables : the names in whose products the answer is written term by term
    """

    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    mistakes: Callable[[sp.Expr], Variants]
    example: str
    kind: str
    leads_on: str
    hints: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[sp.Symbol, tuple[sp.Expr, str]] = field(default_factory=dict)
    variables: tuple[str, ...] = NAMES


def question(name: str) -> Question:
    """Return the question of that name.

    Raises
    ------
    ValueError : name is not one of `QUESTIONS`.
    """
    if not isinstance(name, str) or name not in _ASKED:
        raise ValueError(_("name must be one of {known}").format(known=", ".join(QUESTIONS)))
    it = _ASKED[name]
    return Question(name, it.quantity, it.prompt(), allowed_names(name), it.example)


def asked(name: str) -> Asked:
    """Return a question with what belongs to its answer."""
    return _ASKED[name]


@cache
def answer(question: str) -> sp.Expr:
    """Return the right answer."""
    return _ASKED[question].answer()


@cache
def right_values(question: str) -> Values:
    """Return the values of the right answer."""
    return at_points(answer(question))


@cache
def right_terms(question: str) -> FracElement:
    """Return the right answer in lowest terms; only for those without a root."""
    return exact(answer(question)).rational


@cache
def wrong_values(question: str) -> tuple[tuple[str, Values], ...]:
    """Return hint and result of each typical mistake that changes the answer; the more common ones come first."""
    found = []
    for hint, result in _wrong_results(question):
        try:
            values = at_points(result) if isinstance(result, sp.Expr) else result
        except ArithmeticError:
            continue
        if values and any(values) and not agree(values, right_values(question)):
            found.append((hint, values))
    return tuple(found)


@cache
def longest_form(question: str) -> int:
    """Return the length of the longest form that counts as simplified."""
    right = answer(question)
    numerator, denominator = sp.fraction(sp.together(right))
    forms = (right, sp.factor(right), sp.expand(right, frac=True), sp.expand(numerator) / denominator)
    return max(map(length, forms))


@cache
def allowed_names(question: str) -> tuple[str, ...]:
    """Return the names in the answer; ε may stand for m′/m where both masses do."""
    allowed = leaves(answer(question)) | ({epsilon} if question in _COUPLED else set())
    return tuple(name for name, symbol in SYMBOLS.items() if symbol in allowed)


def _wrong_results(question: str) -> Variants:
    right = answer(question)
    yield from _ASKED[question].mistakes(right)
    if R in leaves(right):
        yield _("You get this result if you leave out R. Which length belongs to an angle?"), right.subs(R, 1)


# The questions


def _body_question(name: str) -> Asked:
    body, called = machine()[name], CALLED[name]
    rate = {"block": "", "top": "Φ′"}.get(name, "φ′")
    hints = {
        "X′²": _("What is the kinetic energy of {body} while only the block moves, with {rate} = 0?"),
        f"X′{rate}": _("What is the mixed term when you square the velocity of {body}?"),
        f"{rate}²": _("What is the kinetic energy of {body} while the block is at rest, with X′ = 0?"),
    }
    leads_on = (
        _("How fast does {body} move relative to the ground, and how fast does it rotate?")
        if body.angle != 0
        else _("How fast does {body} move relative to the ground?")
    )
    speed = _("What is v in terms of X′ and {rate}?") if rate else _("What is v in terms of X′?")
    return Asked(
        _("the kinetic energy of {body}").format(body=called),
        lambda: body.kinetic_energy,
        lambda: _("What is the kinetic energy of {body} relative to the ground?").format(body=called),
        lambda _right: mistakes.energy(name),
        "3/5 m' (X' + 3 R phi')^2",
        POLYNOMIAL,
        leads_on.format(body=called),
        {term: hint.format(body=called, rate=rate) for term, hint in hints.items()} if rate else {},
        {
            TEXTBOOK["v"]: (body.velocity, speed.format(rate=rate)),
            TEXTBOOK["I"]: (body.moment_of_inertia, _("What is I?")),
            TEXTBOOK["omega"]: (body.angle.diff(t), _("What is ω?")),
        },
        MOTION,
    )


def _coupling_question(name: str, quantity: str, acceleration: sp.Expr, equation: str) -> Asked:
    return Asked(
        quantity,
        lambda: mistakes.answer_of(equation),
        lambda: _("The equations of motion of $X$ and $\\Phi$ give {relation}. What is $c$?").format(
            relation=f"${latex(acceleration)}=c\\,{latex(phi_ddot)}$"
        ),
        partial(mistakes.coupling, name),
        "R (2m + m')/(5m)" if acceleration == X_ddot else "(2m + m')/(5m)",
        QUOTIENT,
        _("What do the equations of motion of X and Φ say about the three accelerations?"),
    )


def _equation_prompt() -> str:
    equation = elimination().motion[phi]
    written = equation - equation.coeff(phi_ddot) * phi_ddot + sp.Symbol("a") * phi_ddot
    prompt = _("The equation of motion of {coordinate} is {equation}. What is $a$?")
    return prompt.format(coordinate=f"${latex(phi)}$", equation=f"${latex(written)}=0$")


_COUPLED = ("phi_equation", "block_coupling", "top_coupling", "natural_frequency_squared")

_ASKED: dict[str, Asked] = {
    **{f"kinetic_energy_{body}": _body_question(body) for body in CALLED},
    "potential_energy": Asked(
        _("the potential energy"),
        lambda: machine().potential_energy,
        lambda: _("What is the potential energy of the spring when the lower rollers have turned by {angle}?").format(
            angle=f"${latex(phi)}$"
        ),
        lambda _right: mistakes.spring(),
        "k (R phi)^2 / 5",
        POLYNOMIAL,
        _("How far is the spring compressed when the lower rollers have turned by φ?"),
        letters={TEXTBOOK["x"]: (machine().deformation, _("What is x in terms of φ?"))},
        variables=MOTION,
    ),
    "phi_equation": Asked(
        _("the factor of the acceleration"),
        lambda: elimination().motion[phi].coeff(phi_ddot),
        _equation_prompt,
        lambda _right: mistakes.equation(),
        "R (2m + m')/5",
        POLYNOMIAL,
        _("Which kinetic energies contain φ′², and with which factors?"),
    ),
    "block_coupling": _coupling_question(
        "block_coupling", _("the factor in the block’s acceleration"), X_ddot, "X_from_phi"
    ),
    "top_coupling": _coupling_question(
        "top_coupling", _("the factor in the top cylinder’s acceleration"), Phi_ddot, "Phi_from_phi"
    ),
    "natural_frequency_squared": Asked(
        "Ω²",
        lambda: elimination().natural_frequency_squared,
        lambda: _("What is $\\Omega^2$, the square of the natural frequency?"),
        mistakes.frequency,
        "2k/(3m + m')",
        QUOTIENT,
        _("What is left of the equation of motion of φ when you insert the other two accelerations?"),
    ),
    "unit_mass_ratio": Asked(
        _("the mass ratio"),
        lambda: mistakes.unit().root,
        lambda: _("For which mass ratio {ratio} is $\\Omega^2=k/m$ exactly?").format(ratio=f"${latex(epsilon)}=m'/m$"),
        lambda _right: mistakes.ratio(),
        "(sqrt(5) - 1)/2",
        NUMBER,
        _("Which quadratic equation for ε follows from Ω² = k/m?"),
    ),
}

QUESTIONS: tuple[str, ...] = tuple(_ASKED)
"""The names of the questions, in the order of the derivation."""
