"""How a wrong answer differs from the right one: coefficient by coefficient, as one fraction, or as a number.

A formula becomes an element of SymPy's fraction field ℤ(m, m′, k, R, X, …), where every quotient is in lowest terms.
Degrees and digits are bounded before anything is computed. Every sentence states what was computed exactly.
"""

from collections import Counter
from fractions import Fraction
from math import inf, prod
from typing import NamedTuple

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers.formulas import is_number, weights
from ramanujan.answers.spelling import SYMBOLS
from ramanujan.answers.values import decimals
from ramanujan.derivation.model import epsilon, m, m_prime
from ramanujan.numerals import superscript
from ramanujan.translation import _, ngettext

NAMES = tuple(SYMBOLS)
_SHOWN = {"eps": "ε", "Phi": "Φ", "phi": "φ", "''": "″", "'": "′"}
# TRANSLATORS: they stand for {times} in a sentence such as: Your answer is {times} the right one.
_WORDS = {"2": _("twice"), "3": _("three times"), "4": _("four times"), "1/2": _("half of")}
_MOST_SENTENCES = 3

FIELD = field(list(SYMBOLS.values()), sp.ZZ)[0]
_GENERATORS = dict(zip(NAMES, FIELD.gens, strict=True))

_MAX_WEIGHT, _MAX_BITS, _MAX_TERMS = 60, 60_000, 120
"""Limits on the names and numbers of a quotient, on the integers of a search for common factors, on the terms of a
polynomial."""
_FEWEST_BITS = 6
"""The bits of the integers with which that search begins."""


class Difference(NamedTuple):
    """A product of names, a sentence about its coefficient, and whether a slip of the pen explains the difference."""

    term: str
    sentence: str
    is_slip: bool


Differences = list[Difference]


class NotComparableError(ValueError):
    """The formula cannot be written out; the message tells the student."""


_TOO_LARGE = _("Your answer differs from the right one. It cannot be compared term by term.")


def _check_size(expression: sp.Expr) -> None:
    """Refuse a formula whose lowest terms would take long to find.

    A sum of few terms is multiplied out at once. Common factors of a quotient are searched with integers in place of
    one name after another (the heuristic gcd): a name of degree n makes the integers n + 1 times as long.
    """
    if _terms(expression) <= _MAX_TERMS:
        return
    counted = weights(expression)
    bits = _FEWEST_BITS + sum(times * _bits(leaf) for leaf, times in counted.items() if is_number(leaf))
    if counted.total() > _MAX_WEIGHT or bits * prod(n + 1 for n in _degrees(counted).values()) > _MAX_BITS:
        raise NotComparableError(_TOO_LARGE)


def _bits(number: sp.Expr) -> int:
    """Return how many bits a number, as it was typed, adds to the integers of a product."""
    return sum(part.bit_length() - 1 for part in Fraction(str(number)).as_integer_ratio() if part)


def _degrees(counted: Counter[sp.Expr]) -> Counter[sp.Expr]:
    """Return the degree of each name; ε stands for m′/m."""
    degrees = Counter()
    for leaf, times in counted.items():
        if not is_number(leaf):
            degrees.update(dict.fromkeys((m, m_prime) if leaf == epsilon else (leaf,), times))
    return degrees


def _terms(expression: sp.Expr) -> float:
    """Return how many terms a formula has at most when it is multiplied out; infinity if it divides by a sum."""
    if expression.is_Add:
        return sum(map(_terms, expression.args))
    if expression.is_Mul:
        return prod(map(_terms, expression.args))
    if expression.is_Pow:
        terms, exponent = _terms(expression.base), expression.exp
        if terms > 1 and not (exponent.is_Integer and exponent > 0):
            return inf
        return terms ** int(exponent) if terms > 1 else terms
    return 1


def names_in(formula: FracElement) -> frozenset[str]:
    """Return the names on which a formula depends."""
    return frozenset(
        name for i, name in enumerate(NAMES) if any(powers[i] for p in (formula.numer, formula.denom) for powers in p)
    )


def exact(expression: sp.Expr, *, of_ratio: bool = False) -> FracElement:
    """Return a formula in lowest terms, with m′/m for ε or, if it is a formula in the mass ratio, with εm for m′.

    Raises
    ------
    NotComparableError : it is too large, or has a root.
    """
    _check_size(expression)
    masses = {m_prime: epsilon * m} if of_ratio else {epsilon: m_prime / m}
    numbers = {decimal: sp.Rational(decimal.name) for decimal in decimals(expression)}
    try:
        return FIELD.from_expr(expression.xreplace(masses | numbers).doit())
    except ValueError:
        raise NotComparableError(_("Your answer contains a root. The right one has none.")) from None


# In words


