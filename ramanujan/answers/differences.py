"""What is said of a wrong answer that no typical mistake gives: which term differs, for which masses it is right."""

from collections.abc import Iterator

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.formulas import leaves
from ramanujan.answers.questions import EQUATION, NUMBER, POLYNOMIAL, Question, question
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.values import POINTS, Values, agree, decimals, depends_on, evaluate, point, rational_ratio
from ramanujan.numerals import number as written
from ramanujan.translation import _


def differences(it: Question, typed: sp.Expr, given: Values) -> tuple[str | None, list[str]]:
    """Return the term that differs, if there is only one, and sentences about the difference.

    Raises
    ------
    terms.NotComparableError : the answer cannot be written out term by term.
    """
    if it.kind == NUMBER:
        return None, [*_as_number(it, given), *_as_mass_ratio(typed, given[0])]
    exact, right = it.terms(typed), it.right_terms
    if it.kind == EQUATION:
        differences = terms.as_equation(exact, right, it.variables)
        if not differences:
            return None, [_("No term of your equation is in the right ratio to another one.")]
        return None, [_("Bring all terms to the left side and compare them."), *terms.in_short(differences)]
    ratio = exact / right
    if it.kind == POLYNOMIAL:
        differences = terms.term_by_term(exact, right, it.variables)
        if differences is None:
            if it.variables == MOTION:
                return "", [_("In your answer a velocity or an angle is below a fraction line.")]
            return "", [_("In your answer a mass or a length is below a fraction line.")]
        if len(differences) > 1 and not terms.names_in(ratio).intersection(MOTION) and (of := terms.multiple(ratio)):
            return None, of
        return differences[0][0] if len(differences) == 1 else None, terms.in_short(differences)
    return None, terms.multiple(ratio) or terms.as_fraction(exact, right) or _for_special_masses(it, typed)


def _for_special_masses(it: Question, typed: sp.Expr) -> list[str]:
    """Return for which masses the answer is right, what it does not depend on, or that it is wrong even for m′ = m."""
    right, m, m_prime = it.right, SYMBOLS["m"], SYMBOLS["m'"]
    cases = (
        ({m_prime: POINTS[0][m]}, _("Your answer is right for equal masses, m′ = m, but not for other masses.")),
        ({m_prime: 0}, _("Your answer is right for m′ = 0, so the error is in a term with m′.")),
        ({m: 0}, _("Your answer is right for m = 0, so the error is in a term with m.")),
    )
    found = []
    for masses, sentence in cases:
        known = POINTS[0] | masses
        known[SYMBOLS["eps"]] = known[m_prime] / known[m] if known[m] else 0
        try:
            yours, theirs = (evaluate(formula, known) for formula in (typed, right))
        except ArithmeticError:
            continue
        if agree((yours,), (theirs,)):
            return [sentence]
        found.append(sentence)
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(right)]
    missing = [name for name in needed if not depends_on(typed, SYMBOLS[name])]
    if missing:
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        return [sentence.format(names=terms.listed(missing), quantity=it.quantity)]
    # A decimal number may be right to its digits there.
    return [] if decimals(typed) else [_("Your answer is wrong even for equal masses, m′ = m.")]


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
