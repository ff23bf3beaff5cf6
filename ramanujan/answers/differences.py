"""The account of a wrong answer that no typical mistake gives: simple accounts first, then single terms."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.formulas import leaves
from ramanujan.answers.questions import EQUATION, NUMBER, POLYNOMIAL, Question, question
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.terms import Compared, Differences
from ramanujan.answers.values import POINTS, Values, agree, decimals, depends_on, evaluate, point, rational_ratio
from ramanujan.numerals import number as written
from ramanujan.translation import _


@dataclass(frozen=True)
class Difference:
    """Sentences about how an answer differs from the right one.

    Parameters
    ----------
    sentences : the result of the comparison
    term : product of names, as shown, if it alone differs; empty for the constant term, None if there is no such term
    is_slip : whether a slip of the pen explains the difference: a sign, a factor, a missing term or letter
    is_whole : whether the sentences explain the whole answer, its unit too
    asks : the next question, if another one is better than that of the question or of the term
    """

    sentences: list[str]
    term: str | None = None
    is_slip: bool = False
    is_whole: bool = False
    asks: str = ""


def difference(it: Question, typed: sp.Expr, given: Values) -> Difference:
    """Return how an answer differs from the right one.

    Raises
    ------
    terms.NotComparableError : the answer cannot be written out term by term.
    """
    if it.kind == NUMBER:
        return Difference([*_as_number(it, given), *_as_mass_ratio(typed, given[0])])
    if it.kind == EQUATION:
        return _of_equation(it, typed)
    compared = it.compared(typed)
    if account := _of_whole_formula(it, compared):
        return account
    if it.kind == POLYNOMIAL:
        return _of_polynomial(it, compared)
    return _of_quotient(it, typed, compared)


def _of_equation(it: Question, typed: sp.Expr) -> Difference:
    gives_value = it.variables == ("eps",) and _is_solved(typed)
    found = None
    try:
        found = it.compared(typed).of_equation(it.variables)
    except terms.NotComparableError:
        if not gives_value:
            raise
    # A single missing term explains more.
    if gives_value and not (found and len(found) == 1):
        value = _("Your equation gives ε a value. The question asks for the quadratic equation that ε satisfies.")
        return Difference([value], is_whole=True)
    if not found:
        return Difference([_("No term of your equation is in the right ratio to another one.")])
    return _listed(found, _("Bring all terms to the left side and compare them."))


def _is_solved(typed: sp.Expr) -> bool:
    """Tell whether an equation consists of ε, with either sign, and one other term or side without ε."""
    if not typed.is_Add or len(typed.args) != 2:
        return False
    left, right = (leaves(side) - {sp.S.NegativeOne} for side in typed.args)
    ratio = {SYMBOLS["eps"]}
    return ratio in (left, right) and left.isdisjoint(right)


def _of_whole_formula(it: Question, compared: Compared) -> Difference | None:
    """Return the simple factor between the given formula and the right one, or its reciprocal."""
    if terms.shown_factor(compared.right) is not None:
        # Any two products of names differ by a simple factor.
        return None
    ratio = compared.given / compared.right
    of_motion = it.kind == POLYNOMIAL and terms.names_in(ratio).intersection(MOTION)
    if not of_motion and (multiple := terms.multiple(ratio)):
        return Difference(multiple, is_slip=not terms.names_in(ratio))
    factor = terms.shown_factor(compared.given * compared.right)
    if factor is None:
        return None
    reciprocal = _("Apart from the factor {factor}, this is the reciprocal of the right answer.")
    return Difference([reciprocal.format(factor=factor)], is_whole=True)


def _of_polynomial(it: Question, compared: Compared) -> Difference:
    found = compared.differences(it.variables)
    if found is None:
        if it.variables == MOTION:
            return Difference([_("In your answer a velocity or an angle is below a fraction line.")], "")
        return Difference([_("In your answer a mass or a length is below a fraction line.")], "")
    opposite = replace(compared, given=-compared.given).differences(it.variables)
    if len(opposite) == 1 < len(found):
        return _listed(opposite, _("Multiply your answer by −1. Then only one term differs."))
    return _listed(found)


def _listed(found: Differences, *lead: str) -> Difference:
    """Return sentences about single terms, after a sentence that says how to compare."""
    sentences = [*lead, *terms.in_short(found)]
    if len(found) > 1:
        return Difference(sentences)
    (only,) = found
    asks = _("Which sign does each of these terms have?") if only.cancels else ""
    return Difference(sentences, None if lead else only.term, only.is_slip, asks=asks)


def _of_quotient(it: Question, typed: sp.Expr, compared: Compared) -> Difference:
    """Return how two quotients differ: in a name, or in terms above or below the fraction line."""
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(it.right)]
    if missing := [name for name in needed if not depends_on(typed, SYMBOLS[name])]:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block; {names} are symbols.
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        independent = sentence.format(names=terms.listed(missing), quantity=it.quantity)
        return Difference([independent, *_for_special_masses(it, typed)[:1]], is_slip=True)
    if found := compared.of_fraction():
        sentence, differing = found
        return replace(_listed(differing, sentence), is_slip=len(differing) == 1 and differing[0].is_slip)
    # A decimal number may be right to its digits there.
    unequal = [] if decimals(typed) else [_("Your answer is wrong even for equal masses, m′ = m.")]
    return Difference(_for_special_masses(it, typed) or unequal)


def _for_special_masses(it: Question, typed: sp.Expr) -> list[str]:
    """Return for which masses the answer is right, and where the error is then."""
    m, m_prime = SYMBOLS["m"], SYMBOLS["m'"]
    cases = (
        ({m_prime: POINTS[0][m]}, [_("Your answer is right for equal masses, m′ = m, but not for other masses.")]),
        ({m_prime: 0}, [_("Your answer is right for m′ = 0."), _("So the error is in a term with m′.")]),
        ({m: 0}, [_("Your answer is right for m = 0."), _("So the error is in a term with m.")]),
    )
    for masses, sentences in cases:
        known = POINTS[0] | masses
        known[SYMBOLS["eps"]] = known[m_prime] / known[m] if known[m] else 0
        try:
            yours, theirs = (evaluate(formula, known) for formula in (typed, it.right))
        except ArithmeticError:
            continue
        if agree((yours,), (theirs,)):
            return sentences
    return []


def _as_number(it: Question, given: Values) -> list[str]:
    """Return the quotient of the given number and the right one, or which part of the number is right."""
    right = it.right_values
    times = rational_ratio(given, right)
    if times is not None:
        return terms.multiple(terms.FIELD(times.numerator) / times.denominator)
    (yours, *_same), (theirs, *_same), one = given, right, (1,)
    without = evaluate(it.right.expand().as_independent(sp.Pow)[0], POINTS[0])
    if rational_ratio((yours - theirs,), one) is not None:
        return [_("The part of your answer with the root is right. The part without the root is not.")]
    if rational_ratio((yours,), one) is None and rational_ratio(((yours - without) ** 2,), one) is not None:
        return [_("The part of your answer without the root is right. The part with the root is not.")]
    return []


def _as_mass_ratio(typed: sp.Expr, ratio: object) -> Iterator[str]:
    """Yield the frequency of the machine with the given mass ratio."""
    if any(depends_on(typed, symbol) for symbol in SYMBOLS.values()):
        return
    if ratio <= 0:
        yield _("A ratio of two masses is positive.")
        return
    known = point(m=1, k=1, **{"m'": ratio})
    frequency = evaluate(question("natural_frequency_squared").right, known)
    shown, difference = float(ratio), float(abs(frequency - 1))
    if difference < 1e-5:
        close = _("With ε = {ratio}, Ω² and k/m differ by {difference} k/m, not by zero.")
        yield close.format(ratio=written(shown, 12, strip=True), difference=written(difference, 4))
    else:
        far = _("With ε = {ratio} you get Ω² = {frequency} k/m.")
        yield far.format(ratio=written(shown, 6, strip=True), frequency=written(float(frequency), 6, strip=True))
