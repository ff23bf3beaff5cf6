"""The motion in closed form: the exact state at any time from the initial state.

Both momenta are conserved, so X and Φ are each a steady drift plus a multiple of the oscillation of φ:

    φ(t) = φ₀ cos Ωt + φ̇₀ S              S = (sin Ωt)/Ω,  C = 1 − cos Ωt = 2 sin²(Ωt/2)
    X(t) = X₀ + (Ẋ₀ − κRφ̇₀) t + κR (φ̇₀ S − φ₀ C)
    Φ(t) = Φ₀ + (Φ̇₀ − λφ̇₀) t + λ (φ̇₀ S − φ₀ C)

In this form no nearly equal numbers are subtracted for a machine released at rest, however short t is.

The phase Ωt is reduced in turns, with Ω/2π carried as the sum of two doubles: after n periods a plain product
fl(Ω)·t is wrong by about n·1e-15 rad, the reduced one by 1e-15 rad however large n is (up to 1e15).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.numerals import number
from ramanujan.oscillator import Oscillator
from ramanujan.rounding import in_range, nearest, over_one_denominator, product_error, scaled
from ramanujan.translation import _
from ramanujan.validation import coordinates, finite_array, instance, real

FARTHEST = 1e18
"""Periods up to which the phase is right to 1e-12 rad: Ω/2π is known to two doubles, 106 bits."""

SHORT = 1e-9
"""Periods below which sin Ωt and Ωt are the same double: they differ by (Ωt)²/6 of their size."""

Values = float | NDArray[np.float64]
"""A series, or one value of it."""


@dataclass(frozen=True)
class InitialState:
    """The initial state: q = (X, φ, Φ) and its time derivatives at t = 0.

    Parameters
    ----------
    X, X_dot : the block's displacement relative to the ground, counted to the LEFT [m], and velocity [m/s]
    phi, phi_dot : φ, angle of hoop and lower cylinder, clockwise [rad], and angular velocity [rad/s]
    Phi, Phi_dot : Φ, angle of the top cylinder, clockwise [rad], and angular velocity [rad/s]

    Raises
    ------
    ValueError : a field is not a finite number; the message names it.

    >>> InitialState(phi=0.4).phi_dot
    0.0
    """

    X: float = 0.0
    phi: float = 0.0
    Phi: float = 0.0
    X_dot: float = 0.0
    phi_dot: float = 0.0
    Phi_dot: float = 0.0

    def __post_init__(self) -> None:
        vars(self).update({name: real(name, value) for name, value in vars(self).items()})


def released(oscillator: Oscillator, compression: float) -> InitialState:
    """Return the state at release: at rest, with the spring compressed by x₀, so that φ₀ = x₀/(2R).

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; negative means a stretched spring

    Returns
    -------
    the initial state, in which only φ₀ differs from zero

    Raises
    ------
    ValueError : the compression is not a finite number, or φ₀ is too large for float64.

    Source: paper, section 1 (x = 2Rφ).

    >>> released(Oscillator(radius=0.25), 0.1).phi
    0.2
    """
    return with_initial_velocities(oscillator, compression)


def with_initial_velocities(
    oscillator: Oscillator, compression: float, glide: float = 0.0, spin: float = 0.0
) -> InitialState:
    """Return the state at a release with a push along each zero mode: φ₀ = x₀/(2R), Ẋ₀ = −glide, Φ̇₀ = spin.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; negative means a stretched spring
    glide : initial velocity of the whole machine, to the RIGHT [m/s]
    spin : additional initial angular velocity of the top cylinder, clockwise [rad/s]

    Returns
    -------
    the initial state

    Raises
    ------
    ValueError : a value is not a finite number, or φ₀ is too large for float64.

    Source: the null space of K, spanned by (1, 0, 0) and (0, 0, 1).

    >>> with_initial_velocities(Oscillator(radius=0.1), 0.08, glide=0.5, spin=2).X_dot
    -0.5
    """
    radius = instance("oscillator", oscillator, Oscillator).radius
    deformation, radius, _unit = over_one_denominator(real("compression", compression), radius)
    return InitialState(
        phi=nearest("phi", deformation, 2 * radius), X_dot=-real("glide", glide), Phi_dot=real("spin", spin)
    )


def motion(
    oscillator: Oscillator, initial: InitialState, t: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the exact state (q, q̇) at the times t, in the order X, φ, Φ.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0
    t : time [s], scalar or array of any shape, either sign

    Returns
    -------
    q, q_dot : (X, φ, Φ) [m, rad, rad] and its time derivative, each of shape (3, …t)

    Raises
    ------
    ValueError : a time is not a finite number, or farther away than `FARTHEST` periods; or a part of the state is too
        large for float64.

    Source: module docstring; the equations (11) of the paper, integrated with both conserved momenta.

    >>> machine = Oscillator(radius=0.1)
    >>> q, q_dot = motion(machine, released(machine, 0.08), [0, machine.period])
    >>> q.shape
    (3, 2)
    >>> q[1].round(12)
    array([0.4, 0.4])
    """
    instance("oscillator", oscillator, Oscillator)
    instance("initial", initial, InitialState)
    # A single time stays a Python float, whose arithmetic takes a tenth of the time of an array's.
    times = real("t", t) if isinstance(t, float) else finite_array("t", t)
    start, rate, unit = over_one_denominator(initial.phi, initial.phi_dot)
    omega_squared, one = oscillator.frequency_ratio
    kappa, whole = oscillator.coupling_ratio
    R, length = oscillator.radius.as_integer_ratio()

    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        cosine, C, S = _oscillation(oscillator, times)

        def follows(shape: int, divisor: int, position: float, velocity: float) -> tuple[Values, Values]:
            """Return X or Φ and its rate: a drift, and shape/divisor times φ − φ₀ = φ̇₀ S − φ₀ C."""
            moved, pushed_on, divisor = shape * start, shape * rate, divisor * unit
            own, own_unit = velocity.as_integer_ratio()
            swing = scaled(pushed_on, divisor, S) - scaled(moved, divisor, C)
            slower = scaled(pushed_on, divisor, C) + scaled(moved * omega_squared, divisor * one, S)
            drift = scaled(own * divisor - pushed_on * own_unit, own_unit * divisor, times)
            return position + drift + swing, velocity - slower

        phi = initial.phi * cosine + initial.phi_dot * S
        phi_dot = initial.phi_dot * cosine - scaled(start * omega_squared, unit * one, S)
        X, X_dot = follows(kappa * R, whole * length, initial.X, initial.X_dot)
        Phi, Phi_dot = follows(2 * kappa, 3 * whole, initial.Phi, initial.Phi_dot)
        state = np.array([X, phi, Phi, X_dot, phi_dot, Phi_dot])
    if not np.isfinite(state).all():
        for name, values in zip(vars(initial), state, strict=True):
            in_range(name, values)
    return state[:3], state[3:]


