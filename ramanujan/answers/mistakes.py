"""What typical mistakes give as the answer to each question, each with a hint and the question that leads on.

A mistake is a slip in a formula, an altered procedure (an acceleration dropped, a sign lost), or an altered machine.
Machines and procedures go through one elimination, in exact numbers and the mass ratio. Slips come first, exotic
machines last: the first mistake that gives a result is the one that is named.
"""

import sympy as sp

from ramanujan.answers import machines
from ramanujan.derivation.elimination import Elimination, eliminate, phi_ddot
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.derivation.symbols import ACCELERATIONS, COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime, phi, t
from ramanujan.translation import _

Results = dict[str, sp.Expr | tuple[sp.Expr, ...] | None]
"""Hint → the result of the mistake, or several; None where there is no solution."""


def elimination() -> Elimination:
    """Return the elimination for the machine as it is."""
    return eliminate(machines.right())


# Energies


def energy(name: str) -> Results:
    """Return the mistakes in the kinetic energy of one body."""
    body = machines.right()[name]
    whole, travel, spin = sp.expand(body.kinetic_energy), body.translation, body.rotation
    squares = [term for term in sp.Add.make_args(whole) if sum(term.has(rate) for rate in VELOCITIES) == 1]
    turning = body.moment_of_inertia * body.angle.diff(t)
    return {
        **{hint: bodies[name].kinetic_energy for hint, bodies in machines.altered().items()},
        _("You get this result if you square a sum term by term. What is the mixed term of (a + b)²?"): sp.Add(
            *squares
        ),
        # A student who forgets the square may count the velocity positive to either side.
        _("You get this result if you do not square the velocity. How does kinetic energy depend on velocity?"): tuple(
            (body.mass * velocity + turning) / 2 for velocity in (body.velocity, -body.velocity)
        ),
        _("You get this result if you leave out the ½. What is the kinetic energy of a point mass?"): 2 * whole,
        _(
            "You get this result if you leave out the ½ in the energy of translation. What is the kinetic energy of a "
            "point mass?"
        ): 2 * travel + spin,
        _(
            "You get this result if you leave out the ½ in the energy of rotation. What is the energy of a body that "
            "rotates about a fixed axis?"
        ): travel + 2 * spin,
        _("You get this result if you subtract one energy from the other. Which sign does each kinetic energy have?"): (
            travel - spin,
            spin - travel,
        )
        if spin
        else None,
        _("This is only the energy of rotation of {body}. How fast does its centre move?").format(
            body=machines.CALLED[name]
        ): spin,
    }


def spring() -> Results:
    """Return the mistakes in the energy of the spring."""
    bodies = machines.right()
    path, travel = bodies.deformation, bodies["block"].displacement
    return {
        _("You get this result if you leave out the ½. What is the potential energy of a spring?"): k * path**2,
        _("You get this result if you do not square the deformation. How does a spring’s energy depend on it?"): (
            k * path / 2
        ),
        _(
            "You get this result if you take the displacement of the slab relative to the ground. Between which two "
            "bodies does the spring act?"
        ): k * (path + travel) ** 2 / 2,
        _(
            "You get this result if you take 2Rφ + X for the deformation. Between which two bodies does the spring "
            "act, and does their distance depend on X?"
        ): k * (path - travel) ** 2 / 2,
        _(
            "You get this result if the slab moves only as far as the centres of its rollers. How far does the top of "
            "a rolling body move?"
        ): k * (bodies["hoop"].displacement - travel) ** 2 / 2,
    }


# The Lagrangian, and what is derived from it


def lagrangian(right: sp.Expr) -> Results:
    """Return the mistakes in the Lagrangian: those with U, those in the energy of the spring, and altered machines."""
    stored = machines.right().potential_energy
    return {
        _("You get this result if you add the potential energy. Which sign does it have in the Lagrangian?"): (
            right + 2 * stored
        ),
        _("This is the kinetic energy alone. What does the Lagrangian contain besides it?"): right + stored,
        **{hint: right + stored - wrong for hint, wrong in spring().items()},
        **{hint: each.kinetic_energy - each.potential_energy for hint, each in machines.altered().items()},
    }


