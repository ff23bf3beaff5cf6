"""Matrix: derive the mass and stiffness matrices from the energies, and the three modes from det(K − ω²M) = 0.

    T = ½ q̇ᵀM q̇,    U = ½ qᵀK q,    q = (X, φ, Φ),    M q̈ + K q = 0

K has rank one, so two modes have zero frequency. The third can be found without a determinant: Ω² = 4kR²(M⁻¹)_φφ.
"""

from collections import Counter
from dataclasses import dataclass
from functools import cache

import sympy as sp

from ramanujan.derivation.lagrangian import energies_step
from ramanujan.derivation.model import (
    ACCELERATIONS,
    COORDINATES,
    VELOCITIES,
    Machine,
    Omega_squared,
    equation,
    gather,
    machine,
    t,
)
from ramanujan.derivation.steps import ROUTES, Route, Step, insert, margin_text, solve_for, step
from ramanujan.text.translation import _

omega = sp.Symbol("omega", real=True)
"""Angular frequency of a mode: ω² is an eigenvalue of K relative to M."""

_PHI = 1
"""Index of φ in the order X, φ, Φ."""
_UNIT = sp.ImmutableMatrix([0, 1, 0])
_M, _K = sp.MatrixSymbol("M", 3, 3), sp.MatrixSymbol("K", 3, 3)


@dataclass(frozen=True)
class Modes:
    """M and K, det(K − ω²M), its roots with their multiplicities, M⁻¹, and the modes in the order X, φ, Φ."""

    mass_matrix: sp.ImmutableMatrix
    stiffness_matrix: sp.ImmutableMatrix
    determinant: sp.Expr
    eigenvalues: dict[sp.Expr, int]
    inverse_mass_matrix: sp.ImmutableMatrix
    zero_modes: tuple[sp.ImmutableMatrix, ...]
    mode_shape: sp.ImmutableMatrix

    @property
    def natural_frequency_squared(self) -> sp.Expr:
        """Ω² = K_φφ (M⁻¹)_φφ, the shortcut for a stiffness matrix of rank one."""
        return sp.factor(self.stiffness_matrix[_PHI, _PHI] * self.inverse_mass_matrix[_PHI, _PHI])


@cache
def find_modes(bodies: Machine) -> Modes:
    """Return the mass and stiffness matrices, which are second derivatives of the energies, and the modes.

    >>> from ramanujan.derivation.model import machine
    >>> find_modes(machine()).eigenvalues[sp.S.Zero]
    2
    """
    mass = _second_derivatives(bodies.kinetic_energy, VELOCITIES)
    stiffness = _second_derivatives(bodies.potential_energy, COORDINATES)
    squared = sp.Symbol("squared")
    determinant = sp.factor((stiffness - squared * mass).det())
    gathered = [gather(factor, (squared,)) for factor in sp.Mul.make_args(determinant)]
    roots = sp.roots(determinant, squared)
    zeros_first = sorted(roots, key=lambda root: root != 0)
    inverse = sp.ImmutableMatrix(mass.inv().applyfunc(sp.factor))
    # For a rank-one K the oscillating mode is a multiple of M⁻¹e_φ. Its element φ is set to 1.
    column = inverse[:, _PHI]
    return Modes(
        mass_matrix=mass,
        stiffness_matrix=stiffness,
        determinant=sp.Mul(*gathered).subs(squared, omega**2),
        eigenvalues={sp.factor(root): roots[root] for root in zeros_first},
        inverse_mass_matrix=inverse,
        zero_modes=tuple(sp.ImmutableMatrix(vector) for vector in stiffness.nullspace()),
        mode_shape=sp.ImmutableMatrix((column / column[_PHI]).applyfunc(sp.factor)),
    )


