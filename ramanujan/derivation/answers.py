"""The verdict on a student's formula: right, right but not simplified, wrong and how it differs, or unreadable.

`QUESTIONS` lists the names of the questions, `question(name)` says what is asked, `judge(name, text)` answers. A
verdict claims only what was worked out exactly. Nothing that a student types reaches SymPy's own parser.
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
from ramanujan.derivation.expressions import NAMES, Expression, length, names, numbers
from ramanujan.derivation.normal_form import (
    VARIABLES,
    NegativeRootError,
    NormalForm,
    TooLargeError,
    UncertainRootError,
    constant,
    minus,
    normal_form,
    over,
    times,
)
from ramanujan.derivation.parser import UnreadableError, parse
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

__all__ = ["QUESTIONS", "Question", "Verdict", "judge", "question"]

_MANY_TERMS, _TELLING_DIGITS = 60, 4
_DIVIDES_BY_ZERO = "Your formula divides by zero."
_NEGATIVE_ROOT = "Your formula contains the root of a negative number."


@dataclass(frozen=True)
class Verdict:
    """What a student is told: `kind` is right, unsimplified, wrong or unreadable; `message` is plain text."""

    kind: str
    message: str


def judge(question: str, text: str) -> Verdict:
    """Return the verdict on a student's answer; never raises, whatever it is given.

    Two formulas are equal if their exact normal forms are. Where a formula has none, because it is too large or because
    a root may be one of a negative number, it is compared in 300 digits at random points. A right formula is
    unsimplified if it is longer than the derived one and its expanded and factored forms, or if something in it can be
    worked out.

    Parameters
    ----------
    question : one of `QUESTIONS`
    text : the formula as typed
    """
    if not isinstance(question, str) or question not in QUESTIONS:
        return Verdict("unreadable", "There is no question of that name.")
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
        return Verdict("unsimplified", f"Right! {to_do}") if to_do else Verdict("right", "Right!")
    return Verdict("wrong", " ".join(_advice(question, typed, given)))


def _sampled(question: str, typed: Expression) -> Verdict:
    """Return the verdict on a formula without a normal form."""
    try:
        values = decimals.values(typed)
    except decimals.RootOfNegativeError:
        return Verdict("unreadable", "Your formula contains a root that is not real for all masses and motions.")
    if decimals.agree(values, decimals.values(answer(question))):
        return Verdict("unsimplified", "Right! It can be written much shorter.")
    return Verdict(
        "wrong", f"Your answer differs from the right one. It is too involved to say where. {leads_on(question)}"
    )


# Right, and simplified?


def _to_simplify(question: str, typed: Expression, given: NormalForm) -> str | None:
    """Return what is left to do, cheapest test first, or None."""
    needless = [name for name in NAMES if name in names(typed) - set(allowed_names(question))]
    if needless:
        return f"It can be written without {_listed(needless)}."
    if simplicity.has_like_terms(typed):
        return "Can you gather the like terms?"
    if simplicity.has_root_to_take(typed):
        return "Can you work out a root, or what is under it?"
    if simplicity.has_root(typed) and not any(roots for roots, _ in given.numerators):
        return "It can be written without a root."
    if length(typed) > longest_form(question):
        return "It can be written shorter."
    if simplicity.has_fraction_below(typed):
        return "Can you clear the fraction inside the denominator?"
    if simplicity.has_common_factor(typed):
        return "Can you cancel a common factor above and below the fraction line?"
    return None


# Wrong, and how?


def _advice(question: str, typed: Expression, given: NormalForm) -> Iterator[str]:
    """Yield what was found, then the question that leads on."""
    if given.is_zero:
        yield "Your answer is zero."
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
        yield f"Written out, your answer has more than {_MANY_TERMS} terms, and the right one has fewer."
        yield leads_on(question)
        return
    term, sentences = _differences(question, typed, given)
    # Where the unit is wrong as a whole, every term is, and a list of them tells nothing.
    if term is not None or not (wrong_unit or foreign):
        yield from sentences
    yield leads_on(question, term)


def _known_mistake(question: str, given: NormalForm) -> str | None:
    wrong = wrong_forms(question)
    if given in wrong:
        return wrong[given]
    if kind(question) == POLYNOMIAL and set(variables(question)) <= set(MOTION):
        half = wrong.get(times(given, constant(Fraction(1, 2))))
        return half and f"{half} Also, a factor ½ is missing."
    return None


def _rounded(question: str, typed: Expression) -> str | None:
    """Return what the answer would be with one of its decimal numbers exact; None if that is nothing known."""
    if not any(number.places for number in numbers(typed)):
        return None
    if decimals.rounded(typed, decimals.values(answer(question))):
        return "Your decimal number is rounded: the exact one agrees with it up to its last digit. What is it exactly?"
    # Fewer digits would fit too many cases.
    if all(number.places is None or number.places >= _TELLING_DIGITS for number in numbers(typed)):
        for values, hint in wrong_values(question):
            if decimals.rounded(typed, values):
                return f"Your decimal number fits the following case to its last digit. {hint}"
    return None


def _depends_on(question: str, foreign: list[str]) -> str:
    if question == "potential_energy" and foreign in (["X"], ["Phi"]):
        return f"Your answer depends on {_listed(foreign)}, which does not stretch the spring."
    what = quantity(question)
    return f"{what[0].upper()}{what[1:]} does not depend on {_listed(foreign)}."


def _wrong_unit(question: str, given: NormalForm) -> str | None:
    found, (right,) = units(given), units(right_form(question))
    if found is None:
        return "Below a fraction line or under a root you add terms with different units."
    if len(found) > 1:
        one, other = unit_text(found[0]), unit_text(found[1])
        if not (one and other):
            return f"You add a plain number to a term with the unit {one or other}."
        return f"You add terms with different units, {one} and {other}."
    if found == (right,):
        return None
    yours, expected = unit_text(found[0]), unit_text(right)
    if not yours:
        return f"Your answer is a plain number, but {quantity(question)} has the unit {expected}."
    if not expected:
        return f"Your answer has the unit {yours}, but {quantity(question)} is a plain number."
    return f"Your answer has the unit {yours}, but {quantity(question)} has the unit {expected}."


def _differences(question: str, typed: Expression, given: NormalForm) -> tuple[str | None, list[str]]:
    """Return the term that differs, if there is only one, and sentences on how the answer differs."""
    right = right_form(question)
    if kind(question) == NUMBER:
        return None, [*(_multiple(over(given, right)) or as_number(given, right)), *_as_mass_ratio(typed, given)]
    if kind(question) == POLYNOMIAL:
        differences = term_by_term(given, right, variables(question))
        if differences is None:
            return "", ["In your answer a rate or an angle is below a fraction line or under a root."]
        ratio = over(given, right)
        if len(differences) > 1 and not ratio.names.intersection(MOTION) and (multiple := _multiple(ratio)):
            return None, multiple
        return differences[0][0] if len(differences) == 1 else None, in_short(differences)
    return None, _multiple(over(given, right)) or as_fraction(given, right)


def _multiple(ratio: NormalForm) -> list[str]:
    """Return how many times the right answer the given one is, if that is simple to say."""
    if ratio == MINUS_ONE:
        return ["Your answer has the wrong sign."]
    factor = shown_factor(ratio)
    if factor is None:
        return []
    if factor.startswith("−"):
        size = how_many_times(factor.removeprefix("−"))
        return [f"Your answer has the wrong sign, and its size is {size} what it should be."]
    return [f"Your answer is {how_many_times(factor)} what it should be."]


def _as_mass_ratio(typed: Expression, given: NormalForm) -> Iterator[str]:
    """Yield what the machine does at the given mass ratio."""
    if given.names:
        return
    ratio = decimals.values(typed)[0]
    if ratio <= 0:
        yield "A ratio of two masses is positive."
        return
    frequency = decimals.value_at(answer("natural_frequency_squared"), {"m": Decimal(1), "m'": ratio, "k": Decimal(1)})
    if abs(frequency - 1) < Decimal("1e-5"):
        yield f"With ε = {ratio:.12g} the difference between Ω² and k/m is {_short(abs(frequency - 1))} k/m, not zero."
    else:
        yield f"With ε = {_short(ratio)} you get Ω² = {_short(frequency)} k/m."


def _short(value: Decimal) -> str:
    return f"{value:.6g}" if Decimal("1e-4") < value < 10**6 else f"{value:.3e}"


def _listed(names: list[str]) -> str:
    *first, last = map(shown_name, names)
    return f"{', '.join(first)} and {last}" if first else last
