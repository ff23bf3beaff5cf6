"""Judges a student's formula: right, right but not simplified, wrong and what is probably missing, or unreadable.

`QUESTIONS` lists the names of the questions, `question(name)` says what is asked, `judge(name, text)` answers.
The right answers come from the bodies and their elimination, the wrong ones from the same derivation with one thing
overlooked (`mistakes`). Nothing that a student types reaches SymPy's own parser.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial

import sympy as sp

from ramanujan.derivation import expressions, mistakes
from ramanujan.derivation.euler_lagrange import (
    Elimination,
    Phi_ddot,
    UnitCondition,
    X_ddot,
    eliminate,
    phi_ddot,
    unit_condition,
)
from ramanujan.derivation.expressions import Values, agree, spelled
from ramanujan.derivation.parser import NAMES, Expression, UnreadableError, parse
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import R, epsilon, k, m, machine, phi

_Variants = Iterator[tuple[str, sp.Expr]]


@dataclass(frozen=True)
class Verdict:
    """What a student is told: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


@dataclass(frozen=True)
class Question:
    """What is asked.

    Parameters
    ----------
    name : the name in `QUESTIONS`
    quantity : what is asked for, in a few words of plain text
    prompt : one or two sentences, Markdown with $…$
    names : what the answer may contain, as one types it
    example : a formula that shows how one types; it is not the answer
    """

    name: str
    quantity: str
    prompt: str
    names: tuple[str, ...]
    example: str


@dataclass(frozen=True)
class _Asked:
    """A question before it is derived: what it calls its quantity, its answer, its prompt, its typical mistakes."""

    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    mistakes: Callable[[], _Variants]
    example: str


def question(name: str) -> Question:
    """Return what is asked under a name.

    Raises
    ------
    ValueError : name is not one of `QUESTIONS`.
    """
    if not isinstance(name, str) or name not in _ASKED:
        raise ValueError(f"name must be one of {', '.join(QUESTIONS)}")
    asked = _ASKED[name]
    return Question(name, asked.quantity, asked.prompt(), _names(name), asked.example)


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises, whatever it is given.

    Equal means equal at random points, exactly for formulas without roots. A right formula is unsimplified if it is
    longer than the derived one and its expanded and factored forms, or a fraction that can be cleared or reduced.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in _ASKED:
        return Verdict("unreadable", "There is no question of that name.")
    try:
        return _verdict(question, parse(text))
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except ArithmeticError:
        return Verdict("unreadable", "Somewhere you divide by zero or take the root of a negative number.")


def _verdict(question: str, answer: Expression) -> Verdict:
    exact = not (expressions.has_root(answer) or expressions.has_root(_answer(question)))
    given = expressions.values(answer, exact)
    if agree(given, expressions.values(_answer(question), exact)):
        return _right(question, answer)
    return Verdict("wrong", " ".join(_advice(question, answer, given, exact)))


# Right, and simplified?


def _right(question: str, answer: Expression) -> Verdict:
    what = _longer_than_needed(question, answer)
    return Verdict("unsimplified", f"Right, but not simplified: {what}.") if what else Verdict("right", "Right!")


def _longer_than_needed(question: str, answer: Expression) -> str | None:
    """Return what could be simplified, cheapest test first, or None."""
    needless = expressions.names(answer) - set(_names(question))
    if needless:
        return f"it can be written without {_listed(needless)}"
    if expressions.length(answer) > _longest_form(question):
        return "it can be written shorter"
    if expressions.has_like_terms(answer):
        return "there are like terms to gather"
    if expressions.has_fraction_below(answer):
        return "there is a fraction inside a denominator"
    # Short by now, so that its numerator and denominator are small polynomials.
    if not expressions.has_root(answer) and expressions.has_common_factor(answer):
        return "numerator and denominator have a common factor"
    return None


@cache
def _longest_form(question: str) -> int:
    """Return the length of the longest form that counts as simplified."""
    answer = _ASKED[question].answer()
    numerator, denominator = sp.fraction(sp.together(answer))
    forms = (answer, sp.factor(answer), sp.expand(answer, frac=True), sp.expand(numerator) / denominator)
    return max(expressions.length(spelled(form)) for form in forms)


# Wrong, and why?


def _advice(question: str, answer: Expression, given: Values, exact: bool) -> Iterator[str]:
    """Yield the sentences on a wrong answer: what was overlooked, then what is wrong with its unit or its names."""
    hint = _overlooked(question, given, exact)
    if hint:
        yield hint
    unit = _wrong_unit(question, answer)
    if unit:
        yield unit
    foreign = expressions.names(answer) - set(_names(question))
    if foreign:
        quantity = _ASKED[question].quantity
        yield f"{quantity[0].upper()}{quantity[1:]} does not depend on {_listed(foreign)}."
    if not (hint or unit or foreign):
        yield _nearly(question, answer, exact)


