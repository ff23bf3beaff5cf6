"""Lagrange’s equations, the paper’s elimination of two coordinates, and the condition Ω² = k/m that leads to 1729."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ramanujan.derivation.steps import equation
from ramanujan.derivation.symbols import (
    COORDINATES,
    Machine,
    Phi,
    R,
    X,
    epsilon,
    gather,
    k,
    m,
    m_prime,
    phi,
    t,
)
from ramanujan.translation import _

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)


def euler_lagrange_operator(lagrangian: sp.Expr, q: sp.Expr) -> sp.Expr:
    """Return d/dt ∂ℒ/∂q̇ − ∂ℒ/∂q, whose zero is the equation of motion of q.  Source: paper, eq. (3).

    >>> euler_lagrange_operator(m * X.diff(t) ** 2 / 2 - k * X**2 / 2, X)
    k*X(t) + m*Derivative(X(t), (t, 2))
    """
    return lagrangian.diff(q.diff(t)).diff(t) - lagrangian.diff(q)


@dataclass(frozen=True)
class Elimination:
    """The three equations of motion, and the one that is left when X and Φ are expressed by φ.

    `motion` maps each coordinate to its equation (left side of … = 0, without common factor); the others are
    Φ̈ in terms of Ẍ, Ẍ and Φ̈ in terms of φ̈, the φ equation after insertion, and Ω².
    """

    lagrangian: sp.Expr
    motion: dict[sp.Expr, sp.Expr]
    Phi_from_X: sp.Expr
    X_from_phi: sp.Expr
    Phi_from_phi: sp.Expr
    remaining: sp.Expr
    natural_frequency_squared: sp.Expr


@cache
def eliminate(bodies: Machine) -> Elimination:
    """Return the paper's elimination for the machine: the Φ equation into the X equation, both into that of φ.

    >>> from ramanujan.derivation.symbols import machine
    >>> eliminate(machine(roller_mass=m)).natural_frequency_squared
    104*k/(99*m)
    """
    lagrangian = bodies.lagrangian
    motion = {q: _without_common_factor(euler_lagrange_operator(lagrangian, q)) for q in COORDINATES}
    (Phi_from_X,) = sp.solve(motion[Phi], Phi_ddot)
    (X_from_phi,) = sp.solve(motion[X].subs(Phi_ddot, Phi_from_X), X_ddot)
    Phi_from_phi = sp.factor(Phi_from_X.subs(X_ddot, X_from_phi))
    remaining = gather(motion[phi].subs(X_ddot, X_from_phi))
    frequency = sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot))
    return Elimination(lagrangian, motion, Phi_from_X, sp.factor(X_from_phi), Phi_from_phi, remaining, frequency)


@dataclass(frozen=True)
class UnitCondition:
    """When Ω² = k/m: the frequency in units of k/m, the quadratic in ε = m′/m, its positive root, its discriminant."""

    normalized_frequency_squared: sp.Expr
    quadratic: sp.Poly
    root: sp.Expr
    discriminant: sp.Integer

    @property
    def completed_square(self) -> sp.Eq:
        """(2aε + b)² = b² − 4ac, the quadratic times 4a with the square completed.  Source: paper, section 2.1."""
        a, b = self.quadratic.all_coeffs()[:2]
        return equation((2 * a * epsilon + b) ** 2, self.discriminant)


def unit_condition(natural_frequency_squared: sp.Expr) -> UnitCondition:
    """Return the condition Ω²m/k = 1 for a frequency given in m, m′ and k, as a quadratic in ε with integers.

    Raises
    ------
    ValueError : not exactly one positive mass ratio satisfies it.

    >>> from ramanujan.derivation.symbols import machine
    >>> unit_condition(eliminate(machine()).natural_frequency_squared).completed_square
    Eq((36*varepsilon + 1)**2, 1729)
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
    roots = [root for root in sp.roots(quadratic, multiple=True) if root.is_positive]
    if len(roots) != 1:
        raise ValueError(_("natural_frequency_squared must be k/m at exactly one positive mass ratio"))
    return UnitCondition(normalized, quadratic, sp.factor(roots[0]), quadratic.discriminant())


def _without_common_factor(expression: sp.Expr) -> sp.Expr:
    """Return the equation's left side divided by the symbols that all of its coefficients share."""
    gathered = gather(expression)
    common = sp.gcd_list([term.as_independent(*COORDINATES)[0] for term in gathered.args])
    return gather(sp.cancel(gathered / sp.Mul(*(f for f in sp.Mul.make_args(common) if f in (m, R)))))