def shown_name(name: str) -> str:
    """Return a name as a sentence shows it."""
    for typed, shown in _SHOWN.items():
        name = name.replace(typed, shown)
    return name


def listed(names: list[str]) -> str:
    """Return names as a sentence lists them."""
    *first, last = map(shown_name, names)
    return _("{names} and {last}").format(names=", ".join(first), last=last) if first else last


def _shown_product(powers: tuple[int, ...]) -> str:
    return "".join(
        shown_name(name) + (superscript(n) if n > 1 else "") for name, n in zip(NAMES, powers, strict=True) if n
    )


def shown_factor(factor: FracElement) -> str | None:
    """Return a factor that is one term over one term, such as 3m′/(2m), as a sentence shows it; else None."""
    if len(factor.numer) != 1 or len(factor.denom) != 1:
        return None
    (above, p), (below, q) = next(iter(factor.numer.items())), next(iter(factor.denom.items()))
    numerator = (str(abs(int(p))) if abs(p) != 1 else "") + _shown_product(above)
    denominator = (str(int(q)) if q != 1 else "") + _shown_product(below)
    shown = ("−" if p < 0 else "") + (numerator or "1")
    if not denominator:
        return shown
    plain = sum(n > 0 for n in below) + (q != 1) == 1
    return f"{shown}/{denominator}" if plain else f"{shown}/({denominator})"


def how_many_times(factor: str) -> str:
    """Return a factor in words, such as "twice" or "3/2 times", to be followed by "the right one"."""
    # TRANSLATORS: stands for {times} in a sentence such as: Your answer is {times} the right one.
    return _WORDS.get(factor) or _("{factor} times").format(factor=factor)


def in_short(differences: Differences) -> list[str]:
    """Return the sentences about what differs; if there are many, their number and the first one."""
    sentences = [each.sentence for each in differences]
    if len(sentences) <= _MOST_SENTENCES:
        return sentences
    n = len(sentences)
    return [
        ngettext("{n} term differs from the right one.", "{n} terms differ from the right ones.", n).format(n=n),
        sentences[0],
    ]


def multiple(ratio: FracElement) -> list[str]:
    """Return the ratio of the given answer to the right one in a sentence, if the ratio is simple."""
    factor = shown_factor(ratio)
    times, sign = _("Your answer is {times} the right one."), _("Your answer has the wrong sign.")
    return [] if factor is None else [_size_and_sign(factor, times, sign)]


def _size_and_sign(factor: str, times: str, sign: str, **names: str) -> str:
    """Return how many times the right one it is, or that its sign is wrong, and its size if that is wrong as well."""
    said = how_many_times(factor.removeprefix("−"))
    if not factor.startswith("−"):
        return times.format(times=said, **names)
    size = _("Its size is {times} the right one.").format(times=said)
    return sign.format(**names) + ("" if factor == "−1" else f" {size}")


# Term by term


def term_by_term(
    given: FracElement, right: FracElement, variables: tuple[str, ...], place: str = "{term}"
) -> Differences | None:
    """Return the products of names whose coefficients differ, and a sentence about each.

    None if one of them is not a polynomial in the variables.

    Parameters
    ----------
    given, right : the answer and what it should be
    variables : the names in whose products both are written; the coefficients may contain the others
    place : a template that says where these terms are, such as "{term} in the numerator"
    """
    yours, theirs = (_coefficients(formula, variables) for formula in (given, right))
    if yours is None or theirs is None:
        return None
    found = []
    for powers in sorted(yours.keys() | theirs.keys(), reverse=True):
        term, pair = _shown_product(powers), [each.get(powers, FIELD.zero) for each in (yours, theirs)]
        if sentence := _coefficient(term and place.format(term=term), *pair):
            # One mass of a sum may be wrong.
            within = term_by_term(*pair, NAMES, f"{{term}}{term}") if all(pair) and variables != NAMES else None
            only = within[0] if within and len(within) == 1 and len(pair[1].numer) > 1 else None
            found.append(Difference(term, *(only[1:] if only else (sentence, _is_slip(*pair)))))
    return found


def _is_slip(yours: FracElement, right: FracElement) -> bool:
    """Tell whether a coefficient is missing, has the wrong sign, is off by a factor of 2, or has m for m′."""
    return yours in (0, -right, 2 * right, right / 2, _interchanged(right))


def _interchanged(formula: FracElement) -> FracElement:
    """Return a formula with m and m′ in each other's place."""
    return FIELD.from_expr(formula.as_expr().xreplace({m: m_prime, m_prime: m}))


