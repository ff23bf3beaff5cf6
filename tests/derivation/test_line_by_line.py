"""In the paper's route each equation follows from the earlier ones by the stated operation.

A function with the name of a step repeats its operation by plain SymPy, on the displayed equations. It returns
expressions that must vanish. test_my_numbers checks that the equations of all routes are true.
"""

import re
from collections.abc import Callable
from itertools import product

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import (
    ACCELERATIONS,
    COORDINATES,
    MOMENTA,
    VELOCITIES,
    Omega_squared,
    epsilon,
    k,
    m,
    m_prime,
    phi,
    t,
)
from ramanujan.derivation.printers import latex
from tests.checks.reference import difference, is_zero, spoiled

X_ddot, phi_ddot, Phi_ddot = ACCELERATIONS
Lines = Callable[[str], list[sp.Eq]]


def substitutions(group: list[sp.Eq]) -> dict[sp.Basic, sp.Basic]:
    """Return left side → right side, for substitutions."""
    return {relation.lhs: relation.rhs for relation in group}


def same_zero(first: sp.Eq, second: sp.Eq) -> sp.Expr:
    """Return an expression that vanishes if two equations differ by a factor independent of the motion."""
    ratio = sp.cancel(difference(first) / difference(second))
    return ratio.diff(X_ddot) + ratio.diff(phi_ddot) + ratio.diff(Phi_ddot) + ratio.diff(phi)


def momenta(at: Lines) -> list[sp.Expr]:
    return [e.rhs - at("lagrangian")[0].rhs.diff(u) for e, u in zip(at("momenta"), VELOCITIES, strict=True)]


def lagrangian(at: Lines) -> list[sp.Expr]:
    return [at("lagrangian")[0].rhs - at("sum")[0].rhs]


def rates(at: Lines) -> list[sp.Expr]:
    (function,), of = at("lagrangian"), substitutions(at("momenta"))
    differences = []
    for rate, p, q in zip(at("rates"), MOMENTA, COORDINATES, strict=True):
        differences += [rate.lhs - of[p].diff(t), rate.rhs - function.rhs.diff(q)]
    return differences


def motion(at: Lines) -> list[sp.Expr]:
    return [same_zero(*pair) for pair in zip(at("motion"), at("rates"), strict=True)]


def elimination(at: Lines) -> list[sp.Expr]:
    of_X, _, of_Phi = at("motion")
    first, multiplied, replaced, of_block, of_top = at("elimination")
    (turning,) = sp.solve(first, Phi_ddot)
    return [
        same_zero(first, of_Phi),
        same_zero(multiplied, of_X),
        replaced.rhs - multiplied.rhs,
        replaced.lhs - multiplied.lhs.subs(Phi_ddot, turning),
        of_block.rhs - sp.solve(replaced, X_ddot)[0],
        of_top.rhs - turning.subs(X_ddot, of_block.rhs),
    ]


def insertion(at: Lines) -> list[sp.Expr]:
    with_block, collected, *divided = at("insertion")
    return [
        difference(with_block) - difference(at("motion")[1]).subs(substitutions(at("elimination"))),
        difference(collected) - difference(with_block),
        *(same_zero(e, with_block) for e in divided),
        *(difference(e).diff(phi_ddot) - 1 for e in divided),
    ]


def frequency(at: Lines) -> list[sp.Expr]:
    oscillator, frequency_squared = at("frequency")
    with_cosine = difference(oscillator).subs(phi, sp.cos(sp.sqrt(Omega_squared) * t)).doit()
    return [with_cosine, frequency_squared.rhs - difference(at("insertion")[-1]).diff(phi)]


def unit(at: Lines) -> list[sp.Expr]:
    (_, in_parts, _), (to_one, cancelled, multiplied, quadratic) = at("ratio"), at("unit")
    plain = sp.Eq(in_parts.lhs.subs(Omega_squared, k / m), in_parts.rhs, evaluate=False)
    return [
        to_one.rhs / to_one.lhs.doit() - plain.rhs / plain.lhs,
        difference(cancelled) - difference(to_one),
        sp.diff(sp.cancel(difference(multiplied) / (difference(cancelled) * (6 * epsilon + 7))), epsilon),
        difference(quadratic) - difference(multiplied),
        cancelled.rhs,
    ]