def relative_positions(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return how far each body has moved relative to the block [m], right positive: Rφ, Rφ, 2Rφ and RΦ.

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t); the displacements count from q = 0, where the spring is not deformed

    Returns
    -------
    dict with the keys hoop, cylinder, slab and top, each of shape (…t); the slab's entry is the deformation of the
    spring

    Raises
    ------
    ValueError : q does not have three rows of finite numbers, or a position is too large for float64.

    Source: the rolling constraints, paper section 2.

    >>> float(relative_positions(Oscillator(radius=0.1), [0, 0.5, 0])["slab"])
    0.1
    """
    return _over_block(oscillator, coordinates("q", q), _("position of the {body}"))


def relative_velocities(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return each body's velocity relative to the block [m/s], right positive: Rφ̇, Rφ̇, 2Rφ̇ and RΦ̇.

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns
    -------
    dict with the keys of `relative_positions`, each of shape (…t)

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers, or a velocity is too large for float64.

    >>> float(relative_velocities(Oscillator(radius=0.1), [0, 0, 5])["top"])
    0.5
    """
    return _over_block(oscillator, coordinates("q_dot", q_dot), _("velocity of the {body}"))


def ground_positions(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return how far each body has moved relative to the ground [m], right positive.

        block −X,   hoop and cylinder Rφ − X,   slab 2Rφ − X,   top RΦ − X

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t); the displacements count from q = 0, where the spring is not deformed

    Returns
    -------
    dict with the keys block, hoop, cylinder, slab and top, each of shape (…t)

    Raises
    ------
    ValueError : q does not have three rows of finite numbers, or a position is too large for float64.

    Source: the rolling constraints, paper section 2; X counts to the left.

    >>> float(ground_positions(Oscillator(radius=0.1), [0.25, 0, 0])["block"])
    -0.25
    """
    return _over_ground(oscillator, coordinates("q", q), _("position of the {body}"))


def ground_velocities(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return each body's velocity relative to the ground [m/s], right positive.

        block −Ẋ,   hoop and cylinder Rφ̇ − Ẋ,   slab 2Rφ̇ − Ẋ,   top RΦ̇ − Ẋ

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns
    -------
    dict with the keys of `ground_positions`, each of shape (…t)

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers, or a velocity is too large for float64.

    >>> float(ground_velocities(Oscillator(radius=0.1), [0.25, 0, 5])["top"])
    0.25
    """
    return _over_ground(oscillator, coordinates("q_dot", q_dot), _("velocity of the {body}"))


