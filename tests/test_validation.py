"""One contract for input: every public function of the numeric rooms, with every kind of bad value.

The functions are found, not listed: a new one fails here until each of its parameters says which kind it is.
"""

from __future__ import annotations

import datetime
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
from ramanujan.accuracy.work_precision import work_precision
from ramanujan.number_theory import BodyChoice
from ramanujan.record import record
from ramanujan.validation import coordinates, floats, integer, positive, rational, real, sequence, shown

ROOMS = (
    "frequency",
    "oscillator",
    "motion",
    "energy",
    "contact",
    "sampling",
    "record",
    "table",
    "integrators",
    "number_theory",
    "accuracy",
)
STEPS = {method.step.__name__ for method in METHODS.values()}
UNCHECKED = {
    **dict.fromkeys(
        ("frequency_ratio", "frequency_squared"), "works in whatever arithmetic its arguments bring with them"
    ),
    "main": "takes the words of a command line and answers them with one sentence and an exit status",
    **dict.fromkeys(("float_type", "method_named", "steps_within"), "is itself a check, like those of validation"),
    **dict.fromkeys(
        ("blocks", "evaluations_of", "powers_of_ten", "ulp_errors"),
        "is inside an experiment, which checks once before its first piece",
    ),
    **dict.fromkeys(STEPS, "is the inner loop; `trajectory` checks once for all steps"),
}

HUGE = 10**5000  # more digits than Python prints
MASKED = np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False])
NOT_NUMBERS = [
    True,
    np.True_,
    None,
    "1",
    b"1",
    1j,
    sp.I,
    object(),
    {},
    {1.0},
    np.datetime64("2020-01-01"),
    np.timedelta64(1, "s"),
    datetime.date(1729, 1, 1),
    np.ma.masked,
    HUGE,
    -HUGE,
    math.nan,
    math.inf,
    -math.inf,
    Decimal("nan"),
    np.array("1"),
    np.array(True),
    np.array(None),
]
BAD_ENTRIES = [[entry] * 3 for entry in (True, None, "1", 1j, HUGE, math.nan, math.inf, np.datetime64("2020-01-01"))]
BAD = {
    "number": [*NOT_NUMBERS, [1.0], (1.0, 2.0), np.array([1.0])],
    "array": [
        *NOT_NUMBERS,
        *BAD_ENTRIES,
        [1.0, True, 2.0],
        [[1.0], [2.0, 3.0], [4.0]],
        MASKED,
        np.array([1.0, None, "x"], dtype=object),
        np.array([1, 2, 3], dtype="timedelta64[s]"),
        np.array([True, False, True]),
        iter([1.0, 2.0, 3.0]),
    ],
    "integer": [*NOT_NUMBERS, 1.0, np.float64(2), Fraction(1, 2), Decimal(3), 0, -1, [1]],
    "coefficient": [*NOT_NUMBERS, 1.0, np.float64(2), Fraction(1, 2), Decimal(3), [1]],
    "exact": [*NOT_NUMBERS, 0.5, Decimal(1), -1, [1], Fraction(1, HUGE)],
    "numbers": [None, 3, True, "12", b"12", math.nan, object(), {1, 2}, [None], [True], ["1"], [1.5], [HUGE], [-1]],
    "name": [None, 3, True, "nope", b"rk4", ["rk4"], math.nan, object(), np.array(["rk4"])],
    "names": [None, 3, True, "rk4", b"rk4", math.nan, object(), ["nope"], [None], [["rk4"]], {"rk4"}],
    "body": [*(value for value in NOT_NUMBERS if not isinstance(value, str)), "nope", "", 0.5, -1, 2, ["hoop"]],
    "object": [None, 3, True, "machine", object(), math.nan, [Oscillator()]],
}
KINDS = {
    "number": "mass_ratio m m_prime k radius X phi Phi X_dot phi_dot Phi_dot compression "
    "glide spin g spacing friction_coefficient periods height_px tolerance",
    "array": "t q q_dot v h times",
    "coefficient": "a b c",
    "integer": "n digits terms points",
    "exact": "target ratio",
    "numbers": "quotients steps_per_period",
    "name": "method by dtype",
    "names": "dtypes",
    "body": "beta_a beta_b beta_c left right top",
    "object": "oscillator initial motion acceleration call curve curves after between columns comments",
}
KIND = {name: kind for kind, names in KINDS.items() for name in names.split()}
SPECIAL = {
    ("normalized_frequency_squared", "mass_ratio"): "array",
    ("mass_ratio_for", "normalized_frequency_squared"): "array",
    ("trajectory", "method"): "object",
    ("work_precision", "periods"): "integer",
    ("error_history", "periods"): "integer",
    ("error_history", "steps_per_period"): "integer",
    ("closed_form", "periods"): "numbers",
}
PERMITTED = {
    "spacing": (math.inf,),
    "after": (None,),
    # An acceleration may be any function, and any text may be a comment.
    "comments": (["nope"], "machine"),
}


