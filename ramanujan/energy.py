"""Energies and momenta of a state: how the energy is distributed at one moment, and what the motion conserves.

Each is a function of a state (q, q̇), whether it comes from the closed form or from an integrator.

    E   = Σ ½ m v² + Σ ½ I ω² + ½k (2Rφ)²      I = m′R² (hoop), ½m′R² (lower cylinder), ½mR² (top cylinder)
    p_X = (3m + 2m′) Ẋ − 2(m + m′) Rφ̇ − mRΦ̇
    p_Φ = (3/2) mR² Φ̇ − mRẊ

Neither X nor Φ enters the Lagrangian, so E, p_X and p_Φ are constant.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.motion import ground_velocities, relative_positions, relative_velocities
from ramanujan.oscillator import Oscillator
from ramanujan.rounding import in_range, product
from ramanujan.translation import _
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
    ValueError : q or q_dot does not have three rows of finite numbers, their shapes differ, or an energy is too large
        for float64.

    Source: paper, section 2, the terms of the Lagrangian.

    >>> stored = energies(Oscillator(k=10, radius=0.1), [0, 0.4, 0], [0, 0, 0])
    >>> round(float(sum(stored.values())), 12)
    0.032
    """
    q, q_dot = coordinates("q", q), coordinates("q_dot", q_dot)
    if q.shape != q_dot.shape:
        sentence = _("q_dot must have the shape of q, {shape}, not {other}")
        raise ValueError(sentence.format(shape=q.shape, other=q_dot.shape))
    deformation = relative_positions(oscillator, q)["slab"]
    velocity = ground_velocities(oscillator, q_dot)
    # Rω, the speed of a rolling body's rim about its axis, is its velocity relative to the block.
    rim = relative_velocities(oscillator, q_dot)
    m, m_prime = oscillator.m, oscillator.m_prime
    hoop, solid = 1 / 2, 1 / 4  # half the shape factor β, since ½Iω² = ½βm(Rω)²
    terms = {
        "block_translation": (0.5, m, velocity["block"]),
        "hoop_translation": (0.5, m_prime, velocity["hoop"]),
        "hoop_rotation": (hoop, m_prime, rim["hoop"]),
        "cylinder_translation": (0.5, m_prime, velocity["cylinder"]),
        "cylinder_rotation": (solid, m_prime, rim["cylinder"]),
        "slab_translation": (0.5, m, velocity["slab"]),
        "top_translation": (0.5, m, velocity["top"]),
        "top_rotation": (solid, m, rim["top"]),
        "spring": (0.5, oscillator.k, deformation),
    }
    # TRANSLATORS: in an error such as: energy block_translation is too large for float64.
    label = _("energy {name}")
    return {
        name: product(label.format(name=name), factor, constant, x, x) for name, (factor, constant, x) in terms.items()
    }


def momenta(oscillator: Oscillator, q_dot: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the two conserved momenta: p_X = ∂L/∂Ẋ [kg·m/s] and p_Φ = ∂L/∂Φ̇ [kg·m²/s].

        p_X = −Σ m v            the whole machine's linear momentum, to the left as X counts
        p_Φ = R (mv + ½mRΦ̇)     the top cylinder's angular momentum about its line of contact, v its velocity

    Parameters
    ----------
    oscillator : the machine
    q_dot : (Ẋ, φ̇, Φ̇), shape (3, …t)

    Returns
    -------
    dict with the keys p_X and p_Phi, each of shape (…t)

    Raises
    ------
    ValueError : q_dot does not have three rows of finite numbers, or a momentum is too large for float64.

    Source: paper, eq. of motion for the cyclic coordinates X and Φ.

    >>> float(momenta(Oscillator(m=1, m_prime=1), [1, 0, 0])["p_X"])
    5.0
    """
    bodies = body_momenta(oscillator, q_dot)
    R = oscillator.radius
    rim = relative_velocities(oscillator, q_dot)["top"]
    with np.errstate(over="ignore"):
        p_X = in_range("p_X", -sum(bodies.values()))
        p_Phi = in_range("p_Phi", R * bodies["top"] + product("p_Phi", 0.5, oscillator.m, R, rim))
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
    ValueError : q_dot does not have three rows of finite numbers, or a momentum is too large for float64.

    >>> float(body_momenta(Oscillator(m=2), [1, 0, 0])["block"])
    -2.0
    """
    velocity = ground_velocities(oscillator, q_dot)
    rollers = dict.fromkeys(("hoop", "cylinder"), oscillator.m_prime)
    # TRANSLATORS: in an error; {body} is an English name from the program: block, hoop, cylinder, slab, top.
    label = _("momentum of the {body}")
    return {body: product(label.format(body=body), rollers.get(body, oscillator.m), v) for body, v in velocity.items()}
