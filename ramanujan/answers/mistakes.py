"""What typical mistakes give as the answer to each question, each with a hint and the question that leads on.

A mistake is a slip in a formula, an altered procedure (an acceleration dropped, a sign lost), or an altered machine.
Machines and procedures go through one elimination, in exact numbers and the mass ratio. Slips come first, exotic
machines last: the first mistake that gives a result is the one that is named.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import cache

import sympy as sp

from ramanujan.answers import machines
from ramanujan.answers.machines import conditions, eliminated, mass_matrix
from ramanujan.derivation.elimination import Elimination, UnitCondition, eliminate, phi_ddot, unit_condition
from ramanujan.derivation.symbols import (
    ACCELERATIONS,
    COORDINATES,
    VELOCITIES,
    Machine,
    R,
    epsilon,
    k,
    m,
    m_prime,
    machine,
    phi,
    t,
)
from ramanujan.translation import _

Variants = Iterator[tuple[str, sp.Expr | None]]
"""Hints, and the results of the mistakes; None where there is no solution."""


@cache
def elimination() -> Elimination:
    """Return the elimination for the machine as it is."""
    return eliminate(machine())


@cache
def unit() -> UnitCondition:
    """Return the condition Ω² = k/m for the machine as it is."""
    return unit_condition(elimination().natural_frequency_squared)


# Energies


def energy(name: str) -> Variants:
    """Yield the mistakes in the kinetic energy of one body."""
    body = machine()[name]
    mixed = [term for term in sp.Add.make_args(sp.expand(body.kinetic_energy)) if len(_rates_in(term)) > 1]
    yield from _altered(machines.common(), lambda bodies: bodies[name].kinetic_energy)
    if mixed:
        yield (
            _("You get this result if you square a sum term by term. What is the mixed term of (a + b)²?"),
            sp.expand(body.kinetic_energy) - sp.Add(*mixed),
        )
    unsquared = _("You get this result if you do not square the velocity. How does kinetic energy depend on velocity?")
    # A student who forgets the square may count the velocity positive to either side.
    for velocity in (body.velocity, -body.velocity):
        yield unsquared, (body.mass * velocity + body.moment_of_inertia * body.angle.diff(t)) / 2
    if body.rotation:
        yield (
            _(
                "You get this result if you leave out the ½ in the energy of translation. What is the kinetic energy "
                "of a point mass?"
            ),
            2 * body.translation + body.rotation,
        )
        yield (
            _(
                "You get this result if you leave out the ½ in the energy of rotation. What is the energy of a body "
                "that rotates about a fixed axis?"
            ),
            body.translation + 2 * body.rotation,
        )
        subtracted = _(
            "You get this result if you subtract one energy from the other. Which sign does each kinetic energy have?"
        )
        yield subtracted, body.translation - body.rotation
        yield subtracted, body.rotation - body.translation
        only = _("This is only the energy of rotation of {body}. How fast does its centre move?")
        yield only.format(body=machines.CALLED[name]), body.rotation
    yield (
        _("You get this result if you leave out the ½. What is the kinetic energy of a point mass?"),
        2 * body.kinetic_energy,
    )
    yield from _altered(machines.exotic(), lambda bodies: bodies[name].kinetic_energy)


def _altered(group: Iterable[machines.Mistake], answer: Callable[[Machine], sp.Expr]) -> Variants:
    """Yield the answers for altered machines; where one is as for the right machine, nothing is compared with it."""
    for mistake in group:
        yield mistake.hint, answer(mistake.bodies)


def _rates_in(term: sp.Expr) -> list[sp.Expr]:
    return [rate for rate in VELOCITIES if term.has(rate)]


def spring() -> Variants:
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


# The Lagrangian, and what is derived from it


def lagrangian(right: sp.Expr) -> Variants:
    """Yield the mistakes in the Lagrangian: those with U, those in the energy of the spring, and altered machines."""
    stored = machine().potential_energy
    yield (
        _("You get this result if you add the potential energy. Which sign does it have in the Lagrangian?"),
        right + 2 * stored,
    )
    yield _("This is the kinetic energy alone. What does the Lagrangian contain besides it?"), right + stored
    for hint, wrong in spring():
        yield hint, right + stored - wrong
    everyone = (*machines.common(), *machines.exotic())
    yield from _altered(everyone, lambda bodies: bodies.kinetic_energy - bodies.potential_energy)


def momentum(right: sp.Expr) -> Variants:
    """Yield the mistakes in p_X: the momentum of another coordinate, a square’s factor 2 lost, altered machines."""
    for (q, other), shown in zip(elimination().momenta.items(), ("X", "φ", "Φ"), strict=True):
        if q != COORDINATES[0]:
            sentence = _("This is the momentum of {coordinate}. With respect to which velocity do you differentiate?")
            yield sentence.format(coordinate=shown), other
    rate = VELOCITIES[0]
    yield (
        _("You get this result if you leave out the 2 when you differentiate X′². What is the derivative of a square?"),
        right - right.coeff(rate) * rate / 2,
    )
    yield from _first_row(VELOCITIES)


def block_equation(right: sp.Expr) -> Variants:
    """Yield the mistakes in the equation of X: the momentum itself, the equation of another coordinate, machines."""
    slowed = dict(zip(ACCELERATIONS, VELOCITIES, strict=True))
    yield (
        _("This says that the momentum of X is zero. What does Lagrange’s equation say about its derivative?"),
        right.xreplace(slowed),
    )
    for (q, other), shown in zip(elimination().motion.items(), ("X", "φ", "Φ"), strict=True):
        if q != COORDINATES[0]:
            yield _("This is the equation of {coordinate}. Which one is asked for?").format(coordinate=shown), other
    for hint, wrong in _first_row(ACCELERATIONS):
        # An equation with one term says no more than that this term is zero.
        yield hint, wrong if wrong.is_Add else None


def _first_row(states: tuple[sp.Expr, ...]) -> Iterator[tuple[str, sp.Expr]]:
    """Yield the first row of the mass matrix of altered machines times velocities, or times accelerations."""
    for mistake in (*machines.common(), *machines.exotic()):
        row = mass_matrix(mistake.bodies)[0]
        yield mistake.hint, sp.Add(*(entry * state for entry, state in zip(row, states, strict=True)))


# The elimination


def _eliminated(name: str) -> Variants:
    unit = {"block_coupling": R, "phi_equation": m * R, "natural_frequency_squared": k / m}.get(name, 1)
    for hint, result in eliminated(name):
        yield hint, result and unit * result.as_expr()


def coupling(name: str, right: sp.Expr) -> Variants:
    """Yield the mistakes in Ẍ/φ̈ or Φ̈/φ̈: the reciprocal, the quotient of another pair, and those of the elimination."""
    yield _("This is the reciprocal of the right answer. Which acceleration is multiplied by c?"), 1 / right
    block, top = (answer_of(each) for each in ("X_from_phi", "Phi_from_phi"))
    other = _(
        "This is the acceleration of {above} divided by that of {below}. Which two accelerations does the question "
        "compare?"
    )
    pairs = (("X", "φ", block), ("Φ", "φ", top), ("X", "Φ", block / top), ("Φ", "X", top / block))
    for above, below, quotient in pairs:
        yield other.format(above=above, below=below), quotient
    yield from _eliminated(name)


def answer_of(equation: str) -> sp.Expr:
    """Return the factor of φ̈ in an equation of the elimination."""
    return getattr(elimination(), equation).coeff(phi_ddot)


def equation() -> Variants:
    """Yield the mistakes in the equation of motion of φ."""
    right = elimination().motion[phi].coeff(phi_ddot)
    yield (
        _("This is the factor after the other two accelerations are inserted. What is it before?"),
        answer_of("remaining"),
    )
    yield _("This is R times the right answer. Which common factor has been cancelled in the equation?"), right * R
    yield _("This is the reciprocal of the right answer. What multiplies the acceleration of φ?"), 1 / right
    yield from _eliminated("phi_equation")


def frequency(right: sp.Expr) -> Variants:
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
    yield _("This is the reciprocal of the right answer. Which unit does Ω² have?"), 1 / right
    yield from _eliminated("natural_frequency_squared")


# The mass ratio


def ratio() -> Variants:
    """Yield the mistakes in the unit mass ratio: slips in the quadratic formula, then those of the elimination."""
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
    # Both slips lead to √(−c/a), because b² = b here.
    yield (
        _(
            "You get this result if you leave out the linear term bε, or if −b is under the root as well. What is b, "
            "and where does the root end?"
        ),
        sp.sqrt(-c / a),
    )
    bracket = _("You get this result if you divide only one of the two terms by 2a. Where do you need a bracket?")
    yield bracket, root - b / (2 * a)
    yield bracket, root / (2 * a) - b
    yield _("You get this result if you divide by a. By what does the quadratic formula divide?"), (root - b) / a
    yield _("You get this result if you leave out b in front of the root. What is b here?"), root / (2 * a)
    yield (
        _("You get this result if you leave out b² under the root. What is the discriminant?"),
        (sp.sqrt(-4 * a * c) - b) / (2 * a),
    )
    yield (
        _("You get this result if you leave out the factor 4 under the root. What is the discriminant?"),
        (sp.sqrt(b**2 - a * c) - b) / (2 * a),
    )
    for hint, altered in conditions():
        yield hint, _positive_root(*altered)


def quadratic(right: sp.Expr) -> Variants:
    """Yield the mistakes in the quadratic equation for the unit mass ratio: those of the elimination."""
    yield (
        _("You get this result if you add the two sides of Ω²m/k = 1. What is left when you subtract them?"),
        sp.Add(*sp.fraction(unit().normalized_frequency_squared)),
    )
    yield (
        _("The term with ε is missing. In which terms of the denominator is ε?"),
        right - right.coeff(epsilon) * epsilon,
    )
    for hint, (a, b, c) in conditions():
        yield hint, a * epsilon**2 + b * epsilon + c if a and (b or c) else None


def _positive_root(a: int, b: int, c: int) -> sp.Expr | None:
    """Return the positive root of a quadratic, None if it has not exactly one."""
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - sp.Rational(b, a)) / 2 if a * c < 0 else None