def momentum(right: sp.Expr) -> Results:
    """Return the mistakes in p_X: the momentum of another coordinate, a square’s factor 2 lost, altered machines."""
    sentence = _("This is the momentum of {coordinate}. With respect to which velocity do you differentiate?")
    rate = VELOCITIES[0]
    return {
        **_of_others(sentence, elimination().momenta),
        _(
            "You get this result if you leave out the 2 when you differentiate X′². What is the derivative of a square?"
        ): (right - right.coeff(rate) * rate / 2),
        **_first_row(VELOCITIES),
    }


def block_equation(right: sp.Expr) -> Results:
    """Return the mistakes in the equation of X: the momentum itself, the equation of another coordinate, machines."""
    rows = _first_row(ACCELERATIONS)
    return {
        _("This says that the momentum of X is zero. What does Lagrange’s equation say about its derivative?"): (
            right.xreplace(dict(zip(ACCELERATIONS, VELOCITIES, strict=True)))
        ),
        **_of_others(_("This is the equation of {coordinate}. Which one is asked for?"), elimination().motion),
        # An equation with one term says no more than that this term is zero.
        **{hint: row if row.is_Add else None for hint, row in rows.items()},
    }


def _of_others(sentence: str, found: dict[sp.Expr, sp.Expr]) -> Results:
    """Return what belongs to φ and to Φ instead of X."""
    return {sentence.format(coordinate=shown): found[q] for q, shown in zip(COORDINATES[1:], "φΦ", strict=True)}


def _first_row(states: tuple[sp.Expr, ...]) -> dict[str, sp.Expr]:
    """Return the first row of the mass matrix of altered machines times velocities, or times accelerations."""
    rows = {hint: machines.mass_matrix(bodies)[0] for hint, bodies in machines.altered().items()}
    return {hint: sp.Add(*map(sp.Mul, row, states)) for hint, row in rows.items()}


# The elimination


def _eliminated(name: str) -> Results:
    unit = {"block_coupling": R, "phi_equation": m * R, "natural_frequency_squared": k / m}.get(name, 1)
    return {hint: found and unit * found.as_expr() for hint, found in machines.eliminated(name).items()}


def coupling(name: str, right: sp.Expr) -> Results:
    """Return the mistakes in Ẍ/φ̈ or Φ̈/φ̈: the reciprocal, the quotient of another pair, and those of the elimination."""
    block, top = (answer_of(each) for each in ("X_from_phi", "Phi_from_phi"))
    other = _(
        "This is the acceleration of {above} divided by that of {below}. Which two accelerations does the question "
        "compare?"
    )
    pairs = {"Xφ": block, "Φφ": top, "XΦ": block / top, "ΦX": top / block}
    return {
        _("This is the reciprocal of the right answer. Which acceleration is multiplied by c?"): 1 / right,
        **{other.format(above=above, below=below): quotient for (above, below), quotient in pairs.items()},
        **_eliminated(name),
    }


def answer_of(equation: str) -> sp.Expr:
    """Return the factor of φ̈ in an equation of the elimination."""
    return getattr(elimination(), equation).coeff(phi_ddot)


def equation() -> Results:
    """Return the mistakes in the equation of motion of φ."""
    right = elimination().motion[phi].coeff(phi_ddot)
    return {
        _("This is the factor after the other two accelerations are inserted. What is it before?"): (
            answer_of("remaining")
        ),
        _("This is R times the right answer. Which common factor has been cancelled in the equation?"): right * R,
        _("This is the reciprocal of the right answer. What multiplies the acceleration of φ?"): 1 / right,
        **_eliminated("phi_equation"),
    }


