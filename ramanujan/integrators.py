"""Numerical integrators for x″ = a(x): one pure step function for each, and the registry METHODS.

They are independent of the machine. `Method` has the order, the cost and the stability limit of each.

Contract for a step function, `step(acceleration, q, v, h) -> (q, v)`:

 1. `acceleration(q)` returns x″ at the positions q, with the dtype of q. It depends on q alone.
 2. q and v are independent runs, one per element: an array of any shape, or plain floats for a single run.
    Element i of the acceleration depends on element i of q alone.
 3. h is the step, one for all runs or an array with one per run; it may be negative. h has the dtype of q or is a
    Python float, and constants are Python floats, so that float32 stays float32.
 4. A step changes no argument in place and keeps nothing between calls.
 5. A step that ends with a(q) returns the same object q, and a step that begins with a(q) evaluates it at the object
    that it received. `trajectory` evaluates it once for both, and `Method.evaluations` counts it once. A single
    velocity Verlet step evaluates twice.
 6. The implicit method needs a linear acceleration, a(q) = q·a(1).

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

from ramanujan.translation import _
from ramanujan.validation import float_array

Runs: TypeAlias = float | NDArray[np.floating]
"""One number for each independent run: an array of any shape, or a float for a single run."""

Acceleration: TypeAlias = Callable[[Runs], Runs]
Step: TypeAlias = Callable[[Acceleration, Runs, Runs, Runs], tuple[Runs, Runs]]

_YOSHIDA_4_OUTER = 1 / (2 - 2 ** (1 / 3))
YOSHIDA_4_WEIGHTS = (_YOSHIDA_4_OUTER, -(2 ** (1 / 3)) * _YOSHIDA_4_OUTER, _YOSHIDA_4_OUTER)
"""Verlet steps that make up one Yoshida 4 step, in units of h: 2w₁ + w₀ = 1 and 2w₁³ + w₀³ = 0. [3] eq. (2.11)."""

_GRID = 1 / 64
"""Step sizes hΩ at which a stability limit is first looked for."""

# Roots of four polynomial equations without a closed form: [3] table 1, solution A; digits from [1] eq. (V.3.11).
_YOSHIDA_6_SIDE = (0.78451361047755726382, 0.23557321335935813368, -1.17767998417887100695)
YOSHIDA_6_WEIGHTS = (*_YOSHIDA_6_SIDE, 1 - 2 * sum(_YOSHIDA_6_SIDE), *reversed(_YOSHIDA_6_SIDE))
"""Verlet steps that make up one Yoshida 6 step, in units of h; they are symmetric and sum to 1."""


def explicit_euler(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by q ← q + hv, v ← v + ha(q), both with the old values. [2] section I.7.

    >>> explicit_euler(lambda q: -q, 1.0, 0.0, 0.5)
    (1.0, -0.5)
    """
    return q + h * v, v + h * acceleration(q)


