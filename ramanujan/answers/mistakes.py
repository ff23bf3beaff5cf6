"""Typical slips, each with a hint, an example and the wrong answers to which it leads.

A slip is an error in a formula, a guess, the answer to another question, or an error in the elimination. No two slips
of one question have the same result, so a result determines the slip. Mistakes about bodies are in `machines`.

The argument `right` of a function is the right answer to its question.
"""

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import sympy as sp

from ramanujan.answers import machines
from ramanujan.derivation.elimination import Elimination, eliminate, phi_ddot
from ramanujan.derivation.model import ACCELERATIONS, COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime, t
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.text.names import BODIES
from ramanujan.text.translation import _

HINTS = {
    "no_radius": _("You get this result if you leave out R. Which length belongs to an angle?"),
    # Energies
    "no_mixed_term": _("You get this result if you square a sum term by term. What is the mixed term of (a + b)²?"),
    "velocity_not_squared": _(
        "You get this result if you do not square the velocity. How does kinetic energy depend on velocity?"
    ),
    "no_half_of_energy": _("You get this result if you leave out the ½. What is the kinetic energy of a point mass?"),
    "no_half_of_translation": _(
        "You get this result if you leave out the ½ in the energy of translation. What is the kinetic energy of a "
        "point mass?"
    ),
    # The ½ of ½Iω² may be missing, or that of a cylinder's moment of inertia.
    "rotation_twice": _("In your answer the energy of rotation is twice the right one. What is I, and what is ½Iω²?"),
    "energies_subtracted": _(
        "You get this result if you subtract one energy from the other. Which sign does each kinetic energy have?"
    ),
    # TRANSLATORS: {body} is the hoop, the lower cylinder or the top cylinder.
    "rotation_alone": _("This is only the energy of rotation of {body}. How fast does its centre move?"),
    "no_half_of_spring": _("You get this result if you leave out the ½. What is the potential energy of a spring?"),
    "deformation_not_squared": _(
        "You get this result if you do not square the deformation. How does a spring’s energy depend on it?"
    ),
    "spring_to_ground": _(
        "You get this result if you take the displacement of the slab relative to the ground. Between which two bodies "
        "does the spring act?"
    ),
    "block_added": _(
        "You get this result if you take 2Rφ + X for the deformation. Between which two bodies does the spring act, "
        "and does their distance depend on X?"
    ),
    "spring_to_centres": _(
        "You get this result if the slab moves only as far as the centres of its rollers. How far does the top of a "
        "rolling body move?"
    ),
    # The Lagrangian, and the equations that follow from it
    "potential_energy_added": _(
        "You get this result if you add the potential energy. Which sign does it have in the Lagrangian?"
    ),
    "kinetic_energy_alone": _("This is the kinetic energy alone. What does the Lagrangian contain besides it?"),
    "other_momentum": _("This is the momentum of {coordinate}. With respect to which velocity do you differentiate?"),
    "no_factor_2": _(
        "You get this result if you leave out the 2 when you differentiate X′². What is the derivative of a square?"
    ),
    "block_alone": _("This is the momentum of the block alone. Which other bodies move when X changes?"),
    "momentum_is_zero": _(
        "This says that the momentum of X is zero. What does Lagrange’s equation say about its derivative?"
    ),
    "other_equation": _("This is the equation of {coordinate}. Which one is asked for?"),
    "centres_do_not_accelerate": _(
        "This says that the centres of the lower rollers do not accelerate. Which forces act on them?"
    ),
    # The elimination
    "centres_at_rest": _("With this factor the centres of the lower rollers stay at rest. Which forces act on them?"),
    "slab_at_rest": _("With this factor the slab stays at rest. Which force acts on it?"),
    "rollers_turn_alike": _("With this factor all rollers turn alike. Which force makes the top cylinder turn?"),
    "reciprocal_coupling": _("This is the reciprocal of the right answer. Which acceleration is multiplied by c?"),
    "other_pair": _(
        "This is the acceleration of {above} divided by that of {below}. Which two accelerations does the question "
        "compare?"
    ),
    "other_pair_and_radius": _(
        "Apart from a factor R, this is the acceleration of {above} divided by that of {below}. Which two "
        "accelerations does the question compare?"
    ),
    "after_insertion": _("This is the factor after the other two accelerations are inserted. What is it before?"),
    "times_radius": _("This is R times the right answer. Which common factor has been cancelled in the equation?"),
    "reciprocal_factor": _("This is the reciprocal of the right answer. What multiplies the acceleration of φ?"),
    "equal_masses": _(
        "This is the answer for equal masses, m′ = m. What changes if the lower rollers have another mass?"
    ),
    "masses_interchanged": _("Somewhere in your answer m and m′ are interchanged. Which bodies have the mass m′?"),
    "no_top_in_block_equation": _(
        "You get this result if you leave the acceleration of Φ out of the X equation. What does the Φ equation say "
        "about it?"
    ),
    "block_stands_still": _(
        "You get this result if you leave out the acceleration of X, as if the block stood still. What does the X "
        "equation say about it?"
    ),
    "wrong_sign_inserted": _(
        "You get this result if you insert the acceleration of {q} with the wrong sign. What does its equation say?"
    ),
    "square_root_of_answer": _("This is Ω. The question asks for Ω². What do you get if you square it?"),
    "square_of_answer": _("This is Ω⁴. The question asks for Ω². What do you get if you take its root?"),
    "normalized": _("This is Ω² in units of k/m. Which factor turns it into the square of a frequency?"),
    "plain_mass": _("This is Ω² of a plain mass m on the same spring. Which other bodies move?"),
    "block_and_slab": _("This is Ω² of the block and the slab alone, joined by the spring. Which other bodies move?"),
    "one_large_mass": _("This is Ω² of one mass as large as all bodies together. Do all bodies move alike?"),
    "equal_masses_normalized": _(
        "This is Ω² for equal masses, m′ = m, in units of k/m. What changes if the lower rollers have another mass?"
    ),
    "root_for_equal_masses": _("This is Ω for equal masses, m′ = m. What is Ω² for any two masses?"),
    "reciprocal_frequency": _("This is the reciprocal of the right answer. Which unit does Ω² have?"),
    # The mass ratio
    "other_root": _("This is the other root of the quadratic. Can a ratio of masses be negative?"),
    "sign_of_b": _("You get this result if b has the wrong sign. Which sign does b have in (−b ± √(b² − 4ac))/(2a)?"),
    "inverse_ratio": _("This is the ratio m/m′. Which ratio does the question ask for?"),
    "no_square_root": _(
        "You get this result if you leave out the square root. What does the quadratic formula do with the "
        "discriminant?"
    ),
    # Both slips lead to √(−c/a), because b² = b here.
    "no_linear_term": _(
        "You get this result if you leave out the linear term bε, or if −b is under the root as well. What is b, "
        "and where does the root end?"
    ),
    "only_one_term_divided": _(
        "You get this result if you divide only one of the two terms by 2a. Where do you need a bracket?"
    ),
    "divided_by_a": _("You get this result if you divide by a. By what does the quadratic formula divide?"),
    "no_b": _("You get this result if you leave out b in front of the root. What is b here?"),
    "no_b_squared": _("You get this result if you leave out b² under the root. What is the discriminant?"),
    "no_4_under_root": _("You get this result if you leave out the factor 4 under the root. What is the discriminant?"),
    "no_term_in_ratio": _("The term with ε is missing. In which terms of the denominator is ε?"),
    "equation_of_inverse": _("This is the equation for m/m′. Which ratio is ε?"),
    "sides_added": _("You get this result if you add the two sides of Ω²m/k = 1. What is left when you subtract them?"),
    "sign_kept": _(
        "You get this result if {term} keeps its sign when you bring it to the other side. Which sign is right?"
    ),
    "no_factor_of_numerator": _(
        "You get this result if you leave out the factor {factor} of the numerator. What is Ω²m/k?"
    ),
    "only_one_term_multiplied": _(
        "You get this result if you multiply only one term of a bracket. Which terms does the factor multiply?"
    ),
}
"""A sentence about each slip and the next question."""


