"""Invalid arguments of the numeric packages: each error message begins with the name of the parameter."""

import math
import re
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import ramanujan
import ramanujan.number_theory as nt
from ramanujan import METHODS, InitialState, Oscillator, motion, trajectory
from ramanujan.physics.record import record
from ramanujan.physics.validation import finite, float_array, positive

MACHINE, HUGE = Oscillator(), 10**5000
NOT_NUMBERS = [None, "1", True, 1j, sp.I, {}, math.nan, math.inf, [1.0]]
NOT_POSITIVE = [*NOT_NUMBERS, 0, -1.0]
NOT_ARRAYS = [*NOT_NUMBERS[:-1], ["1", "2", "3"], [1.0, None, 2.0], [1.0, math.nan, 2.0], [[1.0], [2.0, 3.0], [4.0]]]
NOT_INTEGERS = [None, "1", True, 1.0, Fraction(1, 2), HUGE]
NOT_EXACT = [None, True, 0.5, -1, Fraction(1, HUGE)]

INVALID = [
    *((name, lambda x, name=name: Oscillator(**{name: x}), NOT_POSITIVE) for name in ("m", "m_prime", "k", "radius")),
    *((name, lambda x, name=name: InitialState(**{name: x}), NOT_NUMBERS) for name in ("X", "phi", "Phi_dot")),
    ("compression", lambda x: ramanujan.released(MACHINE, x), NOT_NUMBERS),
    ("glide", lambda x: ramanujan.with_initial_velocities(MACHINE, 0.1, glide=x), NOT_NUMBERS),
    ("g", lambda x: ramanujan.required_friction(MACHINE, 0.1, g=x), NOT_POSITIVE),
    ("friction_coefficient", lambda x: ramanujan.largest_compression(MACHINE, x), NOT_POSITIVE),
    ("g", lambda x: ramanujan.largest_compression(MACHINE, 0.3, g=x), [*NOT_POSITIVE, 1e-200, 1e51]),
    ("friction_coefficient", lambda x: ramanujan.largest_compression(MACHINE, x), [1e-51, 1e308]),
    ("oscillator", lambda x: ramanujan.largest_compression(x, 0.3), [Oscillator(m_prime=1e-200, k=1e-200)]),
    ("oscillator", lambda x: ramanujan.required_friction(x, 0.1), [Oscillator(k=1e60), Oscillator(m_prime=1e60)]),
    ("compression", lambda x: ramanujan.required_friction(MACHINE, x), [*NOT_NUMBERS, 1e51, -1e51]),
    ("compression", lambda x: ramanujan.released(MACHINE, x), [1e308]),
    ("spacing", lambda x: ramanujan.largest_compression(MACHINE, 0.3, spacing=x), [1e51]),
    ("t", lambda x: motion(Oscillator(k=1e10), InitialState(phi=1.0), x), [1e308, [0.0, -1e308]]),
    ("points", lambda x: record(MACHINE, 0.08, spacing=0.29, periods=1, points=x), [2.5, 1, 10**7 + 1, "5"]),
    ("periods", lambda x: record(MACHINE, 0.08, spacing=0.29, periods=x, points=5), NOT_POSITIVE),
    ("spacing", lambda x: ramanujan.first_to_slip(MACHINE, 0.1, x), [None, "1", math.nan, 0, -1, 0.19]),
    ("t", lambda x: motion(MACHINE, InitialState(phi=1.0), x), NOT_ARRAYS),
    ("mass_ratio", ramanujan.normalized_frequency_squared, [*NOT_ARRAYS, -1]),
    ("normalized_frequency_squared", ramanujan.mass_ratio_for, [*NOT_ARRAYS, 0, 7 / 4]),
    ("q", lambda x: ramanujan.contact_forces(MACHINE, x), [*NOT_ARRAYS, 1.0, np.zeros((2, 3))]),
    ("q_dot", lambda x: ramanujan.momenta(MACHINE, x), [*NOT_ARRAYS, [1.0, 2.0]]),
    ("q_dot", lambda x: ramanujan.energies(MACHINE, [0, 0, 0], x), [np.zeros((3, 5))]),
    ("v", lambda x: trajectory(METHODS["rk4"], abs, [1.0, 2.0], x, 0.1), [*NOT_ARRAYS, [1.0]]),
    ("h", lambda x: trajectory(METHODS["rk4"], abs, 1.0, 1.0, x), [*NOT_ARRAYS, [0.1]]),
    ("n", nt.sums_of_two_cubes, NOT_INTEGERS),
    ("ratio", lambda x: nt.normalized_frequency_squared_exact("hoop", "hoop", "hoop", x), NOT_EXACT),
    ("target", lambda x: nt.unit_quadratic("hoop", "hoop", "hoop", x), NOT_EXACT),
    ("beta_a", lambda x: nt.unit_quadratic(x, "hoop", "hoop"), [*NOT_EXACT, "nope", 2]),
]
"""Parameter, a function that passes a value for it, and invalid values."""


@pytest.mark.parametrize(("name", "call", "values"), INVALID, ids=[name for name, *_rest in INVALID])
def test_the_error_for_an_invalid_value_names_its_parameter(name, call, values):
    for value in values:
        with pytest.raises(ValueError, match=rf"^{re.escape(name)}\b") as caught:
            call(value)
        assert "\n" not in str(caught.value)


def test_all_types_of_real_numbers_are_valid():
    for good in (1, 1.0, np.int8(1), np.float32(1), Fraction(1), Decimal(1), sp.Integer(1)):
        assert finite("x", good) == positive("x", good) == 1.0
        assert type(finite("x", good)) is float
        assert float_array("x", good) == float_array("x", [good]) == 1.0
    assert float_array("x", np.float32(0.1)).dtype == np.float32
    assert float_array("x", [[1, Fraction(1, 2)], [Decimal("0.25"), 3]]).tolist() == [[1, 0.5], [0.25, 3]]
