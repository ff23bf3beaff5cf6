"""Common mistakes, and the results that follow from them: the same derivation for an altered machine.

A mistake changes bodies or terms, never a result. Its hint names one way to this result and asks the next question. It
does not claim that the student went this way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ramanujan.derivation.expressions import SPELLING
from ramanujan.derivation.normal_form import (
    MINUS_ONE,
    VARIABLES,
    ZERO,
    NormalForm,
    coefficients,
    minus,
    over,
    plus,
    times,
)
from ramanujan.derivation.symbols import (
    COORDINATES,
    HOOP,
    SOLID_CYLINDER,
    VELOCITIES,
    Body,
    Machine,
    Phi,
    R,
    X,
    k,
    m,
    m_prime,
    machine,
    phi,
    t,
)
from ramanujan.words import _

ROLLING = ("hoop", "cylinder", "top")
LOWER_ROLLERS = ("hoop", "cylinder")
RIDERS = ("hoop", "cylinder", "slab", "top")

_COORDINATES = tuple(SPELLING[q] for q in COORDINATES)

CALLED = {
    "block": _("the block"),
    "hoop": _("the hoop"),
    "cylinder": _("the lower cylinder"),
    "slab": _("the slab"),
    "top": _("the top cylinder"),
}
"""The name of each body in a sentence."""

_SHAPES = {
    _("a hoop"): HOOP,
    _("a spherical shell"): sp.Rational(2, 3),
    _("a solid cylinder"): SOLID_CYLINDER,
    _("a solid sphere"): sp.Rational(2, 5),
}


@dataclass(frozen=True)
class Mistake:
    """A hint (one sentence, then a question), and the machine for which the mistake would be right."""

    hint: str
    bodies: Machine

    @property
    def altered(self) -> tuple[str, ...]:
        """The names of the bodies that the mistake changes."""
        return tuple(body.name for body in self.bodies.bodies if body != _right()[body.name])


@cache
def mistakes() -> tuple[Mistake, ...]:
    """Return every mistake that changes bodies; the more common ones come first."""
    return tuple(Mistake(hint, bodies) for family in _FAMILIES for hint, bodies in family())


def single_mass(bodies: Machine, name: str) -> NormalForm | None:
    """Return one result of the elimination for a machine: the factor of φ̈ in Ẍ, in Φ̈ or in the φ equation, or Ω².

    The X and Φ equations are solved for Ẍ and Φ̈, which are inserted into the φ equation, as in
    `euler_lagrange.eliminate`. The mass matrix and polynomials make this fast enough for many machines. The spring's
    deformation is taken to depend on φ alone.

    Parameters
    ----------
    bodies : the machine
    name : block_coupling, top_coupling, phi_equation or natural_frequency_squared; None is returned where that divides
        by zero
    """
    stiffness = _form(k * bodies.deformation.coeff(phi) ** 2)
    if name == "phi_equation":
        # The question writes the φ equation with 4kRφ as its last term.
        above, below = times(_inertia(bodies, "phi", "phi"), _form(4 * k * R)), stiffness
    else:
        determinant, block, top, inertia = _eliminated(bodies)
        above, below = {
            "block_coupling": (block, determinant),
            "top_coupling": (top, determinant),
            "natural_frequency_squared": (times(stiffness, determinant), inertia),
        }[name]
    return None if below.is_zero else over(above, below)


@cache
def _eliminated(bodies: Machine) -> tuple[NormalForm, NormalForm, NormalForm, NormalForm]:
    """Return D, B, T and J of Ẍ = (B/D)φ̈, Φ̈ = (T/D)φ̈ and Ω² = stiffness·D/J."""
    M = {(i, j): _inertia(bodies, _COORDINATES[i], _COORDINATES[j]) for i in range(3) for j in range(i, 3)}
    if M[2, 2].is_zero:
        # Without a top cylinder the Φ equation is empty.
        determinant, block, top = M[0, 0], times(MINUS_ONE, M[0, 1]), ZERO
    else:
        determinant = minus(times(M[0, 0], M[2, 2]), times(M[0, 2], M[0, 2]))
        block = minus(times(M[0, 2], M[1, 2]), times(M[0, 1], M[2, 2]))
        top = minus(times(M[0, 1], M[0, 2]), times(M[0, 0], M[1, 2]))
    inertia = plus(times(M[1, 1], determinant), times(M[0, 1], block), times(M[1, 2], top))
    return determinant, block, top, inertia


def overlooked_in_energy(body: Body) -> Iterator[tuple[str, sp.Expr]]:
    """Yield hints and kinetic energies for mistakes in the formula of the energy itself."""
    mixed = [term for term in sp.Add.make_args(sp.expand(body.kinetic_energy)) if len(_rates(term)) > 1]
    if mixed:
        yield (
            _("You get this result if you square a sum term by term. What is the mixed term of (a + b)²?"),
            sp.expand(body.kinetic_energy) - sp.Add(*mixed),
        )
    # A student who forgets the square may count the velocity positive to either side.
    for velocity in (body.velocity, -body.velocity):
        unsquared = (body.mass * velocity + body.moment_of_inertia * body.angle.diff(t)) / 2
        yield (
            _("You get this result if you do not square the velocity. How does kinetic energy depend on velocity?"),
            unsquared,
        )
    if body.rotation:
        yield (
            _(
                "You get this result if you leave out the ½ in the energy of translation. What is the kinetic energy "
                "of a point mass?"
            ),
            2 * body.translation + body.rotation,
        )
        yield (
            _(
                "You get this result if you leave out the ½ in the energy of rotation. What is the energy of a body "
                "that rotates about a fixed axis?"
            ),
            body.translation + 2 * body.rotation,
        )
        yield (
            _("This is only the energy of rotation of {body}. How fast does its centre move?").format(
                body=CALLED[body.name]
            ),
            body.rotation,
        )
    yield (
        _("You get this result if you leave out the ½. What is the kinetic energy of a point mass?"),
        2 * body.kinetic_energy,
    )


@cache
def _inertia(bodies: Machine, q: str, other: str) -> NormalForm:
    """Return the entry of the mass matrix that belongs to two coordinates."""
    right = _right()
    if bodies == right:
        return plus(*(_share(body, q, other) for body in bodies.bodies))
    # A mistake leaves most bodies as they are.
    changed = [(body, right[body.name]) for body in bodies.bodies if body != right[body.name]]
    changes = (minus(_share(body, q, other), _share(original, q, other)) for body, original in changed)
    return plus(_inertia(right, q, other), *changes)


@cache
def _share(body: Body, q: str, other: str) -> NormalForm:
    """Return the contribution of a body to an entry of the mass matrix."""
    moved, turned = _rates_of(body.displacement), _rates_of(body.angle)
    translation = times(_form(body.mass), moved.get(q, ZERO), moved.get(other, ZERO))
    rotation = times(_form(body.moment_of_inertia), turned.get(q, ZERO), turned.get(other, ZERO))
    return plus(translation, rotation)


@cache
def _rates_of(displacement: sp.Expr) -> dict[str, NormalForm]:
    """Return the factor of each coordinate in a displacement or an angle."""
    by_product = coefficients(_form(displacement), _COORDINATES)
    return {VARIABLES[product.index(1)]: coefficient for product, coefficient in by_product.items()}


_form = cache(NormalForm.of)
_right = cache(machine)


def _altered(names: tuple[str, ...], change: Callable[[Body], Body]) -> Machine:
    return Machine(tuple(change(body) if body.name in names else body for body in _right().bodies))


def _moved(names: tuple[str, ...], old: sp.Expr, new: sp.Expr) -> Machine:
    return _altered(names, lambda body: replace(body, displacement=body.displacement.subs(old, new)))


def _called(names: tuple[str, ...]) -> str:
    groups = {LOWER_ROLLERS: _("the lower rollers"), ROLLING: _("all rollers"), RIDERS: _("everything on the block")}
    return groups.get(names) or CALLED[names[0]]


def _rotation_forgotten() -> Iterator[tuple[str, Machine]]:
    for names in (*((name,) for name in ROLLING), LOWER_ROLLERS, ROLLING):
        yield (
            _(
                "You get this result if you leave out the rotation of {bodies}. Which energy does a body have because "
                "it rotates?"
            ).format(bodies=_called(names)),
            _altered(names, lambda body: replace(body, shape_factor=sp.S.Zero)),
        )


def _spin_from_the_ground() -> Iterator[tuple[str, Machine]]:
    for names in (*((name,) for name in ROLLING), LOWER_ROLLERS, ROLLING):
        yield (
            _(
                "You get this result if you divide the velocity of {bodies} relative to the ground by R to find the "
                "angular velocity. On which surface does a roller roll?"
            ).format(bodies=_called(names)),
            _altered(names, lambda body: replace(body, angle=sp.expand(body.displacement / R))),
        )


def _wrong_inertia() -> Iterator[tuple[str, Machine]]:
    for name in ROLLING:
        for shape, factor in _SHAPES.items():
            if factor != _right()[name].shape_factor:
                yield (
                    _(
                        "You get this result if {body} has the moment of inertia of {shape}. What is the moment of "
                        "inertia of {body}?"
                    ).format(body=CALLED[name], shape=shape),
                    _altered((name,), lambda body, factor=factor: replace(body, shape_factor=factor)),
                )


def _wrong_mass() -> Iterator[tuple[str, Machine]]:
    yield (
        _("You get this result if the lower rollers have the mass m. Which mass do they have?"),
        _with_other_mass(LOWER_ROLLERS),
    )
    for name in CALLED:
        wrong = "m" if name in LOWER_ROLLERS else "m′"
        yield (
            _("You get this result if {body} has the mass {mass}. Which mass does it have?").format(
                body=CALLED[name], mass=wrong
            ),
            _with_other_mass((name,)),
        )


def _with_other_mass(names: tuple[str, ...]) -> Machine:
    return _altered(names, lambda body: replace(body, mass=m if body.mass == m_prime else m_prime))


def _wrong_rolling() -> Iterator[tuple[str, Machine]]:
    for names in (*((name,) for name in RIDERS), LOWER_ROLLERS):
        yield (
            _(
                "You get this result if you add X′ to the velocity of {bodies} instead of subtracting it. In which "
                "direction does the block move when X grows?"
            ).format(bodies=_called(names)),
            _moved(names, X, -X),
        )
    for names in (*((name,) for name in RIDERS), LOWER_ROLLERS, RIDERS):
        yield (
            _(
                "You get this result if you take the velocity of {bodies} relative to the block. How does the block "
                "itself move?"
            ).format(bodies=_called(names)),
            _moved(names, X, sp.S.Zero),
        )


def _wrong_travel() -> Iterator[tuple[str, Machine]]:
    # The displacements of the slab and of the centres of its rollers are confused.
    yield (
        _(
            "You get this result if the slab moves only as far as the centres of its rollers. How fast does the top of "
            "a rolling body move?"
        ),
        _altered(("slab",), lambda body: replace(body, displacement=_right()["hoop"].displacement)),
    )
    for names in (*((name,) for name in LOWER_ROLLERS), LOWER_ROLLERS):
        yield (
            _(
                "You get this result if you give {bodies} the displacement of the slab. How far does the centre of a "
                "roller move when its top moves by 2Rφ?"
            ).format(bodies=_called(names)),
            _altered(names, lambda body: replace(body, displacement=_right()["slab"].displacement)),
        )
    for name, own, other, wrong in (
        ("hoop", phi, Phi, "Φ"),
        ("cylinder", phi, Phi, "Φ"),
        ("slab", phi, Phi, "Φ"),
        ("top", Phi, phi, "φ"),
    ):
        yield (
            _(
                "You get this result if you use the angle {angle} for {body}. Which angle describes the motion of "
                "{body}?"
            ).format(angle=wrong, body=CALLED[name]),
            _altered(
                (name,),
                lambda body, own=own, other=other: replace(
                    body, displacement=body.displacement.subs(own, other), angle=body.angle.subs(own, other)
                ),
            ),
        )


def _left_out() -> Iterator[tuple[str, Machine]]:
    for name in CALLED:
        yield (
            _("You get this result if you leave out {body}. Which bodies have kinetic energy?").format(
                body=CALLED[name]
            ),
            _altered((name,), lambda body: replace(body, mass=sp.S.Zero)),
        )


_FAMILIES = (
    _rotation_forgotten,
    _wrong_mass,
    _wrong_rolling,
    _wrong_travel,
    _spin_from_the_ground,
    _wrong_inertia,
    _left_out,
)


def _rates(term: sp.Expr) -> frozenset[sp.Expr]:
    return frozenset(rate for rate in VELOCITIES if term.has(rate))
