"""Compare a wrong answer with the right one, coefficient by coefficient or as one fraction.

A formula is an element of SymPy's fraction field ℤ(m, m′, k, R, X, …), where every quotient is in lowest terms.
Degrees and digits are bounded before anything is computed. Every sentence states an exact result.
"""

from dataclasses import dataclass, replace
from math import inf, prod

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers.formulas import weights
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

_MAX_WEIGHT, _MAX_TERMS = 40, 120
"""Limits on the names and numbers of a quotient, and on the terms of a polynomial."""


@dataclass(frozen=True)
class Difference:
    """A coefficient that differs from the right one.

    Parameters
    ----------
    term : the product of names that it multiplies, as shown; empty for the constant term
    sentence : a sentence about it
    is_slip : whether a slip of the pen explains it: a sign, a factor of 2, a missing term, m for m′
    cancels : whether the term is in the answer as typed, but its parts add up to zero
    """

    term: str
    sentence: str
    is_slip: bool
    cancels: bool = False


Differences = list[Difference]


@dataclass(frozen=True)
class _Words:
    """The sentences about one coefficient."""

    extra: str
    missing: str
    cancels: str
    wrong: str
    multiple: str
    positive: str
    negative: str


_OF_A_TERM = _Words(
    extra=_("Your answer contains a term with {term}. The right answer has none."),
    missing=_("The term with {term} is missing."),
    cancels=_("In your answer the terms with {term} cancel."),
    wrong=_("Your coefficient of {term} is wrong."),
    multiple=_("Your coefficient of {term} is {times} the right one."),
    positive=_("Your coefficient of {term} should be positive."),
    negative=_("Your coefficient of {term} should be negative."),
)
_OF_THE_CONSTANT = _Words(
    extra=_("Your answer contains a constant term. The right answer has none."),
    missing=_("The constant term is missing."),
    cancels=_("In your answer the constant terms cancel."),
    wrong=_("Your constant term is wrong."),
    multiple=_("Your constant term is {times} the right one."),
    positive=_("Your constant term has the wrong sign."),
    negative=_("Your constant term has the wrong sign."),
)


class NotComparableError(ValueError):
    """The formula cannot be written out; the message tells the student."""


_TOO_LARGE = _("Your answer differs from the right one. It cannot be compared term by term.")


def _check_size(expression: sp.Expr) -> None:
    """Raise if the lowest terms of a formula would take long to find.

    A sum of few terms is multiplied out at once. The common factors of a quotient take longer.
    """
    if _terms(expression) > _MAX_TERMS and weights(expression).total() > _MAX_WEIGHT:
        raise NotComparableError(_TOO_LARGE)


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