def _overlooked(question: str, given: Values, exact: bool) -> str | None:
    right = expressions.values(_answer(question), exact)
    wrong = _wrong_values(question, exact)
    hints = [hint for hint, values in wrong if agree(given, values)]
    if hints:
        # Two mistakes may well give the same formula; the first are the most common ones.
        return " Or: ".join(hints[:2])
    number = expressions.ratio(given, right)
    if number is not None:
        return _number_off(question, number)
    for hint, values in wrong:
        if question in _ENERGIES and expressions.ratio(given, values) == 2:
            return f"{hint} Besides, a factor ½ is missing."
    if all(abs(a - b) < abs(b) / 1000 for a, b in zip(given, right, strict=True)):
        return "That is only nearly right: give the exact expression, not a rounded number."
    return None


def _number_off(question: str, number: Fraction) -> str:
    if number == -1:
        return "Only the sign is wrong."
    if number == 2 and question in _ENERGIES:
        return "A factor ½ is missing."
    if number == Fraction(1, 2) and question in _ENERGIES:
        return "There is one factor ½ too many."
    sign = " and the sign" if number < 0 else ""
    return f"Only a number{sign} is wrong: yours is {abs(number)} times the right one."


def _wrong_unit(question: str, answer: Expression) -> str | None:
    try:
        unit = expressions.unit(answer)
    except expressions.UnitError as error:
        return str(error)
    right = expressions.unit(_answer(question))
    if unit == right:
        return None
    return f"The unit is wrong: yours is {expressions.unit_text(unit)}, it should be {expressions.unit_text(right)}."


def _nearly(question: str, answer: Expression, exact: bool) -> str:
    """Return which name the wrong terms contain, if without that name the answer would be right."""
    for name in _names(question):
        points = tuple(point | {name: Fraction(0)} for point in expressions.POINTS)
        try:
            given, right = (expressions.values(e, exact, points) for e in (answer, _answer(question)))
        except ArithmeticError:
            continue
        if any(right) and agree(given, right):
            return f"Not yet: only the terms with {name} are wrong."
    return "Not yet: the unit is right, the expression is not."


@cache
def _wrong_values(question: str, exact: bool) -> tuple[tuple[str, Values], ...]:
    """Return hints and the values that their mistakes give, without those that change nothing here."""
    right = expressions.values(_answer(question), exact)
    found = []
    for hint, formula in _wrong_formulas(question):
        # Some bodies do not oscillate any more, or leave a coordinate without inertia.
        if formula.has(sp.nan, sp.zoo):
            continue
        wrong = spelled(formula)
        if exact and expressions.has_root(wrong):
            continue
        try:
            values = expressions.values(wrong, exact)
        except ArithmeticError:
            continue
        if any(values) and not agree(values, right):
            found.append((hint, values))
    return tuple(found)


@cache
def _wrong_formulas(question: str) -> tuple[tuple[str, sp.Expr], ...]:
    right = _ASKED[question].answer()
    without_radius = (("R is missing: an angle, or its rate, becomes a length only times R.", right.subs(R, 1)),)
    return (*_ASKED[question].mistakes(), *(without_radius if right.has(R) else ()))


def _energy_mistakes(body: str) -> _Variants:
    for mistake in mistakes.mistakes():
        if mistake.altered == (body,):
            yield mistake.hint, mistake.bodies[body].kinetic_energy
    yield from mistakes.overlooked_in_energy(machine()[body])


def _spring_mistakes() -> _Variants:
    bodies = machine()
    yield "The deformation of the spring has to be squared.", k * bodies.deformation / 2
    yield (
        "The spring feels only how far the slab moves over the block, not over the ground.",
        k * bodies["slab"].displacement ** 2 / 2,
    )
    yield (
        "A factor 2 is missing: the slab, lying on top of its rollers, moves twice as far as they do.",
        k * (bodies["hoop"].displacement - bodies["block"].displacement) ** 2 / 2,
    )


def _elimination_mistakes(name: str) -> _Variants:
    right = _ASKED[name].answer()
    for mistake in mistakes.mistakes():
        yield mistake.hint, mistakes.single_mass(mistake.bodies)[name]
    yield "That is upside down.", 1 / right


def _equation_mistakes() -> _Variants:
    equation = _elimination().remaining
    yield "That is the factor after Ẍ has been put in; asked is the one before.", equation.coeff(phi_ddot)
    yield from _elimination_mistakes("phi_equation")
    yield "The equation is written here divided by R.", _ASKED["phi_equation"].answer() * R


