"""What counts as a quantity: the contract for the arguments of every public function of the numeric rooms.

    a number     a real number: Python's int, float, Fraction or Decimal, a NumPy scalar, or an array without axes.
                 Booleans, text, dates, complex numbers and None are not numbers; neither is what float64 cannot hold.
    an array     numbers of any shape, also as a list. Every entry is a number in the above sense; a masked one is not.
    finite       NaN is never accepted, and infinity only where a function says so.
    an integer   an integer type. 2.0 is a float, not an integer.
    exact        an integer or a Fraction whose numerator and denominator stay below a stated bound.

A value outside the contract raises `ValueError` with one sentence that begins with the name of the parameter.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Callable, Collection, Iterable, Set
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.numerals import number as written
from ramanujan.translation import _

T = TypeVar("T")


def real(name: str, value: object) -> float:
    """Return a finite number as a float.

    >>> real("compression", 1)
    1.0
    >>> real("compression", True)
    Traceback (most recent call last):
    ValueError: compression must be a finite number, not True
    """
    number = float(value) if isinstance(value, float) else _float(value)
    if not math.isfinite(number):
        raise ValueError(_("{name} must be a finite number, not {value}").format(name=name, value=shown(value)))
    return number


def positive(name: str, value: object, *, infinite: bool = False) -> float:
    """Return a positive number as a float; infinity is accepted only if `infinite` says so.

    >>> positive("m", 2)
    2.0
    >>> positive("spacing", math.inf, infinite=True)
    inf
    """
    number = float(value) if isinstance(value, float) else _float(value)
    if not (0 < number < math.inf or (infinite and number == math.inf)):
        sentence = (
            _("{name} must be a positive number or infinity, not {value}")
            if infinite
            else _("{name} must be a finite positive number, not {value}")
        )
        raise ValueError(sentence.format(name=name, value=shown(value)))
    return number


def integer(name: str, value: object, low: int, high: int) -> int:
    """Return an integer from low to high as an int.

    >>> integer("points", np.int64(5), 2, 10)
    5
    """
    value = _without_axes(value)
    # NumPy derives timedelta64 from its integers.
    is_integer = isinstance(value, Integral) and not isinstance(value, bool | np.timedelta64)
    if not is_integer or not low <= value <= high:
        sentence = _("{name} must be an integer from {low} to {high}")
        raise ValueError(sentence.format(name=name, low=written(low), high=written(high)))
    return int(value)


def rational(name: str, value: object, largest: int) -> Fraction:
    """Return an exact number as a Fraction; its numerator and denominator may not exceed `largest` in size.

    >>> rational("target", 2, 10)
    Fraction(2, 1)
    """
    value = _without_axes(value)
    if not isinstance(value, Rational) or isinstance(value, bool | np.timedelta64):
        sentence = _("{name} must be an exact number, an integer or a Fraction, not {value}")
        raise ValueError(sentence.format(name=name, value=shown(value)))
    exact = Fraction(int(value.numerator), int(value.denominator))
    if max(abs(exact.numerator), exact.denominator) > largest:
        sentence = _("{name} must have a numerator and a denominator of at most {largest}")
        raise ValueError(sentence.format(name=name, largest=written(largest)))
    return exact


def floats(name: str, values: ArrayLike) -> NDArray[np.floating]:
    """Return numbers of any shape as an array; float32 stays float32, everything else becomes float64.

    NaN and infinity pass, so that the caller can say which range it accepts.

    >>> floats("mass_ratio", [1, Fraction(1, 2)])
    array([1. , 0.5])
    """
    try:
        array = np.asarray(values)
        if np.ma.is_masked(values) or _holds_a_boolean(values):
            raise TypeError
        if array.dtype == object and all(map(_is_real, array.flat)):
            array = array.astype(np.float64)
        if array.dtype.kind not in "fiu":
            raise TypeError
    except (TypeError, ValueError, OverflowError):
        sentence = _("{name} must be a real number or an array of real numbers, not {value}")
        raise ValueError(sentence.format(name=name, value=shown(values))) from None
    return array if array.dtype in (np.float32, np.float64) else array.astype(np.float64)


def finite_array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return finite numbers of any shape as a float64 array.

    >>> finite_array("t", [0, 1])
    array([0., 1.])
    """
    array = floats(name, values).astype(np.float64, copy=False)
    if not np.all(np.isfinite(array)):
        raise ValueError(_("{name} must be finite, not {value}").format(name=name, value=shown(values)))
    return array