def root(at: Lines) -> list[sp.Expr]:
    *lines, value = at("root")
    first, multiplied, cubes, square, other_cubes = map(difference, lines)
    return [
        first - difference(at("unit")[-1]),
        multiplied - 72 * first,
        *(each - multiplied for each in (cubes, square, other_cubes)),
        square.subs(epsilon, value.rhs),
        sp.Integer(0 if value.rhs.is_positive else 1),
    ]


def ratio(at: Lines) -> list[sp.Expr]:
    definition, in_parts, together = at("ratio")
    denominator = at("insertion")[2].lhs.diff(phi)
    return [
        definition.rhs - m_prime / m,
        (in_parts.rhs.subs(epsilon, definition.rhs) - denominator * m / k),
        in_parts.rhs - together.rhs,
    ]


def close(at: Lines) -> list[sp.Expr]:
    return [difference(at("close")[0]).subs(substitutions(at("frequency")))]


WALK = (lagrangian, momenta, rates, motion, elimination, insertion, frequency)
STEPS = {
    (masses, step.__name__): step
    for masses, steps in {"any": (*WALK, ratio, unit, root), "equal": (*WALK, close)}.items()
    for step in steps
}


def lines(masses: str, key: str = "", place: int = 0) -> Lines:
    """Return a function for the displayed equations of a step, with the equation at a place spoiled."""
    route = ROUTES["euler_lagrange"] if masses == "any" else ROUTES.with_equal_masses("euler_lagrange")
    return lambda step: [spoiled(e) if (step, n) == (key, place) else e for n, e in enumerate(route[step].equations)]


FACTORS = {
    ("euler_lagrange", "motion", 1): ("rates", 1),
    ("euler_lagrange", "motion", 2): ("rates", 2),
    ("euler_lagrange", "elimination", 1): ("motion", 0),
    ("euler_lagrange", "ratio", 1): ("frequency", 1),
    ("euler_lagrange", "unit", 2): ("unit", 1),
    ("euler_lagrange", "root", 1): ("root", 0),
    ("hamilton", "frequency", 2): ("reduction", 1),
    ("newton", "friction", 4): ("torques", 2),
    ("energy", "quotient", 0): ("energies", 2),
    ("energy", "quotient", 1): ("energies", 1),
    ("energy", "frequency", 1): ("quotient", 0),
    ("energy", "spring_mass", 0): ("frequency", 0),
}
"""Route, step and place of a line with a factor as operation → step and place of the changed line.

M_clamped is only a name in the routes. No line contains its value.
"""
NAMED_FACTOR = re.compile(r"\\(times|div) ((?!M_{\\text).+)|\\text\{cancel \$(?!8)(.+)\$\}")


def test_every_named_factor_connects_two_lines():
    steps = {(name, step.key): step for name in ROUTES for step in ROUTES[name].steps}
    matches = {}
    for (name, key), step in steps.items():
        for place, operation in enumerate(step.operations):
            match = NAMED_FACTOR.fullmatch(operation)
            if match:
                matches[name, key, place] = match
    assert matches.keys() == FACTORS.keys()
    for (name, key, place), match in matches.items():
        source_key, source_place = FACTORS[name, key, place]
        source, line = steps[name, source_key].equations[source_place], steps[name, key].equations[place]
        quotients = [
            sp.factor(before / after if match[1] != "times" else after / before)
            for before, after in ((difference(source), difference(line)), *product(source.args, line.args))
            if before != 0 != after
        ]
        operation = (match[2] or match[3]).removeprefix(r"\left(").removesuffix(r"\right)")
        multiple = 2 if "tfrac12" in operation else 1
        assert operation.replace(r"\tfrac12", "") in {latex(multiple * q) for q in quotients}, operation


@pytest.mark.parametrize(("masses", "key"), STEPS)
def test_each_equation_follows_and_an_altered_one_does_not(masses, key):
    follows = STEPS[masses, key]
    assert all(map(is_zero, follows(lines(masses))))
    for place in range(len(lines(masses)(key))):
        assert not all(map(is_zero, follows(lines(masses, key, place)))), place
