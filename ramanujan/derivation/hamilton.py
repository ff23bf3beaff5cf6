"""Hamilton: two of the three canonical momenta are conserved, so one degree of freedom remains.

H contains neither X nor Φ. For fixed values of their momenta the machine acts like a single mass M_e. It moves by Rφ
and compresses the spring by 2Rφ:

    H = (p_φ + shift)²/(2M_eR²) + 2kR²φ² + H₀,    shift and H₀ constant,    Ω² = 4k/M_e.
"""

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.model import COORDINATES, MOMENTA, VELOCITIES, M_e, M_x, Machine, R, equation, gather, phi, t
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import ROUTES, Route, Step, compare_factors, insert, margin_text, solve_for, step
from ramanujan.text.translation import _

X_dot, phi_dot, Phi_dot = VELOCITIES
p_phi = MOMENTA[COORDINATES.index(phi)]
H_0 = sp.Symbol("H_0")
"""The constant part of H."""


def legendre_transform(bodies: Machine) -> tuple[dict[sp.Expr, sp.Expr], dict[sp.Expr, sp.Expr], sp.Expr]:
    """Return momentum → ∂ℒ/∂q̇, velocity → its expression in the momenta, and H(q, p) = Σ p q̇ − ℒ.

    >>> from ramanujan.derivation.model import machine
    >>> momenta, velocities, hamiltonian = legendre_transform(machine())
    >>> momenta[MOMENTA[2]]
    3*R**2*m*Derivative(Phi(t), t)/2 - R*m*Derivative(X(t), t)
    """
    lagrangian = bodies.lagrangian
    momenta = {p: lagrangian.diff(v) for p, v in zip(MOMENTA, VELOCITIES, strict=True)}
    solved = sp.hessian(lagrangian, VELOCITIES).inv() * sp.Matrix(MOMENTA)
    velocities = {v: _gather_in_one_fraction(value) for v, value in zip(VELOCITIES, solved, strict=True)}
    # T is quadratic in the velocities, so Σ p q̇ = 2T and Σ p q̇ − ℒ = ½ Σ p q̇ + U. No expansion is necessary.
    twice_kinetic = sum(p * velocities[v] for p, v in zip(MOMENTA, VELOCITIES, strict=True))
    kinetic = gather(twice_kinetic / 2, MOMENTA)
    # One term each for p_φ², p_φ and the products of the other momenta.
    square, linear, rest = (kinetic.coeff(p_phi, power) for power in (2, 1, 0))
    return momenta, velocities, square * p_phi**2 + sp.factor(linear) * p_phi + rest + bodies.potential_energy


