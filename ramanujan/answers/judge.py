"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from dataclasses import dataclass

import sympy as sp

from ramanujan.answers import terms, values
from ramanujan.answers.differences import Difference, difference_between
from ramanujan.answers.formulas import leaves, length, replaced
from ramanujan.answers.grammar import parse, parse_equation
from ramanujan.answers.questions import EQUATION, QUESTIONS, Question
from ramanujan.answers.questions import question as question_named
from ramanujan.answers.spelling import SYMBOLS, TEXTBOOK, UnknownNameError, UnreadableError
from ramanujan.translation import _, ngettext

_OF_SLIPS, _OF_BODIES = 3, 5
"""A decimal needs this many significant digits to be compared with the results of slips, and of wrong bodies."""

_HALF = 0.5
"""The largest rounding error in units of the last digit."""


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises.

    Two formulas are equal if they agree at random points to 1,150 digits. A right formula counts as unsimplified in
    two cases: it contains a needless symbol, or it is longer than the derived formula and its factored and expanded
    forms.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    return _judge_formula(question_named(question), text)


def _judge_formula(question: Question, text: str) -> Verdict:
    try:
        typed = _parse(question, text)
        letters = _letters_in(typed)
        return _compare(question, _without_letters(question, typed), letters)
    except UnknownNameError as error:
        may_use = _("You may use {names} and sqrt( ).").format(names=", ".join(question.accepted) or _("numbers"))
        return Verdict("unreadable", f"{error} {may_use}")
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except values.NegativeRootError:
        return Verdict("unreadable", _("Your formula contains a root that is not real for all masses and motions."))
    except ArithmeticError:
        return Verdict("unreadable", _("Your formula divides by zero."))


def _parse(question: Question, text: str) -> sp.Expr:
    """Return the typed formula; for an equation, its left side minus its right side."""
    if question.kind != EQUATION:
        return parse(text)
    left, right = parse_equation(text)
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False) if right else left


def _letters_in(typed: sp.Expr) -> list[sp.Symbol]:
    return [letter for letter in TEXTBOOK.values() if letter in leaves(typed)]


def _without_letters(question: Question, typed: sp.Expr) -> sp.Expr:
    """Replace v, I, ω and x by their meanings.

    Raises
    ------
    UnreadableError : the question does not use one of the letters.
    """
    for letter in _letters_in(typed):
        if letter not in question.letters:
            refusal = _("Type only the right side of the equation: a formula without Ω.")
            raise UnreadableError(refusal) if letter == TEXTBOOK["omega"] else UnknownNameError(letter.name)
    return replaced(typed, {letter: meaning for letter, (meaning, _next) in question.letters.items()})


def _compare(question: Question, typed: sp.Expr, letters: list[sp.Symbol]) -> Verdict:
    given, right = question.values(typed), question.right_values
    if not values.agree(given, right):
        if _has_denominator(question, typed):
            return Verdict("unsimplified", _("Right so far! What do you get if you multiply by the denominator?"))
        return Verdict("wrong", " ".join(_advice(question, typed, given)))
    if letters:
        next_questions = (question.letters[letter][1] for letter in letters)
        return Verdict("unsimplified", " ".join([_("Right so far!"), *next_questions]))
    used = leaves(typed)
    needless = [name for name, symbol in SYMBOLS.items() if symbol in used and name not in question.names]
    if needless:
        sentence = _("Right! The formula can be written without {names}.")
        return Verdict("unsimplified", sentence.format(names=terms.listed(needless)))
    if not (question.any_form or question.kind == EQUATION) and length(typed) > question.longest_form:
        return Verdict("unsimplified", _("Right! The formula can be written shorter."))
    return Verdict("right", _("Right!"))


def _has_denominator(question: Question, typed: sp.Expr) -> bool:
    """Return whether an equation is the right one divided by an expression in its variables."""
    if question.kind != EQUATION:
        return False
    try:
        numerator = terms.FIELD(question.terms(typed).numer)
    except terms.NotComparableError:
        return False
    factor = terms.names_in(numerator / question.right_terms)
    return bool(numerator) and factor.isdisjoint(question.variables)


def _advice(question: Question, typed: sp.Expr, given: values.Values) -> list[str]:
    """Return sentences about a wrong answer, the last one with the next question.

    The first explanation wins: a known slip, a rounded number, a difference of the whole formula, or wrong bodies.
    Without one, the sentences are about the unit, the names and the single terms.
    """
    if not any(given):
        zero = _("Both sides of your equation are equal.") if question.kind == EQUATION else _("Your answer is zero.")
        return [zero, question.next_question]
    hint = _first_hint(question.slips, given) or _rounded(question, typed)
    if hint:
        return [hint]
    difference = _difference(question, typed, given)
    if not _is_explained(question, difference):
        hint = _wrong_bodies(question, given)
        if hint:
            return [hint]
    return _account(question, typed, difference)


