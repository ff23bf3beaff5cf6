"""Text to expression: the small grammar in which a student types a formula.

    sum      = product { (+ | −) product }
    product  = factor { (* | / | nothing) factor }
    factor   = { + | − } primary [ ^ exponent ]
    primary  = number | name | √ primary | ( sum )

Lives here: the expression tree, the grammar and its limits. Not here: what an expression means or whether it is right.
Text is only ever compared with the grammar; nothing in it is executed or looked up anywhere else.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, prod

NAMES = ("m", "m'", "k", "R", "X", "X'", "phi", "phi'", "Phi", "Phi'", "eps")
"""Every name the grammar knows, as one types it."""

MAX_LENGTH, MAX_DEPTH, MAX_DIGITS, MAX_EXPONENT, MAX_WEIGHT = 300, 20, 20, 12, 120
"""Limits on characters, nested brackets, digits of a number, |exponent| and `weight`: they bound all later work."""


class UnreadableError(ValueError):
    """The text is no formula of the grammar; the message is one sentence for the student."""


@dataclass(frozen=True)
class Number:
    """A number as typed; 0.5 and ½ are the same."""

    value: Fraction


@dataclass(frozen=True)
class Name:
    """One of `NAMES`."""

    name: str


@dataclass(frozen=True)
class Sum:
    """The sum of its terms; what is subtracted is a term times −1."""

    terms: tuple[Expression, ...]


@dataclass(frozen=True)
class Product:
    """The product of its factors; what divides is a factor to a negative power."""

    factors: tuple[Expression, ...]


@dataclass(frozen=True)
class Power:
    """base ^ exponent; the exponent is a multiple of ½, so that a quotient and a root are powers too."""

    base: Expression
    exponent: Fraction


Expression = Number | Name | Sum | Product | Power


def parse(text: str) -> Expression:
    """Return the expression that a text spells.

    Parameters
    ----------
    text : a formula in the names of `NAMES` (φ, Φ, ε, ′, ², ½, √, ·, Ẋ and the like are accepted too)

    Raises
    ------
    UnreadableError : the text is no such formula, is ambiguous or exceeds a limit; the message says which.
    """
    if not isinstance(text, str):
        raise UnreadableError("Type your answer as text.")
    if len(text) > MAX_LENGTH:
        raise UnreadableError(f"That is too long: use at most {MAX_LENGTH} characters.")
    tokens = list(_tokens(_plain(text)))
    if not tokens:
        raise UnreadableError("Type an expression first.")
    reader = _Reader(tokens)
    expression = reader.sum()
    if reader.next is not None:
        raise UnreadableError("A bracket is closed that was never opened.")
    return expression


def weight(expression: Expression) -> int:
    """Return how many numbers and names there are when every power is written out: a bound on degree and digits."""
    match expression:
        case Sum(parts) | Product(parts):
            return sum(map(weight, parts))
        case Power(base, exponent):
            return weight(base) * max(1, ceil(abs(exponent)))
    return 1


_HALVES = {"½": Fraction(1, 2), "¼": Fraction(1, 4), "¾": Fraction(3, 4)}
_SPELLINGS = str.maketrans(
    {
        **dict.fromkeys("′’ʹ", "'"),
        **dict.fromkeys("·×⋅∙", "*"),
        **dict.fromkeys("÷∕⁄", "/"),
        **dict.fromkeys("−–", "-"),
        **dict.fromkeys("φϕ", "phi"),
        **dict.fromkeys("εϵ", "eps"),
        **dict.fromkeys("\t\n\r\u00a0\u2009\u202f", " "),
        "Φ": "Phi",
        "√": "sqrt",
    }
)
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_RATE = re.compile("(?<=[XφϕΦ])\u0307")
_TOKEN = re.compile(
    r"(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<half>[½¼¾])|(?P<word>[A-Za-z_][A-Za-z_']*)|(?P<sign>[-+*/^()])"
)
_ALIASES = {"epsilon": "eps", "m_prime": "m'", "X_dot": "X'", "phi_dot": "phi'", "Phi_dot": "Phi'"}
# Longest first, so that m' is not read as m.
_NAME = re.compile("|".join(sorted(("sqrt", *NAMES, *_ALIASES), key=len, reverse=True)))


def _plain(text: str) -> str:
    """Return the text in ASCII spelling, except for the fractions that are one character."""
    # Decomposed, the Ẋ of a textbook is X and a dot above; composed again, nothing else is changed by this.
    text = _RATE.sub("'", unicodedata.normalize("NFD", text))
    text = re.sub("⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda found: f"^({found[0].translate(_SUPERSCRIPTS)})", text)
    return text.translate(_SPELLINGS).replace("**", "^")


def _tokens(text: str) -> Iterable[str | Fraction]:
    """Yield numbers as fractions, everything else as text."""
    position = 0
    while position < len(text):
        if text[position] == " ":
            position += 1
            continue
        found = _TOKEN.match(text, position)
        if found is None:
            raise UnreadableError(_strange(text[position]))
        position = found.end()
        if found["number"]:
            yield _number(found["number"])
        elif found["half"]:
            yield _HALVES[found["half"]]
        elif found["word"]:
            yield from _names(found["word"])
        else:
            yield found["sign"]


def _strange(character: str) -> str:
    if character in "=<>":
        return "Type only the expression, without an equals sign or what stands left of it."
    if character == ",":
        return "Write decimals with a point, and no comma."
    # The Unicode name has only capitals, digits and hyphens: safe to show wherever the character itself is not.
    name = unicodedata.name(character, "")
    return f"There is a character that does not belong in a formula{f': {name.lower()}' if name else ''}."


def _number(digits: str) -> Fraction:
    if len(digits) - digits.count(".") > MAX_DIGITS:
        raise UnreadableError(f"A number may have at most {MAX_DIGITS} digits.")
    return Fraction(digits)


def _names(word: str) -> list[str]:
    """Return the names that a run of letters is made of: mR is m and R."""
    names, position = [], 0
    while position < len(word):
        found = _NAME.match(word, position)
        if found is None:
            shown = re.sub("[^A-Za-z']", "", word)[:MAX_DIGITS]
            raise UnreadableError(f"I do not know the name “{shown}”; I know {', '.join(NAMES)} and sqrt( ).")
        names.append(_ALIASES.get(found[0], found[0]))
        position = found.end()
    return names


class _Reader:
    """Recursive descent over the tokens; `next` is the token that comes, None at the end."""

    def __init__(self, tokens: list[str | Fraction]) -> None:
        self._tokens = [*tokens, None]
        self._position = 0
        self._depth = 0

    @property
    def next(self) -> str | Fraction | None:
        return self._tokens[self._position]

    def take(self) -> str | Fraction | None:
        token = self.next
        self._position += token is not None
        return token

    def sum(self) -> Expression:
        terms = [self.product()]
        while self.next in ("+", "-"):
            negative = self.take() == "-"
            term = self.product()
            terms.append(_negative(term) if negative else term)
        return _bounded(terms[0] if len(terms) == 1 else Sum(tuple(terms)))

    def product(self) -> Expression:
        factors, divided = [self.factor()], False
        while True:
            if self.next == "*":
                self.take()
                factors.append(self.factor())
                divided = False
            elif self.next == "/":
                self.take()
                factors.append(_power(self.factor(), Fraction(-1)))
                divided = True
            elif self._starts_a_factor():
                if divided and not _is_fraction(factors):
                    raise UnreadableError("How far does the denominator reach? Put it in brackets.")
                factors.append(self.factor())
                divided = False
            else:
                return _bounded(factors[0] if len(factors) == 1 else Product(tuple(factors)))

    def factor(self) -> Expression:
        negative = False
        while self.next in ("+", "-"):
            negative ^= self.take() == "-"
        power = self.primary()
        if self.next == "^":
            self.take()
            power = _power(power, self.exponent())
        return _negative(power) if negative else power

    def exponent(self) -> Fraction:
        exponent = _constant(self.factor())
        if exponent is None or abs(exponent) > MAX_EXPONENT or exponent.denominator > 2:
            raise UnreadableError(f"An exponent has to be a whole number up to {MAX_EXPONENT}, or a half of one.")
        return exponent

    def primary(self) -> Expression:
        token = self.take()
        if isinstance(token, Fraction):
            if isinstance(self.next, Fraction):
                raise UnreadableError("Two numbers stand side by side: put a sign between them.")
            return Number(token)
        if token == "sqrt":
            return self.root()
        if token == "(":
            return self.bracket()
        if token in NAMES:
            if isinstance(self.next, Fraction):
                raise UnreadableError("A number stands right behind a name: put it in front, or write ^ for a power.")
            return Name(token)
        if token is None:
            raise UnreadableError("The expression stops too early: something is missing at the end.")
        raise UnreadableError("Something is missing between two signs or brackets.")

    def root(self) -> Expression:
        bracketed = self.next == "("
        root = _power(self._nested(self.primary), Fraction(1, 2))
        if not bracketed and self._starts_a_factor():
            raise UnreadableError("How far does the root reach? Put what is under it in brackets.")
        return root

    def bracket(self) -> Expression:
        inside = self._nested(self.sum)
        if self.take() != ")":
            raise UnreadableError("A bracket is opened but not closed.")
        if isinstance(self.next, Fraction):
            raise UnreadableError("A number stands right behind a bracket: put it in front, or write ^ for a power.")
        return inside

    def _nested(self, read: Callable[[], Expression]) -> Expression:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise UnreadableError(f"Brackets and roots may be nested at most {MAX_DEPTH} deep.")
        inside = read()
        self._depth -= 1
        return inside

    def _starts_a_factor(self) -> bool:
        return isinstance(self.next, Fraction) or self.next in (*NAMES, "sqrt", "(")


def _negative(expression: Expression) -> Expression:
    return Number(-expression.value) if isinstance(expression, Number) else Product((Number(Fraction(-1)), expression))


def _power(base: Expression, exponent: Fraction) -> Expression:
    return _bounded(Power(base, exponent))


def _is_fraction(factors: list[Expression]) -> bool:
    """Tell whether the last factors are a number over a number: 1/2 m is a half of m, but k/2m may be two things."""
    match factors:
        case [*_, Number(), Power(Number(), _)]:
            return True
    return False


def _constant(expression: Expression) -> Fraction | None:
    """Return the value of an expression of numbers that is small enough to be an exponent, None for any other."""
    match expression:
        case Number(value) if abs(value) <= MAX_EXPONENT:
            return value
        case Sum(parts) | Product(parts):
            values = [_constant(part) for part in parts]
            if None not in values:
                return sum(values) if isinstance(expression, Sum) else prod(values)
        case Power(base, exponent) if exponent.denominator == 1:
            value = _constant(base)
            return None if value is None or (value == 0 and exponent < 0) else value**exponent
    return None


def _bounded(expression: Expression) -> Expression:
    if weight(expression) > MAX_WEIGHT:
        raise UnreadableError("That is too large for me to check: write it shorter or with smaller exponents.")
    return expression
