r"""The five rolling contacts: their forces, the friction that they need, and the compression at which one slips.

The forces hold as long as every contact rolls without slipping; the motion after a slip is not modelled.

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
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan.motion import InitialState
from ramanujan.numerals import quantity
from ramanujan.oscillator import GRAVITY, Oscillator
from ramanujan.rounding import in_range, nearest, product, scaled, square_root
from ramanujan.translation import _
from ramanujan.validation import coordinates, instance, positive, real


def contact_forces(oscillator: Oscillator, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Return the horizontal force [N], right positive, at every contact and in the spring.

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
    ValueError : q does not have three rows of finite numbers, or a force is too large for float64.

    Source: Newton's equations with the rolling constraints, as in the module docstring.

    >>> forces = contact_forces(Oscillator(k=10, radius=0.1), [0, 0.4, 0])
    >>> round(float(forces["spring"]), 12)
    -0.8
    """
    m, _m_prime, k, R = instance("oscillator", oscillator, Oscillator).exact
    phi = coordinates("q", q)[1]
    per_angle = -oscillator.exact_frequency_squared * m * R
    per_angles = {name: share * per_angle for name, share in _shares(oscillator).items()} | {"spring": -2 * k * R}
    # TRANSLATORS: in an error such as: force hoop_slab is too large for float64.
    label = _("force {name}")
    with np.errstate(over="ignore"):
        forces = {name: scaled(*coefficient.as_integer_ratio(), phi) for name, coefficient in per_angles.items()}
    return {name: in_range(label.format(name=name), force) for name, force in forces.items()}


def normal_forces(
    oscillator: Oscillator, q: ArrayLike, g: float = GRAVITY, spacing: float = math.inf
) -> dict[str, NDArray[np.float64]]:
    """Return the normal force [N] at the five contacts; the load shifts as the slab moves.

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
    instance("oscillator", oscillator, Oscillator)
    travel = product(_("displacement of a roller"), oscillator.radius, coordinates("q", q)[1])
    weight = positive("g", g)
    distance = _spacing_beyond(oscillator, Fraction(float(np.abs(travel).max(initial=0.0))) * 2, spacing)
    if math.isinf(distance):
        on_hoop = on_cylinder = np.full(travel.shape, 0.5)
    else:
        # Near tipping this difference is exact; ½ − Rφ/L would lose its digits.
        on_hoop, on_cylinder = (distance / 2 - travel) / distance, (distance / 2 + travel) / distance
    slab, roller = product(_("load"), oscillator.m, weight), product(_("load"), oscillator.m_prime, weight)
    with np.errstate(over="ignore"):
        return {
            "hoop_slab": slab * on_hoop,
            "cylinder_slab": slab * on_cylinder,
            "hoop_block": in_range(_("load"), slab * on_hoop + roller),
            "cylinder_block": in_range(_("load"), slab * on_cylinder + roller),
            "top_block": np.full(travel.shape, slab),
        }


def travel_amplitude(oscillator: Oscillator, initial: InitialState) -> float:
    """Return A = R √(φ₀² + (φ̇₀/Ω)²) [m], how far the lower rollers move relative to the block to either side.

    Every contact force depends on the initial state through A alone: the friction that a motion needs in the long run
    is that after a release with the compression 2A.

    Parameters
    ----------
    oscillator : the machine
    initial : its state at t = 0

    Returns
    -------
    A [m]

    Raises
    ------
    ValueError : A is too large for float64.

    >>> round(travel_amplitude(Oscillator(radius=0.1), InitialState(phi=0.4)), 12)
    0.04
    """
    R = instance("oscillator", oscillator, Oscillator).exact[3]
    phi, phi_dot = Fraction(instance("initial", initial, InitialState).phi), Fraction(initial.phi_dot)
    squared = phi**2 + phi_dot**2 / oscillator.exact_frequency_squared
    return nearest("travel_amplitude", *(R * Fraction(*square_root(*squared.as_integer_ratio()))).as_integer_ratio())


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
        so that the slab would tip off its rollers, or a coefficient is too large for float64.

    Source: module docstring; the largest value of |horizontal force|/normal force over one period.

    >>> needed = required_friction(Oscillator(m=1, m_prime=1, k=10), 0.08)
    >>> max(needed, key=needed.get)
    'hoop_slab'
    """
    demands = _demands(oscillator, compression, spacing)
    amplitude = abs(Fraction(real("compression", compression))) / 2
    pull = oscillator.exact_frequency_squared * amplitude / Fraction(positive("g", g))
    # TRANSLATORS: in an error such as: friction at hoop_slab is too large for float64.
    label = _("friction at {name}")
    return {
        name: nearest(label.format(name=name), *(demand * pull).as_integer_ratio()) for name, demand in demands.items()
    }


