"""Altered machines: one body, or a group of them, with another mass, inertia, velocity or angle than it has.

Each comes with a hint, one sentence and the question that leads on. What students do often comes first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ramanujan.derivation.symbols import HOOP, SOLID_CYLINDER, Body, Machine, Phi, R, X, m, m_prime, machine, phi
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

    @property
    def altered(self) -> tuple[str, ...]:
        """The names of the bodies that the mistake changes."""
        return tuple(body.name for body in self.bodies.bodies if body != right()[body.name])


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

    yield from _each(hint_for_both, (_LOWER_ROLLERS,), other, mass="m")
    yield from _each(hint, _alone(*_LOWER_ROLLERS), other, mass="m")
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
