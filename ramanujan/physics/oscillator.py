"""Parameters of a machine, and its matrices, natural frequency and mode shape.

The machine has three degrees of freedom, q = (X, φ, Φ), and one spring. Lagrange's equations (10) of the paper are
Mq̈ + Kq = 0. The only nonzero element of K is K_φφ = 4kR², so K has rank one. Therefore the machine has one oscillating
mode and two zero modes, that is modes of frequency zero. With the effective mass M_x of the module `frequency`,

    Ω² = k/M_x                          natural frequency of the oscillating mode, eq. (12)
    X : φ : Φ = κR : 1 : λ              its mode shape, eqs. (11)
    κ = (1 + ε)/(7/6 + ε),   λ = 2κ/3   its coefficients, where ε = m′/m

The error of Ω² is at most 6 units in the last place if k/m and ε are normal floating-point numbers; the greatest known
error is 5.04 units. `Oscillator` raises `ValueError` if ε, k/m or Ω² is not a finite positive number. Other quantities
can still overflow: for R = 10²⁰⁰ m a moment of inertia raises `OverflowError`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ramanujan.physics.frequency import effective_mass_ratio
from ramanujan.physics.validation import positive
from ramanujan.text.numerals import quantity
from ramanujan.text.translation import _

GRAVITY = 9.81
"""Default value of the gravitational acceleration g [m/s²]."""

SPACING_PER_RADIUS = 2.4
"""Coefficient a in `drawn_spacing`, L = aR + b."""

SPACING_GAP = 0.05
"""Constant b [m] in `drawn_spacing`, L = aR + b."""

EDGE_GAPS = 0.025, 0.045
"""Constants [m] of the left and the right edge in `drawn_edges`."""


def drawn_spacing(radius: float) -> float:
    """Return L = 2.4R + 5 cm, the distance between the axes of hoop and lower cylinder in every picture.

    The two rollers do not touch, whatever the radius. The natural frequency does not depend on L. The load on each
    roller depends on L, and therefore the required friction does, too.

    Parameters
    ----------
    radius : R, radius of the rollers [m]

    Returns
    -------
    L : distance between the axes [m], greater than 2R

    Raises
    ------
    ValueError : radius is not a finite positive number.

    Source: chosen for the pictures; the paper does not specify the distance.

    >>> round(drawn_spacing(0.1), 3)
    0.29
    """
    return SPACING_PER_RADIUS * positive("radius", radius) + SPACING_GAP


def drawn_edges(radius: float, largest: float) -> tuple[float, float]:
    """Return the edges of the block's upper step in every picture, measured from the top cylinder's axis at release.

    Parameters
    ----------
    radius : R, radius of the rollers [m]
    largest : the largest compression that the picture has room for [m]

    Returns
    -------
    the left edge, negative, and the right edge [m]

    Raises
    ------
    ValueError : a parameter is not a finite positive number.

    Source: chosen for the pictures; the paper does not specify the length of the step.

    >>> [round(edge, 3) for edge in drawn_edges(0.1, 0.12)]
    [-0.185, 0.145]
    """
    R, (left, right) = positive("radius", radius), EDGE_GAPS
    return -(R + positive("largest", largest) / 2 + left), R + right


@dataclass(frozen=True)
class Oscillator:
    """Ramanujan's oscillator: a stepped block, two rollers under a slab on a spring, and a cylinder that rolls freely.

    Parameters
    ----------
    m : m, mass of the block, of the slab and of the top cylinder [kg]
    m_prime : m′, mass of the hoop and of the lower cylinder [kg]
    k : k, stiffness of the spring [N/m]
    radius : R, radius of the three rolling bodies [m]; the natural frequency does not depend on it

    Raises
    ------
    ValueError : a parameter, m′/m, k/m or Ω² is not a finite positive number. The message contains its name.

    Source: paper, figure 1 and section 2.

    >>> machine = Oscillator(m=2, m_prime=2, k=10)
    >>> machine.normalized_frequency_squared == 104 / 99
    True
    >>> round(machine.natural_frequency, 12)
    2.291838836508
    """

    m: float = 1.0
    m_prime: float = 1.0
    k: float = 1.0
    radius: float = 0.1

    def __post_init__(self) -> None:
        # A frozen dataclass forbids `self.m = …`. Writing to its dictionary is the fastest way around that.
        fields = vars(self)
        for name, value in fields.items():
            fields[name] = positive(name, value)
        # Quotients of valid parameters can still overflow to ∞ or underflow to 0.
        ratio, k_over_m, Omega_squared = self.mass_ratio, self.k / self.m, self.natural_frequency_squared
        if not all(0 < quotient < math.inf for quotient in (ratio, k_over_m, Omega_squared)):
            values = f"m_prime/m = {ratio}, k/m = {k_over_m} and Ω² = {Omega_squared}"
            raise ValueError(f"{values} must be finite positive numbers for {self}")

    @property
    def mass_ratio(self) -> float:
        """ε = m′/m, dimensionless."""
        return self.m_prime / self.m

    @property
    def normalized_frequency_squared(self) -> float:
        """Ω²m/k = m/M_x, dimensionless; it depends on ε alone and is 1 at ε = UNIT_MASS_RATIO."""
        return 1 / effective_mass_ratio(self.mass_ratio)

    @property
    def effective_mass(self) -> float:
        """M_x = 3m′/8 + (m/2)(8m + 7m′)/(7m + 6m′) [kg], the effective mass: Ω² = k/M_x, eq. (12)."""
        return self.m * effective_mass_ratio(self.mass_ratio)

    @cached_property
    def natural_frequency_squared(self) -> float:
        """Ω² = (k/m)/(M_x/m) [rad²/s²], eq. (12)."""
        return self.k / self.m / effective_mass_ratio(self.mass_ratio)

    @property
    def natural_frequency(self) -> float:
        """Ω [rad/s], the angular frequency of the one oscillating mode."""
        return math.sqrt(self.natural_frequency_squared)

    @property
    def period(self) -> float:
        """T = 2π/Ω [s]."""
        return 2 * math.pi / self.natural_frequency

    @property
    def block_coupling(self) -> float:
        """κ = 6(1 + ε)/(7 + 6ε), dimensionless: the block moves by κRφ in the oscillating mode, eq. (11a)."""
        return (1 + self.mass_ratio) / (7 / 6 + self.mass_ratio)

    @property
    def top_coupling(self) -> float:
        """λ = 2κ/3, dimensionless: the top cylinder turns by λφ in the oscillating mode, eq. (11b)."""
        return 2 / 3 * self.block_coupling

    @property
    def mode_shape(self) -> NDArray[np.float64]:
        """(κR, 1, λ), shape (3,): X [m], φ [rad] and Φ [rad] in the oscillating mode, scaled to φ = 1, eqs. (11)."""
        return np.array([self.block_coupling * self.radius, 1.0, self.top_coupling])

    @property
    def masses(self) -> dict[str, float]:
        """Body → its mass [kg], with the keys block, hoop, cylinder, slab and top."""
        m, m_prime = self.m, self.m_prime
        return {"block": m, "hoop": m_prime, "cylinder": m_prime, "slab": m, "top": m}

    @property
    def moments_of_inertia(self) -> dict[str, float]:
        """Rolling body → its moment of inertia [kg·m²]: hoop m′R², cylinder ½m′R², top ½mR²."""
        m, m_prime, R = self.m, self.m_prime, self.radius
        return {"hoop": m_prime * R**2, "cylinder": m_prime * R**2 / 2, "top": m * R**2 / 2}

    @property
    def mass_matrix(self) -> NDArray[np.float64]:
        """M, shape (3, 3): the kinetic energy in eq. (9) is ½q̇ᵀMq̇. Elements in kg, kg·m or kg·m²."""
        m, m_prime, R = self.m, self.m_prime, self.radius
        return np.array(
            [
                [3 * m + 2 * m_prime, -2 * (m + m_prime) * R, -m * R],
                [-2 * (m + m_prime) * R, (4 * m + 7 / 2 * m_prime) * R**2, 0],
                [-m * R, 0, 3 / 2 * m * R**2],
            ]
        )

    @property
    def stiffness_matrix(self) -> NDArray[np.float64]:
        """K, shape (3, 3): the potential energy in eq. (9) is ½qᵀKq. Its only nonzero element is K_φφ = 4kR² [N·m]."""
        stiffness = np.zeros((3, 3))
        stiffness[1, 1] = 4 * self.k * self.radius**2
        return stiffness

    def _repr_markdown_(self) -> str:
        """Return a Markdown table of the parameters, Ω and Ω²m/k, which Jupyter displays."""
        rows = (
            ("m", _("block, slab and top cylinder"), self.m, "kg"),
            ("m′", _("hoop and lower cylinder"), self.m_prime, "kg"),
            ("k", _("stiffness of the spring"), self.k, "N/m"),
            ("R", _("radius of the rollers"), self.radius, "m"),
            ("Ω", _("natural frequency"), self.natural_frequency, "rad/s"),
            ("Ω²m/k", _("normalized frequency squared"), self.normalized_frequency_squared, ""),
        )
        title = _("Ramanujan’s oscillator")
        head = [f"| | {title} | |", "|---|---|---|"]
        lines = [f"| {symbol} | {name} | {quantity(x, unit, 6, strip=True)} |" for symbol, name, x, unit in rows]
        return "\n".join(head + lines)
