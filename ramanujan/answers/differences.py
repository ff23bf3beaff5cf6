"""The difference between a wrong answer and the right one: a factor, one term, or a letter.

Every sentence states an exact result. If more than one term differs, there is no sentence.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp
from sympy.polys.fields import FracElement

from ramanujan.answers.questions import EQUATION, NUMBER, POLYNOMIAL, Question
from ramanujan.answers.spelling import MOTION, SYMBOLS
from ramanujan.answers.terms import FIELD, NAMES, collect_coefficients, find_names
from ramanujan.answers.typed_formulas import leaves
from ramanujan.answers.values import Formula, depends_on, find_rational_ratio
from ramanujan.text.numerals import superscript
from ramanujan.text.translation import _

_SHOWN = {"eps": "ε", "Phi": "Φ", "phi": "φ", "''": "″", "'": "′"}
# TRANSLATORS: they stand for {times} in a sentence such as: Your answer is {times} the right one.
_WORDS = {"2": _("twice"), "3": _("three times"), "4": _("four times"), "1/2": _("half of")}


@dataclass(frozen=True)
class Difference:
    """A sentence about the difference between an answer and the right one.

    Parameters
    ----------
    sentence : the sentence
    term : the only term that differs, a product of names as shown; empty for the constant term, None without a term
    is_slip : whether a slip of the pen explains the difference: a sign, a factor of 2, a missing term or letter
    is_complete : whether the sentence explains everything that is wrong, including a wrong unit
    """

    sentence: str
    term: str | None = None
    is_slip: bool = False
    is_complete: bool = False


@dataclass(frozen=True)
class _Words:
    """The sentences about one term."""

    extra: str
    missing: str
    multiple: str
    sign: str


_OF_A_TERM = _Words(
    extra=_("Your answer contains a term with {term}. The right answer has none."),
    missing=_("The term with {term} is missing."),
    multiple=_("Your coefficient of {term} is {times} the right one."),
    sign=_("Your coefficient of {term} has the wrong sign."),
)
_OF_THE_CONSTANT = _Words(
    extra=_("Your answer contains a constant term. The right answer has none."),
    missing=_("The constant term is missing."),
    multiple=_("Your constant term is {times} the right one."),
    sign=_("Your constant term has the wrong sign."),
)


def find_difference(question: Question, answer: Formula) -> Difference | None:
    """Return a factor, the only term or missing letters by which an answer differs from the right one, or None."""
    if question.kind == NUMBER:
        return _compare_numbers(answer, question.right_formula)
    if question.kind == EQUATION:
        return _compare_equations(question, answer)
    if answer.fraction is None:
        return _find_root()
    right = question.right_formula.fraction
    multiple = _find_multiple(question, answer.fraction, right)
    if multiple:
        return multiple
    if question.kind == POLYNOMIAL:
        return _find_only_term(answer.fraction, right, question.variables)
    return _find_missing_letters(question, answer)


def _compare_numbers(answer: Formula, right: Formula) -> Difference | None:
    quotient = find_rational_ratio(answer.values, right.values)
    if quotient is None:
        return None
    sentence = _describe_multiple(FIELD(quotient.numerator) / quotient.denominator)
    return Difference(sentence) if sentence else None


def _compare_equations(question: Question, answer: Formula) -> Difference | None:
    only_term = None
    if answer.fraction is not None:
        right = question.right_formula.fraction
        only_term = _find_only_term_up_to_factor(answer.fraction, right, question.variables)
    # A single wrong term explains more than the form of the equation.
    if only_term:
        return only_term
    if question.variables == ("eps",) and _is_solved(answer.expression):
        value = _("Your equation gives ε a value. The question asks for the quadratic equation that ε satisfies.")
        return Difference(value, is_complete=True)
    return _find_root() if answer.fraction is None else None


def _find_root() -> Difference:
    return Difference(_("Your answer contains a root. The right one has none."))


def _is_solved(typed: sp.Expr) -> bool:
    """Return whether an equation has the form ε = value, with either sign of ε."""
    if not typed.is_Add or len(typed.args) != 2:
        return False
    left, right = (leaves(side) - {sp.S.NegativeOne} for side in typed.args)
    only_ratio = {SYMBOLS["eps"]}
    return only_ratio in (left, right) and left.isdisjoint(right)


def _find_multiple(question: Question, answer: FracElement, right: FracElement) -> Difference | None:
    """Return the factor between the whole answer and the right one, if it is a quotient of single terms."""
    if format_factor(right) is not None:
        # Any two products of names differ by such a factor.
        return None
    ratio = answer / right
    names = find_names(ratio)
    # A factor with motion changes the terms of a polynomial, so single terms are compared instead.
    has_motion = question.kind == POLYNOMIAL and names.intersection(MOTION)
    sentence = None if has_motion else _describe_multiple(ratio)
    return Difference(sentence, is_slip=not names) if sentence else None


def _find_only_term(answer: FracElement, right: FracElement, variables: tuple[str, ...]) -> Difference | None:
    """Return the only term in the variables that differs, or the only one in all names; None for several terms."""
    for names in dict.fromkeys((variables, NAMES)):
        differences = list(_compare_coefficients(answer, right, names))
        if len(differences) == 1:
            powers, yours, theirs = differences[0]
            term = _format_product(powers)
            sentence = _describe_term(term, yours, theirs)
            if sentence:
                in_variables = tuple(
                    power if name in variables else 0 for name, power in zip(NAMES, powers, strict=True)
                )
                is_slip = yours in (0, -theirs, 2 * theirs, theirs / 2)
                return Difference(sentence, term=_format_product(in_variables), is_slip=is_slip)
    return None


def _find_only_term_up_to_factor(
    answer: FracElement, right: FracElement, variables: tuple[str, ...]
) -> Difference | None:
    """Return the only term of an equation that differs, after another term has been made equal by a factor."""
    if find_names(FIELD(answer.denom)).intersection(variables):
        return None
    # Denominators without the variables are factors of the equations.
    answer, right = FIELD(answer.numer), FIELD(right.numer)
    for names in (variables, NAMES):
        yours, theirs = collect_coefficients(answer, names) or {}, collect_coefficients(right, names) or {}
        for powers in yours.keys() & theirs.keys():
            only_term = _find_only_term(answer, right * yours[powers] / theirs[powers], variables)
            if only_term:
                return only_term
    return None


def _compare_coefficients(
    answer: FracElement, right: FracElement, names: tuple[str, ...]
) -> Iterator[tuple[tuple[int, ...], FracElement, FracElement]]:
    """Yield the powers of a term, your coefficient and the right one, for each term that differs."""
    yours, theirs = collect_coefficients(answer, names), collect_coefficients(right, names)
    if yours is None or theirs is None:
        return
    for powers in yours.keys() | theirs.keys():
        coefficients = yours.get(powers, FIELD.zero), theirs.get(powers, FIELD.zero)
        if coefficients[0] != coefficients[1]:
            yield powers, *coefficients


def _find_missing_letters(question: Question, answer: Formula) -> Difference | None:
    needed = [name for name in ("m", "m'", "k", "R") if SYMBOLS[name] in leaves(question.right)]
    missing = [name for name in needed if not depends_on(answer.expression, SYMBOLS[name])]
    if not missing:
        return None
    # TRANSLATORS: {quantity} is what is asked for, such as the kinetic energy of the block; {names} are symbols.
    sentence = _("Your answer does not depend on {names}, but {quantity} does.")
    return Difference(sentence.format(names=join_names(missing), quantity=question.quantity), is_slip=True)


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


def _describe_term(term: str, yours: FracElement, theirs: FracElement) -> str | None:
    """Return a sentence about a coefficient that differs, None if a sum of masses in it differs."""
    words = _OF_A_TERM if term else _OF_THE_CONSTANT
    if not theirs:
        return words.extra.format(term=term)
    if not yours:
        return words.missing.format(term=term)
    factor = format_factor(yours / theirs)
    return _describe_size_and_sign(factor, words.multiple, words.sign, term) if factor else None


def _describe_multiple(ratio: FracElement) -> str | None:
    """Return a sentence about the factor between the typed answer and the right one, None if it has more terms."""
    times, sign = _("Your answer is {times} the right one."), _("Your answer has the wrong sign.")
    factor = format_factor(ratio)
    return _describe_size_and_sign(factor, times, sign) if factor else None


def _describe_size_and_sign(factor: str, times: str, sign: str, term: str = "") -> str:
    """Return a sentence about the size of a factor, after a sentence about its sign if the factor is negative.

    Parameters
    ----------
    factor : the factor, as shown
    times, sign : templates of the two sentences
    term : the term in the templates
    """
    unsigned = factor.removeprefix("−")
    # TRANSLATORS: stands for {times} in a sentence such as: Your answer is {times} the right one.
    size = _WORDS.get(unsigned) or _("{factor} times").format(factor=unsigned)
    if not factor.startswith("−"):
        return times.format(times=size, term=term)
    wrong_sign = sign.format(term=term)
    if factor == "−1":
        return wrong_sign
    wrong_size = _("Its size is {times} the right one.").format(times=size)
    return f"{wrong_sign} {wrong_size}"
