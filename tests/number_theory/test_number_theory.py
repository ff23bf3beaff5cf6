"""The 1729 arithmetic against brute force, SymPy, and the derivation for any bodies."""

import dataclasses
import math
from collections import defaultdict
from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import ramanujan.number_theory as nt
from ramanujan.derivation import model
from ramanujan.derivation.elimination import eliminate

PAPER = (18, 1, -24)
LIGHT_ROLLERS_LIMIT = Fraction(7, 4)

unhurried = settings(deadline=None, max_examples=80)
shape_factors = st.fractions(min_value=0, max_value=1, max_denominator=30)
positive_shape_factors = shape_factors.filter(bool)
# A target reachable by every machine: (2+γ)/(1+γ) is least, 5/3, for γ = 1/2.
common_targets = st.fractions(min_value=Fraction(1, 60), max_value=Fraction(99, 60), max_denominator=60)


# The independent route

BETAS = sp.symbols("beta_a beta_b beta_c", positive=True)
UNITS = {each: 1 for each in (model.m, model.k, model.R)} | {model.m_prime: model.epsilon}


@cache
def derived_frequency() -> sp.Expr:
    """Return Ω²m/k of a machine with these bodies, by rolling constraints and Lagrange's equations."""
    bodies = model.machine(**dict(zip(("hoop", "cylinder", "top"), BETAS, strict=True)))
    return eliminate(bodies).natural_frequency_squared.xreplace(UNITS)


def exact(number: Fraction) -> sp.Rational:
    return sp.Rational(number.numerator, number.denominator)


def derived_quadratic(betas: tuple[Fraction, ...], target: Fraction) -> tuple[int, ...]:
    frequency = derived_frequency().subs(dict(zip(BETAS, map(exact, betas), strict=True)))
    excess = sp.together(frequency - exact(target))
    _, polynomial = sp.Poly(sp.numer(excess), model.epsilon).clear_denoms(convert=True)
    coefficients = [int(x) for x in polynomial.primitive()[1].all_coeffs()]
    return tuple(x if coefficients[0] > 0 else -x for x in coefficients)


def betas_of(machine: nt.BodyChoice) -> tuple[Fraction, ...]:
    return tuple(nt.BODIES[name] for name in machine.bodies)


def family(target: Fraction) -> list[nt.BodyChoice]:
    return [dataclasses.replace(machine, target=target) for machine in nt.machines()]


# Machines and quadratics


def test_paper_machine():
    machine = nt.BodyChoice()
    assert nt.unit_quadratic("hoop", "cylinder", "cylinder") == PAPER == machine.quadratic
    assert nt.unit_quadratic(1, Fraction(1, 2), Fraction(1, 2)) == PAPER
    assert nt.discriminant(*PAPER) == machine.discriminant == 1729
    assert machine.factorization == ((7, 1), (13, 1), (19, 1))
    assert machine.cubes == ((1, 12), (9, 10))
    assert machine.field_discriminant == 1729


def test_shape_factors_are_moments_of_inertia():
    """β = I/(MR²), integrated over the radius for bodies of revolution about their axis."""
    r, z = sp.symbols("r z", positive=True)
    disc = sp.integrate(r**3, (r, 0, 1)) / sp.integrate(r, (r, 0, 1))
    # A ball is a stack of discs, a shell a stack of rings of equal area per height (Archimedes).
    ball = sp.integrate((1 - z**2) ** 2 / 2, (z, -1, 1)) / sp.integrate(1 - z**2, (z, -1, 1))
    shell = sp.integrate(1 - z**2, (z, -1, 1)) / 2
    assert {name: exact(beta) for name, beta in nt.BODIES.items()} == {
        "hoop": 1,
        "shell": shell,
        "cylinder": disc,
        "sphere": ball,
    }
    with pytest.raises(TypeError):
        nt.BODIES["ring"] = Fraction(1)


