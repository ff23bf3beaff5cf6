"""How a wrong answer differs from the right one: coefficient by coefficient, as one fraction, or as a number.

Every sentence states what was computed exactly and claims nothing about how the student came to it. A sentence is one
template with named slots; products of names and numbers are written into them as a person reads them: X′φ′, mR², 3/2.
"""

from __future__ import annotations

from fractions import Fraction

from ramanujan.derivation.normal_form import (
    MINUS_ONE,
    ONE,
    VARIABLES,
    ZERO,
    Monomial,
    NormalForm,
    UncertainRootError,
    at,
    coefficients,
    fraction,
    name_form,
    over,
    times,
)

_SHOWN = {"eps": "ε", "m'": "m′", "X'": "X′", "phi": "φ", "phi'": "φ′", "Phi": "Φ", "Phi'": "Φ′"}
_SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_WORDS = {"2": "twice", "3": "three times", "4": "four times", "1/2": "half of"}
_MOST_SENTENCES = 3

Differences = list[tuple[str, str]]
"""Products of names, and a sentence on the coefficient of each."""


def shown_name(name: str) -> str:
    """Return a name as a sentence shows it."""
    return _SHOWN.get(name, name)


def shown_product(monomial: Monomial) -> str:
    """Return a product of names as a sentence shows it; empty for 1."""
    return "".join(
        shown_name(name) + (str(n).translate(_SUPERSCRIPTS) if n > 1 else "")
        for name, n in zip(VARIABLES, monomial, strict=True)
        if n
    )


def shown_factor(factor: NormalForm) -> str | None:
    """Return a factor that is one term over one term, such as 3m′/(2m) or √2, as a sentence shows it; else None."""
    if len(factor.numerators) != 1 or len(factor.denominator) != 1:
        return None
    ((roots, polynomial),) = factor.numerators
    if len(polynomial) != 1 or any(not radicand.is_ground for radicand in roots):
        return None
    (above, p), (below, q) = next(iter(polynomial.items())), next(iter(factor.denominator.items()))
    under = 1
    for radicand in roots:
        under *= int(radicand.LC)
    number = "−" * (p < 0) + (str(abs(int(p))) if abs(p) != 1 else "") + (f"√{under}" if roots else "")
    numerator, denominator = number + shown_product(above), (str(int(q)) if q != 1 else "") + shown_product(below)
    if not numerator.strip("−"):
        numerator += "1"
    if not denominator:
        return numerator
    plain = sum(n > 0 for n in below) + (q != 1) == 1
    return f"{numerator}/{denominator}" if plain else f"{numerator}/({denominator})"


# Term by term


def term_by_term(
    given: NormalForm, right: NormalForm, variables: tuple[str, ...], place: str = ""
) -> Differences | None:
    """Return the products of names whose coefficients differ, and a sentence on each.

    None if the answer is no polynomial in the variables.

    Parameters
    ----------
    given, right : the answer and what it should be
    variables : the names in whose products both are written; the coefficients may contain the others
    place : where these terms are, such as " in the numerator"; empty for the whole answer
    """
    yours, theirs = coefficients(given, variables), coefficients(right, variables)
    if yours is None or theirs is None:
        return None
    found = []
    for monomial in sorted(yours.keys() | theirs.keys(), reverse=True):
        term = shown_product(monomial)
        sentence = _coefficient(term and term + place, yours.get(monomial, ZERO), theirs.get(monomial, ZERO))
        if sentence:
            found.append((term, sentence))
    return found


def _coefficient(term: str, yours: NormalForm, right: NormalForm) -> str | None:
    """Return how a coefficient differs, None if it does not."""
    if yours == right:
        return None
    if right.is_zero:
        if not term:
            return "Your answer has a constant term. It does not belong here."
        return f"Your term with {term} does not belong here."
    if yours.is_zero:
        return f"The term with {term} is missing."
    ratio = over(yours, right)
    sign = "negative" if _is_negative(right) else "positive"
    if ratio == MINUS_ONE:
        return f"Your coefficient of {term} should be {sign}."
    factor = shown_factor(ratio)
    if factor is None:
        return f"Your coefficient of {term} is wrong."
    if factor.startswith("−"):
        size = how_many_times(factor.removeprefix("−"))
        return f"Your coefficient of {term} should be {sign}, and its size is {size} what it should be."
    return (
        _names_off(term, ratio, right) or f"Your coefficient of {term} is {how_many_times(factor)} what it should be."
    )


