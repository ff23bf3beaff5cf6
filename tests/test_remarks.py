"""The marginal notes: every claim is computed, and the corrected lines are right."""

import pytest
import sympy as sp

from ramanujan.derivation.model import COORDINATES, t
from ramanujan.derivation.remarks import conserved_momenta, list_remarks
from tests import reference
from tests.reference import equal


def test_each_remark_is_true_and_has_its_place_and_reason():
    for remark in list_remarks():
        assert remark.holds is True, remark
        for text in (remark.where, remark.printed, remark.correct, remark.note):
            assert text
            assert text.count("$") % 2 == 0
        assert remark.printed != remark.correct
        assert remark.note.endswith(".")


@pytest.mark.parametrize(
    ("place", "right"),
    [
        ("Introduction", "91=6^3+(-5)^3=4^3+3^3"),
        ("Section 1", f"{104 / 99:.4f}"),
        ("constants", r"c_{2} = \frac{3}{2}\,R"),
        ("four equations", r"\ddot{X} = - \Omega^{2}\,X"),
        ("last sentence", r"0, \  0, \  \Omega^{2}"),
    ],
)
def test_a_slip_of_the_paper_is_corrected(place, right):
    (remark,) = (remark for remark in list_remarks() if place in remark.where)
    assert right in remark.correct + remark.note
    assert right not in remark.printed


def test_the_conserved_momenta_belong_to_the_zero_modes():
    momenta = {q: reference.lagrangian().diff(q.diff(t)) for q in COORDINATES}
    rates = {q: p.diff(t).subs(reference.accelerations()) for q, p in momenta.items()}
    assert [q for q, rate in rates.items() if equal(rate, sp.S.Zero)] == list(conserved_momenta())
    assert all(equal(p, momenta[q]) for q, p in conserved_momenta().items())
