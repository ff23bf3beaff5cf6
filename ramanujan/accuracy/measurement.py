"""Shared by all experiments: timing and the reference arithmetic."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import mpmath
import numpy as np

from ramanujan.frequency import frequency_squared
from ramanujan.numerals import quantity
from ramanujan.translation import _
from ramanujan.validation import function, integer, one_of, positive

_LONGEST_BATCH = 60

REFERENCE = mpmath.MPContext()
"""50-digit arithmetic with an exponent of any size; a separate context, since mpmath.mp is shared."""
REFERENCE.dps = 50


@dataclass(frozen=True)
class Timing:
    """Seconds per call: the median of the repeats and their quartiles, `low` and `high`."""

    median: float
    low: float
    high: float


def measure(call: Callable[[], object], repeats: int = 7, shortest: float = 1e-3) -> Timing:
    """Return the duration of a call, with its spread.

    Parameters
    ----------
    call : called without arguments, many times
    repeats : number of batches; the median and the quartiles are taken over them
    shortest : least duration of a batch [s], much longer than the clock's resolution; at most a minute

    Returns
    -------
    median and quartiles [s]

    Raises
    ------
    ValueError : call is not a function, repeats is not an integer from 1 to 1000, or shortest is out of its range.

    >>> measure(lambda: sum(range(100)), repeats=3, shortest=1e-4).median > 0
    True
    """
    function("call", call)
    integer("repeats", repeats, 1, 1000)
    if positive("shortest", shortest) > _LONGEST_BATCH:
        raise ValueError(_("shortest must be at most {most}").format(most=quantity(_LONGEST_BATCH, "s")))
    calls = 1
    while (seconds := _batch(call, calls)) < shortest:
        calls = max(2 * calls, math.ceil(calls * shortest / max(seconds, 1e-7)))
    per_call = [_batch(call, calls) / calls for _repeat in range(repeats)]
    low, median, high = (float(value) for value in np.percentile(per_call, [25, 50, 75]))
    return Timing(median, low, high)


def exact_frequency_squared(m: float, m_prime: float, k: float) -> mpmath.mpf:
    """Return Ω² [rad²/s²] to 50 digits for the given numbers, taken as exact.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg], k [N/m]

    Returns
    -------
    a number of `REFERENCE`

    Raises
    ------
    ValueError : a parameter is not a finite positive number.

    >>> round(float(exact_frequency_squared(1, 1, 99)), 9)
    104.0
    """
    given = (("m", m), ("m_prime", m_prime), ("k", k))
    return frequency_squared(*(REFERENCE.mpf(positive(name, value)) for name, value in given))


def float_type(name: str, value: str) -> type[np.floating]:
    """Return np.float32 or np.float64 for its name, or raise ValueError.

    >>> float_type("dtype", "float32")
    <class 'numpy.float32'>
    """
    kinds = {"float32": np.float32, "float64": np.float64}
    return kinds[one_of(name, value, kinds)]


def _batch(call: Callable[[], object], calls: int) -> float:
    start = time.perf_counter()
    for _call in range(calls):
        call()
    return time.perf_counter() - start
