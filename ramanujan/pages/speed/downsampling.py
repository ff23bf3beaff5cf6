"""What the experiments of page 5 found, downsampled to what a screen can show: fewer numbers for stage and figures."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan import Oscillator
from ramanujan.accuracy.runs import History
from ramanujan.accuracy.work_precision import SHOWN_STEPS, WorkPrecision
from ramanujan.motion import released

SAMPLES_PER_PERIOD = 32
"""A run with more steps than that is downsampled: straight pieces between so many points of a swing look round."""
SCREEN_HEIGHT = 1080
"""Pixels that errors on screen are held against."""
SHOWN_PERIODS = 8
"""Periods that the stage plays before it begins again."""
ROOM = 1.5
"""How far a wrong slab may travel in the picture, in units of the largest compression that can be set."""
CURVE_POINTS = 96
"""Points of an error curve: about as many as it has pixels to rise in."""


@dataclass(frozen=True, eq=False)
class Run:
    """One integration, downsampled to what the screen shows.

    Parameters
    ----------
    method, dtype, steps, periods : how it was made
    per_period : samples in a period
    q : φ over its amplitude at the samples, the start included, shape (periods·per_period + 1,)
    reach : where each error curve has its points [periods], shape (points,)
    phase, energy : the largest |phase error| [rad] and |energy error| so far, shape (points,)
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
    phase_at_end: float
    evaluations: int


def samples(run: Run, machine: Oscillator, compression: float, most: float) -> tuple[dict[str, Any], int, int, bool]:
    """Return what the stage plays of a run, its first and last period, and whether the slab leaves the picture.

    The last periods are played, as long as the slab is still in the picture; they begin and end with whole periods, so
    that both stages begin again together.
    """
    start = released(machine, compression).phi
    room = ROOM * most / compression
    inside = np.isfinite(run.q) & (np.abs(run.q) <= room)
    leaves = not inside.all()
    left = int(np.argmin(inside)) if leaves else run.q.size
    last = max(1, (left - 1) // run.per_period)
    first = max(0, last - SHOWN_PERIODS)
    # Beyond the room it hangs at the edge until the period is over.
    q = np.clip(np.nan_to_num(run.q[first * run.per_period : last * run.per_period + 1], nan=room), -room, room)
    kappa_R, _, lambda_ = machine.mode_shape
    phi = start * q.astype(float)
    swing = phi - start
    motion = {"X": kappa_R * swing, "phi": phi, "Phi": lambda_ * swing}
    rounded = {name: np.round(values, 5).tolist() for name, values in motion.items()}
    return {"step": machine.period / run.per_period, **rounded}, first, last, leaves


def costs(curve: WorkPrecision, by: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return cost, error and steps per period of the runs that the diagram shows."""
    at = np.isin(curve.steps_per_period, SHOWN_STEPS)
    error = np.where(np.isfinite(curve.error), curve.error, np.nan)
    return getattr(curve, by)[at], error[at], curve.steps_per_period[at]


def downsampled(history: History, steps: int, periods: int) -> Run:
    """Return a run in as many points as a screen can part."""
    every = next(n for n in range(-(-steps // SAMPLES_PER_PERIOD), steps + 1) if steps % n == 0)
    # Equal ratios between neighbours show how an error grows.
    ends = np.unique(np.rint(np.geomspace(1, steps * periods, CURVE_POINTS)).astype(int))
    with np.errstate(over="ignore"):
        q = history.q[::every].astype(np.float32)
    return Run(
        method=history.method,
        dtype=history.dtype,
        steps=steps,
        periods=periods,
        per_period=steps // every,
        q=q,
        reach=(ends / steps).astype(np.float32),
        phase=np.fmax.accumulate(np.abs(history.phase_error))[ends],
        energy=np.fmax.accumulate(np.abs(history.energy_error))[ends],
        phase_at_end=float(history.phase_error[-1]),
        evaluations=history.evaluations,
    )
