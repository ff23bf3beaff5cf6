"""Altered machines, and what is left of their equations of motion when two coordinates are eliminated.

A mistake gives one body, or a group of them, another mass, inertia, velocity or angle than it has. Machines and altered
procedures go through one elimination, exactly, for any mass ratio.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.derivation import model
from ramanujan.derivation.model import COORDINATES, Body, Machine, Phi, R, X, epsilon, k, m, m_prime, machine, phi
from ramanujan.translation import _

CALLED = {
    # TRANSLATORS: the names of the bodies in sentences; they stand in the slots {body}, {name} and {roller}.
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
    model.HOOP: _("a hoop"),
    model.SOLID_CYLINDER: _("a solid cylinder"),
    sp.Rational(2, 3): _("a spherical shell"),
    sp.Rational(2, 5): _("a solid sphere"),
}

right = cache(machine)
"""The machine as it is."""


@dataclass(frozen=True)
class Mistake:
    """A mistake about bodies.

    Parameters
    ----------
    id : its name
    hint : a sentence and the question that leads on, with slots for {body}, and for its {mass}, {angle} or {shape}
    groups : names of bodies, or of several, that it may concern
    change : body → what is different of it
    """

    id: str
    hint: str
    groups: tuple[str, ...]
    change: Callable[[Body], dict[str, Any]]

    @property
    def is_of_inertia(self) -> bool:
        """Whether it changes nothing but moments of inertia."""
        return self.id == "no_rotation" or self.id.startswith("inertia")


@dataclass(frozen=True)
class Altered:
    """The machine as it would be if a mistake about a group of bodies were right."""

    mistake: Mistake
    group: str
    machine: Machine

    @property
    def bodies(self) -> frozenset[str]:
        """The names of the bodies that are different."""
        return frozenset(self.group.split())

    @property
    def hint(self) -> str:
        """The hint at the mistake."""
        body = self.machine[self.group.split()[-1]]
        return self.mistake.hint.format(
            body=_GROUPS[self.group],
            mass="m" if body.mass == m else "m′",
            angle="φ" if body.displacement.has(phi) else "Φ",
            shape=_SHAPES.get(body.shape_factor, ""),
        )


def _other_angle(body: Body) -> dict[str, Any]:
    swapped = {phi: Phi, Phi: phi}
    return {"displacement": body.displacement.xreplace(swapped), "angle": body.angle.xreplace(swapped)}


MISTAKES = (
    Mistake(
        "no_rotation",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you leave out the rotation of {body}. What is the energy of a rotation?"),
        (*_ROLLERS.split(), _LOWER, _ROLLERS),
        lambda _body: {"shape_factor": sp.S.Zero},
    ),
    Mistake(
        "rolls_on_ground",
        _(
            # TRANSLATORS: {body} is the hoop, the lower rollers … as translated for this.
            "You get this result if you divide the velocity of {body} relative to the ground by R to find the angular "
            "velocity. On which surface does a roller roll?"
        ),
        (*_ROLLERS.split(), _LOWER, _ROLLERS),
        lambda body: {"angle": sp.expand(body.displacement / R)},
    ),
    Mistake(
        "other_mass",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you give the mass {mass} to {body}. Which bodies have this mass?"),
        (*CALLED, _LOWER),
        lambda body: {"mass": m if body.mass == m_prime else m_prime},
    ),
    Mistake(
        "sign_of_X",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you add X′ to the velocity of {body}. In which direction does the block move?"),
        (*_RIDERS.split(), _LOWER),
        lambda body: {"displacement": body.displacement.subs(X, -X)},
    ),
    Mistake(
        "relative_to_block",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you take the velocity of {body} relative to the block. How does the block move?"),
        (*_RIDERS.split(), _LOWER, _RIDERS),
        lambda body: {"displacement": body.displacement.subs(X, 0)},
    ),
    Mistake(
        "slab_as_centres",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if {body} moves only as far as the centres of its rollers. How far do their tops move?"),
        ("slab",),
        lambda _body: {"displacement": right()["hoop"].displacement},
    ),
    Mistake(
        "roller_as_slab",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you let {body} move as far as the slab. How far does the centre of a roller move?"),
        (*_LOWER.split(), _LOWER),
        lambda _body: {"displacement": right()["slab"].displacement},
    ),
    Mistake(
        "other_angle",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you use the angle {angle} for {body}. Which bodies turn by this angle?"),
        tuple(_RIDERS.split()),
        _other_angle,
    ),
    *(
        Mistake(
            f"inertia_{shape}",
            # TRANSLATORS: {body} is the hoop, the top cylinder …; {shape} is a hoop, a solid cylinder …
            _("You get this result if {body} has the moment of inertia of {shape}. What is the right one?"),
            tuple(_ROLLERS.split()),
            lambda _body, shape=shape: {"shape_factor": shape},
        )
        for shape in _SHAPES
    ),
    Mistake(
        "left_out",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you leave out {body}. Which bodies have kinetic energy?"),
        tuple(CALLED),
        lambda _body: {"mass": sp.S.Zero},
    ),
)


@cache
def altered() -> tuple[Altered, ...]:
    """Return the machine of each mistake about each group of bodies, unless it changes nothing."""
    found = (
        Altered(mistake, group, Machine(tuple(_changed(body, mistake, group.split()) for body in right().bodies)))
        for mistake in MISTAKES
        for group in mistake.groups
    )
    return tuple(each for each in found if each.machine != right())


def _changed(body: Body, mistake: Mistake, names: list[str]) -> Body:
    return replace(body, **mistake.change(body)) if body.name in names else body


def named(same: Sequence[Altered]) -> str | None:
    """Return the hint at the one mistake that gives a result; None if several do, and nobody knows which it was.

    Of groups that contain each other the smallest is named: the rest of the mistake has no effect on the result.
    """
    least = min(same, key=lambda each: len(each.bodies))
    if all(each.mistake is least.mistake and least.bodies <= each.bodies for each in same):
        return least.hint
    if all(each.mistake.is_of_inertia and each.bodies <= {*_LOWER.split()} for each in same):
        return _("You get this result with other moments of inertia of the lower rollers. What are they?")
    return None


# The elimination


_RATIOS = field(epsilon, sp.ZZ)[0]
_UNITS = {m: sp.S.One, k: sp.S.One, R: sp.S.One, m_prime: epsilon}
"""An answer has a unit, and in that unit it is a quotient of polynomials in the mass ratio."""

_Equations = tuple[list[list[FracElement]], FracElement]
"""The mass matrix and the stiffness ∂²U/∂φ², in units of m, k and R."""


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


@cache
def _equations(bodies: Machine) -> _Equations:
    def worth(expression: sp.Expr) -> FracElement:
        return _RATIOS.from_expr(sp.sympify(expression).xreplace(_UNITS))

    matrix = [list(map(worth, row)) for row in mass_matrix(bodies)]
    return matrix, worth(k * _rates_of(bodies.deformation)[1] ** 2)


def _solved(name: str, equations: _Equations) -> sp.Expr | None:
    """Return the answer to a question from the three equations of motion, None if there is none.

    The X and Φ equations, rows 0 and 2, give Ẍ and Φ̈, which go into the φ equation. The question about the φ equation
    writes its last term as 4kRφ.
    """
    ((a, b, c), (d, e, f), (g, h, i)), stiffness = equations
    # Without a top cylinder the Φ equation is empty: Φ̈ may be anything, also 0.
    i = i or i + 1
    determinant, block, top = a * i - c * g, c * h - b * i, b * g - a * h
    squared = stiffness * determinant, e * determinant + d * block + f * top
    above, below, unit = {
        "block_coupling": (block, determinant, R),
        "top_coupling": (top, determinant, 1),
        "phi_equation": (4 * e, stiffness, m * R),
    }.get(name, (*squared, k / m))
    if not below:
        return None
    if name in ("unit_quadratic", "unit_mass_ratio"):
        return _condition(name, above / below)
    return unit * (above / below).as_expr()


def _condition(name: str, squared: FracElement) -> sp.Expr | None:
    """Return the quadratic equation for Ω² = k/m, or its positive root."""
    condition = (squared.denom - squared.numer).as_expr().as_poly(epsilon)
    if condition.degree() != 2:
        return None
    if name == "unit_mass_ratio":
        return positive_root(condition)
    # An equation with one term says no more than that this term is zero.
    return condition.as_expr() if len(condition.terms()) > 1 else None


def positive_root(condition: sp.Poly) -> sp.Expr | None:
    """Return the positive root of a quadratic, None if it has not exactly one."""
    a, b, c = condition.all_coeffs()
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - b / a) / 2 if a * c < 0 else None


def answer(name: str, bodies: Machine) -> sp.Expr | None:
    """Return the answer to a question about the elimination that is right for a machine, None if there is none."""
    return _solved(name, _equations(bodies))


def procedures(name: str) -> Iterator[tuple[str, sp.Expr | None]]:
    """Yield hint and result of each slip in the elimination."""
    hint = _(
        "You get this result if you leave the acceleration of Φ out of the X equation. What does the Φ equation say "
        "about it?"
    )
    yield hint, _with_a_slip(name, 0, 2, 0)
    hint = _(
        "You get this result if you leave out the acceleration of X, as if the block stood still. What does the X "
        "equation say about it?"
    )
    yield hint, _with_a_slip(name, 1, 0, 0)
    hint = _(
        "You get this result if you insert the acceleration of {q} with the wrong sign. What does its equation say?"
    )
    yield hint.format(q="Φ"), _with_a_slip(name, 2, 0, -1)
    yield hint.format(q="X"), _with_a_slip(name, 1, 0, -1)


def _with_a_slip(name: str, row: int, column: int, factor: int) -> sp.Expr | None:
    """Return the answer if one entry of the three equations is multiplied by a factor."""
    matrix, stiffness = _equations(right())
    slipped = [list(each) for each in matrix]
    slipped[row][column] *= factor
    return _solved(name, (slipped, stiffness))
