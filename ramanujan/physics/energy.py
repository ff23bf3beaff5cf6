"""Energies and momenta of a state: energy and linear momentum of each body, and the two conserved momenta.

They are functions of a state (q, q̇), which may come from the closed form or from an integrator.

    E   = Σ ½mv² + Σ ½Iω² + ½k(2Rφ)²         the terms of eq. (1); velocities v relative to the ground
    p   = ∂L/∂q̇ = Mq̇ = (p_X, p_φ, p_Φ)       generalized momenta

X and Φ are cyclic coordinates: L depends on Ẋ and Φ̇ but not on X and Φ. Therefore p_X and p_Φ are conserved.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.physics.motion import ground_velocities, relative_positions
from ramanujan.physics.oscillator import Oscillator
from ramanujan.physics.validation import coordinates


def energies(oscillator: Oscillator, q: ArrayLike, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the terms of the energy [J]: ½mv² and ½Iω² of each body, and ½k(2Rφ)² of the spring.

    Parameters
    ----------
    oscillator : the machine
    q, q_dot : (X, φ, Φ) and its time derivative, each of shape (3, …)

    Returns
    -------
    dict with the keys block_translation, hoop_translation, hoop_rotation, cylinder_translation, cylinder_rotation,
    slab_translation, top_translation, top_rotation and spring, each of shape q.shape[1:]; their sum is the total
    energy E

    Raises
    ------
    ValueError : q or q_dot does not have three rows of finite numbers, or their shapes differ.

    Source: paper, eq. (1).

    >>> terms = energies(Oscillator(k=10, radius=0.1), [0, 0.4, 0], [0, 0, 0])
    >>> round(float(sum(terms.values())), 12)
    0.032
    """
    q, q_dot = coordinates("q", q), coordinates("q_dot", q_dot)
    if q.shape != q_dot.shape:
        raise ValueError(f"q_dot must have the shape of q, {q.shape}, not {q_dot.shape}")
    _X_dot, phi_dot, Phi_dot = q_dot
    velocity = ground_velocities(oscillator, q_dot)
    angular_velocity = {"hoop": phi_dot, "cylinder": phi_dot, "top": Phi_dot}
    terms = {}
    for body, mass in oscillator.masses.items():
        terms[f"{body}_translation"] = mass / 2 * velocity[body] ** 2
        if body in angular_velocity:
            terms[f"{body}_rotation"] = oscillator.moments_of_inertia[body] / 2 * angular_velocity[body] ** 2
    terms["spring"] = oscillator.k / 2 * relative_positions(oscillator, q)["slab"] ** 2
    return terms


def momenta(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the two conserved momenta: p_X = ∂L/∂Ẋ [kg·m/s] and p_Φ = ∂L/∂Φ̇ [kg·m²/s].

        p_X = (3m + 2m′)Ẋ − 2(m + m′)Rφ̇ − mRΦ̇      linear momentum of the machine, positive to the LEFT like X
        p_Φ = (3/2)mR²Φ̇ − mRẊ                       angular momentum of the top cylinder about its line of contact

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …)

    Returns
    -------
    dict with the keys p_X and p_Phi, each of shape q_dot.shape[1:]

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eq. (10a), dp_X/dt = 0, and eq. (10b), dp_Φ/dt = 0 divided by mR.

    >>> float(momenta(Oscillator(m=1, m_prime=1), [1, 0, 0])["p_X"])
    5.0
    """
    p_X, _p_phi, p_Phi = np.tensordot(oscillator.mass_matrix, coordinates("q_dot", q_dot), axes=1)
    return {"p_X": p_X, "p_Phi": p_Phi}


def body_momenta(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the linear momentum mv of each body, relative to the ground [kg·m/s], right positive.

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …)

    Returns
    -------
    dict with the keys block, hoop, cylinder, slab and top, each of shape q_dot.shape[1:]

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eq. (1): the velocities v.

    >>> float(body_momenta(Oscillator(m=2), [1, 0, 0])["block"])
    -2.0
    """
    velocity = ground_velocities(oscillator, q_dot)
    return {body: mass * velocity[body] for body, mass in oscillator.masses.items()}
