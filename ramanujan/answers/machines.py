"""Wrong bodies, and the answers that follow from the equations of motion of an altered machine.

A mistake changes the mass, inertia, velocity or angle of one body or of a group. The equations of motion of every
altered machine are solved exactly, for any mass ratio.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from ramanujan.derivation import model
from ramanujan.derivation.model import COORDINATES, Body, Machine, Phi, R, X, epsilon, k, m, m_prime, machine, phi
from ramanujan.translation import _

CALLED = {
    # TRANSLATORS: the names of the bodies in sentences; they fill the slots {body}, {name} and {roller}.
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
    model.HOOP: (
        _("a hoop"),
        ("lagrangian", "½(3m+2m')X'² + (2m+2m')R²φ'² + ¾mR²Φ'² - 2(m+m')RX'φ' - mRX'Φ' - 2kR²φ²"),
    ),
    model.SOLID_CYLINDER: (_("a solid cylinder"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+¼m'R²φ'²")),
    sp.Rational(2, 3): (_("a spherical shell"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+⅓m'R²φ'²")),
    sp.Rational(2, 5): (_("a solid sphere"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+⅕m'R²φ'²")),
}
"""The name of a body with each shape factor, and the example of a mistake with it."""

right = cache(machine)
"""Return the right machine."""


@dataclass(frozen=True)
class Mistake:
    """A mistake about bodies.

    Parameters
    ----------
    id : the name
    hint : a sentence and the question that leads on, with slots for {body}, and for its {mass}, {angle} or {shape}
    groups : the bodies, and the groups of bodies, that it may concern
    change : body → its wrong attributes
    example : a question and the answer of a student who makes the mistake
    """

    id: str
    hint: str
    groups: tuple[str, ...]
    change: Callable[[Body], dict[str, Any]]
    example: tuple[str, str]

    @property
    def is_of_inertia(self) -> bool:
        """Whether it changes only moments of inertia."""
        return self.id == "no_rotation" or self.id.startswith("inertia")


@dataclass(frozen=True)
class Altered:
    """The machine with a mistake about a group of bodies."""

    mistake: Mistake
    group: str
    machine: Machine

    @property
    def bodies(self) -> frozenset[str]:
        """The names of the altered bodies."""
        return frozenset(self.group.split())

    @property
    def hint(self) -> str:
        """The hint, with its slots filled."""
        body = self.machine[self.group.split()[-1]]
        return self.mistake.hint.format(
            body=_GROUPS[self.group],
            mass="m" if body.mass == m else "m′",
            angle="φ" if body.displacement.has(phi) else "Φ",
            shape=_SHAPES.get(body.shape_factor, ("",))[0],
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
        ("kinetic_energy_hoop", "½m'(Rφ'-X')²"),
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
        ("kinetic_energy_hoop", "½m'(Rφ'-X')²+½m'(Rφ'-X')²"),
    ),
    Mistake(
        "other_mass",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you give the mass {mass} to {body}. Which bodies have this mass?"),
        (*CALLED, _LOWER),
        lambda body: {"mass": m if body.mass == m_prime else m_prime},
        ("kinetic_energy_block", "½m'X'²"),
    ),
    Mistake(
        "sign_of_X",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you add X′ to the velocity of {body}. In which direction does the block move?"),
        (*_RIDERS.split(), _LOWER),
        lambda body: {"displacement": body.displacement.subs(X, -X)},
        ("kinetic_energy_hoop", "½m'(Rφ'+X')²+½m'R²φ'²"),
    ),
    Mistake(
        "relative_to_block",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you take the velocity of {body} relative to the block. How does the block move?"),
        (*_RIDERS.split(), _LOWER, _RIDERS),
        lambda body: {"displacement": body.displacement.subs(X, 0)},
        ("kinetic_energy_hoop", "m'R²φ'²"),
    ),
    Mistake(
        "slab_as_centres",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if {body} moves only as far as the centres of its rollers. How far do their tops move?"),
        ("slab",),
        lambda _body: {"displacement": right()["hoop"].displacement},
        ("kinetic_energy_slab", "½m(Rφ'-X')²"),
    ),
    Mistake(
        "roller_as_slab",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you let {body} move as far as the slab. How far does the centre of a roller move?"),
        (*_LOWER.split(), _LOWER),
        lambda _body: {"displacement": right()["slab"].displacement},
        ("kinetic_energy_hoop", "½m'(2Rφ'-X')²+½m'R²φ'²"),
    ),
    Mistake(
        "other_angle",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you use the angle {angle} for {body}. Which bodies turn by this angle?"),
        tuple(_RIDERS.split()),
        _other_angle,
        ("kinetic_energy_hoop", "½m'(RΦ'-X')²+½m'R²Φ'²"),
    ),
    *(
        Mistake(
            f"inertia_{shape}",
            # TRANSLATORS: {body} is the hoop, the top cylinder …; {shape} is a hoop, a solid cylinder …
            _("You get this result if {body} has the moment of inertia of {shape}. What is the right one?"),
            tuple(_ROLLERS.split()),
            lambda _body, shape=shape: {"shape_factor": shape},
            example,
        )
        for shape, (_name, example) in _SHAPES.items()
    ),
    Mistake(
        "left_out",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        _("You get this result if you leave out {body}. Which bodies have kinetic energy?"),
        tuple(CALLED),
        lambda _body: {"mass": sp.S.Zero},
        ("lagrangian", "(m+m')X'² + ¼(8m+7m')R²φ'² - 2(m+m')RX'φ' - 2kR²φ²"),
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
    """Return the hint at the only mistake with a result; None if several mistakes have it.

    If groups contain each other, the smallest one is named: the rest of the mistake has no effect on the result.
    """
    least = min(same, key=lambda each: len(each.bodies))
    if all(each.mistake is least.mistake and least.bodies <= each.bodies for each in same):
        return least.hint
    if all(each.mistake.is_of_inertia and each.bodies <= {*_LOWER.split()} for each in same):
        return _("You get this result with other moments of inertia of the lower rollers. What are they?")
    return None


# The equations of motion


_DOMAIN = sp.ZZ.frac_field(epsilon)
_UNITS = {m: sp.S.One, k: sp.S.One, R: sp.S.One, m_prime: epsilon}
"""In units of m, k and R, an answer is a quotient of polynomials in the mass ratio."""
_FORCE_ON_PHI = DomainMatrix([[_DOMAIN.zero], [_DOMAIN.one], [_DOMAIN.zero]], (3, 1), _DOMAIN)


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


def _solved(name: str, bodies: Machine, factors: dict[tuple[int, int], int]) -> sp.Expr | None:
    """Return the answer to a question from the equations of motion M a = −∂U/∂q, None if there is none.

    Only φ has a force, −∂U/∂φ = −stiffness·φ. So the accelerations are in the ratio of the column φ of M⁻¹, and Ω² is
    the stiffness times its entry in the row φ. The question about the φ equation writes its last term as 4kRφ.

    Parameters
    ----------
    name : the question
    bodies : the machine
    factors : row and column of an entry of M → its factor, for a slip in the elimination
    """
    matrix = [[_in_units(entry) for entry in row] for row in mass_matrix(bodies)]
    stiffness = _in_units(k * _rates_of(bodies.deformation)[1] ** 2)
    for (row, column), factor in factors.items():
        matrix[row][column] *= factor
    # Without a top cylinder the Φ equation is empty, and Φ̈ may be 0.
    matrix[2][2] = matrix[2][2] or _DOMAIN.one
    try:
        block, rollers, top = DomainMatrix(matrix, (3, 3), _DOMAIN).lu_solve(_FORCE_ON_PHI).to_list_flat()
    except DMNonInvertibleMatrixError:
        return None
    quotients = {
        "block_coupling": (block, rollers, R),
        "top_coupling": (top, rollers, 1),
        "phi_equation": (4 * matrix[1][1], stiffness, m * R),
    }
    above, below, unit = quotients.get(name, (stiffness * rollers, _DOMAIN.one, k / m))
    if not below:
        return None
    if name in ("unit_quadratic", "unit_mass_ratio"):
        return _condition(name, above)
    return unit * (above / below).as_expr()


def _condition(name: str, squared: FracElement) -> sp.Expr | None:
    """Return the quadratic equation for Ω² = k/m, or its positive root."""
    condition = (squared.denom - squared.numer).as_expr().as_poly(epsilon)
    if condition.degree() != 2:
        return None
    if name == "unit_mass_ratio":
        return positive_root(condition)
    # An equation with one term states only that this term is zero.
    return condition.as_expr() if len(condition.terms()) > 1 else None


def _in_units(expression: sp.Expr) -> FracElement:
    return _DOMAIN.from_sympy(sp.sympify(expression).xreplace(_UNITS))


def positive_root(condition: sp.Poly) -> sp.Expr | None:
    """Return the positive root of a quadratic, None unless it has exactly one."""
    a, b, c = condition.all_coeffs()
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - b / a) / 2 if a * c < 0 else None


def answer(name: str, bodies: Machine) -> sp.Expr | None:
    """Return the answer to a question about the elimination that is right for a machine, None if there is none."""
    return _solved(name, bodies, {})


def with_a_slip(name: str, row: int, column: int, factor: int) -> sp.Expr | None:
    """Return the answer to a question if one entry of the mass matrix is multiplied by a factor."""
    return _solved(name, right(), {(row, column): factor})
