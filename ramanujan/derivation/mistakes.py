"""What a student may have overlooked, and the formula one then gets: the same derivation run for an altered machine.

A mistake changes bodies or terms, never a result. Lives here: what can be altered, the hint for it, and the elimination
for altered machines. Not here: the right answers (they come from the routes) and the verdict.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ramanujan.derivation.euler_lagrange import unit_condition
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

ROLLING = ("hoop", "cylinder", "top")
LOWER_ROLLERS = ("hoop", "cylinder")
RIDERS = ("hoop", "cylinder", "slab", "top")

CALLED = {
    "block": "the block",
    "hoop": "the hoop",
    "cylinder": "the lower cylinder",
    "slab": "the slab",
    "top": "the top cylinder",
}
"""What a sentence calls a body."""

_SHAPES = {
    "a hoop": HOOP,
    "a spherical shell": sp.Rational(2, 3),
    "a solid cylinder": SOLID_CYLINDER,
    "a solid sphere": sp.Rational(2, 5),
}


@dataclass(frozen=True)
class Mistake:
    """A sentence that says what was overlooked, and the machine as it would be if that were right."""

    hint: str
    bodies: Machine

    @property
    def altered(self) -> tuple[str, ...]:
        """The names of the bodies that the mistake changes."""
        return tuple(body.name for body in self.bodies.bodies if body != machine()[body.name])

    @property
    def is_of_shape(self) -> bool:
        """Whether only moments of inertia are mistaken, so that the unit-frequency condition stays a quadratic."""
        return all(
            replace(body, shape_factor=right.shape_factor) == right
            for body, right in zip(self.bodies.bodies, machine().bodies, strict=True)
        )


@cache
def mistakes() -> tuple[Mistake, ...]:
    """Return every mistake that is one of the bodies; the more common ones come first."""
    return tuple(Mistake(hint, bodies) for family in _FAMILIES for hint, bodies in family())


@cache
def single_mass(bodies: Machine) -> dict[str, sp.Expr]:
    """Return what the elimination makes of a machine: the factors of φ̈ in Ẍ, in Φ̈ and in the φ equation, and Ω².

    With the mass matrix M, the X and Φ equations are solved for Ẍ and Φ̈, and these put into the φ equation, as in
    `euler_lagrange.eliminate`, whose result it has for the right machine; nothing is simplified on the way, so that
    many machines take little time. The spring's deformation counts as one of φ alone.
    """
    M = {(i, j): _inertia(bodies, COORDINATES[i], COORDINATES[j]) for i in range(3) for j in range(i, 3)}
    stiffness = k * bodies.deformation.coeff(phi) ** 2
    determinant = M[0, 0] * M[2, 2] - M[0, 2] ** 2
    block = (M[0, 2] * M[1, 2] - M[0, 1] * M[2, 2]) / determinant
    top = (M[0, 1] * M[0, 2] - M[0, 0] * M[1, 2]) / determinant
    return {
        "block_coupling": block,
        "top_coupling": top,
        # The question writes the φ equation with 4kRφ as its last term.
        "phi_equation": M[1, 1] * 4 * k * R / stiffness,
        "natural_frequency_squared": stiffness / (M[1, 1] + M[0, 1] * block + M[1, 2] * top),
    }


def unit_mass_ratio(bodies: Machine) -> sp.Expr:
    """Return the positive root ε of Ω² = k/m for a machine; ValueError if there is not exactly one."""
    return unit_condition(single_mass(bodies)["natural_frequency_squared"]).root


def overlooked_in_energy(body: Body) -> Iterator[tuple[str, sp.Expr]]:
    """Yield hints and kinetic energies for mistakes in the formula of the energy itself."""
    mixed = [term for term in sp.Add.make_args(sp.expand(body.kinetic_energy)) if len(_rates(term)) > 1]
    if mixed:
        yield (
            "The square of a sum has a mixed term too: (a + b)^2 is not a^2 + b^2.",
            sp.expand(body.kinetic_energy) - sp.Add(*mixed),
        )
    # One who forgets the square may count the speed to either side.
    for velocity in (body.velocity, -body.velocity):
        unsquared = (body.mass * velocity + body.moment_of_inertia * body.angle.diff(t)) / 2
        yield "The speed has to be squared.", unsquared
    if body.rotation:
        yield "A factor ½ is missing in the translation.", 2 * body.translation + body.rotation
        yield "A factor ½ is missing in the rotation.", body.translation + 2 * body.rotation
        yield f"This is the rotation of {CALLED[body.name]} alone; its centre moves too.", body.rotation


def _inertia(bodies: Machine, q: sp.Expr, other: sp.Expr) -> sp.Expr:
    """Return the entry of the mass matrix that belongs to two coordinates."""
    return sp.Add(*(_share(body, q, other) for body in bodies.bodies))


@cache
def _share(body: Body, q: sp.Expr, other: sp.Expr) -> sp.Expr:
    """Return what a body adds to an entry of the mass matrix; a mistake leaves most bodies as they are."""
    translation = body.mass * body.displacement.coeff(q) * body.displacement.coeff(other)
    return translation + body.moment_of_inertia * body.angle.coeff(q) * body.angle.coeff(other)


def _altered(names: tuple[str, ...], change: Callable[[Body], Body]) -> Machine:
    return Machine(tuple(change(body) if body.name in names else body for body in machine().bodies))


def _moved(names: tuple[str, ...], old: sp.Expr, new: sp.Expr) -> Machine:
    return _altered(names, lambda body: replace(body, displacement=body.displacement.subs(old, new)))


def _called(names: tuple[str, ...]) -> str:
    groups = {LOWER_ROLLERS: "the lower rollers", ROLLING: "all rolling bodies", RIDERS: "all that rides on the block"}
    return groups.get(names) or CALLED[names[0]]


def _rotation_forgotten() -> Iterator[tuple[str, Machine]]:
    for names in (*((name,) for name in ROLLING), LOWER_ROLLERS, ROLLING):
        yield (
            f"The rotation of {_called(names)} is left out: what rolls also has the energy of its spin.",
            _altered(names, lambda body: replace(body, shape_factor=sp.S.Zero)),
        )


def _wrong_inertia() -> Iterator[tuple[str, Machine]]:
    for name in ROLLING:
        for shape, factor in _SHAPES.items():
            if factor != machine()[name].shape_factor:
                yield (
                    f"The moment of inertia is not that of {CALLED[name]}: you took the one of {shape}.",
                    _altered((name,), lambda body, factor=factor: replace(body, shape_factor=factor)),
                )


def _wrong_mass() -> Iterator[tuple[str, Machine]]:
    for names in (LOWER_ROLLERS, *((name,) for name in CALLED)):
        wrong, right = ("m", "m'") if names[0] in LOWER_ROLLERS else ("m'", "m")
        verb = "have" if len(names) > 1 else "has"
        yield (
            f"You wrote {wrong} for {right}: {_called(names)} {verb} the mass {right}.",
            _altered(names, lambda body: replace(body, mass=m if body.mass == m_prime else m_prime)),
        )


def _wrong_rolling() -> Iterator[tuple[str, Machine]]:
    for names in ((name,) for name in RIDERS):
        yield _wrong_sign(names)
    yield _wrong_sign(LOWER_ROLLERS)
    for names in (*((name,) for name in RIDERS), RIDERS):
        yield (
            f"The speed of {_called(names)} has to be taken over the ground: the block moves too.",
            _moved(names, X, sp.S.Zero),
        )


def _wrong_sign(names: tuple[str, ...]) -> tuple[str, Machine]:
    return (
        f"Check a sign in the speed of {_called(names)}: X counts to the left, rolling goes to the right.",
        _moved(names, X, -X),
    )


def _wrong_travel() -> Iterator[tuple[str, Machine]]:
    # Where the slab is, the centres of its rollers are not: the two displacements are exchanged.
    yield (
        "A factor 2 is missing in the slab’s speed: lying on top of its rollers, it moves twice as far as they do.",
        _altered(("slab",), lambda body: replace(body, displacement=machine()["hoop"].displacement)),
    )
    for names in (*((name,) for name in LOWER_ROLLERS), LOWER_ROLLERS):
        yield (
            f"There is a factor 2 too many in the speed of {_called(names)}: the centre moves half as far as the top.",
            _altered(names, lambda body: replace(body, displacement=machine()["slab"].displacement)),
        )
    for name, other in (("hoop", Phi), ("cylinder", Phi), ("slab", Phi), ("top", phi)):
        own = phi if other == Phi else Phi
        yield (
            f"That is the wrong angle for {CALLED[name]}: phi belongs to the lower rollers, Phi to the top cylinder.",
            _altered(
                (name,),
                lambda body, own=own, other=other: replace(
                    body, displacement=body.displacement.subs(own, other), angle=body.angle.subs(own, other)
                ),
            ),
        )


def _left_out() -> Iterator[tuple[str, Machine]]:
    for name in ("hoop", "cylinder", "slab"):
        yield (
            f"It looks as if {CALLED[name]} had been left out.",
            _altered((name,), lambda body: replace(body, mass=sp.S.Zero)),
        )


_FAMILIES = (_wrong_inertia, _rotation_forgotten, _wrong_mass, _wrong_rolling, _wrong_travel, _left_out)


def _rates(term: sp.Expr) -> frozenset[sp.Expr]:
    return frozenset(rate for rate in VELOCITIES if term.has(rate))
