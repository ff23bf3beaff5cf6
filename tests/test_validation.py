"""One contract for input: every public function of the numeric rooms, with every kind of bad value.

The functions are found, not listed; what a parameter has to refuse follows from its annotation.
"""

import importlib
import inspect
import math
import pkgutil
import re
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import ramanujan
from ramanujan import METHODS, InitialState, Oscillator, motion
from ramanujan.number_theory import BodyChoice
from ramanujan.record import record
from ramanujan.validation import coordinates, floats, integer, positive, rational, real, sequence, shown

ROOMS = (
    "frequency",
    "oscillator",
    "motion",
    "energy",
    "contact",
    "record",
    "integrators",
    "number_theory",
)
STEPS = {method.step.__name__ for method in METHODS.values()}
UNCHECKED = {
    **dict.fromkeys(
        ("frequency_ratio", "frequency_squared"), "works in whatever arithmetic its arguments bring with them"
    ),
    **dict.fromkeys(STEPS, "is the inner loop; `trajectory` checks once for all steps"),
}

HUGE = 10**5000  # more digits than Python prints
MASKED = np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False])
NOT_NUMBERS = [
    True,
    None,
    "1",
    b"1",
    1j,
    sp.I,
    {},
    np.datetime64("2020-01-01"),
    np.ma.masked,
    HUGE,
    math.nan,
    math.inf,
    Decimal("nan"),
    np.array(True),
]
BAD_ENTRIES = [[entry] * 3 for entry in (True, None, "1", 1j, HUGE, math.nan, math.inf, np.datetime64("2020-01-01"))]
BAD_NUMBERS = [*NOT_NUMBERS, [1.0], (1.0, 2.0), np.array([1.0])]
BAD_ARRAYS = [
    *NOT_NUMBERS,
    *BAD_ENTRIES,
    [1.0, True, 2.0],
    [[1.0], [2.0, 3.0], [4.0]],
    MASKED,
    np.array([1, 2, 3], dtype="timedelta64[s]"),
    iter([1.0, 2.0, 3.0]),
]
BAD = {
    "float": BAD_NUMBERS,
    "ArrayLike": BAD_ARRAYS,
    "Runs": BAD_ARRAYS,
    "int": [*NOT_NUMBERS, 1.0, np.float64(2), Fraction(1, 2), Decimal(3), 0, -1, [1]],
    "int | Fraction": [*NOT_NUMBERS, 0.5, Decimal(1), -1, [1], Fraction(1, HUGE)],
    "Sequence[int]": [None, 3, True, "12", b"12", math.nan, {1, 2}, [None], [True], ["1"], [1.5], [HUGE], [-1]],
    "str": [None, 3, True, "nope", b"rk4", ["rk4"], math.nan, object(), np.array(["rk4"])],
    "ShapeFactor": [*(each for each in NOT_NUMBERS if not isinstance(each, str)), "nope", "", 0.5, -1, 2, ["hoop"]],
}
"""Annotation of a parameter → values that it refuses."""
NO_OBJECTS = [None, 3, True, "machine", object(), math.nan, [Oscillator()]]
"""What every other parameter refuses."""
PERMITTED = {
    "spacing": (math.inf,),
    **dict.fromkeys("abc", (0, -1)),
}
"""Parameter → what it takes all the same."""
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
        modules = [package]
        for entry in pkgutil.iter_modules(getattr(package, "__path__", [])):
            modules.append(importlib.import_module(f"ramanujan.{room}.{entry.name}"))
        for module in modules:
            for name, value in vars(module).items():
                if inspect.isfunction(value) and value.__module__ == module.__name__ and not name.startswith("_"):
                    found[name] = value
    return found


FUNCTIONS = public_functions()
CHECKED = {name: function for name, function in FUNCTIONS.items() if name not in UNCHECKED}


def parameters(name):
    """The parameters of a function: name → annotation, as it is written."""
    return {each.name: each.annotation for each in inspect.signature(CHECKED[name]).parameters.values()}


def good_call(name):
    """Arguments for every parameter."""
    named = {each for each, kind in parameters(name).items() if each in NAMED and kind != "Method"}
    return {each: NAMED[each] if each in named else GOOD[kind] for each, kind in parameters(name).items()}


def test_every_public_function_is_found():
    assert len(CHECKED) > 35
    assert set(UNCHECKED) <= set(FUNCTIONS)
    assert {"motion", "energies", "sums_of_two_cubes", "trajectory"} <= set(CHECKED)
    # What a notebook imports is among them.
    callables = {name for name, value in vars(ramanujan).items() if inspect.isfunction(value)}
    assert callables <= set(CHECKED)


