"""The machine in time: from an initial state to the exact state at any time, in closed form.

Lives here: `InitialState`, the general solution, and what follows from a state. No integrator, no sampling choice.

Both momenta are conserved, so X and Φ are a steady drift plus a copy of the oscillation of φ:

    φ(t) = φ₀ cos Ωt + (φ̇₀/Ω) sin Ωt
    X(t) = X₀ + (Ẋ₀ − κRφ̇₀) t + κR (φ(t) − φ₀)
    Φ(t) = Φ₀ + (Φ̇₀ − λφ̇₀) t + λ (φ(t) − φ₀)

The phase Ωt is reduced in turns, with Ω/2π carried as the sum of two doubles: after n periods a plain product
fl(Ω)·t is wrong by about n·1e-15 rad, the reduced one by 1e-15 rad however large n is (up to 1e15).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from decimal import Context, Decimal, localcontext
from functools import lru_cache
from typing import Any

import numpy as np

from ramanujan.oscillator import Oscillator, real_number

_TWO_PI = Decimal("6.28318530717958647692528676655900576839433879875021")
_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant: it cuts a double into two halves whose products are exact."""


@dataclass(frozen=True)
class InitialState:
    """Where the machine starts: q = (X, φ, Φ) and its time derivatives at t = 0.

    Parameters
    ----------
    X, X_dot : the block's displacement over the ground, counted to the LEFT [m], and velocity [m/s]
    phi, phi_dot : φ, angle of hoop and lower cylinder, clockwise [rad], and angular velocity [rad/s]
    Phi, Phi_dot : Φ, angle of the top cylinder, clockwise [rad], and angular velocity [rad/s]

    Raises
    ------
    ValueError : a field is not a finite number; the message names it.
    """

    X: float = 0.0
    phi: float = 0.0
    Phi: float = 0.0
    X_dot: float = 0.0
    phi_dot: float = 0.0
    Phi_dot: float = 0.0

    def __post_init__(self) -> None:
        for field in fields(self):
            object.__setattr__(self, field.name, _finite(field.name, getattr(self, field.name)))


def released(oscillator: Oscillator, compression: float) -> InitialState:
    """Return the state in which the machine is let go: at rest, the spring compressed by x₀, φ₀ = x₀/(2R).

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; negative means a stretched spring

    Raises
    ------
    ValueError : the compression is not a finite number.

    Source: paper, section 1 (x = 2Rφ).
    """
    return InitialState(phi=_finite("compression", compression) / (2 * oscillator.radius))


def motion(oscillator: Oscillator, initial: InitialState, t: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the exact state (q, q̇) at the times t, each of shape (3, …t), in the order X, φ, Φ.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0
    t : time [s], scalar or array of any shape, either sign

    Raises
    ------
    ValueError : a time is not a finite number.

    Source: module docstring; the equations (11) of the paper, integrated with both conserved momenta.
    """
    times = _times(t)
    cosine, sine = _cosine_sine(oscillator, times)
    omega = oscillator.natural_frequency
    kappa_R, _, lambda_ = oscillator.mode_shape

    phi = initial.phi * cosine + initial.phi_dot / omega * sine
    phi_dot = initial.phi_dot * cosine - initial.phi * omega * sine
    drift_X = initial.X_dot - kappa_R * initial.phi_dot
    drift_Phi = initial.Phi_dot - lambda_ * initial.phi_dot
    swing = phi - initial.phi

    q = np.stack(
        [initial.X + drift_X * times + kappa_R * swing, phi, initial.Phi + drift_Phi * times + lambda_ * swing]
    )
    q_dot = np.stack([drift_X + kappa_R * phi_dot, phi_dot, drift_Phi + lambda_ * phi_dot])
    return q, q_dot


def _cosine_sine(oscillator: Oscillator, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cos Ωt and sin Ωt from the phase reduced in turns (Dekker's exact product of Ω/2π and t)."""
    high, low = _frequency_in_turns(oscillator)
    turns = high * times
    remainder = _product_error(high, times, turns) + low * times
    angle = 2 * math.pi * ((turns - np.rint(turns)) + remainder)
    return np.cos(angle), np.sin(angle)


def _product_error(a: float, b: np.ndarray, product: np.ndarray) -> np.ndarray:
    """Return a·b − fl(a·b) exactly, for operands far from the ends of the range (Dekker 1971, Veltkamp's split)."""
    a_high, b_high = _SPLITTER * a - (_SPLITTER * a - a), _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


@lru_cache(maxsize=256)
def _frequency_in_turns(oscillator: Oscillator) -> tuple[float, float]:
    """Return Ω/2π [1/s] as an unevaluated sum of two doubles, from 45-digit decimals: Ω² is rational in the inputs."""
    with localcontext(Context(prec=45)):
        m, m_prime, k = map(Decimal, (oscillator.m, oscillator.m_prime, oscillator.k))
        squared = 8 * k * (7 * m + 6 * m_prime) / (32 * m * m + 49 * m * m_prime + 18 * m_prime * m_prime)
        frequency = squared.sqrt() / _TWO_PI
        high = float(frequency)
        return high, float(frequency - Decimal(high))


def _times(t: Any) -> np.ndarray:
    """Return t as a float64 array, or raise ValueError."""
    try:
        times = np.asarray(t, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError("t must be a number or an array of numbers") from None
    if not np.all(np.isfinite(times)):
        raise ValueError("t must be finite")
    return times


def _finite(name: str, value: Any) -> float:
    """Return value as a float, or raise ValueError naming it unless it is a finite number."""
    number = real_number(value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be a finite number, not {value!r:.60}")
    return number
