"""What natural mistakes give as the answer to each question, each with a hint and the question that leads on.

A mistake here is a slip in a formula, a guess, the answer to another question, or a slip in the elimination. No two of
one question give the same result: a hint names the only one. Bodies taken wrongly are in `machines`.
"""

from collections.abc import Iterator

import sympy as sp

from ramanujan.answers import machines
from ramanujan.derivation.elimination import Elimination, eliminate, phi_ddot
from ramanujan.derivation.model import ACCELERATIONS, COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime, phi, t
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.translation import _

Slips = Iterator[tuple[str, sp.Expr | None]]
"""Hints, and the result of the mistake of each; None where there is no solution."""


def elimination() -> Elimination:
    """Return the elimination for the machine as it is."""
    return eliminate(machines.right())


# Energies


def energy(name: str) -> Slips:
    """Yield the mistakes in the kinetic energy of one body."""
    body = machines.right()[name]
    whole, travel, spin = sp.expand(body.kinetic_energy), body.translation, body.rotation
    squares = [term for term in sp.Add.make_args(whole) if sum(term.has(rate) for rate in VELOCITIES) == 1]
    hint = _("You get this result if you square a sum term by term. What is the mixed term of (a + b)²?")
    yield hint, sp.Add(*squares)
    # A student who forgets the square may count the velocity positive to either side.
    hint = _("You get this result if you do not square the velocity. How does kinetic energy depend on velocity?")
    turning = body.moment_of_inertia * body.angle.diff(t)
    yield hint, (body.mass * body.velocity + turning) / 2
    yield hint, (-body.mass * body.velocity + turning) / 2
    yield _("You get this result if you leave out the ½. What is the kinetic energy of a point mass?"), 2 * whole
    if not spin:
        return
    hint = _(
        "You get this result if you leave out the ½ in the energy of translation. What is the kinetic energy of a "
        "point mass?"
    )
    yield hint, 2 * travel + spin
    # The ½ of ½Iω² may be missing, or that of a cylinder's moment of inertia.
    yield _("In your answer the energy of rotation is twice the right one. What is I, and what is ½Iω²?"), whole + spin
    hint = _("You get this result if you subtract one energy from the other. Which sign does each kinetic energy have?")
    # The difference for a hoop has no φ′², as if that term had been forgotten.
    if body.shape_factor != 1:
        yield hint, travel - spin
        yield hint, spin - travel
    # TRANSLATORS: {body} is the hoop, the lower cylinder or the top cylinder.
    alone = _("This is only the energy of rotation of {body}. How fast does its centre move?")
    yield alone.format(body=machines.CALLED[name]), spin


def spring() -> Slips:
    """Yield the mistakes in the energy of the spring."""
    bodies = machines.right()
    path, travel = bodies.deformation, bodies["block"].displacement
    yield _("You get this result if you leave out the ½. What is the potential energy of a spring?"), k * path**2
    hint = _("You get this result if you do not square the deformation. How does a spring’s energy depend on it?")
    yield hint, k * path / 2
    hint = _(
        "You get this result if you take the displacement of the slab relative to the ground. Between which two bodies "
        "does the spring act?"
    )
    yield hint, k * (path + travel) ** 2 / 2
    hint = _(
        "You get this result if you take 2Rφ + X for the deformation. Between which two bodies does the spring act, "
        "and does their distance depend on X?"
    )
    yield hint, k * (path - travel) ** 2 / 2
    hint = _(
        "You get this result if the slab moves only as far as the centres of its rollers. How far does the top of a "
        "rolling body move?"
    )
    yield hint, k * (bodies["hoop"].displacement - travel) ** 2 / 2


# The Lagrangian, and what is derived from it


def lagrangian(right: sp.Expr) -> Slips:
    """Yield the mistakes in the Lagrangian: those with U, and those in the energy of the spring."""
    stored = machines.right().potential_energy
    hint = _("You get this result if you add the potential energy. Which sign does it have in the Lagrangian?")
    yield hint, right + 2 * stored
    yield _("This is the kinetic energy alone. What does the Lagrangian contain besides it?"), right + stored
    for hint, wrong in spring():
        yield hint, right + stored - wrong


