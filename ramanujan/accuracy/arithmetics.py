"""Time and error of one value of Ω² in float64, which the app uses, and in four other kinds of arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import TypeAlias

import mpmath
import numpy as np

from ramanujan.accuracy.exact import exact_frequency_squared, frequency_squared, frequency_squared_by_integers
from ramanujan.accuracy.measurement import REFERENCE, measure
from ramanujan.physics.frequency import effective_mass_ratio
from ramanujan.text.translation import _

MACHINE_COUNT = 200
"""Number of random machines."""

_MOST = 5.0, 10.0, 200.0
"""Largest m [kg], m′ [kg] and k [N/m] of the random machines. The smallest values are a hundredth of these."""

_Number: TypeAlias = float | Fraction | mpmath.mpf


@dataclass(frozen=True)
class Arithmetic:
    """A kind of arithmetic: its title, and the function (m, m′, k) → Ω² of three floats."""

    title: str
    evaluate: Callable[[float, float, float], _Number]


@dataclass(frozen=True)
class Price:
    """Measured time [s] of one value of Ω², and the largest relative error among the random machines."""

    seconds: float
    error: float


def measure_arithmetics() -> dict[str, Price]:
    """Measure every kind of arithmetic. The errors are relative to exact fractions.

    Returns
    -------
    name in ARITHMETICS → its price

    >>> prices = measure_arithmetics()
    >>> prices["fractions"].error
    0.0
    """
    exponents = np.random.default_rng(1729).uniform(-2, 0, (MACHINE_COUNT, 3))
    machines = (10.0**exponents * _MOST).tolist()
    return {name: _measure_arithmetic(arithmetic, machines) for name, arithmetic in ARITHMETICS.items()}


def _measure_arithmetic(arithmetic: Arithmetic, machines: list[list[float]]) -> Price:
    """Measure the time for the first machine, and the errors for all machines."""
    seconds = measure(partial(arithmetic.evaluate, *machines[0]))
    error = 0.0
    for machine in machines:
        exact = _fractions(*machine)
        difference = _to_fraction(arithmetic.evaluate(*machine)) - exact
        error = max(error, float(abs(difference) / exact))
    return Price(seconds, error)


def _float64(m: float, m_prime: float, k: float) -> float:
    return k / m / effective_mass_ratio(m_prime / m)


def _float32(m: float, m_prime: float, k: float) -> float:
    block, roller, stiffness = np.array([m, m_prime, k], np.float32)
    return float(stiffness / block / effective_mass_ratio(roller / block))


def _fractions(m: float, m_prime: float, k: float) -> Fraction:
    return frequency_squared(Fraction(m), Fraction(m_prime), Fraction(k))


ARITHMETICS: dict[str, Arithmetic] = {
    "float64": Arithmetic(_("float64, as in this app"), _float64),
    "float32": Arithmetic("float32", _float32),
    "integers": Arithmetic(_("integers of any length, rounded once"), frequency_squared_by_integers),
    "fractions": Arithmetic(_("fractions"), _fractions),
    "digits": Arithmetic(_("50 digits"), exact_frequency_squared),
}
"""Name → kind of arithmetic."""


def _to_fraction(value: _Number) -> Fraction:
    """Return the exact value of a positive number."""
    if isinstance(value, REFERENCE.mpf):
        mantissa, exponent = value.man_exp
        return int(mantissa) * Fraction(2) ** exponent
    return Fraction(value)
