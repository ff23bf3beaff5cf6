"""Integers and quadratics with integer coefficients: factors, sums of cubes, and the exact digits of a root.

All arguments and results are integers, `Fraction`s or decimal text; this module does not depend on the machine.

A quadratic aε² + bε + c with a > 0 > c has exactly one positive root, ε = (√D − b)/(2a) with D = b² − 4ac. Its digits
and its continued fraction follow from the integer square root of D.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from itertools import count
from math import isqrt, prod

from sympy.ntheory import factorint

from ramanujan.number_theory.arguments import integer

LARGEST_NUMBER = 10**12
"""The largest number to factor or to write as a sum of cubes or squares; each search takes less than half a second."""

LARGEST_COEFFICIENT = 10**30
"""The largest absolute value of a coefficient."""

MOST_DIGITS = 1000
"""The largest number of decimal digits of a root."""

MOST_TERMS = 100
"""The largest number of terms of a continued fraction."""

_LARGEST_QUOTIENT = 10**31
"""An upper bound of the partial quotients. None exceeds √D, and the coefficients are at most LARGEST_COEFFICIENT."""

_CUBE_ROOTS = {root**3: root for root in range(1, 10**4 + 1)}
"""Cube → its root, for all cubes up to LARGEST_NUMBER."""

Quadratic = tuple[int, int, int]


def discriminant(a: int, b: int, c: int) -> int:
    """Return D = b² − 4ac of the quadratic aε² + bε + c.

    Parameters
    ----------
    a, b, c : integers of up to 30 digits, a ≠ 0, for example the result of `unit_quadratic`

    Returns
    -------
    D, an integer

    Raises
    ------
    ValueError : a coefficient is invalid. The message begins with its name.

    >>> discriminant(18, 1, -24)
    1729
    """
    a, b, c = _check_coefficients(a, b, c)
    return b * b - 4 * a * c


def factorization(n: int) -> tuple[tuple[int, int], ...]:
    """Return the prime factorization of n as pairs (prime, exponent), in ascending order.

    Parameters
    ----------
    n : an integer from 1 to LARGEST_NUMBER

    Returns
    -------
    the pairs; none for n = 1

    Raises
    ------
    ValueError : n is not an integer in this range.

    >>> factorization(1729)
    ((7, 1), (13, 1), (19, 1))
    """
    return tuple(sorted(factorint(_check_number(n)).items()))


def squarefree_part(n: int) -> int:
    """Return d, where n = d·r² with the largest square r².

    Parameters
    ----------
    n : an integer from 1 to LARGEST_NUMBER

    Returns
    -------
    d, an integer without a square factor

    Raises
    ------
    ValueError : n is not an integer in this range.

    >>> squarefree_part(72)
    2
    """
    return prod(prime for prime, exponent in factorization(n) if exponent % 2)


def field_discriminant(n: int) -> int:
    """Return the discriminant of the number field ℚ(√n), which does not change if √n is multiplied by a rational.

    With d the squarefree part of n, it is d if d ≡ 1 (mod 4), else 4d. It is 1 if n is a square: the field is then ℚ.

    Parameters
    ----------
    n : an integer from 1 to LARGEST_NUMBER, such as the discriminant of a quadratic

    Returns
    -------
    the discriminant, an integer

    Raises
    ------
    ValueError : n is not an integer in this range.

    Source: D. A. Marcus, Number Fields, chapter 2.

    >>> field_discriminant(4 * 1729)
    1729
    """
    d = squarefree_part(n)
    return d if d % 4 == 1 else 4 * d


def sums_of_two_cubes(n: int) -> list[tuple[int, int]]:
    """Return all pairs of positive integers (x, y), x ≤ y, with x³ + y³ = n.

    Parameters
    ----------
    n : an integer from 1 to LARGEST_NUMBER

    Returns
    -------
    the pairs, sorted

    Raises
    ------
    ValueError : n is not an integer in this range.

    >>> sums_of_two_cubes(1729)
    [(1, 12), (9, 10)]
    """
    n = _check_number(n)
    pairs = []
    for cube, x in _CUBE_ROOTS.items():
        if 2 * cube > n:
            break
        y = _CUBE_ROOTS.get(n - cube)
        if y:
            pairs.append((x, y))
    return pairs


@cache
def smallest_taxicab() -> int:
    """Return the smallest number that is a sum of two positive cubes in two ways, found by trying 1, 2, 3, …

    >>> smallest_taxicab()
    1729
    """
    return next(n for n in count(1) if len(sums_of_two_cubes(n)) == 2)


def represent_x2_plus_3y2(n: int) -> list[tuple[int, int]]:
    """Return all pairs of integers x, y ≥ 0 with x² + 3y² = n.

    x² + 3y² is the norm of x + y√−3 in ℤ[√−3].

    Parameters
    ----------
    n : an integer from 1 to LARGEST_NUMBER

    Returns
    -------
    the pairs, sorted

    Raises
    ------
    ValueError : n is not an integer in this range.

    >>> (41, 4) in represent_x2_plus_3y2(1729)
    True
    """
    n = _check_number(n)
    candidates = ((isqrt(n - 3 * y * y), y) for y in range(isqrt(n // 3) + 1))
    return sorted((x, y) for x, y in candidates if x * x + 3 * y * y == n)


def positive_root_digits(a: int, b: int, c: int, digits: int) -> str:
    """Return the positive root of aε² + bε + c = 0 as decimal text, cut off (not rounded) after the digits.

        ⌊10ⁿε⌋ = ⌊(⌊√(10²ⁿD)⌋ − 10ⁿb) / (2a)⌋,   D = b² − 4ac

    Parameters
    ----------
    a, b, c : integers with a > 0 > c, so that exactly one root is positive
    digits : n, the number of digits after the decimal point, from 1 to 1000

    Returns
    -------
    the digits, with a decimal point

    Raises
    ------
    ValueError : a coefficient or the number of digits is invalid.

    Source: integer square root; ⌊⌊x⌋/d⌋ = ⌊x/d⌋ for a positive integer d, here 2a.

    >>> positive_root_digits(18, 1, -24, 10)
    '1.1272568270'
    """
    a, b, c = _check_positive_root(a, b, c)
    digits = integer("digits", digits, 1, MOST_DIGITS)
    scale = 10**digits
    scaled_root = (isqrt(discriminant(a, b, c) * scale**2) - b * scale) // (2 * a)
    whole, decimals = divmod(scaled_root, scale)
    return f"{whole}.{decimals:0{digits}d}"


def continued_fraction(a: int, b: int, c: int, terms: int) -> list[int]:
    """Return the first partial quotients of the positive root of aε² + bε + c = 0; a rational root may have fewer.

    Each complete quotient is (P + √D)/Q with integers P and Q, where Q divides D − P². The quotient is positive and its
    conjugate (P − √D)/Q negative. Their difference 2√D/Q is positive, so Q > 0. The integer part of the quotient is
    therefore ⌊(P + ⌊√D⌋)/Q⌋.

    Parameters
    ----------
    a, b, c : integers with a > 0 > c, so that exactly one root is positive
    terms : the number of partial quotients, from 1 to 100

    Returns
    -------
    the partial quotients

    Raises
    ------
    ValueError : a coefficient or the number of terms is invalid.

    Source: H. Davenport, The Higher Arithmetic, chapter IV.

    >>> continued_fraction(18, 1, -24, 5)
    [1, 7, 1, 6, 20]
    """
    a, b, c = _check_positive_root(a, b, c)
    terms = integer("terms", terms, 1, MOST_TERMS)
    radicand = discriminant(a, b, c)
    root = isqrt(radicand)
    P, Q = -b, 2 * a
    quotients: list[int] = []
    while Q and len(quotients) < terms:
        quotient = (P + root) // Q
        quotients.append(quotient)
        P = quotient * Q - P
        Q = (radicand - P * P) // Q
    return quotients


def convergents(quotients: Sequence[int]) -> list[Fraction]:
    """Return the convergents of a continued fraction, one for each partial quotient.

    Parameters
    ----------
    quotients : at most 100 positive integers; the first may be 0

    Returns
    -------
    the fractions in lowest terms

    Raises
    ------
    ValueError : the list is too long, or a quotient is invalid.

    Source: H. Davenport, The Higher Arithmetic, chapter IV.

    >>> convergents([1, 7, 1])
    [Fraction(1, 1), Fraction(8, 7), Fraction(9, 8)]
    """
    if len(quotients) > MOST_TERMS:
        raise ValueError(f"quotients must be a list of at most {MOST_TERMS} integers")
    fractions: list[Fraction] = []
    p_before, q_before = 0, 1
    p, q = 1, 0
    for position, value in enumerate(quotients):
        smallest = 0 if position == 0 else 1
        quotient = integer("quotients", value, smallest, _LARGEST_QUOTIENT)
        p, p_before = quotient * p + p_before, p
        q, q_before = quotient * q + q_before, q
        fractions.append(Fraction(p, q))
    return fractions


def _check_positive_root(a: int, b: int, c: int) -> Quadratic:
    """Return the coefficients; raise ValueError unless a > 0 > c."""
    a, b, c = _check_coefficients(a, b, c)
    if not a > 0 > c:
        raise ValueError("a must be positive and c negative, so that exactly one root is positive")
    return a, b, c


def _check_coefficients(a: int, b: int, c: int) -> Quadratic:
    """Return a, b, c; raise ValueError unless they are integers up to ±LARGEST_COEFFICIENT, and a ≠ 0."""
    bound = LARGEST_COEFFICIENT
    a = integer("a", a, -bound, bound)
    b = integer("b", b, -bound, bound)
    c = integer("c", c, -bound, bound)
    if a == 0:
        raise ValueError("a must not be 0 in a quadratic")
    return a, b, c


def _check_number(n: int) -> int:
    """Return n; raise ValueError unless it is an integer from 1 to LARGEST_NUMBER."""
    return integer("n", n, 1, LARGEST_NUMBER)
