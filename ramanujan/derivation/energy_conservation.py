"""Energy: derive Ω² from the ratio of the two energies (Rayleigh's quotient), without an equation of motion.

The motion of block and top cylinder in the oscillating mode minimizes the kinetic energy for a given φ̇:

    M_e = least value of 2T/(Rφ̇)² over Ẋ and Φ̇,    Ω² = [2U/(Rφ)²]/M_e = 4k/M_e.

The minimum over some variables of a quadratic form is again a quadratic form. Its matrix is a Schur complement.
"""

from dataclasses import replace

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.lagrangian import energies_step
from ramanujan.derivation.model import M_e, M_x, Machine, Omega_squared, Phi, R, X, equation, gather, m_prime, phi, t
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import ROUTES, Route, Step, insert, margin_text, solve_for, step
from ramanujan.text.translation import _

xi, eta = sp.symbols("xi eta", real=True)
"""Shares of block and top cylinder in the motion: ξ = Ẋ/(Rφ̇), η = Φ̇/φ̇."""


def least_inertia(bodies: Machine) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr], sp.Expr]:
    """Return the inertia 2T/(Rφ̇)² as a function of ξ and η, the ξ and η at its minimum, and its least value.

    >>> from ramanujan.derivation.model import machine
    >>> inertia, shares, least = least_inertia(machine())
    >>> shares[eta]
    4*(m + m_prime)/(7*m + 6*m_prime)
    """
    phi_dot = phi.diff(t)
    energy = bodies.kinetic_energy.subs({X.diff(t): xi * R * phi_dot, Phi.diff(t): eta * phi_dot})
    inertia = gather(2 * energy / (R * phi_dot) ** 2, (xi, eta))
    shares = sp.solve([inertia.diff(xi), inertia.diff(eta)], (xi, eta))
    return inertia, {share: sp.factor(value) for share, value in shares.items()}, sp.factor(inertia.subs(shares))


def spin_of_lower_rollers(bodies: Machine) -> sp.Expr:
    """Return the part of M_x that comes from the rotation of the lower rollers: Σ I φ̇²/ẋ² with ẋ = 2Rφ̇.

    >>> from ramanujan.derivation.model import machine
    >>> spin_of_lower_rollers(machine())
    3*m_prime/8
    """
    spin = bodies["hoop"].rotation + bodies["cylinder"].rotation
    return sp.factor(2 * spin / bodies.deformation.diff(t) ** 2)


@ROUTES.add("energy")
def build(bodies: Machine) -> Route:
    """Return the route: energies, Rayleigh's quotient, its least inertia, Ω², and the clamped block's bound."""
    inertia, shares, least = least_inertia(bodies)
    clamped = inertia.subs({xi: 0, eta: 0})
    stiffness = sp.cancel(2 * bodies.potential_energy / (R * phi) ** 2)
    frequency = sp.factor(stiffness / least)
    curvature = sp.ImmutableMatrix(sp.hessian(inertia, (xi, eta)))
    path, speed = R * phi, R * phi.diff(t)
    by_xi, by_eta = (gather(inertia.diff(share), (xi, eta)) for share in (xi, eta))
    (eta_from_xi,) = sp.solve(by_eta, eta)
    steps = (
        energies_step(
            bodies,
            _(
                "All five bodies contribute to the kinetic energy $T$. Only the spring stores potential energy $U$, "
                "because no body moves up or down. Its compression is $2R\\varphi$."
            ),
        ),
        _quotient_step(inertia, path, speed, stiffness),
        _least_step(by_eta, by_xi, curvature, eta_from_xi, shares),
        _frequency_step(frequency, least, stiffness),
        _spring_mass_step(bodies, least, stiffness),
        _bound_step(clamped, least, stiffness),
    )
    return Route(
        name="energy",
        title=_("Energy"),
        idea=_("energy and two momenta are conserved; one equation is left"),
        steps=steps,
        natural_frequency_squared=frequency,
        cells=CELLS,
    )


def _quotient_step(inertia: sp.Expr, path: sp.Expr, speed: sp.Expr, stiffness: sp.Expr) -> Step:
    return step(
        "quotient",
        _("Form Rayleigh’s quotient"),
        _(
            "In a normal mode the largest kinetic energy equals the largest potential energy. The largest "
            "$\\dot\\varphi$ is $\\Omega$ times the largest $\\varphi$. So $\\Omega^2$ is the first ratio below "
            "divided by the second (Rayleigh’s quotient). The second one, the inertia, depends on how fast block "
            "and top cylinder move compared with the rollers: $\\xi=\\dot X/(R\\dot\\varphi)$ and "
            "$\\eta=\\dot\\Phi/\\dot\\varphi$."
        ),
        equation(2 * sp.Symbol("U") / path**2, stiffness),
        equation(2 * sp.Symbol("T") / speed**2, inertia),
        operations=tuple(rf"\div \left(\tfrac12{latex(factor**2)}\right)" for factor in (path, speed)),
    )


