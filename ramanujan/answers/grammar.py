"""Text to expression: the small grammar in which a student types a formula, also with LaTeX's commands.

    sum      = product { (+ | −) product }
    product  = factor { (* | / | nothing) factor }
    factor   = { + | − } primary [ ^ exponent ]
    primary  = number | name | √ primary | frac primary primary | ( sum )

The text is only compared with this grammar; SymPy's own parser never sees it. What is returned are SymPy's nodes as
they were typed, unevaluated: `length`, digits and exponents are bounded before anything is computed.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from ramanujan.answers.formulas import is_number, leaves, replaced, weights
from ramanujan.answers.spelling import Token, UnreadableError, plain, tokens
from ramanujan.translation import _

MAX_LENGTH, MAX_DEPTH, MAX_EXPONENT, MAX_WEIGHT = 320, 20, 12, 120
"""Limits on characters, brackets, |exponent| and all `weights`; they bound all later work."""

MOST_TYPED = 2 * MAX_LENGTH
"""The longest text: LaTeX takes more characters than what it says."""


def parse(text: str) -> sp.Expr:
    """Return the expression that a text spells, unevaluated; a decimal number is a symbol with its digits as name.

    Parameters
    ----------
    text : a formula in the names of `SYMBOLS` (φ, Φ, ε, ′, ², ½, √, ·, Ẋ, dX/dt, \\dot\\varphi, \\frac are accepted)

    Raises
    ------
    UnreadableError : the text is not such a formula, is ambiguous, or exceeds a limit; the message says which.
    """
    left, *others = _sides(text)
    if others:
        raise UnreadableError(_("Type only the right side of the equation, without the equals sign."))
    return _formula(left)


def parse_equation(text: str) -> tuple[sp.Expr, sp.Expr]:
    """Return both sides of the equation that a text spells; without an equals sign, the right side is 0.

    Raises
    ------
    UnreadableError : a side is not a formula as `parse` reads it, or there is more than one equals sign.
    """
    left, *others = _sides(text)
    if len(others) > 1:
        raise UnreadableError(_("Type one equation, with one equals sign."))
    return _formula(left), _formula(others[0]) if others else sp.S.Zero


def _sides(text: str) -> list[str]:
    if not isinstance(text, str):
        raise UnreadableError(_("Type your answer as text."))
    in_ascii = plain(text[: MOST_TYPED + 1])
    if len(text) > MOST_TYPED or len(in_ascii) > MAX_LENGTH:
        raise UnreadableError(_("The formula is too long. Use at most {most} characters.").format(most=MAX_LENGTH))
    return in_ascii.replace("≈", "=").split("=")


def _formula(in_ascii: str) -> sp.Expr:
    reader = _Reader(list(tokens(in_ascii)))
    if reader.next is None:
        raise UnreadableError(_("Type a formula first."))
    expression = reader.sum()
    if reader.next is not None:
        raise UnreadableError(_("There is a closing bracket without an opening bracket."))
    return expression


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


def _bounded(expression: sp.Expr) -> sp.Expr:
    if weights(expression).total() > MAX_WEIGHT:
        raise UnreadableError(_("This is too large to check here. Write it shorter or with smaller exponents."))
    return expression
