"""The results of the experiments of page 5, downsampled to the pixels of a screen, for stage and figures."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.accuracy.runs import History, count_evaluations
from ramanujan.accuracy.work_precision import SHOWN_STEPS, WorkPrecision
from ramanujan.numerals import number

SAMPLES_PER_PERIOD = 32
"""Largest number of samples in a period: their straight connections look round."""
SCREEN_HEIGHT = 1080
"""Height in pixels with which errors on screen are compared."""
ROOM = 3.0
"""Largest travel of an inaccurate slab, in units of the compression."""
CURVE_POINTS = 96
"""Number of points of an error curve, about one for each pixel of its rise."""


@dataclass(frozen=True, eq=False)
class Run:
    """One integration, downsampled to the resolution of the screen.

    Parameters
    ----------
    method, dtype, steps, periods : arguments of the integration
    per_period : number of samples in a period
    q : φ divided by its amplitude at the samples, with the start, shape (periods·per_period + 1,)
    reach : times of the points of each error curve [periods], shape (points,)
    phase, energy : the largest |phase error| [rad] and |energy error| up to each point, shape (points,)
    turns : the largest |phase error| up to the end of each period [turns], shape (periods + 1,)
    phase_at_end : the phase error at the end, with its sign [rad]
    evaluations : evaluations of the force in the run
    """

    method: str
    dtype: str
    steps: int
    periods: int
    per_period: int
    q: np.ndarray
    reach: np.ndarray
    phase: np.ndarray
    energy: np.ndarray
    turns: np.ndarray
    phase_at_end: float
    evaluations: int


def played(run: Run) -> dict[str, Any]:
    """Return the part of a run that the stage plays. Outside of the stage's range, the slab remains at the edge."""
    q = np.clip(np.nan_to_num(run.q, nan=ROOM), -ROOM, ROOM)
    spent = count_evaluations(run.method, run.steps * np.arange(run.periods + 1)).clip(0)
    log = [[number(cost, 6), number(off)] for cost, off in zip(spent.tolist(), run.turns.tolist(), strict=True)]
    return {"per_period": run.per_period, "q": q.astype(float).round(4).tolist(), "log": log}


def costs(curve: WorkPrecision, by: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return cost, error and steps per period of the runs in the diagram."""
    at = np.isin(curve.steps_per_period, SHOWN_STEPS)
    error = np.where(np.isfinite(curve.error), curve.error, np.nan)
    return getattr(curve, by)[at], error[at], curve.steps_per_period[at]


def downsampled(history: History, steps: int, periods: int) -> Run:
    """Return a run with the number of points that a screen can resolve."""
    every = next(n for n in range(-(-steps // SAMPLES_PER_PERIOD), steps + 1) if steps % n == 0)
    # Equal ratios between neighbours show the growth of an error.
    ends = np.unique(np.rint(np.geomspace(1, steps * periods, CURVE_POINTS)).astype(int))
    with np.errstate(over="ignore"):
        q = history.q[::every].astype(np.float32)
    phase = np.fmax.accumulate(np.abs(history.phase_error))
    return Run(
        method=history.method,
        dtype=history.dtype,
        steps=steps,
        periods=periods,
        per_period=steps // every,
        q=q,
        reach=(ends / steps).astype(np.float32),
        phase=phase[ends],
        energy=np.fmax.accumulate(np.abs(history.energy_error))[ends],
        turns=phase[::steps] / (2 * np.pi),
        phase_at_end=float(history.phase_error[-1]),
        evaluations=history.evaluations,
    )
