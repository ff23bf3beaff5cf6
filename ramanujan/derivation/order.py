"""The order of a formula as in a textbook: one table for the factors of a product and for the terms of a sum.

    factors   number, frequencies, k, masses, sums of masses, R, then functions of time          −2(m + m′)RẊφ̇
    terms     by highest derivative; squares, then products; X before Φ before φ    ½(3m + 2m′)Ẋ² + ¾mR²Φ̇² + …
    signs     if the first term is negative, the first positive term precedes it                   4kRφ − 2mẌ

The printers write every product and every sum in this order, in symbols and with numbers. A sum made by `in_order`
keeps the order of its terms instead.
"""

from functools import lru_cache
from typing import Any, NamedTuple

import sympy as sp
from sympy.core.function import AppliedUndef

SUM = "a sum of masses in brackets"

LETTERS = (
    *("omega", "Omega"),
    "k",
    *("m", "M", "I", "varepsilon"),
    SUM,
    "R",
    *("p", "x", "v", "a", "alpha", "S", "F", "xi", "eta"),
    *("X", "Phi", "varphi"),
)
"""The letters of symbols, from the first factor of a product to the last."""

SUBSCRIPTS = ("", "prime", "X", "Phi", "varphi", "block", "hoop", "cylinder", "slab", "top")
"""Subscripts and primes of a letter, in order: m before m′, the hoop before the cylinder."""

CONSTANTS = ("k", "m", "M", "I", "R")
"""Letters of constants. A sum is ordered by its other symbols first: motion, frequency or mass ratio."""

DERIVATIVES = {"a": 2, "alpha": 2, "v": 1, "p": 1, "S": -1, "F": -1}
"""The order of a letter as a time derivative. Friction forces come after the coordinates."""

Key = tuple[Any, ...]
_LETTER_RANK = {letter: rank for rank, letter in enumerate(LETTERS)}
_SUBSCRIPT_RANK = {subscript: rank for rank, subscript in enumerate(SUBSCRIPTS)}


class InOrder(sp.Add):
    """A sum with uncollected like terms, printed in the given order; any calculation makes it a plain sum.

    >>> x = sp.Symbol("x")
    >>> print([str(term) for term in ordered_terms(in_order(3 * x, -x))], in_order(3 * x, -x).subs(x, 1))
    ['3*x', '-x'] 2
    """

    def __new__(cls, *terms: sp.Expr, evaluate: bool = True) -> sp.Add:
        return sp.Add(*terms) if evaluate else super().__new__(cls, *terms, evaluate=False)


def in_order(*terms: sp.Expr) -> InOrder:
    """Return a sum that keeps its terms and their order."""
    return InOrder(*terms, evaluate=False)


class Product(NamedTuple):
    """A term as a product: its number, and its other factors above and below the fraction bar, in order."""

    number: sp.Expr
    above: tuple[sp.Expr, ...]
    below: tuple[sp.Expr, ...]


@lru_cache(maxsize=8192)
def product(term: sp.Expr) -> Product:
    """Return a term as a product; the number contains the minus sign of a bracket of negative terms.

    >>> from ramanujan.derivation.model import R, m, m_prime
    >>> product(R**2 * (-m - m_prime) * m / 2)
    Product(number=-1/2, above=(m, m + m_prime, R**2), below=())
    """
    number = sp.S.One
    above: list[sp.Expr] = []
    below: list[sp.Expr] = []
    for factor in sp.Mul.make_args(term):
        if isinstance(factor, sp.Mul):
            inner = product(factor)
            number, above, below = number * inner.number, [*above, *inner.above], [*below, *inner.below]
            continue
        base, exponent = factor.as_base_exp()
        if factor.is_number and not (factor.is_Pow and base.is_Integer and exponent.is_Integer):
            number *= factor
        elif exponent.is_number and exponent.is_negative:
            below.append(base**-exponent)
        elif exponent.is_Integer and _is_negative_throughout(base):
            number *= (-1) ** exponent
            above.append(sp.Add(*(-part for part in base.args)) ** exponent)
        else:
            above.append(factor)
    return Product(number, tuple(sorted(above, key=_factor_key)), tuple(sorted(below, key=_factor_key)))


