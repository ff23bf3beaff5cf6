"""The questions: prompt, right answer, the results of typical mistakes, and the next question after a wrong answer.

The right answers come from the bodies and their elimination, the wrong ones from the same derivation with one mistake
(`mistakes`). A new question is one entry of `_ASKED`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial

import sympy as sp

from ramanujan.derivation import decimals, mistakes
from ramanujan.derivation.euler_lagrange import (
    Elimination,
    Phi_ddot,
    UnitCondition,
    X_ddot,
    eliminate,
    phi_ddot,
    unit_condition,
)
from ramanujan.derivation.expressions import NAMES, Expression, length, names, spelled
from ramanujan.derivation.normal_form import NormalForm, expression_of, normal_form
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import R, epsilon, k, m, m_prime, machine, phi
from ramanujan.words import _

POLYNOMIAL, QUOTIENT, NUMBER = "polynomial", "quotient", "number"
"""How an answer is compared: term by term, as one fraction, or as a number."""

MOTION = ("X", "X'", "phi", "phi'", "Phi", "Phi'")
_Variants = Iterator[tuple[str, sp.Expr | NormalForm | None]]
"""Hints, and the results of the mistakes; None where there is no solution."""


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
    """A question before its answer is derived; `hints` maps a product of velocities, as shown, to the next question."""

    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    mistakes: Callable[[], _Variants]
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


# What mistakes lead to


def _wrong_results(question: str) -> _Variants:
    right = _ASKED[question].answer()
    yield from _ASKED[question].mistakes()
    if right.has(R):
        yield _("You get this result if you leave out R. Which length belongs to an angle?"), right.subs(R, 1)


def _energy_mistakes(body: str) -> _Variants:
    for mistake in mistakes.mistakes():
        if mistake.altered == (body,):
            yield mistake.hint, mistake.bodies[body].kinetic_energy
    yield from mistakes.overlooked_in_energy(machine()[body])


def _spring_mistakes() -> _Variants:
    bodies = machine()
    path, travel = bodies.deformation, bodies["block"].displacement
    yield _("You get this result if you leave out the ½. What is the potential energy of a spring?"), k * path**2
    yield (
        _("You get this result if you do not square the deformation. How does a spring’s energy depend on it?"),
        k * path / 2,
    )
    yield (
        _(
            "You get this result if you take the displacement of the slab relative to the ground. Between which two "
            "bodies does the spring act?"
        ),
        k * (path + travel) ** 2 / 2,
    )
    yield (
        _(
            "You get this result if you take 2Rφ + X for the deformation. Between which two bodies does the spring "
            "act, and does their distance depend on X?"
        ),
        k * (path - travel) ** 2 / 2,
    )
    yield (
        _(
            "You get this result if the slab moves only as far as the centres of its rollers. How far does the top of "
            "a rolling body move?"
        ),
        k * (bodies["hoop"].displacement - travel) ** 2 / 2,
    )


def _elimination_mistakes(name: str) -> _Variants:
    right = _ASKED[name].answer()
    for mistake in mistakes.mistakes():
        yield mistake.hint, mistakes.single_mass(mistake.bodies, name)
    reciprocal = _("This is the reciprocal of the right answer. Which unit does {quantity} have?")
    yield reciprocal.format(quantity=_ASKED[name].quantity), 1 / right


def _equation_mistakes() -> _Variants:
    equation = _elimination().remaining
    yield (
        _("This is the factor after the other two accelerations are inserted. What is it before?"),
        equation.coeff(phi_ddot),
    )
    divided = _("This is R times the right answer. By what has the equation been divided here?")
    yield divided, _ASKED["phi_equation"].answer() * R
    yield from _elimination_mistakes("phi_equation")


def _frequency_mistakes() -> _Variants:
    right = _ASKED["natural_frequency_squared"].answer()
    equal = right.subs(m_prime, m)
    yield _("This is Ω. The question asks for Ω². What do you get if you square it?"), sp.sqrt(right)
    yield _("This is Ω⁴. The question asks for Ω². What do you get if you take its root?"), right**2
    yield _("This is Ω² in units of k/m. Which factor turns it into the square of a frequency?"), right * m / k
    yield _("This is Ω² of a plain mass m on the same spring. Which other bodies move?"), k / m
    yield _("This is Ω² for equal masses, m′ = m. What changes if the lower rollers have another mass?"), equal
    yield (
        _("This is Ω² for equal masses, m′ = m, in units of k/m. What changes if the lower rollers have another mass?"),
        equal * m / k,
    )
    yield _("This is Ω for equal masses, m′ = m. What is Ω² for any two masses?"), sp.sqrt(equal)
    yield from _elimination_mistakes("natural_frequency_squared")


def _ratio_mistakes() -> _Variants:
    unit = _unit_condition()
    a, b, c = unit.quadratic.all_coeffs()
    root = sp.sqrt(unit.discriminant)
    yield _("This is the other root of the quadratic. Can a ratio of masses be negative?"), (-b - root) / (2 * a)
    sign = _("You get this result if b has the wrong sign. Which sign does b have in (−b ± √(b² − 4ac))/(2a)?")
    yield sign, (b + root) / (2 * a)
    yield _("This is the ratio m/m′. Which ratio does the question ask for?"), 1 / unit.root
    yield (
        _("You get this result if you leave out the root. What does the quadratic formula do with the discriminant?"),
        (unit.discriminant - b) / (2 * a),
    )
    yield _("You get this result if you divide by a. By what does the quadratic formula divide?"), (root - b) / a
    yield _("You get this result if you leave out b in front of the root. What is b here?"), root / (2 * a)
    yield (
        _("You get this result if you leave out b² under the root. What is the discriminant?"),
        (sp.sqrt(-4 * a * c) - b) / (2 * a),
    )
    for mistake in mistakes.mistakes():
        frequency_squared = mistakes.single_mass(mistake.bodies, "natural_frequency_squared")
        yield mistake.hint, _unit_mass_ratio(frequency_squared) if frequency_squared else None


def _unit_mass_ratio(frequency_squared: NormalForm) -> NormalForm | None:
    """Return the positive ε for which Ω² = k/m; None if this is not a quadratic with exactly one positive root.

    With Ω² = N/D the condition is mN = kD; both sides are homogeneous in m and m′, so that m = k = 1 and m′ = ε.
    """
    powers: dict[int, int] = {}
    position = NAMES.index("m'")
    for polynomial, sign in ((frequency_squared.denominator, 1), (frequency_squared.numerator, -1)):
        for monomial, number in polynomial.items():
            powers[monomial[position]] = powers.get(monomial[position], 0) + sign * int(number)
    a, b, c = (sp.Integer(powers.get(power, 0)) for power in (2, 1, 0))
    if any(number for power, number in powers.items() if power > 2) or a * c >= 0:
        return None
    return NormalForm.of((sp.sqrt(b**2 - 4 * a * c) / abs(a) - b / a) / 2)


# The questions


@cache
def _elimination() -> Elimination:
    return eliminate(machine())


@cache
def _unit_condition() -> UnitCondition:
    return unit_condition(_elimination().natural_frequency_squared)


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
        partial(_energy_mistakes, body),
        "3/5 m' (X' + 3 R phi')^2",
        POLYNOMIAL,
        leads_on.format(body=called),
        {term: hint.format(body=called, rate=rate) for term, hint in hints.items()} if rate else {},
    )


def _coupling_question(name: str, quantity: str, acceleration: sp.Expr, solved: str) -> _Asked:
    return _Asked(
        quantity,
        lambda: getattr(_elimination(), solved).coeff(phi_ddot),
        lambda: _("The equations of motion of $X$ and $\\Phi$ give {relation}. What is $c$?").format(
            relation=f"${latex(acceleration)}=c\\,{latex(phi_ddot)}$"
        ),
        partial(_elimination_mistakes, name),
        "R (2m + m')/(5m)" if solved == "X_from_phi" else "(2m + m')/(5m)",
        QUOTIENT,
        _("What do the equations of motion of X and Φ say about the three accelerations?"),
        {},
    )


def _equation_prompt() -> str:
    equation = _elimination().motion[phi]
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
        _spring_mistakes,
        "k (R phi)^2 / 5",
        POLYNOMIAL,
        _("How far is the spring compressed when the lower rollers have turned by φ?"),
        {},
    ),
    "phi_equation": _Asked(
        _("the factor of the acceleration"),
        lambda: _elimination().motion[phi].coeff(phi_ddot),
        _equation_prompt,
        _equation_mistakes,
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
        lambda: _elimination().natural_frequency_squared,
        lambda: _("What is $\\Omega^2$, the square of the natural frequency?"),
        _frequency_mistakes,
        "2k/(3m + m')",
        QUOTIENT,
        _("What is left of the equation of motion of φ when you insert the other two accelerations?"),
        {},
    ),
    "unit_mass_ratio": _Asked(
        _("the mass ratio"),
        lambda: _unit_condition().root,
        lambda: _("For which mass ratio {ratio} is $\\Omega^2=k/m$ exactly?").format(ratio=f"${latex(epsilon)}=m'/m$"),
        _ratio_mistakes,
        "(sqrt(5) - 1)/2",
        NUMBER,
        _("Which quadratic equation for ε follows from Ω² = k/m?"),
        {},
    ),
}

QUESTIONS: tuple[str, ...] = tuple(_ASKED)
"""The names of the questions, in the order of the derivation."""
