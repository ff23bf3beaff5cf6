"""Print SymPy expressions as LaTeX for people, and as JavaScript for the stage.

The output is equivalent to the expression. Exact numbers (p + r√n)/q are printed as a fraction and as a decimal: “=”
before an exact decimal, “≈” before a rounded one.
"""

from collections.abc import Mapping, Sequence
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from functools import cache, lru_cache
from math import gcd, lcm
from typing import Any, NamedTuple

import sympy as sp
from sympy.physics.vector.printing import VectorLatexPrinter, VectorPrettyPrinter
from sympy.printing.latex import translate

from ramanujan.derivation import model
from ramanujan.derivation.order import InOrder, Product, is_coefficient, is_motion, ordered_terms, product
from ramanujan.numerals import in_latex
from ramanujan.translation import pgettext

# TRANSLATORS: what a symbol belongs to, in small letters below it, as in v with the subscript hoop; very short.
_SUBSCRIPTS = {
    "block": pgettext("subscript", "block"),
    "hoop": pgettext("subscript", "hoop"),
    "cylinder": pgettext("subscript", "cylinder"),
    "slab": pgettext("subscript", "slab"),
    "top": pgettext("subscript", "top"),
    "body": pgettext("subscript", "body"),
    "clamped": pgettext("subscript", "clamped"),
}
_NAMES = {
    model.m_prime: "m'",
    model.epsilon_star: r"\varepsilon_{*}",
    model.Omega_squared: r"\Omega^{2}",
    model.Omega_clamped_squared: rf"\Omega_{{\text{{{_SUBSCRIPTS['clamped']}}}}}^{{2}}",
    model.normalized_frequency_squared: r"\frac{\Omega^{2}\,m}{k}",
    sp.Symbol("L"): r"\mathcal{L}",
    sp.Symbol("H"): r"\mathcal{H}",
    sp.Symbol("H_0"): r"\mathcal{H}_{0}",
}
_PLAIN = {
    **dict(zip(model.VELOCITIES, sp.symbols("X_dot phi_dot Phi_dot"), strict=True)),
    **dict(zip(model.COORDINATES, sp.symbols("X phi Phi"), strict=True)),
    sp.Symbol("R", positive=True): sp.Symbol("radius"),
}
"""The names of the coordinates, their rates and R in a program."""

_EXACTLY = Context(prec=200)

Highlight = tuple[tuple[sp.Basic, str], ...]
"""Symbols, or functions of time, and their colours."""

LONG = 10**7
"""The smallest denominator with too many digits to read; the number is then written as a decimal."""

DIGITS = 8
"""Significant digits of a decimal."""


class LatexPrinter(VectorLatexPrinter):
    """SymPy's printer for mechanics, with upright words in subscripts, and chosen names in a colour."""

    def __init__(self, highlight: Mapping[sp.Basic, str]) -> None:
        super().__init__({"symbol_names": _NAMES, "mul_symbol": r"\,"})
        self._highlight = highlight

    def _print(self, expr: sp.Basic, **kwargs: Any) -> str:
        text = super()._print(expr, **kwargs)
        return colored(text, self._highlight.get(expr)) if self._highlight and isinstance(expr, sp.Basic) else text

    def _print_Integer(self, expr: sp.Integer) -> str:
        return str(expr)

    def _print_Rational(self, expr: sp.Rational) -> str:
        return self._product(Product(expr, (), ()))

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        if isinstance(expr, InOrder) or not expr.is_number:
            return joined([self._print(term) for term in ordered_terms(expr)])
        return super()._print_Add(expr, order) if exact(expr) is None else self._product(Product(expr, (), ()))

    def _print_Mul(self, expr: sp.Expr) -> str:
        return self._product(product(expr))

    def _product(self, term: Product) -> str:
        """Return a product as coefficient and motion, such as ¾mR²Φ̇²; the coefficient may be a longer fraction.

        Keep a fraction in one piece if its numerator is one sum or has no masses: (8m + 7m′)/2 and 2p/(3R).
        """
        number = exact(term.number)
        if number is None:
            return super()._print_Mul(sp.Mul(term.number, *term.above, *(1 / factor for factor in term.below)))
        sign, numerator, denominator, is_sum = number_to_latex(number)
        coefficient, behind = _divided(term)
        if denominator and not term.below and (behind or [f.is_Add for f in term.above] != [True]):
            numerator, denominator = rf"\frac{{{numerator}}}{{{denominator}}}", ""
        elif is_sum and (term.above or (sign < 0 and not term.below)):
            numerator = rf"\left({numerator}\right)"
        below = self._side_by_side(denominator, term.below)
        if below:
            numerator, coefficient = rf"\frac{{{self._side_by_side(numerator, coefficient)}}}{{{below}}}", ()
        text = self._side_by_side(numerator, (*coefficient, *behind), is_term=sign < 0)
        return f"- {text}" if sign < 0 else text

    def _side_by_side(self, number: str, factors: Sequence[sp.Expr], is_term: bool = False) -> str:
        """Return the factors after a number; omit the number if it is 1 or empty.

        Put a sum in brackets, unless it is the only factor and not a term of another sum.
        """
        numbers = [number] if number not in ("", "1") or (number and not factors) else []
        if len(factors) == 1 and not numbers and not is_term:
            return self._print(factors[0])
        brackets = (rf"\left({self._print(f)}\right)" if f.is_Add else self._print(f) for f in factors)
        text, *others = (*numbers, *brackets) or ("",)
        for other in others:
            # Adjacent numbers in an unevaluated product would look like one number or a difference.
            factor = rf"\left({other}\right)" if other.startswith("-") else other
            text += (r" \cdot " if other[0].isdigit() else r"\,") + factor
        return text

    def _print_Derivative(self, expr: sp.Derivative) -> str:
        return _dotted(expr)

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        letter, _, word = expr.name.partition("_")
        is_word = len(word) > 2 and translate(word) == word
        if is_word and expr not in self._settings["symbol_names"]:
            return rf"{super()._print_Symbol(sp.Symbol(letter))}_{{\text{{{_SUBSCRIPTS.get(word, word)}}}}}"
        return super()._print_Symbol(expr, style)


