"""Error of the phase Ωt after many periods, for two methods: the plain product, and `exact.reduced_phase`.

`motion` uses the plain product fl(Ω)·t, where fl(Ω) is Ω as a float. Its error grows with t. `reduced_phase` represents
Ω/2π by the sum of two floats, and subtracts whole turns without a rounding error.
"""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared, reduced_phase, turns_per_second
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.physics.motion import InitialState, motion
from ramanujan.physics.oscillator import Oscillator

LARGEST_DECADE = 15
"""Largest power of ten of the periods. Beyond it, neighbouring doubles t differ by more than a quarter of a period."""


@dataclass(frozen=True)
class PhaseErrors:
    """The largest phase error [rad] of each method at 16 moments of the period after `periods` periods.

    Parameters
    ----------
    periods : number of periods
    float32, float64 : error of the plain product fl(Ω)·t in this dtype
    reduced : error of `reduced_phase`
    """

    periods: float
    float32: float
    float64: float
    reduced: float


def phase_errors(oscillator: Oscillator) -> list[PhaseErrors]:
    """Return the phase errors after 1, 10, 100, … 10^LARGEST_DECADE periods, relative to 50-digit arithmetic.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    the `PhaseErrors` of each decade

    >>> [errors.periods for errors in phase_errors(Oscillator())][:3]
    [1.0, 10.0, 100.0]
    """
    return [_compute_errors_after(oscillator, 10.0**decade) for decade in range(LARGEST_DECADE + 1)]


def largest_phase_error(oscillator: Oscillator, times: NDArray[np.float64]) -> float:
    """Return the largest phase error [rad] of `motion` at the given times, relative to 50-digit arithmetic.

    A phase error δ is computed as sin δ = sin(α + δ) cos α − cos(α + δ) sin α, where α is the exact phase. So δ must be
    small.

    Parameters
    ----------
    oscillator : the machine
    times : times [s], shape (n,)

    Returns
    -------
    the largest error [rad]

    >>> largest_phase_error(Oscillator(), np.array([1.0, 10.0])) < 1e-14
    True
    """
    # From φ₀ = 1 at rest, φ = cos Ωt and φ̇ = −Ω sin Ωt.
    q, q_dot = motion(oscillator, InitialState(phi=1.0), times)
    cosines, sines = q[1], -q_dot[1] / oscillator.natural_frequency
    errors = []
    for cosine, sine, phase in zip(cosines, sines, _exact_phases(oscillator, times), strict=True):
        exact_cosine, exact_sine = REFERENCE.cos_sin(phase)
        error = REFERENCE.mpf(float(sine)) * exact_cosine - REFERENCE.mpf(float(cosine)) * exact_sine
        errors.append(abs(float(error)))
    return max(errors)


def _compute_errors_after(oscillator: Oscillator, periods: float) -> PhaseErrors:
    """Return the phase errors in the period that begins after a number of periods."""
    times = oscillator.period * (periods + np.arange(16) / 16)
    exact = _exact_phases(oscillator, times)
    omega = oscillator.natural_frequency
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        single = np.float32(omega) * times.astype(np.float32)
    return PhaseErrors(
        periods=periods,
        float32=_largest_angle(single, exact),
        float64=_largest_angle(omega * times, exact),
        reduced=_largest_angle(reduced_phase(turns_per_second(oscillator), times), exact),
    )


def _exact_phases(oscillator: Oscillator, times: NDArray[np.float64]) -> list[mpmath.mpf]:
    """Return Ωt with 50 digits."""
    omega = REFERENCE.sqrt(exact_frequency_squared(oscillator.m, oscillator.m_prime, oscillator.k))
    return [omega * REFERENCE.mpf(float(t)) for t in times]


def _largest_angle(phases: NDArray[np.floating], exact: list[mpmath.mpf]) -> float:
    """Return the largest angle between a phase and its exact value on the circle [rad], at most π."""
    turn = 2 * REFERENCE.pi
    angles = []
    for phase, exact_phase in zip(phases, exact, strict=True):
        difference = REFERENCE.mpf(float(phase)) - exact_phase
        angles.append(abs(float(difference - turn * REFERENCE.nint(difference / turn))))
    return max(angles)