class Slip(NamedTuple):
    """A slip in the answer to one question.

    Parameters
    ----------
    id : its key in `HINTS`
    hint : the hint, with its slots filled
    example : a wrong answer with this slip, to one of its questions, as typed: m' is a mass, X' and φ' are velocities
    results : the wrong answers to which it leads; None for a wrong equation without a solution
    """

    id: str
    hint: str
    example: str
    results: tuple[sp.Expr | None, ...]


Slips = Iterator[Slip]


def _make_slip(id: str, *results: sp.Expr | None, example: str, **slots: object) -> Slip:
    """Return a slip; `slots` are the values of the slots in its hint."""
    return Slip(id, HINTS[id].format(**slots), example, results)


def eliminate_right_machine() -> Elimination:
    """Return the elimination for the right machine."""
    return eliminate(machines.right_machine())


def find_radius_slip(right: sp.Expr) -> Slip:
    """Return the slip of leaving out R."""
    return _make_slip("no_radius", right.subs(R, 1), example="½m'(φ'-X')²+½m'φ'²")


# Energies


def find_energy_slips(name: str) -> Slips:
    """Yield the slips in the kinetic energy of one body."""
    body = machines.right_machine()[name]
    whole = sp.expand(body.kinetic_energy)
    translation, rotation = body.translation, body.rotation
    squares = [term for term in sp.Add.make_args(whole) if len(term.atoms(sp.Derivative)) == 1]
    yield _make_slip("no_mixed_term", sp.Add(*squares), example="½m'(R²φ'²+X'²)+½m'R²φ'²")
    # Without the square, the sign of the velocity depends on the positive direction, which the student chooses.
    momentum = body.mass * body.velocity
    angular_momentum = body.moment_of_inertia * body.angle.diff(t)
    results = (angular_momentum + momentum) / 2, (angular_momentum - momentum) / 2
    yield _make_slip("velocity_not_squared", *results, example="½mX'")
    yield _make_slip("no_half_of_energy", 2 * whole, example="mX'²")
    if rotation == 0:
        return
    yield _make_slip("no_half_of_translation", 2 * translation + rotation, example="m'(Rφ'-X')²+½m'R²φ'²")
    yield _make_slip("rotation_twice", whole + rotation, example="½m'(Rφ'-X')²+m'R²φ'²")
    # For a hoop the difference contains no φ′², so it equals an answer in which that term is missing.
    if body.shape_factor != 1:
        yield _make_slip(
            "energies_subtracted", translation - rotation, rotation - translation, example="½m'(Rφ'-X')²-¼m'R²φ'²"
        )
    yield _make_slip("rotation_alone", rotation, example="½m'R²φ'²", body=BODIES[name].in_sentence)