def frequency(right: sp.Expr) -> Results:
    """Return the mistakes in Ω²."""
    equal = right.subs(m_prime, m)
    return {
        _("This is Ω. The question asks for Ω². What do you get if you square it?"): sp.sqrt(right),
        _("This is Ω⁴. The question asks for Ω². What do you get if you take its root?"): right**2,
        _("This is Ω² in units of k/m. Which factor turns it into the square of a frequency?"): right * m / k,
        _("This is Ω² of a plain mass m on the same spring. Which other bodies move?"): k / m,
        _("This is Ω² for equal masses, m′ = m. What changes if the lower rollers have another mass?"): equal,
        _(
            "This is Ω² for equal masses, m′ = m, in units of k/m. What changes if the lower rollers have another mass?"
        ): equal * m / k,
        _("This is Ω for equal masses, m′ = m. What is Ω² for any two masses?"): sp.sqrt(equal),
        _("This is the reciprocal of the right answer. Which unit does Ω² have?"): 1 / right,
        **_eliminated("natural_frequency_squared"),
    }


# The mass ratio


def ratio() -> Results:
    """Return the mistakes in the unit mass ratio: slips in the quadratic formula, then those of the elimination."""
    condition = unit_frequency_condition()
    (a, b, c), discriminant = condition.quadratic.all_coeffs(), condition.discriminant
    root = sp.sqrt(discriminant)
    return {
        _("This is the other root of the quadratic. Can a ratio of masses be negative?"): (-b - root) / (2 * a),
        _("You get this result if b has the wrong sign. Which sign does b have in (−b ± √(b² − 4ac))/(2a)?"): (
            (b + root) / (2 * a)
        ),
        _("This is the ratio m/m′. Which ratio does the question ask for?"): 1 / condition.root,
        _(
            "You get this result if you leave out the square root. What does the quadratic formula do with the "
            "discriminant?"
        ): (discriminant - b) / (2 * a),
        # Both slips lead to √(−c/a), because b² = b here.
        _(
            "You get this result if you leave out the linear term bε, or if −b is under the root as well. What is b, "
            "and where does the root end?"
        ): sp.sqrt(-c / a),
        _("You get this result if you divide only one of the two terms by 2a. Where do you need a bracket?"): (
            root - b / (2 * a),
            root / (2 * a) - b,
        ),
        _("You get this result if you divide by a. By what does the quadratic formula divide?"): (root - b) / a,
        _("You get this result if you leave out b in front of the root. What is b here?"): root / (2 * a),
        _("You get this result if you leave out b² under the root. What is the discriminant?"): (
            (sp.sqrt(-4 * a * c) - b) / (2 * a)
        ),
        _("You get this result if you leave out the factor 4 under the root. What is the discriminant?"): (
            (sp.sqrt(b**2 - a * c) - b) / (2 * a)
        ),
        **{hint: _positive_root(*altered) for hint, altered in machines.conditions().items()},
    }


def quadratic(right: sp.Expr) -> Results:
    """Return the mistakes in the quadratic equation for the unit mass ratio: those of the elimination."""
    sides, conditions = sp.fraction(unit_frequency_condition().normalized_frequency_squared), machines.conditions()
    return {
        _("You get this result if you add the two sides of Ω²m/k = 1. What is left when you subtract them?"): (
            sp.Add(*sides)
        ),
        _("The term with ε is missing. In which terms of the denominator is ε?"): (
            right - right.coeff(epsilon) * epsilon
        ),
        **{
            hint: a * epsilon**2 + b * epsilon + c if a and (b or c) else None for hint, (a, b, c) in conditions.items()
        },
    }


def _positive_root(a: int, b: int, c: int) -> sp.Expr | None:
    """Return the positive root of a quadratic, None if it has not exactly one."""
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - sp.Rational(b, a)) / 2 if a * c < 0 else None
