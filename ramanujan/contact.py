r"""The five rolling contacts: their forces, the friction that they need, and the compression at which one slips.

The forces are what holds the rolling constraints of the paper. They are right as long as every contact rolls without
slipping; the motion after a slip is not modelled.

                                                   ___
                                                  / | \      top cylinder, angle Φ
        ← −2kRφ                                   \_|_/
     [=========== slab ===========]/\/\/|       f →            f, F, T   forces ON a roller, right positive;
           T →           T →            |                                the other body feels the opposite
            ___           ___           |                      L         spacing of the axes, at least 2R
           / | \         / | \          |                      φ, Φ      count clockwise, X to the left
           \___/         \_|_/          |
           F →           F →            |
     ___________________________________|     block            X ←
             |←     L     →|

Newton's law for the five bodies, the three torques and the five rolling constraints give, with a = Rφ̈ = −Ω²Rφ, the
forces on a lower roller of moment of inertia βm′R² (hoop β = 1, cylinder β = ½)

    from the slab   T = ½m′a (1 + β − κ)          from the block   F = ½m′a (1 − β − κ)

The slab is thin, and at φ = 0 its centre of mass is midway between the rollers' axes. It moves twice as far as they
do, so its weight shifts towards the roller to which it moves:

    N_hoop = mg (½ − Rφ/L),   N_cylinder = mg (½ + Rφ/L)

The block also carries the weight m′g of each lower roller, and the weight mg of the top cylinder.
"""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.motion import InitialState
from ramanujan.oscillator import GRAVITY, Oscillator
from ramanujan.validation import coordinates, finite, positive

FloatOrArray = TypeVar("FloatOrArray", float, NDArray[np.float64])


