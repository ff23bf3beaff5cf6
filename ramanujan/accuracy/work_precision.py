"""The work–precision diagram: error and cost of each integrator, and the cheapest run within a tolerance.

The error of a run is the largest state error, or the largest phase error in turns, over its steps (see `runs`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.runs import count_evaluations, run_in_blocks
from ramanujan.integrators import METHODS

STEPS_PER_PERIOD = tuple(range(3, 193))
"""All numbers of steps per period that are computed. With fewer than 3, a step is half a turn or more."""

SHOWN_STEPS: tuple[int, ...] = tuple(int(n) for n in np.rint(np.geomspace(6, 192, 12)))
"""The numbers of steps per period that a diagram or a table shows."""

DTYPES = ("float64", "float32")


@dataclass(frozen=True, eq=False)
class WorkPrecision:
    """Error and cost of one method in one dtype. Arrays have one element for each run.

    Parameters
    ----------
    method : name in METHODS
    dtype : "float32" or "float64"
    periods : duration of all runs, in periods of the machine
    steps_per_period : n, where h = T/n; in ascending order
    error : largest error of the run at any step, for the worst rounding of h and Ω² among all machines; ∞ if the run
        overflowed
    evaluations : number of evaluations of the acceleration
    ends : final q and v, in units of the amplitude and of 1/Ω, each of shape (2, runs); see `work_precision`
    step : measured duration of one step; None before the measurement
    """

    method: str
    dtype: str
    periods: int
    steps_per_period: np.ndarray
    error: np.ndarray
    evaluations: np.ndarray
    ends: tuple[np.ndarray, np.ndarray]
    step_timing: Timing | None = None

    @property
    def seconds(self) -> np.ndarray:
        """Duration of each run: number of steps times the median duration of a step; NaN before the measurement."""
        return self.steps_per_period * self.periods * (self.step_timing.median if self.step_timing else np.nan)

    @property
    def spread(self) -> float:
        """Distance of the quartiles of a step's duration, relative to the median; NaN before the measurement."""
        return (self.step_timing.high - self.step_timing.low) / self.step_timing.median if self.step_timing else np.nan


@dataclass(frozen=True)
class CheapestRun:
    """A run within a tolerance: its method, dtype, steps per period, largest error and cost."""

    method: str
    dtype: str
    steps_per_period: int
    error: float
    evaluations: int
    seconds: float


def work_precision(
    method: str,
    dtype: str = "float64",
    periods: int = 100,
    steps_per_period: Sequence[int] = STEPS_PER_PERIOD,
    previous: WorkPrecision | None = None,
    error_kind: str = "state",
    after_block: Callable[[], object] = lambda: None,
) -> WorkPrecision:
    """Return the error and the evaluations of one method for each number of steps per period.

    The error is an upper bound for all machines. Each run is computed twice: with a time step just below hΩ of every
    machine, and with one just above.

    Parameters
    ----------
    method : name in METHODS
    dtype : "float32" or "float64"
    periods : duration of each run, a whole number of periods
    steps_per_period : n of each run, whole numbers of at least 3
    previous : the same runs over fewer periods, to be continued; then `steps_per_period` is ignored
    error_kind : "state" for the state error, or "phase" for the angle to the exact motion in turns, at most ½
    after_block : called after each block of steps, that is every few milliseconds; a server can yield to other threads

    Returns
    -------
    the runs, without measured durations

    >>> work_precision("velocity_verlet", periods=10, steps_per_period=[20]).evaluations
    array([201])
    """
    if previous is None:
        previous = _start_runs(np.unique(steps_per_period), method, dtype)
    steps, error = previous.steps_per_period, previous.error.copy()
    remaining_steps = steps * (periods - previous.periods)
    h = _bracket_time_steps(steps, dtype)
    ends = np.empty((2, *h.shape), dtype)
    # The exact states e^{it} at the steps of one period, one run after the other in one array.
    exact_states = np.concatenate([np.exp(2j * np.pi * np.arange(n) / n) for n in steps])
    first_index = np.cumsum(steps) - steps
    for step_numbers, q, v in run_in_blocks(METHODS[method], previous.ends, h, remaining_steps):
        running = slice(steps.size - q.shape[-1], None)  # the last ones, because runs are sorted by their steps
        step_in_period = step_numbers[:, None] % steps[running]
        exact = exact_states[first_index[running] + step_in_period][:, None]
        with np.errstate(over="ignore", invalid="ignore"):
            largest = _largest_error(q, v, exact, error_kind)
        error[running] = np.fmax(error[running], largest)
        ends[..., running] = q[-1], v[-1]
        after_block()
    # An overflowed run is not within any tolerance. Its end is set to 0, so that `trajectory` can continue the others.
    has_overflowed = ~np.isfinite(ends).all(axis=(0, 1))
    error[has_overflowed], ends[..., has_overflowed] = np.inf, 0
    return WorkPrecision(
        method=method,
        dtype=dtype,
        periods=periods,
        steps_per_period=steps,
        error=error,
        evaluations=count_evaluations(method, steps * periods),
        ends=tuple(ends),
    )


