"""The remarks on the paper: each printed line is wrong, and each corrected line is right."""

import re
from itertools import combinations_with_replacement

import sympy as sp

from ramanujan.derivation.matrix import conserved_momenta
from ramanujan.derivation.model import COORDINATES, R, k, m, m_prime, phi, t
from ramanujan.derivation.printers import latex
from ramanujan.derivation.remarks import REMARKS, Remark
from tests.checks import reference
from tests.checks.reference import equal


def remark(place: str) -> Remark:
    """Return the remark on a place in the paper."""
    (found,) = (remark for remark in REMARKS if place in remark.where)
    return found


def test_each_remark_has_its_place_and_reason():
    for remark in REMARKS:
        for text in (remark.where, remark.printed, remark.correct, remark.note):
            assert text
            assert text.count("$") % 2 == 0
        assert remark.printed != remark.correct
        assert remark.note.endswith(".")


def smallest_in_two_ways(cubes: list[int]) -> tuple[int, list[tuple[int, int]]]:
    """Return the smallest positive number with two representations a³ + b³, and both representations."""
    ways: dict[int, list[tuple[int, int]]] = {}
    for a, b in combinations_with_replacement(cubes, 2):
        ways.setdefault(a**3 + b**3, []).append((a, b))
    smallest = min(n for n, pairs in ways.items() if n > 0 and len(pairs) > 1)
    return smallest, ways[smallest]


def test_a_smaller_number_than_1729_is_a_sum_of_cubes_with_signs_in_two_ways():
    # The search is complete up to 1729: with a number below −23, the sum is at least 25³ − 24³ = 1801.
    assert smallest_in_two_ways([*range(1, 26)])[0] == 1729
    smallest, ways = smallest_in_two_ways([a for a in range(-24, 26) if a])
    assert smallest < 1729
    number, *sums = re.search(r"\$(.*?)\$", remark("Introduction").note)[1].split("=")
    assert int(number) == smallest
    shown = [tuple(sorted(int(a) for a in re.findall(r"(-?\d+)\)?\^3", text))) for text in sums]
    assert sorted(shown) == sorted(ways)


def test_the_ratio_of_equal_masses_is_rounded_down():
    ratio = (reference.natural_frequency_squared() * m / k).subs(m_prime, m)
    assert sp.cancel(ratio - sp.Rational(104, 99)) == 0
    rounding = remark("Section 1")
    assert rounding.correct == f"$\\frac{{104}}{{99}}\\approx{104 / 99:.4f}$"
    assert f"{104 / 99:.4f}" not in rounding.printed


def accelerations() -> list[sp.Expr]:
    """Return Ẍ, φ̈ and Φ̈ for φ = 1."""
    return [value / phi for value in reference.accelerations().values()]


def test_the_constant_c_2_is_not_the_coefficient_in_the_relation_of_the_two_angles():
    X_ddot, phi_ddot, Phi_ddot = accelerations()
    c_1, c_2, coefficient = X_ddot / phi_ddot, X_ddot / Phi_ddot, Phi_ddot / phi_ddot
    assert equal(coefficient, c_1 / c_2)
    assert not equal(coefficient, c_2)
    correct = remark("constants").correct
    assert f"$c_{{2}} = {latex(sp.cancel(c_2))}$" in correct
    assert equal(c_2, sp.Rational(3, 2) * R)
    assert r"= \frac{4\,\left(m + m'\right)}{7\,m + 6\,m'}$" in correct
    assert equal(coefficient, 4 * (m + m_prime) / (7 * m + 6 * m_prime))


def solves(motion: tuple[sp.Expr, ...]) -> bool:
    """Return whether M q̈ + K q = 0 for q = (X, φ, Φ) as functions of time."""
    mass, stiffness = reference.mass_and_stiffness()
    q = sp.Matrix(motion)
    return (mass * q.diff(t, 2) + stiffness * q).applyfunc(sp.simplify).is_zero_matrix


def oscillation() -> sp.Expr:
    return sp.cos(sp.sqrt(reference.natural_frequency_squared()) * t)


def test_a_drift_solves_the_equations_and_is_not_proportional_to_the_angle():
    X_ddot, phi_ddot, Phi_ddot = accelerations()
    c_1 = X_ddot / phi_ddot
    X_0, V, Phi_0, W = sp.symbols("X_0 V Phi_0 W")
    drifting = (
        X_0 + V * t + c_1 * oscillation(),
        oscillation(),
        Phi_0 + W * t + Phi_ddot / phi_ddot * oscillation(),
    )
    assert solves(drifting)
    assert sp.expand(drifting[0] - c_1 * drifting[1]) != 0
    assert remark("replacing").correct == r"$X = \varphi\,c_{1} + V\,t + X_{0}$"


def test_the_equations_of_the_oscillation_have_a_minus_sign():
    Omega2 = reference.natural_frequency_squared()
    _X_ddot, phi_ddot, _Phi_ddot = accelerations()
    mode = tuple(sp.cancel(acceleration / phi_ddot) * oscillation() for acceleration in accelerations())
    assert solves(mode)
    for q in mode:
        assert sp.simplify(q.diff(t, 2) + Omega2 * q) == 0
        assert sp.simplify(q.diff(t, 2) - Omega2 * q) != 0
    signs = remark("four equations")
    assert signs.correct.replace("= - ", "= ") == signs.printed


def test_one_mode_oscillates_and_two_have_frequency_zero():
    mass, stiffness = reference.mass_and_stiffness()
    eigenvalues = (mass.inv() * stiffness).applyfunc(sp.cancel).eigenvals()
    assert {sp.factor(value): times for value, times in eigenvalues.items()} == {
        sp.S.Zero: 2,
        sp.factor(reference.natural_frequency_squared()): 1,
    }
    assert r"= \left( 0, \  0, \  \Omega^{2}\right)$" in remark("last sentence").correct


def test_the_conserved_momenta_belong_to_the_zero_modes():
    momenta = {q: reference.lagrangian().diff(q.diff(t)) for q in COORDINATES}
    rates = {q: p.diff(t).subs(reference.accelerations()) for q, p in momenta.items()}
    assert [q for q, rate in rates.items() if equal(rate, sp.S.Zero)] == list(conserved_momenta())
    assert all(equal(p, momenta[q]) for q, p in conserved_momenta().items())
