"""Text to expression: the small grammar in which a student types a formula, also with LaTeX's commands.

    sum      = product { (+ | −) product }
    product  = factor { (* | / | nothing) factor }
    factor   = { + | − } primary [ ^ exponent ]
    primary  = number | name | √ primary | frac primary primary | ( sum )

The text is only compared with this grammar; SymPy's own parser never sees it. What is returned are SymPy's nodes as
they were typed, unevaluated: `length`, digits and exponents are bounded before anything is computed.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import pairwise

import sympy as sp

from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime
from ramanujan.numerals import FROM_SUPERSCRIPTS
from ramanujan.translation import _

MAX_LENGTH, MAX_DEPTH, MAX_DIGITS, MAX_EXPONENT, MAX_WEIGHT = 300, 20, 20, 12, 120
"""Limits on characters, brackets, digits of a number, |exponent| and all `weights`; they bound all later work."""

SYMBOLS: dict[str, sp.Expr] = {
    "m": m,
    "m'": m_prime,
    "k": k,
    "R": R,
    "X": COORDINATES[0],
    "X'": VELOCITIES[0],
    "phi": COORDINATES[1],
    "phi'": VELOCITIES[1],
    "Phi": COORDINATES[2],
    "Phi'": VELOCITIES[2],
    "eps": epsilon,
}
"""How one types a symbol of the derivation."""

TEXTBOOK = {name: sp.Symbol(name) for name in ("v", "omega", "I", "x")}
"""Letters of the textbook's ½mv² + ½Iω² and ½kx²: understood, and asked about."""

_ALL = {**SYMBOLS, **TEXTBOOK}


class UnreadableError(ValueError):
    """The text is not a formula of the grammar; the message tells the student why."""


