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

from ramanujan.answers.spelling import Token, TooLargeError, UnreadableError, split_into_tokens, to_ascii
from ramanujan.answers.typed_formulas import count_leaves, is_decimal, is_number, leaves, replace_letters
from ramanujan.derivation.printers import latex
from ramanujan.text.numerals import in_latex
from ramanujan.text.reading import explain_ambiguous_number, normalize
from ramanujan.text.translation import _

MAX_LENGTH, MAX_DEPTH, MAX_EXPONENT, MAX_WEIGHT = 320, 20, 12, 120
"""The largest numbers of characters without spaces, nested brackets and leaves, and the largest |exponent|.

They bound later work.
"""

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
    return _parse_sides(text)[0].value


def parse_equation(text: str) -> tuple[sp.Expr, sp.Expr]:
    """Return both sides of an equation; without an equals sign, the right side is 0.

    Raises
    ------
    UnreadableError : `parse` cannot read a side, or the text has more than one equals sign.
    """
    left, right = _parse_sides(text, is_equation=True)
    return left.value, right.value


def typeset(text: str, *, is_equation: bool = False) -> str:
    """Return a formula or an equation as LaTeX, in the typed order and without evaluation.

    Raises
    ------
    UnreadableError : under the conditions of `parse` and `parse_equation`.
    """
    return "=".join(side.unbracketed for side in _parse_sides(text, is_equation))


def _parse_sides(text: str, is_equation: bool = False) -> "list[_Part]":
    """Return a formula, or both sides of an equation."""
    if not isinstance(text, str):
        raise UnreadableError(_("Type your answer as text."))
    normalized = normalize(text[: MOST_TYPED + 1])
    in_ascii = to_ascii(normalized)
    # The LaTeX of the app contains a space between two factors.
    if len(text) > MOST_TYPED or len(in_ascii.replace(" ", "")) > MAX_LENGTH:
        raise UnreadableError(_("The formula is too long. Use at most {most} characters.").format(most=MAX_LENGTH))
    ambiguity = explain_ambiguous_number(normalized)
    if ambiguity:
        raise UnreadableError(ambiguity)
    sides = in_ascii.replace("≈", "=").split("=")
    if is_equation and len(sides) > 2:
        raise UnreadableError(_("Type one equation, with one equals sign."))
    if not is_equation and len(sides) > 1:
        raise UnreadableError(_("Type only the right side of the equation, without the equals sign."))
    if is_equation and len(sides) == 1:
        sides.append("0")
    return [_parse_side(side) for side in sides]


def _parse_side(in_ascii: str) -> "_Part":
    reader = _Reader(list(split_into_tokens(in_ascii)))
    if reader.next is None:
        raise UnreadableError(_("Type a formula first."))
    side = reader.sum()
    if reader.next is not None:
        raise UnreadableError(_("There is a closing bracket without an opening bracket."))
    return side


class _Part:
    """A part of a formula: its unevaluated value, its LaTeX, and its LaTeX without outer brackets."""

    def __init__(self, value: sp.Expr, shown: str, unbracketed: str = "") -> None:
        if count_leaves(value).total() > MAX_WEIGHT:
            raise TooLargeError
        self.value, self.shown, self.unbracketed = value, shown, unbracketed or shown

    @property
    def unsigned(self) -> str:
        """The LaTeX after another term or factor: in brackets if it begins with a minus sign."""
        return _add_brackets(self.shown) if self.shown.startswith("-") else self.shown

    @property
    def base(self) -> str:
        """The LaTeX below an exponent."""
        return _add_brackets(self.shown) if self.shown.startswith(r"\frac") else f"{{{self.shown}}}"


