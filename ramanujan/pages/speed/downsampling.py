"""The results of the experiments of page 5, downsampled to the pixels of a screen, for stage and figures."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.accuracy.runs import History, count_evaluations
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
    q : φ divided by the exact amplitude at the samples, with the start, shape (periods·per_period + 1,)
    times : times of the points of the error curves [periods], shape (points,)
    phase, energy : the largest |phase error| [rad] and |energy error| up to each point, shape (points,)
    turns : the phase error at the end of each period, with its sign [turns], shape (periods + 1,)
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
    evaluations: int

    @property
    def phase_at_end(self) -> float:
        """The phase error at the end, with its sign [rad]."""
        return math.tau * float(self.turns[-1])


def stage_payload(run: SampledRun) -> dict[str, Any]:
    """Return the motion of a run for the stage. Outside of the stage's range, the slab remains at the edge.

    `evaluations` contains the number of evaluations after each period, as text, and `turns` the phase error there.
    """
    q = np.clip(np.nan_to_num(run.q, nan=ROOM), -ROOM, ROOM)
    evaluations = count_evaluations(run.method, run.steps * np.arange(run.periods + 1))
    return {
        "per_period": run.per_period,
        "q": q.astype(float).round(4).tolist(),
        "evaluations": [number(cost, 6) for cost in evaluations.tolist()],
        "turns": np.nan_to_num(run.turns).round(5).tolist(),
    }


def downsample(history: History, steps: int, periods: int) -> SampledRun:
    """Return a run with the number of points that a screen can resolve."""
    # A sample may be between two steps. Phase error and amplitude change little there, so these are interpolated.
    per_period = min(steps, SAMPLES_PER_PERIOD)
    samples = np.arange(per_period * periods + 1)
    places, numbers = samples * (steps / per_period), np.arange(history.q.size)
    phase_error = np.interp(places, numbers, history.phase_error)
    amplitude = np.interp(places, numbers, np.sqrt(1 + history.energy_error))
    exact_phase = 2 * np.pi * (samples % per_period) / per_period
    # The points of an error curve have equal ratios, because its axis is logarithmic.
    ends = np.unique(np.rint(np.geomspace(1, steps * periods, CURVE_POINTS)).astype(int))
    with np.errstate(over="ignore", invalid="ignore"):
        q = (amplitude * np.cos(exact_phase + phase_error)).astype(np.float32)
    phase = np.fmax.accumulate(np.abs(history.phase_error))
    return SampledRun(
        method=history.method,
        steps=steps,
        periods=periods,
        per_period=per_period,
        q=q,
        times=(ends / steps).astype(np.float32),
        phase=phase[ends],
        energy=np.fmax.accumulate(np.abs(history.energy_error))[ends],
        turns=history.phase_error[::steps] / math.tau,
        evaluations=history.evaluations,
    )
