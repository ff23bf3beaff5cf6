"""Formulas as they were typed, SymPy's nodes unevaluated: their size, their letters, and their LaTeX."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise

import sympy as sp

from ramanujan.derivation.printers import latex


def is_number(token: object) -> bool:
    """Tell whether this is a number as typed: a whole number, a fraction such as ½, or a decimal."""
    return isinstance(token, sp.Rational) or is_decimal(token)


def is_decimal(token: object) -> bool:
    """Tell whether this is a number typed with a decimal point."""
    return isinstance(token, sp.Symbol) and token.name[:1] in "0123456789."


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


def _bare(factor: sp.Expr) -> sp.Expr:
    """Return a factor without the ones that it is multiplied by: 1·(m + m) needs its brackets as m + m does."""
    parts = [part for part in factor.args if part != 1] if factor.is_Mul else []
    return _bare(parts[0]) if len(parts) == 1 else factor


def _product(factors: tuple[sp.Expr, ...]) -> str:
    first, *rest = map(_bare, factors)
    factors = (first, *rest)
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
