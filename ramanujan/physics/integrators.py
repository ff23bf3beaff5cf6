"""Numerical integrators for x″ = a(x): a step function for each method, and the registry METHODS.

They are independent of the machine. `Method` contains the order, the cost and the stability limit of a method.

Contract for a step function, `step(acceleration, q, v, h) -> (q, v)`:

 1. `acceleration(q)` returns x″ at the positions q, with the dtype of q. It depends only on q.
 2. q and v are floats for a single run, or arrays with one element per independent run. Element i of the acceleration
    depends only on element i of q.
 3. h is the time step: one number for all runs, or an array with one element per run. It may be negative. h has the
    dtype of q or is a Python float, and constants are Python floats, so that float32 remains float32.
 4. A step function does not modify its arguments and has no state between calls.
 5. A step whose last evaluation is a(q) at the new q returns the same object q. A step whose first evaluation is a(q)
    at the old q evaluates the object q that was passed. `trajectory` recognizes this object and reuses the
    acceleration. `Method.evaluations` assumes this reuse: velocity Verlet evaluates twice in a single step, but once
    per step in a trajectory.
 6. The implicit method requires a linear acceleration, a(q) = q·a(1).

References
----------
[1] Hairer, Lubich, Wanner: Geometric Numerical Integration, 2nd ed., Springer 2006.
[2] Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, 2nd ed., Springer 1993.
[3] Yoshida: Construction of higher order symplectic integrators, Physics Letters A 150 (1990) 262–268.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ramanujan.physics.validation import float_array
from ramanujan.text.translation import _

PerRun: TypeAlias = float | NDArray[np.floating]
"""A float for a single run, or an array of any shape with one element for each independent run."""

Acceleration: TypeAlias = Callable[[PerRun], PerRun]
Step: TypeAlias = Callable[[Acceleration, PerRun, PerRun, PerRun], tuple[PerRun, PerRun]]

_YOSHIDA_4_OUTER = 1 / (2 - 2 ** (1 / 3))
YOSHIDA_4_WEIGHTS = (_YOSHIDA_4_OUTER, -(2 ** (1 / 3)) * _YOSHIDA_4_OUTER, _YOSHIDA_4_OUTER)
"""Weights (w₁, w₀, w₁) of Yoshida 4: one step consists of velocity Verlet steps w₁h, w₀h and w₁h. [3] eq. (2.11).

They solve 2w₁ + w₀ = 1 and 2w₁³ + w₀³ = 0.
"""

# Solution of polynomial equations without a closed form: [3] table 1, solution A; digits from [1] eq. (V.3.11).
_YOSHIDA_6_SIDE = (0.78451361047755726382, 0.23557321335935813368, -1.17767998417887100695)
YOSHIDA_6_WEIGHTS = (*_YOSHIDA_6_SIDE, 1 - 2 * sum(_YOSHIDA_6_SIDE), *reversed(_YOSHIDA_6_SIDE))
"""Weights of Yoshida 6: one step consists of seven velocity Verlet steps wh. The weights are symmetric and sum to 1."""

_YOSHIDA_4_LIMIT, _YOSHIDA_6_LIMIT = 1.57340194743454, 2.26905799639766
"""Stability limits: the least z > 0 at which the trace of the step matrix for x″ = −x, h = z is 2 or −2.

The matrix has determinant 1, and its powers are bounded if |trace| < 2. The trace is a polynomial in z² of degree 3 for
Yoshida 4, and of degree 7 for Yoshida 6.
"""


def explicit_euler(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance by q ← q + h·v and v ← v + h·a(q), where both right sides contain the old values. [2] section I.7.

    >>> explicit_euler(lambda q: -q, 1.0, 0.0, 0.5)
    (1.0, -0.5)
    """
    return q + h * v, v + h * acceleration(q)


