"""Common mistakes, and the results that follow from them: the same derivation for an altered machine.

A mistake changes bodies or terms, never a result. Its hint names one way to this result and asks the next question. It
does not claim that the student went this way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ramanujan.derivation.altered import right
from ramanujan.derivation.symbols import (
    HOOP,
    SOLID_CYLINDER,
    VELOCITIES,
    Body,
    Machine,
    Phi,
    R,
    X,
    m,
    m_prime,
    phi,
    t,
)
from ramanujan.translation import _

ROLLING = ("hoop", "cylinder", "top")
LOWER_ROLLERS = ("hoop", "cylinder")
RIDERS = ("hoop", "cylinder", "slab", "top")

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
        return tuple(body.name for body in self.bodies.bodies if body != right()[body.name])


@cache
def mistakes() -> tuple[Mistake, ...]:
    """Return every mistake that changes bodies; the more common ones come first."""
    return tuple(Mistake(hint, bodies) for family in _FAMILIES for hint, bodies in family())


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


def _altered(names: tuple[str, ...], change: Callable[[Body], Body]) -> Machine:
    return Machine(tuple(change(body) if body.name in names else body for body in right().bodies))


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
            if factor != right()[name].shape_factor:
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
        _altered(("slab",), lambda body: replace(body, displacement=right()["hoop"].displacement)),
    )
    for names in (*((name,) for name in LOWER_ROLLERS), LOWER_ROLLERS):
        yield (
            _(
                "You get this result if you give {bodies} the displacement of the slab. How far does the centre of a "
                "roller move when its top moves by 2Rφ?"
            ).format(bodies=_called(names)),
            _altered(names, lambda body: replace(body, displacement=right()["slab"].displacement)),
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
