"""Mistakes about the bodies, and the answers that follow from the equations of motion of an altered machine.

A mistake changes the mass, inertia, velocity or angle of one body or of a group. The equations of motion of every
altered machine are solved exactly, for any mass ratio.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from types import MappingProxyType
from typing import Any

import sympy as sp
from sympy.polys.fields import FracElement
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from ramanujan.derivation import model
from ramanujan.derivation.model import COORDINATES, Body, Machine, Phi, R, X, epsilon, k, m, m_prime, phi
from ramanujan.text.names import BODIES
from ramanujan.text.translation import _

_LOWER, _ROLLERS, _RIDERS = "hoop cylinder", "hoop cylinder top", "hoop cylinder slab top"
_GROUPS = {
    **{body: names.in_sentence for body, names in BODIES.items()},
    _LOWER: _("the lower rollers"),
    _ROLLERS: _("all rollers"),
    _RIDERS: _("everything on the block"),
}
_SHAPES = {
    model.HOOP: (
        _("a hoop"),
        ("lagrangian", "½(3m+2m')X'² + (2m+2m')R²φ'² + ¾mR²Φ'² - 2(m+m')RX'φ' - mRX'Φ' - 2kR²φ²"),
    ),
    model.SOLID_CYLINDER: (_("a solid cylinder"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+¼m'R²φ'²")),
    sp.Rational(2, 3): (_("a spherical shell"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+⅓m'R²φ'²")),
    sp.Rational(2, 5): (_("a solid sphere"), ("kinetic_energy_hoop", "½m'(Rφ'-X')²+⅕m'R²φ'²")),
}
"""Shape factor → the name of the body in a sentence, and an example of a mistake with it."""

right_machine = cache(model.machine)
"""Return the machine of the paper."""


@dataclass(frozen=True)
class Mistake:
    """A mistake about bodies.

    Parameters
    ----------
    id : the id
    hint : a sentence and the next question, with slots for the {body} and its {mass}, {angle} or {shape}
    groups : the bodies and groups of bodies about which one can make the mistake
    change : function (body) → its wrong attributes
    example : the name of a question, and a wrong answer with this mistake
    """

    id: str
    hint: str
    groups: tuple[str, ...]
    change: Callable[[Body], dict[str, Any]]
    example: tuple[str, str]

    @property
    def changes_only_inertia(self) -> bool:
        """Whether the mistake changes only moments of inertia."""
        return self.id == "no_rotation" or self.id.startswith("inertia")


@dataclass(frozen=True)
class AlteredMachine:
    """The machine with a mistake about a group of bodies, whose names `group` contains."""

    mistake: Mistake
    group: str
    machine: Machine

    @property
    def bodies(self) -> frozenset[str]:
        """The names of the altered bodies."""
        return frozenset(self.group.split())

    @property
    def hint(self) -> str:
        """The hint, with its slots filled."""
        # A hint about a group mentions only properties that its bodies share, so any body of the group will do.
        *_others, last = self.group.split()
        body = self.machine[last]
        shape_name, _example = _SHAPES.get(body.shape_factor, ("", None))
        return self.mistake.hint.format(
            body=_GROUPS[self.group],
            mass="m" if body.mass == m else "m′",
            angle="φ" if body.displacement.has(phi) else "Φ",
            shape=shape_name,
        )


def _swap_angles(body: Body) -> dict[str, Any]:
    swapped = {phi: Phi, Phi: phi}
    return {"displacement": body.displacement.xreplace(swapped), "angle": body.angle.xreplace(swapped)}


def _with_shape_factor(beta: sp.Rational) -> Callable[[Body], dict[str, Any]]:
    """Return the change that gives a body this shape factor."""
    return lambda _body: {"shape_factor": beta}


MISTAKES = (
    Mistake(
        id="no_rotation",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_("You get this result if you leave out the rotation of {body}. What is the energy of a rotation?"),
        groups=(*_ROLLERS.split(), _LOWER, _ROLLERS),
        change=lambda _body: {"shape_factor": sp.S.Zero},
        example=("kinetic_energy_hoop", "½m'(Rφ'-X')²"),
    ),
    Mistake(
        id="rolls_on_ground",
        hint=_(
            # TRANSLATORS: {body} is the hoop, the lower rollers … as translated for this.
            "You get this result if you divide the velocity of {body} relative to the ground by R to find the angular "
            "velocity. On which surface does a roller roll?"
        ),
        groups=(*_ROLLERS.split(), _LOWER, _ROLLERS),
        change=lambda body: {"angle": sp.expand(body.displacement / R)},
        example=("kinetic_energy_hoop", "½m'(Rφ'-X')²+½m'(Rφ'-X')²"),
    ),
    Mistake(
        id="other_mass",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_("You get this result if you give the mass {mass} to {body}. Which bodies have this mass?"),
        groups=(*BODIES, _LOWER),
        change=lambda body: {"mass": m if body.mass == m_prime else m_prime},
        example=("kinetic_energy_block", "½m'X'²"),
    ),
    Mistake(
        id="sign_of_X",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_("You get this result if you add X′ to the velocity of {body}. In which direction does the block move?"),
        groups=(*_RIDERS.split(), _LOWER),
        change=lambda body: {"displacement": body.displacement.subs(X, -X)},
        example=("kinetic_energy_hoop", "½m'(Rφ'+X')²+½m'R²φ'²"),
    ),
    Mistake(
        id="relative_to_block",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_(
            "You get this result if you take the velocity of {body} relative to the block. How does the block move?"
        ),
        groups=(*_RIDERS.split(), _LOWER, _RIDERS),
        change=lambda body: {"displacement": body.displacement.subs(X, 0)},
        example=("kinetic_energy_hoop", "m'R²φ'²"),
    ),
    Mistake(
        id="slab_as_centres",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_(
            "You get this result if {body} moves only as far as the centres of its rollers. How far do their tops move?"
        ),
        groups=("slab",),
        change=lambda _body: {"displacement": right_machine()["hoop"].displacement},
        example=("kinetic_energy_slab", "½m(Rφ'-X')²"),
    ),
    Mistake(
        id="roller_as_slab",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_(
            "You get this result if you let {body} move as far as the slab. How far does the centre of a roller move?"
        ),
        groups=(*_LOWER.split(), _LOWER),
        change=lambda _body: {"displacement": right_machine()["slab"].displacement},
        example=("kinetic_energy_hoop", "½m'(2Rφ'-X')²+½m'R²φ'²"),
    ),
    Mistake(
        id="other_angle",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_("You get this result if you use the angle {angle} for {body}. Which bodies turn by this angle?"),
        groups=tuple(_RIDERS.split()),
        change=_swap_angles,
        example=("kinetic_energy_hoop", "½m'(RΦ'-X')²+½m'R²Φ'²"),
    ),
    *(
        Mistake(
            id=f"inertia_{shape}",
            # TRANSLATORS: {body} is the hoop, the top cylinder …; {shape} is a hoop, a solid cylinder …
            hint=_("You get this result if {body} has the moment of inertia of {shape}. What is the right one?"),
            groups=tuple(_ROLLERS.split()),
            change=_with_shape_factor(shape),
            example=example,
        )
        for shape, (_name, example) in _SHAPES.items()
    ),
    Mistake(
        id="left_out",
        # TRANSLATORS: {body} is the block, the hoop, the lower rollers … as translated for this.
        hint=_("You get this result if you leave out {body}. Which bodies have kinetic energy?"),
        groups=tuple(BODIES),
        change=lambda _body: {"mass": sp.S.Zero},
        example=("lagrangian", "(m+m')X'² + ¼(8m+7m')R²φ'² - 2(m+m')RX'φ' - 2kR²φ²"),
    ),
)


@cache
def list_altered_machines() -> tuple[AlteredMachine, ...]:
    """Return an altered machine for each mistake and each of its groups of bodies.

    Machines that equal the right one are left out.
    """
    machines = []
    for mistake in MISTAKES:
        for group in mistake.groups:
            names = group.split()
            bodies = (
                replace(body, **mistake.change(body)) if body.name in names else body for body in right_machine().bodies
            )
            altered = AlteredMachine(mistake, group, Machine(tuple(bodies)))
            if altered.machine != right_machine():
                machines.append(altered)
    return tuple(machines)


def find_common_hint(alternatives: Sequence[AlteredMachine]) -> str | None:
    """Return the hint for altered machines with the same result, None without a common hint.

    If the smallest group is part of every other group, the hint is about the smallest group. The other bodies do not
    affect the result. Different moments of inertia of the lower rollers have a separate hint. Other mistakes have a
    common hint only if they are the same.
    """
    smallest = min(alternatives, key=lambda altered: len(altered.bodies))
    has_same_mistake = all(altered.mistake is smallest.mistake for altered in alternatives)
    if has_same_mistake and all(smallest.bodies <= altered.bodies for altered in alternatives):
        return smallest.hint
    lower_rollers = frozenset(_LOWER.split())
    if all(altered.mistake.changes_only_inertia and altered.bodies <= lower_rollers for altered in alternatives):
        return _("You get this result with other moments of inertia of the lower rollers. What are they?")
    return None


# The equations of motion


_DOMAIN = sp.ZZ.frac_field(epsilon)
_UNITS = {m: sp.S.One, k: sp.S.One, R: sp.S.One, m_prime: epsilon}
"""In units of m, k and R, an answer is a quotient of polynomials in the mass ratio."""
_FORCE_ON_PHI = DomainMatrix([[_DOMAIN.zero], [_DOMAIN.one], [_DOMAIN.zero]], (3, 1), _DOMAIN)


@cache
def mass_matrix(machine: Machine) -> tuple[tuple[sp.Expr, ...], ...]:
    """Return the mass matrix of a machine, in the order X, φ, Φ."""
    gradients = [(body.mass, _gradient(body.displacement)) for body in machine.bodies]
    gradients += [(body.moment_of_inertia, _gradient(body.angle)) for body in machine.bodies]

    def entry(i: int, j: int) -> sp.Expr:
        return sp.Add(*(inertia * gradient[i] * gradient[j] for inertia, gradient in gradients))

    size = len(COORDINATES)
    return tuple(tuple(entry(i, j) for j in range(size)) for i in range(size))


@cache
def _gradient(path: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the derivatives of a displacement or an angle with respect to X, φ and Φ."""
    return tuple(sp.diff(path, q) for q in COORDINATES)


