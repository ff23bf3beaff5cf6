"""How a wrong answer differs from the right one: coefficient by coefficient, as one fraction, or as a number.

Every sentence states what was computed exactly, and says nothing about how the student arrived there. Products of names
and numbers are written as a person writes them: X′φ′, mR², 3/2.
"""

from __future__ import annotations

from fractions import Fraction

from ramanujan.derivation.expansion import NormalForm, UncertainRootError
from ramanujan.derivation.normal_form import MINUS_ONE, ONE, ZERO, at, coefficients, fraction, name_form, over, times
from ramanujan.derivation.polynomials import VARIABLES, Monomial
from ramanujan.numerals import superscript
from ramanujan.translation import _, ngettext

_SHOWN = {"eps": "ε", "m'": "m′", "X'": "X′", "phi": "φ", "phi'": "φ′", "Phi": "Φ", "Phi'": "Φ′"}
_WORDS = {"2": _("twice"), "3": _("three times"), "4": _("four times"), "1/2": _("half of")}
_MOST_SENTENCES = 3

Differences = list[tuple[str, str]]
"""Products of names, and a sentence about the coefficient of each."""


def shown_name(name: str) -> str:
    """Return a name as a sentence shows it."""
    return _SHOWN.get(name, name)


def shown_product(monomial: Monomial) -> str:
    """Return a product of names as a sentence shows it; empty for 1."""
    return "".join(
        shown_name(name) + (superscript(n) if n > 1 else "") for name, n in zip(VARIABLES, monomial, strict=True) if n
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
    given: NormalForm, right: NormalForm, variables: tuple[str, ...], place: str = "{term}"
) -> Differences | None:
    """Return the products of names whose coefficients differ, and a sentence about each.

    None if the answer is not a polynomial in the variables.

    Parameters
    ----------
    given, right : the answer and what it should be
    variables : the names in whose products both are written; the coefficients may contain the others
    place : a template that says where these terms are, such as "{term} in the numerator"
    """
    yours, theirs = coefficients(given, variables), coefficients(right, variables)
    if yours is None or theirs is None:
        return None
    found = []
    for monomial in sorted(yours.keys() | theirs.keys(), reverse=True):
        term = shown_product(monomial)
        sentence = _coefficient(term and place.format(term=term), yours.get(monomial, ZERO), theirs.get(monomial, ZERO))
        if sentence:
            found.append((term, sentence))
    return found


def _coefficient(term: str, yours: NormalForm, right: NormalForm) -> str | None:
    """Return how a coefficient differs, None if it does not."""
    if yours == right:
        return None
    if right.is_zero:
        if not term:
            return _("Your answer contains a constant term. The right answer has none.")
        return _("Your answer contains a term with {term}. The right answer has none.").format(term=term)
    if yours.is_zero:
        return _("The term with {term} is missing.").format(term=term)
    ratio = over(yours, right)
    negative = _is_negative(right)
    if ratio == MINUS_ONE:
        return _should_be_negative(term) if negative else _should_be_positive(term)
    factor = shown_factor(ratio)
    if factor is None:
        return _("Your coefficient of {term} is wrong.").format(term=term)
    if factor.startswith("−"):
        sign = _should_be_negative(term) if negative else _should_be_positive(term)
        size = _("Its size is {times} the right one.").format(times=how_many_times(factor.removeprefix("−")))
        return f"{sign} {size}"
    times_right = _("Your coefficient of {term} is {times} the right one.")
    return _names_off(term, ratio, right) or times_right.format(term=term, times=how_many_times(factor))


def _should_be_negative(term: str) -> str:
    return _("Your coefficient of {term} should be negative.").format(term=term)


def _should_be_positive(term: str) -> str:
    return _("Your coefficient of {term} should be positive.").format(term=term)


