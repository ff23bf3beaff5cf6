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
from dataclasses import dataclass, fields
from fractions import Fraction
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.numerals import number
from ramanujan.oscillator import TWO_PI, Oscillator
from ramanujan.rounding import in_range, nearest, product_error, scaled, square_root
from ramanujan.translation import _
from ramanujan.validation import coordinates, finite_array, instance, real

FARTHEST = 1e18
"""Periods up to which the phase is right to 1e-12 rad: Ω/2π is known to two doubles, 106 bits."""


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
        for field in fields(self):
            object.__setattr__(self, field.name, real(field.name, getattr(self, field.name)))


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
    return pushed(oscillator, compression)


def pushed(oscillator: Oscillator, compression: float, glide: float = 0.0, spin: float = 0.0) -> InitialState:
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

    >>> pushed(Oscillator(radius=0.1), 0.08, glide=0.5, spin=2).X_dot
    -0.5
    """
    radius = instance("oscillator", oscillator, Oscillator).exact[3]
    angle = Fraction(real("compression", compression)) / (2 * radius)
    return InitialState(phi=nearest("phi", angle), X_dot=-real("glide", glide), Phi_dot=real("spin", spin))


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
    times = finite_array("t", t)
    cosine, C, S = _oscillation(oscillator, times)
    omega_squared = oscillator.exact_frequency_squared
    kappa, R = oscillator.exact_block_coupling, oscillator.exact[3]
    start, rate = Fraction(initial.phi), Fraction(initial.phi_dot)

    def follows(name: str, shape: Fraction, position: float, velocity: float) -> tuple[NDArray, NDArray]:
        """Return X or Φ and its rate: a drift, and `shape` times φ − φ₀ = φ̇₀ S − φ₀ C."""
        moved, pushed_on = shape * start, shape * rate
        swing = scaled(pushed_on, S) - scaled(moved, C)
        slower = scaled(pushed_on, C) + scaled(moved * omega_squared, S)
        drift = scaled(Fraction(velocity) - pushed_on, times)
        return in_range(name, position + drift + swing), in_range(f"{name}_dot", velocity - slower)

    with np.errstate(over="ignore", invalid="ignore"):
        phi = in_range("phi", initial.phi * cosine + scaled(rate, S))
        phi_dot = in_range("phi_dot", initial.phi_dot * cosine - scaled(start * omega_squared, S))
        X, X_dot = follows("X", kappa * R, initial.X, initial.X_dot)
        Phi, Phi_dot = follows("Phi", kappa * 2 / 3, initial.Phi, initial.Phi_dot)
    return np.stack([X, phi, Phi]), np.stack([X_dot, phi_dot, Phi_dot])


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


def _oscillation(
    oscillator: Oscillator, times: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return cos Ωt, 1 − cos Ωt and (sin Ωt)/Ω from the phase reduced in turns (Dekker's exact product)."""
    high, low, exponent = _frequency_in_turns(oscillator)
    with np.errstate(over="ignore", under="ignore"):
        scaled = np.ldexp(times, exponent)
        if np.any(np.abs(scaled) > FARTHEST / high):
            sentence = _("t must not exceed {most} periods: beyond that the phase is not known")
            raise ValueError(sentence.format(most=number(FARTHEST)))
        turns = high * scaled
        whole = np.rint(turns)
        fraction = (turns - whole) + (product_error(high, scaled, turns) + low * scaled)
        angle = 2 * math.pi * fraction
        # In the first half turn the sine may be too small for float64 although t is not.
        first = times * np.sinc(2 * fraction)
        sine_over_omega = np.where(whole == 0, first, np.sin(angle) / oscillator.natural_frequency)
        return np.cos(angle), 2 * np.sin(angle / 2) ** 2, sine_over_omega


@lru_cache(maxsize=256)
def _frequency_in_turns(oscillator: Oscillator) -> tuple[float, float, int]:
    """Return Ω/2π [1/s] as (high + low)·2^exponent, the sum of two doubles that are far from the ends of the range."""
    frequency = square_root(oscillator.exact_frequency_squared) / TWO_PI
    exponent = frequency.numerator.bit_length() - frequency.denominator.bit_length()
    scaled = frequency / Fraction(2) ** exponent
    high = float(scaled)
    return high, float(scaled - Fraction(high)), exponent
