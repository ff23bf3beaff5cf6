"""Numbers a + b√n against SymPy, and the decimals that are written against fractions of integers."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan.derivation.exact import Surd, element, root_in, rounded, truncated, written
from tests.latex import Formula

fractions = st.fractions(min_value=-50, max_value=50, max_denominator=60)
ROOT = sp.sqrt(1729)


def surd(a: Fraction, b: Fraction) -> sp.Expr:
    return sp.Rational(a) + sp.Rational(b) * ROOT


def value(number: object) -> sp.Expr:
    if isinstance(number, Surd):
        return (number.a + number.b * ROOT) / number.d
    return sp.Rational(str(number))


@settings(deadline=None, max_examples=40)
@given(fractions, fractions, fractions, fractions)
def test_arithmetic_is_that_of_sympy(a, b, c, d):
    x, y = surd(a, b), surd(c, d)
    u, v = element(x, 1729), element(y, 1729)
    assert sp.expand(value(u + v) - (x + y)) == 0
    assert sp.expand(value(u - v) - (x - y)) == 0
    assert sp.expand(value(u * v) - x * y) == 0
    assert sp.expand(value(u**3) - x**3) == 0
    assert sp.expand(value(2 - 3 * u) - (2 - 3 * x)) == 0
    if y != 0:
        assert sp.expand(value(u / v) * y - x) == 0
        assert sp.expand(value(1 / v) * y - 1) == 0


@settings(deadline=None, max_examples=40)
@given(fractions, fractions)
def test_a_number_is_written_as_it_is(a, b):
    number = surd(a, b)
    shown = Formula(written(element(number, 1729)).alone).value({})
    assert abs(shown - sp.N(number, 60)) < sp.Float("1e-40")


@settings(deadline=None, max_examples=40)
@given(st.integers(1, 10**30), st.integers(1, 10**30))
def test_a_decimal_with_dots_is_cut_off_and_one_without_is_exact(p, q):
    text = truncated(p, q)
    digits = text.replace(r"\ldots", "").replace(r" \times 10^{", "e").rstrip("}")
    shown, exact = Fraction(digits), Fraction(p, q)
    if r"\ldots" in text:
        assert shown < exact < shown * (1 + Fraction(1, 10**7))
    else:
        assert shown == exact


@settings(deadline=None, max_examples=40)
@given(st.integers(-(10**20), 10**20), st.integers(1, 10**20))
def test_a_rounded_decimal_is_near(p, q):
    text = rounded(sp.QQ(p, q)).replace(r" \times 10^{", "e").rstrip("}")
    assert abs(Fraction(text) - Fraction(p, q)) <= abs(Fraction(p, q)) * Fraction(1, 10**7)


@pytest.mark.parametrize(
    ("number", "shown"),
    [
        (sp.Rational(-5), "-5"),
        (sp.Rational(-1, 2), r"- \frac{1}{2}"),
        ((37 - ROOT) / 36, r"\frac{37 - \sqrt{1729}}{36}"),
        ((ROOT - 37) / 36, r"\frac{\sqrt{1729} - 37}{36}"),
        (-(37 + 2 * ROOT) / 3, r"- \frac{37 + 2\,\sqrt{1729}}{3}"),
        (5 * (41 - ROOT), r"- 5\,\left(\sqrt{1729} - 41\right)"),
        (2 * ROOT, r"2\,\sqrt{1729}"),
        (sp.Rational(1, 3 * 10**7), r"3.3333333\ldots \times 10^{-8}"),
    ],
)
def test_how_a_number_looks(number, shown):
    assert written(element(number, 1729)).alone == shown


def test_other_numbers_are_refused():
    with pytest.raises(ValueError, match="value"):
        element(sp.sqrt(2), 1729)
    with pytest.raises(ValueError, match="values"):
        root_in((sp.sqrt(2) + sp.sqrt(3),))
    with pytest.raises(ValueError, match="values"):
        root_in((sp.cbrt(2),))