def _is_explained(question: Question, difference: Difference) -> bool:
    """Return whether a difference explains an answer better than a wrong body.

    A missing term or a wrong sign is more likely than a wrong body. A wrong sign in the energy of one body is an
    exception: there it usually comes from a wrong velocity, unless the student typed terms that cancel.
    """
    if difference.next_question or difference.is_whole:
        return True
    return difference.is_slip and not question.of_one_body


def _account(question: Question, typed: sp.Expr, difference: Difference) -> list[str]:
    """Return sentences about the unit, the names and the terms of a wrong answer, then the next question."""
    faults = [] if difference.is_whole else [_wrong_unit(question, typed), _foreign_names(question, typed)]
    sentences = [fault for fault in faults if fault]
    # If the unit of the whole formula is wrong, every term is wrong, and a list of terms does not help.
    if difference.term is not None or not sentences:
        sentences += difference.sentences
    next_of_term = question.of_terms.get(difference.term or "", question.next_question)
    return [*sentences, difference.next_question or next_of_term]


def _difference(question: Question, typed: sp.Expr, given: values.Values) -> Difference:
    try:
        return difference_between(question, typed, given)
    except terms.NotComparableError as error:
        return Difference([str(error)])


def _first_hint(mistakes: values.Mistakes, given: values.Values) -> str | None:
    return next((hint for hint, wrong in mistakes if values.agree(given, wrong)), None)


def _wrong_bodies(question: Question, given: values.Values) -> str | None:
    hint = _first_hint(question.altered, given)
    if hint is None and question.of_one_body:
        hint = _first_hint(question.altered, tuple(value / 2 for value in given))
        return hint and _("{hint} A factor ½ is missing as well.").format(hint=hint)
    return hint


def _rounded(question: Question, typed: sp.Expr) -> str | None:
    """Return a hint if a decimal number in the answer is a rounded exact number, else None."""
    numbers = values.decimals(typed)
    if not numbers or question.kind == EQUATION:
        return None
    units = values.units_off(typed, question.right_values)
    if units is not None:
        if units <= _HALF:
            return _("An exact number agrees with your decimal number to the last digit. What is the exact number?")
        return _("The last digit of your decimal number is off by one unit. What is the exact number?")
    return _rounded_mistake(question, typed, min(map(_significant_digits, numbers)))


def _significant_digits(decimal: sp.Symbol) -> int:
    return len(decimal.name.replace(".", "").lstrip("0"))


def _rounded_mistake(question: Question, typed: sp.Expr, digits: int) -> str | None:
    """Return the hint if the decimal number is the rounded result of exactly one mistake, else None."""
    mistakes: list[tuple[str, values.Values]] = []
    if digits >= _OF_SLIPS:
        mistakes += question.slips
    if digits >= _OF_BODIES:
        mistakes += question.altered
    hints = []
    for hint, wrong in mistakes:
        units = values.units_off(typed, wrong)
        if units is not None and units <= _HALF:
            hints.append(hint)
    if len(hints) == 1:
        return _("Your decimal number agrees to the last digit with this case. {hint}").format(hint=hints[0])
    return None


def _foreign_names(question: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about the names that do not belong in the answer, None if there are none."""
    expected = leaves(question.right)
    others = {name: symbol for name, symbol in SYMBOLS.items() if name != "eps" and symbol not in expected}
    of_ratio = SYMBOLS["eps"] in expected
    foreign = [name for name, symbol in others.items() if values.depends_on(typed, symbol, of_ratio=of_ratio)]
    if not foreign:
        return None
    if question.name == "potential_energy" and foreign in (["X"], ["Phi"]):
        spring = _("Your answer depends on {name}, but {name} does not deform the spring.")
        return spring.format(name=terms.listed(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=terms.listed(foreign), quantity=question.quantity)


def _wrong_unit(question: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about a wrong unit of the answer, None if the unit is right."""
    right, quantity = values.unit(question.right), question.quantity
    try:
        unit = values.unit(typed)
    except values.DifferentUnitsError as error:
        one, other = error.args
        if not (one and other):
            return _("You add a plain number to a term with the unit {unit}.").format(unit=one or other)
        return _("You add terms with different units, {one} and {other}.").format(one=one, other=other)
    if unit == right or question.kind == EQUATION:
        return None
    if not unit:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block.
        sentence = _("Your answer is a plain number, but {quantity} has the unit {expected}.")
    elif not right:
        sentence = _("Your answer has the unit {yours}, but {quantity} is a plain number.")
    else:
        sentence = _("Your answer has the unit {yours}, but {quantity} has the unit {expected}.")
    return sentence.format(yours=unit, expected=right, quantity=quantity)
