"""Energies and momenta of a state: the energy of each body, and the two momenta that the motion conserves.

Each is a function of a state (q, q̇), whether it comes from the closed form or from an integrator.

    E   = Σ ½mv² + Σ ½Iω² + ½k(2Rφ)²         the terms of eq. (1), with v relative to the ground
    p   = M q̇ = ∂L/∂q̇                        p_X and p_Φ are constant, since neither X nor Φ enters L
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.motion import ground_velocities, relative_positions
from ramanujan.oscillator import Oscillator
from ramanujan.validation import coordinates


def energies(oscillator: Oscillator, q: ArrayLike, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the energy [J] of each body by kind: ½mv² relative to the ground, ½Iω², and the spring's ½k(2Rφ)².

    Parameters
    ----------
    oscillator : the machine
    q, q_dot : (X, φ, Φ) and its time derivative, each of shape (3, …t)

    Returns
    -------
    dict with the keys block_translation, hoop_translation, hoop_rotation, cylinder_translation, cylinder_rotation,
    slab_translation, top_translation, top_rotation and spring, each of shape (…t); their sum is E

    Raises
    ------
    ValueError : q or q_dot does not have three rows of finite numbers, or their shapes differ.

    Source: paper, eq. (1).

    >>> stored = energies(Oscillator(k=10, radius=0.1), [0, 0.4, 0], [0, 0, 0])
    >>> round(float(sum(stored.values())), 12)
    0.032
    """
    q, q_dot = coordinates("q", q), coordinates("q_dot", q_dot)
    if q.shape != q_dot.shape:
        raise ValueError(f"q_dot must have the shape of q, {q.shape}, not {q_dot.shape}")
    _X_dot, phi_dot, Phi_dot = q_dot
    velocity = ground_velocities(oscillator, q_dot)
    spin = {"hoop": phi_dot, "cylinder": phi_dot, "top": Phi_dot}
    energy = {}
    for body, mass in oscillator.masses.items():
        energy[f"{body}_translation"] = mass / 2 * velocity[body] ** 2
        if body in spin:
            energy[f"{body}_rotation"] = oscillator.moments_of_inertia[body] / 2 * spin[body] ** 2
    energy["spring"] = oscillator.k / 2 * relative_positions(oscillator, q)["slab"] ** 2
    return energy


def momenta(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the two conserved momenta: p_X = ∂L/∂Ẋ [kg·m/s] and p_Φ = ∂L/∂Φ̇ [kg·m²/s].

        p_X = (3m + 2m′)Ẋ − 2(m + m′)Rφ̇ − mRΦ̇      the linear momentum of the machine, to the left as X counts
        p_Φ = (3/2)mR²Φ̇ − mRẊ                       the angular momentum of the top cylinder about its contact

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns
    -------
    dict with the keys p_X and p_Phi, each of shape (…t)

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eqs. (10a) and (10b), whose left sides are dp_X/dt and dp_Φ/dt.

    >>> float(momenta(Oscillator(m=1, m_prime=1), [1, 0, 0])["p_X"])
    5.0
    """
    p_X, _p_phi, p_Phi = np.tensordot(oscillator.mass_matrix, coordinates("q_dot", q_dot), axes=1)
    return {"p_X": p_X, "p_Phi": p_Phi}


def body_momenta(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return each body's linear momentum mv relative to the ground [kg·m/s], right positive.

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns
    -------
    dict with the keys block, hoop, cylinder, slab and top, each of shape (…t)

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eq. (1): the velocities in it.

    >>> float(body_momenta(Oscillator(m=2), [1, 0, 0])["block"])
    -2.0
    """
    velocity = ground_velocities(oscillator, q_dot)
    return {body: mass * velocity[body] for body, mass in oscillator.masses.items()}