@pytest.mark.parametrize("machine", nt.machines(), ids=lambda m: "-".join(m.bodies))
def test_every_machine_agrees_with_the_derivation(machine):
    a, b, c = machine.quadratic
    assert (a, b, c) == derived_quadratic(betas_of(machine), Fraction(1))
    polynomial = sp.Poly([a, b, c], sp.Symbol("x"))
    assert polynomial.primitive() == (1, polynomial)
    assert polynomial.count_roots(0, None) == 1
    assert machine.discriminant == polynomial.discriminant()
    assert dict(machine.factorization) == sp.factorint(machine.discriminant)


@unhurried
@given(st.tuples(positive_shape_factors, positive_shape_factors, shape_factors), common_targets)
def test_any_bodies_and_target_agree_with_the_derivation(betas, target):
    assert nt.unit_quadratic(*betas, target) == derived_quadratic(betas, target)


@unhurried
@given(st.tuples(shape_factors, shape_factors, shape_factors), st.fractions(min_value=0, max_denominator=10**6))
def test_exact_frequency_agrees_with_the_derivation(betas, ratio):
    expected = derived_frequency().subs(dict(zip((*BETAS, model.epsilon), map(exact, (*betas, ratio)), strict=True)))
    assert exact(nt.normalized_frequency_squared_exact(*betas, ratio)) == expected


def test_top_body_without_rotational_inertia_makes_the_ratio_rational():
    for a, b in product(nt.BODIES, repeat=2):
        assert math.isqrt(D := nt.discriminant(*nt.unit_quadratic(a, b, 0))) ** 2 == D
    # Negative control: with a top body that spins, no machine of the family has a rational ratio.
    assert all(math.isqrt(m.discriminant) ** 2 != m.discriminant for m in nt.machines())


# The family of 40


def test_forty_machines_with_forty_discriminants():
    family = nt.machines()
    assert len({(frozenset((m.left, m.right)), m.top) for m in family}) == len(family) == 40
    assert len({m.discriminant for m in family}) == 40


def test_only_three_discriminants_are_sums_of_two_cubes():
    sums = {m.bodies: (m.discriminant, m.cubes) for m in nt.machines() if m.cubes}
    assert sums == {
        ("hoop", "cylinder", "cylinder"): (1729, ((1, 12), (9, 10))),
        ("hoop", "shell", "sphere"): (5896, ((4, 18),)),
        ("sphere", "sphere", "shell"): (1064, ((4, 10),)),
    }


def test_discriminants_of_ordinary_targets_can_be_factored():
    """Check the limit in `BodyChoice`: parts up to 1000. Large primes leave the fewest common factors."""
    for target in (Fraction(997, 991), Fraction(1, 997), Fraction(991, 997), Fraction(1663, 998), Fraction(999, 1000)):
        for machine in family(target):
            assert math.prod(p**e for p, e in machine.factorization) == machine.discriminant


# Numbers


def test_sums_of_two_cubes_against_every_pair():
    bound = 20_000
    roots = range(1, 28)  # 27³ = 19683 is the last cube below the bound
    pairs = defaultdict(list)
    for x in roots:
        for y in roots:
            if x <= y:
                pairs[x**3 + y**3].append((x, y))
    for n in range(1, bound + 1):
        assert nt.sums_of_two_cubes(n) == sorted(pairs[n])
    # Hardy–Wright and OEIS A011541: the smallest sum in three ways. 10⁴ is the largest root that occurs.
    assert nt.sums_of_two_cubes(87_539_319) == [(167, 436), (228, 423), (255, 414)]
    assert nt.sums_of_two_cubes(10**12) == []
    assert nt.sums_of_two_cubes(9_999**3 + 1) == [(1, 9_999)]


def test_factors_against_sympy():
    for n in range(1, 2_000):
        factors = sp.factorint(n)
        assert nt.factorization(n) == tuple(factors.items())
        assert nt.squarefree_part(n) == math.prod(p for p, e in factors.items() if e % 2)


