"""Energies and momenta of a state: where the energy sits at an instant, and what the motion conserves.

Lives here: functions of a state (q, q̇), whatever produced it, the closed form or an integrator.
Does not live here: time and velocities (`motion`), forces (`contact`).

    E   = Σ ½ m v² + Σ ½ I ω² + ½k (2Rφ)²      I = m′R² (hoop), ½m′R² (lower cylinder), ½mR² (top cylinder)
    p_X = (3m + 2m′) Ẋ − 2(m + m′) Rφ̇ − mRΦ̇
    p_Φ = (3/2) mR² Φ̇ − mRẊ

Neither X nor Φ enters the Lagrangian, so E, p_X and p_Φ are constant.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ramanujan.motion import ground_velocities, relative_positions, relative_velocities
from ramanujan.oscillator import Oscillator


def energies(oscillator: Oscillator, q: Any, q_dot: Any) -> dict[str, np.ndarray]:
    """Return the energy [J] of each body by kind: ½mv² over the ground, ½Iω², and the spring's ½k(2Rφ)².

    Parameters
    ----------
    oscillator : the machine
    q, q_dot : (X, φ, Φ) and its time derivative, each of shape (3, …t)

    Returns a dict with the keys block_translation, hoop_translation, hoop_rotation, cylinder_translation,
    cylinder_rotation, slab_translation, top_translation, top_rotation and spring, each of shape (…t).

    Raises
    ------
    ValueError : q or q_dot does not have three rows of finite numbers.

    Source: paper, section 2, the terms of the Lagrangian.
    """
    m, m_prime = oscillator.m, oscillator.m_prime
    deformation = relative_positions(oscillator, q)["slab"]
    velocity = ground_velocities(oscillator, q_dot)
    # A rolling body's rim moves at Rω about its axis: its velocity over the block.
    rim = relative_velocities(oscillator, q_dot)
    return {
        "block_translation": m * velocity["block"] ** 2 / 2,
        "hoop_translation": m_prime * velocity["hoop"] ** 2 / 2,
        "hoop_rotation": m_prime * rim["hoop"] ** 2 / 2,
        "cylinder_translation": m_prime * velocity["cylinder"] ** 2 / 2,
        "cylinder_rotation": m_prime * rim["cylinder"] ** 2 / 4,
        "slab_translation": m * velocity["slab"] ** 2 / 2,
        "top_translation": m * velocity["top"] ** 2 / 2,
        "top_rotation": m * rim["top"] ** 2 / 4,
        "spring": oscillator.k * deformation**2 / 2,
    }


def total_energy(oscillator: Oscillator, q: Any, q_dot: Any) -> np.ndarray:
    """Return E = ½ q̇ᵀMq̇ + ½ qᵀKq [J], the sum of all `energies`, of shape (…t).

    Parameters and errors are those of `energies`. Released at rest, E = ½kx₀².
    """
    return sum(energies(oscillator, q, q_dot).values())


def momenta(oscillator: Oscillator, q_dot: Any) -> dict[str, np.ndarray]:
    """Return the two conserved momenta: p_X = ∂L/∂Ẋ [kg·m/s] and p_Φ = ∂L/∂Φ̇ [kg·m²/s].

        p_X = −Σ m v            the whole machine's linear momentum, to the left as X counts
        p_Φ = R (mv + ½mRΦ̇)     the top cylinder's angular momentum about its line of contact, v its velocity

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns a dict with the keys p_X and p_Phi, each of shape (…t).

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers.

    Source: paper, eq. of motion for the cyclic coordinates X and Φ.
    """
    m, m_prime = oscillator.m, oscillator.m_prime
    velocity = ground_velocities(oscillator, q_dot)
    rim = relative_velocities(oscillator, q_dot)
    to_the_right = m * (velocity["block"] + velocity["slab"] + velocity["top"])
    to_the_right = to_the_right + m_prime * (velocity["hoop"] + velocity["cylinder"])
    return {"p_X": -to_the_right, "p_Phi": m * oscillator.radius * (velocity["top"] + rim["top"] / 2)}
