"""Altered machines, and what is left of their equations of motion when two coordinates are eliminated.

One body, or a group of them, has another mass, inertia, velocity or angle than it has. Each machine comes with a hint,
one sentence and the question that leads on; what students do often comes first. Machines and altered procedures go
through one elimination, exactly, for any mass ratio.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.derivation import symbols
from ramanujan.derivation.symbols import COORDINATES, Body, Machine, Phi, R, X, epsilon, k, m, m_prime, machine, phi
from ramanujan.translation import _

CALLED = {
    "block": _("the block"),
    "hoop": _("the hoop"),
    "cylinder": _("the lower cylinder"),
    "slab": _("the slab"),
    "top": _("the top cylinder"),
}
"""The name of each body in a sentence."""

_LOWER, _ROLLERS, _RIDERS = "hoop cylinder", "hoop cylinder top", "hoop cylinder slab top"
_GROUPS = CALLED | {
    _LOWER: _("the lower rollers"),
    _ROLLERS: _("all rollers"),
    _RIDERS: _("everything on the block"),
}
_SHAPES = {
    symbols.HOOP: _("a hoop"),
    symbols.SOLID_CYLINDER: _("a solid cylinder"),
    sp.Rational(2, 3): _("a spherical shell"),
    sp.Rational(2, 5): _("a solid sphere"),
}

right = cache(machine)
"""The machine as it is."""

_Change = Callable[[Body], dict[str, Any]]
"""Body → what is different of it."""


def _other_mass(body: Body) -> dict[str, Any]:
    return {"mass": m if body.mass == m_prime else m_prime}


def _other_angle(body: Body) -> dict[str, Any]:
    swapped = {phi: Phi, Phi: phi}
    return {"displacement": body.displacement.xreplace(swapped), "angle": body.angle.xreplace(swapped)}


_MISTAKES: dict[str, tuple[tuple[str, ...], *tuple[_Change, ...]]] = {
    _(
        "You get this result if you leave out the rotation of {body}. Which energy does a body have because it rotates?"
    ): ((*_ROLLERS.split(), _LOWER, _ROLLERS), lambda body: {"shape_factor": sp.S.Zero}),
    _(
        "You get this result if you divide the velocity of {body} relative to the ground by R to find the angular "
        "velocity. On which surface does a roller roll?"
    ): ((*_ROLLERS.split(), _LOWER, _ROLLERS), lambda body: {"angle": sp.expand(body.displacement / R)}),
    _("You get this result if {body} has the mass {mass}. Which mass does it have?"): (tuple(CALLED), _other_mass),
    _("You get this result if {body} have the mass {mass}. Which mass do they have?"): ((_LOWER,), _other_mass),
    _(
        "You get this result if you add X′ to the velocity of {body} instead of subtracting it. In which direction "
        "does the block move when X grows?"
    ): ((*_RIDERS.split(), _LOWER), lambda body: {"displacement": body.displacement.subs(X, -X)}),
    _(
        "You get this result if you take the velocity of {body} relative to the block. How does the block itself move?"
    ): ((*_RIDERS.split(), _LOWER, _RIDERS), lambda body: {"displacement": body.displacement.subs(X, 0)}),
    _(
        "You get this result if {body} moves only as far as the centres of its rollers. How fast does the top of a "
        "rolling body move?"
    ): (("slab",), lambda _body: {"displacement": right()["hoop"].displacement}),
    _(
        "You get this result if you give {body} the displacement of the slab. How far does the centre of a roller move "
        "when its top moves by 2Rφ?"
    ): ((*_LOWER.split(), _LOWER), lambda _body: {"displacement": right()["slab"].displacement}),
    _("You get this result if you use the angle {angle} for {body}. Which angle describes the motion of {body}?"): (
        tuple(_RIDERS.split()),
        _other_angle,
    ),
    _("You get this result if {body} has the moment of inertia of {shape}. What is the moment of inertia of {body}?"): (
        tuple(_ROLLERS.split()),
        *(lambda _body, shape=shape: {"shape_factor": shape} for shape in _SHAPES),
    ),
    _("You get this result if you leave out {body}. Which bodies have kinetic energy?"): (
        tuple(CALLED),
        lambda _body: {"mass": sp.S.Zero},
    ),
}
"""Hint → the bodies, or groups of them, that a mistake alters, and how; the more common mistakes come first."""


@cache
def altered() -> dict[str, Machine]:
    """Return hint → the machine for which that mistake would be right."""
    found = {}
    for hint, (groups, *changes) in _MISTAKES.items():
        for change in changes:
            for group in groups:
                names = group.split()
                bodies = [replace(each, **change(each)) if each.name in names else each for each in right().bodies]
                if (mistaken := Machine(tuple(bodies))) != right():
                    said = hint.format(body=_GROUPS[group], **_words(mistaken[names[-1]]))
                    found[said] = mistaken
    return found


def _words(body: Body) -> dict[str, str]:
    """Return what a hint may say of an altered body."""
    return {
        "mass": "m" if body.mass == m else "m′",
        "angle": "φ" if body.displacement.has(phi) else "Φ",
        "shape": _SHAPES.get(body.shape_factor, ""),
    }


# The elimination


_RATIOS = field(epsilon, sp.ZZ)[0]
_UNITS = {m: sp.S.One, k: sp.S.One, R: sp.S.One, m_prime: epsilon}
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
        return _RATIOS.from_expr(sp.sympify(expression).xreplace(_UNITS))

    matrix = [list(map(worth, row)) for row in mass_matrix(bodies)]
    return matrix, worth(k * _rates_of(bodies.deformation)[1] ** 2)


def _solved(name: str, matrix: list[list[FracElement]], stiffness: FracElement) -> FracElement | None:
    """Return the answer to a question from the three equations of motion, None if it divides by zero.

    The X and Φ equations, rows 0 and 2, give Ẍ and Φ̈, which go into the φ equation. The question about the φ equation
    writes its last term as 4kRφ.
    """
    (a, b, c), (d, e, f), (g, h, i) = matrix
    # Without a top cylinder the Φ equation is empty: Φ̈ may be anything, also 0.
    i = i or i + 1
    determinant, block, top = a * i - c * g, c * h - b * i, b * g - a * h
    above, below = {
        "block_coupling": (block, determinant),
        "top_coupling": (top, determinant),
        "phi_equation": (4 * e, stiffness),
        "natural_frequency_squared": (stiffness * determinant, e * determinant + d * block + f * top),
    }[name]
    return above / below if below else None


PROCEDURES = {
    _(
        "You get this result if you leave the acceleration of Φ out of the X equation. What does the Φ equation say "
        "about it?"
    ): (0, 2, 0),
    _(
        "You get this result if you leave out the acceleration of X, as if the block stood still. What does the X "
        "equation say about it?"
    ): (1, 0, 0),
    _(
        "You get this result if you insert the acceleration of Φ with the wrong sign. What does the Φ equation say "
        "about its sign?"
    ): (2, 0, -1),
    _(
        "You get this result if you insert the acceleration of X with the wrong sign. What does the X equation say "
        "about its sign?"
    ): (1, 0, -1),
}
"""Hints at slips in the elimination: which entry of the three equations is multiplied by 0 or −1."""


@cache
def eliminated(name: str) -> dict[str, FracElement | None]:
    """Return hint → what altered procedures and then altered machines give, in units of m, k and R."""
    matrix, stiffness = _equations(right())
    found = {}
    for hint, (row, column, factor) in PROCEDURES.items():
        slipped = [list(each) for each in matrix]
        slipped[row][column] *= factor
        found[hint] = _solved(name, slipped, stiffness)
    return found | {hint: _solved(name, *_equations(bodies)) for hint, bodies in altered().items()}


def conditions() -> dict[str, tuple[int, int, int]]:
    """Return hint → a, b, c of the quadratic aε² + bε + c for Ω² = k/m of altered procedures and machines."""
    found = {}
    for hint, squared in eliminated("natural_frequency_squared").items():
        if squared and squared.denom.degree() <= 2:
            condition = (squared.denom - squared.numer).as_expr()
            found[hint] = tuple(int(condition.coeff(epsilon, n)) for n in (2, 1, 0))
    return found
