"""Lagrange’s equations, the paper’s elimination of two coordinates, and the condition Ω² = k/m that leads to 1729."""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ramanujan.derivation.model import COORDINATES, Machine, Phi, R, X, epsilon, equation, gather, k, m, m_prime, phi, t
from ramanujan.derivation.order import in_order, order_terms

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)


@dataclass(frozen=True)
class Elimination:
    """The three equations of motion, and the equation of φ after the elimination of X and Φ.

    Parameters
    ----------
    lagrangian : ℒ
    momenta, forces : coordinate → p = ∂ℒ/∂q̇, and coordinate → ∂ℒ/∂q
    common : coordinate → common factor of the terms of ṗ − ∂ℒ/∂q
    motion : coordinate → (ṗ − ∂ℒ/∂q)/common, the left side of the equation of motion, whose right side is 0
    multiplier, merged : the factor of the X equation, and the three lines that eliminate Φ̈, from `_merge_equations`
    Phi_ddot_from_X_ddot : Φ̈ in terms of Ẍ
    X_ddot_from_phi_ddot, Phi_ddot_from_phi_ddot : Ẍ and Φ̈ in terms of φ̈
    inserted, remaining : the φ equation with Ẍ inserted, before and after like terms are gathered
    natural_frequency_squared : Ω²
    """

    lagrangian: sp.Expr
    momenta: dict[sp.Expr, sp.Expr]
    forces: dict[sp.Expr, sp.Expr]
    common: dict[sp.Expr, sp.Expr]
    motion: dict[sp.Expr, sp.Expr]
    multiplier: sp.Rational
    merged: tuple[sp.Eq, ...]
    Phi_ddot_from_X_ddot: sp.Expr
    X_ddot_from_phi_ddot: sp.Expr
    Phi_ddot_from_phi_ddot: sp.Expr
    inserted: sp.Expr
    remaining: sp.Expr
    natural_frequency_squared: sp.Expr

    @property
    def quotient(self) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
        """Numerator of Ω², and the terms of its denominator one by one.  Source: paper, eq. (12)."""
        phi_equation = self.motion[phi]
        own_inertia = phi_equation.coeff(phi_ddot)
        inertia_of_block = phi_equation.coeff(X_ddot) * self.X_ddot_from_phi_ddot / phi_ddot
        # Divide by the number before the masses.
        number, _masses = own_inertia.as_independent(m, m_prime)
        terms = (*order_terms(sp.expand(own_inertia / number)), sp.factor(inertia_of_block / number))
        return sp.cancel(phi_equation.coeff(phi) / number), terms


@cache
def eliminate(bodies: Machine) -> Elimination:
    """Return the paper's elimination: insert the Φ equation into the X equation, and the result into the φ equation.

    >>> from ramanujan.derivation.model import machine
    >>> eliminate(machine(roller_mass=m)).natural_frequency_squared
    104*k/(99*m)
    """
    lagrangian = bodies.lagrangian
    momenta = {q: lagrangian.diff(q.diff(t)) for q in COORDINATES}
    forces = {q: lagrangian.diff(q) for q in COORDINATES}
    # Lagrange’s equations: paper, eq. (3).
    left_sides = {q: gather(momenta[q].diff(t) - forces[q]) for q in COORDINATES}
    common = {q: _common_factor(left_side) for q, left_side in left_sides.items()}
    motion = {q: gather(sp.cancel(left_sides[q] / common[q])) for q in COORDINATES}
    (Phi_ddot_from_X_ddot,) = sp.solve(motion[Phi], Phi_ddot)
    (X_ddot_from_phi_ddot,) = sp.solve(motion[X].subs(Phi_ddot, Phi_ddot_from_X_ddot), X_ddot)
    inserted = in_order(*(sp.factor(term.subs(X_ddot, X_ddot_from_phi_ddot)) for term in order_terms(motion[phi])))
    remaining = gather(inserted.doit())
    multiplier, merged = _merge_equations(motion)
    return Elimination(
        lagrangian=lagrangian,
        momenta=momenta,
        forces=forces,
        common=common,
        motion=motion,
        multiplier=multiplier,
        merged=merged,
        Phi_ddot_from_X_ddot=Phi_ddot_from_X_ddot,
        X_ddot_from_phi_ddot=sp.factor(X_ddot_from_phi_ddot),
        Phi_ddot_from_phi_ddot=sp.factor(Phi_ddot_from_X_ddot.subs(X_ddot, X_ddot_from_phi_ddot)),
        inserted=inserted,
        remaining=remaining,
        natural_frequency_squared=sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot)),
    )


