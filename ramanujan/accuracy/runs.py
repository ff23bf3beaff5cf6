"""Runs of the integrators on the oscillating mode, in units of the amplitude and of 1/Ω, and their errors.

Only the oscillating mode φ̈ = −Ω²φ is integrated. X and Φ are multiples of φ plus a uniform drift, and all methods here
compute a uniform drift exactly. In units of 1/Ω for the time and with q = φ/φ₀, all machines pose the same problem,

    q″ = −q,   q(0) = 1,   q′(0) = 0,   h = 2π/n.

So a run depends only on the method, on n, on the number of periods and on the dtype. Let v = q′ and s = q − iv. The
exact solution is s = e^{it}. The errors of a run, relative to the amplitude, are

    state error    |s − e^{it}|
    phase error    arg(s e^{−it}), unwrapped [rad]; positive if the run is ahead
    energy error   |s|² − 1
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.accuracy.measurement import measure
from ramanujan.physics.integrators import METHODS, Method, PerRun, trajectory

_BLOCK = 256
"""Largest number of steps in a block."""


@dataclass(frozen=True, eq=False)
class History:
    """One run with its errors. Arrays have one element for the start and one for each step.

    Parameters
    ----------
    method : name in METHODS
    q : φ divided by its amplitude
    phase_error : as in the module docstring [rad]
    energy_error : as in the module docstring, relative to the energy
    evaluations : number of evaluations of the acceleration
    """

    method: str
    q: np.ndarray
    phase_error: np.ndarray
    energy_error: np.ndarray
    evaluations: int


def error_history(method: str, steps_per_period: int, periods: int) -> History:
    """Return one run in float64 with its errors, which are the same for all machines.

    Parameters
    ----------
    method : name in METHODS
    steps_per_period : n ≥ 3, where h = 2π/n in units of 1/Ω
    periods : duration of the run, a whole number of periods

    Returns
    -------
    the run

    >>> error_history("rk4", 20, 10).evaluations
    800
    """
    n = steps_per_period
    start = np.ones(1), np.zeros(1)
    h = np.array([2 * np.pi / n])
    steps = np.array([n * periods])
    with np.errstate(over="ignore", invalid="ignore"):
        states = [np.ones(1, complex)]
        for _number, q, v in run_in_blocks(METHODS[method], start, h, steps):
            states.append(q[:, 0] - 1j * v[:, 0])
        s = np.concatenate(states)
        # Unwrap the error instead of the phase. The error changes by less than half a turn per step, and keeps its
        # digits. The remainder modulo n removes whole turns exactly.
        exact_phase = 2 * np.pi * (np.arange(s.size) % n) / n
        phase_error = np.unwrap(np.angle(s * np.exp(-1j * exact_phase)))
        energy_error = s.real**2 + s.imag**2 - 1
    return History(
        method=method,
        q=s.real,
        phase_error=phase_error,
        energy_error=energy_error,
        evaluations=int(count_evaluations(method, n * periods)),
    )


def run_in_blocks(
    method: Method, start: tuple[np.ndarray, np.ndarray], h: np.ndarray, steps: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield the states of several runs in blocks of consecutive steps, without the runs that have ended.

    A block ends at the latest where a run ends, so the last row contains the final state of that run.

    Parameters
    ----------
    method : the integrator
    start : (q, v), both of the shape (…, runs), of the dtype of the computation
    h : time steps, of the shape (…, runs)
    steps : number of steps of the runs in each column, shape (runs,), in ascending order

    Returns
    -------
    iterator over (numbers of the steps, q, v): an array of shape (rows,), and two float64 arrays of shape
    (rows, …, runs that have not ended)

    >>> start = np.ones(2), np.zeros(2)
    >>> for number, q, v in run_in_blocks(METHODS["rk4"], start, np.full(2, 0.1), np.array([10, 20])):
    ...     print(number[-1], q.shape)
    10 (10, 2)
    20 (10, 1)
    """
    # A single run in float64 is computed with numbers instead of arrays: the same bits, but much faster.
    is_single = h.size == 1 and h.dtype == float
    arguments = (array.item() for array in (*start, h)) if is_single else (*start, h)
    states = trajectory(method, lambda q: -q, *arguments)
    done = 0
    for ended_runs, last_step in enumerate(steps.tolist()):
        while done < last_step:
            rows = min(_BLOCK, last_step - done)
            q, v = np.empty((2, rows, *h.shape))
            # An unstable run may overflow; this is a result.
            with np.errstate(over="ignore", invalid="ignore"):
                for row, (q_row, v_row) in enumerate(islice(states, rows)):
                    q[row], v[row] = q_row, v_row
            yield np.arange(done + 1, done + rows + 1), q[..., ended_runs:], v[..., ended_runs:]
            done += rows


def seconds_per_step(method: str, dtype: str = "float64") -> float:
    """Return the median duration of a step of a single run [s]. The acceleration is one multiplication, like −Ω²φ.

    Parameters
    ----------
    method : name in METHODS
    dtype : "float32" or "float64"

    >>> seconds_per_step("rk4") > 0
    True
    """
    minus_omega_squared = np.dtype(dtype).type(-1)
    q, v = np.ones(1, dtype), np.zeros(1, dtype)
    states = trajectory(METHODS[method], lambda q: minus_omega_squared * q, q, v, 2 * np.pi / 100)
    # Explicit Euler overflows during the measurement, which does not change its speed.
    with np.errstate(over="ignore", invalid="ignore"):
        return measure(lambda: next(states))


def count_evaluations(method: str, steps: ArrayLike) -> NDArray[np.int64]:
    """Return the number of evaluations of the acceleration in a number of steps.

    The evaluations in the first two steps are counted. Each step after the first may reuse the last acceleration of the
    step before. So all steps after the first have the same number of evaluations.

    >>> count_evaluations("velocity_verlet", [0, 1, 2, 100])
    array([  0,   2,   3, 101])
    """
    first, second = _count_evaluations_in_first_steps(method)
    steps = np.asarray(steps)
    return np.where(steps > 0, first + (steps - 1) * second, 0)


@cache
def _count_evaluations_in_first_steps(method: str) -> tuple[int, int]:
    """Return the number of evaluations in the first step, and that in the second step."""
    calls = 0

    def acceleration(q: PerRun) -> PerRun:
        nonlocal calls
        calls += 1
        return -q

    states = trajectory(METHODS[method], acceleration, 1.0, 0.0, 0.1)
    next(states)
    calls_of_first_step = calls
    next(states)
    return calls_of_first_step, calls - calls_of_first_step
