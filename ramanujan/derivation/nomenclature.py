"""The list of symbols of a route: what each one means, its unit, and its positive direction."""

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
from ramanujan.translation import _


@dataclass(frozen=True)
class Entry:
    """A symbol, or a letter whose subscript is the name of a body, and its meaning.

    Parameters
    ----------
    symbol : as in the equations; for a letter with a body as its subscript, one such symbol
    meaning : a phrase, Markdown with $…$
    """

    symbol: sp.Basic
    meaning: str

    @property
    def latex(self) -> str:
        """The symbol as LaTeX, the name of a body written as the word “body”."""
        return latex(self.symbol)


_MACHINE = (
    Entry(X, _("displacement of the block relative to the ground, positive to the left [m]")),
    Entry(phi, _("angle of the hoop and of the lower cylinder, positive clockwise [rad]")),
    Entry(Phi, _("angle of the top cylinder, positive clockwise [rad]; the paper writes $\\phi$")),
    Entry(m, _("mass of the block, of the slab and of the top cylinder [kg]")),
    Entry(m_prime, _("mass of the hoop, and mass of the lower cylinder [kg]")),
    Entry(k, _("stiffness of the spring [N/m]")),
    Entry(R, _("radius of the three rolling bodies [m]")),
)
"""The symbols of every route."""

_OTHERS = (
    Entry(
        sp.Symbol("v_body"), _("velocity of the centre of a body relative to the ground, positive to the right [m/s]")
    ),
    Entry(sp.Symbol("I_body"), _("moment of inertia of a rolling body about its axis [kg·m²]")),
    Entry(sp.Symbol("x"), _("compression of the spring [m]")),
    Entry(sp.Symbol("a_body"), _("acceleration of the centre of a body, positive to the right [m/s²]")),
    Entry(sp.Symbol("alpha_body"), _("angular acceleration of a rolling body, positive clockwise [rad/s²]")),
    Entry(sp.Symbol("S_body"), _("friction force that the slab exerts on a roller, positive to the right [N]")),
    Entry(sp.Symbol("F_body"), _("friction force that the block exerts on a roller, positive to the right [N]")),
    Entry(sp.Symbol("T_body"), _("kinetic energy of a body [J]")),
    Entry(sp.Symbol("T"), _("kinetic energy of the machine [J]")),
    Entry(sp.Symbol("U"), _("potential energy of the spring [J]")),
    Entry(sp.Symbol("L"), _("Lagrangian $T-U$ [J]")),
    Entry(sp.Symbol("H"), _("Hamiltonian, the energy in terms of coordinates and momenta [J]")),
    Entry(sp.Symbol("H_0"), _("constant part of the Hamiltonian [J]")),
    *(
        Entry(p, _("canonical momentum of {coordinate} [{unit}]").format(coordinate=f"${latex(q)}$", unit=unit))
        for p, q, unit in zip(MOMENTA, (X, phi, Phi), ("kg·m/s", "kg·m²/s", "kg·m²/s"), strict=True)
    ),
    Entry(Omega_squared, _("square of the natural angular frequency [rad²/s²]")),
    Entry(
        Omega_clamped_squared,
        _("square of the natural angular frequency while block and top cylinder are held still [rad²/s²]"),
    ),
    Entry(epsilon, _("mass ratio $m'/m$: a lower roller’s mass divided by the mass of each other body")),
    Entry(epsilon_star, _("mass ratio at which $\\Omega^2=k/m$")),
    Entry(M_e, _("effective mass for the displacement $R\\varphi$ of the lower rollers [kg]")),
    Entry(M_x, _("effective mass for the deformation $2R\\varphi$ of the spring [kg]")),
    Entry(sp.Symbol("M_clamped"), _("effective mass for $R\\varphi$ while block and top cylinder are held still [kg]")),
    Entry(sp.Symbol("xi"), _("motion of the block relative to that of the lower rollers, $\\dot X/(R\\dot\\varphi)$")),
    Entry(
        sp.Symbol("eta"),
        _("rotation of the top cylinder relative to that of the lower rollers, $\\dot\\Phi/\\dot\\varphi$"),
    ),
    Entry(sp.Symbol("M"), _("mass matrix, in the order $X$, $\\varphi$, $\\Phi$")),
    Entry(sp.Symbol("K"), _("stiffness matrix, in the order $X$, $\\varphi$, $\\Phi$")),
    Entry(
        sp.Symbol("omega"), _("angular frequency of a normal mode [rad/s]; $\\omega^2$ is an eigenvalue of $K$ and $M$")
    ),
    Entry(sp.Symbol("v"), _("mode shape: the amplitudes of $X$, $\\varphi$ and $\\Phi$ in proportion")),
)

DOTS = _("A dot denotes the derivative with respect to time.")


def nomenclature(route: Route) -> tuple[Entry, ...]:
    """Return the symbols of a route: those of the machine, then the others that occur in its steps.

    >>> from ramanujan.derivation import ROUTES
    >>> [entry.latex for entry in nomenclature(ROUTES["energy"])][:4]
    ['X', '\\\\varphi', '\\\\Phi', 'm']
    """
    one_machine = dict.fromkeys((m, m_prime, k), sp.S.One)
    present = set(_names(step.equations for step in route.steps))
    present.update(_names(step.present(one_machine).equations for step in route.steps if step.present))
    return (*_MACHINE, *(entry for entry in _OTHERS if _name(entry.symbol) in present))


def _names(equations: Iterable[tuple[sp.Eq, ...]]) -> Iterable[str]:
    for each in equations:
        for equation in each:
            for atom in equation.atoms(sp.Symbol, AppliedUndef, sp.MatrixSymbol):
                yield _name(atom)


def _name(atom: sp.Basic) -> str:
    """Return a symbol's name, with every body's name replaced by the word body, and the three roots ω by one letter."""
    name = atom.func.__name__ if isinstance(atom, AppliedUndef) else atom.name
    letter, _bar, subscript = name.partition("_")
    if subscript in ("block", "hoop", "cylinder", "slab", "top"):
        return f"{letter}_body"
    return letter if subscript.isdigit() else name
