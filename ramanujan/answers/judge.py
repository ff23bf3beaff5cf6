"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from dataclasses import dataclass

import sympy as sp

from ramanujan.answers import terms, values
from ramanujan.answers.differences import Difference, difference_between
from ramanujan.answers.formulas import leaves, length, replace_letters
from ramanujan.answers.grammar import parse, parse_equation
from ramanujan.answers.questions import EQUATION, QUESTIONS, Question, find_question
from ramanujan.answers.spelling import SYMBOLS, TEXTBOOK, UnknownNameError, UnreadableError
from ramanujan.translation import _, ngettext

_DIGITS_FOR_SLIPS, _DIGITS_FOR_BODIES = 3, 5
"""A decimal needs this many significant digits to be compared with the results of slips, and of mistakes in bodies."""

_HALF = 0.5
"""The largest rounding error in units of the last digit."""


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises.

    Two formulas are equal if they agree at random points to 1,150 digits. A right formula counts as unsimplified if it
    contains a needless symbol. It is also unsimplified if it is longer than every form of the derived formula: as
    derived, factored, or expanded.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    return _judge_formula(find_question(question), text)


def _judge_formula(question: Question, text: str) -> Verdict:
    try:
        typed = _parse(question, text)
        letters = _find_letters(typed)
        return _compare(question, _replace_letters(question, typed), letters)
    except UnknownNameError as error:
        may_use = _("You may use {names} and sqrt( ).").format(names=", ".join(question.accepted_names) or _("numbers"))
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
    if right == 0:
        return left
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False)


def _find_letters(typed: sp.Expr) -> list[sp.Symbol]:
    return [letter for letter in TEXTBOOK.values() if letter in leaves(typed)]


def _replace_letters(question: Question, typed: sp.Expr) -> sp.Expr:
    """Replace v, I, ω and x by their meanings.

    Raises
    ------
    UnreadableError : the question does not use one of the letters.
    """
    for letter in _find_letters(typed):
        if letter not in question.letters:
            # A student who types ω in another question usually means Ω.
            if letter == TEXTBOOK["omega"]:
                raise UnreadableError(_("Type only the right side of the equation: a formula without Ω."))
            raise UnknownNameError(letter.name)
    meanings = {letter: meaning for letter, (meaning, _next_question) in question.letters.items()}
    return replace_letters(typed, meanings)


def _compare(question: Question, typed: sp.Expr, letters: list[sp.Symbol]) -> Verdict:
    typed_values = question.evaluate(typed)
    if not values.agree(typed_values, question.right_values):
        if _has_right_numerator(question, typed):
            return Verdict("unsimplified", _("Right so far! What do you get if you multiply by the denominator?"))
        return Verdict("wrong", " ".join(_explain(question, typed, typed_values)))
    if letters:
        sentences = [_("Right so far!")]
        for letter in letters:
            _meaning, next_question = question.letters[letter]
            sentences.append(next_question)
        return Verdict("unsimplified", " ".join(sentences))
    used = leaves(typed)
    needless = [name for name, symbol in SYMBOLS.items() if symbol in used and name not in question.names]
    if needless:
        sentence = _("Right! The formula can be written without {names}.")
        return Verdict("unsimplified", sentence.format(names=terms.join_names(needless)))
    may_be_long = question.accepts_any_form or question.kind == EQUATION
    if not may_be_long and length(typed) > question.longest_form:
        return Verdict("unsimplified", _("Right! The formula can be written shorter."))
    return Verdict("right", _("Right!"))


def _has_right_numerator(question: Question, typed: sp.Expr) -> bool:
    """Return whether the numerator of an equation is the right one, up to a factor without the variables."""
    if question.kind != EQUATION:
        return False
    try:
        numerator = terms.FIELD(question.to_fraction(typed).numer)
    except terms.NotComparableError:
        return False
    factor = terms.find_names(numerator / question.right_terms)
    return bool(numerator) and factor.isdisjoint(question.variables)


def _explain(question: Question, typed: sp.Expr, typed_values: values.Values) -> list[str]:
    """Return sentences about a wrong answer, the last one with the next question.

    The first explanation counts, in this order: a known slip, a rounded number, a difference of the whole formula, a
    mistake in a body. Without such an explanation, the sentences are about the unit, the names and the single terms.
    """
    is_zero = not any(typed_values)
    if is_zero and question.kind == EQUATION:
        return [_("Both sides of your equation are equal."), question.next_question]
    if is_zero:
        return [_("Your answer is zero."), question.next_question]
    hint = _find_hint(question.values_of_slips, typed_values) or _explain_rounding(question, typed)
    if hint:
        return [hint]
    difference = _find_difference(question, typed, typed_values)
    if not _is_explained(question, difference):
        hint = _explain_body_mistake(question, typed_values)
        if hint:
            return [hint]
    return _explain_difference(question, typed, difference)


