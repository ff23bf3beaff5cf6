"""What exactness takes: Ω² from exact arithmetic, and a phase from which whole turns are subtracted.

The app uses neither: `ramanujan.oscillator` and `ramanujan.motion` compute in plain floating point. The experiments on
the extremes compare the formulas of the app with these.
"""

from __future__ import annotations

from typing import Any, TypeVar

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.oscillator import Oscillator

Number = TypeVar("Number", bound=Any)

_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant: it cuts a float into two halves whose products are exact."""


def frequency_squared(m: Number, m_prime: Number, k: Number) -> Number:
    """Return Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) in the arithmetic of the arguments.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg] and k [N/m], all of one kind: fractions, mpmath numbers, or floats

    Returns
    -------
    Ω² [rad²/s²] : exact for fractions

    Source: paper, eq. (12), in one fraction.

    >>> from fractions import Fraction
    >>> frequency_squared(Fraction(1), Fraction(1), Fraction(1))
    Fraction(104, 99)
    """
    return 8 * k * (7 * m + 6 * m_prime) / (32 * m * m + 49 * m * m_prime + 18 * m_prime * m_prime)


def frequency_squared_by_integers(m: float, m_prime: float, k: float) -> float:
    """Return the float that is nearest to Ω², from integers of any length.

    Each float is a quotient of two integers. Numerator and denominator of Ω² are multiplied by the denominators of m²
    and m′², and by that of k. Python rounds the quotient of two integers once, correctly.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg] and k [N/m]

    Returns
    -------
    Ω² [rad²/s²] : right to half a unit in the last place

    >>> frequency_squared_by_integers(1.0, 1.0, 99.0)
    104.0
    """
    (m_over, m_under), (prime_over, prime_under) = m.as_integer_ratio(), m_prime.as_integer_ratio()
    k_over, k_under = k.as_integer_ratio()
    block, roller, unit = m_over * prime_under, prime_over * m_under, m_under * prime_under
    above = 8 * k_over * unit * (7 * block + 6 * roller)
    below = k_under * (32 * block * block + 49 * block * roller + 18 * roller * roller)
    return above / below


def exact_frequency_squared(m: float, m_prime: float, k: float) -> mpmath.mpf:
    """Return Ω² [rad²/s²] to 50 digits for the given numbers, taken as exact.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg], k [N/m]

    Returns
    -------
    a number of `REFERENCE`

    >>> round(float(exact_frequency_squared(1, 1, 99)), 9)
    104.0
    """
    return frequency_squared(*(REFERENCE.mpf(float(value)) for value in (m, m_prime, k)))


def turns_per_second(oscillator: Oscillator) -> tuple[float, float]:
    """Return Ω/2π [1/s] as the sum of two floats, the second one much smaller than the first.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    the nearest float, and the nearest float to the rest

    >>> high, low = turns_per_second(Oscillator())
    >>> abs(low) < 1e-16 * high
    True
    """
    omega = REFERENCE.sqrt(exact_frequency_squared(oscillator.m, oscillator.m_prime, oscillator.k))
    turns = omega / (2 * REFERENCE.pi)
    high = float(turns)
    return high, float(turns - REFERENCE.mpf(high))


def reduced_phase(turns: tuple[float, float], times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the phase Ωt between −π and π, from which all whole turns are subtracted without an error.

    Parameters
    ----------
    turns : Ω/2π as the sum of two floats, from `turns_per_second`
    times : t [s], a number or an array of any shape

    Returns
    -------
    the phase [rad] : right to 1e-15 rad up to 1e15 periods

    Source: T. J. Dekker, Numer. Math. 18 (1971) 224, for the exact product.

    >>> float(reduced_phase((0.25, 0.0), np.float64(4.0)))
    0.0
    """
    high, low = turns
    product = high * times
    rest = _product_error(high, times, product) + low * times
    return 2 * np.pi * ((product - np.rint(product)) + rest)


def _product_error(a: float, b: NDArray[np.float64], rounded: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return ab − fl(ab) exactly, for factors far from the ends of the range (Dekker, with Veltkamp's split)."""
    a_high, b_high = _SPLITTER * a - (_SPLITTER * a - a), _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    return ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low