def contact_forces(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the horizontal force [N], right positive, at every contact and in the spring.

        ½m′a(1 + β − κ) from the slab,   ½m′a(1 − β − κ) from the block,   −κma/3 on the top cylinder,   −2kRφ

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t), from the closed form or an integrator; only φ matters

    Returns
    -------
    dict of arrays of shape (…t): hoop_slab, cylinder_slab, hoop_block, cylinder_block and top_block are the forces ON
    the roller, spring is the force on the slab; the other body of each pair feels the opposite

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: Newton's equations with the rolling constraints, as in the module docstring.

    >>> forces = contact_forces(Oscillator(k=10, radius=0.1), [0, 0.4, 0])
    >>> round(float(forces["spring"]), 12)
    -0.8
    """
    R, phi = oscillator.radius, coordinates("q", q)[1]
    acceleration = -oscillator.natural_frequency_squared * R * phi
    forces = {name: share * oscillator.m * acceleration for name, share in _forces(oscillator).items()}
    return forces | {"spring": -2 * oscillator.k * R * phi}


def normal_forces(
    oscillator: Oscillator, q: ArrayLike, g: float = GRAVITY, spacing: float = math.inf
) -> dict[str, NDArray[np.float64]]:
    """Return the normal force [N] at the five contacts; the load shifts as the slab moves.

        mg(½ ∓ Rφ/L) between slab and roller,   m′g more between roller and block,   mg under the top cylinder

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …t), from the closed form or an integrator; only φ matters
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; infinite means that no load shifts

    Returns
    -------
    dict of arrays of shape (…t) with the keys of `required_friction`

    Raises
    ------
    ValueError : q does not have three rows of finite numbers, g is not positive, spacing is less than 2R, or the slab
        tips off its rollers in one of the states.

    Source: balance of moments of a thin slab, module docstring.

    >>> loads = normal_forces(Oscillator(m=1, radius=0.1), [0, 0.4, 0], g=10, spacing=0.4)
    >>> {name: round(float(load), 9) for name, load in loads.items()}["cylinder_slab"]
    6.0
    """
    travel = oscillator.radius * coordinates("q", q)[1]
    distance = _valid_spacing(oscillator, 2 * float(np.abs(travel).max(initial=0.0)), spacing)
    weight = oscillator.m * positive("g", g)
    loads = _loads(oscillator, 1 / 2 - travel / distance, 1 / 2 + travel / distance)
    return {name: np.broadcast_to(weight * load, travel.shape) for name, load in loads.items()}


def travel_amplitude(oscillator: Oscillator, initial: InitialState) -> float:
    """Return A = R√(φ₀² + (φ̇₀/Ω)²) [m], how far the lower rollers move relative to the block to either side.

    Every contact force depends on the initial state through A alone. So the friction that a motion needs in the long
    run is that after a release with the compression 2A.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0

    Returns
    -------
    A [m]

    Source: `motion`, φ(t) = φ₀ cos Ωt + (φ̇₀/Ω) sin Ωt.

    >>> round(travel_amplitude(Oscillator(radius=0.1), InitialState(phi=0.4)), 12)
    0.04
    """
    return oscillator.radius * math.hypot(initial.phi, initial.phi_dot / oscillator.natural_frequency)


def required_friction(
    oscillator: Oscillator, compression: float, g: float = GRAVITY, spacing: float = math.inf
) -> dict[str, float]:
    """Return the least coefficient of static friction at which each contact does not slip after a release from rest.

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

    Returns
    -------
    dict with the keys hoop_slab, cylinder_slab, hoop_block, cylinder_block and top_block, dimensionless

    Raises
    ------
    ValueError : compression is not finite, g is not positive, spacing is less than 2R or does not exceed |compression|,
        so that the slab would tip off its rollers.

    Source: module docstring; the largest value of |horizontal force|/normal force over one period.

    >>> needed = required_friction(Oscillator(m=1, m_prime=1, k=10), 0.08)
    >>> max(needed, key=needed.get)
    'hoop_slab'
    """
    amplitude = abs(finite("compression", compression)) / 2
    pull = oscillator.natural_frequency_squared * amplitude / positive("g", g)
    return {name: ratio * pull for name, ratio in _force_per_load(oscillator, amplitude, spacing).items()}


def first_to_slip(oscillator: Oscillator, compression: float = 0.0, spacing: float = math.inf) -> str:
    """Return the contact that needs the most friction after a release from rest, and so slips first.

    It is always top_block or hoop_slab. For L → ∞ it is top_block if ε < (√21 − 3)/6 ≈ 0.2638, else hoop_slab. For
    finite L the load shifts, and hoop_slab comes first already at a smaller ε.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; 0 means the limit of a small compression. It matters only if spacing is finite.
    spacing : L, distance between the axes of hoop and lower cylinder [m]

    Returns
    -------
    a key of `required_friction`

    Raises
    ------
    ValueError : as in `required_friction`.

    Source: `required_friction`, whose largest value this is.

    >>> first_to_slip(Oscillator(m=1, m_prime=0.2)), first_to_slip(Oscillator(m=1, m_prime=0.3))
    ('top_block', 'hoop_slab')
    """
    ratios = _force_per_load(oscillator, abs(finite("compression", compression)) / 2, spacing)
    return max(ratios, key=ratios.__getitem__)


def largest_compression(
    oscillator: Oscillator, friction_coefficient: float, g: float = GRAVITY, spacing: float = math.inf
) -> float:
    """Return the largest compression x₀ [m] from which the machine can be released without slip at any contact.

    A contact with the force f·mΩ²A at the end of the swing and the load mg(n − σA/L) slips beyond
    A = μn/(fΩ²/g + μσ/L), with σ = 0 for the top cylinder and 1 for the others. x₀ is twice the least of the five.

    Parameters
    ----------
    oscillator : the machine
    friction_coefficient : μ, coefficient of static friction, the same at all contacts, dimensionless
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; infinite means that no load shifts

    Returns
    -------
    x₀ [m], less than the spacing

    Raises
    ------
    ValueError : friction_coefficient or g is not positive, or spacing is less than 2R.

    Source: `required_friction`, solved for the compression.

    >>> round(largest_compression(Oscillator(m=1, m_prime=1, k=10), 0.3), 6)
    0.52028
    """
    mu = positive("friction_coefficient", friction_coefficient)
    pull = oscillator.natural_frequency_squared / positive("g", g)
    distance = _valid_spacing(oscillator, 0.0, spacing)
    forces, loads = _forces(oscillator), _loads(oscillator, 1 / 2, 1 / 2)
    amplitudes = []
    for name, load in loads.items():
        shift = 0.0 if name == "top_block" else mu / distance
        amplitudes.append(mu * load / (abs(forces[name]) * pull + shift))
    return 2 * min(amplitudes)


def _forces(oscillator: Oscillator) -> dict[str, float]:
    """Return the horizontal force at each contact divided by ma, with a = Rφ̈, as in the module docstring."""
    kappa, half = oscillator.block_coupling, oscillator.mass_ratio / 2
    return {
        "hoop_slab": half * (2 - kappa),
        "cylinder_slab": half * (3 / 2 - kappa),
        "hoop_block": half * -kappa,
        "cylinder_block": half * (1 / 2 - kappa),
        "top_block": -kappa / 3,
    }


def _loads(oscillator: Oscillator, on_hoop: FloatOrArray, on_cylinder: FloatOrArray) -> dict[str, FloatOrArray | float]:
    """Return the normal force at each contact divided by mg, from both parts of the weight of the slab."""
    return {
        "hoop_slab": on_hoop,
        "cylinder_slab": on_cylinder,
        "hoop_block": on_hoop + oscillator.mass_ratio,
        "cylinder_block": on_cylinder + oscillator.mass_ratio,
        "top_block": 1.0,
    }


def _force_per_load(oscillator: Oscillator, amplitude: float, spacing: float) -> dict[str, float]:
    """Return |force|/load at each contact in units of Ω²A/g, at the end of the swing where the load is smaller."""
    distance = _valid_spacing(oscillator, 2 * amplitude, spacing)
    least = 1 / 2 - amplitude / distance
    loads = _loads(oscillator, least, least)
    return {name: abs(force) / loads[name] for name, force in _forces(oscillator).items()}


def _valid_spacing(oscillator: Oscillator, compression: float, spacing: float) -> float:
    """Return L. Raise `ValueError` if the two rollers overlap, or if the slab tips off them, that is if x₀ ≥ L."""
    distance = positive("spacing", spacing, infinite=True)
    if distance <= compression:
        raise ValueError(
            f"spacing must exceed the largest compression of the spring, {compression} m, or the slab tips off its "
            f"rollers; it is {distance} m"
        )
    if distance < 2 * oscillator.radius:
        raise ValueError(
            f"spacing must be at least 2R, {2 * oscillator.radius} m, or the rollers overlap; it is {distance} m"
        )
    return distance
