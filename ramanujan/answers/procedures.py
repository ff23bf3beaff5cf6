"""The elimination of two coordinates by altered procedures and for altered machines, exactly, for any mass ratio."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers import machines
from ramanujan.answers.values import evaluate, square_root
from ramanujan.derivation.symbols import COORDINATES, Machine, R, epsilon, k, m, m_prime
from ramanujan.translation import _

_RATIOS, _epsilon = field(epsilon, sp.ZZ)
_UNITS = {m: _RATIOS.one, k: _RATIOS.one, R: _RATIOS.one, m_prime: _epsilon}
"""An answer has a unit, and in that unit it is a quotient of polynomials in the mass ratio."""


@cache
def mass_matrix(bodies: Machine) -> tuple[tuple[sp.Expr, ...], ...]:
    """Return the mass matrix of a machine, in the order X, φ, Φ."""
    moving = [(body.mass, _rates_of(body.displacement)) for body in bodies.bodies]
    turning = [(body.moment_of_inertia, _rates_of(body.angle)) for body in bodies.bodies]
    places = range(len(COORDINATES))
    return tuple(tuple(sp.Add(*(mass * v[i] * v[j] for mass, v in moving + turning)) for j in places) for i in places)


@cache
def _rates_of(path: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(sp.diff(path, q) for q in COORDINATES)


def _equations(bodies: Machine) -> tuple[list[list[FracElement]], FracElement]:
    """Return the mass matrix of a machine and its stiffness ∂²U/∂φ², in units of m, k and R."""

    def worth(expression: sp.Expr) -> FracElement:
        return evaluate(expression, _UNITS, square_root, lambda number: _RATIOS(number.numerator) / number.denominator)

    matrix = [list(map(worth, row)) for row in mass_matrix(bodies)]
    return matrix, worth(k * _rates_of(bodies.deformation)[1] ** 2)


def _solved(name: str, matrix: list[list[FracElement]], stiffness: FracElement) -> FracElement | None:
    """Return the answer to a question from the three equations of motion, None if it divides by zero.

    The X and Φ equations, rows 0 and 2, give Ẍ and Φ̈, which go into the φ equation. The question about the φ equation
    writes its last term as 4kRφ.
    """
    (a, b, c), (d, e, f), (g, h, i) = matrix
    if i:
        determinant, block, top = a * i - c * g, c * h - b * i, b * g - a * h
    else:
        # Without a top cylinder the Φ equation is empty.
        determinant, block, top = a, -b, 0 * a
    above, below = {
        "block_coupling": (block, determinant),
        "top_coupling": (top, determinant),
        "phi_equation": (4 * e, stiffness),
        "natural_frequency_squared": (stiffness * determinant, e * determinant + d * block + f * top),
    }[name]
    return above / below if below else None


PROCEDURES = (
    (
        _(
            "You get this result if you leave the acceleration of Φ out of the X equation. What does the Φ equation "
            "say about it?"
        ),
        (0, 2),
        0,
    ),
    (
        _(
            "You get this result if you leave out the acceleration of X, as if the block stood still. What does the X "
            "equation say about it?"
        ),
        (1, 0),
        0,
    ),
    (
        _(
            "You get this result if you insert the acceleration of Φ with the wrong sign. What does the Φ equation say "
            "about its sign?"
        ),
        (2, 0),
        -1,
    ),
    (
        _(
            "You get this result if you insert the acceleration of X with the wrong sign. What does the X equation say "
            "about its sign?"
        ),
        (1, 0),
        -1,
    ),
)
"""Hints at slips in the elimination: which entry of the three equations is multiplied by 0 or −1."""


@cache
def eliminated(name: str) -> tuple[tuple[str, FracElement | None], ...]:
    """Return hints, and what altered procedures and then altered machines give, in units of m, k and R."""
    matrix, stiffness = _equations(machines.right())
    found = []
    for hint, (row, column), factor in PROCEDURES:
        altered = [list(each) for each in matrix]
        altered[row][column] *= factor
        found.append((hint, _solved(name, altered, stiffness)))
    everyone = (*machines.common(), *machines.exotic())
    return (*found, *((mistake.hint, _solved(name, *_equations(mistake.bodies))) for mistake in everyone))


def conditions() -> Iterator[tuple[str, tuple[int, int, int]]]:
    """Yield the quadratics aε² + bε + c for Ω² = k/m of altered procedures and machines, as a, b and c."""
    for hint, squared in eliminated("natural_frequency_squared"):
        if squared and squared.denom.degree() <= 2:
            condition = (squared.denom - squared.numer).as_expr()
            yield hint, tuple(int(condition.coeff(epsilon, n)) for n in (2, 1, 0))