def solve(name: str, machine: Machine, factors: Mapping[tuple[int, int], int] = MappingProxyType({})) -> sp.Expr | None:
    """Return the answer to a question from the equations of motion M a = −∂U/∂q, None without a solution.

    The only force is −∂U/∂φ = −stiffness·φ. So the accelerations are proportional to the column φ of M⁻¹. Ω² is the
    stiffness times the entry of this column in the row φ.

    Parameters
    ----------
    name : the question
    machine : the right or an altered machine
    factors : row and column of an entry of M → its factor, for a slip in the elimination
    """
    matrix = [[_convert_to_units(entry) for entry in row] for row in mass_matrix(machine)]
    for (row, column), factor in factors.items():
        matrix[row][column] *= factor
    # Without a top cylinder the Φ equation is empty. This entry makes Φ̈ zero.
    matrix[2][2] = matrix[2][2] or _DOMAIN.one
    stiffness = _convert_to_units(k * _gradient(machine.deformation)[1] ** 2)
    try:
        column = DomainMatrix(matrix, (3, 3), _DOMAIN).lu_solve(_FORCE_ON_PHI)
    except DMNonInvertibleMatrixError:
        return None
    X_entry, phi_entry, Phi_entry = column.to_list_flat()
    if name == "block_coupling":
        return _divide(X_entry, phi_entry, R)
    if name == "top_coupling":
        return _divide(Phi_entry, phi_entry, sp.S.One)
    if name == "phi_equation":
        # The answer is the factor of φ̈ if the last term is 4kRφ, instead of the stiffness times φ.
        return _divide(4 * matrix[1][1], stiffness, m * R)
    if name in ("unit_quadratic", "unit_mass_ratio"):
        return _solve_condition(name, stiffness * phi_entry)
    return k / m * (stiffness * phi_entry).as_expr()


