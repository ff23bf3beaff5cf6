"""The elimination of two coordinates by altered procedures and for altered machines, in any kind of exact number."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from itertools import chain
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers import machines
from ramanujan.answers.values import evaluate, square_root
from ramanujan.derivation.symbols import COORDINATES, Machine, R, k, m, m_prime
from ramanujan.translation import _

Row = list[Any]


@cache
def mass_matrix(bodies: Machine) -> tuple[tuple[sp.Expr, ...], ...]:
    """Return the mass matrix of a machine, in the order X, φ, Φ."""
    moving = [(body.mass, _rates_of(body.displacement)) for body in bodies.bodies]
    turning = [(body.moment_of_inertia, _rates_of(body.angle)) for body in bodies.bodies]
    places = range(len(COORDINATES))
    return tuple(tuple(sp.Add(*(mass * v[i] * v[j] for mass, v in moving + turning)) for j in places) for i in places)


def equations(
    bodies: Machine, values: Mapping[sp.Expr, Any], number: Callable[[Any], Any]
) -> tuple[list[Row], Any, Any]:
    """Return the mass matrix of a machine, its stiffness ∂²U/∂φ², and the question's 4kR.

    Parameters
    ----------
    bodies : a machine
    values : symbol → its value, in any kind of number
    number : how to make such a number of a fraction
    """

    def worth(expression: sp.Expr) -> Any:
        return evaluate(expression, values, square_root, number)

    matrix = [list(map(worth, row)) for row in mass_matrix(bodies)]
    return matrix, worth(k * _rates_of(bodies.deformation)[1] ** 2), worth(4 * k * R)


@cache
def _rates_of(path: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(sp.diff(path, q) for q in COORDINATES)


def solved(name: str, matrix: list[Row], stiffness: Any, last_factor: Any) -> Any:
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
        "phi_equation": (e * last_factor, stiffness),
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


def through(name: str, system: Callable[[Machine], tuple[list[Row], Any, Any]]) -> Iterator[tuple[str, Any]]:
    """Yield what altered procedures give, then what altered machines give; `system` returns a machine's equations."""
    for hint, (row, column), factor in PROCEDURES:
        matrix, *rest = system(machines.right())
        altered = [
            [x * factor if (i, j) == (row, column) else x for j, x in enumerate(r)] for i, r in enumerate(matrix)
        ]
        yield hint, solved(name, altered, *rest)
    for mistake in chain(machines.common(), machines.exotic()):
        yield mistake.hint, solved(name, *system(mistake.bodies))


_EPSILON, _e = field("e", sp.ZZ)


def conditions() -> Iterator[tuple[str, tuple[int, int, int]]]:
    """Yield the quadratics aε² + bε + c for Ω² = k/m of altered procedures and machines, as a, b and c."""
    one = _EPSILON.one
    units = {m: one, k: one, R: one, m_prime: _e}
    for hint, squared in through("natural_frequency_squared", lambda bodies: equations(bodies, units, _number)):
        if squared and squared.denom.degree() <= 2:
            condition = (squared.denom - squared.numer).as_expr()
            yield hint, tuple(int(condition.coeff("e", n)) for n in (2, 1, 0))


def _number(value: Any) -> FracElement:
    return _EPSILON(value.numerator) / value.denominator