def symplectic_euler(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance by v ← v + h·a(q), then by q ← q + h·v with the new velocity. [1] eq. (I.1.9).

    >>> symplectic_euler(lambda q: -q, 1.0, 0.0, 0.5)
    (0.75, -0.5)
    """
    v = v + h * acceleration(q)
    return q + h * v, v


def velocity_verlet(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance by v_½ = v + ½h·a(q), then q ← q + h·v_½, then v ← v_½ + ½h·a(q) with the new position.

    Source: [1] eq. (I.1.17).

    >>> velocity_verlet(lambda q: -q, 1.0, 0.0, 0.5)
    (0.875, -0.46875)
    """
    half = h / 2
    v = v + half * acceleration(q)
    q = q + h * v
    return q, v + half * acceleration(q)


def rk4(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance (q, v)′ = (v, a(q)) by the classical Runge–Kutta method: weights 1/6, 1/3, 1/3, 1/6. [2] table II.1.2.

    >>> [round(x, 6) for x in rk4(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.877604, -0.479167]
    """
    half = h / 2
    a_1 = acceleration(q)
    v_2, a_2 = v + half * a_1, acceleration(q + half * v)
    v_3, a_3 = v + half * a_2, acceleration(q + half * v_2)
    v_4, a_4 = v + h * a_3, acceleration(q + h * v_3)
    return q + h / 6 * (v + 2 * (v_2 + v_3) + v_4), v + h / 6 * (a_1 + 2 * (a_2 + a_3) + a_4)


def yoshida4(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance by velocity Verlet steps of sizes w₁·h, w₀·h and w₁·h, where w₀ is negative. [3] eq. (2.11).

    >>> [round(x, 6) for x in yoshida4(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.878616, -0.478891]
    """
    return _compose_verlet(YOSHIDA_4_WEIGHTS, acceleration, q, v, h)


def yoshida6(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Advance by seven velocity Verlet steps w·h, with the weights w in YOSHIDA_6_WEIGHTS. [3] solution A.

    Two weights are negative.

    >>> [round(x, 6) for x in yoshida6(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.877568, -0.479436]
    """
    return _compose_verlet(YOSHIDA_6_WEIGHTS, acceleration, q, v, h)


def implicit_midpoint(acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun) -> tuple[PerRun, PerRun]:
    """Solve q_new = q + ½h(v + v_new) and v_new = v + h·a(y) with the midpoint y = ½(q + q_new), for a linear a.

    Elimination of q_new and v_new gives y = q + ½h·v + ¼h²·a(y). With a(y) = sy the solution is
    y = (q + ½h·v)/(1 − ¼h²s). The first evaluation gives the slope s = a(1), the second one a(y).

    Source: [1] eq. (I.1.7); item 6 of the contract in the module docstring.

    >>> [round(x, 6) for x in implicit_midpoint(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.882353, -0.470588]
    """
    slope = acceleration(1.0)
    midpoint = (q + h / 2 * v) / (1 - h * h / 4 * slope)
    return 2 * midpoint - q, v + h * acceleration(midpoint)


@dataclass(frozen=True)
class Method:
    """An integrator and its properties.

    Parameters
    ----------
    title : usual name
    idea : its difference from the other methods, in words that follow the title
    order : p, where the error at a fixed time is proportional to h^p for small h
    evaluations : evaluations of a(q) per step of a `trajectory`; the first step may require one more
    stability_limit : upper limit of hΩ for bounded solutions of x″ = −Ω²x; 0 if unstable for all h, ∞ if always stable
    step : the step function
    """

    title: str
    idea: str
    order: int
    evaluations: int
    stability_limit: float
    step: Step


def trajectory(
    method: Method, acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun
) -> Iterator[tuple[PerRun, PerRun]]:
    """Return an endless iterator over the states (q, v) after 1, 2, 3, … steps.

    Parameters
    ----------
    method : one of METHODS
    acceleration : a(q) [m/s² or rad/s²], see items 1, 2 and 6 of the contract in the module docstring
    q, v : initial positions [m or rad] and velocities, of the same shape, with one element for each run
    h : time step [s], one number for all runs, or an array of the shape of q

    Returns
    -------
    iterator over (q, v), for example for `itertools.islice`; float32 for float32, otherwise float64

    Raises
    ------
    ValueError : q, v or h is not finite, or their shapes differ.

    >>> from itertools import islice
    >>> for q, v in islice(trajectory(METHODS["velocity_verlet"], lambda q: -q, 1.0, 0.0, 0.5), 2):
    ...     print(q, v)
    0.875 -0.46875
    0.53125 -0.8203125
    """
    q, v = _convert_runs("q", q), _convert_runs("v", v)
    if np.shape(v) != np.shape(q):
        raise ValueError(f"v must have the shape of q, {np.shape(q)}, not {np.shape(v)}")
    if float_array("h", h).shape not in ((), np.shape(q)):
        raise ValueError(f"h must be one number or have the shape of q, {np.shape(q)}, not {np.shape(h)}")
    return _iterate(method.step, _cache_last(acceleration), q, v, _convert_time_step(h, q))


def _convert_runs(name: str, values: PerRun) -> PerRun:
    """Return finite floats or floating-point arrays: Python floats and float32 unchanged, other types as float64."""
    array = float_array(name, values)
    if isinstance(values, float):
        return values
    # A NumPy scalar for an array without axes, otherwise the array itself.
    runs: PerRun = array[()]
    return runs


def _convert_time_step(h: PerRun, q: PerRun) -> PerRun:
    """Convert the time step h to a type that preserves the dtype of q."""
    dtype = np.asarray(q).dtype.type
    if np.ndim(h) > 0:
        return np.asarray(h, dtype=dtype)
    # A NumPy scalar beside a Python float q would slow down every operation.
    return dtype(h) if isinstance(q, np.floating) else float(h)


def _iterate(
    step: Step, acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun
) -> Iterator[tuple[PerRun, PerRun]]:
    while True:
        q, v = step(acceleration, q, v, h)
        yield q, v


def _cache_last(acceleration: Acceleration) -> Acceleration:
    """Return a function that caches the last acceleration, and reuses it if it is called with the same object q."""
    last_q: PerRun | None = None
    last_acceleration: PerRun | None = None

    def cached_acceleration(q: PerRun) -> PerRun:
        nonlocal last_q, last_acceleration
        if last_acceleration is None or q is not last_q:
            last_q, last_acceleration = q, acceleration(q)
        return last_acceleration

    return cached_acceleration


def _compose_verlet(
    weights: Sequence[float], acceleration: Acceleration, q: PerRun, v: PerRun, h: PerRun
) -> tuple[PerRun, PerRun]:
    """Advance by one velocity Verlet step wh for each weight w."""
    for weight in weights:
        q, v = velocity_verlet(acceleration, q, v, weight * h)
    return q, v


def _compose_idea(weights: Sequence[float]) -> str:
    """Return the steps of a composed method in words. A negative weight is a step back in time."""
    backwards = sum(weight < 0 for weight in weights)
    return _("joins {n} Verlet steps, {backwards} of them backwards").format(n=len(weights), backwards=backwards)


METHODS: dict[str, Method] = {
    "explicit_euler": Method(_("explicit Euler"), _("uses the old velocity"), 1, 1, 0.0, explicit_euler),
    "symplectic_euler": Method(_("symplectic Euler"), _("uses the new velocity"), 1, 1, 2.0, symplectic_euler),
    "velocity_verlet": Method(_("velocity Verlet"), _("uses the velocity at mid-step"), 2, 1, 2.0, velocity_verlet),
    "rk4": Method(_("Runge–Kutta 4"), _("uses a mean of four velocities"), 4, 4, 2 * math.sqrt(2), rk4),
    "yoshida4": Method(_("Yoshida 4"), _compose_idea(YOSHIDA_4_WEIGHTS), 4, 3, _YOSHIDA_4_LIMIT, yoshida4),
    "yoshida6": Method(_("Yoshida 6"), _compose_idea(YOSHIDA_6_WEIGHTS), 6, 7, _YOSHIDA_6_LIMIT, yoshida6),
    "implicit_midpoint": Method(
        _("implicit midpoint"), _("uses the force at mid-step"), 2, 2, math.inf, implicit_midpoint
    ),
}
"""Name → integrator, the simplest first.

The stability limits with z = hΩ: the eigenvalues of a step of explicit Euler have |λ|² = 1 + z². The trace of a step is
2 − z² for symplectic Euler and velocity Verlet. For Runge–Kutta 4, |λ|² = 1 − z⁶/72 + z⁸/576. For the implicit midpoint
rule, |λ| = 1.
"""
