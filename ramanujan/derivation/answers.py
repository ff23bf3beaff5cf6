"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable.

`QUESTIONS` lists the names of the questions, `question(name)` returns one, and `judge(name, text)` returns the verdict.
A verdict claims only what was computed exactly. Nothing that a student types reaches SymPy's own parser.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

from ramanujan.derivation import decimals, simplicity
from ramanujan.derivation.comparison import (
    MINUS_ONE,
    as_fraction,
    as_number,
    how_many_times,
    in_short,
    shown_factor,
    shown_name,
    term_by_term,
)
from ramanujan.derivation.expansion import NegativeRootError, NormalForm, TooLargeError, UncertainRootError, constant
from ramanujan.derivation.expressions import NAMES, Expression, length, names, numbers
from ramanujan.derivation.normal_form import minus, normal_form, over, times
from ramanujan.derivation.parser import UnreadableError, parse
from ramanujan.derivation.polynomials import VARIABLES
from ramanujan.derivation.questions import (
    MOTION,
    NUMBER,
    POLYNOMIAL,
    QUESTIONS,
    Question,
    allowed_names,
    answer,
    kind,
    leads_on,
    longest_form,
    quantity,
    question,
    right_form,
    variables,
    wrong_forms,
    wrong_values,
)
from ramanujan.derivation.units import unit_text, units
from ramanujan.numerals import number as written
from ramanujan.translation import _, ngettext

__all__ = ["QUESTIONS", "Question", "Verdict", "judge", "question"]

_MANY_TERMS, _TELLING_DIGITS = 60, 4
_DIVIDES_BY_ZERO = _("Your formula divides by zero.")
_NEGATIVE_ROOT = _("Your formula contains the root of a negative number.")