@pytest.mark.parametrize("name", CHECKED)
def test_the_good_values_are_good(name):
    assert CHECKED[name](**good_call(name)) is not NotImplemented


@pytest.mark.parametrize(("name", "parameter"), [(name, each) for name in CHECKED for each in parameters(name)])
def test_every_bad_value_is_refused_by_the_name_of_its_parameter(name, parameter):
    permitted = PERMITTED.get(parameter, ())
    for bad in BAD.get(parameters(name)[parameter], NO_OBJECTS):
        if any(bad is value or (type(bad) is type(value) and bad == value) for value in permitted):
            continue
        with warnings.catch_warnings():
            # NumPy warns when it makes NaN of a masked entry, which is then refused.
            warnings.simplefilter("ignore", UserWarning)
            with pytest.raises(ValueError, match=rf"^{re.escape(parameter)}\b") as caught:
                CHECKED[name](**{**good_call(name), parameter: bad})
        assert "\n" not in str(caught.value)


def test_what_counts_as_a_number():
    for good in (
        1,
        1.0,
        np.int8(1),
        np.float32(1),
        np.longdouble(1),
        Fraction(1),
        Decimal(1),
        sp.Integer(1),
        np.array(1),
    ):
        assert real("x", good) == positive("x", good) == 1.0
        assert type(real("x", good)) is float
        assert floats("x", good) == floats("x", [good]) == 1.0
    for good in (1, np.int8(1), sp.Integer(1), np.array(1)):
        assert integer("x", good, 0, 2) == rational("x", good, 5) == 1
    assert floats("x", np.ma.array([1.0, 2.0])).tolist() == [1.0, 2.0]
    assert floats("x", np.float32(0.1)).dtype == np.float32
    assert floats("x", np.array([1, 2], dtype=np.float16)).dtype == np.float64
    assert floats("x", [[1, Fraction(1, 2)], [Decimal("0.25"), 3]]).tolist() == [[1, 0.5], [0.25, 3]]
    assert floats("x", []).shape == (0,)


def test_nothing_that_is_given_is_changed():
    given = np.array([0.0, 0.1, 0.0])
    given.flags.writeable = False
    coordinates("q", given)
    motion(Oscillator(), InitialState(phi=1.0), given)


def test_a_sequence_has_an_order():
    assert sequence("x", (value for value in "ab")) == ["a", "b"]
    assert sequence("x", np.array([1, 2])) == [1, 2]
    assert sequence("x", {"a": 1}) == ["a"]


def test_shown_never_fails():
    class Bad:
        def __repr__(self):
            raise RuntimeError

    assert "Bad" in shown(Bad())
    assert len(shown("x" * 10**6)) <= 60
    assert shown(HUGE)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ramanujan.energies(Oscillator(), [0, 0, 0], np.zeros((3, 5))), r"^q_dot must have the shape of q"),
        (lambda: coordinates("q", [1.0, 2.0]), r"^q must have three rows"),
        (lambda: coordinates("q", np.zeros((2, 3))), r"^q must have three rows"),
        (
            lambda: ramanujan.required_friction(Oscillator(), 0.08, spacing=0.19),
            r"^spacing must be at least 2R, 0.2",
        ),
        (lambda: ramanujan.normal_forces(Oscillator(), [0, 0, 0], spacing=0.19), r"^spacing must be at least 2R"),
        (lambda: ramanujan.first_to_slip(Oscillator(), 0.1, spacing=0.19), r"^spacing must be at least 2R"),
        (lambda: ramanujan.largest_compression(Oscillator(), 0.3, spacing=0.19), r"^spacing must be at least 2R"),
        (lambda: record(Oscillator(), 0.01, spacing=0.1, periods=1, points=5), r"^spacing must be at least 2R"),
        (lambda: ramanujan.trajectory(METHODS["rk4"], abs, [1.0, 2.0], [1.0], 0.1), r"^v must have the shape of q"),
        (lambda: ramanujan.trajectory(METHODS["rk4"], abs, 1.0, 1.0, [0.1]), r"^h must be one number or have"),
        (lambda: record(Oscillator(), 0.08, spacing=0.29, periods=1e308, points=2), r"^(t|periods) "),
    ],
)
def test_shapes_and_ranges_are_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()
