"""The motion in closed form: initial states, the state at any time, and the displacement and velocity of each body.

Eq. (12) of the paper, φ̈ = −Ω²φ, gives φ(t). Eqs. (11), Ẍ = κRφ̈ and Φ̈ = λφ̈, then give X(t) and Φ(t) by integrating
twice. Each of them is a uniform drift plus a multiple of the oscillation of φ:

    S(t) = (sin Ωt)/Ω
    C(t) = 1 − cos Ωt = 2 sin²(Ωt/2)
    s(t) = φ̇₀S(t) − φ₀C(t)                       change of φ since t = 0

    φ(t) = φ₀ + s(t)
    X(t) = X₀ + (Ẋ₀ − κRφ̇₀)t + κR s(t)
    Φ(t) = Φ₀ + (Φ̇₀ − λφ̇₀)t + λ s(t)

The form 2 sin²(Ωt/2) avoids the cancellation in 1 − cos Ωt for small Ωt. The phase Ωt inherits the relative error of Ω,
about 10⁻¹⁶, so its error after n periods is about 10⁻¹⁵n rad.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.physics.oscillator import Oscillator
from ramanujan.physics.validation import coordinates, finite, float_array


@dataclass(frozen=True)
class InitialState:
    """The state at t = 0: q = (X, φ, Φ) and its time derivative.

    Parameters
    ----------
    X, X_dot : the block's displacement relative to the ground, counted to the LEFT [m], and velocity [m/s]
    phi, phi_dot : φ, angle of hoop and lower cylinder, clockwise [rad], and angular velocity [rad/s]
    Phi, Phi_dot : Φ, angle of the top cylinder, clockwise [rad], and angular velocity [rad/s]

    Raises
    ------
    ValueError : a field is not a finite number. The message begins with its name.

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
        fields = vars(self)
        for name, value in fields.items():
            fields[name] = finite(name, value)


def released(oscillator: Oscillator, compression: float) -> InitialState:
    """Return the initial state of a release from rest with the spring compressed by x₀ = 2Rφ₀.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; negative means a stretched spring

    Returns
    -------
    the initial state; only φ₀ = x₀/(2R) is not zero

    Raises
    ------
    ValueError : the compression is not a finite number.

    Source: paper, section 1, x = 2Rφ.

    >>> released(Oscillator(radius=0.25), 0.1).phi
    0.2
    """
    return with_initial_velocities(oscillator, compression)


def with_initial_velocities(
    oscillator: Oscillator, compression: float, glide: float = 0.0, spin: float = 0.0
) -> InitialState:
    """Return the initial state of a release with a push: φ₀ = x₀/(2R), Ẋ₀ = −glide and Φ̇₀ = spin.

    The sign is negative because X counts to the left.

    `glide` excites the zero mode q = (1, 0, 0), a translation of the whole machine. `spin` excites the zero mode
    q = (0, 0, 1), a rotation of the top cylinder as it rolls over the block. The oscillation φ(t) depends on neither.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; negative means a stretched spring
    glide : initial velocity of block, lower rollers and slab, to the RIGHT [m/s]
    spin : initial angular velocity of the top cylinder, clockwise [rad/s]

    Returns
    -------
    the initial state

    Raises
    ------
    ValueError : a value is not a finite number, or x₀/(2R) exceeds the largest float.

    Source: the null space of K, spanned by (1, 0, 0) and (0, 0, 1).

    >>> with_initial_velocities(Oscillator(radius=0.1), 0.08, glide=0.5, spin=2).X_dot
    -0.5
    """
    phi = finite("compression", compression) / (2 * oscillator.radius)
    if not math.isfinite(phi):
        raise ValueError(f"compression is too large for a radius of {oscillator.radius} m: {compression}")
    return InitialState(phi=phi, X_dot=-finite("glide", glide), Phi_dot=finite("spin", spin))