@dataclass(frozen=True)
class Verdict:
    """A verdict for a student: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises, whatever it is given.

    Two formulas are equal if their exact normal forms are. Where a formula has none, because it is too large or because
    a root may be one of a negative number, it is compared in 300 digits at random points. A right formula counts as
    unsimplified if it is longer than the derived one and its expanded and factored forms, or if something in it can
    still be simplified.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", _("There is no question of that name."))
    try:
        typed = parse(text)
        try:
            return _verdict(question, typed)
        except (TooLargeError, UncertainRootError):
            return _sampled(question, typed)
    except UnreadableError as error:
        return Verdict("unreadable", str(error))
    except NegativeRootError:
        return Verdict("unreadable", _NEGATIVE_ROOT)
    except ArithmeticError:
        return Verdict("unreadable", _DIVIDES_BY_ZERO)


def _verdict(question: str, typed: Expression) -> Verdict:
    given, right = normal_form(typed), right_form(question)
    if given == right or not (given.is_reduced or minus(given, right).numerators):
        to_do = _to_simplify(question, typed, given)
        if not to_do:
            return Verdict("right", _("Right!"))
        return Verdict("unsimplified", _("Right! {what_is_left}").format(what_is_left=to_do))
    return Verdict("wrong", " ".join(_advice(question, typed, given)))


def _sampled(question: str, typed: Expression) -> Verdict:
    """Return the verdict on a formula without a normal form."""
    try:
        values = decimals.values(typed)
    except decimals.RootOfNegativeError:
        return Verdict("unreadable", _("Your formula contains a root that is not real for all masses and motions."))
    if decimals.agree(values, decimals.values(answer(question))):
        return Verdict("unsimplified", _("Right! The formula can be written much shorter."))
    differs = _("Your answer differs from the right one. It cannot be compared term by term.")
    return Verdict("wrong", f"{differs} {leads_on(question)}")


# Right, and simplified?


def _to_simplify(question: str, typed: Expression, given: NormalForm) -> str | None:
    """Return what is left to simplify, or None; the cheapest test comes first."""
    needless = [name for name in NAMES if name in names(typed) - set(allowed_names(question))]
    if needless:
        return _("The formula can be written without {names}.").format(names=_listed(needless))
    if simplicity.has_like_terms(typed):
        return _("Can you combine the like terms?")
    if simplicity.has_root_to_take(typed):
        return _("Can you simplify a root, or the expression under it?")
    if simplicity.has_root(typed) and not any(roots for roots, _polynomial in given.numerators):
        return _("The formula can be written without a root.")
    if length(typed) > longest_form(question):
        return _("The formula can be written shorter.")
    if simplicity.has_fraction_below(typed):
        return _("Can you remove the fraction inside the denominator?")
    if simplicity.has_common_factor(typed):
        return _("Can you cancel a common factor of numerator and denominator?")
    return None


# Wrong, and how?


def _advice(question: str, typed: Expression, given: NormalForm) -> Iterator[str]:
    """Yield what was found, then the question that leads to the next step."""
    if given.is_zero:
        yield _("Your answer is zero.")
        yield leads_on(question)
        return
    small = given.size <= _MANY_TERMS
    known = small and (_known_mistake(question, given) or _rounded(question, typed))
    if known:
        yield known
        return
    wrong_unit = _wrong_unit(question, given)
    if wrong_unit:
        yield wrong_unit
    foreign = [name for name in VARIABLES if name in given.names - right_form(question).names]
    if foreign:
        yield _depends_on(question, foreign)
    if not small:
        yield _("Written out, your answer has more than {most} terms. The right one has fewer.").format(
            most=_MANY_TERMS
        )
        yield leads_on(question)
        return
    term, sentences = _differences(question, typed, given)
    # If the unit is wrong as a whole, every term is wrong, and a list of them says nothing.
    if term is not None or not (wrong_unit or foreign):
        yield from sentences
    yield leads_on(question, term)


def _known_mistake(question: str, given: NormalForm) -> str | None:
    wrong = wrong_forms(question)
    if given in wrong:
        return wrong[given]
    if kind(question) == POLYNOMIAL and set(variables(question)) <= set(MOTION):
        half = wrong.get(times(given, constant(Fraction(1, 2))))
        return half and _("{hint} A factor ½ is missing as well.").format(hint=half)
    return None


def _rounded(question: str, typed: Expression) -> str | None:
    """Return a hint if one decimal number of the answer agrees with an exact one to its last digit; else None."""
    if not any(number.places for number in numbers(typed)):
        return None
    if decimals.rounded(typed, decimals.values(answer(question))):
        return _("An exact number agrees with your decimal number to the last digit. What is the exact number?")
    # Fewer digits would fit too many cases.
    if all(number.places is None or number.places >= _TELLING_DIGITS for number in numbers(typed)):
        for values, hint in wrong_values(question):
            if decimals.rounded(typed, values):
                return _("Your decimal number agrees to the last digit with this case. {hint}").format(hint=hint)
    return None


def _depends_on(question: str, foreign: list[str]) -> str:
    if question == "potential_energy" and foreign in (["X"], ["Phi"]):
        spring = _("Your answer depends on {name}, but {name} does not deform the spring.")
        return spring.format(name=_listed(foreign))
    sentence = ngettext(
        "Your answer depends on {names}, but {quantity} does not depend on it.",
        "Your answer depends on {names}, but {quantity} does not depend on them.",
        len(foreign),
    )
    return sentence.format(names=_listed(foreign), quantity=quantity(question))


def _wrong_unit(question: str, given: NormalForm) -> str | None:
    found, (right,) = units(given), units(right_form(question))
    if found is None:
        return _("You add terms with different units below a fraction line or under a root.")
    if len(found) > 1:
        one, other = unit_text(found[0]), unit_text(found[1])
        if not (one and other):
            return _("You add a plain number to a term with the unit {unit}.").format(unit=one or other)
        return _("You add terms with different units, {one} and {other}.").format(one=one, other=other)
    if found == (right,):
        return None
    yours, expected = unit_text(found[0]), unit_text(right)
    if not yours:
        sentence = _("Your answer is a plain number, but {quantity} has the unit {expected}.")
    elif not expected:
        sentence = _("Your answer has the unit {yours}, but {quantity} is a plain number.")
    else:
        sentence = _("Your answer has the unit {yours}, but {quantity} has the unit {expected}.")
    return sentence.format(yours=yours, expected=expected, quantity=quantity(question))


def _differences(question: str, typed: Expression, given: NormalForm) -> tuple[str | None, list[str]]:
    """Return the term that differs, if there is only one, and sentences about the difference."""
    right = right_form(question)
    if kind(question) == NUMBER:
        return None, [*(_multiple(over(given, right)) or as_number(given, right)), *_as_mass_ratio(typed, given)]
    if kind(question) == POLYNOMIAL:
        differences = term_by_term(given, right, variables(question))
        if differences is None:
            if set(variables(question)) & set(MOTION):
                return "", [_("In your answer a velocity or an angle is below a fraction line or under a root.")]
            return "", [_("In your answer a mass or a length is below a fraction line or under a root.")]
        ratio = over(given, right)
        if len(differences) > 1 and not ratio.names.intersection(MOTION) and (multiple := _multiple(ratio)):
            return None, multiple
        return differences[0][0] if len(differences) == 1 else None, in_short(differences)
    return None, _multiple(over(given, right)) or as_fraction(given, right)


def _multiple(ratio: NormalForm) -> list[str]:
    """Return the ratio of the given answer to the right one in a sentence, if the ratio is simple."""
    if ratio == MINUS_ONE:
        return [_("Your answer has the wrong sign.")]
    factor = shown_factor(ratio)
    if factor is None:
        return []
    if factor.startswith("−"):
        times = how_many_times(factor.removeprefix("−"))
        return [_("Your answer has the wrong sign. Its size is {times} the right one.").format(times=times)]
    return [_("Your answer is {times} the right one.").format(times=how_many_times(factor))]


def _as_mass_ratio(typed: Expression, given: NormalForm) -> Iterator[str]:
    """Yield the frequency of the machine with the given mass ratio."""
    if given.names:
        return
    ratio = decimals.values(typed)[0]
    if ratio <= 0:
        yield _("A ratio of two masses is positive.")
        return
    frequency = decimals.value_at(answer("natural_frequency_squared"), {"m": Decimal(1), "m'": ratio, "k": Decimal(1)})
    if (difference := abs(frequency - 1)) < Decimal("1e-5"):
        close = _("With ε = {ratio}, Ω² and k/m differ by {difference} k/m, not by zero.")
        yield close.format(ratio=written(ratio, 12, strip=True), difference=written(difference, 4))
    else:
        far = _("With ε = {ratio} you get Ω² = {frequency} k/m.")
        yield far.format(ratio=written(ratio, 6, strip=True), frequency=written(frequency, 6, strip=True))


def _listed(names: list[str]) -> str:
    *first, last = map(shown_name, names)
    return _("{names} and {last}").format(names=", ".join(first), last=last) if first else last