def _names_off(term: str, ratio: NormalForm, right: NormalForm) -> str | None:
    """Return which names make the difference, if it is made by names alone."""
    inverse = over(ONE, ratio)
    if (
        not ratio.names
        or None in (ratio.numerator, inverse.numerator)
        or ratio.numerator.LC * inverse.numerator.LC != 1
    ):
        return None
    for yours, theirs in (("m", "m'"), ("m'", "m")):
        if theirs in right.names and yours not in right.names and ratio == over(name_form(yours), name_form(theirs)):
            return f"Your coefficient of {term} contains {shown_name(yours)} instead of {shown_name(theirs)}."
    if ratio.denominator == 1:
        return f"Your coefficient of {term} contains a factor {shown_factor(ratio)} too many."
    if inverse.denominator == 1:
        return f"Your coefficient of {term} lacks a factor {shown_factor(inverse)}."
    return None


def how_many_times(factor: str) -> str:
    """Return a factor such that it reads well before "what it should be"."""
    return _WORDS.get(factor, f"{factor} times")


def _is_negative(coefficient: NormalForm) -> bool:
    """Tell whether the leading term of a coefficient is negative."""
    return any(polynomial.LC < 0 for _, polynomial in coefficient.numerators)


# As one fraction


def as_fraction(given: NormalForm, right: NormalForm) -> list[str]:
    """Return sentences on numerator and denominator if one of them is right; else on special masses.

    Over the denominator of the right answer the numerator is given·D, over its numerator the denominator is N/given.
    """
    (above, below), yours = fraction(right), fraction(given)
    numerator = term_by_term(times(given, below), above, VARIABLES, " in the numerator")
    if numerator and (len(numerator) == 1 or not over(yours[1], below).names):
        return ["Written as one fraction, your answer has the right denominator.", *in_short(numerator)]
    denominator = term_by_term(over(above, given), below, VARIABLES, " in the denominator")
    if denominator and (len(denominator) == 1 or not over(yours[0], above).names):
        return ["Written as one fraction, your answer has the right numerator.", *in_short(denominator)]
    return _special_masses(given, right)


def _special_masses(given: NormalForm, right: NormalForm) -> list[str]:
    """Return for which masses the answer is right, or that it is wrong even for equal ones."""
    try:
        if at(given, {"m'": "m"}) == at(right, {"m'": "m"}):
            return ["For equal masses, m′ = m, your answer is right, but not for other masses."]
        for name in ("m'", "m"):
            if at(given, {name: 0}) == at(right, {name: 0}):
                lost = shown_name(name)
                return [f"With {lost} = 0 your answer is right, so the error is in a term with {lost}."]
    except (ZeroDivisionError, UncertainRootError):
        return []
    return ["Your answer is wrong even for equal masses, m′ = m."]


def in_short(differences: Differences) -> list[str]:
    """Return the sentences on what differs; of many only the first."""
    sentences = [sentence for _, sentence in differences]
    if len(sentences) <= _MOST_SENTENCES:
        return sentences
    return [f"There are {len(sentences)} terms that differ from the right ones.", sentences[0]]


# As a number


def as_number(given: NormalForm, right: NormalForm) -> list[str]:
    """Return which part of a number is right: the one without a root or the one with it."""
    (rational, irrational), (right_rational, right_irrational) = _parts(given), _parts(right)
    if irrational == right_irrational:
        return ["The part of your answer with the root is right. The part without it is not."]
    if rational == right_rational:
        return ["The part of your answer without the root is right. The part with the root is not."]
    return []


def _parts(form: NormalForm) -> tuple[frozenset, frozenset]:
    """Return the rational numbers in a number, and the multiples of roots."""
    shares = [(roots, Fraction(int(p.LC), int(form.denominator.LC))) for roots, p in form.numerators]
    return frozenset(s for s in shares if not s[0]), frozenset(s for s in shares if s[0])
