"""Energies of the bodies: the first steps of every route without forces, and the energy of each part.

The routes derive the energies; `printers` and the pages format them.
"""

from functools import cache

import sympy as sp

from ramanujan.derivation.model import Body, Machine, R, equation, gather, k, m, m_prime, machine, t
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Step, insert, margin_text, step
from ramanujan.text.translation import _

_KINETIC, _POTENTIAL, _LAGRANGIAN = sp.symbols("T U L")
# The energies of translation, of rotation and of the spring, for the margin.
_TRAVEL, _SPIN, _STORED = r"\tfrac12mv^2", r"\tfrac12I\omega^2", r"\tfrac12kx^2"
COLLECTED = margin_text(_("collect"))


def velocity_reason(body: Body, order: str = "") -> str:
    """Return the operation that leads to a body's velocity, or to its acceleration with the order ^2."""
    if body.displacement.has(R):
        # A body that moves with R without turning lies on rollers.
        return margin_text(_("rolling without slipping") if body.angle != 0 else _("as the tops of the rollers"))
    return rf"\tfrac{{d{order}}}{{dt{order}}}\left({latex(body.displacement)}\right)"


def bodies_steps(bodies: Machine) -> tuple[Step, ...]:
    """Return the steps from the rolling bodies to the Lagrangian as a sum over them."""
    rolling = [body for body in bodies.bodies if body.angle != 0]
    return (
        _velocities_step(bodies),
        _inertia_step(bodies, rolling),
        _body_energies_step(bodies, rolling),
        _sum_step(bodies),
    )


def _velocities_step(bodies: Machine) -> Step:
    return step(
        "velocities",
        _("Find the velocity of every body"),
        _(
            "Measure every velocity $v$ relative to the ground, positive to the right. The block moves to the left "
            "with $\\dot X$. No roller slips: relative to the block, its lowest point is at rest. So its centre "
            "moves to the right by $R$ times its clockwise angle, and its top twice as far. The slab rests on the "
            "tops of the lower rollers and moves with them."
        ),
        *(equation(f"v_{body.name}", body.velocity) for body in bodies.bodies),
        operations=tuple(velocity_reason(body) for body in bodies.bodies),
    )


def _inertia_step(bodies: Machine, rolling: list[Body]) -> Step:
    x_block, x_slab = sp.symbols("x_block x_slab")
    return step(
        "inertia",
        _("Find the moments of inertia and the compression of the spring"),
        _(
            "All mass of a hoop is at the distance $R$ from its axis. In a solid cylinder it is nearer, which "
            "halves the moment of inertia $I$. The compression $x$ of the spring is the displacement of the slab "
            "relative to the block."
        ),
        *(equation(f"I_{body.name}", body.moment_of_inertia) for body in rolling),
        equation("x", bodies.deformation),
        operations=(*(r"\textstyle\int r^2\,dm" for _body in rolling), rf"{latex(x_slab)}-{latex(x_block)}"),
    )


def _body_energies_step(bodies: Machine, rolling: list[Body]) -> Step:
    half = sp.Rational(1, 2)
    energies: dict[str, sp.Expr] = {}
    for body in bodies.bodies:
        energies[body.name] = half * body.mass * sp.Symbol(f"v_{body.name}") ** 2
        if body in rolling:
            rotation = half * sp.Symbol(f"I_{body.name}") * body.angle.diff(t) ** 2
            energies[body.name] = in_order(energies[body.name], rotation)
    return step(
        "energies",
        _("Write down the energies"),
        _(
            "The kinetic energy of a rolling body is that of its centre’s motion plus that of its rotation about "
            "the centre. The potential energy is that of the spring. Nothing moves up or down."
        ),
        *(equation(f"T_{name}", energy) for name, energy in energies.items()),
        equation("U", half * k * sp.Symbol("x") ** 2),
        equation("U", bodies.potential_energy),
        operations=(
            *(f"{_TRAVEL}+{_SPIN}" if body in rolling else _TRAVEL for body in bodies.bodies),
            _STORED,
            insert(equation("x", bodies.deformation)),
        ),
    )


def _sum_step(bodies: Machine) -> Step:
    return step(
        "sum",
        _("Add them up to the Lagrangian"),
        _(
            "The Lagrangian is $\\mathcal L=T-U$. Insert the velocities, the moments of inertia and the "
            "compression. The terms are those of block, hoop, lower cylinder, slab, top cylinder and spring, in "
            "this order."
        ),
        equation("L", in_order(*bodies.kinetic_parts, -bodies.potential_energy)),
        operations=(insert("v", "I", "x"),),
    )


def energies_step(bodies: Machine, reason: str) -> Step:
    """Return the step with T as a sum over the bodies, T with like terms collected, and U."""
    return step(
        "energies",
        _("Add up the energies"),
        reason,
        equation("T", in_order(*bodies.kinetic_parts)),
        equation("T", gather(bodies.kinetic_energy)),
        equation("U", bodies.potential_energy),
        operations=(rf"\textstyle\sum\left({_TRAVEL}+{_SPIN}\right)", COLLECTED, _STORED),
    )


def terms_by_part(equation: sp.Eq) -> dict[str, tuple[sp.Expr, ...]]:
    """Return the terms of T or ℒ by body, not multiplied out; for ℒ also the term of the spring.

    Their sum is the right side of the equation. The result is empty if the left side is neither T nor ℒ.

    Parameters
    ----------
    equation : in symbols, from a route

    >>> from ramanujan.derivation import ROUTES
    >>> terms_by_part(ROUTES["energy"]["energies"].equations[0])["block"]
    (m*Derivative(X(t), t)**2/2,)
    """
    if equation.lhs not in (_KINETIC, _LAGRANGIAN):
        return {}
    roller_mass = m_prime if m_prime in equation.free_symbols else m
    kinetic, spring = _terms_of_machine(roller_mass)
    return kinetic if equation.lhs == _KINETIC else kinetic | {"spring": (spring,)}


def belongs_to(part: str, equation: sp.Eq) -> bool:
    """Return whether the left side of an equation belongs to a part of the machine.

    Such a left side has the name of the part in a subscript. U belongs to the spring.

    >>> from ramanujan.derivation import ROUTES
    >>> belongs_to("hoop", ROUTES["newton"]["torques"].equations[0])
    True
    """
    return bool(symbols_of_part(part, equation.lhs)) or (part == "spring" and equation.lhs == _POTENTIAL)


def symbols_of_part(part: str, expression: sp.Basic) -> frozenset[sp.Basic]:
    """Return the symbols and functions of time whose subscript is the part's name."""
    candidates = expression.atoms(sp.Symbol, sp.core.function.AppliedUndef)
    return frozenset(atom for atom in candidates if str(atom).removesuffix("(t)").endswith(f"_{part}"))


@cache
def _terms_of_machine(roller_mass: sp.Symbol) -> tuple[dict[str, tuple[sp.Expr, ...]], sp.Expr]:
    """Return the terms of T by body, and the term of the spring in ℒ."""
    bodies = machine(roller_mass)
    kinetic = {}
    for body in bodies.bodies:
        kinetic[body.name] = (body.translation, body.rotation) if body.rotation != 0 else (body.translation,)
    return kinetic, -bodies.potential_energy