def _merge_equations(motion: dict[sp.Expr, sp.Expr]) -> tuple[sp.Rational, tuple[sp.Eq, ...]]:
    """Return a multiplier of the X equation, and the three lines that eliminate Φ̈.

    The multiplier is a number, such as 3/2. After the multiplication, the Φ equation's term with Φ̈ is −s times that of
    the X equation. The factor s contains only symbols, such as 1/m. The lines are

    1. the Φ equation, solved for its term with Φ̈,
    2. the X equation times the multiplier,
    3. the second line with its term with Φ̈ replaced by means of the first line.
    """
    Phi_term = motion[Phi].coeff(Phi_ddot) * Phi_ddot
    equal_to_Phi_term = Phi_term - motion[Phi]
    ratio_of_Phi_terms = -motion[Phi].coeff(Phi_ddot) / motion[X].coeff(Phi_ddot)
    multiplier, symbolic_factor = ratio_of_Phi_terms.as_coeff_Mul()
    X_term = sp.factor(multiplier * motion[X].coeff(X_ddot)) * X_ddot
    phi_term = sp.factor(multiplier * motion[X].coeff(phi_ddot)) * phi_ddot
    lines = (
        equation(Phi_term, equal_to_Phi_term),
        equation(in_order(X_term, -Phi_term / symbolic_factor), -phi_term),
        equation(in_order(X_term, -sp.cancel(equal_to_Phi_term / symbolic_factor)), -phi_term),
    )
    return multiplier, lines


@dataclass(frozen=True)
class UnitCondition:
    """The condition Ω² = k/m: Ω²m/k, the quadratic equation for ε = m′/m, its positive root, and its discriminant."""

    normalized_frequency_squared: sp.Expr
    quadratic: sp.Poly
    root: sp.Expr
    discriminant: sp.Integer

    @property
    def completed_square(self) -> sp.Eq:
        """(2aε + b)² = b² − 4ac, the quadratic times 4a with the square completed.  Source: paper, section 2.1."""
        a, b = self.quadratic.all_coeffs()[:2]
        return equation(in_order(2 * a * epsilon, b) ** 2, self.discriminant)


def unit_condition(natural_frequency_squared: sp.Expr) -> UnitCondition:
    """Return the condition Ω²m/k = 1 as a quadratic equation for ε with integer coefficients.

    Parameters
    ----------
    natural_frequency_squared : Ω² in terms of m, m′ and k

    Raises
    ------
    ValueError : not exactly one positive mass ratio satisfies the condition.

    >>> from ramanujan.derivation.model import machine
    >>> unit_condition(eliminate(machine()).natural_frequency_squared).completed_square
    Eq((36*varepsilon + 1)**2, 1729)
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    _content, quadratic = sp.Poly(denominator - numerator, epsilon).primitive()
    (root,) = (root for root in sp.roots(quadratic, multiple=True) if root.is_positive)
    return UnitCondition(normalized, quadratic, sp.factor(root), quadratic.discriminant())


def _common_factor(gathered: sp.Expr) -> sp.Expr:
    """Return the symbols m and R that all coefficients of an equation share."""
    common = sp.gcd_list([term.as_independent(*COORDINATES)[0] for term in gathered.args])
    return sp.Mul(*(factor for factor in sp.Mul.make_args(common) if factor in (m, R)))
