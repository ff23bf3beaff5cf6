r"""Forces at the five rolling contacts, the friction that they require, and the largest compression without slip.

The paper assumes rolling without slipping. The contact forces enforce this constraint. They are valid as long as no
contact slips; the motion after a slip is not modelled.

                                                   ___
                                                  / | \      top cylinder, angle Φ
        −2kRφ →                                   \_|_/
     [=========== slab ===========]/\/\/|       f →            T, F, f   horizontal forces ON a rolling body,
           T →           T →            |                                right positive
            ___           ___           |                      L         distance between the axes, ≥ 2R
           / | \         / | \          |                      φ, Φ, X   clockwise, clockwise, to the left
           \___/         \_|_/          |
           F →           F →            |
     ___________________________________|     block            X ←
             |←     L     →|

Let a = Rφ̈ = −Ω²Rφ. Then Ẍ = κa and RΦ̈ = λa = ⅔κa by eqs. (11) of the paper. The moment of inertia of a lower roller is
βm′R², with β = 1 for the hoop and β = ½ for the cylinder. Newton's law and the torque about the axis give

    T + F = m′(a − Ẍ)  = m′a(1 − κ)               T = ½m′a(1 + β − κ)    from the slab
    T − F = βm′Rφ̈      = βm′a              ⟹      F = ½m′a(1 − β − κ)    from the block

    −f = ½mRΦ̈ = ⅓κma                       ⟹      f = −⅓κma              on the top cylinder, from the block

The slab is thin: all horizontal forces on it act along one line and have no torque. At φ = 0 its centre of mass is
midway between the axes of the rollers. It moves by 2Rφ and each axis by Rφ, so the loads of the slab on the rollers are

    on the hoop   mg(½ − Rφ/L)             on the cylinder   mg(½ + Rφ/L)

Let A be the amplitude of Rφ. The ratio force/load of each contact is largest at φ = A/R or φ = −A/R, where the load is
smaller. The block also carries the weight m′g of each lower roller.

    contact            largest force c·mΩ²A          load mg(n − sA/L)
    hoop_slab          c = ½ε(2 − κ)                 n = ½        s = 1
    cylinder_slab      c = ½ε(3/2 − κ)               n = ½        s = 1
    hoop_block         c = ½εκ                       n = ½ + ε    s = 1
    cylinder_block     c = ½ε|½ − κ|                 n = ½ + ε    s = 1
    top_block          c = ⅓κ                        n = 1        s = 0
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.physics.motion import InitialState
from ramanujan.physics.oscillator import GRAVITY, Oscillator
from ramanujan.physics.validation import FloatOrArray, coordinates, finite, positive

_LEAST, _LARGEST = 1e-50, 1e50
"""Bounds of the numbers in the formulas for friction. No product or quotient of them overflows or underflows."""


def contact_forces(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the horizontal force [N], right positive, at every contact and of the spring.

    The forces at the contacts are T, F and f of the module docstring. The force of the spring on the slab is −2kRφ.

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …), from the closed form or an integrator; only φ is used

    Returns
    -------
    dict of arrays of shape q.shape[1:]. The values of hoop_slab, cylinder_slab, hoop_block, cylinder_block and
    top_block are the forces ON the rolling body; the reactions have the opposite sign. The value of spring is the force
    on the slab.

    Raises
    ------
    ValueError : q does not have three rows of finite numbers.

    Source: Newton's equations with the rolling constraints, module docstring.

    >>> forces = contact_forces(Oscillator(k=10, radius=0.1), [0, 0.4, 0])
    >>> round(float(forces["spring"]), 12)
    -0.8
    """
    R, phi = oscillator.radius, coordinates("q", q)[1]
    acceleration = -oscillator.natural_frequency_squared * R * phi
    coefficients = _force_coefficients(oscillator)
    forces = {name: coefficient * oscillator.m * acceleration for name, coefficient in coefficients.items()}
    return forces | {"spring": -2 * oscillator.k * R * phi}


