"""The work–precision diagram: error and cost of each integrator, and the cheapest run within a tolerance.

The error of a run is the largest angle between the computed and the exact machine, in turns, at any of its steps. If
its amplitude has more than doubled, the angle has no meaning, and the error is half a turn.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from ramanujan.accuracy.measurement import measure
from ramanujan.accuracy.phase import largest_phase_error
from ramanujan.accuracy.runs import count_evaluations, run_in_blocks
from ramanujan.physics.integrators import METHODS
from ramanujan.physics.motion import InitialState, motion
from ramanujan.physics.oscillator import Oscillator

STEPS_PER_PERIOD = tuple(range(3, 193))
"""All numbers of steps per period. With fewer than 3, a step is half a turn or more."""

_FEWEST_SHOWN_STEPS, _MOST_SHOWN_EVALUATIONS = 6, 768
"""The first and the last run of each line in a diagram: steps per period, and evaluations per period."""

PERIODS = 30
"""Duration of the runs in the diagram."""

DTYPES = ("float64", "float32")

LARGEST_ERROR = 0.5
"""The largest error of a run: an angle does not count whole turns [turns]."""

_LARGEST_AMPLITUDE = 2.0
"""Largest amplitude of a meaningful run, relative to the exact one."""

_COMPUTING = threading.Lock()
"""Lock of the computations for the diagram, so that simultaneous visitors share one result."""


@dataclass(frozen=True)
class Run:
    """A run of a curve: its method, dtype, steps per period, largest error and cost."""

    method: str
    dtype: str
    steps_per_period: int
    error: float
    evaluations: int
    seconds: float


@dataclass(frozen=True, eq=False)
class WorkPrecision:
    """Error and cost of one method in one dtype. Arrays have one element for each run.

    Parameters
    ----------
    method : name in METHODS
    dtype : "float32" or "float64"
    periods : duration of all runs, in periods of the machine
    steps_per_period : n, where h = T/n; in ascending order
    error : largest error of the run at any step [turns], at most ½, for the worst rounding of h and Ω² among all
        machines
    evaluations : number of evaluations of the acceleration
    step_seconds : measured duration of one step [s]; NaN before the measurement
    """

    method: str
    dtype: str
    periods: int
    steps_per_period: np.ndarray
    error: np.ndarray
    evaluations: np.ndarray
    step_seconds: float = np.nan

    @property
    def seconds(self) -> np.ndarray:
        """Duration of each run [s]: number of steps times the duration of a step; NaN before the measurement."""
        return self.steps_per_period * self.periods * self.step_seconds

    def select(self, steps_per_period: int) -> Run:
        """Return the run with this number of steps per period."""
        index = int(np.searchsorted(self.steps_per_period, steps_per_period))
        return Run(
            method=self.method,
            dtype=self.dtype,
            steps_per_period=steps_per_period,
            error=float(self.error[index]),
            evaluations=int(self.evaluations[index]),
            seconds=float(self.seconds[index]),
        )


def work_precision(
    method: str, dtype: str = "float64", periods: int = PERIODS, steps_per_period: Sequence[int] = STEPS_PER_PERIOD
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

    Returns
    -------
    the runs, without measured durations

    >>> work_precision("velocity_verlet", periods=10, steps_per_period=[20]).evaluations
    array([201])
    """
    steps = np.unique(steps_per_period)
    h = _bracket_time_steps(steps, dtype)
    start = np.ones(h.shape, dtype), np.zeros(h.shape, dtype)
    # The exact states e^{it} at the steps of one period, one run after the other in one array.
    exact_states = np.concatenate([np.exp(2j * np.pi * np.arange(n) / n) for n in steps])
    first_index = np.cumsum(steps) - steps
    error = np.zeros(steps.size)
    for step_numbers, q, v in run_in_blocks(METHODS[method], start, h, steps * periods):
        running = slice(steps.size - q.shape[-1], None)  # the last ones, because runs are sorted by their steps
        step_in_period = step_numbers[:, None] % steps[running]
        exact = exact_states[first_index[running] + step_in_period][:, None]
        with np.errstate(over="ignore", invalid="ignore"):
            turns = _turns_between(q - 1j * v, exact)
        error[running] = np.maximum(error[running], turns.max(axis=(0, 1)))
    return WorkPrecision(
        method=method,
        dtype=dtype,
        periods=periods,
        steps_per_period=steps,
        error=error,
        evaluations=count_evaluations(method, steps * periods),
    )