def _over_block(oscillator: Oscillator, q: NDArray[np.float64], what: str) -> dict[str, NDArray[np.float64]]:
    """Map (X, φ, Φ), or its time derivative, to the four bodies' motion relative to the block."""
    R = instance("oscillator", oscillator, Oscillator).radius
    _X, phi, Phi = q
    with np.errstate(over="ignore"):
        relative = {"hoop": R * phi, "cylinder": R * phi, "slab": 2 * (R * phi), "top": R * Phi}
    return {body: in_range(what.format(body=body), values) for body, values in relative.items()}


def _over_ground(oscillator: Oscillator, q: NDArray[np.float64], what: str) -> dict[str, NDArray[np.float64]]:
    """Map (X, φ, Φ), or its time derivative, to the five bodies' motion relative to the ground."""
    over_block = _over_block(oscillator, q, what)
    with np.errstate(over="ignore"):
        return {"block": -q[0]} | {
            body: in_range(what.format(body=body), relative - q[0]) for body, relative in over_block.items()
        }


def _oscillation(oscillator: Oscillator, times: Values) -> tuple[Values, Values, Values]:
    """Return cos Ωt, 1 − cos Ωt and (sin Ωt)/Ω from the phase reduced in turns (Dekker's exact product)."""
    omega, (high, low, exponent) = oscillator.natural_frequency, oscillator.frequency_in_turns
    single = isinstance(times, float)
    module, rint = (math, round) if single else (np, np.rint)
    if (abs(times) if single else np.abs(times).max(initial=0.0)) > FARTHEST * (2 * math.pi / omega):
        sentence = _("t must not exceed {most} periods: beyond that the phase is not known")
        raise ValueError(sentence.format(most=number(FARTHEST)))
    scaled_times = module.ldexp(times, exponent)
    turns = high * scaled_times
    error = product_error(high, scaled_times, turns) + low * scaled_times
    angle = 2 * math.pi * ((turns - rint(turns)) + error)
    sine_over_omega = module.sin(angle) / omega
    # Where (sin Ωt)/Ω is t to the last digit, the sine itself may be too small for float64.
    short = abs(turns) < SHORT
    S = (times if short else sine_over_omega) if single else np.where(short, times, sine_over_omega)
    return module.cos(angle), 2 * module.sin(angle / 2) ** 2, S
