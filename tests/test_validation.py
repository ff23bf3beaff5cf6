"""What the numeric rooms refuse: every public function, every parameter that is a number, by its name.

The functions are found, not listed. What a parameter refuses follows from its annotation.
"""

import importlib
import inspect
import math
import pkgutil
import re
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import ramanujan
from ramanujan import METHODS, InitialState, Oscillator, motion
from ramanujan.number_theory import BodyChoice
from ramanujan.record import record
from ramanujan.validation import coordinates, finite, float_array, positive

ROOMS = ("frequency", "oscillator", "motion", "energy", "contact", "record", "integrators", "number_theory")
UNCHECKED = {"effective_mass_ratio", *(method.step.__name__ for method in METHODS.values())}
"""Inner loops, whose callers check."""
NOT_NUMBERS = [None, "1", True, 1j, sp.I, {}, math.nan, math.inf, np.array(["1"])]
NOT_ARRAYS = [*NOT_NUMBERS, [1.0, None, 2.0], ["1", "2", "3"], [1.0, math.nan, 2.0], [[1.0], [2.0, 3.0], [4.0]]]
NOT_INTEGERS = [None, "1", True, 1.0, Fraction(1, 2), 10**5000]
BAD = {
    "float": NOT_NUMBERS,
    "ArrayLike": NOT_ARRAYS,
    "Runs": NOT_ARRAYS,
    "int | Fraction": [None, "1", True, 0.5, -1, Fraction(1, 10**5000)],
    "ShapeFactor": [None, "nope", True, 0.5, -1, 2],
}
"""Annotation of a parameter → values that it refuses."""
GOOD = {
    "float": 0.08,
    "ArrayLike": [0.1, 0.2, 0.3],
    "Runs": 0.1,
    "int": 8,
    "int | Fraction": Fraction(1),
    "Sequence[int]": [8, 8],
    "ShapeFactor": "hoop",
    "Oscillator": Oscillator(),
    "InitialState": InitialState(phi=0.1),
    "Record": record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5),
    "Method": METHODS["rk4"],
    "Acceleration": lambda q: -q,
}
NAMED = {"a": 18, "b": 1, "c": -24, "spacing": 0.29}
"""Annotation, or name of a parameter for which that is not enough → a value that it takes."""


def public_functions():
    """Every public function of the rooms, and the classes that a person makes, by name."""
    found = {"Oscillator": Oscillator, "InitialState": InitialState, "BodyChoice": BodyChoice}
    for room in ROOMS:
        package = importlib.import_module(f"ramanujan.{room}")
        entries = pkgutil.iter_modules(getattr(package, "__path__", []))
        names = [entry.name for entry in entries if entry.name != "arguments"]
        for module in (package, *(importlib.import_module(f"ramanujan.{room}.{name}") for name in names)):
            for name, value in vars(module).items():
                if inspect.isfunction(value) and value.__module__ == module.__name__ and not name.startswith("_"):
                    found[name] = value
    return {name: value for name, value in found.items() if name not in UNCHECKED}


FUNCTIONS = public_functions()


def parameters(name):
    """The parameters of a function: name → annotation, as it is written."""
    return {each.name: each.annotation for each in inspect.signature(FUNCTIONS[name]).parameters.values()}


def good_call(name):
    """Arguments for every parameter."""
    return {each: NAMED.get(each, GOOD[kind]) for each, kind in parameters(name).items()}


def bad_values(parameter, kind):
    """The values that a parameter refuses. In the number theory, integers are checked as well."""
    if kind == "int" and parameter != "points":
        return NOT_INTEGERS
    return [value for value in BAD.get(kind, []) if not (parameter == "spacing" and value == math.inf)]


def test_every_public_function_is_found():
    assert {name for name, value in vars(ramanujan).items() if inspect.isfunction(value)} <= set(FUNCTIONS)
    assert {"motion", "energies", "sums_of_two_cubes", "trajectory"} <= set(FUNCTIONS)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_bad_number_is_refused_by_the_name_of_its_parameter(name):
    assert FUNCTIONS[name](**good_call(name)) is not NotImplemented
    for parameter, kind in parameters(name).items():
        for bad in bad_values(parameter, kind):
            with pytest.raises(ValueError, match=rf"^{re.escape(parameter)}\b") as caught:
                FUNCTIONS[name](**{**good_call(name), parameter: bad})
            assert "\n" not in str(caught.value)


def test_what_counts_as_a_number():
    for good in (1, 1.0, np.int8(1), np.float32(1), Fraction(1), Decimal(1), sp.Integer(1)):
        assert finite("x", good) == positive("x", good) == 1.0
        assert type(finite("x", good)) is float
        assert float_array("x", good) == float_array("x", [good]) == 1.0
    assert float_array("x", np.float32(0.1)).dtype == np.float32
    assert float_array("x", np.array([1, 2], dtype=np.float16)).dtype == np.float64
    assert float_array("x", [[1, Fraction(1, 2)], [Decimal("0.25"), 3]]).tolist() == [[1, 0.5], [0.25, 3]]


def test_no_argument_is_changed():
    given = np.array([0.0, 0.1, 0.0])
    given.flags.writeable = False
    coordinates("q", given)
    motion(Oscillator(), InitialState(phi=1.0), given)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ramanujan.energies(Oscillator(), [0, 0, 0], np.zeros((3, 5))), r"^q_dot must have the shape of q"),
        (lambda: coordinates("q", np.zeros((2, 3))), r"^q must have three rows"),
        (lambda: coordinates("q", 1.0), r"^q must have three rows"),
        (lambda: ramanujan.required_friction(Oscillator(), 0.08, spacing=0.19), r"^spacing must be at least 2R, 0.2"),
        (lambda: record(Oscillator(), 0.01, spacing=0.29, periods=1, points=1), r"^points must be an integer from 2"),
        (lambda: ramanujan.trajectory(METHODS["rk4"], abs, [1.0, 2.0], [1.0], 0.1), r"^v must have the shape of q"),
        (lambda: ramanujan.trajectory(METHODS["rk4"], abs, 1.0, 1.0, [0.1]), r"^h must be one number or have"),
    ],
)
def test_shapes_and_ranges_are_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()
