"""Polynomials with integer coefficients in m, m′, k, R and the motion: common factors, and what leaves a root."""

from __future__ import annotations

from functools import cache
from math import isqrt, prod
from operator import itemgetter, sub

import sympy as sp
from sympy.polys.heuristicgcd import heugcd
from sympy.polys.polyerrors import HeuristicGCDFailed
from sympy.polys.rings import PolyElement, PolyRing, ring

from ramanujan.derivation.expressions import NAMES

MAX_GCD_BITS = 8_000
"""A common factor is looked for only where the integers that the search meets stay shorter than this."""

_SMALL_PRIMES = tuple(sp.primerange(2, 1000))

VARIABLES = NAMES[:-1]
"""The names that a normal form may contain; ε is m′/m."""

_POSITIVE = ("m", "m'", "k", "R")

RING, *GENERATORS = ring([f"x{i}" for i in range(len(VARIABLES))], sp.ZZ)

GENERATOR = dict(zip(VARIABLES, GENERATORS, strict=True))

_SIGNED = tuple(i for i, name in enumerate(VARIABLES) if name not in _POSITIVE)

Monomial = tuple[int, ...]


def greatest_common_factor(left: PolyElement, right: PolyElement) -> PolyElement | None:
    """Return the greatest common factor with a positive leading coefficient, None if the search fails.

    The search replaces one variable after another by an integer, so that those that do not occur are left out.
    """
    used = [i for i, column in enumerate(zip(*left, *right, strict=True)) if any(column)]
    small = _ring_of(len(used))
    chosen = itemgetter(*used) if len(used) > 1 else lambda powers: (powers[used[0]],)
    try:
        factor = heugcd(*(small({chosen(powers): c for powers, c in p.items()}) for p in (left, right)))[0]
    except HeuristicGCDFailed:
        return None
    sign = -1 if factor.LC < 0 else 1
    found = {}
    for powers, c in factor.items():
        all_powers = [0] * len(VARIABLES)
        for i, power in zip(used, powers, strict=True):
            all_powers[i] = power
        found[tuple(all_powers)] = sign * c
    return RING(found)


@cache
def _ring_of(size: int) -> PolyRing:
    return ring([f"x{i}" for i in range(size)], sp.ZZ)[0]


def divided(polynomial: PolyElement, factor: PolyElement) -> PolyElement:
    """Return a quotient that is exact, as a new polynomial: one that SymPy divided may keep an old hash."""
    if factor == 1:
        return RING(dict(polynomial))
    if len(factor) > 1:
        return RING(dict(polynomial.exquo(factor)))
    ((powers, number),) = factor.items()
    return RING({tuple(map(sub, monomial, powers)): c // number for monomial, c in polynomial.items()})


def is_positive(polynomial: PolyElement) -> bool:
    """Tell whether a polynomial is evidently positive: sums of products of masses and squares."""
    return all(c > 0 and not any(monomial[i] % 2 for i in _SIGNED) for monomial, c in polynomial.items())


def root_of_integer(number: int) -> tuple[set[int], int]:
    """Return the factors of a positive integer that stay under its root, and what comes out of it."""
    inside, outside = set(), 1
    for prime in _SMALL_PRIMES:
        exponent = 0
        while number % prime == 0:
            number, exponent = number // prime, exponent + 1
        outside *= prime ** (exponent // 2)
        if exponent % 2:
            inside.add(prime)
    if (root := isqrt(number)) ** 2 == number:
        return inside, outside * root
    return inside | {number}, outside


def bits(polynomial: PolyElement) -> int:
    return max((abs(int(c)).bit_length() for c in polynomial.values()), default=0)


def gcd_bits(left: PolyElement, right: PolyElement) -> int:
    """Return about how long the integers become with which `heugcd` replaces one variable after another."""
    degrees = [max(column) for column in zip(*left, *right, strict=True)]
    return (6 + min(bits(left), bits(right))) * prod(degree + 1 for degree in degrees)
