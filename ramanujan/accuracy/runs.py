"""Runs of the integrators on the machine's oscillating mode, block by block, in units of 1/Ω and of the amplitude.

Only the oscillating mode φ″ = −Ω²φ is integrated. X and Φ are each a steady drift, which every method here follows
exactly, plus a multiple of φ. With the time in units of 1/Ω and q = φ/φ₀ every machine is the same problem

    q″ = −q,   q = 1 and q′ = 0 at the start,   h = 2π/n

so that a run depends on the method, the number n of steps per period, the number of periods and the precision alone.
With s = q − iv, v = q′, the exact motion is s = e^{it}, and the errors, relative to the amplitude, are

    state error    |s − e^{it}|
    phase error    angle of s against e^{it}, unwrapped [rad]; positive where the run is ahead
    energy error   |s|² − 1
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.accuracy.measurement import Timing, measure
from ramanujan.integrators import METHODS, Method, trajectory

_BLOCK = 256
"""Steps whose errors are worked out at once."""


@dataclass(frozen=True, eq=False)
class History:
    """One run; each array has one element per step, the start included.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    q : φ over its amplitude
    phase_error, energy_error : as above [rad], [1]
    evaluations : evaluations of the acceleration in the run
    """

    method: str
    dtype: str
    q: np.ndarray
    phase_error: np.ndarray
    energy_error: np.ndarray
    evaluations: int


def error_history(method: str, steps_per_period: int, periods: int, dtype: str = "float64") -> History:
    """Return one run with its errors.

    Parameters
    ----------
    method : name in METHODS
    steps_per_period : n, so that h = 2π/n in units of 1/Ω; at least 3
    periods : length of the run [periods], whole
    dtype : "float32" or "float64"

    Returns
    -------
    the run, which is that of every machine

    >>> error_history("rk4", 20, 10).evaluations
    800
    """
    n = steps_per_period
    start, h = (np.ones(1, dtype), np.zeros(1, dtype)), np.array([2 * np.pi / n], dtype)
    with np.errstate(over="ignore", invalid="ignore"):
        found = [q - 1j * v for _number, q, v in blocks(METHODS[method], start, h, np.array([n * periods]))]
        s = np.concatenate([[1.0], *(block[:, 0] for block in found)])
        # The error is unwrapped, not the phase: it moves by less than half a turn a step and keeps its last digits.
        # Whole turns are taken off as integers.
        phase = np.unwrap(np.angle(s * np.exp(-2j * np.pi * (np.arange(s.size) % n) / n)))
        energy = s.real**2 + s.imag**2 - 1
    return History(method, dtype, s.real, phase, energy, int(evaluations_of(method, n * periods)))


def blocks(
    method: Method, start: tuple[np.ndarray, np.ndarray], h: np.ndarray, steps: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield blocks of steps: their numbers (rows,), and the states q, v in float64, (rows, …, runs still under way).

    The runs start at `start`, (q, v), both of the shape (…, runs), in whose dtype they are computed. Those in column i
    end after steps[i] steps, in ascending order. A block ends where the shortest run under way ends: its last row is
    that run's final state.

    >>> start = np.ones(2), np.zeros(2)
    >>> for number, q, v in blocks(METHODS["rk4"], start, np.full(2, 0.1), np.array([10, 20])):
    ...     print(number[-1], q.shape)
    10 (10, 2)
    20 (10, 1)
    """
    # Single numbers give the very bits of arrays with one element, in a fraction of the time; Python's own the fastest.
    alone = h.size == 1
    given = ((x.item() if x.dtype == float else x.ravel()[0]) if alone else x for x in (*start, h))
    states = trajectory(method, lambda q: -q, *given)
    done = 0
    for ended, total in enumerate(steps.tolist()):
        while done < total:
            rows = min(_BLOCK, total - done)
            q, v = np.empty((2, rows, *h.shape[:-1], steps.size - ended))
            # A run whose values grow beyond float64 is a result here, not a fault.
            with np.errstate(over="ignore", invalid="ignore"):
                for row, (q_row, v_row) in enumerate(islice(states, rows)):
                    q[row], v[row] = (q_row, v_row) if alone else (q_row[..., ended:], v_row[..., ended:])
            yield np.arange(done + 1, done + rows + 1), q, v
            done += rows


def seconds_per_step(method: str, dtype: str = "float64") -> Timing:
    """Measure a step of a single run, by itself; the acceleration is one multiplication, as it is for −Ω²φ.

    Parameters
    ----------
    method : name in METHODS
    dtype : "float32" or "float64"

    Returns
    -------
    median and quartiles [s]

    >>> seconds_per_step("rk4").median > 0
    True
    """
    minus_omega_squared, q, v = np.dtype(dtype).type(-1), np.ones(1, dtype), np.zeros(1, dtype)
    states = trajectory(METHODS[method], lambda q: minus_omega_squared * q, q, v, 2 * np.pi / 100)
    # Explicit Euler overflows during a long timing; its speed stays the same.
    with np.errstate(over="ignore", invalid="ignore"):
        return measure(lambda: next(states))


def evaluations_of(method: str, steps: ArrayLike) -> NDArray[np.int64]:
    """Return how often so many steps evaluate the acceleration, from counting the first two steps.

    The second step may use what the first has evaluated; for a linear acceleration every later one does the same.

    >>> evaluations_of("velocity_verlet", [1, 2, 100])
    array([  2,   3, 101])
    """
    first, second = _counted(method)
    return first + (np.asarray(steps) - 1) * second


@cache
def _counted(method: str) -> tuple[int, int]:
    """Return the evaluations of the first and of the second step."""
    calls = 0

    def acceleration(q: float) -> float:
        nonlocal calls
        calls += 1
        return -q

    states, counted = trajectory(METHODS[method], acceleration, 1.0, 0.0, 0.1), []
    for _step in range(2):
        next(states)
        counted.append(calls)
    return counted[0], counted[1] - counted[0]
