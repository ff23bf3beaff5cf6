"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable."""

from dataclasses import dataclass

import sympy as sp

from ramanujan.answers import terms, values
from ramanujan.answers.differences import Difference, difference
from ramanujan.answers.formulas import leaves, length, replaced
from ramanujan.answers.grammar import parse, parse_equation
from ramanujan.answers.questions import EQUATION, QUESTIONS, Question
from ramanujan.answers.questions import question as asked
from ramanujan.answers.spelling import SYMBOLS, TEXTBOOK, UnknownNameError, UnreadableError
from ramanujan.translation import _, ngettext

_OF_SLIPS, _OF_BODIES = 3, 5
"""The fewest significant digits of a decimal that is compared with the results of slips, and of wrong bodies."""

_HALF = 0.5
"""The largest rounding error in units of the last digit."""


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises.

    Two formulas are equal if they agree at random points, to 1,150 digits. A right formula counts as unsimplified if
    it contains a symbol that it does not need, or if it is longer than the derived one, expanded and factored too.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    it = asked(question)
    try:
        typed = _typed(it, text)
        return _verdict(it, _without_letters(it, typed), _letters_in(typed))
    except UnknownNameError as error:
        may_use = _("You may use {names} and sqrt( ).").format(names=", ".join(it.accepted) or _("numbers"))
        return Verdict("unreadable", f"{error} {may_use}")
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except values.NegativeRootError:
        return Verdict("unreadable", _("Your formula contains a root that is not real for all masses and motions."))
    except ArithmeticError:
        return Verdict("unreadable", _("Your formula divides by zero."))


def _typed(it: Question, text: str) -> sp.Expr:
    """Return the formula that was typed, of an equation its left side minus its right side."""
    if it.kind != EQUATION:
        return parse(text)
    left, right = parse_equation(text)
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False) if right else left


def _letters_in(typed: sp.Expr) -> list[sp.Symbol]:
    return [letter for letter in TEXTBOOK.values() if letter in leaves(typed)]


def _without_letters(it: Question, typed: sp.Expr) -> sp.Expr:
    """Replace v, I, ω and x by their meanings; raise for a letter that the question does not use."""
    for letter in _letters_in(typed):
        if letter not in it.letters:
            refusal = _("Type only the right side of the equation: a formula without Ω.")
            raise UnreadableError(refusal) if letter == TEXTBOOK["omega"] else UnknownNameError(letter.name)
    return replaced(typed, {letter: meaning for letter, (meaning, _asks) in it.letters.items()})


def _verdict(it: Question, typed: sp.Expr, letters: list[sp.Symbol]) -> Verdict:
    given, right = it.values(typed), it.right_values
    if not values.agree(given, right):
        if _has_denominator(it, typed):
            return Verdict("unsimplified", _("Right so far! What do you get if you multiply by the denominator?"))
        return Verdict("wrong", " ".join(_advice(it, typed, given)))
    if letters:
        asks = (it.letters[letter][1] for letter in letters)
        return Verdict("unsimplified", " ".join([_("Right so far!"), *asks]))
    own = it.names
    needless = [name for name, symbol in SYMBOLS.items() if symbol in leaves(typed) and name not in own]
    if needless:
        sentence = _("Right! The formula can be written without {names}.")
        return Verdict("unsimplified", sentence.format(names=terms.listed(needless)))
    if not (it.any_form or it.kind == EQUATION) and length(typed) > it.longest_form:
        return Verdict("unsimplified", _("Right! The formula can be written shorter."))
    return Verdict("right", _("Right!"))


def _has_denominator(it: Question, typed: sp.Expr) -> bool:
    """Whether an equation is the right one divided by an expression that contains its variables."""
    if it.kind != EQUATION:
        return False
    try:
        numerator = terms.FIELD(it.terms(typed).numer)
    except terms.NotComparableError:
        return False
    factor = terms.names_in(numerator / it.right_terms)
    return bool(numerator) and factor.isdisjoint(it.variables)


