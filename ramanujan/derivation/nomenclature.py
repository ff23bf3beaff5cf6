"""The list of symbols of a route: meaning, unit and positive direction of each symbol."""

import sympy as sp
from sympy.core.function import AppliedUndef

from ramanujan.derivation import model
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Route
from ramanujan.text.translation import _

_MACHINE = {
    model.X: _("displacement of the block relative to the ground, positive to the left [m]"),
    model.phi: _("angle of the hoop and of the lower cylinder, positive clockwise [rad]"),
    model.Phi: _("angle of the top cylinder, positive clockwise [rad]; the paper writes $\\phi$"),
    model.m: _("mass of the block, of the slab and of the top cylinder [kg]"),
    model.m_prime: _("mass of the hoop, and mass of the lower cylinder [kg]"),
    model.k: _("stiffness of the spring [N/m]"),
    model.R: _("radius of the three rolling bodies [m]"),
}
"""The symbols of the machine, which are in the list of every route."""

_OTHERS = {
    sp.Symbol("v_body"): _("velocity of the centre of a body relative to the ground, positive to the right [m/s]"),
    sp.Symbol("I_body"): _("moment of inertia of a rolling body about its axis [kg·m²]"),
    sp.Symbol("x"): _("compression of the spring [m]"),
    sp.Symbol("a_body"): _("acceleration of the centre of a body, positive to the right [m/s²]"),
    sp.Symbol("alpha_body"): _("angular acceleration of a rolling body, positive clockwise [rad/s²]"),
    sp.Symbol("S_body"): _("friction force that the slab exerts on a roller, positive to the right [N]"),
    sp.Symbol("F_body"): _("friction force that the block exerts on a roller, positive to the right [N]"),
    sp.Symbol("T_body"): _("kinetic energy of a body [J]"),
    sp.Symbol("T"): _("kinetic energy of the machine [J]"),
    sp.Symbol("U"): _("potential energy of the spring [J]"),
    sp.Symbol("L"): _("Lagrangian $T-U$ [J]"),
    sp.Symbol("H"): _("Hamiltonian, the energy in terms of coordinates and momenta [J]"),
    sp.Symbol("H_0"): _("constant part of the Hamiltonian [J]"),
    **{
        p: _("canonical momentum of {coordinate} [{unit}]").format(coordinate=f"${latex(q)}$", unit=unit)
        for p, q, unit in zip(model.MOMENTA, model.COORDINATES, ("kg·m/s", "kg·m²/s", "kg·m²/s"), strict=True)
    },
    model.Omega_squared: _("square of the natural angular frequency [rad²/s²]"),
    model.Omega_clamped_squared: _(
        "square of the natural angular frequency while block and top cylinder are held still [rad²/s²]"
    ),
    model.epsilon: _("mass ratio $m'/m$: a lower roller’s mass divided by the mass of each other body"),
    model.epsilon_star: _("mass ratio at which $\\Omega^2=k/m$"),
    model.M_e: _("effective mass for the displacement $R\\varphi$ of the lower rollers [kg]"),
    model.M_x: _("effective mass for the deformation $2R\\varphi$ of the spring [kg]"),
    sp.Symbol("M_clamped"): _("effective mass for $R\\varphi$ while block and top cylinder are held still [kg]"),
    sp.Symbol("xi"): _("motion of the block relative to that of the lower rollers, $\\dot X/(R\\dot\\varphi)$"),
    sp.Symbol("eta"): _(
        "rotation of the top cylinder relative to that of the lower rollers, $\\dot\\Phi/\\dot\\varphi$"
    ),
    sp.Symbol("M"): _("mass matrix, in the order $X$, $\\varphi$, $\\Phi$"),
    sp.Symbol("K"): _("stiffness matrix, in the order $X$, $\\varphi$, $\\Phi$"),
    sp.Symbol("omega"): _("angular frequency of a normal mode [rad/s]; $\\omega^2$ is an eigenvalue of $K$ and $M$"),
    sp.Symbol("v"): _("mode shape: the amplitudes of $X$, $\\varphi$ and $\\Phi$ in proportion"),
}

DOTS = _("A dot denotes the derivative with respect to time.")


def nomenclature(route: Route) -> dict[str, str]:
    """Return the symbols of a route, LaTeX → meaning: first the machine's symbols, then other symbols of its steps.

    The word “body” replaces the name of a body in a subscript: v_body stands for v_hoop, v_slab and the others.
    A meaning is a phrase, Markdown with $…$.

    >>> from ramanujan.derivation import ROUTES
    >>> list(nomenclature(ROUTES["energy"]))[:4]
    ['X', '\\\\varphi', '\\\\Phi', 'm']
    """
    present = set()
    for step in route.steps:
        # A step with numbers may have other symbols. Which numbers does not matter.
        for variant in (step, step.for_numbers(Numbers(1.0, 1.0, 1.0))):
            for equation in variant.equations:
                present |= {_name(atom) for atom in equation.atoms(sp.Symbol, AppliedUndef, sp.MatrixSymbol)}
    others = {symbol: meaning for symbol, meaning in _OTHERS.items() if _name(symbol) in present}
    return {latex(symbol): meaning for symbol, meaning in (_MACHINE | others).items()}


def _name(atom: sp.Basic) -> str:
    """Return a symbol's name, with the word body for each body's name, and one letter for the three roots ω."""
    name = str(atom).removesuffix("(t)")
    letter, _bar, subscript = name.partition("_")
    if subscript in ("block", "hoop", "cylinder", "slab", "top"):
        return f"{letter}_body"
    return letter if subscript.isdigit() else name