@dataclass(frozen=True)
class ClosedForm:
    """Error of the closed form after the periods of the diagram [turns], and seconds per state."""

    error: float
    seconds: float


def measure_closed_form() -> ClosedForm:
    """Measure one state of `motion.motion` after `PERIODS`, for the machine with m = m′ = 1 kg and k = 1 N/m.

    >>> measure_closed_form().error < 1e-13
    True
    """
    machine = Oscillator()
    times = machine.period * (PERIODS + np.arange(16) / 16)
    seconds = measure(partial(motion, machine, InitialState(phi=1.0), float(times[0])))
    return ClosedForm(largest_phase_error(machine, times) / (2 * np.pi), seconds)


def _turns_between(computed: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Return the angles between states s = q − iv in turns; ½ where the computed amplitude is too large or NaN."""
    turns = abs(np.angle(computed * exact.conj())) / (2 * np.pi)
    return np.where(abs(computed) <= _LARGEST_AMPLITUDE, turns, LARGEST_ERROR)


def diagram_curve(method: str, dtype: str = "float64") -> WorkPrecision:
    """Return a curve of the diagram: the runs of one method over `PERIODS`. It is computed once.

    >>> diagram_curve("rk4") is diagram_curve("rk4")
    True
    """
    with _COMPUTING:
        return _diagram_curve(method, dtype)


@cache
def _diagram_curve(method: str, dtype: str) -> WorkPrecision:
    return work_precision(method, dtype)


def diagram_line(method: str) -> WorkPrecision:
    """Return the line of a method in a diagram: some of its runs over `PERIODS`. It is computed once.

    The lines of all methods end at the same number of evaluations, so their names fit at their ends.
    """
    with _COMPUTING:
        return _diagram_line(method)


@cache
def _diagram_line(method: str) -> WorkPrecision:
    most_steps = _MOST_SHOWN_EVALUATIONS // METHODS[method].evaluations
    steps = np.rint(np.geomspace(_FEWEST_SHOWN_STEPS, most_steps, 12)).astype(int)
    return work_precision(method, steps_per_period=steps.tolist())


def _bracket_time_steps(steps: np.ndarray, dtype: str) -> np.ndarray:
    """Return two time steps for each run, shape (2, runs), that enclose hΩ of all machines.

    The time step and Ω² of a machine are rounded. The relative error of hΩ is at most ¾ of the epsilon of the dtype: ½
    from h, and ¼ from Ω, whose relative error is half of that of Ω². This is at most 1½ spacings of h. The rounding of
    2π/n adds half a spacing.
    """
    h = (2 * np.pi / steps).astype(dtype)
    margin = 2 * np.spacing(h)
    return np.stack([h - margin, h + margin])


def find_cheapest_runs(curves: Iterable[WorkPrecision], tolerance: float, by: str = "evaluations") -> list[Run]:
    """Return the cheapest run of each method whose error does not exceed the tolerance, in order of cost.

    Parameters
    ----------
    curves : results of `work_precision`
    tolerance : largest error [turns]
    by : the cost, "evaluations" or "seconds"

    Returns
    -------
    the run with the fewest steps of each curve that has a run within the tolerance

    >>> [choice] = find_cheapest_runs([work_precision("rk4", periods=10)], tolerance=1e-2)
    >>> choice.steps_per_period
    11
    """
    choices = []
    for curve in curves:
        runs_within = np.flatnonzero(curve.error <= tolerance)
        if runs_within.size == 0:
            continue
        choices.append(curve.select(int(curve.steps_per_period[runs_within[0]])))
    return sorted(choices, key=lambda choice: getattr(choice, by))
