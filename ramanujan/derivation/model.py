"""The machine as symbols: its bodies, the rolling constraints between them, and the energies that follow.

Every route starts from these bodies. The equations of motion are derived in the routes.

A body has a mass, a shape factor and a position. Its position follows from the surface on which it rolls:

    rolling on a surface       x_centre = x_surface + Rθ     (θ clockwise, x to the right)
    resting on a roller        x_slab   = x_centre  + Rθ
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

m, m_prime, k, R = sp.symbols("m m_prime k R", positive=True)
epsilon, epsilon_star = sp.symbols("varepsilon varepsilon_star", positive=True)
"""ε = m′/m, and ε*, the mass ratio at which Ω² = k/m."""
Omega_squared, Omega_clamped_squared = sp.symbols("Omega_squared Omega_clamped_squared", positive=True)
"""Ω² of the machine, and of the machine with clamped block and top cylinder."""
normalized_frequency_squared = sp.Symbol("normalized_frequency_squared", positive=True)
"""Ω²m/k as one symbol, for a step with its value."""

t = sp.Symbol("t")
X, phi, Phi = (sp.Function(name)(t) for name in ("X", "varphi", "Phi"))
COORDINATES = (X, phi, Phi)
VELOCITIES = tuple(q.diff(t) for q in COORDINATES)
ACCELERATIONS = tuple(q.diff(t, 2) for q in COORDINATES)
MOMENTA = tuple(sp.Function(name)(t) for name in ("p_X", "p_varphi", "p_Phi"))
"""Canonical momenta, in the order of the coordinates."""

M_e, M_x, M_clamped = sp.symbols("M_e M_x M_clamped", positive=True)
"""Effective mass for the rollers' displacement Rφ, for the spring's deformation 2Rφ, and for Rφ when clamped."""

HOOP, SOLID_CYLINDER = sp.Integer(1), sp.Rational(1, 2)
"""Shape factors β = I/(mass·R²)."""


@dataclass(frozen=True)
class Body:
    """A rigid body: ½·mass·ẋ² of its centre plus ½·β·mass·R²·θ̇² about it.

    Parameters
    ----------
    name : one of block, hoop, cylinder, slab, top
    mass : m or m′ [kg]
    displacement : of its centre relative to the ground, to the right [m]
    angle : clockwise rotation θ [rad]; zero for a body that does not roll
    shape_factor : β, dimensionless
    """

    name: str
    mass: sp.Expr
    displacement: sp.Expr
    angle: sp.Expr = sp.S.Zero
    shape_factor: sp.Expr = sp.S.Zero

    @property
    def velocity(self) -> sp.Expr:
        """ẋ, of the centre relative to the ground [m/s]."""
        return self.displacement.diff(t)

    @property
    def moment_of_inertia(self) -> sp.Expr:
        """I = β·mass·R², about the axis of the body [kg·m²]."""
        return self.shape_factor * self.mass * R**2

    @property
    def translation(self) -> sp.Expr:
        """½·mass·ẋ² [J]."""
        return self.mass * self.velocity**2 / 2

    @property
    def rotation(self) -> sp.Expr:
        """½·I·θ̇² [J]."""
        return self.moment_of_inertia * self.angle.diff(t) ** 2 / 2

    @property
    def kinetic_energy(self) -> sp.Expr:
        """Translation plus rotation [J]."""
        return self.translation + self.rotation


@dataclass(frozen=True)
class Machine:
    """The five bodies in the order block, hoop, cylinder, slab, top, and the spring between slab and block."""

    bodies: tuple[Body, ...]

    def __getitem__(self, name: str) -> Body:
        """Return the body with this name."""
        return {body.name: body for body in self.bodies}[name]

    @property
    def deformation(self) -> sp.Expr:
        """The deformation of the spring, positive in compression [m]: the slab's displacement relative to the block."""
        return sp.expand(self["slab"].displacement - self["block"].displacement)

    @property
    def kinetic_parts(self) -> tuple[sp.Expr, ...]:
        """Kinetic energies of translation and rotation [J], body by body."""
        parts: list[sp.Expr] = []
        for body in self.bodies:
            parts += [body.translation, body.rotation]
        return tuple(part for part in parts if part != 0)

    @property
    def kinetic_energy(self) -> sp.Expr:
        """T [J], summed over the bodies."""
        return sp.Add(*(body.kinetic_energy for body in self.bodies))

    @property
    def potential_energy(self) -> sp.Expr:
        """U = ½k·deformation² [J]."""
        return k * self.deformation**2 / 2

    @property
    def lagrangian(self) -> sp.Expr:
        """ℒ = T − U [J], with like terms gathered."""
        return gather(self.kinetic_energy - self.potential_energy)


@cache
def machine(
    roller_mass: sp.Expr = m_prime, hoop: Any = HOOP, cylinder: Any = SOLID_CYLINDER, top: Any = SOLID_CYLINDER
) -> Machine:
    """Return the machine whose positions obey the rolling constraints.

    Parameters
    ----------
    roller_mass : mass of each of the two lower rollers; `m` for the paper's section 1
    hoop, cylinder, top : shape factors β of the three rolling bodies

    Source: paper, figure 1 and the text before eq. (1).

    >>> machine()["slab"].velocity
    2*R*Derivative(varphi(t), t) - Derivative(X(t), t)
    >>> machine().deformation
    2*R*varphi(t)
    """
    block = Body("block", m, -X)
    hoop_body = Body("hoop", roller_mass, _rolling_on(block.displacement, phi), phi, sp.sympify(hoop))
    cylinder_body = Body("cylinder", roller_mass, _rolling_on(block.displacement, phi), phi, sp.sympify(cylinder))
    slab = Body("slab", m, hoop_body.displacement + R * hoop_body.angle)
    top_body = Body("top", m, _rolling_on(block.displacement, Phi), Phi, sp.sympify(top))
    return Machine((block, hoop_body, cylinder_body, slab, top_body))


def gather(expression: sp.Expr, unknowns: tuple[sp.Expr, ...] = ACCELERATIONS + VELOCITIES + COORDINATES) -> sp.Expr:
    """Return a polynomial in the unknowns with one term for each product of unknowns, and with factored coefficients.

    >>> gather(m * X**2 + m_prime * X**2)
    (m + m_prime)*X(t)**2
    """
    polynomial = sp.Poly(expression, *unknowns, field=True)
    terms = []
    for powers, coefficient in polynomial.terms():
        unknowns_of_term = sp.prod(unknown**power for unknown, power in zip(unknowns, powers, strict=True))
        terms.append(sp.factor(coefficient) * unknowns_of_term)
    return sp.Add(*terms)


def equation(left: sp.Expr | str, right: sp.Expr) -> sp.Eq:
    """Return left = right, unevaluated because SymPy evaluates an identity to True. A text becomes a symbol.

    >>> equation("v", sp.Integer(2)).lhs
    v
    """
    return sp.Eq(sp.Symbol(left) if isinstance(left, str) else left, right, evaluate=False)


def _rolling_on(surface: sp.Expr, angle: sp.Expr) -> sp.Expr:
    return surface + R * angle