def find_spring_slips() -> Slips:
    """Yield the slips in the energy of the spring."""
    machine = machines.right_machine()
    path, block = machine.deformation, machine["block"].displacement
    yield _make_slip("no_half_of_spring", k * path**2, example="k(2Rφ)²")
    yield _make_slip("deformation_not_squared", k * path / 2, example="½k·2Rφ")
    yield _make_slip("spring_to_ground", k * (path + block) ** 2 / 2, example="½k(2Rφ-X)²")
    yield _make_slip("block_added", k * (path - block) ** 2 / 2, example="½k(2Rφ+X)²")
    yield _make_slip("spring_to_centres", k * (machine["hoop"].displacement - block) ** 2 / 2, example="½k(Rφ)²")


# The Lagrangian, and the equations that follow from it


def find_lagrangian_slips(right: sp.Expr) -> Slips:
    """Yield the slips in the Lagrangian: in the sign of U and in U itself."""
    potential = machines.right_machine().potential_energy
    kinetic = "½(3m+2m')X'² + ¼(8m+7m')R²φ'² + ¾mR²Φ'² - 2(m+m')RX'φ' - mRX'Φ'"
    yield _make_slip("potential_energy_added", right + 2 * potential, example=f"{kinetic} + 2kR²φ²")
    yield _make_slip("kinetic_energy_alone", right + potential, example=kinetic)
    for slip in find_spring_slips():
        yield slip._replace(results=tuple(right + potential - wrong for wrong in slip.results))


def find_momentum_slips(right: sp.Expr) -> Slips:
    """Yield the slips in the momentum p_X."""
    rate = VELOCITIES[0]
    yield from _find_coordinate_slips("other_momentum", "(3/2)mR²Φ' - mRX'", eliminate_right_machine().momenta)
    half_as_much = right - right.coeff(rate) * rate / 2
    yield _make_slip("no_factor_2", half_as_much, example="½(3m+2m')X' - 2(m+m')Rφ' - mRΦ'")
    yield _make_slip("block_alone", m * rate, example="mX'")


