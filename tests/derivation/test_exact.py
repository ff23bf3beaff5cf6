"""LaTeX of exact numbers, and their decimals compared with fractions. test_my_numbers parses all of them."""

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan.derivation.model import m
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import QuadraticNumber, round_number, truncate
from ramanujan.derivation.rows import side_terms

ROOT, HALF = sp.sqrt(1729), sp.Rational(1, 2)


def coefficient_in_latex(number: sp.Expr) -> str:
    """Return the LaTeX of a number that is the only coefficient of a formula."""
    return "".join(side_terms(number * m, Numbers(1.0, 1.0, 1.0)))


@settings(deadline=None, max_examples=40)
@given(st.integers(1, 10**30), st.integers(1, 10**30))
def test_a_decimal_with_dots_is_truncated_and_one_without_is_exact(p, q):
    text = truncate(QuadraticNumber(p, q))
    digits = text.replace(r"\ldots", "").replace(r" \times 10^{", "e").rstrip("}")
    shown, exact = Fraction(digits), Fraction(p, q)
    if r"\ldots" in text:
        assert shown < exact < shown * (1 + Fraction(1, 10**7))
    else:
        assert shown == exact


@settings(deadline=None, max_examples=40)
@given(st.integers(-(10**20), 10**20), st.integers(1, 10**20))
def test_a_rounded_decimal_is_near(p, q):
    text = round_number(QuadraticNumber(p, q)).replace(r" \times 10^{", "e").rstrip("}")
    assert abs(Fraction(text) - Fraction(p, q)) <= abs(Fraction(p, q)) * Fraction(1, 10**7)


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (-HALF, r"- \frac{1}{2}"),
        ((37 - ROOT) / 36, r"- \frac{\sqrt{1729} - 37}{36}"),
        (37 - ROOT, r"- \left(\sqrt{1729} - 37\right)"),
        (5 * (41 - ROOT) / 7, r"- \frac{5\,\left(\sqrt{1729} - 41\right)}{7}"),
        (2 * ROOT, r"2\,\sqrt{1729}"),
        (HALF / (15 * 10**6), r"3.3333333\ldots \times 10^{-8}"),
    ],
)
def test_a_number_is_printed_as_expected(number, text):
    assert coefficient_in_latex(number) == text


@mpmath.workdps(100)
def test_a_near_cancellation_keeps_its_digits():
    """The difference 10³⁰ − r√1729, for the nearest integer r, is 10³⁰ times smaller than its terms."""
    p = 10**30
    r = -int(p / mpmath.sqrt(1729))
    exact = mpmath.mpf(p) + r * mpmath.sqrt(1729)
    assert round_number(QuadraticNumber.of(p, r, 1, 1729), 12) == mpmath.nstr(exact, 12)
