"""What is said of a wrong answer that no typical mistake gives: which term differs, for which masses it is right."""

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp
from sympy.polys.fields import FracElement

from ramanujan.answers import terms
from ramanujan.answers.formulas import leaves
from ramanujan.answers.questions import EQUATION, NUMBER, QUOTIENT, Question, question
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.values import POINTS, Values, agree, decimals, depends_on, evaluate, point, rational_ratio
from ramanujan.numerals import number as written
from ramanujan.translation import _


@dataclass(frozen=True)
class Difference:
    """Sentences about how an answer differs from the right one.

    Parameters
    ----------
    sentences : what was found
    term : product of names, as shown, if it alone differs; empty for the constant term, None if there is no such term
    is_slip : whether a slip of the pen is enough to explain it: a sign, a factor, a missing term or letter
    """

    sentences: list[str]
    term: str | None = None
    is_slip: bool = False


def difference(it: Question, typed: sp.Expr, given: Values) -> Difference:
    """Return how an answer differs from the right one.

    Raises
    ------
    terms.NotComparableError : the answer cannot be written out term by term.
    """
    if it.kind == NUMBER:
        return Difference([*_as_number(it, given), *_as_mass_ratio(typed, given[0])])
    exact, right = it.terms(typed), it.right_terms
    ratio = exact / right
    if it.kind == QUOTIENT:
        return _of_quotients(it, typed, exact, right)
    if it.kind == EQUATION:
        found = terms.as_equation(exact, right, it.variables)
        if not found:
            return Difference([_("No term of your equation is in the right ratio to another one.")])
        lead = [_("Bring all terms to the left side and compare them.")]
    else:
        found, lead = terms.term_by_term(exact, right, it.variables), []
        if found is None:
            if it.variables == MOTION:
                return Difference([_("In your answer a velocity or an angle is below a fraction line.")], "")
            return Difference([_("In your answer a mass or a length is below a fraction line.")], "")
        if len(found) > 1 and not terms.names_in(ratio).intersection(MOTION) and (of := terms.multiple(ratio)):
            return Difference(of, is_slip=not terms.names_in(ratio))
    sentences = lead + terms.in_short(found)
    if len(found) > 1:
        return Difference(sentences)
    return Difference(sentences, None if lead else found[0].term, found[0].is_slip)


def _of_quotients(it: Question, typed: sp.Expr, exact: FracElement, right: FracElement) -> Difference:
    """Return how two quotients differ: in a factor, in a name, in terms above or below the fraction line."""
    ratio = exact / right
    if multiple := terms.multiple(ratio):
        return Difference(multiple, is_slip=not terms.names_in(ratio))
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(it.right)]
    if missing := [name for name in needed if not depends_on(typed, SYMBOLS[name])]:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block; {names} are symbols.
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        said = sentence.format(names=terms.listed(missing), quantity=it.quantity)
        return Difference([said, *_for_special_masses(it, typed)[:1]], is_slip=True)
    if found := terms.as_fraction(exact, right):
        sentence, differing = found
        return Difference([sentence, *terms.in_short(differing)], is_slip=len(differing) == 1 and differing[0].is_slip)
    # A decimal number may be right to its digits there.
    unequal = [] if decimals(typed) else [_("Your answer is wrong even for equal masses, m′ = m.")]
    return Difference(_for_special_masses(it, typed) or unequal)


def _for_special_masses(it: Question, typed: sp.Expr) -> list[str]:
    """Return for which masses the answer is right, and what that says about the error."""
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
    """Return how many times the right number the given one is, or which of its parts is right."""
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
