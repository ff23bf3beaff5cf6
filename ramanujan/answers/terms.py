"""Compare a wrong answer with the right one, coefficient by coefficient or as one fraction.

A formula is an element of SymPy's fraction field ℤ(m, m′, k, R, X, …), where every quotient is in lowest terms.
Degrees and digits are bounded before anything is computed. Every sentence states an exact result.
"""

from dataclasses import dataclass, replace
from math import inf, prod

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers.formulas import count_leaves
from ramanujan.answers.spelling import SYMBOLS
from ramanujan.answers.values import find_decimals
from ramanujan.derivation.model import epsilon, m, m_prime
from ramanujan.numerals import filled, superscript
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
class TermDifference:
    """A coefficient that differs from the right one.

    Parameters
    ----------
    term : the product of names after the coefficient, as shown; empty for the constant term
    sentence : a sentence about the coefficient
    is_slip : whether a slip of the pen explains the difference: a sign, a factor of 2, a missing term, m for m′
    cancels : whether the typed answer contains the term, but its parts add up to zero
    """

    term: str
    sentence: str
    is_slip: bool
    cancels: bool = False


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
    """The formula cannot be expanded into terms; the message is for the student."""


_TOO_LARGE = _("Your answer differs from the right one. It cannot be compared term by term.")


def _check_size(expression: sp.Expr) -> None:
    """Raise an error if the reduction of a formula to lowest terms would take long.

    Expanding a formula with few terms is fast. Finding the common factors of a large quotient is slow.

    Raises
    ------
    NotComparableError : the formula has too many terms, and too many names and numbers.
    """
    if _count_terms(expression) > _MAX_TERMS and count_leaves(expression).total() > _MAX_WEIGHT:
        raise NotComparableError(_TOO_LARGE)


def _count_terms(expression: sp.Expr) -> float:
    """Return an upper bound of the number of terms after expansion.

    The bound is infinite if a sum has a negative or a fractional exponent.
    """
    if expression.is_Add:
        return sum(map(_count_terms, expression.args))
    if expression.is_Mul:
        return prod(map(_count_terms, expression.args))
    if not expression.is_Pow:
        return 1
    terms, exponent = _count_terms(expression.base), expression.exp
    if terms <= 1:
        return terms
    if exponent.is_Integer and exponent > 0:
        return terms ** int(exponent)
    return inf


def find_names(formula: FracElement) -> frozenset[str]:
    """Return the names on which a formula depends."""
    # Each key of a polynomial contains the powers of NAMES in one of its terms.
    powers_of_terms = [*formula.numer, *formula.denom]
    powers_of_names = zip(NAMES, zip(*powers_of_terms, strict=True), strict=True)
    return frozenset(name for name, powers in powers_of_names if any(powers))


def to_fraction(expression: sp.Expr, *, is_in_ratio: bool = False) -> FracElement:
    """Return a formula in lowest terms.

    Parameters
    ----------
    expression : the formula, which may be unevaluated
    is_in_ratio : whether to replace m′ by εm, for a formula in the mass ratio; otherwise m′/m replaces ε

    Raises
    ------
    NotComparableError : the formula is too large, or contains a root.
    """
    _check_size(expression)
    masses = {m_prime: epsilon * m} if is_in_ratio else {epsilon: m_prime / m}
    numbers = {decimal: sp.Rational(decimal.name) for decimal in find_decimals(expression)}
    try:
        return FIELD.from_expr(expression.xreplace(masses | numbers).doit())
    except ValueError:
        raise NotComparableError(_("Your answer contains a root. The right one has none.")) from None


# In words


def format_name(name: str) -> str:
    """Return a name with its Greek letters and primes, for a sentence."""
    for typed, shown in _SHOWN.items():
        name = name.replace(typed, shown)
    return name


def join_names(names: list[str]) -> str:
    """Return names as a list in a sentence: "m, k and R"."""
    *first, last = map(format_name, names)
    return _("{names} and {last}").format(names=", ".join(first), last=last) if first else last


def _format_product(powers: tuple[int, ...]) -> str:
    factors = []
    for name, power in zip(NAMES, powers, strict=True):
        if power:
            factors.append(format_name(name) + (superscript(power) if power > 1 else ""))
    return "".join(factors)


def format_factor(factor: FracElement) -> str | None:
    """Return a quotient of two single terms as text, such as 3m′/(2m); None for a factor with more terms."""
    if len(factor.numer) != 1 or len(factor.denom) != 1:
        return None
    ((numerator_powers, p),) = factor.numer.items()
    ((denominator_powers, q),) = factor.denom.items()
    numerator = (str(abs(int(p))) if abs(p) != 1 else "") + _format_product(numerator_powers)
    denominator = (str(int(q)) if q != 1 else "") + _format_product(denominator_powers)
    shown = ("−" if p < 0 else "") + (numerator or "1")
    if not denominator:
        return shown
    factors_below = sum(power > 0 for power in denominator_powers) + (q != 1)
    if factors_below == 1:
        return f"{shown}/{denominator}"
    return f"{shown}/({denominator})"