@dataclass(frozen=True)
class Compared:
    """An answer and the right one in lowest terms.

    Parameters
    ----------
    given : the answer
    right : what it should be
    typed : the answer with every minus sign replaced by a plus, so that no two of its terms cancel
    """

    given: FracElement
    right: FracElement
    typed: FracElement

    def differences(self, variables: tuple[str, ...], place: str = "{term}") -> Differences | None:
        """Return the coefficients that differ; None if the answer is not a polynomial in the variables.

        Parameters
        ----------
        variables : the names in whose products both formulas are written; the coefficients may contain the others
        place : a template that says where these terms are, such as "{term} in the numerator"
        """
        given, right, typed = (_coefficients(each, variables) for each in (self.given, self.right, self.typed))
        if given is None or right is None:
            return None
        differences = []
        for powers in sorted(given.keys() | right.keys(), reverse=True):
            coefficients = Compared(*(each.get(powers, FIELD.zero) for each in (given, right, typed or {})))
            if coefficients.given != coefficients.right:
                product = _shown_product(powers)
                term = place.format(term=product) if product else ""
                differences.append(coefficients._difference(product, term, variables))
        return differences

    def _difference(self, product: str, term: str, variables: tuple[str, ...]) -> Difference:
        """Return how a coefficient differs; if it is a sum, only one mass of it may be wrong."""
        if variables != NAMES and self.given and len(self.right.numer) > 1:
            within = self.differences(NAMES, f"{{term}}{product}")
            if within and len(within) == 1:
                return replace(within[0], term=product)
        cancels = bool(self.typed) and not self.given
        return Difference(product, self._sentence(term), self._is_slip(), cancels)

    def _is_slip(self) -> bool:
        right = self.right
        return self.given in (0, -right, 2 * right, right / 2, _interchanged(right))

    def _sentence(self, term: str) -> str:
        """Return a sentence about a coefficient that differs."""
        words = _OF_A_TERM if term else _OF_THE_CONSTANT
        if not self.right:
            return words.extra.format(term=term)
        if not self.given:
            return (words.cancels if self.typed else words.missing).format(term=term)
        if term and {"m", "m'"} <= names_in(self.right) and self.given == _interchanged(self.right):
            return _("In your coefficient of {term} m and m′ are interchanged.").format(term=term)
        factor = shown_factor(self.given / self.right)
        if factor is None:
            return words.wrong.format(term=term)
        if term and (sentence := self._names_off(term)):
            return sentence
        sign = words.negative if self.right.numer.LC < 0 else words.positive
        return _size_and_sign(factor, words.multiple, sign, term=term)

    def _names_off(self, term: str) -> str | None:
        """Return which names differ, if the coefficients differ in names alone."""
        ratio = self.given / self.right
        if not names_in(ratio) or ratio.numer.LC * ratio.denom.LC != 1:
            return None
        if ratio.denom == 1:
            extra = _("Your coefficient of {term} contains an extra factor {factor}.")
            return extra.format(term=term, factor=shown_factor(ratio))
        if ratio.numer == 1:
            lacks = _("Your coefficient of {term} lacks a factor {factor}.")
            return lacks.format(term=term, factor=shown_factor(1 / ratio))
        for yours, theirs in (("m", "m'"), ("m'", "m")):
            replaces = theirs in names_in(self.right) and yours not in names_in(self.right)
            if replaces and ratio == _GENERATORS[yours] / _GENERATORS[theirs]:
                instead = _("Your coefficient of {term} contains {yours} instead of {right}.")
                return instead.format(term=term, yours=shown_name(yours), right=shown_name(theirs))
        return None

    # Of the whole formula

    def of_equation(self, variables: tuple[str, ...]) -> Differences | None:
        """Return how “given = 0” differs from “right = 0”, multiplied such that as few terms as possible differ."""
        given, right = (_coefficients(each, variables) or {} for each in (self.given, self.right))
        factors = [given[powers] / right[powers] for powers in given.keys() & right.keys()]
        compared = [replace(self, right=self.right * factor).differences(variables) for factor in factors]
        return min(filter(None, compared), key=len, default=None)

    def of_fraction(self) -> tuple[str, Differences] | None:
        """Return a sentence on what is right in a fraction, and how the rest differs; None if nothing is right.

        With the right denominator D the given numerator is given·D; with the right numerator N the denominator is
        N/given.
        """
        above, below = FIELD(self.right.numer), FIELD(self.right.denom)
        numerators = Compared(self.given * below, above, self.typed * below)
        denominators = Compared(above / self.given, below, above / self.typed)
        # TRANSLATORS: {term} is a product of symbols; the whole stands for {term} in: Your coefficient of {term} is …
        numerator = numerators.differences(NAMES, _("{term} in the numerator"))
        # TRANSLATORS: as before, of a term below the fraction line.
        denominator = denominators.differences(NAMES, _("{term} in the denominator"))
        if numerator and not names_in(FIELD(self.given.denom) / below):
            return _("Written as one fraction, your answer has the right denominator."), numerator
        if denominator and not names_in(FIELD(self.given.numer) / above):
            return _("Written as one fraction, your answer has the right numerator."), denominator
        # A wrong fraction may have cancelled: then neither part is right, but the fraction can be expanded.
        if numerator and len(numerator) == 1:
            return _("Written with the right denominator, your answer differs in one term."), numerator
        if denominator and len(denominator) == 1:
            return _("Written with the right numerator, your answer differs in one term."), denominator
        return None


def _interchanged(formula: FracElement) -> FracElement:
    """Return a formula with m and m′ interchanged."""
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