def symplectic_euler(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by v ← v + ha(q), then q ← q + hv with the new velocity. [1] eq. (I.1.9).

    >>> symplectic_euler(lambda q: -q, 1.0, 0.0, 0.5)
    (0.75, -0.5)
    """
    v = v + h * acceleration(q)
    return q + h * v, v


def velocity_verlet(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by half a kick, a drift and half a kick: v_½ = v + ½ha(q), q ← q + hv_½, v ← v_½ + ½ha(q).

    Source: [1] eq. (I.1.17).

    >>> velocity_verlet(lambda q: -q, 1.0, 0.0, 0.5)
    (0.875, -0.46875)
    """
    half = h / 2
    v = v + half * acceleration(q)
    q = q + h * v
    return q, v + half * acceleration(q)


def rk4(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
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


def yoshida4(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by three velocity Verlet steps w₁h, w₀h, w₁h, the middle one backwards. [3] eq. (2.11).

    >>> [round(x, 6) for x in yoshida4(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.878616, -0.478891]
    """
    return _composed(YOSHIDA_4_WEIGHTS, acceleration, q, v, h)


def yoshida6(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by seven velocity Verlet steps, symmetric, two of them backwards. [3] solution A.

    >>> [round(x, 6) for x in yoshida6(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.877568, -0.479436]
    """
    return _composed(YOSHIDA_6_WEIGHTS, acceleration, q, v, h)


def implicit_midpoint(acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Advance by q ← q + h(v + v_new)/2, v ← v + ha(y) with the middle y = (q + q_new)/2, for a linear acceleration.

    The equation y = q + ½hv + ¼h²a(y) has the solution y = (q + ½hv)/(1 − ¼h²s) if a(y) = sy. One evaluation gives the
    slope s = a(1), the other one a(y).

    Source: [1] eq. (I.1.7); item 6 of the contract.

    >>> [round(x, 6) for x in implicit_midpoint(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.882353, -0.470588]
    """
    slope = acceleration(1.0)
    middle = (q + h / 2 * v) / (1 - h * h / 4 * slope)
    return 2 * middle - q, v + h * acceleration(middle)


@dataclass(frozen=True)
class Method:
    """An integrator and its properties.

    Parameters
    ----------
    title : its usual name
    order : p, so that the error after a fixed time falls like h^p
    evaluations : evaluations of a(q) per step within a `trajectory`; the first step may take one more
    stability_limit : the largest hΩ at which x″ = −Ω²x stays bounded; 0 for never, ∞ for always
    step : the step function
    """

    title: str
    order: int
    evaluations: int
    stability_limit: float
    step: Step


def trajectory(method: Method, acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> Iterator[tuple[Runs, Runs]]:
    """Return an endless iterator over the states (q, v) after 1, 2, 3, … steps.

    Parameters
    ----------
    method : one of METHODS
    acceleration : a(q) [m/s² or rad/s²], items 1, 2 and 6 of the contract
    q, v : positions [m or rad] and velocities at the start, of one shape (…runs)
    h : step [s], a number or an array of shape (…runs)

    Returns
    -------
    iterator over (q, v), for example for `itertools.islice`; float32 stays float32

    Raises
    ------
    ValueError : q, v or h is not finite, or their shapes differ.

    >>> from itertools import islice
    >>> for q, v in islice(trajectory(METHODS["velocity_verlet"], lambda q: -q, 1.0, 0.0, 0.5), 2):
    ...     print(q, v)
    0.875 -0.46875
    0.53125 -0.8203125
    """
    shape = float_array("q", q).shape
    if float_array("v", v).shape != shape:
        raise ValueError(f"v must have the shape of q, {shape}, not {np.shape(v)}")
    if float_array("h", h).shape not in ((), shape):
        raise ValueError(f"h must be one number or have the shape of q, {shape}, not {np.shape(h)}")
    q, v = (x if isinstance(x, float | np.floating | np.ndarray) else np.asarray(x, dtype=float)[()] for x in (q, v))
    kind = np.asarray(q).dtype.type
    # A NumPy number beside a Python float would slow down every operation of a single run.
    number = kind if isinstance(q, np.floating) else float
    h = number(h) if np.ndim(h) == 0 else np.asarray(h, dtype=kind)
    return _steps(method.step, _remembering(acceleration), q, v, h)


def _steps(step: Step, acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> Iterator[tuple[Runs, Runs]]:
    while True:
        q, v = step(acceleration, q, v, h)
        yield q, v


def _remembering(acceleration: Acceleration) -> Acceleration:
    """Return the acceleration with a memory of one value: the same object q is not evaluated twice in a row."""
    last: tuple[Runs, Runs] | None = None

    def remembered(q: Runs) -> Runs:
        nonlocal last
        if last is None or q is not last[0]:
            last = q, acceleration(q)
        return last[1]

    return remembered


def _composed(weights: Sequence[float], acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Take one velocity Verlet step of length wh for each weight w."""
    for weight in weights:
        q, v = velocity_verlet(acceleration, q, v, weight * h)
    return q, v


def _stability_limit(step: Step) -> float:
    """Return the stability limit of an explicit step that preserves area.

    Its matrix for x″ = −x has determinant 1, so its powers stay bounded while |trace| < 2. The trace is 2 at h = 0.
    """

    def is_stable(h: float) -> bool:
        trace = step(lambda q: -q, 1.0, 0.0, h)[0] + step(lambda q: -q, 0.0, 1.0, h)[1]
        return bool(np.abs(trace) < 2)

    low, high = 0.0, _GRID
    while is_stable(high):
        low, high = high, high + _GRID
    while low < (middle := (low + high) / 2) < high:
        low, high = (middle, high) if is_stable(middle) else (low, middle)
    return high


METHODS: dict[str, Method] = {
    "explicit_euler": Method(_("explicit Euler"), 1, 1, 0.0, explicit_euler),
    "symplectic_euler": Method(_("symplectic Euler"), 1, 1, _stability_limit(symplectic_euler), symplectic_euler),
    "velocity_verlet": Method(_("velocity Verlet"), 2, 1, _stability_limit(velocity_verlet), velocity_verlet),
    "rk4": Method(_("Runge–Kutta 4"), 4, 4, 2 * math.sqrt(2), rk4),
    "yoshida4": Method(_("Yoshida 4"), 4, 3, _stability_limit(yoshida4), yoshida4),
    "yoshida6": Method(_("Yoshida 6"), 6, 7, _stability_limit(yoshida6), yoshida6),
    "implicit_midpoint": Method(_("implicit midpoint"), 2, 2, math.inf, implicit_midpoint),
}
"""Every integrator by its name, the simplest first."""