def describe_factor(factor: str) -> str:
    """Return a factor in words, such as "twice" or "3/2 times", for a sentence that continues with "the right one"."""
    # TRANSLATORS: stands for {times} in a sentence such as: Your answer is {times} the right one.
    return _WORDS.get(factor) or _("{factor} times").format(factor=factor)


def summarize(differences: list[TermDifference]) -> list[str]:
    """Return the sentences about the differences. If there are many, return their number and the first sentence."""
    sentences = [difference.sentence for difference in differences]
    if len(sentences) <= _MOST_SENTENCES:
        return sentences
    n = len(sentences)
    differ = ngettext("One term differs from the right one.", "{n:Word} terms differ from the right ones.", n)
    return [filled(differ, n=n), sentences[0]]


def describe_multiple(ratio: FracElement) -> list[str]:
    """Return a sentence with the ratio of the typed answer to the right one.

    The list is empty unless the ratio is a quotient of two single terms.
    """
    factor = format_factor(ratio)
    if factor is None:
        return []
    times, sign = _("Your answer is {times} the right one."), _("Your answer has the wrong sign.")
    return [_describe_size_and_sign(factor, times, sign)]


def _describe_size_and_sign(factor: str, times: str, sign: str, **names: str) -> str:
    """Return a sentence about the size of a factor, after a sentence about its sign if the factor is negative.

    Parameters
    ----------
    factor : the factor, as shown
    times, sign : templates of the two sentences
    names : values of the other slots in the templates
    """
    size = describe_factor(factor.removeprefix("−"))
    if not factor.startswith("−"):
        return times.format(times=size, **names)
    wrong_sign = sign.format(**names)
    if factor == "−1":
        return wrong_sign
    wrong_size = _("Its size is {times} the right one.").format(times=size)
    return f"{wrong_sign} {wrong_size}"


# Term by term