def momentum(right: sp.Expr) -> Slips:
    """Yield the mistakes in p_X: the momentum of another coordinate or of the block alone, a square’s factor 2 lost."""
    sentence = _("This is the momentum of {coordinate}. With respect to which velocity do you differentiate?")
    yield from _of_others(sentence, elimination().momenta)
    rate = VELOCITIES[0]
    yield (
        _("You get this result if you leave out the 2 when you differentiate X′². What is the derivative of a square?"),
        right - right.coeff(rate) * rate / 2,
    )
    yield _("This is the momentum of the block alone. Which other bodies move when X changes?"), m * rate


def block_equation(right: sp.Expr) -> Slips:
    """Yield the mistakes in the equation of X: the momentum itself, the equation of another coordinate, a guess."""
    yield (
        _("This says that the momentum of X is zero. What does Lagrange’s equation say about its derivative?"),
        right.xreplace(dict(zip(ACCELERATIONS, VELOCITIES, strict=True))),
    )
    yield from _of_others(_("This is the equation of {coordinate}. Which one is asked for?"), elimination().motion)
    yield (
        _("This says that the centres of the lower rollers do not accelerate. Which forces act on them?"),
        ACCELERATIONS[0] - R * ACCELERATIONS[1],
    )


def _of_others(sentence: str, found: dict[sp.Expr, sp.Expr]) -> Slips:
    """Yield what belongs to φ and to Φ instead of X."""
    for q, shown in zip(COORDINATES[1:], "φΦ", strict=True):
        yield sentence.format(coordinate=shown), found[q]


# The elimination


def coupling(name: str, right: sp.Expr) -> Slips:
    """Yield the mistakes in Ẍ/φ̈ or Φ̈/φ̈: guesses, the reciprocal, another pair, and those of the elimination."""
    if name == "block_coupling":
        yield _("With this factor the centres of the lower rollers stay at rest. Which forces act on them?"), R
        yield _("With this factor the slab stays at rest. Which force acts on it?"), 2 * R
    else:
        yield _("With this factor all rollers turn alike. Which force makes the top cylinder turn?"), sp.S.One
    yield _("This is the reciprocal of the right answer. Which acceleration is multiplied by c?"), 1 / right
    block, top = (answer_of(each) for each in ("X_from_phi", "Phi_from_phi"))
    pairs = {"Xφ": block, "Φφ": top, "XΦ": block / top, "ΦX": top / block}
    asked = _(
        "This is the acceleration of {above} divided by that of {below}. Which two accelerations does the question "
        "compare?"
    )
    apart = _(
        "Apart from a factor R, this is the acceleration of {above} divided by that of {below}. Which two "
        "accelerations does the question compare?"
    )
    for (above, below), quotient in pairs.items():
        if quotient != right:
            yield asked.format(above=above, below=below), quotient
            for factor in (R, 1 / R):
                yield apart.format(above=above, below=below), quotient * factor
    yield from _of_masses(right)
    yield from machines.procedures(name)


def answer_of(equation: str) -> sp.Expr:
    """Return the factor of φ̈ in an equation of the elimination."""
    return getattr(elimination(), equation).coeff(phi_ddot)


def equation() -> Slips:
    """Yield the mistakes in the equation of motion of φ."""
    right = elimination().motion[phi].coeff(phi_ddot)
    hint = _("This is the factor after the other two accelerations are inserted. What is it before?")
    yield hint, answer_of("remaining")
    yield _("This is R times the right answer. Which common factor has been cancelled in the equation?"), right * R
    yield _("This is the reciprocal of the right answer. What multiplies the acceleration of φ?"), 1 / right
    yield from _of_masses(right)


def frequency(right: sp.Expr) -> Slips:
    """Yield the mistakes in Ω²."""
    yield _("This is Ω. The question asks for Ω². What do you get if you square it?"), sp.sqrt(right)
    yield _("This is Ω⁴. The question asks for Ω². What do you get if you take its root?"), right**2
    yield _("This is Ω² in units of k/m. Which factor turns it into the square of a frequency?"), right * m / k
    yield _("This is Ω² of a plain mass m on the same spring. Which other bodies move?"), k / m
    yield _("This is Ω² of the block and the slab alone, joined by the spring. Which other bodies move?"), 2 * k / m
    together = sum(body.mass for body in machines.right().bodies)
    yield _("This is Ω² of one mass as large as all bodies together. Do all bodies move alike?"), k / together
    equal = right.subs(m_prime, m)
    yield (
        _("This is Ω² for equal masses, m′ = m, in units of k/m. What changes if the lower rollers have another mass?"),
        equal * m / k,
    )
    yield _("This is Ω for equal masses, m′ = m. What is Ω² for any two masses?"), sp.sqrt(equal)
    yield _("This is the reciprocal of the right answer. Which unit does Ω² have?"), 1 / right
    yield from _of_masses(right)
    yield from machines.procedures("natural_frequency_squared")


