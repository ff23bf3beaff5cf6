"""The phase Ωt after very many periods: the plain product, which `motion` uses, and one without whole turns.

The plain product fl(Ω)·t has the relative error of Ω, so its error grows with t. The other one takes Ω/2π as the sum of
two floats and subtracts whole turns exactly (`exact.reduced_phase`).
"""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared, reduced_phase, turns_per_second
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.motion import InitialState, motion
from ramanujan.oscillator import Oscillator

LARGEST_DECADE = 15
"""Beyond 1e15 periods neighbouring doubles t are a quarter of a period apart: t itself no longer determines a phase."""


@dataclass(frozen=True)
class PhaseErrors:
    """The largest phase errors [rad] at times near `periods` periods, the same times t for all.

    float32, float64 : fl(Ω)·t multiplied in that dtype;  reduced : whole turns subtracted first.
    """

    periods: float
    float32: float
    float64: float
    reduced: float


def phase_errors(oscillator: Oscillator) -> list[PhaseErrors]:
    """Return the phase errors after 1, 10, 100, … 10^LARGEST_DECADE periods, against 50-digit arithmetic.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    the `PhaseErrors` of each decade

    >>> [near.periods for near in phase_errors(Oscillator())][:3]
    [1.0, 10.0, 100.0]
    """
    return [_errors_near(oscillator, 10.0**decade) for decade in range(LARGEST_DECADE + 1)]


def largest_phase_error(oscillator: Oscillator, times: NDArray[np.float64]) -> float:
    """Return the largest phase error [rad] of `motion` at the given times, against 50-digit arithmetic.

    Parameters
    ----------
    oscillator : the machine
    times : times [s], shape (n,)

    Returns
    -------
    the largest of the n errors [rad]

    >>> largest_phase_error(Oscillator(), np.array([1.0, 10.0])) < 1e-14
    True
    """
    q, q_dot = motion(oscillator, InitialState(phi=1.0), times)
    sines = -q_dot[1] / oscillator.natural_frequency
    exact = map(REFERENCE.cos_sin, _exact_phases(oscillator, times))
    return max(
        abs(float(REFERENCE.mpf(float(s)) * cosine - REFERENCE.mpf(float(c)) * sine))
        for c, s, (cosine, sine) in zip(q[1], sines, exact, strict=True)
    )


def _errors_near(oscillator: Oscillator, periods: float) -> PhaseErrors:
    times = oscillator.period * (periods + np.arange(16) / 16)
    exact = _exact_phases(oscillator, times)
    omega = oscillator.natural_frequency
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        single = np.float32(omega) * times.astype(np.float32)
    return PhaseErrors(
        periods=periods,
        float32=_largest_gap(single, exact),
        float64=_largest_gap(omega * times, exact),
        reduced=_largest_gap(reduced_phase(turns_per_second(oscillator), times), exact),
    )


def _exact_phases(oscillator: Oscillator, times: NDArray[np.float64]) -> list[mpmath.mpf]:
    omega = REFERENCE.sqrt(exact_frequency_squared(oscillator.m, oscillator.m_prime, oscillator.k))
    return [omega * REFERENCE.mpf(float(t)) for t in times]


def _largest_gap(phases: NDArray[np.floating], exact: list[mpmath.mpf]) -> float:
    """Return the largest distance of two phases on the circle [rad], at most π."""
    turn = 2 * REFERENCE.pi
    gaps = (REFERENCE.mpf(float(phase)) - truth for phase, truth in zip(phases, exact, strict=True))
    return max(abs(float(gap - turn * REFERENCE.nint(gap / turn))) for gap in gaps)
