r"""Numbers into formulas: SymPy prints a formula once for each shape of its numbers, then any digits are put in.

Where masses and stiffness have values, each formula is a sum of terms, with a number wherever m, m′ and k stood alone.
The template keeps these terms, and each number as a rational function of m, m′ and k:

    ½R²(8m + 7m′)φ̇²   →   □R²φ̇²  with  □ = (8m + 7m′)/2   →   \frac{15\,R^{2}\,\dot{\varphi}^{2}}{2}

The shape of a number is its sign, and whether it is 1, a fraction, or a sum with a root. SymPy's printer needs no more
to set signs, fraction bars and brackets. It takes ten times as long as all the rest, so what it prints is kept.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from math import lcm, prod
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain
from sympy.utilities.iterables import sift

from ramanujan.derivation.model import k, m, m_prime
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import InOrder, LatexPrinter, Number, Printed, in_order, number_to_latex

GIVEN = (m, m_prime, k)
"""The symbols that have a value."""

Highlight = tuple[tuple[sp.Basic, str], ...]
"""Symbols, or functions of time, and their colours."""

_PRIVATE = 0xE000
"""The first of the characters that no formula contains: one for each numerator, one for each denominator."""


@dataclass(frozen=True)
class Template:
    """One side of an equation: its terms with a slot for each number, and the numbers as functions of m, m′ and k."""

    terms: tuple[sp.Basic, ...]
    numbers: tuple[sp.Expr, ...]
    highlight: Highlight

    def filled(self, given: Numbers | None = None) -> list[str]:
        """Return the terms as LaTeX, each with its sign; without numbers there must be no slot."""
        found = [number_to_latex(number) for number in self.evaluated(given)] if self.numbers else []
        digits = dict(enumerate((part for number in found for part in (number.above, number.below)), _PRIVATE))
        texts = []
        for term in self.terms:
            shapes = tuple((place, _shape(found[place])) for place in _places(term))
            texts.append(_printed(term, shapes, self.highlight).translate(digits))
        first, *others = [text for text in texts if text != "0"] or ["0"]
        return [first, *(f" - {each[1:].lstrip()}" if each[0] == "-" else f" + {each}" for each in others)]

    def evaluated(self, given: Numbers) -> list[Number]:
        """Return the numbers in the formula, exactly; m′/m may carry a square root."""
        field, known = _field(_root_in(*self.numbers, *given.exact.values()))
        known = known | {symbol: _worth(value, field, known) for symbol, value in given.exact.items()}
        return [_number(_worth(number, field, known), field) for number in self.numbers]


@lru_cache(maxsize=1024)
def template(side: sp.Basic, highlight: Highlight = (), with_slots: bool = True) -> Template:
    """Return one side of an equation as a template.

    Parameters
    ----------
    side : an expression, a matrix or a tuple; rational in m, m′ and k
    highlight : symbols, or functions of time, in a colour
    with_slots : False for the formula in symbols, which has no slot to fill
    """
    numbers: dict[sp.Expr, sp.Symbol] = {}

    def slot(number: sp.Expr) -> sp.Expr:
        return numbers.setdefault(number, _Slot(str(len(numbers)), positive=True))

    slotted = gather_numbers(side, slot) if with_slots else side
    terms = _terms(slotted) if isinstance(slotted, sp.Add) else [slotted]
    return Template(tuple(terms), tuple(numbers), highlight)


def gather_numbers(expression: sp.Basic, replaced: Callable[[sp.Expr], sp.Expr]) -> sp.Basic:
    """Return the expression with each part that is a rational function of m, m′ and k alone replaced.

    Parameters
    ----------
    expression : an expression or a matrix
    replaced : part → what replaces it
    """
    if expression.free_symbols.isdisjoint(GIVEN):
        return expression
    if _is_number(expression):
        return replaced(expression)
    if isinstance(expression, InOrder):
        return in_order(*(gather_numbers(part, replaced) for part in expression.args))
    if not isinstance(expression, sp.Add | sp.Mul):
        return expression.func(*(gather_numbers(part, replaced) for part in expression.args))
    numbers, rest = sift(expression.args, _is_number, binary=True)
    if numbers and expression.is_Mul and (sums := [argument for argument in rest if argument.is_Add]):
        # A number before a sum goes into it, where it meets the numbers of the terms, and takes a denominator along.
        rest.remove(sums[0])
        below, before = sift(rest, lambda argument: argument.is_Pow and argument.exp.is_negative, binary=True)
        distributed = sp.Add(*(sp.Mul(*numbers, term, *below) for term in sums[0].args))
        return gather_numbers(sp.Mul(distributed, *before), replaced)
    gathered = (gather_numbers(part, replaced) for part in rest)
    return expression.func(*([replaced(expression.func(*numbers))] if numbers else []), *gathered)


def _is_number(expression: sp.Expr) -> bool:
    """Tell whether the expression is a rational function of m, m′ and k alone."""
    if expression.is_Symbol:
        return expression in GIVEN
    return expression.is_Rational or (
        type(expression) in (sp.Add, sp.Mul, sp.Pow) and all(_is_number(part) for part in expression.args)
    )


# Formulas with slots


class _Slot(sp.Symbol):
    """Stands for a number; its name is the place of the number among those of its side."""


class _Part(sp.Symbol):
    """Stands for the numerator or the denominator of a number, and is printed as one private character."""

    def sort_key(self, order: str | None = None) -> tuple:
        """Return a key that comes before that of any other symbol: in a product, numbers come first."""
        return sp.Symbol("").sort_key(order)


class _Sum(InOrder):
    """A numerator with a root, p + r√n; it is printed as one character, and in brackets where a sum needs them."""

    def sort_key(self, order: str | None = None) -> tuple:
        """Return the key of its first part."""
        return self.args[0].sort_key(order)


class _ShapePrinter(LatexPrinter):
    """Prints the parts of a number as they are named."""

    def _print__Part(self, expr: _Part) -> str:
        return expr.name

    def _print__Sum(self, expr: _Sum) -> str:
        return expr.args[0].name


Shape = tuple[int, bool, bool, bool]
"""The sign of a number, and whether its numerator is 1, whether it is a sum, and whether there is a denominator."""


def _shape(number: Printed) -> Shape:
    return number.sign, number.above == "1", number.is_sum, bool(number.below)


def _of_shape(place: int, shape: Shape) -> sp.Expr:
    """Return an expression that SymPy prints as it would print a number of that shape."""
    sign, is_one, is_sum, has_denominator = shape
    above, below = (_Part(chr(_PRIVATE + 2 * place + part), positive=True) for part in (0, 1))
    numerator = sp.S.One if is_one else _Sum(above, below, evaluate=False) if is_sum else above
    factors = [*([] if sign > 0 else [sp.Integer(sign)]), numerator, *([1 / below] if has_denominator else [])]
    return factors[0] if len(factors) == 1 else sp.Mul(*factors, evaluate=not is_sum or not sign)


@lru_cache(maxsize=8192)
def _places(term: sp.Basic) -> tuple[int, ...]:
    """Return the places of the numbers in a term."""
    return tuple(sorted(int(symbol.name) for symbol in term.free_symbols if isinstance(symbol, _Slot)))


@lru_cache(maxsize=8192)
def _printed(term: sp.Basic, shapes: tuple[tuple[int, Shape], ...], highlight: Highlight) -> str:
    """Return a term as LaTeX, with characters in place of the digits of its numbers."""
    numbers = {place: _of_shape(place, shape) for place, shape in shapes}
    return _ShapePrinter(dict(highlight)).doprint(_put(term, numbers))


def _put(expression: sp.Basic, numbers: Mapping[int, sp.Expr]) -> sp.Basic:
    """Return an expression with numbers in its slots, every sum in the order in which it is read."""
    if isinstance(expression, _Slot):
        return numbers[int(expression.name)]
    if not _places(expression):
        return expression
    if isinstance(expression, sp.Add):
        return in_order(*(_put(term, numbers) for term in _terms(expression)))
    return expression.func(*(_put(part, numbers) for part in expression.args))


def _terms(total: sp.Add) -> list[sp.Expr]:
    """Return the terms of a sum in the order in which they are read: that of the terms without their numbers."""
    if isinstance(total, InOrder):
        return list(total.args)
    bare = {term: _without_number(term) for term in total.args}
    order = sp.Add(*set(bare.values())).as_ordered_terms()
    return sorted(total.args, key=lambda term: order.index(bare[term]))


def _without_number(term: sp.Expr) -> sp.Expr:
    slots, others = sift(sp.Mul.make_args(term), lambda factor: isinstance(factor, _Slot), binary=True)
    return sp.Mul(*others) if slots else term


# Numbers


@cache
def _field(root: sp.Pow | None) -> tuple[Domain, Mapping[sp.Basic, Any]]:
    """Return the field of all p + r√n with fractions p and r, and the root in it; without a root, that of fractions."""
    field = sp.QQ.algebraic_field(root) if root else sp.QQ
    return field, {root: field.unit} if root else {}


def _worth(number: sp.Expr, field: Domain, known: Mapping[sp.Basic, Any]) -> Any:
    """Return the value of a number in a field."""
    if number in known:
        return known[number]
    if number.is_Add or number.is_Mul:
        parts = (_worth(part, field, known) for part in number.args)
        return sum(parts, field.zero) if number.is_Add else prod(parts, start=field.one)
    return _worth(number.base, field, known) ** int(number.exp) if number.is_Pow else field.from_sympy(number)


def _number(value: Any, field: Domain) -> Number:
    """Return a value in a field as (p + r√n)/q."""
    of_root = field.is_Algebraic
    parts = [0, 0, *value.to_list()][-2:] if of_root else [0, value]
    r, p = (Fraction(int(part.numerator), int(part.denominator)) for part in parts)
    q = lcm(p.denominator, r.denominator)
    return Number.of(int(p * q), int(r * q), q, int(field.ext.args[0] ** 2) if of_root else 1)


@lru_cache(maxsize=4096)
def _root_in(*values: sp.Expr) -> sp.Pow | None:
    """Return the square root in some numbers, or None if all are fractions."""
    roots = (power for value in values for power in value.atoms(sp.Pow) if not power.exp.is_Integer)
    return next(roots, None)
