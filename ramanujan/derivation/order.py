"""The order of a formula as in a textbook: a table for the factors of a product and the terms of a sum.

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

SUM = "a bracket of constants, such as a sum of masses"

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
_NO_VARIABLE = -2
"""A derivative order below all others. Terms of high order come first, so terms without a variable come last."""

Key = tuple[Any, ...]
_LETTER_RANK = {letter: rank for rank, letter in enumerate(LETTERS)}
_SUBSCRIPT_RANK = {subscript: rank for rank, subscript in enumerate(SUBSCRIPTS)}


class InOrder(sp.Add):
    """A sum that keeps the order of its terms and does not collect like terms. Any calculation makes it a plain sum.

    >>> x = sp.Symbol("x")
    >>> print([str(term) for term in order_terms(in_order(3 * x, -x))], in_order(3 * x, -x).subs(x, 1))
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
def to_product(term: sp.Expr) -> Product:
    """Return a term as a product; the number contains the minus sign of a bracket of negative terms.

    >>> from ramanujan.derivation.model import R, m, m_prime
    >>> to_product(R**2 * (-m - m_prime) * m / 2)
    Product(number=-1/2, above=(m, m + m_prime, R**2), below=())
    """
    number = sp.S.One
    above: list[sp.Expr] = []
    below: list[sp.Expr] = []
    for factor in sp.Mul.make_args(term):
        if isinstance(factor, sp.Mul):
            inner = to_product(factor)
            number *= inner.number
            above += inner.above
            below += inner.below
            continue
        base, exponent = factor.as_base_exp()
        # An unevaluated power of an integer, such as 12³, remains a factor.
        is_unevaluated_power = factor.is_Pow and base.is_Integer and exponent.is_Integer
        if factor.is_number and not is_unevaluated_power:
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
def order_terms(total: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the terms of a sum in the order of the table.

    >>> from ramanujan.derivation.model import X, k, phi, t
    >>> order_terms(4 * k * phi - 2 * X.diff(t, 2) + phi.diff(t, 2))
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
    return bool(to_product(term).number.is_negative)


def is_motion(factor: sp.Expr) -> bool:
    """Return whether a factor comes after R: coordinates, velocities, forces and brackets with them."""
    return _factor_key(factor)[0] > _LETTER_RANK["R"]


def is_coefficient(factor: sp.Expr) -> bool:
    """Return whether a factor comes before R, such as k and the masses."""
    return _factor_key(factor)[0] < _LETTER_RANK["R"]


def _is_negative_throughout(base: sp.Expr) -> bool:
    return base.is_Add and not isinstance(base, InOrder) and all(map(is_negative, base.args))


def _is_linear_in_the_mass_ratio(total: sp.Add) -> bool:
    """Return whether a sum is a + bε with rational a and b."""
    if len(total.args) != 2:
        return False
    number, multiple = sorted(total.args, key=lambda term: not term.is_number)
    _coefficient, above, below = to_product(multiple)
    return number.is_Rational and {_name(factor) for factor in above + below} == {("varepsilon", "")}


# Keys


def _term_key(term: sp.Expr) -> Key:
    """Return the sort key of a term: the variables, from the highest derivative; then the constants."""
    _number, above, below = to_product(term)
    # The bases of the factors, each as often as its power: X²R gives X, X, R.
    variables: list[sp.Expr] = []
    constants: list[sp.Expr] = []
    for factor in above:
        base, power = factor.as_base_exp()
        times = int(power) if power.is_Integer else 1
        (variables if _is_variable(base) else constants).extend([base] * times)
    variable_keys = [_factor_key(base) for base in variables]
    highest_derivative = max(map(_derivative_order, variables), default=_NO_VARIABLE)
    has_bracket = any(base.is_Add for base in variables)
    is_mixed_product = len(set(variable_keys)) > 1
    return (
        -highest_derivative,
        has_bracket,
        -len(variables),
        is_mixed_product,
        variable_keys,
        bool(below),
        [_factor_key(base) for base in constants],
        term.sort_key(),
    )


def _factor_key(factor: sp.Expr) -> Key:
    """Return the sort key of a factor. A bracket with anything but constants and ε comes after R."""
    base = factor.as_base_exp()[0]
    if base.is_Add:
        letters = {_name(symbol)[0] for symbol in _symbols(base)}
        is_constant = letters <= {*CONSTANTS, "varepsilon"}
        rank_of_bracket = _LETTER_RANK[SUM] if is_constant else _LETTER_RANK["R"] + 0.5
        return (rank_of_bracket, "", 0, "", 0)
    letter, subscript = _name(base)
    letter_rank = _LETTER_RANK.get(letter, len(LETTERS))
    subscript_rank = _SUBSCRIPT_RANK.get(subscript, len(SUBSCRIPTS))
    return letter_rank, letter, subscript_rank, subscript, -_derivative_order(base)


@lru_cache(maxsize=4096)
def _derivative_order(base: sp.Expr) -> int:
    """Return the order of a symbol as a time derivative; for a bracket, the highest order in it."""
    if base.is_Add:
        return max(map(_derivative_order, _symbols(base)), default=0)
    letter, _subscript = _name(base)
    order = base.derivative_count if isinstance(base, sp.Derivative) else 0
    return order + DERIVATIVES.get(letter, 0)


@lru_cache(maxsize=4096)
def _is_variable(base: sp.Expr) -> bool:
    """Return whether a factor is more than a constant: it contains motion, a frequency or the mass ratio."""
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
    name = symbol.func if isinstance(symbol, AppliedUndef) else symbol
    letter, _bar, subscript = str(name).partition("_")
    return letter, subscript
