"""The phase Ωt after very many periods: a plain product against the reduced phase of `motion`.

Lives here: that one experiment. A plain product fl(Ω)·t carries the relative rounding error of Ω into the phase, so
its error grows with t; `motion` carries Ω/2π as two doubles and takes the whole turns off exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ramanujan.accuracy.progress import REFERENCE, Piece, each, frequency_squared, positive_integer
from ramanujan.motion import InitialState, motion
from ramanujan.oscillator import Oscillator

LARGEST_DECADE = 15
"""Beyond 1e15 periods neighbouring doubles t lie a quarter of a period apart: t itself no longer names a phase."""


@dataclass(frozen=True)
class PhaseErrors:
    """The largest phase error [rad] among times near `periods` periods, for the same times t.

    float32, float64 : fl(Ω)·t multiplied in that dtype;  reduced : cosine and sine as `motion` returns them.
    """

    periods: float
    float32: float
    float64: float
    reduced: float


def phase_errors(
    oscillator: Oscillator, largest_decade: int = LARGEST_DECADE, samples: int = 16
) -> Iterator[Piece[PhaseErrors]]:
    """Yield the phase errors after 1, 10, 100, … 10^largest_decade periods, against 50-digit arithmetic.

    Parameters
    ----------
    oscillator : the machine
    largest_decade : from 1 to LARGEST_DECADE
    samples : times per decade, each a whole number of periods plus a fraction of one; the largest error counts

    Raises
    ------
    ValueError : an argument is outside its range.
    """
    last = positive_integer("largest_decade", largest_decade, LARGEST_DECADE)
    fractions = np.arange(positive_integer("samples", samples, 1000)) / samples
    return each(lambda decade: _errors_near(oscillator, 10.0**decade, fractions), range(last + 1))


def largest_phase_error(oscillator: Oscillator, times: np.ndarray) -> float:
    """Return the largest phase error [rad] of `motion` at the given times [s], against 50-digit arithmetic."""
    q, q_dot = motion(oscillator, InitialState(phi=1.0), times)
    sines = -q_dot[1] / oscillator.natural_frequency
    return max(
        abs(float(REFERENCE.mpf(float(s)) * REFERENCE.cos(phase) - REFERENCE.mpf(float(c)) * REFERENCE.sin(phase)))
        for c, s, phase in zip(q[1], sines, _exact_phases(oscillator, times), strict=True)
    )


def _errors_near(oscillator: Oscillator, periods: float, fractions: np.ndarray) -> PhaseErrors:
    times = oscillator.period * (periods + fractions)
    exact = _exact_phases(oscillator, times)
    omega = oscillator.natural_frequency
    return PhaseErrors(
        periods=periods,
        float32=_largest_gap(np.float32(omega) * times.astype(np.float32), exact),
        float64=_largest_gap(omega * times, exact),
        reduced=largest_phase_error(oscillator, times),
    )


def _exact_phases(oscillator: Oscillator, times: np.ndarray) -> list[Any]:
    omega = REFERENCE.sqrt(frequency_squared(oscillator.m, oscillator.m_prime, oscillator.k))
    return [omega * REFERENCE.mpf(float(t)) for t in times]


def _largest_gap(phases: np.ndarray, exact: list[Any]) -> float:
    """Return the largest distance of two phases on the circle [rad], at most π."""
    gaps = (float(REFERENCE.mpf(float(phase)) - truth) for phase, truth in zip(phases, exact, strict=True))
    return max(abs(math.remainder(gap, 2 * math.pi)) for gap in gaps)