def _names_off(term: str, ratio: NormalForm, right: NormalForm) -> str | None:
    """Return which names differ, if the two coefficients differ by names alone."""
    inverse = over(ONE, ratio)
    if (
        not ratio.names
        or None in (ratio.numerator, inverse.numerator)
        or ratio.numerator.LC * inverse.numerator.LC != 1
    ):
        return None
    for yours, theirs in (("m", "m'"), ("m'", "m")):
        if theirs in right.names and yours not in right.names and ratio == over(name_form(yours), name_form(theirs)):
            instead = _("Your coefficient of {term} contains {yours} instead of {right}.")
            return instead.format(term=term, yours=shown_name(yours), right=shown_name(theirs))
    if ratio.denominator == 1:
        extra = _("Your coefficient of {term} contains an extra factor {factor}.")
        return extra.format(term=term, factor=shown_factor(ratio))
    if inverse.denominator == 1:
        lacks = _("Your coefficient of {term} lacks a factor {factor}.")
        return lacks.format(term=term, factor=shown_factor(inverse))
    return None


def how_many_times(factor: str) -> str:
    """Return a factor in words, such as "twice" or "3/2 times", to be followed by "the right one"."""
    return _WORDS.get(factor) or _("{factor} times").format(factor=factor)


def _is_negative(coefficient: NormalForm) -> bool:
    """Tell whether the leading term of a coefficient is negative."""
    return any(polynomial.LC < 0 for _roots, polynomial in coefficient.numerators)


# As one fraction


def as_fraction(given: NormalForm, right: NormalForm) -> list[str]:
    """Return sentences about numerator and denominator if one of them is right, else about special masses.

    With the right denominator D the given numerator is given·D; with the right numerator N the denominator is N/given.
    """
    (above, below), yours = fraction(right), fraction(given)
    numerator = term_by_term(times(given, below), above, VARIABLES, _("{term} in the numerator"))
    if numerator and not over(yours[1], below).names:
        return [_("Written as one fraction, your answer has the right denominator."), *in_short(numerator)]
    denominator = term_by_term(over(above, given), below, VARIABLES, _("{term} in the denominator"))
    if denominator and not over(yours[0], above).names:
        return [_("Written as one fraction, your answer has the right numerator."), *in_short(denominator)]
    # A spoiled fraction may have cancelled to a simpler one: then it has neither, but can be written with one of them.
    if numerator and len(numerator) == 1:
        return [_("Written with the right denominator, your answer differs in one term."), *in_short(numerator)]
    if denominator and len(denominator) == 1:
        return [_("Written with the right numerator, your answer differs in one term."), *in_short(denominator)]
    return _special_masses(given, right)


def _special_masses(given: NormalForm, right: NormalForm) -> list[str]:
    """Return for which masses the answer is right, or that it is wrong even for equal masses."""
    try:
        if at(given, {"m'": "m"}) == at(right, {"m'": "m"}):
            return [_("Your answer is right for equal masses, m′ = m, but not for other masses.")]
        for name in ("m'", "m"):
            if at(given, {name: 0}) == at(right, {name: 0}):
                vanishing = _("Your answer is right for {mass} = 0, so the error is in a term with {mass}.")
                return [vanishing.format(mass=shown_name(name))]
    except (ZeroDivisionError, UncertainRootError):
        return []
    return [_("Your answer is wrong even for equal masses, m′ = m.")]


def in_short(differences: Differences) -> list[str]:
    """Return the sentences about what differs; if there are many, their number and the first one."""
    sentences = [sentence for _term, sentence in differences]
    if len(sentences) <= _MOST_SENTENCES:
        return sentences
    n = len(sentences)
    return [
        ngettext("{n} term differs from the right one.", "{n} terms differ from the right ones.", n).format(n=n),
        sentences[0],
    ]


# As a number


def as_number(given: NormalForm, right: NormalForm) -> list[str]:
    """Return which part of a number is right: the part without a root or the part with one."""
    (rational, irrational), (right_rational, right_irrational) = _parts(given), _parts(right)
    if irrational == right_irrational:
        return [_("The part of your answer with the root is right. The part without the root is not.")]
    if rational == right_rational:
        return [_("The part of your answer without the root is right. The part with the root is not.")]
    return []


def _parts(form: NormalForm) -> tuple[frozenset, frozenset]:
    """Return the rational numbers in a number, and the multiples of roots."""
    shares = [(roots, Fraction(int(p.LC), int(form.denominator.LC))) for roots, p in form.numerators]
    return frozenset(s for s in shares if not s[0]), frozenset(s for s in shares if s[0])
