"""Lagrange’s equations, the paper’s elimination of two coordinates, and the condition Ω² = k/m that leads to 1729."""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ramanujan.derivation.model import COORDINATES, Machine, Phi, R, X, epsilon, equation, gather, k, m, m_prime, phi, t
from ramanujan.derivation.order import in_order, ordered_terms

X_ddot, phi_ddot, Phi_ddot = (q.diff(t, 2) for q in COORDINATES)


@dataclass(frozen=True)
class Elimination:
    """The three equations of motion, and the equation of φ after the elimination of X and Φ.

    `momenta` maps each coordinate to p = ∂ℒ/∂q̇, and `forces` maps it to ∂ℒ/∂q. `motion` is ṗ − ∂ℒ/∂q, the left side
    of … = 0, divided by the `common` factor of its terms. `merged` contains the three lines that eliminate Φ̈: the
    first line replaces a term of the X equation multiplied by `times`. The other fields are Φ̈ in terms of Ẍ, Ẍ and Φ̈
    in terms of φ̈, the φ equation after insertion and with like terms gathered, and Ω².
    """

    lagrangian: sp.Expr
    momenta: dict[sp.Expr, sp.Expr]
    forces: dict[sp.Expr, sp.Expr]
    common: dict[sp.Expr, sp.Expr]
    motion: dict[sp.Expr, sp.Expr]
    times: sp.Rational
    merged: tuple[sp.Eq, ...]
    Phi_from_X: sp.Expr
    X_from_phi: sp.Expr
    Phi_from_phi: sp.Expr
    inserted: sp.Expr
    remaining: sp.Expr
    natural_frequency_squared: sp.Expr

    @property
    def quotient(self) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
        """Numerator of Ω², and the terms of its denominator one by one.  Source: paper, eq. (12)."""
        direct, through_block = self.motion[phi].coeff(phi_ddot), self.motion[phi].coeff(X_ddot) * self.X_from_phi
        unit = direct.as_independent(m, m_prime)[0]
        terms = (*ordered_terms(sp.expand(direct / unit)), sp.factor(through_block / phi_ddot / unit))
        return sp.cancel(self.motion[phi].coeff(phi) / unit), terms


@cache
def eliminate(bodies: Machine) -> Elimination:
    """Return the paper's elimination for the machine: the Φ equation into the X equation, both into that of φ.

    >>> from ramanujan.derivation.model import machine
    >>> eliminate(machine(roller_mass=m)).natural_frequency_squared
    104*k/(99*m)
    """
    lagrangian = bodies.lagrangian
    momenta = {q: lagrangian.diff(q.diff(t)) for q in COORDINATES}
    forces = {q: lagrangian.diff(q) for q in COORDINATES}
    # Lagrange’s equations: paper, eq. (3).
    operated = {q: gather(momenta[q].diff(t) - forces[q]) for q in COORDINATES}
    common = {q: _common_factor(expression) for q, expression in operated.items()}
    motion = {q: gather(sp.cancel(operated[q] / common[q])) for q in COORDINATES}
    (Phi_from_X,) = sp.solve(motion[Phi], Phi_ddot)
    (X_from_phi,) = sp.solve(motion[X].subs(Phi_ddot, Phi_from_X), X_ddot)
    inserted = in_order(*(sp.factor(term.subs(X_ddot, X_from_phi)) for term in ordered_terms(motion[phi])))
    remaining = gather(inserted.doit())
    return Elimination(
        lagrangian,
        momenta,
        forces,
        common,
        motion,
        *_merged(motion),
        Phi_from_X,
        sp.factor(X_from_phi),
        sp.factor(Phi_from_X.subs(X_ddot, X_from_phi)),
        inserted,
        remaining,
        sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot)),
    )


def _merged(motion: dict[sp.Expr, sp.Expr]) -> tuple[sp.Rational, tuple[sp.Eq, ...]]:
    """Return the factor of the X equation, and three lines.

    The lines are the Φ equation solved for its term in Φ̈, the multiple of the X equation, and the multiple with that
    term replaced.
    """
    of_Phi = motion[Phi].coeff(Phi_ddot) * Phi_ddot
    by_X = of_Phi - motion[Phi]
    times, share = (-motion[Phi].coeff(Phi_ddot) / motion[X].coeff(Phi_ddot)).as_coeff_Mul()
    block, rollers = (sp.factor(times * motion[X].coeff(a)) * a for a in (X_ddot, phi_ddot))
    lines = (
        equation(of_Phi, by_X),
        equation(in_order(block, -of_Phi / share), -rollers),
        equation(in_order(block, -sp.cancel(by_X / share)), -rollers),
    )
    return times, lines


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
        return equation(in_order(2 * a * epsilon, b) ** 2, self.discriminant)


def unit_condition(natural_frequency_squared: sp.Expr) -> UnitCondition:
    """Return the condition Ω²m/k = 1 for a frequency given in m, m′ and k, as a quadratic in ε with integers.

    Raises
    ------
    ValueError : not exactly one positive mass ratio satisfies it.

    >>> from ramanujan.derivation.model import machine
    >>> unit_condition(eliminate(machine()).natural_frequency_squared).completed_square
    Eq((36*varepsilon + 1)**2, 1729)
    """
    normalized = sp.factor(natural_frequency_squared.subs(m_prime, epsilon * m) * m / k)
    numerator, denominator = sp.fraction(normalized)
    quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
    (root,) = (root for root in sp.roots(quadratic, multiple=True) if root.is_positive)
    return UnitCondition(normalized, quadratic, sp.factor(root), quadratic.discriminant())


def _common_factor(gathered: sp.Expr) -> sp.Expr:
    """Return the symbols m and R that all coefficients of an equation share."""
    common = sp.gcd_list([term.as_independent(*COORDINATES)[0] for term in gathered.args])
    return sp.Mul(*(factor for factor in sp.Mul.make_args(common) if factor in (m, R)))