def _divided(term: Product) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """Return the factors of a product's coefficient, and the factors after it."""
    coefficient = tuple(filter(is_coefficient, term.above))
    has_symbols = any(factor.free_symbols for factor in term.below)
    if any(map(is_motion, term.below)) or (has_symbols and not coefficient):
        return term.above, ()
    return coefficient, term.above[len(coefficient) :]


@cache
def _dotted(derivative: sp.Derivative) -> str:
    """Return q̇ or q̈ in LaTeX; SymPy's printer differentiates again, which takes half the time of a formula."""
    return VectorLatexPrinter().doprint(derivative)


@lru_cache(maxsize=2048)
def latex(expression: sp.Basic) -> str:
    """Return the LaTeX of an expression or relation, with the primes and dots of physics.

    A fraction with a denominator of eight digits or more is written as a decimal that ends in dots.

    >>> from ramanujan.derivation.model import X, m_prime
    >>> latex(m_prime * X.diff().diff())
    "m'\\\\,\\\\ddot{X}"
    """
    return LatexPrinter({}).doprint(expression)


def joined(texts: Sequence[str]) -> str:
    """Return a sum from the LaTeX of its terms."""
    return "".join(signed(texts))


def signed(texts: Sequence[str]) -> list[str]:
    """Return the LaTeX of the nonzero terms of a sum, each term except the first with its sign."""
    first, *others = [text for text in texts if text != "0"] or ["0"]
    return [first, *(f" - {each[1:].lstrip()}" if each[0] == "-" else f" + {each}" for each in others)]


def colored(formula: str, color: str | None) -> str:
    """Return LaTeX in a colour, #rrggbb; without a colour, return it unchanged."""
    return rf"\textcolor{{{color}}}{{{formula}}}" if color else formula


def plain_text(expression: sp.Expr) -> str:
    """Return a short expression as a label: Unicode on one line, factors side by side.

    >>> from ramanujan.derivation.model import R, phi
    >>> plain_text(2 * R * phi)
    '2Rφ'
    """
    named = expression.subs({q: sp.Function(str(q.func).replace("var", ""))(model.t) for q in model.COORDINATES}).doit()
    return VectorPrettyPrinter({"use_unicode": True, "wrap_line": False}).doprint(named).replace("⋅", "")


def javascript(formulas: Mapping[str, Any]) -> str:
    """Return a JavaScript object literal with an arrow function of named symbols for each SymPy expression.

    Parameters
    ----------
    formulas : name → expression, or name → another such mapping

    >>> from ramanujan.derivation.model import k, m
    >>> javascript({"plain": sp.sqrt(k / m)})
    '{plain: ({k, m}) => Math.sqrt(k)/Math.sqrt(m)}'
    """
    entries = (
        f"{name}: {javascript(value) if isinstance(value, Mapping) else _arrow(value)}"
        for name, value in formulas.items()
    )
    return "{" + ", ".join(entries) + "}"


def _arrow(expression: sp.Expr) -> str:
    plain = sp.sympify(expression).subs(_PLAIN)
    names = sorted(symbol.name for symbol in plain.free_symbols)
    return f"({{{', '.join(names)}}}) => {sp.jscode(plain)}"


# Numbers (p + r√n)/q


