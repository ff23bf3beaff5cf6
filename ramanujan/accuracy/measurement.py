"""Durations of calls, and 50-digit arithmetic for reference values; all experiments use this module."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable

import mpmath

_BATCHES = 7
"""Number of timed batches of calls, from which the median is computed."""

_SHORTEST_BATCH = 1e-3
"""Least duration of a batch [s], so that the resolution of the clock does not matter."""

REFERENCE = mpmath.MPContext()
"""50-digit mpmath arithmetic without overflow. It is separate from the global context mpmath.mp."""
REFERENCE.dps = 50


def measure(call: Callable[[], object]) -> float:
    """Return the median duration of a call [s].

    Parameters
    ----------
    call : a function without parameters; it is called many times

    >>> measure(lambda: sum(range(100))) > 0
    True
    """
    # Enlarge the batch until it is long enough.
    calls = 1
    seconds = _time_batch(call, calls)
    while seconds < _SHORTEST_BATCH:
        calls = max(2 * calls, math.ceil(calls * _SHORTEST_BATCH / max(seconds, 1e-7)))
        seconds = _time_batch(call, calls)
    return statistics.median(_time_batch(call, calls) / calls for _repeat in range(_BATCHES))


def _time_batch(call: Callable[[], object], calls: int) -> float:
    """Return the duration of a number of calls."""
    # Let other threads run now, because they would otherwise wait for up to 5 ms, many times for each answer.
    time.sleep(0)
    start = time.perf_counter()
    for _call in range(calls):
        call()
    return time.perf_counter() - start
