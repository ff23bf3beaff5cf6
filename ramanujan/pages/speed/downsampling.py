"""The results of the experiments of page 5, downsampled to the pixels of a screen, for stage and figures."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.accuracy.runs import History, count_evaluations
from ramanujan.accuracy.work_precision import SHOWN_STEPS, WorkPrecision
from ramanujan.text.numerals import number

SAMPLES_PER_PERIOD = 32
"""Largest number of samples in a period. With this number, straight lines between samples look like a curve."""
ROOM = 3.0
"""Largest displacement of the slab of an inaccurate run, in units of the compression."""
CURVE_POINTS = 96
"""Number of points of an error curve, about one for each pixel of its rise."""


@dataclass(frozen=True, eq=False)
class SampledRun:
    """One integration, downsampled to the resolution of the screen.

    Parameters
    ----------
    method, steps, periods : arguments of the integration
    per_period : number of samples in a period
    q : φ divided by its amplitude at the samples, with the start, shape (periods·per_period + 1,)
    times : times of the points of the error curves [periods], shape (points,)
    phase, energy : the largest |phase error| [rad] and |energy error| up to each point, shape (points,)
    turns : the largest |phase error| up to the end of each period [turns], shape (periods + 1,)
    phase_at_end : the phase error at the end, with its sign [rad]
    evaluations : evaluations of the force in the run
    """

    method: str
    steps: int
    periods: int
    per_period: int
    q: np.ndarray
    times: np.ndarray
    phase: np.ndarray
    energy: np.ndarray
    turns: np.ndarray
    phase_at_end: float
    evaluations: int


def stage_payload(run: SampledRun) -> dict[str, Any]:
    """Return the motion of a run for the stage. Outside of the stage's range, the slab remains at the edge.

    The entry `log` contains the number of evaluations and the phase error [turns] after each period, as texts.
    """
    q = np.clip(np.nan_to_num(run.q, nan=ROOM), -ROOM, ROOM)
    evaluations = count_evaluations(run.method, run.steps * np.arange(run.periods + 1))
    log = []
    for cost, error in zip(evaluations.tolist(), run.turns.tolist(), strict=True):
        log.append([number(cost, 6), number(error)])
    return {"per_period": run.per_period, "q": q.astype(float).round(4).tolist(), "log": log}


def costs(curve: WorkPrecision, by: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return cost, error and steps per period of the runs in the diagram; `by` is the kind of cost."""
    is_shown = np.isin(curve.steps_per_period, SHOWN_STEPS)
    return getattr(curve, by)[is_shown], curve.error[is_shown], curve.steps_per_period[is_shown]


def downsample(history: History, steps: int, periods: int) -> SampledRun:
    """Return a run with the number of points that a screen can resolve."""
    # Take every nth step, where n divides the steps of a period and leaves at most SAMPLES_PER_PERIOD samples.
    least = math.ceil(steps / SAMPLES_PER_PERIOD)
    stride = next(n for n in range(least, steps + 1) if steps % n == 0)
    # The points of an error curve have equal ratios, because its axis is logarithmic.
    ends = np.unique(np.rint(np.geomspace(1, steps * periods, CURVE_POINTS)).astype(int))
    with np.errstate(over="ignore"):
        q = history.q[::stride].astype(np.float32)
    phase = np.fmax.accumulate(np.abs(history.phase_error))
    return SampledRun(
        method=history.method,
        steps=steps,
        periods=periods,
        per_period=steps // stride,
        q=q,
        times=(ends / steps).astype(np.float32),
        phase=phase[ends],
        energy=np.fmax.accumulate(np.abs(history.energy_error))[ends],
        turns=phase[::steps] / (2 * np.pi),
        phase_at_end=float(history.phase_error[-1]),
        evaluations=history.evaluations,
    )