def _of_masses(right: sp.Expr) -> Slips:
    """Yield an answer for equal masses, and answers with m and m′ interchanged."""
    hint = _("This is the answer for equal masses, m′ = m. What changes if the lower rollers have another mass?")
    for wrong in {right.subs(m_prime, m), right.subs(m, m_prime)}:
        yield hint, wrong
    hint = _("Somewhere in your answer m and m′ are interchanged. Which bodies have the mass m′?")
    above, below = sp.fraction(right)
    above_off, below_off = (part.xreplace({m: m_prime, m_prime: m}) for part in (above, below))
    for wrong in {above_off / below, above / below_off, above_off / below_off}:
        yield hint, wrong


# The mass ratio


def ratio() -> Slips:
    """Yield the mistakes in the unit mass ratio: slips in the quadratic formula, then those in the quadratic."""
    condition = unit_frequency_condition()
    (a, b, c), discriminant = condition.quadratic.all_coeffs(), condition.discriminant
    root = sp.sqrt(discriminant)
    yield _("This is the other root of the quadratic. Can a ratio of masses be negative?"), (-b - root) / (2 * a)
    hint = _("You get this result if b has the wrong sign. Which sign does b have in (−b ± √(b² − 4ac))/(2a)?")
    yield hint, (b + root) / (2 * a)
    yield _("This is the ratio m/m′. Which ratio does the question ask for?"), 1 / condition.root
    hint = _(
        "You get this result if you leave out the square root. What does the quadratic formula do with the "
        "discriminant?"
    )
    yield hint, (discriminant - b) / (2 * a)
    # Both slips lead to √(−c/a), because b² = b here.
    hint = _(
        "You get this result if you leave out the linear term bε, or if −b is under the root as well. What is b, "
        "and where does the root end?"
    )
    yield hint, sp.sqrt(-c / a)
    hint = _("You get this result if you divide only one of the two terms by 2a. Where do you need a bracket?")
    yield hint, root - b / (2 * a)
    yield hint, root / (2 * a) - b
    yield _("You get this result if you divide by a. By what does the quadratic formula divide?"), (root - b) / a
    yield _("You get this result if you leave out b in front of the root. What is b here?"), root / (2 * a)
    hint = _("You get this result if you leave out b² under the root. What is the discriminant?")
    yield hint, (sp.sqrt(-4 * a * c) - b) / (2 * a)
    hint = _("You get this result if you leave out the factor 4 under the root. What is the discriminant?")
    yield hint, (sp.sqrt(b**2 - a * c) - b) / (2 * a)
    for hint, wrong in _sides():
        yield hint, machines.positive_root(wrong.as_poly(epsilon))
    yield from machines.procedures("unit_mass_ratio")


def quadratic(right: sp.Expr) -> Slips:
    """Yield the mistakes in the quadratic equation for the unit mass ratio, those of the elimination among them."""
    hint = _("The term with ε is missing. In which terms of the denominator is ε?")
    yield hint, right - right.coeff(epsilon) * epsilon
    hint = _("This is the equation for m/m′. Which ratio is ε?")
    yield hint, sp.expand(right.subs(epsilon, 1 / epsilon) * epsilon**2)
    yield from _sides()
    yield from machines.procedures("unit_quadratic")


def _sides() -> Slips:
    """Yield slips on the way from Ω²m/k = 1 to the quadratic: in signs, and in the product in the numerator."""
    above, below = sp.fraction(unit_frequency_condition().normalized_frequency_squared)
    hint = _("You get this result if you add the two sides of Ω²m/k = 1. What is left when you subtract them?")
    yield hint, below + above
    terms = sp.expand(above).as_ordered_terms()
    kept = _("You get this result if {term} keeps its sign when you bring it to the other side. Which sign is right?")
    for term in terms:
        yield kept.format(term=str(term).replace("*varepsilon", "ε")), below - sum(terms) + 2 * term
    factor, inner = above.as_content_primitive()
    hint = _("You get this result if you leave out the factor {factor} of the numerator. What is Ω²m/k?")
    yield hint.format(factor=factor), below - inner
    hint = _("You get this result if you multiply only one term of a bracket. Which terms does the factor multiply?")
    for term in inner.as_ordered_terms():
        yield hint, below - inner - (factor - 1) * term
