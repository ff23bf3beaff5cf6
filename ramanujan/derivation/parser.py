"""Text to expression: the small grammar in which a student types a formula.

    sum      = product { (+ | −) product }
    product  = factor { (* | / | nothing) factor }
    factor   = { + | − } primary [ ^ exponent ]
    primary  = number | name | √ primary | ( sum )

The text is only compared with this grammar. Nothing in it is executed or passed to SymPy's own parser.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator
from fractions import Fraction
from math import prod

from ramanujan.derivation.expressions import NAMES, Expression, Name, Number, Power, Product, Sum, weight
from ramanujan.numerals import FROM_SUPERSCRIPTS
from ramanujan.translation import _

MAX_LENGTH, MAX_DEPTH, MAX_DIGITS, MAX_EXPONENT, MAX_WEIGHT = 300, 20, 20, 12, 120
"""Limits on characters, nested brackets, digits of a number, |exponent| and `weight`: they bound all later work."""


class UnreadableError(ValueError):
    """The text is not a formula of the grammar; the message tells the student why."""


def parse(text: str) -> Expression:
    """Return the expression that a text spells.

    Parameters
    ----------
    text : a formula in the names of `NAMES` (φ, Φ, ε, ′, ², ½, √, ·, Ẋ, dX/dt and the like are accepted too)

    Raises
    ------
    UnreadableError : the text is not such a formula, is ambiguous, or exceeds a limit; the message says which.
    """
    if not isinstance(text, str):
        raise UnreadableError(_("Type your answer as text."))
    if len(text) > MAX_LENGTH:
        raise UnreadableError(_("The formula is too long. Use at most {most} characters.").format(most=MAX_LENGTH))
    plain = _plain(text)
    if "=" in plain or "≈" in plain:
        raise UnreadableError(_("Type only the right side of the equation, without the equals sign."))
    tokens = list(_tokens(plain))
    if not tokens:
        raise UnreadableError(_("Type a formula first."))
    reader = _Reader(tokens)
    expression = reader.sum()
    if reader.next is not None:
        raise UnreadableError(_("There is a closing bracket without an opening bracket."))
    return expression


_FRACTIONS = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
_SPELLINGS = str.maketrans(
    {
        **dict.fromkeys("′’ʹ´`‘", "'"),
        **dict.fromkeys("·×⋅∙∗", "*"),
        **dict.fromkeys("÷∕⁄", "/"),
        **dict.fromkeys("−–", "-"),
        **dict.fromkeys("φϕ", "phi"),
        **dict.fromkeys("εϵɛ", "eps"),
        **dict.fromkeys("\t\n\r\u00a0\u2009\u202f", " "),
        "[": "(",
        "]": ")",
        "Φ": "Phi",
        "√": "sqrt",
    }
)
_DOT = re.compile("(?<=[XφϕΦ])\u0307")
_LEIBNIZ = re.compile(r"\bd ?(X|phi|Phi) ?/ ?dt\b")
_TOKEN = re.compile(
    rf"(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<fraction>[{_FRACTIONS}])|(?P<word>[A-Za-z_][A-Za-z_']*)"
    r"|(?P<sign>[-+*/^()])"
)
_RATES = {
    f"{before}{name}{after}": f"{name}'"
    for name in ("X", "phi", "Phi")
    for before, after in (("", "_dot"), ("", "dot"), ("d", ""))
}
_ALIASES = {"epsilon": "eps", "varepsilon": "eps", "varphi": "phi", "m_prime": "m'", **_RATES}
# Longest first, so that m' is not read as m.
_NAME = re.compile("|".join(sorted(("sqrt", *NAMES, *_ALIASES), key=len, reverse=True)))


def _plain(text: str) -> str:
    """Return the text in ASCII spelling, except for the fractions that are one character."""
    # Decomposed, the Ẋ of a textbook is X and a dot above; composed again, nothing else is changed by this.
    text = _DOT.sub("'", unicodedata.normalize("NFD", text))
    text = re.sub("⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda found: f"^({found[0].translate(FROM_SUPERSCRIPTS)})", text)
    return _LEIBNIZ.sub(r"\1'", text.translate(_SPELLINGS).replace("**", "^"))


def _tokens(text: str) -> Iterator[tuple[str | Number, bool]]:
    """Yield numbers, names and signs, each with whether a space comes before it."""
    position, spaced = 0, False
    while position < len(text):
        if text[position] == " ":
            position, spaced = position + 1, True
            continue
        found = _TOKEN.match(text, position)
        if found is None:
            raise UnreadableError(_strange(text[position]))
        position = found.end()
        if found["number"]:
            yield _number(found["number"]), spaced
        elif found["fraction"]:
            yield Number(Fraction(unicodedata.numeric(found[0])).limit_denominator(10)), spaced
        elif found["word"]:
            for name in _names(found["word"]):
                yield name, spaced
                spaced = False
        else:
            yield found["sign"], spaced
        spaced = False


def _strange(character: str) -> str:
    if character in "Ωω":
        return _("Type only the right side of the equation: a formula without Ω.")
    if character in "<>":
        return _("Type a formula, not a comparison.")
    if character == ",":
        return _("Write decimals with a point, not with a comma.")
    # The Unicode name has only capitals, digits and hyphens: safe to show wherever the character itself is not.
    name = unicodedata.name(character, "")
    if not name:
        return _("One character does not belong in a formula.")
    return _("This character does not belong in a formula: {name}.").format(name=name.lower())


def _number(digits: str) -> Number:
    whole, point, decimals = digits.partition(".")
    if len(whole) + len(decimals) > MAX_DIGITS:
        raise UnreadableError(_("A number may have at most {most} digits.").format(most=MAX_DIGITS))
    return Number(Fraction(digits), len(decimals) if point else None)


def _names(word: str) -> list[str]:
    """Return the names that a run of letters is made of: mR is m and R."""
    names, position = [], 0
    while position < len(word):
        found = _NAME.match(word, position)
        if found is None:
            shown = re.sub("[^A-Za-z']", "", word)[:MAX_DIGITS]
            unknown = _("“{name}” is not known here. You may use {names} and sqrt( ).")
            raise UnreadableError(unknown.format(name=shown, names=", ".join(NAMES)))
        names.append(_ALIASES.get(found[0], found[0]))
        position = found.end()
    return names


class _Reader:
    """Recursive descent over the tokens; `next` is the token that comes, None at the end."""

    def __init__(self, tokens: list[tuple[str | Number, bool]]) -> None:
        self._tokens = [*tokens, (None, False)]
        self._position = 0
        self._depth = 0

    @property
    def next(self) -> str | Number | None:
        return self._tokens[self._position][0]

    @property
    def spaced(self) -> bool:
        return self._tokens[self._position][1]

    def take(self) -> str | Number | None:
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
        factors, reach_is_clear = [self.factor()], True
        while True:
            if self.next == "*":
                self.take()
                factors.append(self.factor())
                reach_is_clear = True
            elif self.next == "/":
                self.take()
                bracketed = self.next == "("
                below = self.factor()
                factors.append(_power(below, Fraction(-1)))
                # 1/2 m and k/2 (m + R) have only one meaning; k/2m and k/2(m + R) may have two.
                whole = bracketed or isinstance(below, Number)
                reach_is_clear = _is_fraction(factors) or (whole and self.spaced)
            elif self._starts_a_factor():
                if not reach_is_clear:
                    raise UnreadableError(
                        _(
                            "Where does the denominator end? Put it in brackets, or write a multiplication sign after "
                            "it."
                        )
                    )
                factors.append(self.factor())
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
        exponent = _constant(self._nested(self.factor))
        if exponent is None or abs(exponent) > MAX_EXPONENT or exponent.denominator > 2:
            limits = _("An exponent must be an integer or half an integer, from −{most} to {most}.")
            raise UnreadableError(limits.format(most=MAX_EXPONENT))
        return exponent

    def primary(self) -> Expression:
        token = self.take()
        if isinstance(token, Number):
            if isinstance(self.next, Number):
                raise UnreadableError(_("Two numbers follow each other. Write a sign between them."))
            return token
        if token == "sqrt":
            return self.root()
        if token == "(":
            return self.bracket()
        if token in NAMES:
            if isinstance(self.next, Number):
                raise UnreadableError(_("A number follows a name. Put it in front, or write ^ for a power."))
            return Name(token)
        if token is None:
            raise UnreadableError(_("The formula is not complete: something is missing at its end."))
        raise UnreadableError(_("Something is missing between two signs or brackets."))

    def root(self) -> Expression:
        bracketed = self.next == "("
        root = _power(self._nested(self.primary), Fraction(1, 2))
        if not bracketed and not self.spaced and self._starts_a_factor():
            raise UnreadableError(_("Where does the root end? Put what is under it in brackets."))
        return root

    def bracket(self) -> Expression:
        inside = self._nested(self.sum)
        if self.take() != ")":
            raise UnreadableError(_("There is an opening bracket without a closing bracket."))
        if isinstance(self.next, Number):
            raise UnreadableError(_("A number follows a bracket. Put it in front, or write ^ for a power."))
        return inside

    def _nested(self, read: Callable[[], Expression]) -> Expression:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            levels = _("Brackets, roots and exponents may be nested at most {most} levels deep.")
            raise UnreadableError(levels.format(most=MAX_DEPTH))
        inside = read()
        self._depth -= 1
        return inside

    def _starts_a_factor(self) -> bool:
        return isinstance(self.next, Number) or self.next in (*NAMES, "sqrt", "(")


def _negative(expression: Expression) -> Expression:
    if isinstance(expression, Number):
        return Number(-expression.value, expression.places)
    return Product((Number(Fraction(-1)), expression))


def _power(base: Expression, exponent: Fraction) -> Expression:
    return _bounded(Power(base, exponent))


def _is_fraction(factors: list[Expression]) -> bool:
    """Tell whether the last factors are a number over a number: 1/2 m is a half of m, but k/2m may be two things."""
    match factors:
        case [*_others, Number(), Power(Number(), _exponent)]:
            return True
    return False


def _constant(expression: Expression) -> Fraction | None:
    """Return the value of an expression of numbers that is small enough to be an exponent, None for any other."""
    match expression:
        case Number(value) if abs(value) <= MAX_EXPONENT:
            return value
        case Sum(inside) | Product(inside):
            values = [_constant(part) for part in inside]
            if None not in values:
                return sum(values) if isinstance(expression, Sum) else prod(values)
        case Power(base, exponent) if exponent.denominator == 1:
            value = _constant(base)
            return None if value is None or (value == 0 and exponent < 0) else value**exponent
    return None


def _bounded(expression: Expression) -> Expression:
    if weight(expression) > MAX_WEIGHT:
        raise UnreadableError(_("This is too large to check here. Write it shorter or with smaller exponents."))
    return expression