def parse(text: str) -> sp.Expr:
    """Return the expression that a text spells, unevaluated; a decimal number is a symbol with its digits as name.

    Parameters
    ----------
    text : a formula in the names of `SYMBOLS` (φ, Φ, ε, ′, ², ½, √, ·, Ẋ, dX/dt, \\dot\\varphi, \\frac are accepted)

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
        **dict.fromkeys("[{", "("),
        **dict.fromkeys("]}", ")"),
        "Φ": "Phi",
        "ω": "omega",
        "√": "sqrt",
    }
)
_REWRITTEN = [
    (re.compile(pattern), replacement)
    for pattern, replacement in (
        # Decomposed, the Ẋ of a textbook is X and a dot above.
        ("(?<=[XφϕΦ])\u0307", "'"),
        ("⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda found: f"^({found[0].translate(FROM_SUPERSCRIPTS)})"),
        # A decimal comma, and the thin space between groups of digits.
        (r"(?<=[0-9]),(?=[0-9])", "."),
        ("(?<=[0-9])\u202f(?=[0-9]{3})", ""),
        # LaTeX
        (r"^\s*\$+|\$+\s*$", ""),
        (r"\\(left|right|displaystyle|quad|[,;:! ])", " "),
        (r"\\(cdot|times)(?![A-Za-z])", "*"),
        (r"\\dot\s*(\{\s*)?(\\?[A-Za-z]+)\s*(?(1)\})", r" \2'"),
        (r"\^\s*(\{\s*)?\\prime\s*(?(1)\})", "'"),
        (r"\\[dt]?frac\s*([0-9])\s*([0-9])", r" frac(\1)(\2)"),
        (r"\\[dt]?frac(?![A-Za-z])", " frac"),
        (r"\\(?=(sqrt|varphi|phi|Phi|varepsilon|epsilon|omega)(?![A-Za-z]))", " "),
    )
]
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
_ALIASES = {"epsilon": "eps", "varepsilon": "eps", "varphi": "phi", "varphi'": "phi'", "m_prime": "m'", **_RATES}
# Longest first, so that m' is not read as m.
_NAME = re.compile("|".join(sorted(("sqrt", "frac", *_ALL, *_ALIASES), key=len, reverse=True)))


def _plain(text: str) -> str:
    """Return the text in ASCII spelling, except for the fractions that are one character."""
    text = unicodedata.normalize("NFD", text)
    for pattern, replacement in _REWRITTEN:
        text = pattern.sub(replacement, text)
    return _LEIBNIZ.sub(r"\1'", text.translate(_SPELLINGS).replace("**", "^"))


Token = str | sp.Expr


def _tokens(text: str) -> Iterator[tuple[Token, bool]]:
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
            yield sp.Rational(unicodedata.numeric(found[0])).limit_denominator(10), spaced
        elif found["word"]:
            for name in _names(found["word"]):
                yield _ALL.get(name, name), spaced
                spaced = False
        else:
            yield found["sign"], spaced
        spaced = False


def _strange(character: str) -> str:
    if character == "Ω":
        return _("Type only the right side of the equation: a formula without Ω.")
    if character in "<>":
        return _("Type a formula, not a comparison.")
    # The Unicode name has only capitals, digits and hyphens: safe to show wherever the character itself is not.
    name = unicodedata.name(character, "")
    if not name:
        return _("One character does not belong in a formula.")
    return _("This character does not belong in a formula: {name}.").format(name=name.lower())


def _number(digits: str) -> sp.Expr:
    if len(digits.replace(".", "")) > MAX_DIGITS:
        raise UnreadableError(_("A number may have at most {most} digits.").format(most=MAX_DIGITS))
    return sp.Symbol(digits) if "." in digits else sp.Integer(digits)


def _names(word: str) -> list[str]:
    """Return the names that a run of letters is made of: mR is m and R."""
    names, position = [], 0
    while position < len(word):
        found = _NAME.match(word, position)
        if found is None:
            raise UnreadableError(not_known(re.sub("[^A-Za-z']", "", word)[:MAX_DIGITS]))
        names.append(_ALIASES.get(found[0], found[0]))
        position = found.end()
    return names


def not_known(name: str) -> str:
    """Return the sentence that says which names may be used instead of this one."""
    unknown = _("“{name}” is not known here. You may use {names} and sqrt( ).")
    return unknown.format(name=name, names=", ".join(SYMBOLS))


def is_number(token: Token | None) -> bool:
    """Tell whether this is a number as typed: a whole number, a fraction such as ½, or a decimal."""
    return isinstance(token, sp.Rational) or is_decimal(token)


def is_decimal(token: Token | None) -> bool:
    """Tell whether this is a number typed with a decimal point."""
    return isinstance(token, sp.Symbol) and token.name[:1] in "0123456789."


class _Reader:
    """Recursive descent over the tokens; `next` is the token that comes, None at the end."""

    def __init__(self, tokens: list[tuple[Token, bool]]) -> None:
        self._tokens = [*tokens, (None, False)]
        self._position = 0
        self._depth = 0

    @property
    def next(self) -> Token | None:
        return self._tokens[self._position][0]

    @property
    def spaced(self) -> bool:
        return self._tokens[self._position][1]

    def take(self) -> Token | None:
        token = self.next
        self._position += token is not None
        return token

    def sum(self) -> sp.Expr:
        terms = [self.product()]
        while self.next in ("+", "-"):
            negative = self.take() == "-"
            term = self.product()
            terms.append(_negative(term) if negative else term)
        return _bounded(sp.Add(*terms, evaluate=False))

    def product(self) -> sp.Expr:
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
                factors.append(_power(below, sp.S.NegativeOne))
                # 1/2 m and k/2 (m + R) have only one meaning; k/2m and k/2(m + R) may have two.
                simple = len(factors) > 1 and is_number(factors[-2]) and is_number(below)
                reach_is_clear = simple or ((bracketed or is_number(below)) and self.spaced)
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
                return _bounded(sp.Mul(*factors, evaluate=False))

    def factor(self) -> sp.Expr:
        negative = False
        while self.next in ("+", "-"):
            negative ^= self.take() == "-"
        power = self.primary()
        if self.next == "^":
            self.take()
            power = _power(power, self.exponent())
        return _negative(power) if negative else power

    def exponent(self) -> sp.Rational:
        typed = self._nested(self.factor)
        parts = leaves(typed)
        # The exponents in it are small already, so that its numbers can be worked out.
        numbers = {part: sp.Rational(str(part)) for part in parts if is_number(part)}
        exponent = replaced(typed, numbers).doit() if len(numbers) == len(parts) else sp.nan
        if not exponent.is_Rational or abs(exponent) > MAX_EXPONENT or exponent.q > 2:
            limits = _("An exponent must be an integer or half an integer, from −{most} to {most}.")
            raise UnreadableError(limits.format(most=MAX_EXPONENT))
        return exponent

    def primary(self) -> sp.Expr:
        token = self.take()
        if is_number(token):
            if is_number(self.next):
                raise UnreadableError(_("Two numbers follow each other. Write a sign between them."))
            return token
        if token == "sqrt":
            return self.root()
        if token == "frac":
            above, below = self._nested(self.primary), self._nested(self.primary)
            return _bounded(sp.Mul(above, _power(below, sp.S.NegativeOne), evaluate=False))
        if token == "(":
            inside = self._nested(self.sum)
            if self.take() != ")":
                raise UnreadableError(_("There is an opening bracket without a closing bracket."))
            self._not_a_number(_("A number follows a bracket. Put it in front, or write ^ for a power."))
            return inside
        if isinstance(token, sp.Expr):
            self._not_a_number(_("A number follows a name. Put it in front, or write ^ for a power."))
            return token
        if token is None:
            raise UnreadableError(_("The formula is not complete: something is missing at its end."))
        raise UnreadableError(_("Something is missing between two signs or brackets."))

    def root(self) -> sp.Expr:
        bracketed = self.next == "("
        root = _power(self._nested(self.primary), sp.S.Half)
        if not bracketed and not self.spaced and self._starts_a_factor():
            raise UnreadableError(_("Where does the root end? Put what is under it in brackets."))
        return root

    def _not_a_number(self, refusal: str) -> None:
        if is_number(self.next) and not self.spaced:
            raise UnreadableError(refusal)

    def _nested(self, read: Callable[[], sp.Expr]) -> sp.Expr:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            levels = _("Brackets, roots and exponents may be nested at most {most} levels deep.")
            raise UnreadableError(levels.format(most=MAX_DEPTH))
        inside = read()
        self._depth -= 1
        return inside

    def _starts_a_factor(self) -> bool:
        return isinstance(self.next, sp.Expr) or self.next in ("sqrt", "frac", "(")


def _negative(expression: sp.Expr) -> sp.Expr:
    return -expression if expression.is_Rational else sp.Mul(sp.S.NegativeOne, expression, evaluate=False)


def _power(base: sp.Expr, exponent: sp.Rational) -> sp.Expr:
    return _bounded(sp.Pow(base, exponent, evaluate=False))


def weights(expression: sp.Expr) -> Counter[sp.Expr]:
    """Return how often each number and name is there when every power is written out: a bound on its degree."""
    if expression.is_Pow:
        times = max(1, int(sp.ceiling(abs(expression.exp))))
        return Counter({leaf: times * n for leaf, n in weights(expression.base).items()})
    if expression.is_Add or expression.is_Mul:
        return sum(map(weights, expression.args), Counter())
    return Counter([expression])


def length(expression: sp.Expr) -> int:
    """Return how long a formula is to write: a sign for each name, digit of a number, exponent and root."""
    if is_number(expression):
        p, q = Fraction(str(abs(expression) if expression.is_Rational else expression)).as_integer_ratio()
        # A sign, and the 1 above a fraction line, take no room.
        return (len(str(p)) if p != 1 or q == 1 else 0) + (len(str(q)) if q != 1 else 0)
    if expression.is_Pow:
        return length(expression.base) + (abs(expression.exp) != 1)
    if expression.is_Mul:
        return sum(length(factor) for factor in expression.args if factor not in (1, -1))
    return sum(map(length, expression.args)) if expression.is_Add else 1


def leaves(expression: sp.Expr) -> set[sp.Expr]:
    """Return the numbers and names of which a formula is made; exponents do not count."""
    return set(weights(expression))


def replaced(expression: sp.Expr, values: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """Return a formula with other expressions in the place of some letters, still unevaluated."""
    if expression.is_Pow:
        return sp.Pow(replaced(expression.base, values), expression.exp, evaluate=False)
    if not (expression.is_Add or expression.is_Mul):
        return values.get(expression, expression)
    return expression.func(*(replaced(part, values) for part in expression.args), evaluate=False)


def _bounded(expression: sp.Expr) -> sp.Expr:
    if weights(expression).total() > MAX_WEIGHT:
        raise UnreadableError(_("This is too large to check here. Write it shorter or with smaller exponents."))
    return expression


# Set as it was typed


def typeset(expression: sp.Expr) -> str:
    """Return the LaTeX of an expression as it was typed: nothing is evaluated, gathered or reordered.

    SymPy's own printer is no help: it evaluates, and it does not return from (m/m)^(−2).
    """
    if expression.is_Add:
        terms = [_bracketed(term) if term.is_Add else typeset(term) for term in expression.args]
        return terms[0] + "".join(f" {term}" if term.startswith("-") else f" + {term}" for term in terms[1:])
    if expression.is_Mul:
        return _product(expression.args)
    if expression.is_Pow:
        base, exponent = expression.args
        if exponent < 0:
            return _product((expression,))
        if exponent == sp.S.Half:
            return rf"\sqrt{{{typeset(base)}}}"
        text = _bracketed(base) if base.is_Add or base.is_Mul or base.is_Pow or _is_negative(base) else typeset(base)
        return f"{{{text}}}^{{{exponent}}}" if text[-1] in "'}" else f"{text}^{{{exponent}}}"
    if is_decimal(expression):
        return expression.name
    return f"- {latex(-expression)}" if _is_negative(expression) else latex(expression)


def _bracketed(expression: sp.Expr) -> str:
    return rf"\left({typeset(expression)}\right)"


def _is_negative(expression: sp.Expr) -> bool:
    first = expression.args[0] if expression.is_Mul else expression
    return _is_negative(first) if first.is_Mul else bool(first.is_Rational and first < 0)


def _product(factors: tuple[sp.Expr, ...]) -> str:
    first, *rest = factors
    if _is_negative(first) and (rest or not first.is_Rational):
        # One minus sign before the whole product, and not above its fraction line.
        if first.is_Mul:
            return _product((*first.args, *rest))
        shown = (-first,) if first != -1 else ()
        left = (*shown, *rest)
        alone = len(left) == 1 and (left[0].is_Add or _is_negative(left[0]))
        return f"- {_bracketed(left[0]) if alone else _product(left)}"
    above = [f for f in factors if not (f.is_Pow and f.exp < 0)]
    below = [sp.Pow(f.base, -f.exp, evaluate=False) if f.exp != -1 else f.base for f in factors if f not in above]
    above = [f for f in above if f != 1] or [sp.S.One]
    return rf"\frac{{{_side_by_side(above)}}}{{{_side_by_side(below)}}}" if below else _side_by_side(above)


def _side_by_side(factors: list[sp.Expr]) -> str:
    """Return factors next to each other, with a dot where two digits would read as one number."""
    if len(factors) == 1:
        return typeset(factors[0])
    shown = [_bracketed(f) if f.is_Add or _is_negative(f) else typeset(f) for f in factors]
    text = shown[0]
    for before, after in pairwise(shown):
        digits = (before[-1].isdigit() or before[-1] == "}") and (after[0].isdigit() or after[0] == ".")
        text += (r" \cdot " if digits or after.startswith(r"\frac") else r"\,") + after
    return text
