"""One expression, two languages: LaTeX for the eye, JavaScript for the stage.

Nothing is derived here and nothing is typed: what goes in is a SymPy expression, what comes out says the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from typing import Any

import sympy as sp
from sympy.physics.vector.printing import VectorLatexPrinter, VectorPrettyPrinter
from sympy.printing.latex import translate

from ramanujan.derivation.exact import LONG, Number, truncated
from ramanujan.derivation.symbols import (
    COORDINATES,
    VELOCITIES,
    Omega_clamped_squared,
    Omega_squared,
    epsilon_star,
    m_prime,
    normalized_frequency_squared,
    t,
)

_NAMES = {
    m_prime: "m'",
    epsilon_star: r"\varepsilon_{*}",
    Omega_squared: r"\Omega^{2}",
    Omega_clamped_squared: r"\Omega_{\text{clamped}}^{2}",
    normalized_frequency_squared: r"\frac{\Omega^{2}\,m}{k}",
    sp.Symbol("L"): r"\mathcal{L}",
    sp.Symbol("H"): r"\mathcal{H}",
    sp.Symbol("H_0"): r"\mathcal{H}_{0}",
}
_PLAIN = {
    **dict(zip(VELOCITIES, sp.symbols("X_dot phi_dot Phi_dot"), strict=True)),
    **dict(zip(COORDINATES, sp.symbols("X phi Phi"), strict=True)),
    sp.Symbol("R", positive=True): sp.Symbol("radius"),
}
"""What a program calls the coordinates, their rates and R."""


class InOrder(sp.Add):
    """A sum whose like terms are not collected, printed in its order; any calculation makes it a plain sum.

    >>> x = sp.Symbol("x")
    >>> print(latex(in_order(3 * x, -x)), in_order(3 * x, -x).subs(x, 1))
    3\\,x - x 2
    """

    def __new__(cls, *terms: sp.Expr, evaluate: bool = True) -> sp.Add:
        return sp.Add(*terms) if evaluate else super().__new__(cls, *terms, evaluate=False)


def in_order(*terms: sp.Expr) -> InOrder:
    """Return a sum whose terms stay as they are."""
    return InOrder(*terms, evaluate=False)


class LatexPrinter(VectorLatexPrinter):
    """SymPy's printer for mechanics, with words as subscripts set as text, and chosen names in a colour."""

    def __init__(self, highlight: Mapping[sp.Basic, str]) -> None:
        super().__init__({"symbol_names": _NAMES, "mul_symbol": r"\,"})
        self._highlight = highlight

    def _print(self, expr: sp.Basic, **kwargs: Any) -> str:
        text = super()._print(expr, **kwargs)
        return colored(text, self._highlight.get(expr)) if self._highlight and isinstance(expr, sp.Basic) else text

    def _print_Rational(self, expr: sp.Rational) -> str:
        if expr.q < LONG:
            return super()._print_Rational(expr)
        return ("- " if expr.p < 0 else "") + truncated(Number(abs(expr.p), expr.q))

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        if isinstance(expr, InOrder):
            return super()._print_Add(expr, "none")
        if expr.is_number and len(expr.args) == 2 and expr.args[0].is_Rational and expr.args[0] < 0:
            # √1729 − 1, as it is written by hand, and not −1 + √1729.
            number, root = expr.args
            return f"{self._print(root)} - {self._print(-number)}"
        return super()._print_Add(expr, order)

    def _print_Derivative(self, expr: sp.Derivative) -> str:
        return _dotted(expr)

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        letter, _, word = expr.name.partition("_")
        is_word = len(word) > 2 and translate(word) == word
        if is_word and expr not in self._settings["symbol_names"]:
            return rf"{super()._print_Symbol(sp.Symbol(letter))}_{{\text{{{word}}}}}"
        return super()._print_Symbol(expr, style)


@cache
def _dotted(derivative: sp.Derivative) -> str:
    """Return q̇ or q̈ in LaTeX; SymPy differentiates again to print it, which is half of the time of a formula."""
    return VectorLatexPrinter().doprint(derivative)


@lru_cache(maxsize=2048)
def latex(expression: sp.Basic) -> str:
    """Return the LaTeX of an expression or relation: primes and dots as physicists write them.

    A fraction that no eye can read (a denominator of eight digits or more) is written as a decimal that ends in dots.

    >>> from ramanujan.derivation.symbols import X, m_prime
    >>> latex(m_prime * X.diff().diff())
    "m'\\\\,\\\\ddot{X}"
    """
    return LatexPrinter({}).doprint(expression)


def colored(formula: str, color: str | None) -> str:
    """Return LaTeX in a colour, #rrggbb; without a colour, as it is."""
    return rf"\textcolor{{{color}}}{{{formula}}}" if color else formula


def plain_text(expression: sp.Expr) -> str:
    """Return a short expression as a label: Unicode on one line, factors side by side.

    >>> from ramanujan.derivation.symbols import R, phi
    >>> plain_text(2 * R * phi)
    '2Rφ'
    """
    named = expression.subs({q: sp.Function(str(q.func).replace("var", ""))(t) for q in COORDINATES}).doit()
    return VectorPrettyPrinter({"use_unicode": True, "wrap_line": False}).doprint(named).replace("⋅", "")


def javascript(formulas: Mapping[str, Any]) -> str:
    """Return a JavaScript object literal: each SymPy expression becomes an arrow function of its symbols by name.

    Parameters
    ----------
    formulas : name → expression, or name → another such mapping

    >>> from ramanujan.derivation.symbols import k, m
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
