"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from ramanujan.answers import terms
from ramanujan.answers.grammar import SYMBOLS, TEXTBOOK, UnreadableError, leaves, not_known, parse, replaced
from ramanujan.answers.questions import (
    MOTION,
    NUMBER,
    POLYNOMIAL,
    QUESTIONS,
    allowed_names,
    answer,
    asked,
    longest_form,
    right_terms,
    right_values,
    wrong_values,
)
from ramanujan.answers.simplicity import to_simplify
from ramanujan.answers.values import (
    POINTS,
    DifferentUnitsError,
    NegativeRootError,
    Values,
    agree,
    at_points,
    decimals,
    depends_on,
    evaluate,
    point,
    rational_ratio,
    square_root,
    unit,
    units_off,
)
from ramanujan.numerals import number as written
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
    formula counts as unsimplified if something in it can still be simplified, or if it is longer than the derived one
    and its expanded and factored forms.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    try:
        typed = parse(text)
        return _verdict(question, _without_letters(question, typed), _letters_in(typed))
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except NegativeRootError:
        return Verdict("unreadable", _("Your formula contains a root that is not real for all masses and motions."))
    except ArithmeticError:
        return Verdict("unreadable", _("Your formula divides by zero."))


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
    given, right = at_points(typed), right_values(question)
    if not agree(given, right):
        return Verdict("wrong", " ".join(_advice(question, typed, given)))
    if letters:
        asks = (asked(question).letters[letter][1] for letter in letters)
        return Verdict("unsimplified", " ".join([_("Right so far!"), *asks]))
    own = allowed_names(question)
    needless = [name for name, symbol in SYMBOLS.items() if symbol in leaves(typed) and name not in own]
    if needless:
        to_do = _("The formula can be written without {names}.").format(names=terms.listed(needless))
    else:
        to_do = to_simplify(typed, answer(question), longest_form(question))
    if to_do:
        return Verdict("unsimplified", _("Right! {what_is_left}").format(what_is_left=to_do))
    return Verdict("right", _("Right!"))


def _advice(question: str, typed: sp.Expr, given: Values) -> Iterator[str]:
    """Yield what was found, then the question that leads to the next step."""
    leads_on = asked(question).leads_on
    if not any(given):
        yield _("Your answer is zero.")
        yield leads_on
        return
    known = _known_mistake(question, given) or _rounded(question, typed)
    if known:
        yield known
        return
    wrong_unit = _wrong_unit(question, typed)
    if wrong_unit:
        yield wrong_unit
    own = leaves(answer(question))
    foreign = [name for name in terms.NAMES if _depends(typed, name) and SYMBOLS[name] not in own]
    if foreign:
        yield _depends_on(question, foreign)
    try:
        exact = terms.exact(typed)
    except terms.NotComparableError:
        if not (wrong_unit or foreign):
            yield _("Your answer differs from the right one. It cannot be compared term by term.")
        yield leads_on
        return
    term, sentences = _differences(question, typed, given, exact)
    # If the unit is wrong as a whole, every term is wrong, and a list of them says nothing.
    if term is not None or not (wrong_unit or foreign):
        yield from sentences
    yield asked(question).hints.get(term or "", leads_on)


def _depends(typed: sp.Expr, name: str) -> bool:
    symbol = SYMBOLS[name]
    present = leaves(typed)
    through = SYMBOLS["eps"] in present and name in ("m", "m'")
    return (symbol in present or through) and depends_on(typed, symbol)


def _known_mistake(question: str, given: Values) -> str | None:
    for hint, values in wrong_values(question):
        if agree(given, values):
            return hint
    if asked(question).variables == MOTION:
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
    if found == right:
        return None
    if not found:
        sentence = _("Your answer is a plain number, but {quantity} has the unit {expected}.")
    elif not right:
        sentence = _("Your answer has the unit {yours}, but {quantity} is a plain number.")
    else:
        sentence = _("Your answer has the unit {yours}, but {quantity} has the unit {expected}.")
    return sentence.format(yours=found, expected=right, quantity=quantity)