def find_block_equation_slips(right: sp.Expr) -> Slips:
    """Yield the slips in the equation of motion of X."""
    of_velocities = right.xreplace(dict(zip(ACCELERATIONS, VELOCITIES, strict=True)))
    yield _make_slip("momentum_is_zero", of_velocities, example="(3m+2m')X' = 2(m+m')Rφ' + mRΦ'")
    yield from _find_coordinate_slips("other_equation", "(3/2)RΦ'' = X''", eliminate_right_machine().motion)
    yield _make_slip("centres_do_not_accelerate", ACCELERATIONS[0] - R * ACCELERATIONS[1], example="X'' = Rφ''")


def _find_coordinate_slips(id: str, example: str, results: dict[sp.Expr, sp.Expr]) -> Slips:
    """Yield the slips of answering for φ or Φ instead of X."""
    for q, letter in zip(COORDINATES[1:], "φΦ", strict=True):
        yield _make_slip(id, results[q], example=example, coordinate=letter)


# The elimination


def find_coupling_slips(name: str, right: sp.Expr) -> Slips:
    """Yield the slips in Ẍ/φ̈ or Φ̈/φ̈: guesses, the reciprocal, another quotient, and slips of the elimination."""
    if name == "block_coupling":
        yield _make_slip("centres_at_rest", R, example="R")
        yield _make_slip("slab_at_rest", 2 * R, example="2R")
    else:
        yield _make_slip("rollers_turn_alike", sp.S.One, example="1")
    yield _make_slip("reciprocal_coupling", 1 / right, example="(7m+6m')/(4(m+m'))")
    block = find_factor_of_acceleration("X_ddot_from_phi_ddot")
    top = find_factor_of_acceleration("Phi_ddot_from_phi_ddot")
    quotients = {("X", "φ"): block, ("Φ", "φ"): top, ("X", "Φ"): block / top, ("Φ", "X"): top / block}
    for (above, below), quotient in quotients.items():
        if quotient != right:
            pair = {"above": above, "below": below}
            yield _make_slip("other_pair", quotient, example="4(m+m')/(7m+6m')", **pair)
            yield _make_slip("other_pair_and_radius", quotient * R, quotient / R, example="2/3", **pair)
    yield from _find_mass_slips(right)
    yield from find_elimination_slips(name)


def find_factor_of_acceleration(equation: str) -> sp.Expr:
    """Return the factor of φ̈ in an equation of the elimination: `equation` is an attribute of `Elimination`."""
    return getattr(eliminate_right_machine(), equation).coeff(phi_ddot)


def find_phi_equation_slips(right: sp.Expr) -> Slips:
    """Yield the slips in the factor of φ̈ in the equation of motion of φ."""
    yield _make_slip(
        "after_insertion", find_factor_of_acceleration("remaining"), example="R(32m²+49mm'+18m'²)/(2(7m+6m'))"
    )
    yield _make_slip("times_radius", right * R, example="R²(8m+7m')/2")
    yield _make_slip("reciprocal_factor", 1 / right, example="2/(R(8m+7m'))")
    yield from _find_mass_slips(right)


def find_frequency_slips(right: sp.Expr) -> Slips:
    """Yield the slips in Ω²."""
    for_equal_masses = right.subs(m_prime, m)
    total_mass = sum(body.mass for body in machines.right_machine().bodies)
    yield _make_slip("square_root_of_answer", sp.sqrt(right), example="√(8k(7m+6m')/(32m²+49mm'+18m'²))")
    yield _make_slip("square_of_answer", right**2, example="(8k(7m+6m')/(32m²+49mm'+18m'²))²")
    yield _make_slip("normalized", right * m / k, example="8m(7m+6m')/(32m²+49mm'+18m'²)")
    yield _make_slip("plain_mass", k / m, example="k/m")
    yield _make_slip("block_and_slab", 2 * k / m, example="2k/m")
    yield _make_slip("one_large_mass", k / total_mass, example="k/(3m+2m')")
    yield _make_slip("equal_masses_normalized", for_equal_masses * m / k, example="104/99")
    yield _make_slip("root_for_equal_masses", sp.sqrt(for_equal_masses), example="√(104k/(99m))")
    yield _make_slip("reciprocal_frequency", 1 / right, example="(32m²+49mm'+18m'²)/(8k(7m+6m'))")
    yield from _find_mass_slips(right)
    yield from find_elimination_slips("natural_frequency_squared")


