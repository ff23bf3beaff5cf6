"""Shared by all experiments: timing and the reference arithmetic."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import mpmath
import numpy as np

_REPEATS, _SHORTEST = 7, 1e-3
"""Batches of which the median and the quartiles are taken, and the least duration of a batch [s]."""

REFERENCE = mpmath.MPContext()
"""50-digit arithmetic with an exponent of any size; a separate context, since mpmath.mp is shared."""
REFERENCE.dps = 50


@dataclass(frozen=True)
class Timing:
    """Seconds per call: the median of the repeats and their quartiles, `low` and `high`."""

    median: float
    low: float
    high: float


def measure(call: Callable[[], object]) -> Timing:
    """Return the duration of a call, with its spread.

    Parameters
    ----------
    call : called without arguments, many times

    Returns
    -------
    median and quartiles [s]

    >>> measure(lambda: sum(range(100))).median > 0
    True
    """
    calls = 1
    while (seconds := _batch(call, calls)) < _SHORTEST:
        calls = max(2 * calls, math.ceil(calls * _SHORTEST / max(seconds, 1e-7)))
    per_call = [_batch(call, calls) / calls for _repeat in range(_REPEATS)]
    low, median, high = (float(value) for value in np.percentile(per_call, [25, 50, 75]))
    return Timing(median, low, high)


def _batch(call: Callable[[], object], calls: int) -> float:
    start = time.perf_counter()
    for _call in range(calls):
        call()
    return time.perf_counter() - start