def first_to_slip(oscillator: Oscillator, compression: float = 0.0, spacing: float = math.inf) -> str:
    """Return the contact that needs the most friction after a release from rest, and so slips first.

    It is always top_block or hoop_slab. For L → ∞ it is top_block if ε < (√21 − 3)/6 ≈ 0.2638, else hoop_slab. For
    finite L the load shifts, and hoop_slab comes first already at a smaller ε.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]; 0 stands for the limit of a small one. It matters only if spacing is finite.
    spacing : L, distance between the axes of hoop and lower cylinder [m]

    Returns
    -------
    a key of `required_friction`

    Raises
    ------
    ValueError : compression is not finite, spacing is less than 2R or does not exceed |compression|.

    Source: the largest entry of `required_friction`, in which g is a common factor.

    >>> first_to_slip(Oscillator(m=1, m_prime=0.2))
    'top_block'
    """
    demands = _demands(oscillator, compression, spacing)
    return max(demands, key=demands.__getitem__)


def largest_compression(
    oscillator: Oscillator, friction_coefficient: float, g: float = GRAVITY, spacing: float = math.inf
) -> float:
    """Return the largest compression x₀ [m] from which the machine can be released without slip at any contact.

    A contact whose force at the end of the swing is f·mΩ²A under the load mg(n − σA/L), with σ = 0 for the top
    cylinder and 1 else, slips beyond A = μn/(fΩ²/g + μσ/L); x₀ is twice the least of the five.

    Parameters
    ----------
    oscillator : the machine
    friction_coefficient : μ, coefficient of static friction, the same at all contacts, dimensionless
    g : gravitational acceleration [m/s²]
    spacing : L, distance between the axes of hoop and lower cylinder [m]; infinite means that no load shifts

    Returns
    -------
    x₀ [m], less than the spacing; it is rounded down, so that no contact slips at this very x₀

    Raises
    ------
    ValueError : friction_coefficient or g is not positive, spacing is less than 2R, or x₀ is too large for float64.

    Source: `required_friction`, solved for the compression.

    >>> round(largest_compression(Oscillator(m=1, m_prime=1, k=10), 0.3), 6)
    0.52028
    """
    instance("oscillator", oscillator, Oscillator)
    mu = Fraction(positive("friction_coefficient", friction_coefficient))
    pull = oscillator.exact_frequency_squared / Fraction(positive("g", g))
    distance = _spacing_beyond(oscillator, Fraction(0), spacing)
    shifted = Fraction(0) if math.isinf(distance) else mu / Fraction(distance)
    loads = _loads(oscillator, Fraction(1, 2))
    exact = 2 * min(
        mu * loads[name] / (abs(share) * pull + (0 if name == "top_block" else shifted))
        for name, share in _shares(oscillator).items()
    )
    largest = nearest(_("the largest compression"), *exact.as_integer_ratio())
    # If it were rounded up, a contact would slip or the slab would tip.
    return largest if Fraction(largest) <= exact else math.nextafter(largest, 0.0)


def _shares(oscillator: Oscillator) -> dict[str, Fraction]:
    """Return each contact's force on its roller divided by m·Rφ̈, dimensionless."""
    m, m_prime = oscillator.exact[:2]
    kappa, half = Fraction(*oscillator.coupling_ratio), m_prime / m / 2
    shape_factors = {"hoop": Fraction(1), "cylinder": Fraction(1, 2)}
    at_slab = {f"{roller}_slab": half * (1 + beta - kappa) for roller, beta in shape_factors.items()}
    at_block = {f"{roller}_block": half * (1 - beta - kappa) for roller, beta in shape_factors.items()}
    return at_slab | at_block | {"top_block": -kappa / 3}


def _loads(oscillator: Oscillator, on_roller: Fraction) -> dict[str, Fraction]:
    """Return each contact's normal force divided by mg, from the part of the slab's weight on its roller."""
    m, m_prime = oscillator.exact[:2]
    slab, block = dict.fromkeys(("hoop_slab", "cylinder_slab"), on_roller), on_roller + m_prime / m
    return slab | dict.fromkeys(("hoop_block", "cylinder_block"), block) | {"top_block": Fraction(1)}


def _demands(oscillator: Oscillator, compression: float, spacing: float) -> dict[str, Fraction]:
    """Return the friction required, divided by Ω²A/g: for each contact at the moment when it needs most."""
    instance("oscillator", oscillator, Oscillator)
    deformation = abs(Fraction(real("compression", compression)))
    distance = _spacing_beyond(oscillator, deformation, spacing)
    least = Fraction(1, 2) if math.isinf(distance) else (1 - deformation / Fraction(distance)) / 2
    loads = _loads(oscillator, least)
    return {name: abs(share) / loads[name] for name, share in _shares(oscillator).items()}


def _spacing_beyond(oscillator: Oscillator, compression: Fraction, spacing: float) -> float:
    """Return spacing as a float; ValueError if the two rollers overlap, or if the slab tips off them (x₀ ≥ L)."""
    distance = positive("spacing", spacing, infinite=True)
    if math.isinf(distance):
        return distance
    if distance <= compression:
        sentence = _(
            "spacing must exceed the largest compression of the spring, {compression}, or the slab tips off its "
            "rollers; it is {spacing}"
        )
        raise ValueError(sentence.format(compression=_metres(float(compression)), spacing=_metres(distance)))
    if distance < 2 * oscillator.exact[3]:
        sentence = _("spacing must be at least 2R, {least}, or the rollers overlap; it is {spacing}")
        raise ValueError(sentence.format(least=_metres(2 * oscillator.radius), spacing=_metres(distance)))
    return distance


def _metres(length: float) -> str:
    return quantity(length, "m", 6, strip=True)