def _advice(it: Question, typed: sp.Expr, given: values.Values) -> list[str]:
    """Return sentences about a wrong answer, the last one with the question that leads on.

    The first account that explains the answer is returned: a known slip or a rounded number, the whole formula or its
    cancelling terms, wrong bodies, and else the unit, the names and single terms.
    """
    if not any(given):
        zero = _("Both sides of your equation are equal.") if it.kind == EQUATION else _("Your answer is zero.")
        return [zero, it.leads_on]
    if hint := _first_hint(it.slips, given) or _rounded(it, typed):
        return [hint]
    found = _difference(it, typed, given)
    # A missing term or a wrong sign is more natural than a wrong body. In one body’s energy a wrong sign belongs to
    # the velocity, but terms that cancel were typed.
    is_explained = found.asks or found.is_whole or (found.is_slip and not it.of_one_body)
    if not is_explained and (hint := _wrong_bodies(it, given)):
        return [hint]
    faults = [] if found.is_whole else [_wrong_unit(it, typed), _foreign_names(it, typed)]
    sentences = [fault for fault in faults if fault]
    # If the unit is wrong as a whole, every term is wrong, and a list of terms does not help.
    if found.term is not None or not sentences:
        sentences += found.sentences
    return [*sentences, found.asks or it.of_terms.get(found.term or "", it.leads_on)]


def _difference(it: Question, typed: sp.Expr, given: values.Values) -> Difference:
    try:
        return difference(it, typed, given)
    except terms.NotComparableError as error:
        return Difference([str(error)])


def _first_hint(mistakes: values.Mistakes, given: values.Values) -> str | None:
    return next((hint for hint, wrong in mistakes if values.agree(given, wrong)), None)


def _wrong_bodies(it: Question, given: values.Values) -> str | None:
    known = _first_hint(it.altered, given)
    if known is None and it.of_one_body:
        known = _first_hint(it.altered, tuple(value / 2 for value in given))
        return known and _("{hint} A factor ½ is missing as well.").format(hint=known)
    return known


def _rounded(it: Question, typed: sp.Expr) -> str | None:
    """Return a hint if one decimal number of the answer is an exact one, rounded; else None."""
    numbers = values.decimals(typed)
    if not numbers or it.kind == EQUATION:
        return None
    off = values.units_off(typed, it.right_values)
    if off is not None:
        if off <= _HALF:
            return _("An exact number agrees with your decimal number to the last digit. What is the exact number?")
        return _("The last digit of your decimal number is off by one unit. What is the exact number?")
    digits = min(len(number.name.replace(".", "").lstrip("0")) for number in numbers)
    telling = (*(it.slips if digits >= _OF_SLIPS else ()), *(it.altered if digits >= _OF_BODIES else ()))
    offs = ((hint, values.units_off(typed, wrong)) for hint, wrong in telling)
    fits = [hint for hint, off in offs if off is not None and off <= _HALF]
    if len(fits) == 1:
        return _("Your decimal number agrees to the last digit with this case. {hint}").format(hint=fits[0])
    return None


def _foreign_names(it: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about the names on which the answer depends and the right one does not, if there are any."""
    own = leaves(it.right)
    others = {name: symbol for name, symbol in SYMBOLS.items() if name != "eps" and symbol not in own}
    of_ratio = SYMBOLS["eps"] in own
    foreign = [name for name, symbol in others.items() if values.depends_on(typed, symbol, of_ratio=of_ratio)]
    if not foreign:
        return None
    if it.name == "potential_energy" and foreign in (["X"], ["Phi"]):
        spring = _("Your answer depends on {name}, but {name} does not deform the spring.")
        return spring.format(name=terms.listed(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=terms.listed(foreign), quantity=it.quantity)


def _wrong_unit(it: Question, typed: sp.Expr) -> str | None:
    """Return a sentence about the unit of the answer, if it is not that of the right one."""
    right, quantity = values.unit(it.right), it.quantity
    try:
        found = values.unit(typed)
    except values.DifferentUnitsError as error:
        one, other = error.args
        if not (one and other):
            return _("You add a plain number to a term with the unit {unit}.").format(unit=one or other)
        return _("You add terms with different units, {one} and {other}.").format(one=one, other=other)
    if found == right or it.kind == EQUATION:
        return None
    if not found:
        # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block.
        sentence = _("Your answer is a plain number, but {quantity} has the unit {expected}.")
    elif not right:
        sentence = _("Your answer has the unit {yours}, but {quantity} is a plain number.")
    else:
        sentence = _("Your answer has the unit {yours}, but {quantity} has the unit {expected}.")
    return sentence.format(yours=found, expected=right, quantity=quantity)
