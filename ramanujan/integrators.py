"""Numerical integrators for x″ = a(x): one pure step function each, and the registry METHODS.

They are independent of the machine. `Method` holds the order, the cost and the stability limit of each.

Contract for a step function, `step(acceleration, q, v, h) -> (q, v)`:

 1. `acceleration(q)` returns x″ at the positions q, with the shape and dtype of q. It depends on q alone.
 2. q and v hold independent runs, one per element: an array of any shape, or plain floats for a single run.
    Element i of the acceleration depends on element i of q alone.
 3. h is the step, one for all runs or an array with one per run; it may be negative. h has the dtype of q or is a
    Python float, and constants are Python floats, so that float32 stays float32.
 4. A step changes no argument in place and keeps nothing between calls.
 5. A method that ends with a(q) returns that very object q, and one that begins with a(q) asks for it at the object
    that it was given: `trajectory` then evaluates it once for both. `Method.evaluations` counts with that saving;
    called by itself, a velocity Verlet step evaluates twice.
 6. An implicit method solves its equation for any acceleration, by iteration to the last digits, and raises
    `ValueError` where the iteration does not converge. It stops run by run, so that runs stay independent.

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
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from ramanujan.translation import _
from ramanujan.validation import finite_array, function, instance

Runs: TypeAlias = float | NDArray[np.floating]
"""One number for each independent run: an array of any shape, or a float for a single run."""

_MOST_ITERATIONS = 50
_RESIDUAL_ULPS = 4
"""Residual of an implicit equation, in roundings of its terms, below which it counts as solved."""
_CLOSE = 1e-3
"""Relative distance of two points of an iteration from which their secant counts as the tangent."""

Acceleration: TypeAlias = Callable[[Runs], Runs]
Step: TypeAlias = Callable[[Acceleration, Runs, Runs, Runs], tuple[Runs, Runs]]

_YOSHIDA_4_OUTER = 1 / (2 - 2 ** (1 / 3))
YOSHIDA_4_WEIGHTS = (_YOSHIDA_4_OUTER, -(2 ** (1 / 3)) * _YOSHIDA_4_OUTER, _YOSHIDA_4_OUTER)
"""Verlet steps that make up one Yoshida 4 step, in units of h: 2w₁ + w₀ = 1 and 2w₁³ + w₀³ = 0. [3] eq. (2.11)."""

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
    """Advance by q ← q + h(v + v_new)/2, v ← v + ha(y) with the middle y = (q + q_new)/2.

        y = q + ½hv + ¼h²a(y)

    This equation is solved by the secant method, from y = q + ½hv and one fixed-point step on. For a linear
    acceleration that is three evaluations, the last of which confirms the solution.

    Raises
    ------
    ValueError : the iteration does not converge, as can happen for a nonlinear force and a large step.

    Source: [1] eq. (I.1.7); item 6 of the contract.

    >>> [round(float(x), 6) for x in implicit_midpoint(lambda q: -q, 1.0, 0.0, 0.5)]
    [0.882353, -0.470588]
    """
    start, quarter = q + h / 2 * v, h * h / 4
    before, a_before = start, acceleration(start)
    middle, steepness, solved = start + quarter * a_before, 0.0, False
    kind = np.finfo(np.asarray(middle).dtype)
    tolerance, least = _RESIDUAL_ULPS * float(kind.eps), float(kind.smallest_normal)
    with np.errstate(all="ignore"):
        for _iteration in range(_MOST_ITERATIONS):
            a = acceleration(middle)
            residual, moved = (middle - start) - quarter * a, abs(middle - before)
            slope = np.divide(a - a_before, middle - before)
            # The residual that rounding of each term, and of the middle itself, can leave; for the latter only a slope
            # taken close to the solution counts. A few of the smallest floats may always be left.
            steepness = np.where((moved > 0) & (moved < _CLOSE * abs(middle)), abs(quarter * slope), steepness)[()]
            scale = abs(start) + abs(middle) + abs(quarter * a) + steepness * abs(middle) + least
            solved = solved | (np.isfinite(scale) & (abs(residual) <= tolerance * scale))
            if np.all(solved):
                return 2 * middle - q, v + h * a
            before, a_before = middle, a
            # A run that is solved does not change any more, so that runs stay independent.
            middle = np.where(solved, middle, middle - residual / (1 - quarter * slope))[()]
    raise ValueError(_("h is too large for this acceleration: the implicit midpoint equation was not solved"))


@dataclass(frozen=True)
class Method:
    """An integrator and its properties.

    Parameters
    ----------
    title : its usual name
    order : p, so that the error after a fixed time falls like h^p
    evaluations : evaluations of a(q) per step within a `trajectory`, for a linear a(q); the first step may take one
        more, and an implicit method more for a nonlinear a(q). What a run really takes, `accuracy` counts.
    stability_limit : the largest hΩ at which x″ = −Ω²x stays bounded; 0 for never, ∞ for always
    symplectic : whether the step preserves area in the phase plane, so that the energy error stays bounded
    source : reference, numbered as in the module docstring
    step : the step function
    """

    title: str
    order: int
    evaluations: int
    stability_limit: float
    symplectic: bool
    source: str
    step: Step


def trajectory(method: Method, acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> Iterator[tuple[Runs, Runs]]:
    """Return an iterator over the states (q, v) after 1, 2, 3, … steps, without end; `itertools.islice` cuts it off.

    Parameters
    ----------
    method : one of METHODS
    acceleration : a(q), see items 1 and 2 of the contract
    q, v : positions [m or rad] and velocities at the start, of one shape (…runs)
    h : step [s], scalar or shape (…runs)

    Returns
    -------
    iterator over (q, v); float32 stays float32

    Raises
    ------
    ValueError : an argument is not what it should be, at once; a step of an implicit method cannot be solved, later.

    >>> from itertools import islice
    >>> for q, v in islice(trajectory(METHODS["velocity_verlet"], lambda q: -q, 1.0, 0.0, 0.5), 2):
    ...     print(q, v)
    0.875 -0.46875
    0.53125 -0.8203125
    """
    instance("method", method, Method)
    function("acceleration", acceleration)
    shape = finite_array("q", q).shape
    if finite_array("v", v).shape != shape:
        sentence = _("v must have the shape of q, {shape}, not {other}")
        raise ValueError(sentence.format(shape=shape, other=np.shape(v)))
    if finite_array("h", h).shape not in ((), shape):
        sentence = _("h must be one number or have the shape of q, {shape}, not {other}")
        raise ValueError(sentence.format(shape=shape, other=np.shape(h)))
    q, v = (x if isinstance(x, float | np.floating | np.ndarray) else np.asarray(x, dtype=float)[()] for x in (q, v))
    kind = np.asarray(q).dtype.type
    # A number of NumPy's beside one of Python's would slow every operation of a single run.
    number = kind if isinstance(q, np.floating) else float
    h = number(h) if np.ndim(h) == 0 else np.asarray(h, dtype=kind)
    return _steps(method.step, _remembering(acceleration), q, v, h)


def _steps(step: Step, acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> Iterator[tuple[Runs, Runs]]:
    while True:
        q, v = step(acceleration, q, v, h)
        yield q, v


def _remembering(acceleration: Acceleration) -> Acceleration:
    """Return the acceleration with a memory of one: asked again at the same object, it does not evaluate again."""
    last_q = last_a = None

    def remembered(q: Runs) -> Runs:
        nonlocal last_q, last_a
        if q is not last_q:
            last_q, last_a = q, acceleration(q)
        return last_a

    return remembered


def _composed(weights: Sequence[float], acceleration: Acceleration, q: Runs, v: Runs, h: Runs) -> tuple[Runs, Runs]:
    """Take one velocity Verlet step of length wh for each weight w."""
    for weight in weights:
        q, v = velocity_verlet(acceleration, q, v, weight * h)
    return q, v


def _stability_limit(step: Step) -> float:
    """Return the stability limit of an explicit step that preserves area, from its own polynomial.

    With h = 1 and a(q) = −sq, s = (hΩ)², the step matrix has determinant 1 and a polynomial in s as its trace; its
    powers stay bounded while |trace| < 2.
    """
    s, zero, one = Polynomial([0.0, 1.0]), Polynomial([0.0]), Polynomial([1.0])
    trace = step(lambda q: -s * q, one, zero, 1.0)[0] + step(lambda q: -s * q, zero, one, 1.0)[1]
    # Every trace is 2 at s = 0: divide that root out.
    roots = np.concatenate([Polynomial((trace - 2).coef[1:]).roots(), (trace + 2).roots()])
    return math.sqrt(min(root.real for root in roots if abs(root.imag) < 1e-9 < root.real))


METHODS: dict[str, Method] = {
    "explicit_euler": Method(_("explicit Euler"), 1, 1, 0.0, False, "[2] section I.7", explicit_euler),
    "symplectic_euler": Method(
        _("symplectic Euler"), 1, 1, _stability_limit(symplectic_euler), True, "[1] eq. (I.1.9)", symplectic_euler
    ),
    "velocity_verlet": Method(
        _("velocity Verlet"), 2, 1, _stability_limit(velocity_verlet), True, "[1] eq. (I.1.17)", velocity_verlet
    ),
    "rk4": Method(_("Runge–Kutta 4"), 4, 4, 2 * math.sqrt(2), False, "[2] table II.1.2", rk4),
    "yoshida4": Method(_("Yoshida 4"), 4, 3, _stability_limit(yoshida4), True, "[3] eq. (2.11)", yoshida4),
    "yoshida6": Method(_("Yoshida 6"), 6, 7, _stability_limit(yoshida6), True, "[3] solution A", yoshida6),
    "implicit_midpoint": Method(_("implicit midpoint"), 2, 3, math.inf, True, "[1] eq. (I.1.7)", implicit_midpoint),
}
"""Every integrator by its name, the simplest first."""