def _least_step(
    by_eta: sp.Expr,
    by_xi: sp.Expr,
    curvature: sp.ImmutableMatrix,
    eta_from_xi: sp.Expr,
    shares: dict[sp.Symbol, sp.Expr],
) -> Step:
    return step(
        "least",
        _("Find how block and top cylinder move"),
        _(
            "In a normal mode Rayleigh’s quotient is stationary with respect to $\\xi$ and $\\eta$. Only the "
            "inertia depends on them, so its derivatives must vanish. The matrix of its second derivatives is "
            "positive definite, since its upper left entry and its determinant are positive. So the inertia is "
            "least there."
        ),
        equation(by_eta, sp.S.Zero),
        equation(eta, eta_from_xi),
        equation(by_xi, sp.S.Zero),
        equation(gather(by_xi.subs(eta, eta_from_xi), (xi,)), sp.S.Zero),
        *(equation(share, shares[share]) for share in (xi, eta)),
        equation(sp.Determinant(curvature), sp.factor(curvature.det())),
        underlined_terms=("", "", "left 1, left 2", "left 1", "", "", ""),
        operations=(
            rf"\partial/\partial {latex(eta)}",
            solve_for(eta),
            rf"\partial/\partial {latex(xi)}",
            insert(eta),
            solve_for(xi),
            insert(xi),
            margin_text(_("second derivatives")),
        ),
    )


def _frequency_step(frequency: sp.Expr, least: sp.Expr, stiffness: sp.Expr) -> Step:
    return step(
        "frequency",
        _("Read off the frequency"),
        _(
            "The least inertia is the effective mass $M_e$ for the displacement $R\\varphi$ of the rollers. In "
            "terms of the mass matrix, $M_eR^2$ is a Schur complement."
        ),
        equation(M_e, least),
        equation(Omega_squared, stiffness / M_e),
        equation(Omega_squared, frequency),
        operations=(insert(xi, eta), rf"\div {latex(M_e)}", insert(M_e)),
    )


def _bound_step(clamped: sp.Expr, least: sp.Expr, stiffness: sp.Expr) -> Step:
    return step(
        "bound",
        _("Clamp the block for a lower bound"),
        _(
            "Hold block and top cylinder still, $\\xi=\\eta=0$. The inertia is then larger than the least one, so "
            "the clamped machine oscillates more slowly. Its frequency is a lower bound for $\\Omega$."
        ),
        equation(model.M_clamped - M_e, sp.factor(clamped - least)),
        equation(model.Omega_clamped_squared, sp.factor(stiffness / clamped)),
        operations=(rf"\xi=\eta=0,\ -{latex(M_e)}", rf"\div {latex(model.M_clamped)}"),
    )


def _spring_mass_step(bodies: Machine, least: sp.Expr, stiffness: sp.Expr) -> Step:
    """Return the step to M_x.

    A sentence explains its two terms. For equal masses and with numbers they merge, and the sentence is left out.
    """
    # The square of the spring's deformation, divided by that of the displacement Rφ.
    squared_ratio = sp.cancel(bodies.deformation / (R * phi)) ** 2
    spin = spin_of_lower_rollers(bodies)
    spring_mass = sp.factor(least / squared_ratio)
    reason = _("With the deformation $2R\\varphi$ of the spring as coordinate, the machine acts like one mass $M_x$.")
    spins = _("The term that contains $m'$ alone comes from the rotation of the lower rollers.")
    merged = step(
        "spring_mass",
        _("Find the mass that the spring feels"),
        reason,
        equation(M_x, spin + sp.factor(spring_mass - spin)),
        equation(Omega_squared, stiffness / squared_ratio / M_x),
        operations=(rf"\div {latex(squared_ratio)}", insert(equation(M_e, squared_ratio * M_x))),
    )
    if not spin.has(m_prime):
        return merged
    return replace(merged, reason=f"{reason} {spins}", variant=lambda _numbers: merged)


CELLS = {
    "quotient": """\
xi, eta = sp.symbols("xi eta", real=True)
shares = {X.diff(t): xi * R * phi.diff(t), Phi.diff(t): eta * phi.diff(t)}
inertia = sp.cancel(2 * T.subs(shares) / (R * phi.diff(t)) ** 2)
stiffness = sp.cancel(2 * U / (R * phi) ** 2)
inertia, stiffness""",
    "least": """\
least = sp.solve([inertia.diff(xi), inertia.diff(eta)], [xi, eta], dict=True)[0]
assert sp.hessian(inertia, (xi, eta)).is_positive_definite
least""",
    "frequency": """\
M_e = sp.factor(inertia.subs(least))
Omega_squared = sp.factor(stiffness / M_e)
Omega_squared""",
    "spring_mass": """\
M_x = sp.apart(M_e / 4, m_prime)
assert sp.simplify(k / M_x - Omega_squared) == 0
M_x""",
    "bound": """\
clamped = sp.factor(stiffness / inertia.subs({xi: 0, eta: 0}))
assert sp.factor(Omega_squared - clamped).is_positive
clamped""",
}
"""The notebook: step key → plain SymPy that repeats the step."""
