"""Differences between a wrong answer and the right one, for answers that no typical mistake explains.

A simple difference of the whole formula is reported first, differences of single terms otherwise.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.formulas import leaves, replace_letters
from ramanujan.answers.questions import EQUATION, NUMBER, POLYNOMIAL, Question, find_question
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.terms import Comparison, TermDifference
from ramanujan.answers.values import (
    POINTS,
    PreciseNumber,
    Values,
    agree,
    depends_on,
    evaluate,
    find_decimals,
    find_rational_ratio,
    make_point,
)
from ramanujan.numerals import number as format_number
from ramanujan.translation import _


@dataclass(frozen=True)
class Difference:
    """Sentences about how an answer differs from the right one.

    Parameters
    ----------
    sentences : the result of the comparison
    term : the only term that differs, a product of names as shown; empty for the constant term, None for several terms
    is_slip : whether a slip of the pen explains the difference: a sign, a factor, a missing term or letter
    is_complete : whether the sentences explain everything that is wrong, including a wrong unit
    next_question : replaces the next question of the term or of the whole question, if not empty
    """

    sentences: list[str]
    term: str | None = None
    is_slip: bool = False
    is_complete: bool = False
    next_question: str = ""


def difference_between(question: Question, typed: sp.Expr, typed_values: Values) -> Difference:
    """Return how an answer differs from the right one.

    Raises
    ------
    terms.NotComparableError : the answer cannot be written out term by term.
    """
    if question.kind == NUMBER:
        return Difference([*_compare_numbers(question, typed_values), *_test_mass_ratio(typed, typed_values[0])])
    if question.kind == EQUATION:
        return _compare_equations(question, typed)
    compared = question.compare(typed)
    difference = _compare_formulas(question, compared)
    if difference:
        return difference
    if question.kind == POLYNOMIAL:
        return _compare_polynomials(question, compared)
    return _compare_quotients(question, typed, compared)


def _compare_equations(question: Question, typed: sp.Expr) -> Difference:
    is_solved = question.variables == ("eps",) and _is_solved(typed)
    differences = None
    try:
        differences = question.compare(typed).equation_differences(question.variables)
    except terms.NotComparableError:
        if not is_solved:
            raise
    # A single wrong term explains more than the form of the equation.
    has_one_difference = differences is not None and len(differences) == 1
    if is_solved and not has_one_difference:
        value = _("Your equation gives ε a value. The question asks for the quadratic equation that ε satisfies.")
        return Difference([value], is_complete=True)
    if not differences:
        return Difference([_("No term of your equation is in the right ratio to another one.")])
    return _combine(differences, _("Bring all terms to the left side and compare them."))


def _is_solved(typed: sp.Expr) -> bool:
    """Return whether an equation has the form ε = value, with either sign of ε."""
    if not typed.is_Add or len(typed.args) != 2:
        return False
    left, right = (leaves(side) - {sp.S.NegativeOne} for side in typed.args)
    only_ratio = {SYMBOLS["eps"]}
    return only_ratio in (left, right) and left.isdisjoint(right)


def _compare_formulas(question: Question, compared: Comparison) -> Difference | None:
    """Return a difference by a simple factor from the right answer or from its reciprocal, otherwise None."""
    if terms.format_factor(compared.right) is not None:
        # Any two products of names differ by a simple factor.
        return None
    ratio = compared.typed / compared.right
    names = terms.find_names(ratio)
    # A factor with motion changes the terms of a polynomial, so single terms are compared instead.
    has_motion = question.kind == POLYNOMIAL and names.intersection(MOTION)
    sentences = [] if has_motion else terms.describe_multiple(ratio)
    if sentences:
        return Difference(sentences, is_slip=not names)
    factor = terms.format_factor(compared.typed * compared.right)
    if factor is None:
        return None
    reciprocal = _("Apart from the factor {factor}, this is the reciprocal of the right answer.")
    return Difference([reciprocal.format(factor=factor)], is_complete=True)


def _compare_polynomials(question: Question, compared: Comparison) -> Difference:
    differences = compared.differences(question.variables)
    if differences is None:
        if question.variables == MOTION:
            sentence = _("In your answer a velocity or an angle is below a fraction line.")
        else:
            sentence = _("In your answer a mass or a length is below a fraction line.")
        # With a term, even the empty one, the sentence is also shown if the unit is wrong.
        return Difference([sentence], term="")
    opposite = replace(compared, typed=-compared.typed).differences(question.variables)
    if opposite and len(opposite) == 1 and len(differences) > 1:
        return _combine(opposite, _("Multiply your answer by −1. Then only one term differs."))
    return _combine(differences)


def _combine(differences: list[TermDifference], introduction: str = "") -> Difference:
    """Return the differences of terms as one difference, after an introduction on how to compare."""
    sentences = [introduction] if introduction else []
    sentences += terms.summarize(differences)
    if len(differences) > 1:
        return Difference(sentences)
    (only,) = differences
    next_question = _("Which sign does each of these terms have?") if only.cancels else ""
    term = None if introduction else only.term
    return Difference(sentences, term=term, is_slip=only.is_slip, next_question=next_question)


def _compare_quotients(question: Question, typed: sp.Expr, compared: Comparison) -> Difference:
    """Return how a quotient differs from the right one: in a name, or in terms above or below the fraction line."""
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(question.right)]
    missing = [name for name in needed if not depends_on(typed, SYMBOLS[name])]
    if missing:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block; {names} are symbols.
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        independent = sentence.format(names=terms.join_names(missing), quantity=question.quantity)
        return Difference([independent, *_test_special_masses(question, typed)[:1]], is_slip=True)
    difference_in_one_part = compared.fraction_differences()
    if difference_in_one_part:
        sentence, differences = difference_in_one_part
        is_slip = len(differences) == 1 and differences[0].is_slip
        return replace(_combine(differences, sentence), is_slip=is_slip)
    sentences = _test_special_masses(question, typed)
    # An answer with a decimal number may be right for equal masses except for rounding.
    if not sentences and not find_decimals(typed):
        sentences = [_("Your answer is wrong even for equal masses, m′ = m.")]
    return Difference(sentences)


def _test_special_masses(question: Question, typed: sp.Expr) -> list[str]:
    """Return a sentence about special masses for which the answer is right, and one about the place of the error."""
    m, m_prime = SYMBOLS["m"], SYMBOLS["m'"]
    # In terms of m and m′, an answer with ε divides by zero for m = 0, so that case is skipped.
    in_masses = replace_letters(typed, {SYMBOLS["eps"]: m_prime / m})
    cases = (
        ({m_prime: POINTS[0][m]}, [_("Your answer is right for equal masses, m′ = m, but not for other masses.")]),
        ({m_prime: 0}, [_("Your answer is right for m′ = 0."), _("So the error is in a term with m′.")]),
        ({m: 0}, [_("Your answer is right for m = 0."), _("So the error is in a term with m.")]),
    )
    for masses, sentences in cases:
        values = POINTS[0] | masses
        try:
            typed_value, right_value = evaluate(in_masses, values), evaluate(question.right, values)
        except ArithmeticError:
            continue
        if agree((typed_value,), (right_value,)):
            return sentences
    return []


def _compare_numbers(question: Question, typed_values: Values) -> list[str]:
    """Return a sentence about the quotient of the typed and the right number, or about the part that is right."""
    right = question.right_values
    quotient = find_rational_ratio(typed_values, right)
    if quotient is not None:
        return terms.describe_multiple(terms.FIELD(quotient.numerator) / quotient.denominator)
    # The right number has the form p + r√n. If typed − right is rational, the part with the root is right.
    # If (typed − p)² is rational, p is right. A number has the same value at all points.
    typed_number, right_number = typed_values[0], right[0]
    without_root, _with_root = question.right.expand().as_independent(sp.Pow)
    rational_part = evaluate(without_root, POINTS[0])
    if _is_rational(typed_number - right_number):
        return [_("The part of your answer with the root is right. The part without the root is not.")]
    if not _is_rational(typed_number) and _is_rational((typed_number - rational_part) ** 2):
        return [_("The part of your answer without the root is right. The part with the root is not.")]
    return []


def _is_rational(number: PreciseNumber) -> bool:
    return find_rational_ratio((number,), (1,)) is not None


def _test_mass_ratio(typed: sp.Expr, ratio: PreciseNumber) -> Iterator[str]:
    """Yield a sentence with the frequency of the machine that has this mass ratio."""
    if any(depends_on(typed, symbol) for symbol in SYMBOLS.values()):
        return
    if ratio <= 0:
        yield _("A ratio of two masses is positive.")
        return
    values = make_point(m=1, k=1, **{"m'": ratio})
    frequency = evaluate(find_question("natural_frequency_squared").right, values)
    epsilon, difference = float(ratio), float(abs(frequency - 1))
    if difference < 1e-5:
        close = _("With ε = {ratio}, Ω² and k/m differ by {difference} k/m, not by zero.")
        yield close.format(ratio=format_number(epsilon, 12, strip=True), difference=format_number(difference, 4))
    else:
        far = _("With ε = {ratio} you get Ω² = {frequency} k/m.")
        yield far.format(
            ratio=format_number(epsilon, 6, strip=True), frequency=format_number(float(frequency), 6, strip=True)
        )
