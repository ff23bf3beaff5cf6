"""Correct digits of two equivalent formulas in float64, while a parameter x moves to an extreme.

    time     x = t/T      1 − cos Ωt against the form of `motion`, 2 sin²(Ωt/2)
    ratio    x = m′/m     the paper's form of Ω² against the form that the app uses, with m = k = 1
    scale    x = m = m′ = k     the same forms; Ω² is the same for every x

Each formula has one critical step. In the plain formula this step loses the digits. The reference value is computed
with 50 digits from the same floats.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import mpmath
import numpy as np

from ramanujan.accuracy.exact import exact_frequency_squared
from ramanujan.accuracy.extremes import FORMS, USED_FORM
from ramanujan.accuracy.measurement import REFERENCE

DIGITS = 15
"""The number of decimal digits that every float64 value has."""

EXPERIMENTS = ("time", "ratio", "scale")


@dataclass(frozen=True)
class Evaluation:
    """The critical step and the value of a formula, and the number of correct digits of the value."""

    step: float
    value: float
    digits: int


@dataclass(frozen=True)
class Sample:
    """Both formulas at one x.

    Parameters
    ----------
    x : the parameter of the experiment
    plain, used : the plain formula, and the one that the app uses
    truth : the exact value
    """

    x: float
    plain: Evaluation
    used: Evaluation
    truth: mpmath.mpf


def compare(experiment: str) -> list[Sample]:
    """Return the samples of an experiment, in ascending order of x.

    >>> [sample.plain.digits for sample in compare("time")][:: -4]
    [15, 11, 7, 4, 0, 0]
    """
    with np.errstate(all="ignore"):
        return list(_compare_at_times() if experiment == "time" else _compare_masses(experiment))


def _compare_at_times() -> Iterator[Sample]:
    for phase in (math.tau * 10.0 ** (np.arange(-22, -1) / 2)).tolist():
        truth = 1 - REFERENCE.cos(phase)
        cosine, sine = math.cos(phase), math.sin(phase / 2)
        yield Sample(
            x=phase / math.tau,
            plain=_evaluate(cosine, 1 - cosine, truth),
            used=_evaluate(sine, 2 * sine**2, truth),
            truth=truth,
        )


def _compare_masses(experiment: str) -> Iterator[Sample]:
    for exponent in range(-300, 301, 4):
        x, one = np.array([10.0**exponent]), np.ones(1)
        m, m_prime, k = (one, x, one) if experiment == "ratio" else (x, x, x)
        truth = exact_frequency_squared(float(m[0]), float(m_prime[0]), float(k[0]))
        plain, used = (FORMS[form].evaluate(m, m_prime, k)[0] for form in ("paper", USED_FORM))
        yield Sample(
            x=float(x[0]),
            plain=_evaluate(float(((m_prime + m) ** 2)[0]), float(plain), truth),
            used=_evaluate(float((m_prime / m)[0]), float(used), truth),
            truth=truth,
        )


def _evaluate(step: float, value: float, truth: mpmath.mpf) -> Evaluation:
    if not math.isfinite(value):
        return Evaluation(step, value, 0)
    # A value that is right to n digits is wrong by at most half a unit in the nth one.
    error = float(2 * abs((REFERENCE.mpf(value) - truth) / truth))
    digits = DIGITS if error == 0 else math.floor(-math.log10(error))
    return Evaluation(step, value, min(max(digits, 0), DIGITS))