@cache
def conserved_momenta() -> dict[sp.Expr, sp.Expr]:
    """Return p_q = ∂ℒ/∂q̇ for each coordinate q that ℒ does not contain.

    A shift of this coordinate costs no energy: it is the direction of a zero-frequency mode. By Noether's theorem its
    momentum is conserved. Keys are X (the whole machine glides) and Φ (the top cylinder rolls freely).
    """
    lagrangian = machine().lagrangian
    return {q: lagrangian.diff(q.diff(t)) for q in COORDINATES if lagrangian.diff(q) == 0}


@ROUTES.add("matrix")
def build(bodies: Machine) -> Route:
    """Return the route: matrices, determinant, spectrum, rank-one shortcut, mode shapes."""
    result = find_modes(bodies)
    (oscillating,) = (root for root in result.eigenvalues if root != 0)
    q_ddot = sp.ImmutableMatrix(ACCELERATIONS)
    q = sp.ImmutableMatrix(COORDINATES)
    # Each as often as its multiplicity.
    eigenvalues = sp.Tuple(*Counter(result.eigenvalues).elements())
    stiffness = result.stiffness_matrix[_PHI, _PHI]
    steps = (
        energies_step(
            bodies,
            _(
                "The kinetic energy $T$ is a quadratic form in the velocities. The potential energy $U$ is a quadratic "
                "form in the coordinates. The compression of the spring is $2R\\varphi$."
            ),
        ),
        _matrices_step(result),
        _motion_step(result, q, q_ddot),
        _determinant_step(result),
        _spectrum_step(eigenvalues, oscillating),
        _zero_modes_step(result),
        _shortcut_step(result, stiffness),
        _mode_shape_step(result),
    )
    return Route(
        name="matrix",
        title=_("Matrix"),
        idea=_("mass and stiffness matrix; all three modes at once"),
        steps=steps,
        natural_frequency_squared=oscillating,
        cells=CELLS,
    )


def _matrices_step(result: Modes) -> Step:
    return step(
        "matrices",
        _("Take the second derivatives"),
        _(
            "The second derivatives of $T$ with respect to the velocities form the mass matrix $M$, in the order "
            "$X$, $\\varphi$, $\\Phi$. Those of $U$ with respect to the coordinates form the stiffness matrix $K$."
        ),
        equation(_M, result.mass_matrix),
        equation(_K, result.stiffness_matrix),
        operations=(
            r"\partial^2T/\partial\dot q_i\,\partial\dot q_j",
            r"\partial^2U/\partial q_i\,\partial q_j",
        ),
    )


def _motion_step(result: Modes, q: sp.ImmutableMatrix, q_ddot: sp.ImmutableMatrix) -> Step:
    return step(
        "motion",
        _("Write down the equations of motion"),
        _(
            "Since $M$ and $K$ are constant, Lagrange’s three equations are one matrix equation, $M\\ddot q=-Kq$. "
            "The inertia is on the left, the restoring force on the right."
        ),
        equation(
            sp.MatMul(result.mass_matrix, q_ddot, evaluate=False),
            sp.MatMul(-result.stiffness_matrix, q, evaluate=False),
        ),
        operations=(insert(_M, _K),),
    )


def _determinant_step(result: Modes) -> Step:
    return step(
        "determinant",
        _("Look for the modes"),
        _(
            "In a normal mode all coordinates oscillate together: insert $q=v\\cos\\omega t$. This gives "
            "$(K-\\omega^2M)v=0$, which has a solution other than $v=0$ only if the determinant vanishes."
        ),
        equation(sp.Determinant(result.stiffness_matrix - omega**2 * result.mass_matrix), sp.S.Zero),
        equation(result.determinant, sp.S.Zero),
        operations=(insert(r"q=v\cos\omega t"), margin_text(_("factor it"))),
    )


def _spectrum_step(eigenvalues: sp.Tuple, oscillating: sp.Expr) -> Step:
    return step(
        "spectrum",
        _("Find the three roots"),
        _(
            "Zero is a double root: two modes have no restoring force. The third root is the square of the natural "
            "frequency."
        ),
        equation(sp.Tuple(*(frequency**2 for frequency in sp.symbols("omega_1:4"))), eigenvalues),
        equation(Omega_squared, oscillating),
        operations=(solve_for(omega**2), margin_text(_("the third root"))),
    )


