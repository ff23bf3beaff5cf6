"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.differences import compared, depends, differences
from ramanujan.answers.formulas import leaves, length, replaced
from ramanujan.answers.grammar import parse, parse_equation
from ramanujan.answers.questions import (
    EQUATION,
    QUESTIONS,
    answer,
    longest_form,
    right_terms,
    right_values,
    values_of,
    wrong_values,
)
from ramanujan.answers.questions import question as asked
from ramanujan.answers.spelling import MOTION, SYMBOLS, TEXTBOOK, UnreadableError, not_known
from ramanujan.answers.values import (
    DifferentUnitsError,
    NegativeRootError,
    Values,
    agree,
    decimals,
    unit,
    units_off,
)
from ramanujan.translation import _, ngettext

_TELLING_DIGITS, _HALF = 3, 0.5
"""Significant digits with which a decimal may be a mistake's result; units of the last digit that rounding leaves."""


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises, whatever it is given.

    Two formulas are equal if they agree at random points: exactly, or in 120 digits where there are roots. A right
    formula counts as unsimplified if it contains a symbol that it does not need, or if it is longer than the derived
    one and its expanded and factored forms.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    try:
        typed = _typed(question, text)
        return _verdict(question, _without_letters(question, typed), _letters_in(typed))
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except NegativeRootError:
        return Verdict("unreadable", _("Your formula contains a root that is not real for all masses and motions."))
    except ArithmeticError:
        return Verdict("unreadable", _("Your formula divides by zero."))


def _typed(question: str, text: str) -> sp.Expr:
    """Return the formula that was typed, of an equation its left side minus its right side."""
    if asked(question).kind != EQUATION:
        return parse(text)
    left, right = parse_equation(text)
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False) if right else left


def _letters_in(typed: sp.Expr) -> list[sp.Symbol]:
    return [letter for letter in TEXTBOOK.values() if letter in leaves(typed)]


def _without_letters(question: str, typed: sp.Expr) -> sp.Expr:
    """Return a formula with what v, I, ω and x stand for; a letter of which the question has no use is refused."""
    known = asked(question).letters
    for letter in _letters_in(typed):
        if letter not in known:
            refusal = _("Type only the right side of the equation: a formula without Ω.")
            raise UnreadableError(refusal if letter == TEXTBOOK["omega"] else not_known(letter.name))
    return replaced(typed, {letter: meaning for letter, (meaning, _asks) in known.items()})


def _verdict(question: str, typed: sp.Expr, letters: list[sp.Symbol]) -> Verdict:
    given, right = values_of(question, typed), right_values(question)
    if not agree(given, right):
        if _has_denominator(question, typed):
            return Verdict("unsimplified", _("Right so far! What do you get if you multiply by the denominator?"))
        return Verdict("wrong", " ".join(_advice(question, typed, given)))
    if letters:
        asks = (asked(question).letters[letter][1] for letter in letters)
        return Verdict("unsimplified", " ".join([_("Right so far!"), *asks]))
    own = asked(question).names
    needless = [name for name, symbol in SYMBOLS.items() if symbol in leaves(typed) and name not in own]
    if needless:
        sentence = _("Right! The formula can be written without {names}.")
        return Verdict("unsimplified", sentence.format(names=terms.listed(needless)))
    if not asked(question).any_form and length(typed) > longest_form(question):
        return Verdict("unsimplified", _("Right! The formula can be written shorter."))
    return Verdict("right", _("Right!"))


def _has_denominator(question: str, typed: sp.Expr) -> bool:
    """Tell whether an equation is the right one, divided by something that depends on what it is about."""
    if asked(question).kind != EQUATION:
        return False
    try:
        numerator = terms.FIELD(compared(question, typed).numer)
    except terms.NotComparableError:
        return False
    factor = terms.names_in(numerator / right_terms(question))
    return bool(numerator) and factor.isdisjoint(asked(question).variables)


def _advice(question: str, typed: sp.Expr, given: Values) -> Iterator[str]:
    """Yield what was found, then the question that leads to the next step."""
    leads_on = asked(question).leads_on
    is_equation = asked(question).kind == EQUATION
    if not any(given):
        yield _("Both sides of your equation are equal.") if is_equation else _("Your answer is zero.")
        yield leads_on
        return
    known = _known_mistake(question, given) or (None if is_equation else _rounded(question, typed))
    if known:
        yield known
        return
    wrong_unit = _wrong_unit(question, typed)
    if wrong_unit:
        yield wrong_unit
    own = leaves(answer(question))
    foreign = [
        name
        for name in terms.NAMES
        if name != "eps" and SYMBOLS[name] not in own and depends(typed, name, SYMBOLS["eps"] not in own)
    ]
    if foreign:
        yield _depends_on(question, foreign)
    try:
        term, sentences = differences(question, typed, given)
    except terms.NotComparableError as error:
        term, sentences = None, [str(error)]
    # If the unit is wrong as a whole, every term is wrong, and a list of them says nothing.
    if term is not None or not (wrong_unit or foreign):
        yield from sentences
    yield asked(question).of_terms.get(term or "", leads_on)


def _known_mistake(question: str, given: Values) -> str | None:
    for hint, values in wrong_values(question):
        if agree(given, values):
            return hint
    if asked(question).variables == MOTION and asked(question).kind != EQUATION:
        for hint, values in wrong_values(question):
            if agree(given, tuple(2 * value for value in values)):
                return _("{hint} A factor ½ is missing as well.").format(hint=hint)
    return None


def _rounded(question: str, typed: sp.Expr) -> str | None:
    """Return a hint if one decimal number of the answer is an exact one, rounded; else None."""
    numbers = decimals(typed)
    if not numbers:
        return None
    off = units_off(typed, right_values(question))
    if off is not None:
        if off <= _HALF:
            return _("An exact number agrees with your decimal number to the last digit. What is the exact number?")
        return _("The last digit of your decimal number is off by one unit. What is the exact number?")
    # Fewer digits would fit too many cases.
    if all(len(number.name.replace(".", "").lstrip("0")) >= _TELLING_DIGITS for number in numbers):
        for hint, values in wrong_values(question):
            off = units_off(typed, values)
            if off is not None and off <= _HALF:
                return _("Your decimal number agrees to the last digit with this case. {hint}").format(hint=hint)
    return None


def _depends_on(question: str, foreign: list[str]) -> str:
    if question == "potential_energy" and foreign in (["X"], ["Phi"]):
        spring = _("Your answer depends on {name}, but {name} does not deform the spring.")
        return spring.format(name=terms.listed(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=terms.listed(foreign), quantity=asked(question).quantity)


def _wrong_unit(question: str, typed: sp.Expr) -> str | None:
    right, quantity = unit(answer(question)), asked(question).quantity
    try:
        found = unit(typed)
    except DifferentUnitsError as error:
        one, other = error.args
        if not (one and other):
            return _("You add a plain number to a term with the unit {unit}.").format(unit=one or other)
        return _("You add terms with different units, {one} and {other}.").format(one=one, other=other)
    if found == right or asked(question).kind == EQUATION:
        return None
    if not found:
        sentence = _("Your answer is a plain number, but {quantity} has the unit {expected}.")
    elif not right:
        sentence = _("Your answer has the unit {yours}, but {quantity} is a plain number.")
    else:
        sentence = _("Your answer has the unit {yours}, but {quantity} has the unit {expected}.")
    return sentence.format(yours=found, expected=right, quantity=quantity)