def coordinates(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return finite numbers as a float64 array of shape (3, …), whose rows belong to X, φ and Φ.

    >>> coordinates("q", [0, 0.1, 0]).shape
    (3,)
    """
    array = finite_array(name, values)
    if array.ndim == 0 or len(array) != 3:
        sentence = _("{name} must have three rows, for X, φ and Φ, not the shape {shape}")
        raise ValueError(sentence.format(name=name, shape=array.shape))
    return array


def one_of(name: str, value: object, allowed: Collection[str]) -> str:
    """Return a name that is among the allowed ones.

    >>> one_of("by", "seconds", ("evaluations", "seconds"))
    'seconds'
    """
    if not isinstance(value, str) or value not in allowed:
        sentence = _("{name} must be one of {known}, not {value}")
        raise ValueError(sentence.format(name=name, known=", ".join(allowed), value=shown(value)))
    return value


def sequence(name: str, values: object) -> list[object]:
    """Return an ordered iterable as a list; text counts as one value, not as a sequence of letters.

    >>> sequence("steps", (1, 2))
    [1, 2]
    """
    without_order = isinstance(values, str | bytes | Set) or (isinstance(values, np.ndarray) and values.ndim != 1)
    if without_order or not isinstance(values, Iterable):
        raise ValueError(_("{name} must be a sequence, not {value}").format(name=name, value=shown(values)))
    return list(values)


def instance(name: str, value: object, kind: type[T]) -> T:
    """Return an object of the given class.

    >>> instance("ratio", Fraction(1, 2), Fraction)
    Fraction(1, 2)
    """
    if not isinstance(value, kind):
        sentence = _("{name} must be an object of the class {kind}, not {value}")
        raise ValueError(sentence.format(name=name, kind=kind.__name__, value=shown(value)))
    return value


def function(name: str, value: object) -> Callable:
    """Return a function, or anything else that can be called.

    >>> function("acceleration", abs)
    <built-in function abs>
    """
    if not callable(value):
        raise ValueError(_("{name} must be a function, not {value}").format(name=name, value=shown(value)))
    return value


def shown(value: object) -> str:
    """Return a short text for a value, also for one that cannot be printed.

    >>> shown("wheel")
    "'wheel'"
    """
    try:
        return " ".join(reprlib.repr(value).split())[:60]
    except Exception:  # Python refuses to print very long integers; another class may fail in its own way.
        return _("a value of the type {kind}").format(kind=type(value).__name__)


def _float(value: object) -> float:
    """Return a number as a float, and NaN for what is not a number."""
    value = _without_axes(value)
    try:
        return float(value) if _is_real(value) else math.nan
    except (TypeError, ValueError, OverflowError):
        return math.nan


def _is_real(value: object) -> bool:
    return isinstance(value, Real | Decimal) and not isinstance(value, bool | np.timedelta64)


def _without_axes(value: object) -> object:
    """Return the one entry of an array without axes, and anything else as it is."""
    return value[()] if isinstance(value, np.ndarray) and value.ndim == 0 and not np.ma.is_masked(value) else value


def _holds_a_boolean(values: object) -> bool:
    """Tell whether a list holds a boolean, which NumPy would turn into a number."""
    if isinstance(values, list | tuple):
        return any(map(_holds_a_boolean, values))
    return isinstance(values, bool | np.bool_)