GOOD = {
    "oscillator": Oscillator(),
    "initial": InitialState(phi=0.1),
    "motion": record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5),
    "method": "rk4",
    "acceleration": lambda q: -q,
    "call": int,
    "curves": [work_precision("rk4", periods=2, steps_per_period=[8])],
    "curve": work_precision("rk4", periods=2, steps_per_period=[8]),
    "after": None,
    "between": int,
    "columns": {"t [s]": [0.0, 1.0]},
    "comments": ["none"],
    "q": [0.0, 0.1, 0.0],
    "q_dot": [0.0, 0.1, 0.0],
    "t": 0.5,
    "times": [0.5],
    "v": [0.0, 0.0, 0.0],
    "h": 0.1,
    "spacing": 0.29,
    "compression": 0.08,
    "friction_coefficient": 0.3,
    "points": 5,
    "steps_per_period": [8],
    "quotients": [1, 2],
    "by": "seconds",
    "dtype": "float64",
    "dtypes": ["float64"],
    "target": Fraction(1),
    "ratio": Fraction(1),
    "a": 18,
    "b": 1,
    "c": -24,
    "n": 1729,
    "normalized_frequency_squared": 1.0,
    **dict.fromkeys(("beta_a", "beta_b", "beta_c", "left", "right", "top"), "hoop"),
    **dict.fromkeys(("digits", "terms"), 1),
}
GOOD_FOR = {
    ("trajectory", "method"): METHODS["rk4"],
    ("error_history", "steps_per_period"): 8,
    ("error_history", "periods"): 2,
    ("work_precision", "periods"): 2,
    ("closed_form", "periods"): [1],
}


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
PARAMETERS = [
    (name, parameter) for name, function in CHECKED.items() for parameter in inspect.signature(function).parameters
]


def good_call(name):
    """Arguments for every parameter without a default, and for those whose good value is known."""
    arguments = {}
    for parameter in inspect.signature(CHECKED[name]).parameters.values():
        value = GOOD_FOR.get((name, parameter.name), GOOD.get(parameter.name, 1.0))
        arguments[parameter.name] = value
    return arguments


def test_every_public_function_is_found():
    assert len(CHECKED) > 50
    assert set(UNCHECKED) <= set(FUNCTIONS)
    assert {"motion", "energies", "sums_of_two_cubes", "extremes", "trajectory", "csv_table"} <= set(CHECKED)
    # What a notebook imports is among them.
    callables = {name for name in ramanujan.__all__ if inspect.isfunction(getattr(ramanujan, name))}
    assert callables <= set(CHECKED)


@pytest.mark.parametrize("name", CHECKED)
def test_the_good_values_are_good(name):
    assert CHECKED[name](**good_call(name)) is not NotImplemented


@pytest.mark.parametrize(("name", "parameter"), PARAMETERS)
def test_every_bad_value_is_refused_by_the_name_of_its_parameter(name, parameter):
    kind = SPECIAL.get((name, parameter)) or KIND[parameter]
    permitted = PERMITTED.get(parameter, ())
    for bad in BAD[kind]:
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
        (lambda: FUNCTIONS["points_for_half_pixel"](1e300), r"^periods and height_px are too large"),
        (lambda: FUNCTIONS["csv_table"]({}), r"^columns must hold at least one column"),
        (lambda: record(Oscillator(), 0.08, spacing=0.29, periods=1e308, points=2), r"^(t|periods) "),
    ],
)
def test_shapes_and_ranges_are_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_rollers_that_touch_are_allowed():
    assert ramanujan.required_friction(Oscillator(radius=0.1), 0.08, spacing=0.2)["hoop_slab"] > 0
