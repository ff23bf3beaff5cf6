"""What each body and the spring contribute to T and ℒ, and which symbols belong to each of these parts.

The routes derive the energies; `printers` and the pages decide how they look.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from ramanujan.derivation.symbols import m, m_prime, machine
from ramanujan.translation import _

PARTS = {
    "block": _("block"),
    "hoop": _("hoop"),
    "cylinder": _("lower cylinder"),
    "slab": _("slab"),
    "spring": _("spring"),
    "top": _("top cylinder"),
}
"""The five bodies and the spring: id → label."""

_KINETIC, _POTENTIAL, _LAGRANGIAN = sp.symbols("T U L")


def terms(equation: sp.Eq) -> dict[str, tuple[sp.Expr, ...]]:
    """Return the terms that each part contributes to the T or ℒ that an equation states, not multiplied out.

    Their sum is the equation's right side. Empty for an equation that states neither.

    Parameters
    ----------
    equation : in symbols, from a route

    >>> from ramanujan.derivation import ROUTES
    >>> terms(ROUTES["energy"]["energies"].equations[0])["block"]
    (m*Derivative(X(t), t)**2/2,)
    """
    if equation.lhs not in (_KINETIC, _LAGRANGIAN):
        return {}
    roller_mass = m_prime if m_prime in equation.free_symbols else m
    kinetic, spring = _terms(roller_mass)
    return kinetic if equation.lhs == _KINETIC else kinetic | {"spring": (spring,)}


def belongs_to(part: str, equation: sp.Eq) -> bool:
    """Tell whether an equation is about a part: its left side names it, or is the energy of the spring.

    >>> from ramanujan.derivation import ROUTES
    >>> belongs_to("hoop", ROUTES["newton"]["torques"].equations[0])
    True
    """
    return bool(names(part, equation.lhs)) or (part == "spring" and equation.lhs == _POTENTIAL)


def names(part: str, expression: sp.Basic) -> frozenset[sp.Basic]:
    """Return the symbols and functions of time whose subscript is the part's name."""
    candidates = expression.atoms(sp.Symbol, sp.core.function.AppliedUndef)
    return frozenset(atom for atom in candidates if _name(atom).endswith(f"_{part}"))


def _name(atom: sp.Basic) -> str:
    return atom.name if isinstance(atom, sp.Symbol) else atom.func.__name__


@cache
def _terms(roller_mass: sp.Symbol) -> tuple[dict[str, tuple[sp.Expr, ...]], sp.Expr]:
    bodies = machine(roller_mass)
    kinetic = {body.name: tuple(e for e in (body.translation, body.rotation) if e != 0) for body in bodies.bodies}
    return kinetic, -bodies.potential_energy