class Number(NamedTuple):
    """(p + r√n)/q in lowest terms, q > 0; a fraction has r = 0."""

    p: int
    q: int = 1
    r: int = 0
    n: int = 1

    @classmethod
    def of(cls, p: int, r: int, q: int, n: int) -> "Number":
        """Return (p + r√n)/q.

        >>> Number.of(-2, 2, 72, 1729)
        Number(p=-1, q=36, r=1, n=1729)
        """
        common = gcd(p, q, r) if q > 0 else -gcd(p, q, r)
        return cls(p // common, q // common, r // common, n)

    @property
    def numerator(self) -> Decimal:
        """p + r√n, to 40 digits or more even if the two terms nearly cancel."""
        if not self.r:
            return Decimal(self.p)
        context = Context(prec=40 + 2 * len(str(abs(self.p) + abs(self.r))))
        return context.fma(Decimal(self.r), context.sqrt(Decimal(self.n)), Decimal(self.p))


def exact(value: sp.Expr) -> Number | None:
    """Return a SymPy number as (p + r√n)/q, or None if this is impossible.

    >>> exact((sp.sqrt(1729) - 1) / 36)
    Number(p=-1, q=36, r=1, n=1729)
    """
    if value.is_Rational:
        return Number(int(value.p), int(value.q))
    parts = sp.expand(value).as_coefficients_dict()
    roots = [part for part in parts if part != 1]
    if len(roots) != 1:
        return None
    root = roots[0]
    is_root = root.is_Pow and root.base.is_Integer and root.exp == sp.Rational(1, 2)
    if not is_root or not all(coefficient.is_Rational for coefficient in parts.values()):
        return None
    p, r = sp.Rational(parts[sp.S.One]), sp.Rational(parts[root])
    q = lcm(int(p.q), int(r.q))
    return Number.of(int(p * q), int(r * q), q, int(root.base))


class Printed(NamedTuple):
    """A number as LaTeX: its sign (1, 0 or −1), and numerator and denominator of its absolute value.

    `below` is "" for the denominator 1. `is_sum` is true for a numerator p + r√n, which needs brackets as a factor.
    """

    sign: int
    above: str
    below: str = ""
    is_sum: bool = False

    @property
    def needs_no_decimal(self) -> bool:
        """Whether the number needs no decimal, because it is an integer or a decimal."""
        return not self.below and (self.above.isdigit() or r"\ldots" in self.above)


@lru_cache(maxsize=4096)
def number_to_latex(number: Number) -> Printed:
    r"""Return a number as LaTeX: one fraction without a root in the denominator, or for a long one a truncated decimal.

    >>> number_to_latex(Number(37, 36, -1, 1729))
    Printed(sign=-1, above='\\sqrt{1729} - 37', below='36', is_sum=True)
    """
    value = number.numerator if number.r else number.p
    sign = (value > 0) - (value < 0)
    p, q, r = sign * number.p, number.q, sign * number.r
    if max(q, *((abs(p), abs(r)) if r else (0,))) >= LONG:
        return Printed(sign, truncated(number._replace(p=p, r=r)))
    common = gcd(p, r) if p and r else 1
    above, p, r = str(p), p // common, r // common
    if r:
        roots = rf"{abs(r)}\,\sqrt{{{number.n}}}" if abs(r) > 1 else rf"\sqrt{{{number.n}}}"
        # The absolute value is positive, so one of its two terms is positive. This term comes first.
        above = roots if not p else f"{roots} - {-p}" if p < 0 else f"{p} {'-' if r < 0 else '+'} {roots}"
    above = rf"{common}\,\left({above}\right)" if common > 1 else above
    return Printed(sign, above, str(q) if q > 1 else "", bool(p and r) and common == 1)


def truncated(number: Number) -> str:
    r"""Return a number > 0 as a decimal of eight digits; a longer decimal is truncated and ends in dots.

    >>> truncated(Number(2, 3))
    '0.66666666\\ldots'
    """
    return _decimal(number, ROUND_DOWN, DIGITS, r"\ldots")[0]


def rounded(number: Number, digits: int = DIGITS) -> str:
    """Return a number as a decimal rounded to some significant digits, without trailing zeros.

    >>> rounded(Number(-2, 3), 4)
    '-0.6667'
    """
    return _decimal(number, ROUND_HALF_EVEN, digits)[0]


def decimal_of(number: Number, digits: int = DIGITS) -> str:
    r"""Return a relation sign and a decimal as LaTeX: ≈ before a rounded decimal, = before an exact one.

    >>> decimal_of(Number(196, 25)), decimal_of(Number(-2, 3), 4)
    ('= 7.84', '\\approx -0.6667')
    """
    text, is_exact = _decimal(number, ROUND_HALF_EVEN, digits)
    return f"= {text}" if is_exact else rf"\approx {text}"


def _decimal(number: Number, rounding: str, digits: int, ellipsis: str = "") -> tuple[str, bool]:
    """Return a decimal, with a power of ten for many zeros and a mark if it is not exact, and whether it is exact."""
    value = number.numerator
    quotient = Context(prec=digits, rounding=rounding).divide(value, number.q)
    if not quotient:
        return "0", True
    is_exact = not number.r and _EXACTLY.multiply(quotient, number.q) == value
    exponent = quotient.adjusted()
    has_power = not -5 <= exponent < digits
    text = f"{quotient.scaleb(-exponent) if has_power else quotient:f}"
    if is_exact or not ellipsis:
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        text += ellipsis
    text = in_latex(text)
    return rf"{text} \times 10^{{{exponent}}}" if has_power else text, is_exact
