"""The history of one run: how the integrated motion goes, and how its errors grow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.measurement import float_type
from ramanujan.accuracy.runs import LONGEST_RUN, blocks, method_named, steps_within
from ramanujan.accuracy.work_precision import evaluations_of
from ramanujan.validation import integer


@dataclass(frozen=True, eq=False)
class History:
    """One run; each array has one element per step, the start included.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    q : φ over its amplitude
    phase_error, energy_error : see `runs` [rad], [1]
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

    Raises
    ------
    ValueError : an argument is outside its range.

    >>> error_history("rk4", 20, 10).evaluations
    800
    """
    periods = integer("periods", periods, 1, LONGEST_RUN // 3)
    n, chosen = steps_within(steps_per_period, periods), method_named("method", method)
    kind = float_type("dtype", dtype)
    start, h = (np.ones(1, kind), np.zeros(1, kind)), np.array([2 * np.pi / n], kind)
    found = [q - 1j * v for _number, q, v in blocks(chosen, start, h, np.array([n * periods]))]
    s = np.concatenate([[1.0], *(block[:, 0] for block in found)])
    with np.errstate(over="ignore", invalid="ignore"):
        # The error is unwrapped, not the phase: it moves by less than half a turn a step and keeps its last digits.
        # Whole turns are taken off as integers.
        phase = np.unwrap(np.angle(s * np.exp(-2j * np.pi * (np.arange(s.size) % n) / n)))
        energy = s.real**2 + s.imag**2 - 1
    return History(method, dtype, s.real, phase, energy, int(evaluations_of(method, n * periods)))