@dataclass(frozen=True)
class Comparison:
    """An answer and the right one in lowest terms.

    Parameters
    ----------
    typed : the answer
    right : the right answer
    without_signs : the answer with every minus sign replaced by a plus, so that no two of its terms cancel
    """

    typed: FracElement
    right: FracElement
    without_signs: FracElement

    def differences(self, variables: tuple[str, ...], place: str = "{term}") -> list[TermDifference] | None:
        """Return the coefficients that differ, None if the answer is not a polynomial in the variables.

        Parameters
        ----------
        variables : the variables of the polynomials; their coefficients may contain all other names
        place : a template for a term and its place, such as "{term} in the numerator"
        """
        typed = _collect_coefficients(self.typed, variables)
        right = _collect_coefficients(self.right, variables)
        without_signs = _collect_coefficients(self.without_signs, variables) or {}
        if typed is None or right is None:
            return None
        differences = []
        for powers in sorted(typed.keys() | right.keys(), reverse=True):
            coefficients = Comparison(
                typed.get(powers, FIELD.zero), right.get(powers, FIELD.zero), without_signs.get(powers, FIELD.zero)
            )
            if coefficients.typed != coefficients.right:
                product = _format_product(powers)
                term = place.format(term=product) if product else ""
                differences.append(coefficients._describe_coefficient(product, term, variables))
        return differences

    def _describe_coefficient(self, product: str, term: str, variables: tuple[str, ...]) -> TermDifference:
        """Return how a coefficient differs.

        For a sum of masses in which only one term is wrong, the sentence is about that term.
        """
        is_sum_of_masses = variables != NAMES and len(self.right.numer) > 1
        if is_sum_of_masses and self.typed:
            of_masses = self.differences(NAMES, f"{{term}}{product}")
            if of_masses and len(of_masses) == 1:
                return replace(of_masses[0], term=product)
        cancels = bool(self.without_signs) and not self.typed
        sentence = self._describe_wrong_coefficient(term)
        return TermDifference(product, sentence, is_slip=self._is_slip(), cancels=cancels)

    def _is_slip(self) -> bool:
        right = self.right
        return self.typed in (0, -right, 2 * right, right / 2, _interchange_masses(right))

    def _describe_wrong_coefficient(self, term: str) -> str:
        """Return a sentence about a coefficient that differs."""
        words = _OF_A_TERM if term else _OF_THE_CONSTANT
        if not self.right:
            return words.extra.format(term=term)
        if not self.typed:
            return (words.cancels if self.without_signs else words.missing).format(term=term)
        if term and {"m", "m'"} <= find_names(self.right) and self.typed == _interchange_masses(self.right):
            return _("In your coefficient of {term} m and m′ are interchanged.").format(term=term)
        factor = format_factor(self.typed / self.right)
        if factor is None:
            return words.wrong.format(term=term)
        sentence_about_names = self._compare_names(term) if term else None
        if sentence_about_names:
            return sentence_about_names
        sign = words.negative if self.right.numer.LC < 0 else words.positive
        return _describe_size_and_sign(factor, words.multiple, sign, term=term)

    def _compare_names(self, term: str) -> str | None:
        """Return a sentence about the names in which the coefficients differ, None if their numbers differ, too."""
        ratio = self.typed / self.right
        if not find_names(ratio) or ratio.numer.LC * ratio.denom.LC != 1:
            return None
        if ratio.denom == 1:
            extra = _("Your coefficient of {term} contains an extra factor {factor}.")
            return extra.format(term=term, factor=format_factor(ratio))
        if ratio.numer == 1:
            lacks = _("Your coefficient of {term} lacks a factor {factor}.")
            return lacks.format(term=term, factor=format_factor(1 / ratio))
        for yours, theirs in (("m", "m'"), ("m'", "m")):
            replaces = theirs in find_names(self.right) and yours not in find_names(self.right)
            if replaces and ratio == _GENERATORS[yours] / _GENERATORS[theirs]:
                instead = _("Your coefficient of {term} contains {yours} instead of {right}.")
                return instead.format(term=term, yours=format_name(yours), right=format_name(theirs))
        return None

    # The whole formula

    def equation_differences(self, variables: tuple[str, ...]) -> list[TermDifference] | None:
        """Return the differences of the equations “typed = 0” and “right = 0”.

        The right equation is first multiplied by a factor, which makes one of its terms equal to the typed one. The
        factor with the fewest differences counts.
        """
        typed = _collect_coefficients(self.typed, variables) or {}
        right = _collect_coefficients(self.right, variables) or {}
        alternatives = []
        for powers in typed.keys() & right.keys():
            factor = typed[powers] / right[powers]
            differences = replace(self, right=self.right * factor).differences(variables)
            if differences:
                alternatives.append(differences)
        return min(alternatives, key=len, default=None)

    def fraction_differences(self) -> tuple[str, list[TermDifference]] | None:
        """Return a sentence about the correct numerator or denominator, and the differences in the other part; or None.

        Let N/D be the right answer. With the denominator D, the typed answer is (typed·D)/D. With the numerator N, it
        is N/(N/typed).
        """
        N, D = FIELD(self.right.numer), FIELD(self.right.denom)
        numerators = Comparison(self.typed * D, N, self.without_signs * D)
        denominators = Comparison(N / self.typed, D, N / self.without_signs)
        # TRANSLATORS: {term} is a product of symbols; the whole stands for {term} in: Your coefficient of {term} is …
        numerator = numerators.differences(NAMES, _("{term} in the numerator"))
        # TRANSLATORS: as before, of a term below the fraction line.
        denominator = denominators.differences(NAMES, _("{term} in the denominator"))
        if numerator and not find_names(FIELD(self.typed.denom) / D):
            return _("Written as one fraction, your answer has the right denominator."), numerator
        if denominator and not find_names(FIELD(self.typed.numer) / N):
            return _("Written as one fraction, your answer has the right numerator."), denominator
        # Reducing a wrong fraction to lowest terms may change both parts. Then the expanded fraction is compared.
        if numerator and len(numerator) == 1:
            return _("Written with the right denominator, your answer differs in one term."), numerator
        if denominator and len(denominator) == 1:
            return _("Written with the right numerator, your answer differs in one term."), denominator
        return None


def _interchange_masses(formula: FracElement) -> FracElement:
    """Return a formula with m and m′ interchanged."""
    return FIELD.from_expr(formula.as_expr().xreplace({m: m_prime, m_prime: m}))


def _collect_coefficients(
    formula: FracElement, variables: tuple[str, ...]
) -> dict[tuple[int, ...], FracElement] | None:
    """Return product of variables → its coefficient, None if a variable is below a fraction line.

    A product is a tuple with the power of each of `NAMES`.
    """
    is_variable = [name in variables for name in NAMES]
    denominator = FIELD(formula.denom)
    if find_names(denominator).intersection(variables):
        return None
    coefficients: dict[tuple[int, ...], FracElement] = {}
    for powers, number in formula.numer.items():
        # Split the product into its variables and the other names, which belong to the coefficient.
        product = tuple(power if chosen else 0 for power, chosen in zip(powers, is_variable, strict=True))
        other_powers = tuple(0 if chosen else power for power, chosen in zip(powers, is_variable, strict=True))
        coefficient = FIELD(FIELD.ring({other_powers: number})) / denominator
        coefficients[product] = coefficients.get(product, FIELD.zero) + coefficient
    return coefficients