def _find_mass_slips(right: sp.Expr) -> Slips:
    """Yield the slips of answering for equal masses, and of interchanging m and m′."""
    yield _make_slip("equal_masses", right.subs(m_prime, m), right.subs(m, m_prime), example="12R/13")
    numerator, denominator = sp.fraction(right)
    interchange = {m: m_prime, m_prime: m}
    wrong_numerator, wrong_denominator = numerator.xreplace(interchange), denominator.xreplace(interchange)
    results = wrong_numerator / denominator, numerator / wrong_denominator, wrong_numerator / wrong_denominator
    yield _make_slip("masses_interchanged", *results, example="6R(m+m')/(6m+7m')")


def find_elimination_slips(name: str) -> Slips:
    """Yield the slips in the elimination; each multiplies one entry of the mass matrix by a factor."""
    solve = partial(machines.solve, name, machines.right_machine())
    # The rows and columns 0, 1 and 2 belong to X, φ and Φ.
    yield _make_slip("no_top_in_block_equation", solve({(0, 2): 0}), example="2(m+m')R/(3m+2m')")
    yield _make_slip("block_stands_still", solve({(1, 0): 0}), example="8k/(8m+7m')")
    for letter, row in (("Φ", 2), ("X", 1)):
        yield _make_slip("wrong_sign_inserted", solve({(row, 0): -1}), example="6R(m+m')/(11m+6m')", q=letter)


# The mass ratio


def find_mass_ratio_slips() -> Slips:
    """Yield the slips in the mass ratio with Ω²m/k = 1: in the quadratic formula, then in the quadratic."""
    condition = unit_frequency_condition()
    (a, b, c), discriminant = condition.quadratic.all_coeffs(), condition.discriminant
    root = sp.sqrt(discriminant)
    yield _make_slip("other_root", (-b - root) / (2 * a), example="(-√1729-1)/36")
    yield _make_slip("sign_of_b", (b + root) / (2 * a), example="(√1729+1)/36")
    yield _make_slip("inverse_ratio", 1 / condition.root, example="36/(√1729-1)")
    yield _make_slip("no_square_root", (discriminant - b) / (2 * a), example="(1729-1)/36")
    yield _make_slip("no_linear_term", sp.sqrt(-c / a), example="√(24/18)")
    yield _make_slip("only_one_term_divided", root - b / (2 * a), root / (2 * a) - b, example="√1729-1/36")
    yield _make_slip("divided_by_a", (root - b) / a, example="(√1729-1)/18")
    yield _make_slip("no_b", root / (2 * a), example="√1729/36")
    yield _make_slip("no_b_squared", (sp.sqrt(-4 * a * c) - b) / (2 * a), example="(√1728-1)/36")
    yield _make_slip("no_4_under_root", (sp.sqrt(b**2 - a * c) - b) / (2 * a), example="(√433-1)/36")
    for slip in _find_condition_slips():
        roots = (machines.find_positive_root(sp.Poly(wrong, epsilon)) for wrong in slip.results)
        yield slip._replace(results=tuple(roots))
    yield from find_elimination_slips("unit_mass_ratio")


def find_quadratic_slips(right: sp.Expr) -> Slips:
    """Yield the slips in the quadratic equation for the mass ratio with Ω²m/k = 1."""
    yield _make_slip("no_term_in_ratio", right - right.coeff(epsilon) * epsilon, example="18ε² = 24")
    of_inverse = sp.expand(right.subs(epsilon, 1 / epsilon) * epsilon**2)
    yield _make_slip("equation_of_inverse", of_inverse, example="24ε² = ε + 18")
    yield from _find_condition_slips()
    yield from find_elimination_slips("unit_quadratic")


def _find_condition_slips() -> Slips:
    """Yield the slips between Ω²m/k = 1 and the quadratic: in signs, and in the product in the numerator."""
    above, below = sp.fraction(unit_frequency_condition().normalized_frequency_squared)
    yield _make_slip("sides_added", below + above, example="18ε² + 97ε + 88 = 0")
    terms = sp.expand(above).as_ordered_terms()
    for term in terms:
        shown = str(term).replace("*varepsilon", "ε")
        yield _make_slip("sign_kept", below - sum(terms) + 2 * term, example="18ε² + 97ε - 24 = 0", term=shown)
    factor, inner = above.as_content_primitive()
    yield _make_slip("no_factor_of_numerator", below - inner, example="18ε² + 43ε + 25 = 0", factor=factor)
    one_term = (below - inner - (factor - 1) * term for term in inner.as_ordered_terms())
    yield _make_slip("only_one_term_multiplied", *one_term, example="18ε² + 49ε + 32 = 8·7 + 6ε")
