"""What every experiment shares: pieces of work, measured seconds, the reference arithmetic, checks of arguments.

Does not live here: any experiment.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

import mpmath
import numpy as np

T = TypeVar("T")

REFERENCE = mpmath.MPContext()
"""50-digit arithmetic with an exponent of any size; a context of our own, since mpmath.mp belongs to everybody."""
REFERENCE.dps = 50


@dataclass(frozen=True)
class Piece(Generic[T]):
    """A finished piece of work: `done`, the share of the experiment from 0 to 1, and a result if one is complete."""

    done: float
    result: T | None = None


@dataclass(frozen=True)
class Timing:
    """Seconds per call: the median of the repeats and their quartiles, `low` and `high`."""

    median: float
    low: float
    high: float


def results(pieces: Iterable[Piece[T]]) -> list[T]:
    """Run an experiment to its end and return its results in order."""
    return [piece.result for piece in pieces if piece.result is not None]


def each(function: Callable[[Any], T], arguments: Sequence[Any]) -> Iterator[Piece[T]]:
    """Yield one piece per argument, with the function's value as its result."""
    for number, argument in enumerate(arguments, start=1):
        yield Piece(number / len(arguments), function(argument))


def measure(function: Callable[[], Any], repeats: int = 7, shortest: float = 1e-3) -> Timing:
    """Return the seconds that a call takes, with its spread.

    Parameters
    ----------
    function : called without arguments, many times
    repeats : number of batches; the median and the quartiles are taken over them
    shortest : seconds that a batch lasts at least, so that the clock's resolution does not count
    """
    calls = 1
    while (seconds := _batch(function, calls)) < shortest:
        calls = max(2 * calls, math.ceil(calls * shortest / max(seconds, 1e-7)))
    per_call = [_batch(function, calls) / calls for _ in range(repeats)]
    low, median, high = (float(value) for value in np.percentile(per_call, [25, 50, 75]))
    return Timing(median, low, high)


def frequency_squared(m: Any, m_prime: Any, k: Any) -> Any:
    """Return Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) to 50 digits for the given numbers, taken as exact."""
    m, m_prime, k = (REFERENCE.mpf(float(value)) for value in (m, m_prime, k))
    return 8 * k * (7 * m + 6 * m_prime) / (32 * m * m + 49 * m * m_prime + 18 * m_prime * m_prime)


def positive_integer(name: str, value: Any, largest: int) -> int:
    """Return value as an int, or raise ValueError naming it unless it is a whole number from 1 to largest."""
    try:
        number = int(value)
        whole = number == value
    except (TypeError, ValueError, OverflowError):
        whole = False
    if not whole or not 1 <= number <= largest:
        raise ValueError(f"{name} must be a whole number from 1 to {largest}, not {value!r:.60}")
    return number


def float_type(name: str, value: Any) -> type[np.floating]:
    """Return np.float32 or np.float64 for its name, or raise ValueError."""
    kinds = {"float32": np.float32, "float64": np.float64}
    if value not in kinds:
        raise ValueError(f"{name} must be float32 or float64, not {value!r:.60}")
    return kinds[value]


def _batch(function: Callable[[], Any], calls: int) -> float:
    start = time.perf_counter()
    for _ in range(calls):
        function()
    return time.perf_counter() - start
