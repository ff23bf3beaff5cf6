"""The work–precision diagram: error against cost of every integrator, and the cheapest run for a tolerance.

The error of a run is the largest one at any step (`runs`): the state error, or the phase error in turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.runs import blocks, evaluations_of
from ramanujan.integrators import METHODS

STEPS_PER_PERIOD = tuple(range(3, 193))
"""Every whole number of steps that is tried; below 3, a step would turn by half a circle or more."""
SHOWN_STEPS: tuple[int, ...] = tuple(int(n) for n in np.rint(np.geomspace(6, 192, 12)))
"""Those among them that a diagram or a table shows."""
DTYPES = ("float64", "float32")


@dataclass(frozen=True, eq=False)
class WorkPrecision:
    """Error and cost of one method in one dtype over `periods` periods; each array has one element per run.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    periods : length of every run, in periods of the machine
    steps_per_period : n, so that h = T/n; ascending
    error : the largest error at any step of the run, see `runs`, for the worst rounding of h and Ω² that a
        machine can have; ∞ where the run left the range
    evaluations : evaluations of the acceleration in the run
    ends : q and v where the runs end, in units of the amplitude and of 1/Ω, each of shape (2, runs)
    step : measured seconds of one step; None before they are measured
    """

    method: str
    dtype: str
    periods: int
    steps_per_period: np.ndarray
    error: np.ndarray
    evaluations: np.ndarray
    ends: tuple[np.ndarray, np.ndarray]
    step: Timing | None = None

    @property
    def seconds(self) -> np.ndarray:
        """The run's steps times the median of the seconds per step; NaN before they are measured."""
        return self.steps_per_period * self.periods * (self.step.median if self.step else np.nan)


@dataclass(frozen=True)
class Choice:
    """One run within a tolerance: method, precision, step size, largest error and cost."""

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
    after: WorkPrecision | None = None,
    of: str = "state",
    between: Callable[[], object] = lambda: None,
) -> WorkPrecision:
    """Return error and evaluations of one method for each number of steps per period, for every machine the same.

    All runs are one array program: they step together until the longest has ended.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    periods : length of a run [periods], whole
    steps_per_period : n of every run, whole numbers from 3 on
    after : the same runs over fewer periods; they are continued, and `steps_per_period` is theirs
    of : the error that counts: "state", relative to the amplitude, or "phase", the angle to the exact motion in turns,
        at most ½
    between : called after every block of steps, some milliseconds of work; a server lets others work then

    Returns
    -------
    the runs over that many periods, without seconds

    >>> work_precision("velocity_verlet", periods=10, steps_per_period=[20]).evaluations
    array([201])
    """
    if after is None:
        steps, before = np.unique(steps_per_period), 0
        error, start = np.zeros(steps.size), (np.ones((2, steps.size), dtype), np.zeros((2, steps.size), dtype))
    else:
        steps, before, error, start = after.steps_per_period, after.periods, after.error.copy(), after.ends
    h = (2 * np.pi / steps).astype(dtype)
    # Every machine rounds its own h and Ω², so its hΩ is off by up to ¾ ε. These two steps enclose that.
    h = np.stack([h - 2 * np.spacing(h), h + 2 * np.spacing(h)])
    ends = np.empty((2, *h.shape), dtype)
    turns, first = np.concatenate([np.exp(2j * np.pi * np.arange(n) / n) for n in steps]), np.cumsum(steps) - steps
    for number, q, v in blocks(METHODS[method], start, h, steps * (periods - before)):
        running = slice(steps.size - q.shape[-1], None)
        exact = turns[first[running] + number[:, None] % steps[running]][:, None]
        with np.errstate(over="ignore", invalid="ignore"):
            if of == "phase":
                largest = abs(np.angle((q - 1j * v) * exact.conj())).max(axis=(0, 1)) / (2 * np.pi)
            else:
                largest = np.sqrt(((q - exact.real) ** 2 + (v + exact.imag) ** 2).max(axis=(0, 1)))
        error[running] = np.fmax(error[running], largest)
        ends[..., running] = q[-1], v[-1]
        between()
    # A run that has left the range is within no tolerance; if it is continued, it must not stop the others.
    lost = ~np.isfinite(ends).all(axis=(0, 1))
    error[lost], ends[..., lost] = np.inf, 0
    return WorkPrecision(method, dtype, periods, steps, error, evaluations_of(method, steps * periods), tuple(ends))


def cheapest(curves: Iterable[WorkPrecision], tolerance: float, by: str = "evaluations") -> list[Choice]:
    """Return the cheapest run of each curve whose error is within the tolerance at every step, in order of cost.

    Parameters
    ----------
    curves : results of `work_precision`
    tolerance : largest allowed error
    by : the cost that counts, "evaluations" or "seconds"

    Returns
    -------
    at most one choice for each curve, the run with the fewest steps; a curve without such a run has none

    >>> [choice] = cheapest([work_precision("rk4", periods=10)], tolerance=1e-2)
    >>> choice.steps_per_period
    17
    """
    found = []
    for curve in curves:
        if (within := curve.error <= tolerance).any():
            run, n = int(np.argmax(within)), curve.steps_per_period
            costs = int(curve.evaluations[run]), float(curve.seconds[run])
            found.append(Choice(curve.method, curve.dtype, int(n[run]), float(curve.error[run]), *costs))
    return sorted(found, key=lambda choice: getattr(choice, by))
