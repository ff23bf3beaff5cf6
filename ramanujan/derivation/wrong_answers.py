"""The results of typical mistakes in each question, with the question that leads on; `mistakes` alters the machine."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import sympy as sp

from ramanujan.derivation import altered, mistakes
from ramanujan.derivation.elimination import (
    Elimination,
    UnitCondition,
    eliminate,
    phi_ddot,
    unit_condition,
)
from ramanujan.derivation.expansion import NormalForm
from ramanujan.derivation.expressions import NAMES
from ramanujan.derivation.symbols import R, k, m, m_prime, machine
from ramanujan.translation import _

Variants = Iterator[tuple[str, sp.Expr | NormalForm | None]]
"""Hints, and the results of the mistakes; None where there is no solution."""


def energy_mistakes(body: str, _right: sp.Expr, _quantity: str) -> Variants:
    """Yield the mistakes in the kinetic energy of one body."""
    for mistake in mistakes.mistakes():
        if mistake.altered == (body,):
            yield mistake.hint, mistake.bodies[body].kinetic_energy
    yield from mistakes.overlooked_in_energy(machine()[body])


def spring_mistakes(_right: sp.Expr, _quantity: str) -> Variants:
    """Yield the mistakes in the energy of the spring."""
    bodies = machine()
    path, travel = bodies.deformation, bodies["block"].displacement
    yield _("You get this result if you leave out the ½. What is the potential energy of a spring?"), k * path**2
    yield (
        _("You get this result if you do not square the deformation. How does a spring’s energy depend on it?"),
        k * path / 2,
    )
    yield (
        _(
            "You get this result if you take the displacement of the slab relative to the ground. Between which two "
            "bodies does the spring act?"
        ),
        k * (path + travel) ** 2 / 2,
    )
    yield (
        _(
            "You get this result if you take 2Rφ + X for the deformation. Between which two bodies does the spring "
            "act, and does their distance depend on X?"
        ),
        k * (path - travel) ** 2 / 2,
    )
    yield (
        _(
            "You get this result if the slab moves only as far as the centres of its rollers. How far does the top of "
            "a rolling body move?"
        ),
        k * (bodies["hoop"].displacement - travel) ** 2 / 2,
    )


def elimination_mistakes(name: str, right: sp.Expr, quantity: str) -> Variants:
    """Yield what every altered machine gives for a result of the elimination, and the reciprocal."""
    for mistake in mistakes.mistakes():
        yield mistake.hint, altered.single_mass(mistake.bodies, name)
    reciprocal = _("This is the reciprocal of the right answer. Which unit does {quantity} have?")
    yield reciprocal.format(quantity=quantity), 1 / right


def equation_mistakes(right: sp.Expr, quantity: str) -> Variants:
    """Yield the mistakes in the equation of motion of φ."""
    equation = elimination().remaining
    yield (
        _("This is the factor after the other two accelerations are inserted. What is it before?"),
        equation.coeff(phi_ddot),
    )
    divided = _("This is R times the right answer. Which common factor has been cancelled in the equation?")
    yield divided, right * R
    yield from elimination_mistakes("phi_equation", right, quantity)


def frequency_mistakes(right: sp.Expr, quantity: str) -> Variants:
    """Yield the mistakes in Ω²."""
    equal = right.subs(m_prime, m)
    yield _("This is Ω. The question asks for Ω². What do you get if you square it?"), sp.sqrt(right)
    yield _("This is Ω⁴. The question asks for Ω². What do you get if you take its root?"), right**2
    yield _("This is Ω² in units of k/m. Which factor turns it into the square of a frequency?"), right * m / k
    yield _("This is Ω² of a plain mass m on the same spring. Which other bodies move?"), k / m
    yield _("This is Ω² for equal masses, m′ = m. What changes if the lower rollers have another mass?"), equal
    yield (
        _("This is Ω² for equal masses, m′ = m, in units of k/m. What changes if the lower rollers have another mass?"),
        equal * m / k,
    )
    yield _("This is Ω for equal masses, m′ = m. What is Ω² for any two masses?"), sp.sqrt(equal)
    yield from elimination_mistakes("natural_frequency_squared", right, quantity)


def ratio_mistakes(_right: sp.Expr, _quantity: str) -> Variants:
    """Yield the mistakes in the unit mass ratio."""
    condition = unit()
    a, b, c = condition.quadratic.all_coeffs()
    root = sp.sqrt(condition.discriminant)
    yield _("This is the other root of the quadratic. Can a ratio of masses be negative?"), (-b - root) / (2 * a)
    sign = _("You get this result if b has the wrong sign. Which sign does b have in (−b ± √(b² − 4ac))/(2a)?")
    yield sign, (b + root) / (2 * a)
    yield _("This is the ratio m/m′. Which ratio does the question ask for?"), 1 / condition.root
    yield (
        _(
            "You get this result if you leave out the square root. What does the quadratic formula do with the "
            "discriminant?"
        ),
        (condition.discriminant - b) / (2 * a),
    )
    yield _("You get this result if you divide by a. By what does the quadratic formula divide?"), (root - b) / a
    yield _("You get this result if you leave out b in front of the root. What is b here?"), root / (2 * a)
    yield (
        _("You get this result if you leave out b² under the root. What is the discriminant?"),
        (sp.sqrt(-4 * a * c) - b) / (2 * a),
    )
    for mistake in mistakes.mistakes():
        frequency_squared = altered.single_mass(mistake.bodies, "natural_frequency_squared")
        yield mistake.hint, _unit_mass_ratio(frequency_squared) if frequency_squared else None


def _unit_mass_ratio(frequency_squared: NormalForm) -> NormalForm | None:
    """Return the positive ε for which Ω² = k/m; None if this is not a quadratic with exactly one positive root.

    With Ω² = N/D the condition is mN = kD; both sides are homogeneous in m and m′, so that m = k = 1 and m′ = ε.
    """
    powers: dict[int, int] = {}
    position = NAMES.index("m'")
    for polynomial, sign in ((frequency_squared.denominator, 1), (frequency_squared.numerator, -1)):
        for monomial, number in polynomial.items():
            powers[monomial[position]] = powers.get(monomial[position], 0) + sign * int(number)
    a, b, c = (sp.Integer(powers.get(power, 0)) for power in (2, 1, 0))
    if any(number for power, number in powers.items() if power > 2) or a * c >= 0:
        return None
    return NormalForm.of((sp.sqrt(b**2 - 4 * a * c) / abs(a) - b / a) / 2)


@cache
def elimination() -> Elimination:
    """Return the elimination for the machine as it is."""
    return eliminate(machine())


@cache
def unit() -> UnitCondition:
    """Return the condition Ω² = k/m for the machine as it is."""
    return unit_condition(elimination().natural_frequency_squared)
