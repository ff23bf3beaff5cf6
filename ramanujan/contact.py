"""The five rolling contacts: the forces in them, the friction they need, and the motion at which one slips.

Lives here: contact, normal and spring forces along a motion that rolls, and the limit of that assumption.
Does not live here: what happens after a slip; the machine of this package always rolls.

Newton's law for the five bodies, the three torques and the five rolling constraints give, with a = Rφ̈ = −Ω²Rφ, the
forces ON a lower roller of moment of inertia βm′R² (hoop β = 1, cylinder β = ½), right positive,

    from the slab   ½m′a (1 + β − κ)          from the block   ½m′a (1 − β − κ)

on the top cylinder −κma/3, and from the spring on the slab −2kRφ. The slab is thin, its centre of mass midway
between the rollers' axes at φ = 0. It moves twice as far as they do, so its weight shifts onto the roller it moves to:

    N_hoop = mg (½ − Rφ/L),   N_cylinder = mg (½ + Rφ/L)        L: spacing of the axes, which exceeds 2R

The block carries each lower roller's weight m′g besides, and the top cylinder's mg.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ramanujan.motion import InitialState, motion
from ramanujan.oscillator import Oscillator, real_number


def contact_forces(oscillator: Oscillator, initial: InitialState, t: Any) -> dict[str, np.ndarray]:
    """Return the horizontal force [N], right positive, at every contact and in the spring at the times t.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0
    t : time [s], scalar or array of any shape

    Returns a dict of arrays of shape (…t): hoop_slab, cylinder_slab, hoop_block, cylinder_block and top_block are the
    forces ON the roller, spring is the force on the slab. The other body of each pair feels the opposite.

    Raises
    ------
    ValueError : a time is not a finite number.

    Source: Newton's equations with the rolling constraints, as in the module docstring.
    """
    travel = _roller_travel(oscillator, initial, t)
    acceleration = -oscillator.natural_frequency_squared * travel
    forces = {name: oscillator.m * share * acceleration for name, share in _force_shares(oscillator).items()}
    return forces | {"spring": -2 * oscillator.k * travel}


def normal_forces(
    oscillator: Oscillator, initial: InitialState, t: Any, g: float = 9.81, spacing: float = math.inf
) -> dict[str, np.ndarray]:
    """Return the normal force [N] at the five contacts at the times t: the load shifts as the slab moves.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0
    t : time [s], scalar or array of any shape
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; infinite means that no load shifts

    Returns a dict of arrays of shape (…t) with the keys of `required_friction`.

    Raises
    ------
    ValueError : g or spacing is not positive, or the slab tips off its rollers at some time in this motion.

    Source: balance of moments of a thin slab, module docstring.
    """
    weight = oscillator.m * _finite_positive("g", g)
    distance = _spacing_beyond(2 * travel_amplitude(oscillator, initial), spacing)
    shift = _roller_travel(oscillator, initial, t) / distance
    loads = _loads(oscillator, 0.5 - shift, 0.5 + shift)
    return {name: weight * np.broadcast_to(load, shift.shape) for name, load in loads.items()}


def friction_demand(
    oscillator: Oscillator, initial: InitialState, t: Any, g: float = 9.81, spacing: float = math.inf
) -> dict[str, np.ndarray]:
    """Return |horizontal force|/normal force at the five contacts at the times t: a contact rolls while it is ≤ μ.

    Parameters, keys and errors are those of `normal_forces`; the values are dimensionless.
    """
    normals = normal_forces(oscillator, initial, t, g, spacing)
    forces = contact_forces(oscillator, initial, t)
    return {name: np.abs(forces[name]) / normal for name, normal in normals.items()}


def travel_amplitude(oscillator: Oscillator, initial: InitialState) -> float:
    """Return A = R √(φ₀² + (φ̇₀/Ω)²) [m], how far the lower rollers move over the block to either side.

    Every contact force depends on the initial state through A alone: the friction that a motion needs in the long run
    is that after a release with the compression 2A.
    """
    return oscillator.radius * math.hypot(initial.phi, initial.phi_dot / oscillator.natural_frequency)


def required_friction(
    oscillator: Oscillator, compression: float, g: float = 9.81, spacing: float = math.inf
) -> dict[str, float]:
    """Return the least coefficient of static friction with which each contact rolls after a release from rest.

        hoop_slab        16ε(3ε+4)/D · u/(1 − 2A/L)         hoop_block       24ε(1+ε)/D · u/(½ − A/L + ε)
        cylinder_slab    12ε(2ε+3)/D · u/(1 − 2A/L)         cylinder_block    2ε(6ε+5)/D · u/(½ − A/L + ε)
        top_block        16(1+ε)/D · u

    with D = 18ε² + 49ε + 32, A = |x₀|/2 and u = kA/(mg). Each force is largest at both ends of the swing, and the load
    on each roller smallest at one of them: the hoop's at φ = A/R, the cylinder's at φ = −A/R.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀, the spring's compression at release [m]; negative means a stretched spring
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; infinite means that no load shifts

    Returns a dict with the keys hoop_slab, cylinder_slab, hoop_block, cylinder_block and top_block, dimensionless.

    Raises
    ------
    ValueError : compression is not finite, g or spacing is not positive, or spacing does not exceed |compression|,
        so that the slab would tip off its rollers.

    Source: module docstring; the largest value of `friction_demand` over one period.
    """
    demands = _demand_per_pull(oscillator, compression, spacing)
    pull = oscillator.natural_frequency_squared * (abs(float(compression)) / 2 / _finite_positive("g", g))
    return {name: demand * pull for name, demand in demands.items()}


def first_to_slip(oscillator: Oscillator, compression: float = 0.0, spacing: float = math.inf) -> str:
    """Return the contact that needs the most friction after a release from rest, and so slips first.

    It is always top_block or hoop_slab. For L → ∞ it is top_block if ε < (√21 − 3)/6 ≈ 0.2638, else hoop_slab; the load
    that shifts for finite L makes hoop_slab come first already at a smaller ε.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; 0 stands for the limit of a small one. It matters only if spacing is finite.
    spacing : L, distance between the axes of hoop and lower cylinder [m]

    Returns a key of `required_friction`.

    Raises
    ------
    ValueError : compression is not finite, spacing is not positive or does not exceed |compression|.

    Source: the largest entry of `required_friction`, in which g is a common factor.
    """
    demands = _demand_per_pull(oscillator, compression, spacing)
    return max(demands, key=demands.__getitem__)


def largest_compression(
    oscillator: Oscillator, friction_coefficient: float, g: float = 9.81, spacing: float = math.inf
) -> float:
    """Return the largest compression x₀ [m] from which the machine can be released without slip at any contact.

    A contact whose force at the end of the swing is f·mΩ²A under the load mg(n − σA/L), with σ = 0 for the top
    cylinder and 1 else, slips beyond A = μn/(fΩ²/g + μσ/L); x₀ is twice the least of the five.

    Parameters
    ----------
    oscillator : the machine
    friction_coefficient : μ, coefficient of static friction, the same at all contacts, dimensionless
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; the result never exceeds it

    Raises
    ------
    ValueError : friction_coefficient, g or spacing is not positive, or only spacing may be infinite.

    Source: `required_friction`, solved for the compression.
    """
    mu = _finite_positive("friction_coefficient", friction_coefficient)
    gravity = _finite_positive("g", g)
    distance = _spacing_beyond(0.0, spacing)
    loads = _loads(oscillator, 0.5, 0.5)
    amplitudes = []
    for name, share in _force_shares(oscillator).items():
        load_lost = 0.0 if name == "top_block" else mu / distance
        force_grown = abs(share) * oscillator.natural_frequency_squared / gravity
        amplitudes.append(mu * loads[name] / (force_grown + load_lost))
    return 2 * min(amplitudes)


def _force_shares(oscillator: Oscillator) -> dict[str, float]:
    """Return each contact's force on its roller divided by m·Rφ̈, dimensionless."""
    kappa = oscillator.block_coupling
    half = oscillator.mass_ratio / 2
    hoop, cylinder = 1.0, 0.5
    return {
        "hoop_slab": half * (1 + hoop - kappa),
        "cylinder_slab": half * (1 + cylinder - kappa),
        "hoop_block": half * (1 - hoop - kappa),
        "cylinder_block": half * (1 - cylinder - kappa),
        "top_block": -kappa / 3,
    }


