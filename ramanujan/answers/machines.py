"""Altered machines, and what is left of their equations of motion when two coordinates are eliminated.

One body, or a group of them, has another mass, inertia, velocity or angle than it has. Each machine comes with a hint,
one sentence and the question that leads on; what students do often comes first. Machines and altered procedures go
through one elimination, exactly, for any mass ratio.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.derivation.symbols import (
    COORDINATES,
    HOOP,
    SOLID_CYLINDER,
    Body,
    Machine,
    Phi,
    R,
    X,
    epsilon,
    k,
    m,
    m_prime,
    machine,
    phi,
)
from ramanujan.translation import _

_LOWER_ROLLERS, _ROLLERS = ("hoop", "cylinder"), ("hoop", "cylinder", "top")
_RIDERS = ("hoop", "cylinder", "slab", "top")

CALLED = {
    "block": _("the block"),
    "hoop": _("the hoop"),
    "cylinder": _("the lower cylinder"),
    "slab": _("the slab"),
    "top": _("the top cylinder"),
}
"""The name of each body in a sentence."""

_GROUPS = {
    _LOWER_ROLLERS: _("the lower rollers"),
    _ROLLERS: _("all rollers"),
    _RIDERS: _("everything on the block"),
    **{(name,): called for name, called in CALLED.items()},
}

right = cache(machine)
"""The machine as it is."""


@dataclass(frozen=True)
class Mistake:
    """A hint (one sentence, then a question), and the machine for which the mistake would be right."""

    hint: str
    bodies: Machine


@cache
def common() -> tuple[Mistake, ...]:
    """Return mistakes that confuse bodies, masses, angles and velocities of this machine."""
    return (*_rotation(), *_masses(), *_velocities(), *_displacements(), *_inertia("a_hoop", "a_cylinder"))


@cache
def exotic() -> tuple[Mistake, ...]:
    """Return mistakes that put other bodies into the machine, or take one out."""
    return (
        *_inertia("a_shell", "a_sphere"),
        *_each(
            _("You get this result if you leave out {body}. Which bodies have kinetic energy?"),
            _alone(*CALLED),
            lambda body: replace(body, mass=sp.S.Zero),
        ),
    )


def _alone(*names: str) -> tuple[tuple[str, ...], ...]:
    return tuple((name,) for name in names)


def _each(
    hint: str, groups: tuple[tuple[str, ...], ...], change: Callable[[Body], Body], **words: str
) -> Iterator[Mistake]:
    for names in groups:
        bodies = Machine(tuple(change(body) if body.name in names else body for body in right().bodies))
        yield Mistake(hint.format(body=_GROUPS[names], **words), bodies)


def _rotation() -> Iterator[Mistake]:
    groups = (*_alone(*_ROLLERS), _LOWER_ROLLERS, _ROLLERS)
    yield from _each(
        _(
            "You get this result if you leave out the rotation of {body}. Which energy does a body have because it "
            "rotates?"
        ),
        groups,
        lambda body: replace(body, shape_factor=sp.S.Zero),
    )
    yield from _each(
        _(
            "You get this result if you divide the velocity of {body} relative to the ground by R to find the angular "
            "velocity. On which surface does a roller roll?"
        ),
        groups,
        lambda body: replace(body, angle=sp.expand(body.displacement / R)),
    )


def _masses() -> Iterator[Mistake]:
    hint = _("You get this result if {body} has the mass {mass}. Which mass does it have?")
    hint_for_both = _("You get this result if {body} have the mass {mass}. Which mass do they have?")

    def other(body: Body) -> Body:
        return replace(body, mass=m if body.mass == m_prime else m_prime)

    yield from _each(hint, _alone(*_LOWER_ROLLERS), other, mass="m")
    yield from _each(hint_for_both, (_LOWER_ROLLERS,), other, mass="m")
    yield from _each(hint, _alone("block", "slab", "top"), other, mass="m′")


def _velocities() -> Iterator[Mistake]:
    groups = (*_alone(*_RIDERS), _LOWER_ROLLERS)
    yield from _each(
        _(
            "You get this result if you add X′ to the velocity of {body} instead of subtracting it. In which direction "
            "does the block move when X grows?"
        ),
        groups,
        lambda body: replace(body, displacement=body.displacement.subs(X, -X)),
    )
    yield from _each(
        _(
            "You get this result if you take the velocity of {body} relative to the block. How does the block itself "
            "move?"
        ),
        (*groups, _RIDERS),
        lambda body: replace(body, displacement=body.displacement.subs(X, 0)),
    )


def _displacements() -> Iterator[Mistake]:
    yield from _each(
        _(
            "You get this result if {body} moves only as far as the centres of its rollers. How fast does the top of a "
            "rolling body move?"
        ),
        _alone("slab"),
        lambda body: replace(body, displacement=right()["hoop"].displacement),
    )
    yield from _each(
        _(
            "You get this result if you give {body} the displacement of the slab. How far does the centre of a roller "
            "move when its top moves by 2Rφ?"
        ),
        (*_alone(*_LOWER_ROLLERS), _LOWER_ROLLERS),
        lambda body: replace(body, displacement=right()["slab"].displacement),
    )
    hint = _("You get this result if you use the angle {angle} for {body}. Which angle describes the motion of {body}?")
    for names, own, other, shown in ((_RIDERS[:3], phi, Phi, "Φ"), (_RIDERS[3:], Phi, phi, "φ")):
        yield from _each(
            hint,
            _alone(*names),
            lambda body, own=own, other=other: replace(
                body, displacement=body.displacement.subs(own, other), angle=body.angle.subs(own, other)
            ),
            angle=shown,
        )


def _inertia(*shapes: str) -> Iterator[Mistake]:
    hint = _(
        "You get this result if {body} has the moment of inertia of {shape}. What is the moment of inertia of {body}?"
    )
    known = {
        "a_hoop": (_("a hoop"), HOOP),
        "a_shell": (_("a spherical shell"), sp.Rational(2, 3)),
        "a_cylinder": (_("a solid cylinder"), SOLID_CYLINDER),
        "a_sphere": (_("a solid sphere"), sp.Rational(2, 5)),
    }
    for shape, factor in (known[name] for name in shapes):
        others = _alone(*(name for name in _ROLLERS if right()[name].shape_factor != factor))
        yield from _each(hint, others, lambda body, factor=factor: replace(body, shape_factor=factor), shape=shape)


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
    matrix, stiffness = _equations(right())
    found = []
    for hint, (row, column), factor in PROCEDURES:
        altered = [list(each) for each in matrix]
        altered[row][column] *= factor
        found.append((hint, _solved(name, altered, stiffness)))
    everyone = (*common(), *exotic())
    return (*found, *((mistake.hint, _solved(name, *_equations(mistake.bodies))) for mistake in everyone))


def conditions() -> Iterator[tuple[str, tuple[int, int, int]]]:
    """Yield the quadratics aε² + bε + c for Ω² = k/m of altered procedures and machines, as a, b and c."""
    for hint, squared in eliminated("natural_frequency_squared"):
        if squared and squared.denom.degree() <= 2:
            condition = (squared.denom - squared.numer).as_expr()
            yield hint, tuple(int(condition.coeff(epsilon, n)) for n in (2, 1, 0))
