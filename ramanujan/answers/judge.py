"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from dataclasses import dataclass

import sympy as sp

from ramanujan.answers import terms, values
from ramanujan.answers.differences import Difference, find_difference, join_names
from ramanujan.answers.grammar import parse, parse_equation
from ramanujan.answers.questions import EQUATION, QUESTIONS, Question, find_question
from ramanujan.answers.spelling import SYMBOLS, TEXTBOOK, UnknownNameError, UnreadableError
from ramanujan.answers.typed_formulas import leaves, length, replace_letters
from ramanujan.text.translation import _, ngettext

_CLOSE, _CLOSE_TO_SLIP, _CLOSE_TO_BODY = 1e-2, 1e-3, 1e-5
"""Relative differences within which a decimal number is close to the right value, or to the result of a mistake.

Mistakes in bodies have many results, so only five digits distinguish them.
"""

_EQUAL = 1e-50
"""A relative difference below which the decimal number is exact."""

_FARTHER = 20
"""How many times as far away the results of all other mistakes must be."""


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises.

    Two formulas are equal if they are the same fraction, or agree to 50 digits if one contains a root. A right formula
    counts as unsimplified if it contains a needless symbol. It is also unsimplified if it is longer than every form of
    the derived formula: as derived, factored, or expanded.

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
        letters = [letter for letter in TEXTBOOK.values() if letter in leaves(typed)]
        return _compare(question, _replace_letters(question, typed, letters), letters)
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


def _replace_letters(question: Question, typed: sp.Expr, letters: list[sp.Symbol]) -> sp.Expr:
    """Replace v, I, ω and x by their meanings.

    Raises
    ------
    UnreadableError : the question does not use one of the letters.
    """
    for letter in letters:
        if letter not in question.letters:
            # A student who types ω in another question usually means Ω.
            if letter == TEXTBOOK["omega"]:
                raise UnreadableError(_("Type only the right side of the equation: a formula without Ω."))
            raise UnknownNameError(letter.name)
    meanings = {letter: meaning for letter, (meaning, _next_question) in question.letters.items()}
    return replace_letters(typed, meanings)


def _compare(question: Question, typed: sp.Expr, letters: list[sp.Symbol]) -> Verdict:
    answer = question.read(typed)
    if not question.are_equal(answer, question.right_formula):
        if _has_right_numerator(question, answer):
            return Verdict("unsimplified", _("Right so far! What do you get if you multiply by the denominator?"))
        return Verdict("wrong", " ".join(_explain(question, answer)))
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
        return Verdict("unsimplified", sentence.format(names=join_names(needless)))
    may_be_long = question.accepts_any_form or question.kind == EQUATION
    if not may_be_long and length(typed) > question.longest_form:
        return Verdict("unsimplified", _("Right! The formula can be written shorter."))
    return Verdict("right", _("Right!"))


def _has_right_numerator(question: Question, answer: values.Formula) -> bool:
    """Return whether the numerator of an equation is the right one, up to a factor without the variables."""
    if question.kind != EQUATION or not answer.fraction:
        return False
    factor = terms.FIELD(answer.fraction.numer) / question.right_formula.fraction
    return terms.find_names(factor).isdisjoint(question.variables)


def _explain(question: Question, answer: values.Formula) -> list[str]:
    """Return sentences about a wrong answer, the last one with the next question.

    The first explanation counts, in this order: a known slip, a decimal number, a difference of the whole formula, a
    mistake in a body. Without such an explanation, the sentences are about the unit, the names and one term.
    """
    if answer.is_zero and question.kind == EQUATION:
        return [_("Both sides of your equation are equal."), question.next_question]
    if answer.is_zero:
        return [_("Your answer is zero."), question.next_question]
    hint = _find_hint(question, question.slips, answer) or _explain_decimal(question, answer)
    if hint:
        return [hint]
    difference = find_difference(question, answer)
    if not _is_explained(question, difference):
        hint = _explain_body_mistake(question, answer)
        if hint:
            return [hint]
    return _explain_difference(question, answer.expression, difference)


def _is_explained(question: Question, difference: Difference | None) -> bool:
    """Return whether a difference explains an answer better than a mistake in a body.

    A missing term or a wrong sign is more likely than a mistake in a body. The energy of one body is an exception: a
    wrong sign in it usually comes from a wrong velocity.
    """
    if difference is None:
        return False
    return difference.is_complete or (difference.is_slip and not question.is_about_one_body)


def _explain_difference(question: Question, typed: sp.Expr, difference: Difference | None) -> list[str]:
    """Return sentences about the unit, the names and the term of a wrong answer, then the next question."""
    sentences = []
    if not (difference and difference.is_complete):
        faults = (_explain_wrong_unit(question, typed), _explain_foreign_names(question, typed))
        sentences = [fault for fault in faults if fault]
    # If the unit or the names are wrong, the whole answer is, and a factor does not help.
    if difference and (difference.term is not None or not sentences):
        sentences.append(difference.sentence)
    if not sentences:
        sentences = [_("This is not the right answer.")]
    next_question = question.next_question
    if difference and difference.term:
        next_question = question.next_questions_of_terms.get(difference.term, next_question)
    return [*sentences, next_question]


def _find_hint(question: Question, mistakes: values.Mistakes, answer: values.Formula) -> str | None:
    return next((hint for hint, wrong in mistakes if question.are_equal(answer, wrong)), None)


def _explain_body_mistake(question: Question, answer: values.Formula) -> str | None:
    """Return the hint about a mistake in a body that leads to this answer, such as a wrong velocity, or None."""
    hint = _find_hint(question, question.body_mistakes, answer)
    if hint or not question.is_about_one_body:
        return hint
    half = question.read(sp.Mul(sp.S.Half, answer.expression, evaluate=False))
    hint_without_half = _find_hint(question, question.body_mistakes, half)
    if hint_without_half:
        return _("{hint} A factor ½ is missing as well.").format(hint=hint_without_half)
    return None


def _explain_decimal(question: Question, answer: values.Formula) -> str | None:
    """Return a hint if an answer with a decimal number is close to the right one or to the result of a mistake."""
    if not answer.has_decimals or question.kind == EQUATION:
        return None
    if values.find_distance(answer.values, question.right_formula.values) < _CLOSE:
        return _("Your answer is close to the exact value. Type it exactly, with a fraction or a root.")
    hint = _find_nearest_hint(question.slips, answer, _CLOSE_TO_SLIP) or _find_nearest_hint(
        question.body_mistakes, answer, _CLOSE_TO_BODY
    )
    return _("Your decimal number is close to this case. {hint}").format(hint=hint) if hint else None


def _find_nearest_hint(mistakes: values.Mistakes, answer: values.Formula, closest: float) -> str | None:
    """Return the hint about the only mistake with a result near the answer, None without such a mistake."""
    distances = sorted((values.find_distance(answer.values, wrong.values), hint) for hint, wrong in mistakes)
    if not distances:
        return None
    nearest, hint = distances[0]
    if not _EQUAL < nearest < closest:
        return None
    has_rival = any(distance < _FARTHER * nearest for distance, other in distances if other != hint)
    return None if has_rival else hint


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
        return spring.format(name=join_names(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=join_names(foreign), quantity=question.quantity)


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
