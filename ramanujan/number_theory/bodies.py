"""The quadratic for the mass ratio of a machine with any rolling bodies, its discriminant, and the 40 machines.

This module derives the exact quadratic from a choice of rolling bodies; `integers` does the arithmetic.

A rolling body of mass M and radius R has the moment of inertia βMR², where β is its shape factor. With β_a, β_b for the
two lower rollers, β_c for the top body, s = β_a + β_b and γ = β_c/(1 + β_c), the machine of mass ratio ε = m′/m has

    Ω²m/k = [(2 + γ) + 2ε] / [(1 + γ) + ¼(2 + γ)(2 + s)ε + ½sε²].

For s > 0 it decreases from (2 + γ)/(1 + γ) at ε = 0 and approaches 0 for large ε. For each target w in between, ε is
the positive root of

    2ws ε² + [w(2 + γ)(2 + s) − 8] ε − 4[(2 + γ) − w(1 + γ)] = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement
from math import gcd, lcm
from types import MappingProxyType

from ramanujan.number_theory import integers
from ramanujan.number_theory.arguments import rational

BODIES = MappingProxyType(
    {"hoop": Fraction(1), "shell": Fraction(2, 3), "cylinder": Fraction(1, 2), "sphere": Fraction(2, 5)}
)
"""Rolling bodies and their shape factors β = I/(MR²), from the thin hoop to the solid sphere."""

LARGEST_PART = 10**6
"""The largest numerator and denominator of a shape factor or a target. Coefficients are then below 1e26."""

LARGEST_RATIO_PART = 10**1000
"""The largest numerator and denominator of a mass ratio. Those of a ratio of two floats are smaller."""

ShapeFactor = str | int | Fraction


def normalized_frequency_squared_exact(
    beta_a: ShapeFactor, beta_b: ShapeFactor, beta_c: ShapeFactor, ratio: int | Fraction
) -> Fraction:
    """Return Ω²m/k exactly, for any bodies and a rational mass ratio.

        Ω²m/k = [(2 + γ) + 2ε] / [(1 + γ) + ¼(2 + γ)(2 + s)ε + ½sε²]

    Parameters
    ----------
    beta_a, beta_b, beta_c : shape factors of the two lower rollers and the top body, from 0 to 1, or names in BODIES
    ratio : ε = m′/m ≥ 0, dimensionless

    Returns
    -------
    Ω²m/k as a fraction

    Raises
    ------
    ValueError : a shape factor is neither a name nor an exact number from 0 to 1, or the ratio is not exact and ≥ 0.

    Source: paper, section 2, with general shape factors; module docstring.

    >>> normalized_frequency_squared_exact("hoop", "cylinder", "cylinder", 1)
    Fraction(104, 99)
    """
    s, gamma = _inertia_coefficients(beta_a, beta_b, beta_c)
    epsilon = rational("ratio", ratio, LARGEST_RATIO_PART)
    if epsilon < 0:
        raise ValueError("ratio must not be negative")
    return (2 + gamma + 2 * epsilon) / (1 + gamma + (2 + gamma) * (2 + s) * epsilon / 4 + s * epsilon**2 / 2)


def unit_quadratic(
    beta_a: ShapeFactor, beta_b: ShapeFactor, beta_c: ShapeFactor, target: int | Fraction = 1
) -> integers.Quadratic:
    """Return coprime integers (a, b, c) such that aε² + bε + c = 0 is equivalent to Ω²m/k = w.

        2ws ε² + [w(2 + γ)(2 + s) − 8] ε − 4[(2 + γ) − w(1 + γ)] = 0

    Because a > 0 > c, exactly one of its roots is positive.

    Parameters
    ----------
    beta_a, beta_b, beta_c : shape factors of the two lower rollers and the top body, from 0 to 1, or names in BODIES
    target : w, dimensionless; by default 1, the unit frequency

    Returns
    -------
    the integers (a, b, c)

    Raises
    ------
    ValueError : a shape factor is neither a name nor an exact number from 0 to 1; both lower ones are 0 (the equation
        is then linear); or the target is not an exact number strictly between 0 and (2 + γ)/(1 + γ).

    Source: paper, section 2 (the unit frequency), with general shape factors; module docstring.

    >>> unit_quadratic("hoop", "cylinder", "cylinder")
    (18, 1, -24)
    """
    s, gamma = _inertia_coefficients(beta_a, beta_b, beta_c)
    if s == 0:
        raise ValueError("beta_a and beta_b must not both be 0: the equation for the mass ratio is then linear")
    w = rational("target", target, LARGEST_PART)
    limit = (2 + gamma) / (1 + gamma)
    if not 0 < w < limit:
        raise ValueError(f"target must lie strictly between 0 and {limit}, the limit for very light rollers")
    return _make_coprime(2 * w * s, w * (2 + gamma) * (2 + s) - 8, 4 * (w * (1 + gamma) - (2 + gamma)))


@dataclass(frozen=True)
class BodyChoice:
    """A choice of rolling bodies and a target for Ω²m/k, with its quadratic and discriminant.

    Parameters
    ----------
    left, right, top : the two lower rollers (in any order) and the top body, names in BODIES
    target : w = Ω²m/k, dimensionless. If numerator and denominator are at most 1000, the discriminant of a machine
        built from BODIES can be factored. Larger numbers are accepted, too.

    Raises
    ------
    ValueError : as in `unit_quadratic`. `cubes` also raises it if the discriminant exceeds 10¹².

    >>> BodyChoice().discriminant
    1729
    """

    left: str = "hoop"
    right: str = "cylinder"
    top: str = "cylinder"
    target: int | Fraction = Fraction(1)

    def __post_init__(self) -> None:
        for place in ("left", "right", "top"):
            _shape_factor(place, getattr(self, place))
        object.__setattr__(self, "target", rational("target", self.target, LARGEST_PART))
        # A machine without a quadratic raises an error at construction.
        self.quadratic  # noqa: B018

    @property
    def bodies(self) -> tuple[str, str, str]:
        """(left, right, top), in the order of the shape factors β_a, β_b, β_c."""
        return self.left, self.right, self.top

    @cached_property
    def quadratic(self) -> integers.Quadratic:
        """(a, b, c) of aε² + bε + c = 0, coprime integers with a > 0 > c."""
        return unit_quadratic(*self.bodies, self.target)

    @property
    def discriminant(self) -> int:
        """D = b² − 4ac > 0. It is [(8/w − (2 + γ)(2 − s))² + 8sγ²] r² with a rational r."""
        return integers.discriminant(*self.quadratic)

    @cached_property
    def factorization(self) -> tuple[tuple[int, int], ...]:
        """The prime factorization of D as pairs (prime, exponent)."""
        return integers.factorization(self.discriminant)

    @property
    def field_discriminant(self) -> int:
        """The discriminant of the number field ℚ(√D) in which the mass ratio lies."""
        return integers.field_discriminant(self.discriminant)

    @cached_property
    def cubes(self) -> tuple[tuple[int, int], ...]:
        """The ways to write D as a sum of two positive cubes."""
        return tuple(integers.sums_of_two_cubes(self.discriminant))


def machines() -> list[BodyChoice]:
    """Return all 40 machines: each unordered pair of lower rollers with each top body, in the order of BODIES.

    >>> sorted(machine.discriminant for machine in machines() if machine.cubes)
    [1064, 1729, 5896]
    """
    pairs = combinations_with_replacement(BODIES, 2)
    return [BodyChoice(left, right, top) for left, right in pairs for top in BODIES]


def _inertia_coefficients(beta_a: ShapeFactor, beta_b: ShapeFactor, beta_c: ShapeFactor) -> tuple[Fraction, Fraction]:
    """Return s = β_a + β_b and γ = β_c/(1 + β_c)."""
    a = _shape_factor("beta_a", beta_a)
    b = _shape_factor("beta_b", beta_b)
    c = _shape_factor("beta_c", beta_c)
    return a + b, c / (1 + c)


def _shape_factor(argument: str, body: ShapeFactor) -> Fraction:
    """Return the β of a body in BODIES, or a number from 0 to 1 as it is.

    Errors begin with the name of the argument.
    """
    if isinstance(body, str):
        if body not in BODIES:
            raise ValueError(f"{argument} must be one of {', '.join(BODIES)}, not {body!r}")
        return BODIES[body]
    beta = rational(argument, body, LARGEST_PART)
    if not 0 <= beta <= 1:
        raise ValueError(f"{argument} must lie between 0 and 1")
    return beta


def _make_coprime(*coefficients: Fraction) -> integers.Quadratic:
    """Return coprime integers with the same ratios as the coefficients."""
    denominator = lcm(*(x.denominator for x in coefficients))
    a, b, c = (int(x * denominator) for x in coefficients)
    divisor = gcd(a, b, c)
    return a // divisor, b // divisor, c // divisor