class _Reader:
    """A recursive-descent parser with a method for each rule of the grammar; `next` is the next token or None."""

    def __init__(self, tokens: list[tuple[Token, bool]]) -> None:
        self._tokens = [*tokens, (None, False)]
        self._position = 0
        self._depth = 0

    @property
    def next(self) -> Token | None:
        return self._tokens[self._position][0]

    @property
    def is_space_next(self) -> bool:
        """Whether a space precedes the next token."""
        return self._tokens[self._position][1]

    def take(self) -> Token | None:
        """Return the next token, and advance unless it is the end."""
        token = self.next
        if token is not None:
            self._position += 1
        return token

    def sum(self) -> _Part:
        """Return a sum. A single product keeps its outer brackets; a sum of several has none."""
        first = self.product()
        terms, shown, unbracketed = [first.value], first.shown, first.unbracketed
        while self.next in ("+", "-"):
            sign, term = self.take(), self.product()
            terms.append(_negate(term.value) if sign == "-" else term.value)
            shown = unbracketed = f"{shown} {sign} {term.unsigned}"
        return _Part(sp.Add(*terms, evaluate=False), shown, unbracketed)

    def product(self) -> _Part:
        """Return a product. A single factor keeps its outer brackets; a product of several has none.

        Raises
        ------
        UnreadableError : a factor without * or / before it might belong to the denominator.
        """
        first = self.factor()
        factors, shown, unbracketed = [first.value], first.shown, first.unbracketed
        # Whether it is clear on which side of the last fraction line a factor without * or / would belong.
        is_unambiguous = True
        while self.next in ("*", "/") or self._starts_a_factor():
            sign = self.take() if self.next in ("*", "/") else ""
            is_bracket = self.next == "("
            if not (sign or is_unambiguous):
                refusal = _(
                    "Where does the denominator end? Put it in brackets, or write a multiplication sign after it."
                )
                raise UnreadableError(refusal)
            factor = self.factor()
            if sign == "/":
                # 1/2 m and k/2 (m + R) have only one meaning; k/2m and k/2(m + R) may have two.
                is_typed_fraction = is_number(factors[-1]) and is_number(factor.value)
                ends_at_space = (is_bracket or is_number(factor.value)) and self.is_space_next
                is_unambiguous = is_typed_fraction or ends_at_space
                factors.append(_make_power(factor.value, sp.S.NegativeOne))
                shown = unbracketed = _write_fraction(shown, unbracketed, factor)
            else:
                is_unambiguous = is_unambiguous or sign == "*"
                factors.append(factor.value)
                shown = unbracketed = _write_product(shown, factor.unsigned)
        return _Part(sp.Mul(*factors, evaluate=False), shown, unbracketed)

    def factor(self) -> _Part:
        is_negative = False
        while self.next in ("+", "-"):
            if self.take() == "-":
                is_negative = not is_negative
        factor = self.primary()
        if self.next == "^":
            self.take()
            exponent, shown = self.exponent()
            factor = _Part(_make_power(factor.value, exponent), f"{factor.base}^{{{shown}}}")
        return _Part(_negate(factor.value), f"- {factor.shown}") if is_negative else factor

    def exponent(self) -> tuple[sp.Rational, str]:
        part = self._read_nested(self.factor)
        typed_leaves = leaves(part.value)
        numbers = {leaf: sp.Rational(str(leaf)) for leaf in typed_leaves if is_number(leaf)}
        has_only_numbers = len(numbers) == len(typed_leaves)
        # Exponents in this exponent have already passed the check below, so the evaluation is cheap.
        exponent = replace_letters(part.value, numbers).doit() if has_only_numbers else sp.nan
        if not exponent.is_Rational or abs(exponent) > MAX_EXPONENT or exponent.q > 2:
            limits = _("An exponent must be an integer or half an integer, from −{most} to {most}.")
            raise UnreadableError(limits.format(most=MAX_EXPONENT))
        return exponent, part.unbracketed

    def primary(self) -> _Part:
        token = self.take()
        if is_number(token):
            if is_number(self.next):
                raise UnreadableError(_("Two numbers follow each other. Write a sign between them."))
            return _Part(token, in_latex(str(token)) if is_decimal(token) else latex(token))
        if token == "sqrt":
            return self.root()
        if token == "frac":
            above, below = self._read_nested(self.primary), self._read_nested(self.primary)
            quotient = sp.Mul(above.value, _make_power(below.value, sp.S.NegativeOne), evaluate=False)
            return _Part(quotient, _write_fraction(above.shown, above.unbracketed, below))
        if token == "(":
            inside = self._read_nested(self.sum)
            if self.take() != ")":
                raise UnreadableError(_("There is an opening bracket without a closing bracket."))
            self._refuse_number(_("A number follows a bracket. Put it in front, or write ^ for a power."))
            return _Part(inside.value, _add_brackets(inside.unbracketed), inside.unbracketed)
        if isinstance(token, sp.Expr):
            self._refuse_number(_("A number follows a name. Put it in front, or write ^ for a power."))
            return _Part(token, latex(token))
        if token is None:
            raise UnreadableError(_("The formula is not complete: something is missing at its end."))
        raise UnreadableError(_("Something is missing between two signs or brackets."))

    def root(self) -> _Part:
        """Return a root. Refuse √2m, in which the end of the root is unclear."""
        is_bracket = self.next == "("
        under = self._read_nested(self.primary)
        if not is_bracket and not self.is_space_next and self._starts_a_factor():
            raise UnreadableError(_("Where does the root end? Put what is under it in brackets."))
        return _Part(_make_power(under.value, sp.S.Half), rf"\sqrt{{{under.unbracketed}}}")

    def _refuse_number(self, refusal: str) -> None:
        """Raise an error with this message if a number follows without a space."""
        if is_number(self.next) and not self.is_space_next:
            raise UnreadableError(refusal)

    def _read_nested(self, read: Callable[[], _Part]) -> _Part:
        """Return the result of `read`, which parses the next nested part.

        Raises
        ------
        UnreadableError : the part is more than MAX_DEPTH levels deep.
        """
        self._depth += 1
        if self._depth > MAX_DEPTH:
            levels = _("Brackets, roots and exponents may be nested at most {most} levels deep.")
            raise UnreadableError(levels.format(most=MAX_DEPTH))
        inside = read()
        self._depth -= 1
        return inside

    def _starts_a_factor(self) -> bool:
        return isinstance(self.next, sp.Expr) or self.next in ("sqrt", "frac", "(")


def _negate(expression: sp.Expr) -> sp.Expr:
    return -expression if expression.is_Rational else sp.Mul(sp.S.NegativeOne, expression, evaluate=False)


def _make_power(base: sp.Expr, exponent: sp.Rational) -> sp.Expr:
    return sp.Pow(base, exponent, evaluate=False)


def _add_brackets(shown: str) -> str:
    return rf"\left({shown}\right)"


def _write_fraction(above: str, unbracketed: str, below: _Part) -> str:
    """Return a fraction as LaTeX. A minus sign of the numerator is written before the fraction.

    Parameters
    ----------
    above, unbracketed : the numerator with its outer brackets, and without them
    below : the denominator
    """
    sign = "- " if above.startswith("- ") else ""
    unsigned = unbracketed.removeprefix(sign)
    return rf"{sign}\frac{{{unsigned}}}{{{below.unbracketed}}}"


def _write_product(before: str, after: str) -> str:
    """Return two factors as LaTeX, with a dot before a number or a fraction, which would otherwise look attached."""
    needs_dot = after.lstrip("{").startswith((*".0123456789", r"\frac"))
    sign = r" \cdot " if needs_dot else r"\,"
    return before + sign + after
