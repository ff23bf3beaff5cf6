"""Numbers into formulas, exactly: masses may be fractions or carry a root such as √1729.

SymPy's own `subs` and simplification take hundreds of milliseconds for a derivation. Here every part that has become a
number is evaluated as an element of its number field, ℚ or ℚ(√…), and written back once. `slots` does the same for the
pages, where a whole derivation may take a millisecond; this is the general way, to which the tests hold it.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from functools import lru_cache, partial, reduce
from typing import Any

import sympy as sp
from sympy.polys.domains import Domain
from sympy.utilities.iterables import sift

_Values = tuple[tuple[sp.Symbol, sp.Expr], ...]
_Roots = frozenset[sp.Expr]


def put_in(expression: sp.Basic, values: Mapping[sp.Symbol, sp.Expr]) -> sp.Basic:
    """Return the expression, relation or matrix with the values put in, each number one fraction, no root below it.

    What keeps a symbol keeps its shape: only the numbers that are added or multiplied side by side are drawn together.

    Parameters
    ----------
    expression : contains the values' symbols as rational functions
    values : symbol → exact value, an integer, a fraction or a number with roots

    >>> from ramanujan.derivation.symbols import R, m, m_prime
    >>> put_in(R * (3 * m + m_prime) / 2, {m: sp.Integer(1), m_prime: sp.Rational(1, 2)})
    7*R/4
    """
    exact = tuple((symbol, sp.sympify(value)) for symbol, value in values.items())
    return gather_numbers(expression, frozenset(values), partial(_number, values=exact))


def gather_numbers(expression: sp.Basic, given: frozenset[sp.Symbol], number: Callable[[sp.Expr], sp.Expr]) -> sp.Basic:
    """Return the expression with each part that is a rational function of the given symbols alone replaced.

    Parameters
    ----------
    expression : an expression, a relation or a matrix
    given : the symbols that have a value
    number : part → the expression that replaces it
    """
    if given.isdisjoint(expression.free_symbols):
        return expression
    if _is_number(expression, given):
        return number(expression)
    inner = partial(gather_numbers, given=given, number=number)
    if isinstance(expression, sp.Eq):
        return sp.Eq(*map(inner, expression.args), evaluate=False)
    if not isinstance(expression, sp.Add | sp.Mul):
        return expression.func(*map(inner, expression.args))
    numbers, rest = sift(expression.args, lambda argument: _is_number(argument, given), binary=True)
    if numbers and expression.is_Mul and (sums := [argument for argument in rest if argument.is_Add]):
        # A number before a sum goes into it, where it meets the numbers of the terms, and takes a denominator along.
        rest.remove(sums[0])
        below, before = sift(rest, lambda argument: argument.is_Pow and argument.exp.is_negative, binary=True)
        distributed = sp.Add(*(sp.Mul(*numbers, term, *below) for term in sums[0].args))
        return inner(sp.Mul(distributed, *before))
    drawn_together = (number(expression.func(*numbers)),) if numbers else ()
    return expression.func(*drawn_together, *map(inner, rest))


def _is_number(expression: sp.Basic, given: frozenset[sp.Symbol]) -> bool:
    """Tell whether the expression is a rational function of the given symbols alone."""
    if expression.is_Symbol:
        return expression in given
    return expression.is_Rational or (
        type(expression) in (sp.Add, sp.Mul, sp.Pow) and all(_is_number(part, given) for part in expression.args)
    )


@lru_cache(maxsize=1024)
def _number(expression: sp.Expr, values: _Values) -> sp.Expr:
    roots = frozenset().union(*(_roots(value) for _, value in values))
    if roots and expression.is_Add and not _roots(expression) <= roots:
        # A field with the roots of both would take seconds to find; the sum of two numbers needs none.
        own, foreign = sift(expression.args, lambda term: _roots(term) <= roots, binary=True)
        return sp.Add(_number(sp.Add(*own), values), *foreign)
    field, elements = _number_field(values, _roots(expression))
    number = field.to_sympy(_evaluate(expression, field, elements))
    content, primitive = number.primitive()
    if number.is_Rational or content == 1:
        return number
    if sp.N(primitive, 3) < 0:
        content, primitive = -content, -primitive
    return sp.Mul(content, primitive, evaluate=False)


@lru_cache(maxsize=64)
def _number_field(values: _Values, others: _Roots) -> tuple[Domain, dict[sp.Symbol, Any]]:
    """Return the field in which the values and some other roots lie, and the values as its elements."""
    field = _field_with(others.union(*(_roots(value) for _, value in values)))
    return field, {symbol: _evaluate(value, field, {}) for symbol, value in values}


def _roots(expression: sp.Expr) -> _Roots:
    return frozenset(power for power in expression.atoms(sp.Pow) if not power.exp.is_Integer)


@lru_cache(maxsize=8)
def _field_with(roots: _Roots) -> Domain:
    return sp.QQ.algebraic_field(*sorted(roots, key=sp.default_sort_key)) if roots else sp.QQ


@lru_cache(maxsize=64)
def _element(number: sp.Expr, field: Domain) -> Any:
    return field.from_sympy(number)


def _evaluate(expression: sp.Expr, field: Domain, elements: Mapping[sp.Symbol, Any]) -> Any:
    """Return the value of a rational function as an element of the field: exact, and far faster than simplifying."""
    if expression.is_Symbol:
        return elements[expression]
    if expression.is_Pow and expression.exp.is_Integer:
        return _evaluate(expression.base, field, elements) ** int(expression.exp)
    if expression.is_Add or expression.is_Mul:
        combine = operator.add if expression.is_Add else operator.mul
        return reduce(combine, (_evaluate(argument, field, elements) for argument in expression.args))
    return _element(expression, field)