@lru_cache(maxsize=8192)
def ordered_terms(total: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the terms of a sum in the order of the table.

    >>> from ramanujan.derivation.model import X, k, phi, t
    >>> ordered_terms(4 * k * phi - 2 * X.diff(t, 2) + phi.diff(t, 2))
    (Derivative(varphi(t), (t, 2)), -2*Derivative(X(t), (t, 2)), 4*k*varphi(t))
    """
    if isinstance(total, InOrder) or not total.is_Add:
        return sp.Add.make_args(total)
    ordered = sorted(total.args, key=_term_key)
    if _is_linear_in_the_mass_ratio(total):
        # As a sum of masses, divided by m: 7m + 6m′ becomes 7 + 6ε.
        ordered.reverse()
    first = next((term for term in ordered if not is_negative(term)), ordered[0])
    return (first, *(term for term in ordered if term is not first))


def is_negative(term: sp.Expr) -> bool:
    """Return whether a term has a minus sign."""
    return bool(product(term).number.is_negative)


def is_motion(factor: sp.Expr) -> bool:
    """Return whether a factor comes after R: coordinates, velocities, forces and brackets with them."""
    return _factor_key(factor)[0] > _LETTER_RANK["R"]


def is_coefficient(factor: sp.Expr) -> bool:
    """Return whether a factor comes before R, such as k and the masses."""
    return _factor_key(factor)[0] < _LETTER_RANK["R"]


def _is_negative_throughout(base: sp.Expr) -> bool:
    return base.is_Add and not isinstance(base, InOrder) and all(map(is_negative, base.args))


def _is_linear_in_the_mass_ratio(total: sp.Add) -> bool:
    number, *others = sorted(total.args, key=lambda term: not term.is_number)
    names = {_name(each) for term in others for each in product(term).above + product(term).below}
    return number.is_Rational and len(others) == 1 and names == {("varepsilon", "")}


# Keys


def _term_key(term: sp.Expr) -> Key:
    """Return the sort key of a term: the variables, from the highest derivative; then the constants."""
    _number, above, below = product(term)
    factors = [factor.as_base_exp() for factor in above]
    powers = [(base, int(power) if power.is_Integer else 1) for base, power in factors]
    varying = [(base, power) for base, power in powers if _varies(base)]
    names = [_factor_key(base) for base, power in varying for _time in range(power)]
    constants = [_factor_key(base) for base, power in powers if not _varies(base) for _time in range(power)]
    return (
        -max((_times_differentiated(base) for base, _power in varying), default=-len(LETTERS)),
        any(base.is_Add for base, _power in varying),
        -len(names),
        len(set(names)) > 1,
        names,
        bool(below),
        constants,
        term.sort_key(),
    )


def _factor_key(factor: sp.Expr) -> Key:
    """Return the sort key of a factor; a bracket with a function of time comes after the constants."""
    base = factor.as_base_exp()[0]
    if base.is_Add:
        letters = {_name(symbol)[0] for symbol in _symbols(base)}
        is_of_masses = letters <= {*CONSTANTS, "varepsilon"}
        return (_LETTER_RANK[SUM] if is_of_masses else _LETTER_RANK["R"] + 0.5, "", 0, "", 0)
    letter, subscript = _name(base)
    rank = _SUBSCRIPT_RANK.get(subscript, len(SUBSCRIPTS))
    return _LETTER_RANK.get(letter, len(LETTERS)), letter, rank, subscript, -_times_differentiated(base)


@lru_cache(maxsize=4096)
def _times_differentiated(base: sp.Expr) -> int:
    """Return the order of a symbol as a time derivative; for a bracket, the highest order in it."""
    if base.is_Add:
        return max(map(_times_differentiated, _symbols(base)), default=0)
    times = sum(count for _variable, count in base.variable_count) if isinstance(base, sp.Derivative) else 0
    return times + DERIVATIVES.get(_name(base)[0], 0)


@lru_cache(maxsize=4096)
def _varies(base: sp.Expr) -> bool:
    return any(_name(symbol)[0] not in CONSTANTS for symbol in _symbols(base))


@lru_cache(maxsize=4096)
def _symbols(expression: sp.Basic) -> tuple[sp.Basic, ...]:
    """Return the symbols, the functions of time and their derivatives."""
    if isinstance(expression, sp.Symbol | AppliedUndef | sp.Derivative):
        return (expression,)
    return tuple(symbol for part in expression.args for symbol in _symbols(part))


@lru_cache(maxsize=4096)
def _name(base: sp.Expr) -> tuple[str, str]:
    """Return letter and subscript of a symbol, a function of time, or the argument of a derivative."""
    symbol = base.expr if isinstance(base, sp.Derivative) else base
    letter, _bar, subscript = str(symbol.func if isinstance(symbol, AppliedUndef) else symbol).partition("_")
    return letter, subscript
