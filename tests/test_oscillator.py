"""The Ω² curve and its inverse against mpmath, and what a machine refuses; its numbers are in test_whole_range.py."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from ramanujan import UNIT_MASS_RATIO, Oscillator, mass_ratio_for, normalized_frequency_squared

mpmath.mp.dps = 60
SMALLEST = 2.2250738585072014e-308


def test_the_unit_ratio_is_the_nearest_double():
    exact = (mpmath.sqrt(1729) - 1) / 36
    assert float(exact) == UNIT_MASS_RATIO
    assert (math.sqrt(1729) - 1) / 36 != UNIT_MASS_RATIO  # the textbook form loses a digit


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_arrays_keep_their_precision_and_shape(dtype):
    ratios = np.geomspace(1e-6, 1e6, 301, dtype=dtype).reshape(7, 43)
    values = normalized_frequency_squared(ratios)
    assert values.dtype == dtype
    assert values.shape == ratios.shape
    back = mass_ratio_for(values)
    assert back.dtype == dtype
    # f falls by |εf′/f| ≤ 1 of a relative step, but is flat where ε is small: there the inverse can know less.
    conditioning = 1 + 1 / ratios
    assert np.all(np.abs(back / ratios - 1) <= 20 * np.finfo(dtype).eps * conditioning)


@settings(deadline=None, max_examples=300)
@given(st.floats(1e-300, 7 / 4, exclude_max=True))
@example(np.nextafter(7 / 4, 0))
@example(48 / 49)
def test_the_inverse_against_mpmath(w):
    exact_w = mpmath.mpf(w)
    a, b, c = 18 * exact_w, 49 * exact_w - 48, 32 * exact_w - 56
    exact = -2 * c / (b + mpmath.sqrt(b * b - 4 * a * c)) if b >= 0 else (mpmath.sqrt(b * b - 4 * a * c) - b) / (2 * a)
    assert float(abs(mpmath.mpf(float(mass_ratio_for(w))) / exact - 1)) < 2e-15


@pytest.mark.parametrize("w", [0, -1, 7 / 4, 2, 5e-324])
def test_the_inverse_refuses_what_no_machine_has(w):
    with pytest.raises(ValueError, match="normalized_frequency_squared"):
        mass_ratio_for(w)


@pytest.mark.parametrize("ratio", [-1, -1e-300, [1, -1], [1, math.nan]])
def test_a_bad_mass_ratio_is_refused_by_name(ratio):
    with pytest.raises(ValueError, match="mass_ratio"):
        normalized_frequency_squared(ratio)


@pytest.mark.parametrize("name", ["m", "m_prime", "k", "radius"])
@pytest.mark.parametrize("bad", [0, -1.0])
def test_a_parameter_that_is_not_positive_is_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=rf"^{name} must be a finite positive number"):
        Oscillator(**{name: bad})


def test_an_oscillator_is_a_value():
    assert Oscillator(1, 2, 3) == Oscillator(1.0, 2.0, 3.0)
    assert hash(Oscillator()) == hash(Oscillator(np.float64(1)))
    with pytest.raises(AttributeError):
        Oscillator().m = 2


# --- the curve's marked values, and its fall -------------------------------------------------------------------------

MARKED = [0.0, 1.0, 5 / 6, UNIT_MASS_RATIO, 2.0**-53, 2.0**-52, 2.0**-51, 32 / 21, 64 / 21, 48 / 49]


def neighbours(center, dtype, count):
    """The floats next to a number, `count` to either side, without a gap."""
    integer = {np.float32: np.uint32, np.float64: np.uint64}[dtype]
    middle = int(np.array(center, dtype).view(integer))
    values = np.arange(max(middle - count, 0), middle + count, dtype=integer).view(dtype)
    return values[np.isfinite(values)]


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_the_marked_values_are_exact(dtype):
    f = normalized_frequency_squared
    assert f(dtype(0)) == 7 / 4
    assert f(dtype(1)) == dtype(104 / 99)
    assert f(dtype(UNIT_MASS_RATIO)) == 1
    assert f(dtype(5 / 6)) == dtype(9 / 8)
    assert mass_ratio_for(dtype(1)) == dtype(UNIT_MASS_RATIO)
    assert mass_ratio_for(dtype(9 / 8)) == dtype(5 / 6)
    # The other machine of the same ratio, whose ratio is not a double: Ω is computed from the masses themselves.
    assert Oscillator(3.0, 3 * UNIT_MASS_RATIO).normalized_frequency_squared == 1
    assert Oscillator(7.0, 7.0, 99.0).normalized_frequency_squared == 104 / 99


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_it_never_rises_and_never_exceeds_its_limit(dtype):
    f = normalized_frequency_squared
    smallest, largest = (-149, 127) if dtype is np.float32 else (-1074, 1023)
    powers = [2.0**n for n in range(smallest, largest + 1, 1 if dtype is np.float32 else 7)]
    # Where the sum of the two doubles in the denominator changes its leading one: 1 + 21ε/32 a power of two.
    switches = [32 / 21 * (2.0**n - 1) for n in range(1, 60)]
    for center in [*MARKED, *powers, *switches, *(10.0**n for n in range(-37, 38))]:
        values = f(neighbours(center, dtype, 300))
        assert np.all(np.diff(values) <= 0), center
        assert values[0] <= 7 / 4
    rng = np.random.default_rng(7)
    for exponents in (rng.uniform(-20, 20, 200_000), rng.uniform(-1, 1, 200_000), rng.uniform(-17, -15, 200_000)):
        assert np.all(np.diff(f(np.sort(10.0**exponents).astype(dtype))) <= 0)


@settings(deadline=None, max_examples=600)
@given(st.one_of(st.floats(0, 1.7e308), st.floats(-20, 20).map(lambda x: 10.0**x)))
@example(5e-324)
@example(1.7976931348623157e308)
def test_the_curve_is_right_to_half_an_ulp_and_a_bit(ratio):
    exact = 8 * (7 + 6 * mpmath.mpf(ratio)) / (18 * mpmath.mpf(ratio) ** 2 + 49 * mpmath.mpf(ratio) + 32)
    value = float(normalized_frequency_squared(ratio))
    # Below the normal numbers it is rounded a second time.
    assert abs(value - exact) <= 0.52 * math.ulp(value) + (0.5 * 5e-324 if value < SMALLEST else 0)
    # Every ε of float32 is a double, so that its value is rounded only once more.
    small = np.float32(min(ratio, 3e38))
    exact = 8 * (7 + 6 * mpmath.mpf(float(small))) / (18 * mpmath.mpf(float(small)) ** 2 + 49 * float(small) + 32)
    found = normalized_frequency_squared(small)
    assert found.dtype == np.float32
    assert abs(float(found) - exact) <= 0.51 * float(np.spacing(found))


def test_an_oscillator_shows_itself_in_a_notebook():
    shown = Oscillator(1, UNIT_MASS_RATIO, 10)._repr_markdown_()
    assert "| k | stiffness of the spring | 10\u202fN/m |" in shown
    assert "| Ω²m/k | normalized frequency squared | 1 |" in shown
    # A machine whose frequency is beyond float64 still shows its parameters.
    too_fast = Oscillator(5e-324, 5e-324, 1e308)._repr_markdown_()
    assert "| Ω |" not in too_fast
    assert "| Ω²m/k |" in too_fast