def test_field_discriminant_against_sympy():
    for n in (2, 3, 5, 6, 7, 8, 12, 13, 20, 45, 48, 1204, 1729, 4 * 1729, 5896):
        assert nt.field_discriminant(n) == sp.QQ.algebraic_field(sp.sqrt(n)).discriminant()
    assert nt.field_discriminant(49) == nt.field_discriminant(1) == 1


@pytest.mark.parametrize("target", [Fraction(1), Fraction(4, 3), Fraction(5, 7)])
def test_every_discriminant_has_the_general_form(target):
    """(8/w − (2+γ)(2−s))² + 8sγ², up to the square of a fraction."""
    for machine in family(target):
        beta_a, beta_b, beta_c = betas_of(machine)
        s, gamma = beta_a + beta_b, beta_c / (1 + beta_c)
        ratio = ((8 / target - (2 + gamma) * (2 - s)) ** 2 + 8 * s * gamma**2) / machine.discriminant
        assert math.isqrt(ratio.numerator) ** 2 == ratio.numerator
        assert math.isqrt(ratio.denominator) ** 2 == ratio.denominator


# Exactness and bad input


def kinds(value: object) -> set[type]:
    """Yield the types of a value and of its contents."""
    return {type(value)}.union(*map(kinds, value)) if isinstance(value, list | tuple) else {type(value)}


@pytest.mark.parametrize("integer", [np.int64, sp.Integer])
def test_integers_of_numpy_and_sympy_are_accepted(integer):
    one, n, quadratic = integer(1), integer(1729), tuple(map(integer, PAPER))
    machine = nt.BodyChoice(target=one)
    results = [f(n) for f in (nt.factorization, nt.squarefree_part, nt.sums_of_two_cubes)]
    results += [nt.unit_quadratic(one, Fraction(1, 2), Fraction(1, 2), one), machine.target]
    results += [nt.normalized_frequency_squared_exact(one, 0, 0, one), machine.discriminant]
    results += [nt.discriminant(*quadratic), nt.field_discriminant(n)]
    assert kinds(results) == {int, Fraction, list, tuple}


@pytest.mark.parametrize(
    "function",
    [nt.factorization, nt.squarefree_part, nt.field_discriminant, nt.sums_of_two_cubes],
)
def test_numbers_beyond_the_bound_are_refused(function):
    # test_validation.py passes values of other types to every function.
    for bad in (0, -1, 10**12 + 1):
        with pytest.raises(ValueError, match=r"^n must be an integer from 1 to 10¹²$"):
            function(bad)


def test_the_error_for_a_value_outside_its_range_names_it():
    refused = [("a", lambda: nt.discriminant(0, 1, -1)), ("top", lambda: nt.BodyChoice("hoop", "cylinder", "ball"))]
    for bad in (-1, 2, Fraction(-1, 9)):
        refused += [("beta_b", lambda bad=bad: nt.unit_quadratic("hoop", bad, "cylinder"))]
    for bad in (0, -1, LIGHT_ROLLERS_LIMIT, 2):
        refused.append(("target", lambda bad=bad: nt.BodyChoice(target=bad)))
    for name, call in refused:
        with pytest.raises(ValueError, match=rf"^{name} must"):
            call()


def test_two_lower_rollers_without_rotational_inertia_are_refused():
    with pytest.raises(ValueError, match=r"^beta_a and beta_b must not both be 0"):
        nt.unit_quadratic(0, 0, "hoop")


def test_largest_permitted_inputs_have_a_discriminant():
    """Parts up to 10⁶ lead to coefficients that the other functions accept."""
    betas = (Fraction(999_983, 10**6), Fraction(999_979, 999_999), Fraction(999_961, 999_998))
    quadratic = nt.unit_quadratic(*betas, Fraction(999_953, 999_997))
    assert nt.discriminant(*quadratic) > 10**24  # the primes above leave no common factor to cancel
    with pytest.raises(ValueError, match=r"^n must"):
        nt.factorization(nt.discriminant(*quadratic))