def _divide(numerator: FracElement, denominator: FracElement, unit: sp.Expr) -> sp.Expr | None:
    """Return a quotient times its unit, None if it divides by zero."""
    return unit * (numerator / denominator).as_expr() if denominator else None


def _solve_condition(name: str, squared: FracElement) -> sp.Expr | None:
    """Return the quadratic equation for Ω² = k/m, or its positive root."""
    condition = (squared.denom - squared.numer).as_expr().as_poly(epsilon)
    if condition.degree() != 2:
        return None
    if name == "unit_mass_ratio":
        return find_positive_root(condition)
    # An equation with one term states only that this term is zero.
    return condition.as_expr() if len(condition.terms()) > 1 else None


def _convert_to_units(expression: sp.Expr) -> FracElement:
    """Return an expression in units of m, k and R, with ε for m′."""
    return _DOMAIN.from_sympy(sp.sympify(expression).xreplace(_UNITS))


def find_positive_root(condition: sp.Poly) -> sp.Expr | None:
    """Return the positive root of a quadratic, None unless one root is positive and the other negative."""
    a, b, c = condition.all_coeffs()
    has_roots_of_both_signs = a * c < 0
    if not has_roots_of_both_signs:
        return None
    return (sp.sqrt(b**2 - 4 * a * c) / abs(a) - b / a) / 2