def _loads(oscillator: Oscillator, on_hoop: Any, on_cylinder: Any) -> dict[str, Any]:
    """Return each contact's normal force divided by mg, from the fractions of the slab's weight on the two rollers."""
    roller = oscillator.mass_ratio
    return {
        "hoop_slab": on_hoop,
        "cylinder_slab": on_cylinder,
        "hoop_block": on_hoop + roller,
        "cylinder_block": on_cylinder + roller,
        "top_block": 1.0,
    }


def _demand_per_pull(oscillator: Oscillator, compression: float, spacing: float) -> dict[str, float]:
    """Return the friction required divided by Ω²A/g: each contact at its own worst instant."""
    deformation = abs(real_number(compression))
    if not math.isfinite(deformation):
        raise ValueError(f"compression must be a finite number, not {compression!r:.60}")
    distance = _spacing_beyond(deformation, spacing)
    # The difference first: near tipping it is exact, while 1 − x₀/L would lose its digits.
    least = 0.5 if math.isinf(distance) else (distance - deformation) / distance / 2
    loads = _loads(oscillator, least, least)
    return {name: abs(share) / loads[name] for name, share in _force_shares(oscillator).items()}


def _roller_travel(oscillator: Oscillator, initial: InitialState, t: Any) -> np.ndarray:
    """Return Rφ(t) [m], the lower rollers' displacement over the block, right positive."""
    q, _ = motion(oscillator, initial, t)
    return oscillator.radius * q[1]


def _spacing_beyond(compression: float, spacing: float) -> float:
    """Return spacing as a float, or raise ValueError unless both rollers carry the slab at that compression, x₀ < L."""
    distance = real_number(spacing)
    if not distance > 0:
        raise ValueError(f"spacing must be a positive number or infinity, not {spacing!r:.60}")
    if not distance > compression:
        raise ValueError(
            f"spacing must exceed the largest compression of the spring, {compression:.6g} m, "
            f"or the slab tips off its rollers; it is {distance:.6g} m"
        )
    return distance


def _finite_positive(name: str, value: Any) -> float:
    """Return value as a float, or raise ValueError naming it unless it is a finite positive number."""
    number = real_number(value)
    if not 0 < number < math.inf:
        raise ValueError(f"{name} must be a finite positive number, not {value!r:.60}")
    return number
