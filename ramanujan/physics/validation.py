"""Checks of arguments: real numbers and arrays of real numbers.

Each function converts its argument to a float or to an array of floats. An invalid argument raises `ValueError`. The
message is one sentence, and its first word is the name of the parameter.
"""

from __future__ import annotations

import math
import reprlib
from decimal import Decimal
from numbers import Real
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatOrArray = TypeVar("FloatOrArray", float, NDArray[np.float64], NDArray[np.floating])
"""The type of the argument and result of a formula: both are floats, or both are arrays of one dtype."""


def finite(name: str, value: object) -> float:
    """Return a finite real number as a float.

    >>> finite("compression", 1)
    1.0
    """
    number = _float(value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be a finite number, not {reprlib.repr(value)}")
    return number


def positive(name: str, value: object, *, infinite: bool = False) -> float:
    """Return a positive number as a float; ∞ is valid only if `infinite` is true.

    >>> positive("m", -1)
    Traceback (most recent call last):
    ValueError: m must be a finite positive number, not -1
    """
    number = _float(value)
    if not 0 < number < math.inf and not (infinite and number == math.inf):
        kind = "a positive number or infinity" if infinite else "a finite positive number"
        raise ValueError(f"{name} must be {kind}, not {reprlib.repr(value)}")
    return number


def float_array(name: str, values: ArrayLike) -> NDArray[np.floating]:
    """Return finite real numbers as an array of the same shape: float32 for float32, float64 for all other types.

    >>> float_array("t", [0, 1])
    array([0., 1.])
    """
    try:
        array = np.asarray(values)
        # Floats, integers and objects such as `Fraction`. Booleans, text and complex numbers are invalid.
        if array.dtype.kind not in "fiuO":
            raise TypeError
        if array.dtype != np.float32:
            array = array.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} must be a real number or an array of real numbers") from None
    if not np.all(np.isfinite(array)):
        raise ValueError(f"{name} must be finite")
    return array


def coordinates(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return finite numbers as a float64 array of shape (3, …), with one row each for X, φ and Φ.

    >>> coordinates("q", [0, 0.1, 0]).shape
    (3,)
    """
    array = float_array(name, values).astype(np.float64, copy=False)
    if array.shape[:1] != (3,):
        raise ValueError(f"{name} must have three rows, for X, φ and Φ, not the shape {array.shape}")
    return array


def _float(value: object) -> float:
    """Convert a real number to a float, and any other object to NaN."""
    if type(value) is float:
        return value
    if isinstance(value, bool) or not isinstance(value, Real | Decimal):
        return math.nan
    try:
        return float(value)
    except (TypeError, OverflowError):
        return math.nan