def normal_forces(
    oscillator: Oscillator, q: ArrayLike, g: float = GRAVITY, spacing: float = math.inf
) -> dict[str, NDArray[np.float64]]:
    """Return the load, that is the normal force [N], at each of the five contacts.

        hoop and slab        mg(½ − Rφ/L)          hoop and block        mg(½ − Rφ/L) + m′g
        cylinder and slab    mg(½ + Rφ/L)          cylinder and block    mg(½ + Rφ/L) + m′g
        top and block        mg

    Parameters
    ----------
    oscillator : the machine
    q : (X, φ, Φ), shape (3, …), from the closed form or an integrator; only φ is used
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; for ∞ the loads are constant

    Returns
    -------
    dict of arrays of shape q.shape[1:] with the keys of `required_friction`

    Raises
    ------
    ValueError : q does not have three rows of finite numbers, g is not positive, spacing is less than 2R, or the slab
        tips off its rollers in one of the states.

    Source: balance of torques of a thin slab, module docstring.

    >>> loads = normal_forces(Oscillator(m=1, radius=0.1), [0, 0.4, 0], g=10, spacing=0.4)
    >>> {name: round(float(load), 9) for name, load in loads.items()}["cylinder_slab"]
    6.0
    """
    displacement = oscillator.radius * coordinates("q", q)[1]
    compression = 2 * float(np.abs(displacement).max(initial=0.0))
    L = _check_spacing(oscillator, compression, spacing)
    weight = oscillator.m * positive("g", g)
    loads = _load_coefficients(oscillator, 1 / 2 - displacement / L, 1 / 2 + displacement / L)
    return {name: np.broadcast_to(weight * load, displacement.shape) for name, load in loads.items()}


