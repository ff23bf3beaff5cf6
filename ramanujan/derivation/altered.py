"""The elimination for an altered machine, fast enough for many: mass matrices as polynomials."""

from __future__ import annotations

from functools import cache

import sympy as sp

from ramanujan.derivation.expansion import NormalForm
from ramanujan.derivation.expressions import SPELLING
from ramanujan.derivation.normal_form import MINUS_ONE, ZERO, coefficients, minus, over, plus, times
from ramanujan.derivation.polynomials import VARIABLES
from ramanujan.derivation.symbols import (
    COORDINATES,
    Body,
    Machine,
    R,
    k,
    machine,
    phi,
)

_COORDINATES = tuple(SPELLING[q] for q in COORDINATES)


def single_mass(bodies: Machine, name: str) -> NormalForm | None:
    """Return one result of the elimination for a machine: the factor of φ̈ in Ẍ, in Φ̈ or in the φ equation, or Ω².

    The X and Φ equations are solved for Ẍ and Φ̈, which are inserted into the φ equation, as in
    `elimination.eliminate`. The mass matrix and polynomials make this fast enough for many machines. The spring's
    deformation is taken to depend on φ alone.

    Parameters
    ----------
    bodies : the machine
    name : block_coupling, top_coupling, phi_equation or natural_frequency_squared; None is returned where that divides
        by zero
    """
    stiffness = _form(k * bodies.deformation.coeff(phi) ** 2)
    if name == "phi_equation":
        # The question writes the φ equation with 4kRφ as its last term.
        above, below = times(_inertia(bodies, "phi", "phi"), _form(4 * k * R)), stiffness
    else:
        determinant, block, top, inertia = _eliminated(bodies)
        above, below = {
            "block_coupling": (block, determinant),
            "top_coupling": (top, determinant),
            "natural_frequency_squared": (times(stiffness, determinant), inertia),
        }[name]
    return None if below.is_zero else over(above, below)


@cache
def _eliminated(bodies: Machine) -> tuple[NormalForm, NormalForm, NormalForm, NormalForm]:
    """Return D, B, T and J of Ẍ = (B/D)φ̈, Φ̈ = (T/D)φ̈ and Ω² = stiffness·D/J."""
    M = {(i, j): _inertia(bodies, _COORDINATES[i], _COORDINATES[j]) for i in range(3) for j in range(i, 3)}
    if M[2, 2].is_zero:
        # Without a top cylinder the Φ equation is empty.
        determinant, block, top = M[0, 0], times(MINUS_ONE, M[0, 1]), ZERO
    else:
        determinant = minus(times(M[0, 0], M[2, 2]), times(M[0, 2], M[0, 2]))
        block = minus(times(M[0, 2], M[1, 2]), times(M[0, 1], M[2, 2]))
        top = minus(times(M[0, 1], M[0, 2]), times(M[0, 0], M[1, 2]))
    inertia = plus(times(M[1, 1], determinant), times(M[0, 1], block), times(M[1, 2], top))
    return determinant, block, top, inertia


@cache
def _inertia(bodies: Machine, q: str, other: str) -> NormalForm:
    """Return the entry of the mass matrix that belongs to two coordinates."""
    paper = right()
    if bodies == paper:
        return plus(*(_share(body, q, other) for body in bodies.bodies))
    # A mistake leaves most bodies as they are.
    changed = [(body, paper[body.name]) for body in bodies.bodies if body != paper[body.name]]
    changes = (minus(_share(body, q, other), _share(original, q, other)) for body, original in changed)
    return plus(_inertia(paper, q, other), *changes)


@cache
def _share(body: Body, q: str, other: str) -> NormalForm:
    """Return the contribution of a body to an entry of the mass matrix."""
    moved, turned = _rates_of(body.displacement), _rates_of(body.angle)
    translation = times(_form(body.mass), moved.get(q, ZERO), moved.get(other, ZERO))
    rotation = times(_form(body.moment_of_inertia), turned.get(q, ZERO), turned.get(other, ZERO))
    return plus(translation, rotation)


@cache
def _rates_of(displacement: sp.Expr) -> dict[str, NormalForm]:
    """Return the factor of each coordinate in a displacement or an angle."""
    by_product = coefficients(_form(displacement), _COORDINATES)
    return {VARIABLES[product.index(1)]: coefficient for product, coefficient in by_product.items()}


_form = cache(NormalForm.of)

right = cache(machine)