def motion(
    oscillator: Oscillator, initial: InitialState, t: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the state (q, q̇) at the times t from the closed form in the module docstring.

    The error is at most 10⁻¹¹ of the amplitude for up to 1,000 periods, and 10⁻⁸ for up to a million periods. The
    rounding of the initial value and of the drift adds at most 10⁻¹⁵ of each.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0
    t : time [s], a number or an array of any shape; it may be negative

    Returns
    -------
    q, q_dot : (X, φ, Φ) [m, rad, rad] and its time derivative, each of shape (3, *t.shape)

    Raises
    ------
    ValueError : a time is not a finite number, or Ωt exceeds the largest float.

    Source: paper, eqs. (11) and (12), integrated as in the module docstring.

    >>> machine = Oscillator(radius=0.1)
    >>> q, q_dot = motion(machine, released(machine, 0.08), [0, machine.period])
    >>> q.shape
    (3, 2)
    >>> q[1].round(12)
    array([0.4, 0.4])
    """
    # For a single time, Python floats and `math.sin` are several times faster than NumPy.
    times: float | NDArray[np.float64]
    if isinstance(t, float):
        times, sin = finite("t", t), math.sin
    else:
        times, sin = float_array("t", t).astype(np.float64, copy=False), np.sin
    Omega, Omega_squared = oscillator.natural_frequency, oscillator.natural_frequency_squared
    largest_time = abs(times) if isinstance(times, float) else float(np.abs(times).max(initial=0.0))
    if Omega * largest_time == math.inf:
        raise ValueError("t is too large: the phase Ωt exceeds the largest float")
    phase = Omega * times
    kappa_R, lambda_ = oscillator.block_coupling * oscillator.radius, oscillator.top_coupling
    X_0, phi_0, Phi_0 = initial.X, initial.phi, initial.Phi
    X_dot_0, phi_dot_0, Phi_dot_0 = initial.X_dot, initial.phi_dot, initial.Phi_dot

    S = sin(phase) / Omega
    C = 2 * sin(phase / 2) ** 2
    s = phi_dot_0 * S - phi_0 * C
    X = X_0 + (X_dot_0 - kappa_R * phi_dot_0) * times + kappa_R * s
    phi = phi_0 + s
    Phi = Phi_0 + (Phi_dot_0 - lambda_ * phi_dot_0) * times + lambda_ * s

    # φ̇ = ds/dt, with dS/dt = 1 − C and dC/dt = Ω²S. The constant φ̇₀ is added last.
    phi_dot_change = -phi_dot_0 * C - phi_0 * Omega_squared * S
    X_dot = X_dot_0 + kappa_R * phi_dot_change
    phi_dot = phi_dot_0 + phi_dot_change
    Phi_dot = Phi_dot_0 + lambda_ * phi_dot_change
    return np.array([X, phi, Phi]), np.array([X_dot, phi_dot, Phi_dot])


def relative_positions(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the displacement of each body relative to the block [m], right positive: Rφ, Rφ, 2Rφ and RΦ.

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …); displacements are measured from q = 0, where the spring is undeformed

    Returns
    -------
    dict with the keys hoop, cylinder, slab and top, each of shape q.shape[1:]; the displacement of the slab is also
    the compression of the spring

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: paper, section 1, rolling without slipping.

    >>> float(relative_positions(Oscillator(radius=0.1), [0, 0.5, 0])["slab"])
    0.1
    """
    return _relative_to_block(oscillator, coordinates("q", q))


def relative_velocities(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the velocity of each body relative to the block [m/s], right positive: Rφ̇, Rφ̇, 2Rφ̇ and RΦ̇.

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …)

    Returns
    -------
    dict with the keys of `relative_positions`, each of shape q_dot.shape[1:]

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, section 1, rolling without slipping.

    >>> float(relative_velocities(Oscillator(radius=0.1), [0, 0, 5])["top"])
    0.5
    """
    return _relative_to_block(oscillator, coordinates("q_dot", q_dot))


def ground_positions(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the displacement of each body relative to the ground [m], right positive.

        block −X,   hoop and cylinder Rφ − X,   slab 2Rφ − X,   top RΦ − X

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …); displacements are measured from q = 0, where the spring is undeformed

    Returns
    -------
    dict with the keys block, hoop, cylinder, slab and top, each of shape q.shape[1:]

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: paper, eq. (1): its velocities with q instead of q̇.

    >>> float(ground_positions(Oscillator(radius=0.1), [0.25, 0, 0])["block"])
    -0.25
    """
    return _relative_to_ground(oscillator, coordinates("q", q))


def ground_velocities(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the velocity of each body relative to the ground [m/s], right positive.

        block −Ẋ,   hoop and cylinder Rφ̇ − Ẋ,   slab 2Rφ̇ − Ẋ,   top RΦ̇ − Ẋ

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …)

    Returns
    -------
    dict with the keys of `ground_positions`, each of shape q_dot.shape[1:]

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eq. (1).

    >>> float(ground_velocities(Oscillator(radius=0.1), [0.25, 0, 5])["top"])
    0.25
    """
    return _relative_to_ground(oscillator, coordinates("q_dot", q_dot))


def _relative_to_block(oscillator: Oscillator, q: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return displacements relative to the block for q, or velocities for q̇.

    The slab moves with the highest point of the rollers, twice as far as their axes.
    """
    R = oscillator.radius
    _X, phi, Phi = q
    return {"hoop": R * phi, "cylinder": R * phi, "slab": 2 * R * phi, "top": R * Phi}


def _relative_to_ground(oscillator: Oscillator, q: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return displacements relative to the ground for q, or velocities for q̇. The block moves by −X, to the right."""
    X = q[0]
    relative_to_block = _relative_to_block(oscillator, q)
    return {"block": -X} | {body: relative - X for body, relative in relative_to_block.items()}