def _is_explained(question: Question, difference: Difference) -> bool:
    """Return whether a difference explains an answer better than a mistake in a body.

    A missing term or a wrong sign is more likely than a mistake in a body. The energy of one body is an exception. A
    wrong sign in it usually comes from a wrong velocity, unless the student typed terms that cancel.
    """
    if difference.next_question or difference.is_complete:
        return True
    return difference.is_slip and not question.is_about_one_body


def _explain_difference(question: Question, typed: sp.Expr, difference: Difference) -> list[str]:
    """Return sentences about the unit, the names and the terms of a wrong answer, then the next question."""
    sentences = []
    if not difference.is_complete:
        faults = (_explain_wrong_unit(question, typed), _explain_foreign_names(question, typed))
        sentences = [fault for fault in faults if fault]
    # If the unit or the names are wrong, most terms are wrong, and a list of them does not help.
    if difference.term is not None or not sentences:
        sentences += difference.sentences
    next_of_term = question.next_questions_of_terms.get(difference.term or "", question.next_question)
    return [*sentences, difference.next_question or next_of_term]


def _find_difference(question: Question, typed: sp.Expr, typed_values: values.Values) -> Difference:
    try:
        return difference_between(question, typed, typed_values)
    except terms.NotComparableError as error:
        return Difference([str(error)])


def _find_hint(mistakes: values.Mistakes, typed_values: values.Values) -> str | None:
    return next((hint for hint, wrong in mistakes if values.agree(typed_values, wrong)), None)


def _explain_body_mistake(question: Question, typed_values: values.Values) -> str | None:
    """Return the hint about a mistake in a body that leads to this answer, such as a wrong velocity, or None."""
    hint = _find_hint(question.values_of_body_mistakes, typed_values)
    if hint or not question.is_about_one_body:
        return hint
    hint_without_half = _find_hint(question.values_of_body_mistakes, tuple(value / 2 for value in typed_values))
    if hint_without_half:
        return _("{hint} A factor ½ is missing as well.").format(hint=hint_without_half)
    return None


def _explain_rounding(question: Question, typed: sp.Expr) -> str | None:
    """Return a hint if a decimal number in the answer is a rounded exact number, else None."""
    numbers = values.find_decimals(typed)
    if not numbers or question.kind == EQUATION:
        return None
    units = values.compute_rounding_error(typed, question.right_values)
    if units is not None:
        if units <= _HALF:
            return _("An exact number agrees with your decimal number to the last digit. What is the exact number?")
        return _("The last digit of your decimal number is off by one unit. What is the exact number?")
    return _explain_rounded_mistake(question, typed, min(map(_count_significant_digits, numbers)))


def _count_significant_digits(decimal: sp.Symbol) -> int:
    return len(decimal.name.replace(".", "").lstrip("0"))


def _explain_rounded_mistake(question: Question, typed: sp.Expr, digits: int) -> str | None:
    """Return the hint if the decimal number is the rounded result of exactly one mistake, else None."""
    mistakes: list[tuple[str, values.Values]] = []
    if digits >= _DIGITS_FOR_SLIPS:
        mistakes += question.values_of_slips
    if digits >= _DIGITS_FOR_BODIES:
        mistakes += question.values_of_body_mistakes
    hints = []
    for hint, wrong in mistakes:
        units = values.compute_rounding_error(typed, wrong)
        if units is not None and units <= _HALF:
            hints.append(hint)
    if len(hints) == 1:
        return _("Your decimal number agrees to the last digit with this case. {hint}").format(hint=hints[0])
    return None


def _explain_foreign_names(question: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about the names that do not belong in the answer, None if there are none."""
    expected = leaves(question.right)
    others = {name: symbol for name, symbol in SYMBOLS.items() if name != "eps" and symbol not in expected}
    has_free_ratio = SYMBOLS["eps"] in expected
    foreign = [
        name for name, symbol in others.items() if values.depends_on(typed, symbol, has_free_ratio=has_free_ratio)
    ]
    if not foreign:
        return None
    if question.name == "potential_energy" and foreign in (["X"], ["Phi"]):
        spring = _("Your answer depends on {name}, but {name} does not deform the spring.")
        return spring.format(name=terms.join_names(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=terms.join_names(foreign), quantity=question.quantity)


def _explain_wrong_unit(question: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about a wrong unit of the answer, None if the unit is right."""
    right = values.find_unit(question.right)
    quantity = question.quantity
    try:
        unit = values.find_unit(typed)
    except values.DifferentUnitsError as error:
        # The unit of a plain number is empty.
        first, second = error.args
        if not (first and second):
            return _("You add a plain number to a term with the unit {unit}.").format(unit=first or second)
        return _("You add terms with different units, {one} and {other}.").format(one=first, other=second)
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