def travel_amplitude(oscillator: Oscillator, initial: InitialState) -> float:
    """Return A = R√(φ₀² + (φ̇₀/Ω)²) [m], the amplitude of the displacement Rφ of the lower rollers.

    The largest ratio of force to load at each contact depends on the initial state only through A. Therefore the
    required friction equals that of a release from rest with the compression 2A.

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
    """Return the least coefficient of static friction that prevents slip at each contact after a release from rest.

    It is the largest force/load over one period, μ = (Ω²A/g)·c/(n − sA/L) with A = |x₀|/2 and the coefficients in the
    module docstring.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀, the spring's compression at release [m]; negative means a stretched spring
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; for ∞ the loads are constant

    Returns
    -------
    dict with the keys hoop_slab, cylinder_slab, hoop_block, cylinder_block and top_block, dimensionless

    Raises
    ------
    ValueError : compression is not finite, g is not positive, or spacing is less than 2R or not greater than
        |compression|, so that the slab would tip off its rollers. Also, |compression| exceeds 10⁵⁰, or g, ε, Ω² or a
        finite spacing is not between 10⁻⁵⁰ and 10⁵⁰, in SI units.

    Source: module docstring.

    >>> needed = required_friction(Oscillator(m=1, m_prime=1, k=10), 0.08)
    >>> max(needed, key=needed.get)
    'hoop_slab'
    """
    amplitude = abs(finite("compression", compression)) / 2
    if 2 * amplitude > _LARGEST:
        raise ValueError(f"compression must be at most {_LARGEST:g} m, not {compression}")
    # The largest acceleration of the axes relative to the block, divided by g.
    relative_acceleration = _frequency_squared_over_g(oscillator, g) * amplitude
    ratios = _scaled_force_load_ratios(oscillator, amplitude, spacing)
    return {name: ratio * relative_acceleration for name, ratio in ratios.items()}


def first_to_slip(oscillator: Oscillator, compression: float = 0.0, spacing: float = math.inf) -> str:
    """Return the contact with the largest required friction after a release from rest; it slips first.

    It is always top_block or hoop_slab. For L → ∞ it is top_block if ε < (√21 − 3)/6 ≈ 0.2638, otherwise hoop_slab. For
    finite L this limit of ε is smaller.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; 0 means the limit of a small compression. It has no effect for infinite spacing.
    spacing : L, distance between the axes of hoop and lower cylinder [m]

    Returns
    -------
    a key of `required_friction`

    Raises
    ------
    ValueError : as in `required_friction`.

    Source: `required_friction`; its key with the largest value.

    >>> first_to_slip(Oscillator(m=1, m_prime=0.2)), first_to_slip(Oscillator(m=1, m_prime=0.3))
    ('top_block', 'hoop_slab')
    """
    amplitude = abs(finite("compression", compression)) / 2
    ratios = _scaled_force_load_ratios(oscillator, amplitude, spacing)
    return max(ratios, key=ratios.__getitem__)


def largest_compression(
    oscillator: Oscillator, friction_coefficient: float, g: float = GRAVITY, spacing: float = math.inf
) -> float:
    """Return the largest compression x₀ [m] for a release from rest without slip at any contact.

    The condition (Ω²A/g)·c/(n − sA/L) = μ gives A = μn/(cΩ²/g + sμ/L) for each contact, with the coefficients of the
    module docstring. The result is x₀ = 2A for the smallest A.

    Parameters
    ----------
    oscillator : the machine
    friction_coefficient : μ, coefficient of static friction, the same at all contacts, dimensionless
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; for ∞ the loads are constant

    Returns
    -------
    x₀ [m], less than the spacing

    Raises
    ------
    ValueError : friction_coefficient or g is not positive, or spacing is less than 2R. Also, friction_coefficient, g,
        ε, Ω² or a finite spacing is not between 10⁻⁵⁰ and 10⁵⁰, in SI units.

    Source: `required_friction`, solved for the compression.

    >>> round(largest_compression(Oscillator(m=1, m_prime=1, k=10), 0.3), 6)
    0.52028
    """
    mu = _moderate("friction_coefficient", friction_coefficient)
    squared_over_g = _frequency_squared_over_g(oscillator, g)
    L = _check_spacing(oscillator, 0.0, spacing)
    forces = _force_coefficients(oscillator)
    amplitudes = []
    for name, n in _load_coefficients(oscillator, 1 / 2, 1 / 2).items():
        c = abs(forces[name])
        s = 0.0 if name == "top_block" else 1.0
        amplitudes.append(mu * n / (c * squared_over_g + s * (mu / L)))
    # For a very large μ, the rounded compression could reach L.
    return min(2 * min(amplitudes), math.nextafter(L, 0))


def _frequency_squared_over_g(oscillator: Oscillator, g: float) -> float:
    """Return Ω²/g [rad²/m]. Raise `ValueError` if g, Ω² or ε is not between `_LEAST` and `_LARGEST`."""
    gravity = _moderate("g", g)
    ratio, squared = oscillator.mass_ratio, oscillator.natural_frequency_squared
    if not all(_LEAST <= value <= _LARGEST for value in (ratio, squared)):
        raise ValueError(
            f"oscillator must have m_prime/m and Ω² between {_LEAST:g} and {_LARGEST:g}, not {ratio} and {squared}"
        )
    return squared / gravity


def _moderate(name: str, value: float) -> float:
    """Return a number as a float. Raise `ValueError` if it is not between `_LEAST` and `_LARGEST`."""
    number = positive(name, value)
    if not _LEAST <= number <= _LARGEST:
        raise ValueError(f"{name} must be between {_LEAST:g} and {_LARGEST:g}, not {number}")
    return number


def _force_coefficients(oscillator: Oscillator) -> dict[str, float]:
    """Return T, F or f at each contact, divided by ma. The absolute values are the coefficients c."""
    kappa, half = oscillator.block_coupling, oscillator.mass_ratio / 2
    return {
        "hoop_slab": half * (2 - kappa),
        "cylinder_slab": half * (3 / 2 - kappa),
        "hoop_block": half * -kappa,
        "cylinder_block": half * (1 / 2 - kappa),
        "top_block": -kappa / 3,
    }


def _load_coefficients(
    oscillator: Oscillator, on_hoop: FloatOrArray, on_cylinder: FloatOrArray
) -> dict[str, FloatOrArray | float]:
    """Return load/mg of each contact, given the slab's load/mg on the hoop and on the cylinder."""
    return {
        "hoop_slab": on_hoop,
        "cylinder_slab": on_cylinder,
        "hoop_block": on_hoop + oscillator.mass_ratio,
        "cylinder_block": on_cylinder + oscillator.mass_ratio,
        "top_block": 1.0,
    }


def _scaled_force_load_ratios(oscillator: Oscillator, amplitude: float, spacing: float) -> dict[str, float]:
    """Return the largest force/load of each contact in units of Ω²A/g.

    This is c/(n − sA/L), with the coefficients c, n and s of the module docstring.
    """
    L = _check_spacing(oscillator, 2 * amplitude, spacing)
    # Hoop and cylinder carry their smallest loads at opposite ends of the motion. Each force is largest at both ends.
    smaller_load = 1 / 2 - amplitude / L
    loads = _load_coefficients(oscillator, smaller_load, smaller_load)
    return {name: abs(force) / loads[name] for name, force in _force_coefficients(oscillator).items()}


def _check_spacing(oscillator: Oscillator, compression: float, spacing: float) -> float:
    """Return L as a float. Raise `ValueError` if the rollers overlap, or if the slab tips off them: |x₀| ≥ L."""
    distance = positive("spacing", spacing, infinite=True)
    if distance < math.inf:
        _moderate("spacing", distance)
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
