"""Differences between a wrong answer and the right one, for answers that no typical mistake explains.

A simple difference of the whole formula is reported first, differences of single terms otherwise.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.formulas import leaves
from ramanujan.answers.questions import EQUATION, NUMBER, POLYNOMIAL, Question
from ramanujan.answers.questions import question as question_named
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.terms import Compared, TermDifference
from ramanujan.answers.values import (
    POINTS,
    Number,
    Values,
    agree,
    decimals,
    depends_on,
    evaluate,
    point,
    rational_ratio,
)
from ramanujan.numerals import number as written
from ramanujan.translation import _


@dataclass(frozen=True)
class Difference:
    """Sentences about how an answer differs from the right one.

    Parameters
    ----------
    sentences : the result of the comparison
    term : the only term that differs, a product of names as shown; empty for the constant term, None for several terms
    is_slip : whether a slip of the pen explains the difference: a sign, a factor, a missing term or letter
    is_whole : whether the sentences explain the whole answer, including its unit
    next_question : replaces the next question of the term or of the whole question, if not empty
    """

    sentences: list[str]
    term: str | None = None
    is_slip: bool = False
    is_whole: bool = False
    next_question: str = ""


def difference_between(question: Question, typed: sp.Expr, given: Values) -> Difference:
    """Return how an answer differs from the right one.

    Raises
    ------
    terms.NotComparableError : the answer cannot be written out term by term.
    """
    if question.kind == NUMBER:
        return Difference([*_as_number(question, given), *_as_mass_ratio(typed, given[0])])
    if question.kind == EQUATION:
        return _of_equation(question, typed)
    compared = question.compared(typed)
    if account := _of_whole_formula(question, compared):
        return account
    if question.kind == POLYNOMIAL:
        return _of_polynomial(question, compared)
    return _of_quotient(question, typed, compared)


def _of_equation(question: Question, typed: sp.Expr) -> Difference:
    is_solved = question.variables == ("eps",) and _is_solved(typed)
    differences = None
    try:
        differences = question.compared(typed).of_equation(question.variables)
    except terms.NotComparableError:
        if not is_solved:
            raise
    # A single missing term explains more.
    if is_solved and not (differences and len(differences) == 1):
        value = _("Your equation gives ε a value. The question asks for the quadratic equation that ε satisfies.")
        return Difference([value], is_whole=True)
    if not differences:
        return Difference([_("No term of your equation is in the right ratio to another one.")])
    return _listed(differences, _("Bring all terms to the left side and compare them."))


def _is_solved(typed: sp.Expr) -> bool:
    """Return whether an equation has the form ε = value, with either sign of ε."""
    if not typed.is_Add or len(typed.args) != 2:
        return False
    left, right = (leaves(side) - {sp.S.NegativeOne} for side in typed.args)
    ratio = {SYMBOLS["eps"]}
    return ratio in (left, right) and left.isdisjoint(right)


def _of_whole_formula(question: Question, compared: Compared) -> Difference | None:
    """Return the simple factor between the given formula and the right one, or its reciprocal."""
    if terms.shown_factor(compared.right) is not None:
        # Any two products of names differ by a simple factor.
        return None
    ratio = compared.given / compared.right
    names = terms.names_in(ratio)
    has_motion = question.kind == POLYNOMIAL and names.intersection(MOTION)
    multiple = [] if has_motion else terms.multiple(ratio)
    if multiple:
        return Difference(multiple, is_slip=not names)
    factor = terms.shown_factor(compared.given * compared.right)
    if factor is None:
        return None
    reciprocal = _("Apart from the factor {factor}, this is the reciprocal of the right answer.")
    return Difference([reciprocal.format(factor=factor)], is_whole=True)


def _of_polynomial(question: Question, compared: Compared) -> Difference:
    differences = compared.differences(question.variables)
    if differences is None:
        if question.variables == MOTION:
            return Difference([_("In your answer a velocity or an angle is below a fraction line.")], "")
        return Difference([_("In your answer a mass or a length is below a fraction line.")], "")
    opposite = replace(compared, given=-compared.given).differences(question.variables)
    if opposite and len(opposite) == 1 < len(differences):
        return _listed(opposite, _("Multiply your answer by −1. Then only one term differs."))
    return _listed(differences)


def _listed(differences: list[TermDifference], introduction: str = "") -> Difference:
    """Return sentences about single terms, after a sentence on how to compare."""
    sentences = [introduction] if introduction else []
    sentences += terms.in_short(differences)
    if len(differences) > 1:
        return Difference(sentences)
    (only,) = differences
    next_question = _("Which sign does each of these terms have?") if only.cancels else ""
    return Difference(sentences, None if introduction else only.term, only.is_slip, next_question=next_question)


def _of_quotient(question: Question, typed: sp.Expr, compared: Compared) -> Difference:
    """Return how two quotients differ: in a name, or in terms above or below the fraction line."""
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(question.right)]
    missing = [name for name in needed if not depends_on(typed, SYMBOLS[name])]
    if missing:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block; {names} are symbols.
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        independent = sentence.format(names=terms.listed(missing), quantity=question.quantity)
        return Difference([independent, *_for_special_masses(question, typed)[:1]], is_slip=True)
    if half := compared.of_fraction():
        sentence, differences = half
        is_slip = len(differences) == 1 and differences[0].is_slip
        return replace(_listed(differences, sentence), is_slip=is_slip)
    sentences = _for_special_masses(question, typed)
    # An answer with a decimal number may be right for equal masses except for rounding.
    if not sentences and not decimals(typed):
        sentences = [_("Your answer is wrong even for equal masses, m′ = m.")]
    return Difference(sentences)


def _for_special_masses(question: Question, typed: sp.Expr) -> list[str]:
    """Return sentences about the special masses for which the answer is right, and which term then has the error."""
    m, m_prime = SYMBOLS["m"], SYMBOLS["m'"]
    cases = (
        ({m_prime: POINTS[0][m]}, [_("Your answer is right for equal masses, m′ = m, but not for other masses.")]),
        ({m_prime: 0}, [_("Your answer is right for m′ = 0."), _("So the error is in a term with m′.")]),
        ({m: 0}, [_("Your answer is right for m = 0."), _("So the error is in a term with m.")]),
    )
    for masses, sentences in cases:
        values = POINTS[0] | masses
        values[SYMBOLS["eps"]] = values[m_prime] / values[m] if values[m] else 0
        try:
            given, right = evaluate(typed, values), evaluate(question.right, values)
        except ArithmeticError:
            continue
        if agree((given,), (right,)):
            return sentences
    return []


def _as_number(question: Question, given: Values) -> list[str]:
    """Return the quotient of the given number and the right one, or which part of the number is right."""
    right = question.right_values
    times = rational_ratio(given, right)
    if times is not None:
        return terms.multiple(terms.FIELD(times.numerator) / times.denominator)
    # A number has the same value at all points.
    given_number, right_number = given[0], right[0]
    rational_part = evaluate(question.right.expand().as_independent(sp.Pow)[0], POINTS[0])
    if _is_rational(given_number - right_number):
        return [_("The part of your answer with the root is right. The part without the root is not.")]
    if not _is_rational(given_number) and _is_rational((given_number - rational_part) ** 2):
        return [_("The part of your answer without the root is right. The part with the root is not.")]
    return []


def _is_rational(number: Number) -> bool:
    return rational_ratio((number,), (1,)) is not None


def _as_mass_ratio(typed: sp.Expr, ratio: Number) -> Iterator[str]:
    """Yield a sentence with the frequency of the machine that has this mass ratio."""
    if any(depends_on(typed, symbol) for symbol in SYMBOLS.values()):
        return
    if ratio <= 0:
        yield _("A ratio of two masses is positive.")
        return
    values = point(m=1, k=1, **{"m'": ratio})
    frequency = evaluate(question_named("natural_frequency_squared").right, values)
    shown, difference = float(ratio), float(abs(frequency - 1))
    if difference < 1e-5:
        close = _("With ε = {ratio}, Ω² and k/m differ by {difference} k/m, not by zero.")
        yield close.format(ratio=written(shown, 12, strip=True), difference=written(difference, 4))
    else:
        far = _("With ε = {ratio} you get Ω² = {frequency} k/m.")
        yield far.format(ratio=written(shown, 6, strip=True), frequency=written(float(frequency), 6, strip=True))