def reduce_to_one_degree(hamiltonian: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return M_e, shift and H₀ of H = (p_φ + shift)²/(2M_eR²) + U(φ) + H₀, by completing the square in p_φ.

    >>> from ramanujan.derivation.model import machine
    >>> reduce_to_one_degree(legendre_transform(machine())[2])[0]
    (32*m**2 + 49*m*m_prime + 18*m_prime**2)/(2*(7*m + 6*m_prime))
    """
    constant = hamiltonian.subs(p_phi, 0).as_independent(phi, as_Add=True)[0]
    # Taylor coefficients in p_φ.
    square = hamiltonian.diff(p_phi, 2) / 2
    linear = hamiltonian.diff(p_phi).subs(p_phi, 0)
    effective_mass = sp.factor(1 / (2 * square * R**2))
    shift = sp.factor(linear / (2 * square))
    return effective_mass, shift, _gather_in_one_fraction(constant - linear**2 / (4 * square))


@ROUTES.add("hamilton")
def build(bodies: Machine) -> Route:
    """Return the route: Legendre transform, Hamilton's equations, one degree of freedom, Ω²."""
    momenta, velocities, hamiltonian = legendre_transform(bodies)
    rates = {p.diff(t): -hamiltonian.diff(q) for p, q in zip(MOMENTA, COORDINATES, strict=True)}
    effective_mass, shift, constant = reduce_to_one_degree(hamiltonian)
    acceleration = hamiltonian.diff(p_phi).diff(t).subs(rates)
    frequency = sp.factor(-acceleration / phi)
    stiffness = bodies.potential_energy.diff(phi, 2) / R**2
    # The square of the spring's deformation, divided by that of the displacement Rφ.
    squared_ratio = sp.cancel(bodies.deformation / (R * phi)) ** 2
    one_degree = (p_phi + shift) ** 2 / (2 * M_e * R**2) + bodies.potential_energy + H_0
    steps = (
        _lagrangian_step(bodies),
        _momenta_step(momenta),
        _inversion_step(momenta),
        _velocities_step(velocities),
        _hamiltonian_step(hamiltonian),
        _motion_step(rates, velocities),
        _reduction_step(constant, effective_mass, one_degree),
        _frequency_step(effective_mass, frequency, squared_ratio, rates, stiffness),
    )
    return Route(
        name="hamilton",
        title=_("Hamilton"),
        idea=_("energies and momenta; two momenta are constant from the start"),
        steps=steps,
        natural_frequency_squared=frequency,
        cells=CELLS,
    )


def _lagrangian_step(bodies: Machine) -> Step:
    return step(
        "lagrangian",
        _("Start from the Lagrangian"),
        _(
            "The Lagrangian $\\mathcal L=T-U$ is written in three independent coordinates. The rolling constraints "
            "are already built in."
        ),
        equation("L", bodies.lagrangian),
        operations=(r"T-U",),
    )


def _momenta_step(momenta: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "momenta",
        _("Find the momenta"),
        _("Each coordinate $q$ has a canonical momentum, $p_q=\\partial\\mathcal L/\\partial\\dot q$."),
        *(equation(p, value) for p, value in momenta.items()),
        operations=tuple(rf"\partial\mathcal{{L}}/\partial {latex(velocity)}" for velocity in VELOCITIES),
    )


def _inversion_step(momenta: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "inversion",
        _("Solve for the velocities, one after the other"),
        _(
            "The momenta are linear in the velocities, $p=M\\dot q$. Solve that of $\\Phi$ for $\\dot\\Phi$ and "
            "insert it into that of $X$. Solve the result for $\\dot X$ and insert it into that of $\\varphi$: "
            "only $\\dot\\varphi$ is left."
        ),
        *_invert_momenta(momenta),
        underlined_terms=("", "left 2, right 1", "", "left 2, right 1"),
        operations=(solve_for(Phi_dot), insert(Phi_dot), solve_for(X_dot), insert(X_dot)),
    )


def _velocities_step(velocities: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "velocities",
        _("Collect the velocities"),
        _(
            "Solve the last line for $\\dot\\varphi$, then go back to $\\dot X$ and $\\dot\\Phi$. This always "
            "works, because $T$ is positive for every motion."
        ),
        *(equation(velocity, velocities[velocity]) for velocity in (phi_dot, X_dot, Phi_dot)),
        operations=(solve_for(phi_dot), insert(phi_dot), insert(X_dot)),
    )


def _hamiltonian_step(hamiltonian: sp.Expr) -> Step:
    return step(
        "hamiltonian",
        _("Write down the Hamiltonian"),
        _(
            "The Hamiltonian is $\\mathcal H=\\sum p_q\\dot q-\\mathcal L$, with the velocities expressed by the "
            "momenta. The sum is $2T$, because $T$ is quadratic in the velocities. So $\\mathcal H$ is the energy "
            "$T+U$."
        ),
        equation("H", in_order(*(p * v / 2 for p, v in zip(MOMENTA, VELOCITIES, strict=True)), sp.Symbol("U"))),
        equation("H", hamiltonian),
        operations=(r"\textstyle\sum p_q\dot q-\mathcal{L}", insert(*VELOCITIES, "U")),
    )


def _motion_step(rates: dict[sp.Expr, sp.Expr], velocities: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "motion",
        _("Write down Hamilton’s equations"),
        _(
            "Hamilton’s equations are $\\dot p_q=-\\partial\\mathcal H/\\partial q$ and $\\dot "
            "q=\\partial\\mathcal H/\\partial p_q$. The Hamiltonian contains neither $X$ nor $\\Phi$, so $p_X$ and "
            "$p_\\Phi$ are conserved. $-p_X$ is the momentum of the whole machine, positive to the right. "
            "$p_\\Phi$ is the angular momentum of the top cylinder about its line of contact with the block."
        ),
        *(equation(rate, value) for rate, value in rates.items()),
        equation(phi_dot, velocities[phi_dot]),
        operations=(
            *(rf"-\partial\mathcal{{H}}/\partial {latex(q)}" for q in COORDINATES),
            rf"\partial\mathcal{{H}}/\partial {latex(p_phi)}",
        ),
    )


def _reduction_step(constant: sp.Expr, effective_mass: sp.Expr, one_degree: sp.Expr) -> Step:
    return step(
        "reduction",
        _("Complete the square"),
        _(
            "Complete the square in $p_\\varphi$. The conserved momenta $p_X$ and $p_\\Phi$ only shift "
            "$p_\\varphi$ and add a constant $\\mathcal H_0$. One degree of freedom is left: a mass $M_e$ with the "
            "displacement $R\\varphi$."
        ),
        equation("H", one_degree),
        equation(M_e, effective_mass),
        equation(H_0, constant),
        underlined_terms=("right 1, right 3", "", ""),
        operations=(
            margin_text(_("complete the square")),
            compare_factors(p_phi**2),
            margin_text(_("compare what is constant")),
        ),
    )


def _frequency_step(
    effective_mass: sp.Expr,
    frequency: sp.Expr,
    squared_ratio: sp.Expr,
    rates: dict[sp.Expr, sp.Expr],
    stiffness: sp.Expr,
) -> Step:
    return step(
        "frequency",
        _("Read off the frequency"),
        _(
            "A constant shift of $p_\\varphi$ does not change the frequency. The spring is deformed by "
            "$2R\\varphi$, twice the displacement $R\\varphi$. The mass for this deformation, $M_x$, is therefore "
            "a quarter of $M_e$."
        ),
        equation(M_e * R**2 * phi.diff(t, 2), rates[p_phi.diff(t)]),
        equation(model.Omega_squared, stiffness / M_e),
        equation(M_x, sp.factor(effective_mass / squared_ratio)),
        equation(model.Omega_squared, frequency),
        operations=(insert(p_phi.diff(t)), compare_factors(phi), rf"\div {latex(squared_ratio)}", insert(M_e)),
    )


def _invert_momenta(momenta: dict[sp.Expr, sp.Expr]) -> tuple[sp.Eq, ...]:
    """Return the lines from p = Mq̇ to one equation for φ̇: the equations of p_Φ and p_X are solved and inserted."""
    p_X, p_phi, p_Phi = MOMENTA
    (solved_Phi_dot,) = sp.solve(momenta[p_Phi] - p_Phi, Phi_dot)
    p_X_without_Phi = momenta[p_X].subs(Phi_dot, solved_Phi_dot)
    (solved_X_dot,) = sp.solve(p_X_without_Phi - p_X, X_dot)
    p_phi_without_X = momenta[p_phi].subs(X_dot, solved_X_dot)
    # The terms without velocities are moved to the left side.
    constant_of_X = p_X_without_Phi.subs({X_dot: 0, phi_dot: 0})
    constant_of_phi = p_phi_without_X.subs(phi_dot, 0)
    return (
        equation(Phi_dot, _gather_in_one_fraction(solved_Phi_dot, VELOCITIES)),
        equation(p_X - sp.factor(constant_of_X), gather(p_X_without_Phi - constant_of_X)),
        equation(X_dot, _gather_in_one_fraction(solved_X_dot, VELOCITIES)),
        equation(p_phi - sp.factor(constant_of_phi), gather(p_phi_without_X - constant_of_phi)),
    )


def _gather_in_one_fraction(polynomial: sp.Expr, others: tuple[sp.Expr, ...] = ()) -> sp.Expr:
    """Return a polynomial in the momenta and other symbols over one denominator, with a gathered numerator."""
    unknowns = MOMENTA + others
    numerator, denominator = sp.fraction(sp.together(gather(polynomial, unknowns)))
    return gather(numerator, unknowns) / denominator


CELLS = {
    "momenta": """\
p_X, p_phi, p_Phi = p = sp.symbols("p_X p_varphi p_Phi")
momenta = [L.diff(v) for v in q_dot]
momenta""",
    "velocities": """\
velocities = sp.solve([symbol - value for symbol, value in zip(p, momenta)], q_dot, dict=True)[0]
velocities""",
    "hamiltonian": """\
H = sp.factor(sum(symbol * v for symbol, v in zip(p, q_dot)).subs(velocities) - L.subs(velocities))
H""",
    "motion": """\
p_dot = {symbol: -sp.cancel(H.diff(x)) for symbol, x in zip(p, q)}
assert p_dot[p_X] == p_dot[p_Phi] == 0
phi_dot = sp.factor(H.diff(p_phi))
p_dot, phi_dot""",
    "reduction": """\
M_e = sp.factor(1 / (R**2 * H.diff(p_phi, 2)))
shift = sp.factor(phi_dot.subs(p_phi, 0) * M_e * R**2)
H_0 = sp.cancel(H - (p_phi + shift) ** 2 / (2 * M_e * R**2) - U.doit())
assert not H_0.has(p_phi, phi)
M_e, shift, sp.factor(H_0)""",
    "frequency": """\
phi_ddot = sum(phi_dot.diff(symbol) * p_dot[symbol] for symbol in p)
Omega_squared = sp.factor(-phi_ddot / phi)
Omega_squared""",
}
"""The notebook: step key → plain SymPy that repeats the step."""