def _differences(question: str, typed: sp.Expr, given: Values, exact: terms.Exact) -> tuple[str | None, list[str]]:
    """Return the term that differs, if there is only one, and sentences about the difference."""
    it = asked(question)
    if it.kind == NUMBER:
        return None, [*_as_number(question, given, exact), *_as_mass_ratio(exact, given[0])]
    ratio = exact.over(right_terms(question))
    if it.kind == POLYNOMIAL:
        differences = terms.term_by_term(exact, right_terms(question), it.variables)
        if differences is None:
            if it.variables == MOTION:
                return "", [_("In your answer a velocity or an angle is below a fraction line or under a root.")]
            return "", [_("In your answer a mass or a length is below a fraction line or under a root.")]
        if len(differences) > 1 and not ratio.names.intersection(MOTION) and (multiple := terms.multiple(ratio)):
            return None, multiple
        return differences[0][0] if len(differences) == 1 else None, terms.in_short(differences)
    if multiple := terms.multiple(ratio):
        return None, multiple
    if exact.irrational:
        return None, [_("Your answer contains a root. The right one has none.")]
    return None, terms.as_fraction(exact.rational, right_terms(question)) or _for_special_masses(question, typed)


def _for_special_masses(question: str, typed: sp.Expr) -> list[str]:
    """Return for which masses the answer is right, what it does not depend on, or that it is wrong even for m′ = m."""
    right, m, m_prime = answer(question), SYMBOLS["m"], SYMBOLS["m'"]
    cases = (
        ({m_prime: POINTS[0][m]}, _("Your answer is right for equal masses, m′ = m, but not for other masses.")),
        ({m_prime: Fraction(0)}, _("Your answer is right for m′ = 0, so the error is in a term with m′.")),
        ({m: Fraction(0)}, _("Your answer is right for m = 0, so the error is in a term with m.")),
    )
    found = []
    for masses, sentence in cases:
        known = POINTS[0] | masses
        known[SYMBOLS["eps"]] = known[m_prime] / known[m] if known[m] else Fraction(0)
        try:
            yours, theirs = (evaluate(formula, known, square_root) for formula in (typed, right))
        except ArithmeticError:
            continue
        if agree((yours,), (theirs,)):
            return [sentence]
        found.append(sentence)
    missing = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(right) and not _depends(typed, name)]
    if missing:
        sentence = _("Your answer does not depend on {names}, but {quantity} does.")
        return [sentence.format(names=terms.listed(missing), quantity=asked(question).quantity)]
    # A decimal number may be right to its digits there.
    return [] if decimals(typed) else [_("Your answer is wrong even for equal masses, m′ = m.")]


def _as_number(question: str, given: Values, exact: terms.Exact) -> list[str]:
    """Return how many times the right number the given one is, or which of its parts is right."""
    times = rational_ratio(given, right_values(question))
    if times is not None:
        return terms.multiple(terms.Exact(terms.number(times)))
    right = terms.exact(answer(question))
    if (exact.irrational, exact.radicand) == (right.irrational, right.radicand):
        return [_("The part of your answer with the root is right. The part without the root is not.")]
    if exact.rational == right.rational:
        return [_("The part of your answer without the root is right. The part with the root is not.")]
    return []


def _as_mass_ratio(exact: terms.Exact, ratio: object) -> Iterator[str]:
    """Yield the frequency of the machine with the given mass ratio."""
    if exact.names:
        return
    if ratio <= 0:
        yield _("A ratio of two masses is positive.")
        return
    one = Fraction(1)
    known = point(m=one, k=one, **{"m'": ratio})
    frequency = evaluate(answer("natural_frequency_squared"), known, square_root)
    shown, difference = float(ratio), float(abs(frequency - 1))
    if difference < 1e-5:
        close = _("With ε = {ratio}, Ω² and k/m differ by {difference} k/m, not by zero.")
        yield close.format(ratio=written(shown, 12, strip=True), difference=written(difference, 4))
    else:
        far = _("With ε = {ratio} you get Ω² = {frequency} k/m.")
        yield far.format(ratio=written(shown, 6, strip=True), frequency=written(float(frequency), 6, strip=True))