def _start_runs(steps: np.ndarray, method: str, dtype: str) -> WorkPrecision:
    """Return the runs at t = 0, before their first step: q = 1, v = 0."""
    # Each run is computed with two time steps.
    shape = (2, steps.size)
    ends = np.ones(shape, dtype), np.zeros(shape, dtype)
    return WorkPrecision(
        method=method,
        dtype=dtype,
        periods=0,
        steps_per_period=steps,
        error=np.zeros(steps.size),
        evaluations=np.zeros(steps.size, dtype=int),
        ends=ends,
    )


def _bracket_time_steps(steps: np.ndarray, dtype: str) -> np.ndarray:
    """Return two time steps for each run, shape (2, runs), that enclose hΩ of all machines.

    The time step and Ω² of a machine are rounded. The relative error of hΩ is at most ¾ of the epsilon of the dtype: ½
    from h, and ¼ from Ω, whose relative error is half of that of Ω². This is at most 1½ spacings of h. The rounding of
    2π/n adds half a spacing.
    """
    h = (2 * np.pi / steps).astype(dtype)
    margin = 2 * np.spacing(h)
    return np.stack([h - margin, h + margin])


def _largest_error(q: np.ndarray, v: np.ndarray, exact: np.ndarray, error_kind: str) -> np.ndarray:
    """Return the largest error of each run in a block, over all rows and both time steps of each run.

    Parameters
    ----------
    q, v : computed states, both of the shape (rows, 2, runs)
    exact : exact states e^{it}, shape (rows, 1, runs)
    error_kind : as in `work_precision`
    """
    if error_kind == "phase":
        phase_errors = np.angle((q - 1j * v) * exact.conj())
        return abs(phase_errors).max(axis=(0, 1)) / (2 * np.pi)
    # A state is s = q − iv. The exact q is the real part of e^{it}, and the exact v is minus its imaginary part.
    squared_errors = (q - exact.real) ** 2 + (v + exact.imag) ** 2
    return np.sqrt(squared_errors.max(axis=(0, 1)))


def find_cheapest_runs(curves: Iterable[WorkPrecision], tolerance: float, by: str = "evaluations") -> list[CheapestRun]:
    """Return the cheapest run of each method whose error does not exceed the tolerance, in order of cost.

    Parameters
    ----------
    curves : results of `work_precision`
    tolerance : largest error
    by : the cost, "evaluations" or "seconds"

    Returns
    -------
    the run with the fewest steps of each curve that has a run within the tolerance

    >>> [choice] = find_cheapest_runs([work_precision("rk4", periods=10)], tolerance=1e-2)
    >>> choice.steps_per_period
    17
    """
    choices = []
    for curve in curves:
        runs_within = np.flatnonzero(curve.error <= tolerance)
        if runs_within.size == 0:
            continue
        run = runs_within[0]
        choice = CheapestRun(
            method=curve.method,
            dtype=curve.dtype,
            steps_per_period=int(curve.steps_per_period[run]),
            error=float(curve.error[run]),
            evaluations=int(curve.evaluations[run]),
            seconds=float(curve.seconds[run]),
        )
        choices.append(choice)
    return sorted(choices, key=lambda choice: getattr(choice, by))
