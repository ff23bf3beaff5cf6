"""Parse the small grammar in which a student types a formula, including LaTeX commands.

    sum      = product { (+ | −) product }
    product  = factor { (* | / | nothing) factor }
    factor   = { + | − } primary [ ^ exponent ]
    primary  = number | name | √ primary | frac primary primary | ( sum )

SymPy's own parser evaluates Python code, so it never receives the text. The result is an unevaluated SymPy expression,
and its length, digits and exponents are bounded before any computation. The parser also builds the LaTeX of the text,
because SymPy's printer would evaluate the expression.
"""

from collections.abc import Callable

import sympy as sp

from ramanujan.answers.formulas import is_number, leaves, replaced, weights
from ramanujan.answers.spelling import Token, UnreadableError, plain, tokens
from ramanujan.derivation.printers import latex
from ramanujan.numerals import explain_ambiguous_number, in_latex
from ramanujan.translation import _

MAX_LENGTH, MAX_DEPTH, MAX_EXPONENT, MAX_WEIGHT = 320, 20, 12, 120
"""Limits on characters, nested brackets, |exponent| and the sum of all `weights`; they bound all later work."""

MOST_TYPED = 2 * MAX_LENGTH
"""The longest text. LaTeX needs more characters than the formula it spells."""


def parse(text: str) -> sp.Expr:
    """Return the unevaluated expression for a text; a decimal number becomes a symbol whose name is its digits.

    Parameters
    ----------
    text : a formula in the names of `SYMBOLS` (φ, Φ, ε, ′, ², ½, √, ·, Ẋ, dX/dt, \\dot\\varphi, \\frac are accepted)

    Raises
    ------
    UnreadableError : the text is not a formula, is ambiguous, or exceeds a limit; the message is for the student.
    """
    return _sides(text)[0].value


def parse_equation(text: str) -> tuple[sp.Expr, sp.Expr]:
    """Return both sides of an equation; without an equals sign, the right side is 0.

    Raises
    ------
    UnreadableError : `parse` cannot read a side, or the text has more than one equals sign.
    """
    left, right = _sides(text, is_equation=True)
    return left.value, right.value


def typeset(text: str, *, is_equation: bool = False) -> str:
    """Return a formula or an equation as LaTeX, in the typed order and without evaluation.

    Raises
    ------
    UnreadableError : under the conditions of `parse` and `parse_equation`.
    """
    return "=".join(side.bare for side in _sides(text, is_equation))


def _sides(text: str, is_equation: bool = False) -> "list[_Part]":
    """Return a formula, or both sides of an equation."""
    if not isinstance(text, str):
        raise UnreadableError(_("Type your answer as text."))
    in_ascii = plain(text[: MOST_TYPED + 1])
    if len(text) > MOST_TYPED or len(in_ascii) > MAX_LENGTH:
        raise UnreadableError(_("The formula is too long. Use at most {most} characters.").format(most=MAX_LENGTH))
    if refusal := explain_ambiguous_number(text):
        raise UnreadableError(refusal)
    sides = in_ascii.replace("≈", "=").split("=")
    if is_equation and len(sides) > 2:
        raise UnreadableError(_("Type one equation, with one equals sign."))
    if not is_equation and len(sides) > 1:
        raise UnreadableError(_("Type only the right side of the equation, without the equals sign."))
    if is_equation and len(sides) == 1:
        sides.append("0")
    return [_parse_side(side) for side in sides]


def _parse_side(in_ascii: str) -> "_Part":
    reader = _Reader(list(tokens(in_ascii)))
    if reader.next is None:
        raise UnreadableError(_("Type a formula first."))
    side = reader.sum()
    if reader.next is not None:
        raise UnreadableError(_("There is a closing bracket without an opening bracket."))
    return side


class _Part:
    """A part of a formula: its unevaluated value, its LaTeX, and its LaTeX without outer brackets."""

    def __init__(self, value: sp.Expr, shown: str, bare: str = "") -> None:
        if weights(value).total() > MAX_WEIGHT:
            raise UnreadableError(_("This is too large to check here. Write it shorter or with smaller exponents."))
        self.value, self.shown, self.bare = value, shown, bare or shown

    @property
    def unsigned(self) -> str:
        """The LaTeX after another term or factor: in brackets if it begins with a minus sign."""
        return _bracketed(self.shown) if self.shown.startswith("-") else self.shown

    @property
    def base(self) -> str:
        """The LaTeX below an exponent."""
        return _bracketed(self.shown) if self.shown.startswith(r"\frac") else f"{{{self.shown}}}"