def _zero_modes_step(result: Modes) -> Step:
    return step(
        "zero_modes",
        _("Look at the two zero modes"),
        _(
            "The zero modes are the vectors $v$ with $Kv=0$: these motions do not deform the spring. In the first "
            "one the whole machine glides. Its momentum to the right, $-p_X$, is conserved. In the second one the top "
            "cylinder rolls freely. Then $p_\\Phi$, the cylinder’s angular momentum about its line of contact with "
            "the block, is conserved."
        ),
        *(
            equation(sp.MatMul(result.stiffness_matrix, mode, evaluate=False), sp.ImmutableMatrix.zeros(3, 1))
            for mode in result.zero_modes
        ),
        operations=tuple(r"Kv" for _mode in result.zero_modes),
    )


def _shortcut_step(result: Modes, stiffness: sp.Expr) -> Step:
    return step(
        "shortcut",
        _("Avoid the determinant"),
        _(
            "The matrix $K$ has rank one: it maps every vector to a multiple of $e_\\varphi$, the unit vector of "
            "$\\varphi$. So the oscillating mode is a multiple of {vector}, and its frequency needs no "
            "determinant: {shortcut}."
        ).format(
            vector="$M^{-1}e_\\varphi$", shortcut="$\\Omega^2=K_{\\varphi\\varphi}\\,(M^{-1})_{\\varphi\\varphi}$"
        ),
        equation(_K, sp.MatMul(stiffness, _UNIT, _UNIT.T, evaluate=False)),
        equation(_M.I, result.inverse_mass_matrix),
        equation(Omega_squared, result.natural_frequency_squared),
        operations=(margin_text(_("rank one")), margin_text(_("invert {what}"), _M), insert(_K, _M.I)),
    )


def _mode_shape_step(result: Modes) -> Step:
    return step(
        "mode_shape",
        _("Read off the mode shape"),
        _(
            "A mode is determined up to a factor, so the entry of $\\varphi$ may be set to 1. Block and top "
            "cylinder oscillate in proportion to it."
        ),
        equation("v", result.mode_shape),
        operations=(r"M^{-1}e_\varphi\div(M^{-1})_{\varphi\varphi}",),
    )


def _second_derivatives(energy: sp.Expr, variables: tuple[sp.Expr, ...]) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix(sp.hessian(energy, variables)).applyfunc(sp.factor)


CELLS = {
    "matrices": """\
mass_matrix, stiffness_matrix = sp.hessian(T, q_dot).applyfunc(sp.factor), sp.hessian(U, q)
mass_matrix, stiffness_matrix""",
    "determinant": """\
omega_squared = sp.Symbol("omega^2")
determinant = sp.factor((stiffness_matrix - omega_squared * mass_matrix).det())
sp.Eq(determinant, 0)""",
    "spectrum": """\
spectrum = sp.roots(determinant, omega_squared)
assert spectrum[sp.S.Zero] == 2
spectrum""",
    "zero_modes": """\
stiffness_matrix.nullspace()""",
    "shortcut": """\
assert stiffness_matrix.rank() == 1
inverse = mass_matrix.inv().applyfunc(sp.factor)
Omega_squared = sp.factor(stiffness_matrix[1, 1] * inverse[1, 1])
inverse, Omega_squared""",
    "mode_shape": """\
mode_shape = (inverse[:, 1] / inverse[1, 1]).applyfunc(sp.factor)
residual = (stiffness_matrix - Omega_squared * mass_matrix) * mode_shape
assert residual.applyfunc(sp.simplify).is_zero_matrix
mode_shape""",
}
"""The notebook: step key → plain SymPy that repeats the step."""
