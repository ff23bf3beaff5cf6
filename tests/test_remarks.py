"""The marginal notes: every claim is computed, and the corrected lines are the right ones."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest
import sympy as sp

from ramanujan.derivation.remarks import conserved_momenta, remarks
from ramanujan.derivation.symbols import COORDINATES, VELOCITIES, Phi, R, X, k, m, m_prime, machine, phi
from tests import reference
from tests.reference import equal

X_dot, phi_dot, Phi_dot = VELOCITIES


@pytest.mark.parametrize("remark", remarks(), ids=lambda remark: remark.where)
def test_each_remark_holds(remark):
    assert remark.holds() is True


@pytest.mark.parametrize("remark", remarks(), ids=lambda remark: remark.where)
def test_each_remark_says_where_and_why(remark):
    for text in (remark.where, remark.printed, remark.correct, remark.note):
        assert text
        assert text.count("$") % 2 == 0
    assert remark.printed != remark.correct
    assert remark.note.endswith(".")


def test_a_remark_cannot_be_changed():
    with pytest.raises(FrozenInstanceError):
        remarks()[0].note = ""


def by_place(place: str) -> str:
    (remark,) = (remark for remark in remarks() if place in remark.where)
    return remark.correct + remark.note


def test_91_is_a_sum_of_two_cubes_in_two_ways():
    assert 91 == 6**3 + (-5) ** 3 == 4**3 + 3**3
    assert "91=6^3+(-5)^3=4^3+3^3" in by_place("Introduction")


def test_the_last_digit():
    assert f"{104 / 99:.4f}" in by_place("Section 1")
    assert "1.0506" not in by_place("Section 1")


def test_the_constants_of_section_3():
    assert r"c_{2} = \frac{3\,R}{2}" in by_place("constants")


def test_the_missing_sign():
    assert r"\ddot{X} = - \Omega^{2}\,X" in by_place("four equations")


def test_the_three_modes():
    assert r"0, \  0, \  \Omega^{2}" in by_place("last sentence")


# Momenta of the zero modes


def test_conserved_momenta_are_the_known_ones():
    momenta = conserved_momenta()
    assert list(momenta) == [X, Phi]
    assert equal(momenta[X], (3 * m + 2 * m_prime) * X_dot - m * R * Phi_dot - 2 * (m + m_prime) * R * phi_dot)
    assert equal(momenta[Phi], sp.Rational(3, 2) * m * R**2 * Phi_dot - m * R * X_dot)


@pytest.mark.parametrize("q", conserved_momenta())
def test_a_conserved_momentum_does_not_change_along_the_motion(q):
    rate = conserved_momenta()[q].diff(sp.Symbol("t"))
    assert equal(rate.subs(reference.accelerations()), sp.S.Zero)


def test_the_rollers_momentum_does_change():
    assert phi not in conserved_momenta()
    rate = reference.lagrangian().diff(phi_dot).diff(sp.Symbol("t")).subs(reference.accelerations())
    assert equal(rate, -4 * k * R**2 * phi)


@pytest.mark.parametrize("q", conserved_momenta())
def test_a_conserved_momentum_belongs_to_a_zero_mode(q):
    mass, stiffness = reference.mass_and_stiffness()
    mode = sp.Matrix([int(q == coordinate) for coordinate in COORDINATES])
    assert (stiffness * mode).is_zero_matrix
    assert equal(conserved_momenta()[q], (mode.T * mass * sp.Matrix(VELOCITIES))[0])


def test_momenta_of_another_machine():
    # A top body that does not resist turning makes Φ's momentum lose its spin part.
    momenta = conserved_momenta(machine(top=0))
    assert equal(momenta[Phi], m * R**2 * Phi_dot - m * R * X_dot)