def _frequency_mistakes() -> _Variants:
    right = _ASKED["natural_frequency_squared"].answer()
    yield "That is the frequency Ω; asked is its square.", sp.sqrt(right)
    yield "That is squared once too often: asked is Ω^2.", right**2
    yield "That is Ω^2 in units of k/m: a factor k/m is missing.", right * m / k
    yield from _elimination_mistakes("natural_frequency_squared")


def _ratio_mistakes() -> _Variants:
    unit = _unit_condition()
    for root in sp.roots(unit.quadratic, multiple=True):
        if root.is_negative:
            yield "That is the other root of the quadratic: a ratio of masses is positive.", root
            yield "Check a sign: the quadratic formula begins with −b.", -root
    yield "That is m/m'; asked is m'/m.", 1 / unit.root
    a, b, _ = unit.quadratic.all_coeffs()
    yield "A root is missing: the discriminant stands under a square root.", (unit.discriminant - b) / (2 * a)
    for mistake in mistakes.mistakes():
        if mistake.is_of_shape:
            try:
                yield mistake.hint, mistakes.unit_mass_ratio(mistake.bodies)
            except ValueError:
                continue


# The questions


@cache
def _elimination() -> Elimination:
    return eliminate(machine())


@cache
def _unit_condition() -> UnitCondition:
    return unit_condition(_elimination().natural_frequency_squared)


@cache
def _answer(question: str) -> Expression:
    return spelled(_ASKED[question].answer())


@cache
def _names(question: str) -> tuple[str, ...]:
    """Return the names in the answer; ε may stand for m′/m where both masses do."""
    present = expressions.names(_answer(question))
    allowed = present | {"eps"} if question in _COUPLED else present
    return tuple(name for name in NAMES if name in allowed)


def _listed(names: frozenset[str] | set[str]) -> str:
    return ", ".join(name for name in NAMES if name in names)


def _body_question(body: str) -> _Asked:
    called = mistakes.CALLED[body]
    return _Asked(
        f"the kinetic energy of {called}",
        lambda: machine()[body].kinetic_energy,
        lambda: f"What is the kinetic energy of {called}, over the ground?",
        partial(_energy_mistakes, body),
        "3/5 m' (X' + 3 R phi')^2",
    )


def _coupling_question(name: str, which: str, acceleration: sp.Expr, solved: str) -> _Asked:
    return _Asked(
        f"the factor of the {which}",
        lambda: getattr(_elimination(), solved).coeff(phi_ddot),
        lambda: f"With the other equations solved, ${latex(acceleration)}=c\\,{latex(phi_ddot)}$. What is $c$?",
        partial(_elimination_mistakes, name),
        "R (2m + m')/(5m)" if solved == "X_from_phi" else "(2m + m')/(5m)",
    )


def _equation_prompt() -> str:
    equation = _elimination().motion[phi]
    written = equation - equation.coeff(phi_ddot) * phi_ddot + sp.Symbol("a") * phi_ddot
    return f"The equation of motion of ${latex(phi)}$ is ${latex(written)}=0$. What is $a$?"


_ENERGIES = (*(f"kinetic_energy_{body}" for body in mistakes.CALLED), "potential_energy")
_COUPLED = ("phi_equation", "block_coupling", "top_coupling", "natural_frequency_squared")

_ASKED: dict[str, _Asked] = {
    **{f"kinetic_energy_{body}": _body_question(body) for body in mistakes.CALLED},
    "potential_energy": _Asked(
        "the potential energy",
        lambda: machine().potential_energy,
        lambda: f"What is the potential energy of the spring when the lower rollers stand at ${latex(phi)}$?",
        _spring_mistakes,
        "k (R phi)^2 / 5",
    ),
    "phi_equation": _Asked(
        "the factor of the acceleration",
        lambda: _elimination().motion[phi].coeff(phi_ddot),
        _equation_prompt,
        _equation_mistakes,
        "R (2m + m')/5",
    ),
    "block_coupling": _coupling_question("block_coupling", "block’s acceleration", X_ddot, "X_from_phi"),
    "top_coupling": _coupling_question("top_coupling", "top cylinder’s acceleration", Phi_ddot, "Phi_from_phi"),
    "natural_frequency_squared": _Asked(
        "Ω^2",
        lambda: _elimination().natural_frequency_squared,
        lambda: "What is $\\Omega^2$, the square of the natural frequency?",
        _frequency_mistakes,
        "2k/(3m + m')",
    ),
    "unit_mass_ratio": _Asked(
        "the mass ratio",
        lambda: _unit_condition().root,
        lambda: f"For which mass ratio ${latex(epsilon)}=m'/m$ is $\\Omega^2=k/m$, exactly?",
        _ratio_mistakes,
        "(sqrt(5) - 1)/2",
    ),
}

QUESTIONS: tuple[str, ...] = tuple(_ASKED)
"""The names of the questions, in the order of the derivation."""
