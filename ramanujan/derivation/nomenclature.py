"""What each symbol means, in which unit, and which way it counts: the list that goes with every route."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from sympy.core.function import AppliedUndef

from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Route
from ramanujan.derivation.symbols import (
    MOMENTA,
    M_e,
    M_x,
    Omega_clamped_squared,
    Omega_squared,
    Phi,
    R,
    X,
    epsilon,
    epsilon_star,
    k,
    m,
    m_prime,
    phi,
)


@dataclass(frozen=True)
class Entry:
    """A symbol, or a letter with the name of a body as its subscript, and what it means.

    Parameters
    ----------
    symbol : as it occurs in equations; of a letter with a subscript, one of them
    meaning : a phrase, Markdown with $…$
    """

    symbol: sp.Basic
    meaning: str

    @property
    def latex(self) -> str:
        """The symbol as LaTeX, the name of a body written as $\\mathrm{body}$."""
        return latex(self.symbol)


_MACHINE = (
    Entry(X, "displacement of the block relative to the ground, positive to the left [m]"),
    Entry(phi, "angle of the hoop and of the lower cylinder, positive clockwise [rad]"),
    Entry(Phi, "angle of the top cylinder, positive clockwise [rad]"),
    Entry(m, "mass of the block, of the slab and of the top cylinder [kg]"),
    Entry(m_prime, "mass of the hoop, and mass of the lower cylinder [kg]"),
    Entry(k, "stiffness of the spring [N/m]"),
    Entry(R, "radius of the three rolling bodies [m]"),
)
"""What every route speaks of."""

_OTHERS = (
    Entry(sp.Symbol("v_body"), "velocity of the centre of a body relative to the ground, positive to the right [m/s]"),
    Entry(sp.Symbol("a_body"), "acceleration of the centre of a body, positive to the right [m/s²]"),
    Entry(sp.Symbol("alpha_body"), "angular acceleration of a rolling body, positive clockwise [rad/s²]"),
    Entry(sp.Symbol("S_body"), "friction force of the slab on a roller, positive to the right [N]"),
    Entry(sp.Symbol("F_body"), "friction force of the block on a roller, positive to the right [N]"),
    Entry(sp.Symbol("T_body"), "kinetic energy of a body [J]"),
    Entry(sp.Symbol("T"), "kinetic energy of the machine [J]"),
    Entry(sp.Symbol("U"), "potential energy of the spring [J]"),
    Entry(sp.Symbol("L"), "Lagrangian $T-U$ [J]"),
    Entry(sp.Symbol("H"), "Hamiltonian, the energy in terms of coordinates and momenta [J]"),
    Entry(sp.Symbol("H_0"), "the part of the Hamiltonian that stays constant [J]"),
    *(
        Entry(p, f"momentum that belongs to ${latex(q)}$ [{unit}]")
        for p, q, unit in zip(MOMENTA, (X, phi, Phi), ("kg·m/s", "kg·m²/s", "kg·m²/s"), strict=True)
    ),
    Entry(Omega_squared, "square of the natural angular frequency [rad²/s²]"),
    Entry(Omega_clamped_squared, "the same for the machine whose block and top cylinder are held [rad²/s²]"),
    Entry(epsilon, "mass ratio $m'/m$"),
    Entry(epsilon_star, "mass ratio at which $\\Omega^2=k/m$"),
    Entry(M_e, "effective mass for the path $R\\varphi$ [kg]"),
    Entry(M_x, "effective mass for the deformation $2R\\varphi$ of the spring [kg]"),
    Entry(sp.Symbol("M_clamped"), "effective mass for $R\\varphi$ while block and top cylinder are held [kg]"),
    Entry(sp.Symbol("xi"), "share of the block, $\\dot X/(R\\dot\\varphi)$"),
    Entry(sp.Symbol("eta"), "share of the top cylinder, $\\dot\\Phi/\\dot\\varphi$"),
    Entry(sp.Symbol("M"), "mass matrix, in the order $X$, $\\varphi$, $\\Phi$"),
    Entry(sp.Symbol("K"), "stiffness matrix, in the same order"),
    Entry(sp.Symbol("Lambda"), "eigenvalue of $K$ relative to $M$, a squared angular frequency [rad²/s²]"),
    Entry(sp.Symbol("v"), "mode shape: how far $X$, $\\varphi$ and $\\Phi$ move together"),
)

DOTS = "A dot is a derivative with respect to time."


def nomenclature(route: Route) -> tuple[Entry, ...]:
    """Return the symbols of a route in a fixed order: those of the machine, then the others that its steps contain.

    >>> from ramanujan.derivation import ROUTES
    >>> [entry.latex for entry in nomenclature(ROUTES["energy"])][:4]
    ['X', '\\\\varphi', '\\\\Phi', 'm']
    """
    present = set(_names(step.equations for step in route.steps))
    present.update(_names(step.present.equations for step in route.steps if step.present))
    return (*_MACHINE, *(entry for entry in _OTHERS if _name(entry.symbol) in present))


def _names(equations: Iterable[tuple[sp.Eq, ...]]) -> Iterable[str]:
    for each in equations:
        for equation in each:
            for atom in equation.atoms(sp.Symbol, AppliedUndef, sp.MatrixSymbol):
                yield _name(atom)


def _name(atom: sp.Basic) -> str:
    """Return a symbol's name, in which the names of all bodies become one word, and the three roots Λ one letter."""
    name = atom.func.__name__ if isinstance(atom, AppliedUndef) else atom.name
    letter, _, subscript = name.partition("_")
    if subscript in ("block", "hoop", "cylinder", "slab", "top"):
        return f"{letter}_body"
    return letter if subscript.isdigit() and letter == "Lambda" else name