def _coefficients(formula: FracElement, variables: tuple[str, ...]) -> dict[tuple[int, ...], FracElement] | None:
    """Return products of variables and what multiplies each; None if a variable is below a fraction line."""
    chosen = [name in variables for name in NAMES]
    if any(n and c for powers in formula.denom for n, c in zip(powers, chosen, strict=True)):
        return None
    found: dict[tuple[int, ...], FracElement] = {}
    for powers, number_of in formula.numer.items():
        product = tuple(n * c for n, c in zip(powers, chosen, strict=True))
        rest = tuple(n - used for n, used in zip(powers, product, strict=True))
        found[product] = found.get(product, FIELD.zero) + FIELD(FIELD.ring({rest: number_of})) / FIELD(formula.denom)
    return found


def _coefficient(term: str, yours: FracElement, right: FracElement) -> str | None:
    """Return how a coefficient differs, None if it does not."""
    if yours == right:
        return None
    if not right:
        if not term:
            return _("Your answer contains a constant term. The right answer has none.")
        return _("Your answer contains a term with {term}. The right answer has none.").format(term=term)
    if not yours:
        missing = _("The term with {term} is missing.") if term else _("The constant term is missing.")
        return missing.format(term=term)
    if term and {"m", "m'"} <= names_in(right) and yours == _interchanged(right):
        return _("In your coefficient of {term} m and m′ are interchanged.").format(term=term)
    ratio = yours / right
    factor = shown_factor(ratio)
    if factor is None:
        wrong = _("Your coefficient of {term} is wrong.") if term else _("Your constant term is wrong.")
        return wrong.format(term=term)
    if not term:
        times, sign = _("Your constant term is {times} the right one."), _("Your constant term has the wrong sign.")
        return _size_and_sign(factor, times, sign)
    if named := not factor.startswith("−") and _names_off(term, ratio, right):
        return named
    should = (
        _("Your coefficient of {term} should be negative.")
        if right.numer.LC < 0
        else _("Your coefficient of {term} should be positive.")
    )
    times = _("Your coefficient of {term} is {times} the right one.")
    return _size_and_sign(factor, times, should, term=term)


def _names_off(term: str, ratio: FracElement, right: FracElement) -> str | None:
    """Return which names differ, if the two coefficients differ by names alone."""
    above, below = ratio.numer, ratio.denom
    if not names_in(ratio) or above.LC * below.LC != 1:
        return None
    if below == 1:
        extra = _("Your coefficient of {term} contains an extra factor {factor}.")
        return extra.format(term=term, factor=shown_factor(ratio))
    if above == 1:
        lacks = _("Your coefficient of {term} lacks a factor {factor}.")
        return lacks.format(term=term, factor=shown_factor(1 / ratio))
    for yours, theirs in (("m", "m'"), ("m'", "m")):
        has_it = theirs in names_in(right) and yours not in names_in(right)
        if has_it and ratio == _GENERATORS[yours] / _GENERATORS[theirs]:
            instead = _("Your coefficient of {term} contains {yours} instead of {right}.")
            return instead.format(term=term, yours=shown_name(yours), right=shown_name(theirs))
    return None


def as_equation(given: FracElement, right: FracElement, variables: tuple[str, ...]) -> Differences | None:
    """Return how “given = 0” differs from “right = 0”, multiplied such that as few terms as possible differ."""
    yours, theirs = (_coefficients(each, variables) or {} for each in (given, right))
    factors = (yours[powers] / theirs[powers] for powers in yours.keys() & theirs.keys())
    compared = [term_by_term(given, right * factor, variables) for factor in factors]
    return min(filter(None, compared), key=len, default=None)


# As one fraction


def as_fraction(given: FracElement, right: FracElement) -> tuple[str, Differences] | None:
    """Return a sentence on what is right in a fraction, and how the rest of it differs; None if nothing is right.

    With the right denominator D the given numerator is given·D; with the right numerator N the denominator is N/given.
    """
    above, below = FIELD(right.numer), FIELD(right.denom)
    # TRANSLATORS: {term} is a product of symbols; the whole stands for {term} in: Your coefficient of {term} is wrong.
    numerator = term_by_term(given * below, above, NAMES, _("{term} in the numerator"))
    if numerator and not names_in(FIELD(given.denom) / below):
        return _("Written as one fraction, your answer has the right denominator."), numerator
    # TRANSLATORS: as before, of a term below the fraction line.
    denominator = term_by_term(above / given, below, NAMES, _("{term} in the denominator"))
    if denominator and not names_in(FIELD(given.numer) / above):
        return _("Written as one fraction, your answer has the right numerator."), denominator
    # A spoiled fraction may have cancelled to a simpler one: then it has neither, but can be written with one of them.
    if numerator and len(numerator) == 1:
        return _("Written with the right denominator, your answer differs in one term."), numerator
    if denominator and len(denominator) == 1:
        return _("Written with the right numerator, your answer differs in one term."), denominator
    return None
