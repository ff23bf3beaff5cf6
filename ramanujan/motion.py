"""The machine in time: from an initial state to the exact state at any time, in closed form.

Lives here: `InitialState`, the general solution, and where each body then is and how fast it moves.
Does not live here: energies and momenta (`energy`), forces (`contact`), how densely to draw (`sampling`), integrators.

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

FARTHEST = 1e18
"""Periods up to which the phase is right to 1e-12 rad: Ω/2π is known to two doubles, 106 bits."""


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
    ValueError : a time is not a finite number, or farther away than `FARTHEST` periods.

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


def relative_positions(oscillator: Oscillator, q: Any) -> dict[str, np.ndarray]:
    """Return how far each body has moved over the block [m], right positive: Rφ, Rφ, 2Rφ and RΦ.

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t); the displacements count from q = 0, where the spring is not deformed

    Returns a dict with the keys hoop, cylinder, slab and top, each of shape (…t); the slab's entry is the deformation
    of the spring.

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: the rolling constraints, paper section 2.
    """
    return _over_block(oscillator, _rows("q", q))


def relative_velocities(oscillator: Oscillator, q_dot: Any) -> dict[str, np.ndarray]:
    """Return each body's velocity over the block [m/s], right positive: Rφ̇, Rφ̇, 2Rφ̇ and RΦ̇.

    Parameters, keys and errors are those of `relative_positions`, with q̇ in place of q.
    """
    return _over_block(oscillator, _rows("q_dot", q_dot))


def ground_positions(oscillator: Oscillator, q: Any) -> dict[str, np.ndarray]:
    """Return how far each body has moved over the ground [m], right positive: −X, Rφ − X, Rφ − X, 2Rφ − X and RΦ − X.

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t); the displacements count from q = 0, where the spring is not deformed

    Returns a dict with the keys block, hoop, cylinder, slab and top, each of shape (…t).

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: the rolling constraints, paper section 2; X counts to the left.
    """
    return _over_ground(oscillator, _rows("q", q))


def ground_velocities(oscillator: Oscillator, q_dot: Any) -> dict[str, np.ndarray]:
    """Return each body's velocity over the ground [m/s], right positive: −Ẋ, Rφ̇ − Ẋ, Rφ̇ − Ẋ, 2Rφ̇ − Ẋ and RΦ̇ − Ẋ.

    Parameters, keys and errors are those of `ground_positions`, with q̇ in place of q.
    """
    return _over_ground(oscillator, _rows("q_dot", q_dot))


def _over_block(oscillator: Oscillator, q: np.ndarray) -> dict[str, np.ndarray]:
    """Map (X, φ, Φ), or its time derivative, to the four bodies' motion over the block."""
    _, phi, Phi = q
    R = oscillator.radius
    return {"hoop": R * phi, "cylinder": R * phi, "slab": 2 * R * phi, "top": R * Phi}


def _over_ground(oscillator: Oscillator, q: np.ndarray) -> dict[str, np.ndarray]:
    """Map (X, φ, Φ), or its time derivative, to the five bodies' motion over the ground."""
    over_block = _over_block(oscillator, q)
    return {"block": -q[0]} | {body: relative - q[0] for body, relative in over_block.items()}


def _cosine_sine(oscillator: Oscillator, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cos Ωt and sin Ωt from the phase reduced in turns (Dekker's exact product of Ω/2π and t)."""
    high, low = _frequency_in_turns(oscillator)
    if np.any(np.abs(times) > FARTHEST / high):
        raise ValueError(f"t must stay within {FARTHEST:g} periods: beyond, no phase is certain")
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


def _rows(name: str, coordinates: Any) -> np.ndarray:
    """Return coordinates as a float64 array whose rows belong to X, φ and Φ, or raise ValueError."""
    try:
        rows = np.asarray(coordinates, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be an array of numbers") from None
    if rows.ndim == 0 or len(rows) != 3:
        raise ValueError(f"{name} must have three rows, for X, φ and Φ, not the shape {rows.shape}")
    if not np.all(np.isfinite(rows)):
        raise ValueError(f"{name} must be finite")
    return rows


def _finite(name: str, value: Any) -> float:
    """Return value as a float, or raise ValueError naming it unless it is a finite number."""
    number = real_number(value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be a finite number, not {value!r:.60}")
    return number
