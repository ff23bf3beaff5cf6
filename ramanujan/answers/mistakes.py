"""What typical mistakes give as the answer to each question, each with a hint and the question that leads on.

A mistake is a slip in a formula, an altered procedure (an acceleration dropped, a sign lost), or an altered machine.
Machines and procedures go through one elimination, in exact numbers at the points of `values`. Slips come first, exotic
machines last: the first mistake that gives a result is the one that is named.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, partial
from itertools import chain
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement, field

from ramanujan.answers import machines
from ramanujan.answers.values import POINTS, Values, evaluate, square_root
from ramanujan.derivation.elimination import Elimination, UnitCondition, eliminate, phi_ddot, unit_condition
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, Machine, R, k, m, m_prime, machine, phi, t
from ramanujan.translation import _

Variants = Iterator[tuple[str, sp.Expr | Values | None]]
"""Hints, and the results of the mistakes: formulas, or their values at the points; None where there is no solution."""


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
    in_common, in_exotic = (
        [(mistake.hint, mistake.bodies[name].kinetic_energy) for mistake in group() if mistake.altered == (name,)]
        for group in (machines.common, machines.exotic)
    )
    mixed = [term for term in sp.Add.make_args(sp.expand(body.kinetic_energy)) if len(_rates_in(term)) > 1]
    yield from in_common
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
    yield from in_exotic


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


# The elimination


Row = list[Any]


def equations(
    bodies: Machine, values: Mapping[sp.Expr, Any], number: Callable[[Any], Any]
) -> tuple[list[Row], Any, Any]:
    """Return the mass matrix of a machine, its stiffness ∂²U/∂φ², and the question's 4kR.

    Parameters
    ----------
    bodies : a machine
    values : symbol → its value, in any kind of number
    number : how to make such a number of a fraction
    """

    def worth(expression: sp.Expr) -> Any:
        return evaluate(expression, values, square_root, number)

    parts = [
        (worth(mass), [worth(rate) for rate in _rates_of(path)])
        for body in bodies.bodies
        for mass, path in ((body.mass, body.displacement), (body.moment_of_inertia, body.angle))
    ]
    matrix = [[sum((mass * v[i] * v[j] for mass, v in parts), number(0)) for j in range(3)] for i in range(3)]
    return matrix, worth(k * _rates_of(bodies.deformation)[1] ** 2), worth(4 * k * R)


@cache
def _rates_of(path: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(sp.diff(path, q) for q in COORDINATES)


def solved(name: str, matrix: list[Row], stiffness: Any, last_factor: Any) -> Any:
    """Return the answer to a question from the three equations of motion, None if it divides by zero.

    The X and Φ equations, rows 0 and 2, give Ẍ and Φ̈, which go into the φ equation. The question about the φ equation
    writes its last term as 4kRφ.
    """
    (a, b, c), (d, e, f), (g, h, i) = matrix
    if i:
        determinant, block, top = a * i - c * g, c * h - b * i, b * g - a * h
    else:
        # Without a top cylinder the Φ equation is empty.
        determinant, block, top = a, -b, 0 * a
    above, below = {
        "block_coupling": (block, determinant),
        "top_coupling": (top, determinant),
        "phi_equation": (e * last_factor, stiffness),
        "natural_frequency_squared": (stiffness * determinant, e * determinant + d * block + f * top),
    }[name]
    return above / below if below else None


PROCEDURES = (
    (
        _(
            "You get this result if you leave the acceleration of Φ out of the X equation. What does the Φ equation "
            "say about it?"
        ),
        (0, 2),
        0,
    ),
    (
        _(
            "You get this result if you leave out the acceleration of X, as if the block stood still. What does the X "
            "equation say about it?"
        ),
        (1, 0),
        0,
    ),
    (
        _(
            "You get this result if you insert the acceleration of Φ with the wrong sign. What does the Φ equation say "
            "about its sign?"
        ),
        (2, 0),
        -1,
    ),
    (
        _(
            "You get this result if you insert the acceleration of X with the wrong sign. What does the X equation say "
            "about its sign?"
        ),
        (1, 0),
        -1,
    ),
)
"""Hints at slips in the elimination: which entry of the three equations is multiplied by 0 or −1."""


def _through(name: str, system: Callable[[Machine], tuple[list[Row], Any, Any]]) -> Iterator[tuple[str, Any]]:
    """Yield what altered procedures give, then what altered machines give; `system` returns a machine's equations."""
    for hint, (row, column), factor in PROCEDURES:
        matrix, *rest = system(machines.right())
        altered = [
            [x * factor if (i, j) == (row, column) else x for j, x in enumerate(r)] for i, r in enumerate(matrix)
        ]
        yield hint, solved(name, altered, *rest)
    for mistake in chain(machines.common(), machines.exotic()):
        yield mistake.hint, solved(name, *system(mistake.bodies))


@cache
def _at_point(i: int, bodies: Machine) -> tuple[list[Row], Any, Any]:
    return equations(bodies, POINTS[i], Fraction)


def _eliminated(name: str) -> Variants:
    for each in zip(*(_through(name, partial(_at_point, i)) for i in range(len(POINTS))), strict=True):
        values = tuple(value for _hint, value in each)
        yield each[0][0], None if None in values else values


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
    one = _EPSILON.one
    units = {m: one, k: one, R: one, m_prime: _e}
    for hint, squared in _through("natural_frequency_squared", lambda bodies: equations(bodies, units, _number)):
        yield hint, _unit_mass_ratio(squared) if squared else None


_EPSILON, _e = field("e", sp.ZZ)


def _unit_mass_ratio(frequency_squared: FracElement) -> sp.Expr | None:
    """Return the positive ε for which Ω² = k/m; None if this is not a quadratic with exactly one positive root."""
    condition = (frequency_squared.denom - frequency_squared.numer).as_expr()
    a, b, c = (int(condition.coeff("e", n)) for n in (2, 1, 0))
    if frequency_squared.denom.degree() > 2 or a * c >= 0:
        return None
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - sp.Rational(b, a)) / 2


def _number(value: Any) -> FracElement:
    return _EPSILON(value.numerator) / value.denominator
