"""Exact arithmetic: Ω² from integers or fractions, and the phase Ωt without its whole turns.

`physics.oscillator` and `physics.motion` use plain floating-point arithmetic instead. The experiments in
`extremes`, `phase` and `arithmetics` compare the two in accuracy and cost.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TypeVar

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.physics.oscillator import Oscillator
from ramanujan.physics.validation import FloatOrArray

AnyNumber = TypeVar("AnyNumber", Fraction, float, NDArray[np.floating])
"""The type of a number in exact or in floating-point arithmetic. The numbers of mpmath have no type annotations."""

_SPLITTER = 2.0**27 + 1
"""Veltkamp's constant, which splits a float into two halves of 26 bits. Products of such halves are exact."""


def frequency_squared(m: AnyNumber, m_prime: AnyNumber, k: AnyNumber) -> AnyNumber:
    """Return Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) in the arithmetic of the arguments.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg] and k [N/m], all of the same type: fractions, mpmath numbers, floats, or arrays

    Returns
    -------
    Ω² [rad²/s²] : exact for fractions

    Source: paper, eq. (12), as one fraction.

    >>> from fractions import Fraction
    >>> frequency_squared(Fraction(1), Fraction(1), Fraction(1))
    Fraction(104, 99)
    """
    return 8 * k * (7 * m + 6 * m_prime) / (32 * m * m + 49 * m * m_prime + 18 * m_prime * m_prime)


def frequency_squared_by_integers(m: float, m_prime: float, k: float) -> float:
    """Return the nearest float to Ω², computed with integers of any length.

    Each float is a quotient of two integers. With common denominators, Ω² is also a quotient of two integers. Python's
    division of integers rounds it correctly.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg] and k [N/m]

    Returns
    -------
    Ω² [rad²/s²] : with an error of at most half a unit in the last place

    >>> frequency_squared_by_integers(1.0, 1.0, 99.0)
    104.0
    """
    m_numerator, m_denominator = m.as_integer_ratio()
    prime_numerator, prime_denominator = m_prime.as_integer_ratio()
    k_numerator, k_denominator = k.as_integer_ratio()
    # Over the common denominator of both masses, m = block/common and m′ = roller/common.
    common = m_denominator * prime_denominator
    block = m_numerator * prime_denominator
    roller = prime_numerator * m_denominator
    numerator = 8 * k_numerator * common * (7 * block + 6 * roller)
    denominator = k_denominator * (32 * block * block + 49 * block * roller + 18 * roller * roller)
    return numerator / denominator


def exact_frequency_squared(m: float, m_prime: float, k: float) -> mpmath.mpf:
    """Return Ω² [rad²/s²] with 50 digits, for the exact values of the arguments.

    Parameters
    ----------
    m, m_prime, k : m, m′ [kg], k [N/m]

    Returns
    -------
    an mpmath number of the context `REFERENCE`

    >>> round(float(exact_frequency_squared(1, 1, 99)), 9)
    104.0
    """
    exact_m, exact_m_prime, exact_k = (REFERENCE.mpf(float(value)) for value in (m, m_prime, k))
    return frequency_squared(exact_m, exact_m_prime, exact_k)


def turns_per_second(oscillator: Oscillator) -> tuple[float, float]:
    """Return Ω/2π [1/s] as the sum of two floats, with about 32 digits.

    Parameters
    ----------
    oscillator : the machine

    Returns
    -------
    the nearest float to Ω/2π, and the nearest float to the remainder

    >>> high, low = turns_per_second(Oscillator())
    >>> abs(low) < 1e-16 * high
    True
    """
    omega = REFERENCE.sqrt(exact_frequency_squared(oscillator.m, oscillator.m_prime, oscillator.k))
    turns = omega / (2 * REFERENCE.pi)
    high = float(turns)
    return high, float(turns - REFERENCE.mpf(high))


def reduced_phase(turns: tuple[float, float], times: FloatOrArray) -> FloatOrArray:
    """Return the phase Ωt without its whole turns. The subtraction of the turns causes no rounding error.

    Parameters
    ----------
    turns : Ω/2π as the sum of two floats, from `turns_per_second`
    times : t [s], a number or an array of any shape

    Returns
    -------
    the phase [rad] : with an error of at most 1e-15 rad for up to 1e15 periods. It is between −π and π after few
        periods, and up to a fifth of a turn beyond after 1e15 periods.

    Source: T. J. Dekker, Numer. Math. 18 (1971) 224, for the exact product.

    >>> float(reduced_phase((0.25, 0.0), np.float64(4.0)))
    0.0
    """
    high, low = turns
    product = high * times
    remainder = _product_error(high, times, product) + low * times
    return 2 * np.pi * ((product - np.rint(product)) + remainder)


def _product_error(a: float, b: FloatOrArray, rounded: FloatOrArray) -> FloatOrArray:
    """Return ab − `rounded`, exactly, where `rounded` is the float product a * b.

    The factors are split into halves by Veltkamp's method, and the products of the halves are added by Dekker's. No
    intermediate result may overflow or become subnormal.
    """
    a_high = _SPLITTER * a - (_SPLITTER * a - a)
    b_high = _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    return ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low
