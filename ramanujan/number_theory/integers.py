"""Integers and quadratics with integer coefficients: factors, discriminants, and sums of cubes.

All arguments and results are integers; this module does not depend on the machine.
"""

from __future__ import annotations

from functools import cache
from itertools import count
from math import prod

from sympy.ntheory import factorint

from ramanujan.number_theory.arguments import integer

LARGEST_NUMBER = 10**12
"""The largest number to factor or to write as a sum of cubes; each search takes less than half a second."""

LARGEST_COEFFICIENT = 10**30
"""The largest absolute value of a coefficient."""

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
    bound = LARGEST_COEFFICIENT
    a, b, c = (integer(name, value, -bound, bound) for name, value in (("a", a), ("b", b), ("c", c)))
    if a == 0:
        raise ValueError("a must not be 0 in a quadratic")
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


def _check_number(n: int) -> int:
    """Return n; raise ValueError unless it is an integer from 1 to LARGEST_NUMBER."""
    return integer("n", n, 1, LARGEST_NUMBER)
