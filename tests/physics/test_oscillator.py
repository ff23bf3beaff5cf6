"""The function Ω²m/k and its inverse, compared with mpmath, and `Oscillator` as a value.

test_whole_range.py tests its quantities.
"""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from ramanujan import UNIT_MASS_RATIO, Oscillator, mass_ratio_for, normalized_frequency_squared
from tests.checks.reference import frequency_squared

mpmath.mp.dps = 60
BOTH = pytest.mark.parametrize("dtype", [np.float32, np.float64])


def curve(ratio):
    return frequency_squared(1, mpmath.mpf(float(ratio)), 1)


def inverse(w):
    """Return the positive root of 18wε² + (49w − 48)ε + (32w − 56) with hundreds of digits."""
    a, b, c = 18 * mpmath.mpf(float(w)), 49 * mpmath.mpf(float(w)) - 48, 32 * mpmath.mpf(float(w)) - 56
    with mpmath.workdps(700):
        return (mpmath.sqrt(b * b - 4 * a * c) - b) / (2 * a)


def test_the_unit_ratio_is_the_nearest_double():
    assert float((mpmath.sqrt(1729) - 1) / 36) == UNIT_MASS_RATIO
    assert (math.sqrt(1729) - 1) / 36 != UNIT_MASS_RATIO  # cancellation in eq. (14) loses a digit


@settings(deadline=None, max_examples=400)
@given(st.one_of(st.floats(1e-300, 1e300), st.floats(-300, 300).map(lambda x: 10.0**x)))
@example(1.7e308)
# The greatest errors known, 3.26 and 3.35 ulp, just below powers of two.
@example(1410498.33852513)
@example(174763.85018168093)
def test_the_curve_is_right_to_4_ulp(ratio):
    for value in (normalized_frequency_squared(ratio), Oscillator(m_prime=ratio).normalized_frequency_squared):
        assert abs(value - curve(ratio)) <= 4 * math.ulp(value)
    small = np.float32(min(ratio, 3e38))
    value = normalized_frequency_squared(small)
    assert abs(value - curve(small)) <= 4 * np.spacing(value)


@settings(deadline=None, max_examples=400)
@given(st.floats(1e-300, 7 / 4, exclude_max=True))
@example(np.nextafter(7 / 4, 0))
@example(48 / 49)
def test_the_inverse_is_right_to_16_ulp(w):
    ratio = mass_ratio_for(w)
    assert abs(ratio - inverse(w)) <= 16 * math.ulp(ratio)


@BOTH
def test_the_marked_values_are_exact(dtype):
    f = normalized_frequency_squared
    assert f(dtype(0)) == 7 / 4
    assert f(dtype(1)) == dtype(104 / 99)
    assert f(dtype(UNIT_MASS_RATIO)) == 1
    assert mass_ratio_for(dtype(1)) == dtype(UNIT_MASS_RATIO)
    assert mass_ratio_for(dtype(1)).dtype == dtype
    assert Oscillator(3.0, 3 * UNIT_MASS_RATIO).normalized_frequency_squared == 1
    assert Oscillator(7.0, 7.0, 99.0).natural_frequency_squared == pytest.approx(104 / 7, rel=1e-15)


@BOTH
def test_the_curve_falls_from_one_float_to_the_next(dtype):
    integer, decades = (np.uint32, 37) if dtype is np.float32 else (np.uint64, 300)
    rng = np.random.default_rng(7)
    centers = [1, 5 / 6, UNIT_MASS_RATIO, *10.0 ** rng.uniform(-18, 18, 1000), *10.0 ** rng.uniform(-2, 2, 1000)]
    middle = np.array(centers, dtype).view(integer)
    neighbours = (middle[:, None] + np.arange(300, dtype=integer)).view(dtype)
    wide = np.geomspace(10.0**-decades, 10.0**decades, 200_001, dtype=dtype)
    for ratios in (*neighbours, wide):
        values = normalized_frequency_squared(ratios)
        assert (values.dtype, values.shape) == (dtype, ratios.shape)
        assert np.all(np.diff(values) <= 0)
        assert values[0] <= 7 / 4


def test_an_oscillator_is_a_value():
    assert Oscillator(1, 2, 3) == Oscillator(1.0, 2.0, 3.0)
    assert hash(Oscillator()) == hash(Oscillator(np.float64(1)))
    with pytest.raises(AttributeError):
        Oscillator().m = 2


def test_an_oscillator_is_displayed_in_a_notebook():
    shown = Oscillator(1, UNIT_MASS_RATIO, 10)._repr_markdown_()
    assert "| k | stiffness of the spring | 10\u202fN/m |" in shown
    assert "| Ω²m/k | normalized frequency squared | 1 |" in shown
