"""The machine as numbers: from four parameters follow the matrices, the natural frequency and the mode shape.

The machine has three degrees of freedom, q = (X, φ, Φ), and one spring:

    M q̈ + K q = 0,    K = 4kR² e_φ e_φᵀ  (rank one)

so it has one oscillating mode and two zero-frequency modes. Everything that oscillates does so at

    Ω² = k / M_x,    M_x/m = 3ε/8 + 7/12 − 1/(12(7 + 6ε)),    ε = m′/m,

where M_x is the mass that the spring feels. Every number is computed exactly from the four doubles, in integers, and
rounded once (`rounding`). So it is the nearest double, or an error names the value that leaves the range of float64.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ramanujan.frequency import frequency_ratio
from ramanujan.numerals import quantity
from ramanujan.rounding import nearest, normal, over_one_denominator, square_root
from ramanujan.translation import _
from ramanujan.validation import positive

TWO_PI = Fraction(Decimal("6.28318530717958647692528676655900576839433879875021164194988918"))
"""2π to 60 digits."""


DRAWN_SPACING = (Fraction(12, 5), Fraction(1, 20))
"""a and b [m] of the drawn distance aR + b between the axes of hoop and lower cylinder."""


GRAVITY = 9.81
"""g [m/s²], the gravitational acceleration in every picture and, unless another one is given, in every function."""


def drawn_spacing(radius: float) -> float:
    """Return L [m], the distance between the axes of hoop and lower cylinder in every picture of the machine.

        L = 2.4R + 5 cm

    There is a gap between the two rollers for every radius. No frequency depends on L. The load of the slab on each
    roller does, and with it the friction that the contacts need.

    Parameters
    ----------
    radius : R, radius of the rollers [m]

    Returns
    -------
    L : distance of the axes [m], at least 2R

    Raises
    ------
    ValueError : radius is not a finite positive number.

    >>> round(drawn_spacing(0.1), 3)
    0.29
    """
    per_radius, gap = DRAWN_SPACING
    return nearest("spacing", *(per_radius * Fraction(positive("radius", radius)) + gap).as_integer_ratio())


@dataclass(frozen=True)
class Oscillator:
    """Ramanujan's oscillator: a stepped block, two rollers under a slab on a spring, and a cylinder that rolls freely.

    Parameters
    ----------
    m : m, mass of the block, of the slab and of the top cylinder [kg]
    m_prime : m′, mass of the hoop and of the lower cylinder [kg]
    k : k, stiffness of the spring [N/m]
    radius : R, radius of the three rolling bodies [m]; it sets lengths and drops out of every frequency

    Raises
    ------
    ValueError : a parameter is not a finite positive number (the message names it), or a derived value is too large
        for float64, or so small that it would lose digits.

    Source: paper, figure 1 and section 2; coordinates q = (X, φ, Φ) with X counted to the left.

    >>> machine = Oscillator(m=2, m_prime=2, k=10)
    >>> machine.normalized_frequency_squared == 104 / 99
    True
    >>> machine.natural_frequency
    2.291838836507762
    """

    m: float = 1.0
    m_prime: float = 1.0
    k: float = 1.0
    radius: float = 0.1

    def __post_init__(self) -> None:
        # A frozen dataclass lets nothing be assigned; the four fields are all that is in its dictionary yet.
        vars(self).update({name: positive(name, value) for name, value in vars(self).items()})

    @cached_property
    def exact(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """(m, m′, k, R) as the fractions that these doubles are [kg, kg, N/m, m]."""
        return Fraction(self.m), Fraction(self.m_prime), Fraction(self.k), Fraction(self.radius)

    @property
    def frequency_ratio(self) -> tuple[int, int]:
        """Ω² = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) [rad²/s²], exactly: its numerator and denominator."""
        m, m_prime, unit = over_one_denominator(self.m, self.m_prime)
        k, own_unit = self.k.as_integer_ratio()
        numerator, denominator = frequency_ratio(m, m_prime, k)
        return numerator * unit, denominator * own_unit

    @property
    def exact_frequency_squared(self) -> Fraction:
        """Ω² [rad²/s²] as a fraction in lowest terms."""
        return Fraction(*self.frequency_ratio)

    @cached_property
    def exact_frequency(self) -> tuple[int, int]:
        """Ω [rad/s] to 160 bits, or exactly if it is a double: its numerator and denominator."""
        return square_root(*self.frequency_ratio)

    @cached_property
    def coupling_ratio(self) -> tuple[int, int]:
        """κ = 6(m + m′)/(7m + 6m′), dimensionless, exactly: its numerator and denominator."""
        m, m_prime, _unit = over_one_denominator(self.m, self.m_prime)
        return 6 * (m + m_prime), 7 * m + 6 * m_prime

    @property
    def mass_ratio(self) -> float:
        """ε = m′/m, dimensionless."""
        m, m_prime, _unit = over_one_denominator(self.m, self.m_prime)
        return self._rounded("mass_ratio", m_prime, m)

    @property
    def effective_mass(self) -> float:
        """M_x = 3m′/8 + (m/2)(8m + 7m′)/(7m + 6m′) [kg], the mass that the spring feels; Ω² = k/M_x."""
        m, m_prime, unit = over_one_denominator(self.m, self.m_prime)
        numerator, denominator = frequency_ratio(m, m_prime, unit)
        return self._rounded("effective_mass", denominator, numerator)

    @property
    def natural_frequency_squared(self) -> float:
        """Ω² = k/M_x = 8k(7m + 6m′)/(32m² + 49mm′ + 18m′²) [rad²/s²]."""
        return self._rounded("natural_frequency_squared", *self.frequency_ratio)

    @cached_property
    def natural_frequency(self) -> float:
        """Ω [rad/s], the angular frequency of the one oscillating mode."""
        return self._rounded("natural_frequency", *self.exact_frequency)

    @cached_property
    def period(self) -> float:
        """T = 2π/Ω [s]."""
        numerator, denominator = self.exact_frequency
        return self._rounded("period", TWO_PI.numerator * denominator, TWO_PI.denominator * numerator)

    @cached_property
    def frequency_in_turns(self) -> tuple[float, float, int]:
        """Ω/2π [1/s] as (high + low)·2^exponent, the sum of two doubles that are far from the ends of the range."""
        numerator, denominator = self.exact_frequency
        top, bottom = numerator * TWO_PI.denominator, denominator * TWO_PI.numerator
        exponent = top.bit_length() - bottom.bit_length()
        top, bottom = top << max(-exponent, 0), bottom << max(exponent, 0)
        high = top / bottom
        taken, unit = high.as_integer_ratio()
        return high, (top * unit - taken * bottom) / (bottom * unit), exponent

    @property
    def normalized_frequency_squared(self) -> float:
        """Ω²m/k, dimensionless; it depends on ε alone and is 1 at ε = UNIT_MASS_RATIO."""
        m, m_prime, _unit = over_one_denominator(self.m, self.m_prime)
        return self._rounded("normalized_frequency_squared", *frequency_ratio(m, m_prime, m))

    @property
    def block_coupling(self) -> float:
        """κ = 6(1 + ε)/(7 + 6ε), dimensionless: in the oscillating mode the block moves by X = κRφ."""
        return self._rounded("block_coupling", *self.coupling_ratio)

    @property
    def mass_matrix(self) -> NDArray[np.float64]:
        """M, shape (3, 3): T = ½ q̇ᵀMq̇ for q = (X, φ, Φ); units kg, kg·m and kg·m² by row and column."""
        m, m_prime, _k, R = self.exact
        zero = Fraction(0)
        rows = [
            [3 * m + 2 * m_prime, -2 * (m + m_prime) * R, -m * R],
            [-2 * (m + m_prime) * R, (4 * m + m_prime * 7 / 2) * R * R, zero],
            [-m * R, zero, m * R * R * 3 / 2],
        ]
        return np.array([[self._rounded("mass_matrix", *entry.as_integer_ratio()) for entry in row] for row in rows])

    @property
    def stiffness_matrix(self) -> NDArray[np.float64]:
        """K, shape (3, 3): U = ½ qᵀKq; its one entry 4kR² [N·m] belongs to φ."""
        _m, _m_prime, k, R = self.exact
        stiffness = np.zeros((3, 3))
        stiffness[1, 1] = self._rounded("stiffness_matrix", *(4 * k * R * R).as_integer_ratio())
        return stiffness

    @property
    def mode_shape(self) -> NDArray[np.float64]:
        """The oscillating mode (κR, 1, λ), shape (3,), for q = (X, φ, Φ): metres, radians, radians; λ = 2κ/3."""
        (kappa, whole), (R, unit) = self.coupling_ratio, self.radius.as_integer_ratio()
        return np.array([self._rounded("mode_shape", kappa * R, whole * unit), 1.0, 2 * kappa / (3 * whole)])

    def _rounded(self, name: str, numerator: int, denominator: int) -> float:
        """Return the double nearest to a quotient, or raise ValueError that names the value and the machine."""
        try:
            return normal(name, numerator, denominator)
        except ValueError as error:
            raise ValueError(_("{problem} for {machine}").format(problem=error, machine=repr(self))) from None

    def _repr_markdown_(self) -> str:
        """Show the machine in a notebook: its parameters, its natural frequency and Ω²m/k."""
        shown = (
            ("m", _("block, slab and top cylinder"), "m", "kg"),
            ("m′", _("hoop and lower cylinder"), "m_prime", "kg"),
            ("k", _("stiffness of the spring"), "k", "N/m"),
            ("R", _("radius of the rollers"), "radius", "m"),
            ("Ω", _("natural frequency"), "natural_frequency", "rad/s"),
            ("Ω²m/k", _("normalized frequency squared"), "normalized_frequency_squared", ""),
        )
        title = _("Ramanujan’s oscillator")
        rows = [f"| | {title} | |", "|---|---|---|"]
        for symbol, meaning, name, unit in shown:
            # A machine whose frequency exceeds float64 still shows its parameters.
            with suppress(ValueError):
                value = quantity(getattr(self, name), unit, 6, strip=True)
                rows.append(f"| {symbol} | {meaning} | {value} |")
        return "\n".join(rows)