class _Reader:
    """A recursive-descent parser; `next` is the next token, None at the end."""

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

    def sum(self) -> _Part:
        first = self.product()
        terms, shown, bare = [first.value], first.shown, first.bare
        while self.next in ("+", "-"):
            sign, term = self.take(), self.product()
            terms.append(_negative(term.value) if sign == "-" else term.value)
            shown = bare = f"{shown} {sign} {term.unsigned}"
        return _Part(sp.Add(*terms, evaluate=False), shown, bare)

    def product(self) -> _Part:
        first, reach_is_clear = self.factor(), True
        factors, shown, bare = [first.value], first.shown, first.bare
        while self.next in ("*", "/") or self._starts_a_factor():
            sign = self.take() if self.next in ("*", "/") else ""
            bracketed = self.next == "("
            if not (sign or reach_is_clear):
                refusal = _(
                    "Where does the denominator end? Put it in brackets, or write a multiplication sign after it."
                )
                raise UnreadableError(refusal)
            factor = self.factor()
            if sign == "/":
                # 1/2 m and k/2 (m + R) have only one meaning; k/2m and k/2(m + R) may have two.
                simple = is_number(factors[-1]) and is_number(factor.value)
                reach_is_clear = simple or ((bracketed or is_number(factor.value)) and self.spaced)
                factors.append(_power(factor.value, sp.S.NegativeOne))
                shown = bare = _fraction(shown, bare, factor)
            else:
                reach_is_clear = reach_is_clear or sign == "*"
                factors.append(factor.value)
                shown = bare = _side_by_side(shown, factor.unsigned)
        return _Part(sp.Mul(*factors, evaluate=False), shown, bare)

    def factor(self) -> _Part:
        negative = False
        while self.next in ("+", "-"):
            negative ^= self.take() == "-"
        factor = self.primary()
        if self.next == "^":
            self.take()
            exponent, shown = self.exponent()
            factor = _Part(_power(factor.value, exponent), f"{factor.base}^{{{shown}}}")
        return _Part(_negative(factor.value), f"- {factor.shown}") if negative else factor

    def exponent(self) -> tuple[sp.Rational, str]:
        part = self._nested(self.factor)
        typed = part.value
        parts = leaves(typed)
        # Nested exponents have passed the check below, so the evaluation is cheap.
        numbers = {part: sp.Rational(str(part)) for part in parts if is_number(part)}
        exponent = replaced(typed, numbers).doit() if len(numbers) == len(parts) else sp.nan
        if not exponent.is_Rational or abs(exponent) > MAX_EXPONENT or exponent.q > 2:
            limits = _("An exponent must be an integer or half an integer, from −{most} to {most}.")
            raise UnreadableError(limits.format(most=MAX_EXPONENT))
        return exponent, part.bare

    def primary(self) -> _Part:
        token = self.take()
        if is_number(token):
            if is_number(self.next):
                raise UnreadableError(_("Two numbers follow each other. Write a sign between them."))
            return _Part(token, in_latex(str(token)) if isinstance(token, sp.Symbol) else latex(token))
        if token == "sqrt":
            return self.root()
        if token == "frac":
            above, below = self._nested(self.primary), self._nested(self.primary)
            quotient = sp.Mul(above.value, _power(below.value, sp.S.NegativeOne), evaluate=False)
            return _Part(quotient, _fraction(above.shown, above.bare, below))
        if token == "(":
            inside = self._nested(self.sum)
            if self.take() != ")":
                raise UnreadableError(_("There is an opening bracket without a closing bracket."))
            self._not_a_number(_("A number follows a bracket. Put it in front, or write ^ for a power."))
            return _Part(inside.value, _bracketed(inside.bare), inside.bare)
        if isinstance(token, sp.Expr):
            self._not_a_number(_("A number follows a name. Put it in front, or write ^ for a power."))
            return _Part(token, latex(token))
        if token is None:
            raise UnreadableError(_("The formula is not complete: something is missing at its end."))
        raise UnreadableError(_("Something is missing between two signs or brackets."))

    def root(self) -> _Part:
        bracketed = self.next == "("
        under = self._nested(self.primary)
        if not bracketed and not self.spaced and self._starts_a_factor():
            raise UnreadableError(_("Where does the root end? Put what is under it in brackets."))
        return _Part(_power(under.value, sp.S.Half), rf"\sqrt{{{under.bare}}}")

    def _not_a_number(self, refusal: str) -> None:
        if is_number(self.next) and not self.spaced:
            raise UnreadableError(refusal)

    def _nested(self, read: Callable[[], _Part]) -> _Part:
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
    return sp.Pow(base, exponent, evaluate=False)


def _bracketed(shown: str) -> str:
    return rf"\left({shown}\right)"


def _fraction(above: str, bare: str, below: _Part) -> str:
    """Return a fraction as LaTeX, from its numerator with and without brackets; a minus sign moves to its front."""
    sign, unsigned = ("- ", bare[2:]) if above.startswith("- ") else ("", bare)
    return rf"{sign}\frac{{{unsigned}}}{{{below.bare}}}"


def _side_by_side(before: str, after: str) -> str:
    """Return two factors as LaTeX, with a dot before a number or a fraction, which would otherwise look attached."""
    needs_dot = after.lstrip("{").startswith((*".0123456789", r"\frac"))
    sign = r" \cdot " if needs_dot else r"\,"
    return before + sign + after
