"""A record of one motion: positions, velocities, energies, momenta and forces on a uniform time grid.

This module collects and names the series. `motion`, `energy` and `contact` compute them.
"""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Integral

import numpy as np
from numpy.typing import NDArray

from ramanujan.physics.contact import contact_forces, normal_forces, travel_amplitude
from ramanujan.physics.energy import body_momenta, energies, momenta
from ramanujan.physics.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    with_initial_velocities,
)
from ramanujan.physics.oscillator import Oscillator
from ramanujan.physics.validation import positive

MOST_POINTS = 10**7
"""Upper limit of the number of times in a record. The series then take several gigabytes."""


@dataclass(frozen=True)
class Record:
    """All series of a motion at the times t, in SI units.

    Each dictionary is the result of the function of the same name; `forces` is that of `contact_forces`. All quantities
    are positive to the right, except X, Ẋ and p_X, which are positive to the LEFT as in the paper.
    """

    oscillator: Oscillator
    compression: float
    initial: InitialState
    spacing: float
    t: NDArray[np.float64]
    q: NDArray[np.float64]
    q_dot: NDArray[np.float64]
    ground_positions: dict[str, NDArray[np.float64]]
    relative_positions: dict[str, NDArray[np.float64]]
    ground_velocities: dict[str, NDArray[np.float64]]
    relative_velocities: dict[str, NDArray[np.float64]]
    energies: dict[str, NDArray[np.float64]]
    body_momenta: dict[str, NDArray[np.float64]]
    momenta: dict[str, NDArray[np.float64]]
    forces: dict[str, NDArray[np.float64]]
    normal_forces: dict[str, NDArray[np.float64]]

    @property
    def total_energy(self) -> NDArray[np.float64]:
        """E [J], the sum of all terms in `energies`."""
        total: NDArray[np.float64] = np.sum(list(self.energies.values()), axis=0)
        return total


def record(
    oscillator: Oscillator,
    compression: float,
    *,
    glide: float = 0.0,
    spin: float = 0.0,
    spacing: float,
    periods: float,
    points: int,
) -> Record:
    """Return the motion after a release with a push, at equally spaced times from 0 to the end of the last period.

    Parameters
    ----------
    oscillator, compression, glide, spin : as in `with_initial_velocities`
    spacing : L, distance between the axes of hoop and lower cylinder [m]
    periods : duration, in periods of the machine
    points : number of times, at least 2

    Returns
    -------
    the record; all series are computed from the same (q, q̇)

    Raises
    ------
    ValueError : a value is not a finite number, periods is not positive, points is out of range, or the slab tips off
        its rollers.

    Source: the modules `motion`, `energy` and `contact`.

    >>> one_period = record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5)
    >>> one_period.q.shape
    (3, 5)
    """
    initial = with_initial_velocities(oscillator, compression, glide, spin)
    if not isinstance(points, Integral) or not 2 <= points <= MOST_POINTS:
        raise ValueError(f"points must be an integer from 2 to {MOST_POINTS}, not {points}")
    t = np.linspace(0, positive("periods", periods) * oscillator.period, points)
    q, q_dot = motion(oscillator, initial, t)
    # The slab may tip off its rollers between two recorded times, so `normal_forces` checks the largest φ, too.
    largest_phi = travel_amplitude(oscillator, initial) / oscillator.radius
    normal_forces(oscillator, (0.0, largest_phi, 0.0), spacing=spacing)
    return Record(
        oscillator=oscillator,
        compression=float(compression),
        initial=initial,
        spacing=float(spacing),
        t=t,
        q=q,
        q_dot=q_dot,
        ground_positions=ground_positions(oscillator, q),
        relative_positions=relative_positions(oscillator, q),
        ground_velocities=ground_velocities(oscillator, q_dot),
        relative_velocities=relative_velocities(oscillator, q_dot),
        energies=energies(oscillator, q, q_dot),
        body_momenta=body_momenta(oscillator, q_dot),
        momenta=momenta(oscillator, q_dot),
        forces=contact_forces(oscillator, q),
        normal_forces=normal_forces(oscillator, q, spacing=spacing),
    )
