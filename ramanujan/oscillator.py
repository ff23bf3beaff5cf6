"""The machine as numbers: four parameters in; matrices, natural frequency and mode shape out.

Lives here: `Oscillator` and the two pure functions that relate its mass ratio to its frequency.
Does not live here: time (`motion`), forces (`contact`), symbols (`derivation`).

The machine has three degrees of freedom, q = (X, φ, Φ), and one spring:

    M q̈ + K q = 0,    K = 4kR² e_φ e_φᵀ  (rank one)

so it has one oscillating mode and two zero-frequency modes. Everything that oscillates does so at

    Ω² = k / M_x,    M_x/m = 3ε/8 + 7/12 − 1/(12(7 + 6ε)),    ε = m′/m,

where M_x is the mass that the spring feels. This partial-fraction form is the one that is evaluated: it has no
large intermediate value, so it cannot overflow where the result does not (the paper's form fails beyond 1e153).
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

UNIT_MASS_RATIO = 48 / (1 + math.sqrt(1729))
"""ε* = (√1729 − 1)/36, where Ω² = k/m exactly; written without the subtraction, it rounds to the nearest double."""

_LIGHT_ROLLERS_LIMIT = 7 / 4
"""Ω²m/k for ε → 0, the least upper bound of the normalized frequency squared."""


def _effective_mass_ratio(mass_ratio: Any) -> Any:
    """M_x/m = 3ε/8 + 7/12 − 1/(84 + 72ε) for a float or array ε ≥ 0; ε = ∞ only ever meets the last term."""
    return mass_ratio * 0.375 + _bound_mass_ratio(mass_ratio)


def _bound_mass_ratio(mass_ratio: Any) -> Any:
    """(M_x − 3m′/8)/m = 7/12 − 1/(84 + 72ε), the part of M_x that does not grow with the rollers."""
    return 7 / 12 - 1 / (mass_ratio * 72 + 84)


def normalized_frequency_squared(mass_ratio: Any) -> Any:
    """Return Ω²m/k, the square of the natural frequency in units of √(k/m).

        Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32) = 1/(3ε/8 + 7/12 − 1/(12(7 + 6ε)))

    It falls from 7/4 at ε = 0 like 8/(3ε) for heavy rollers, and is 1 at ε = UNIT_MASS_RATIO.

    Parameters
    ----------
    mass_ratio : ε = m′/m, dimensionless, scalar or array of any shape; float32 in gives float32 out.

    Raises
    ------
    ValueError : a mass ratio is negative, infinite or not a number.

    Source: paper, section 2, the equation of motion before eq. (10), in partial fractions.
    """
    ratio = _as_floats("mass_ratio", mass_ratio)
    # One comparison per side finds every bad value: NaN fails both.
    if not (np.all(ratio >= 0) and np.all(ratio < np.inf)):
        raise ValueError("mass_ratio must be finite and not negative")
    with np.errstate(over="ignore"):
        return 1 / _effective_mass_ratio(ratio)


def mass_ratio_for(normalized_frequency_squared: Any) -> Any:
    """Return the one mass ratio ε > 0 at which Ω²m/k has the given value w; the inverse of the function above.

        18w ε² + (49w − 48) ε + (32w − 56) = 0

    With b = 49w − 48 and d = √(b² + 72w(56 − 32w)) = hypot(7w − 48, √48 w), the positive root is
    16(7 − 4w)/(b + d) for b ≥ 0 and (d − b)/(36w) otherwise: neither form subtracts nearly equal numbers.

    Parameters
    ----------
    normalized_frequency_squared : w = Ω²m/k, dimensionless, scalar or array; float32 in gives float32 out.

    Raises
    ------
    ValueError : w is outside 0 < w < 7/4, or so small that ε leaves the floating-point range.

    Source: physics of the unit-frequency condition, paper section 2, for a general target.
    """
    w = _as_floats("normalized_frequency_squared", normalized_frequency_squared)
    if not np.all((w > 0) & (w < _LIGHT_ROLLERS_LIMIT)):
        raise ValueError("normalized_frequency_squared must lie strictly between 0 and 7/4")
    b = 49 * w - 48
    d = np.hypot(7 * w - 48, math.sqrt(48) * w)
    # Where a branch is not taken it may divide by a tiny number; its value is thrown away.
    with np.errstate(over="ignore", divide="ignore"):
        ratio = np.where(b >= 0, 16 * (7 - 4 * w) / (b + d), (d - b) / 36 / w)[()]
    if not np.all(np.isfinite(ratio)):
        raise ValueError("normalized_frequency_squared is too small: its mass ratio exceeds the floating-point range")
    return ratio


@dataclass(frozen=True)
class Oscillator:
    """Ramanujan's oscillator: a stepped block with two rollers under a sprung slab, and a cylinder rolling free.

    Parameters
    ----------
    m : m, mass of the block, of the slab and of the top cylinder [kg]
    m_prime : m′, mass of the hoop and of the lower cylinder [kg]
    k : k, stiffness of the spring [N/m]
    radius : R, radius of the three rolling bodies [m]; it sets lengths and drops out of every frequency

    Raises
    ------
    ValueError : a parameter is not a finite positive number (the message names it), or a derived value
        leaves the range of normal float64 numbers, where it would be silently wrong.

    Source: paper, figure 1 and section 2; coordinates q = (X, φ, Φ) with X counted to the left.
    """

    m: float = 1.0
    m_prime: float = 1.0
    k: float = 1.0
    radius: float = 0.1

    def __post_init__(self) -> None:
        for field in fields(self):
            value = _positive(field.name, getattr(self, field.name))
            object.__setattr__(self, field.name, value)

    @property
    def mass_ratio(self) -> float:
        """ε = m′/m, dimensionless."""
        return self._representable("mass_ratio", self.m_prime / self.m)

    @cached_property
    def effective_mass(self) -> float:
        """M_x = 3m′/8 + (m/2)(8m + 7m′)/(7m + 6m′) [kg], the mass that the spring feels; Ω² = k/M_x."""
        # An overflow or underflow of m′/m is harmless here: its term then is 0 or 1/84 to the last digit.
        bound = self.m * _bound_mass_ratio(self.m_prime / self.m)
        return self._representable("effective_mass", self.m_prime * 0.375 + bound)

    @property
    def natural_frequency_squared(self) -> float:
        """Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) [rad²/s²]."""
        return self._representable("natural_frequency_squared", self.k / self.effective_mass)

    @property
    def natural_frequency(self) -> float:
        """Ω [rad/s], the angular frequency of the one oscillating mode."""
        return math.sqrt(self.natural_frequency_squared)

    @property
    def period(self) -> float:
        """T = 2π/Ω [s]."""
        return 2 * math.pi / self.natural_frequency

    @property
    def normalized_frequency_squared(self) -> float:
        """Ω²m/k, dimensionless; it depends on ε alone and is 1 at ε = UNIT_MASS_RATIO."""
        return float(normalized_frequency_squared(self.mass_ratio))

    @property
    def block_coupling(self) -> float:
        """κ = 6(1 + ε)/(7 + 6ε), dimensionless: in the oscillating mode the block moves by X = κRφ."""
        return 1 - 1 / (7 + 6 * (self.m_prime / self.m))

    @property
    def mass_matrix(self) -> np.ndarray:
        """M, shape (3, 3): T = ½ q̇ᵀMq̇ for q = (X, φ, Φ); units kg, kg·m and kg·m² by row and column."""
        m, mp, R = self.m, self.m_prime, self.radius
        return self._representable(
            "mass_matrix",
            np.array(
                [
                    [3 * m + 2 * mp, -2 * (m + mp) * R, -m * R],
                    [-2 * (m + mp) * R, (4 * m + 3.5 * mp) * R * R, 0.0],
                    [-m * R, 0.0, 1.5 * m * R * R],
                ]
            ),
        )

    @property
    def stiffness_matrix(self) -> np.ndarray:
        """K, shape (3, 3): U = ½ qᵀKq; its one entry 4kR² [N·m] belongs to φ."""
        stiffness = np.zeros((3, 3))
        stiffness[1, 1] = self._representable("stiffness_matrix", 4 * self.k * self.radius * self.radius)
        return stiffness

    @property
    def mode_shape(self) -> np.ndarray:
        """The oscillating mode (κR, 1, λ), shape (3,), for q = (X, φ, Φ): metres, radians, radians; λ = 2κ/3."""
        kappa = self.block_coupling
        return np.array([kappa * self.radius, 1.0, 2 * kappa / 3])

    def _representable(self, name: str, value: Any) -> Any:
        """Return the value, or raise ValueError where overflow or underflow has made it wrong."""
        size = np.abs(np.asarray(value))
        diagonal = size.diagonal() if size.ndim == 2 else size
        if np.all(np.isfinite(size)) and np.all(diagonal >= sys.float_info.min):
            return value
        raise ValueError(
            f"{name} leaves the range of float64 for m={self.m!r}, m_prime={self.m_prime!r}, "
            f"k={self.k!r}, radius={self.radius!r}"
        )


def real_number(value: Any) -> float:
    """Return value as a float, or NaN for whatever is no real number (text included, since "1" is not 1)."""
    try:
        return math.nan if isinstance(value, str | bytes) else float(value)
    except (TypeError, ValueError, OverflowError):
        return math.nan


def _positive(name: str, value: Any) -> float:
    """Return value as a float, or raise ValueError naming the parameter unless it is a finite positive number."""
    number = real_number(value)
    if not 0 < number < math.inf:
        raise ValueError(f"{name} must be a finite positive number, not {value!r:.60}")
    return number


def _as_floats(name: str, values: Any) -> Any:
    """Return values as a NumPy scalar or array of floats, keeping float32; ValueError names what is no number."""
    try:
        array = np.asarray(values)
        if array.dtype.kind in "fiuO":
            return (array if array.dtype in (np.float32, np.float64) else array.astype(np.float64))[()]
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"{name} must be a real number or an array of real numbers")
