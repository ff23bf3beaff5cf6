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
from sympy.printing.latex import translate as translate_name

from ramanujan.derivation import model
from ramanujan.derivation.order import InOrder, Product, is_coefficient, is_motion, order_terms, to_product
from ramanujan.text.names import BODIES
from ramanujan.text.numerals import in_latex
from ramanujan.text.translation import pgettext

# TRANSLATORS: what a symbol belongs to, in small letters below it, as in v with the subscript hoop; very short.
_SUBSCRIPTS = {
    **{body: names.subscript for body, names in BODIES.items()},
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

_EXACT_CONTEXT = Context(prec=200)

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
        return apply_color(text, self._highlight.get(expr)) if self._highlight and isinstance(expr, sp.Basic) else text

    def _print_Integer(self, expr: sp.Integer) -> str:
        return str(expr)

    def _print_Rational(self, expr: sp.Rational) -> str:
        return self._write_product(Product(expr, (), ()))

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        if isinstance(expr, InOrder) or not expr.is_number:
            return "".join(add_signs([self._print(term) for term in order_terms(expr)]))
        if to_quadratic(expr) is None:
            return super()._print_Add(expr, order)
        return self._write_product(Product(expr, (), ()))

    def _print_Mul(self, expr: sp.Expr) -> str:
        return self._write_product(to_product(expr))

    def _write_product(self, term: Product) -> str:
        """Return a product as a coefficient and the factors after it, such as ¾m and R²Φ̇²; either may be missing.

        Number and factors share one fraction if factors are below it, 2p/(3R), or if the only factor above is a sum,
        (8m + 7m′)/2.
        """
        number = to_quadratic(term.number)
        if number is None:
            return self._write_product_of_other_number(term)
        sign, numerator, denominator, is_sum = number_to_latex(number)
        coefficient, other_factors = _split_coefficient(term)
        is_one_sum = len(term.above) == 1 and term.above[0].is_Add and not other_factors
        if denominator and not term.below and not is_one_sum:
            # Write the number as a separate fraction before the factors.
            numerator, denominator = rf"\frac{{{numerator}}}{{{denominator}}}", ""
        elif is_sum and (term.above or (sign < 0 and not term.below)):
            # The numerator p + r√n is a factor, or follows a minus sign.
            numerator = rf"\left({numerator}\right)"
        below = self._write_factors(denominator, term.below)
        if below:
            above = self._write_factors(numerator, coefficient)
            numerator, coefficient = rf"\frac{{{above}}}{{{below}}}", ()
        minus = "- " if sign < 0 else ""
        return minus + self._write_factors(numerator, (*coefficient, *other_factors), is_term=bool(minus))

    def _write_product_of_other_number(self, term: Product) -> str:
        """Return a product in SymPy's own order, for a number with more than one root."""
        return super()._print_Mul(sp.Mul(term.number, *term.above, *(1 / factor for factor in term.below)))

    def _write_factors(self, number: str, factors: Sequence[sp.Expr], is_term: bool = False) -> str:
        """Return the factors after a number; omit the number if it is 1 or empty.

        Put a sum in brackets, unless it is the only factor and not a term of another sum.
        """
        if not factors:
            return number
        has_number = number not in ("", "1")
        if len(factors) == 1 and not has_number and not is_term:
            return self._print(factors[0])
        texts = [number] if has_number else []
        for factor in factors:
            text = self._print(factor)
            texts.append(rf"\left({text}\right)" if factor.is_Add else text)
        joined, *others = texts
        for other in others:
            # Adjacent numbers in an unevaluated product would look like one number or a difference.
            separator = r" \cdot " if other[0].isdigit() else r"\,"
            joined += separator + (rf"\left({other}\right)" if other.startswith("-") else other)
        return joined

    def _print_Derivative(self, expr: sp.Derivative) -> str:
        return _print_derivative(expr)

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        letter, _, word = expr.name.partition("_")
        # SymPy translates the name of a Greek letter, such as alpha, but not a word.
        is_word = len(word) > 2 and translate_name(word) == word
        if is_word and expr not in self._settings["symbol_names"]:
            return rf"{super()._print_Symbol(sp.Symbol(letter))}_{{\text{{{_SUBSCRIPTS.get(word, word)}}}}}"
        return super()._print_Symbol(expr, style)


def _split_coefficient(term: Product) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """Return the factors above the fraction bar, and those after the fraction: in (k/m)Rφ, k and Rφ.

    All factors are above the bar if the denominator contains motion. They are also above the bar if the denominator has
    symbols and no mass is above it.
    """
    coefficient = tuple(filter(is_coefficient, term.above))
    has_motion_below = any(map(is_motion, term.below))
    has_symbols_below = any(factor.free_symbols for factor in term.below)
    if has_motion_below or (has_symbols_below and not coefficient):
        return term.above, ()
    return coefficient, term.above[len(coefficient) :]


@cache
def _print_derivative(derivative: sp.Derivative) -> str:
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


def add_signs(texts: Sequence[str]) -> list[str]:
    """Return the LaTeX of the nonzero terms of a sum, with a sign before each term after the first."""
    first, *others = [text for text in texts if text != "0"] or ["0"]
    signed = [first]
    for text in others:
        signed.append(f" - {text[1:].lstrip()}" if text.startswith("-") else f" + {text}")
    return signed


def apply_color(formula: str, color: str | None) -> str:
    """Return LaTeX in a colour, #rrggbb; without a colour, return it unchanged."""
    return rf"\textcolor{{{color}}}{{{formula}}}" if color else formula


def plain_text(term: sp.Expr) -> str:
    """Return a term without a fraction as a label: Unicode on one line, its factors in the order of the equations.

    >>> from ramanujan.derivation.model import R, k, phi
    >>> plain_text(-2 * R * k * phi)
    '−2kRφ'
    """
    # The printer has the letter φ for the name phi, but not for varphi.
    renamed = {q: sp.Function(str(q.func).replace("var", ""))(model.t) for q in model.COORDINATES}
    printer = VectorPrettyPrinter({"use_unicode": True, "wrap_line": False})
    number, factors, _below = to_product(term)
    size = [] if factors and abs(number) == 1 else [abs(number)]
    texts = [printer.doprint(factor.subs(renamed).doit()) for factor in (*size, *factors)]
    return "".join(["−" if number < 0 else "", *texts])


def javascript(formulas: Mapping[str, Any]) -> str:
    """Return a JavaScript object literal with an arrow function of named symbols for each SymPy expression.

    Parameters
    ----------
    formulas : name → expression, or name → another such mapping

    >>> from ramanujan.derivation.model import k, m
    >>> javascript({"plain": sp.sqrt(k / m)})
    '{plain: ({k, m}) => Math.sqrt(k)/Math.sqrt(m)}'
    """
    entries = []
    for name, value in formulas.items():
        text = javascript(value) if isinstance(value, Mapping) else _arrow_function(value)
        entries.append(f"{name}: {text}")
    return "{" + ", ".join(entries) + "}"


def _arrow_function(expression: sp.Expr) -> str:
    plain = sp.sympify(expression).subs(_PLAIN)
    names = sorted(symbol.name for symbol in plain.free_symbols)
    return f"({{{', '.join(names)}}}) => {sp.jscode(plain)}"


# Numbers (p + r√n)/q


class QuadraticNumber(NamedTuple):
    """(p + r√n)/q in lowest terms, q > 0; a fraction has r = 0."""

    p: int
    q: int = 1
    r: int = 0
    n: int = 1

    @classmethod
    def of(cls, p: int, r: int, q: int, n: int) -> "QuadraticNumber":
        """Return (p + r√n)/q.

        >>> QuadraticNumber.of(-2, 2, 72, 1729)
        QuadraticNumber(p=-1, q=36, r=1, n=1729)
        """
        common = gcd(p, q, r) if q > 0 else -gcd(p, q, r)
        return cls(p=p // common, q=q // common, r=r // common, n=n)

    @property
    def numerator(self) -> Decimal:
        """p + r√n, to 40 digits or more even if the two terms nearly cancel."""
        if not self.r:
            return Decimal(self.p)
        context = Context(prec=40 + 2 * len(str(abs(self.p) + abs(self.r))))
        return context.fma(Decimal(self.r), context.sqrt(Decimal(self.n)), Decimal(self.p))


def to_quadratic(value: sp.Expr) -> QuadraticNumber | None:
    """Return a SymPy number as (p + r√n)/q, or None if this is impossible.

    >>> to_quadratic((sp.sqrt(1729) - 1) / 36)
    QuadraticNumber(p=-1, q=36, r=1, n=1729)
    """
    if value.is_Rational:
        return QuadraticNumber(int(value.p), int(value.q))
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
    return QuadraticNumber.of(int(p * q), int(r * q), q, int(root.base))


class LatexNumber(NamedTuple):
    """A number as LaTeX: its sign (1, 0 or −1), and numerator and denominator of its absolute value.

    `below` is "" for the denominator 1. `is_sum` is true for a numerator p + r√n, which needs brackets as a factor.
    """

    sign: int
    above: str
    below: str = ""
    is_sum: bool = False

    @property
    def needs_no_decimal(self) -> bool:
        """Whether the number is an integer or already a decimal."""
        return not self.below and (self.above.isdigit() or r"\ldots" in self.above)


@lru_cache(maxsize=4096)
def number_to_latex(number: QuadraticNumber) -> LatexNumber:
    r"""Return a number as LaTeX: one fraction without a root in the denominator, or a truncated decimal if it is long.

    >>> number_to_latex(QuadraticNumber(37, 36, -1, 1729))
    LatexNumber(sign=-1, above='\\sqrt{1729} - 37', below='36', is_sum=True)
    """
    value = number.numerator
    sign = (value > 0) - (value < 0)
    absolute = number._replace(p=sign * number.p, r=sign * number.r)
    p, q, r, _n = absolute
    is_long = q >= LONG or (r != 0 and max(abs(p), abs(r)) >= LONG)
    if is_long:
        return LatexNumber(sign, truncate(absolute))
    below = str(q) if q > 1 else ""
    if r == 0:
        return LatexNumber(sign, str(p), below)
    common = gcd(p, r) if p else 1
    above = _sum_to_latex(p // common, r // common, number.n)
    if common > 1:
        above = rf"{common}\,\left({above}\right)"
    return LatexNumber(sign, above, below, is_sum=p != 0 and common == 1)


def _sum_to_latex(p: int, r: int, n: int) -> str:
    """Return p + r√n > 0 as LaTeX, with a positive term first."""
    root = rf"{abs(r)}\,\sqrt{{{n}}}" if abs(r) > 1 else rf"\sqrt{{{n}}}"
    if p == 0:
        return root
    if p < 0:
        return f"{root} - {-p}"
    return f"{p} {'-' if r < 0 else '+'} {root}"


def truncate(number: QuadraticNumber) -> str:
    r"""Return a number > 0 as a decimal of eight digits; a longer decimal is truncated and ends in dots.

    >>> truncate(QuadraticNumber(2, 3))
    '0.66666666\\ldots'
    """
    return _write_decimal(number, ROUND_DOWN, DIGITS, r"\ldots")[0]


def round_number(number: QuadraticNumber, digits: int = DIGITS) -> str:
    """Return a number as a decimal rounded to some significant digits, without trailing zeros.

    >>> round_number(QuadraticNumber(-2, 3), 4)
    '-0.6667'
    """
    return _write_decimal(number, ROUND_HALF_EVEN, digits)[0]


def format_decimal(number: QuadraticNumber, digits: int = DIGITS) -> str:
    r"""Return a relation sign and a decimal as LaTeX: ≈ before a rounded decimal, = before an exact one.

    >>> format_decimal(QuadraticNumber(196, 25)), format_decimal(QuadraticNumber(-2, 3), 4)
    ('= 7.84', '\\approx -0.6667')
    """
    text, is_exact = _write_decimal(number, ROUND_HALF_EVEN, digits)
    return f"= {text}" if is_exact else rf"\approx {text}"


def _write_decimal(number: QuadraticNumber, rounding: str, digits: int, ellipsis: str = "") -> tuple[str, bool]:
    """Return a decimal as LaTeX, and whether it is exact.

    Parameters
    ----------
    number : the number
    rounding, digits : as in `decimal.Context`
    ellipsis : the end of a decimal that is not exact. Without it, trailing zeros are omitted.
    """
    value = number.numerator
    quotient = Context(prec=digits, rounding=rounding).divide(value, number.q)
    if not quotient:
        return "0", True
    is_exact = not number.r and _EXACT_CONTEXT.multiply(quotient, number.q) == value
    exponent = quotient.adjusted()
    has_power = not -5 <= exponent < digits
    text = f"{quotient.scaleb(-exponent) if has_power else quotient:f}"
    if ellipsis and not is_exact:
        text += ellipsis
    elif "." in text:
        text = text.rstrip("0").rstrip(".")
    text = in_latex(text)
    return rf"{text} \times 10^{{{exponent}}}" if has_power else text, is_exact
