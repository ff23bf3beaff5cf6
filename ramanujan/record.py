"""One motion, recorded: everything that is known of it at equal steps of time, and as a table.

Lives here: which series belong together and what they are called. Does not live here: the physics of any of them
(`motion`, `energy`, `contact`), how many steps a screen needs (`sampling`), the table's format (`table`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ramanujan.contact import contact_forces, largest_compression, normal_forces, required_friction
from ramanujan.energy import energies, momenta
from ramanujan.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
)
from ramanujan.oscillator import Oscillator
from ramanujan.table import csv_table


@dataclass(frozen=True)
class Record:
    """A motion at the times t: arrays in SI units, right positive, with the keys of the functions they come from.

    Only q = (X, φ, Φ), q̇ and the momentum p_X follow the paper, in which X counts to the LEFT.
    `body_momenta` are m v of each body over the ground [kg·m/s].
    """

    oscillator: Oscillator
    compression: float
    initial: InitialState
    spacing: float
    t: np.ndarray
    q: np.ndarray
    q_dot: np.ndarray
    over_ground: dict[str, np.ndarray]
    over_block: dict[str, np.ndarray]
    velocity_over_ground: dict[str, np.ndarray]
    velocity_over_block: dict[str, np.ndarray]
    energies: dict[str, np.ndarray]
    body_momenta: dict[str, np.ndarray]
    momenta: dict[str, np.ndarray]
    forces: dict[str, np.ndarray]
    normal_forces: dict[str, np.ndarray]

    @property
    def total_energy(self) -> np.ndarray:
        """E [J], the sum of all energies."""
        return sum(self.energies.values())


def pushed(oscillator: Oscillator, compression: float, glide: float = 0.0, spin: float = 0.0) -> InitialState:
    """Return the state of a release with a push along each zero mode: φ₀ = x₀/(2R), Ẋ₀ = −glide, Φ̇₀ = spin.

    Parameters
    ----------
    oscillator : the machine
    compression : x₀ [m]
    glide : velocity that the whole machine gets, to the RIGHT [m/s]
    spin : angular velocity that the top cylinder gets besides, clockwise [rad/s]

    Raises
    ------
    ValueError : a value is not a finite number.

    Source: the null space of K, spanned by (1, 0, 0) and (0, 0, 1).
    """
    return InitialState(phi=compression / (2 * oscillator.radius), X_dot=-glide, Phi_dot=spin)


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
    """Return the motion after a release with a push, at equally spaced times, both ends included.

    Parameters
    ----------
    oscillator, compression, glide, spin : as in `pushed`
    spacing : L, distance between the axes of hoop and lower cylinder [m]
    periods : how long, in periods of the machine
    points : number of times

    Raises
    ------
    ValueError : a value is not a finite number, or the slab tips off its rollers.
    """
    initial = pushed(oscillator, compression, glide, spin)
    t = np.linspace(0, periods * oscillator.period, points)
    q, q_dot = motion(oscillator, initial, t)
    velocity = ground_velocities(oscillator, q_dot)
    m, m_prime = oscillator.m, oscillator.m_prime
    masses = {"block": m, "hoop": m_prime, "cylinder": m_prime, "slab": m, "top": m}
    return Record(
        oscillator=oscillator,
        compression=compression,
        initial=initial,
        spacing=spacing,
        t=t,
        q=q,
        q_dot=q_dot,
        over_ground=ground_positions(oscillator, q),
        over_block=relative_positions(oscillator, q),
        velocity_over_ground=velocity,
        velocity_over_block=relative_velocities(oscillator, q_dot),
        energies=energies(oscillator, q, q_dot),
        body_momenta={body: mass * velocity[body] for body, mass in masses.items()},
        momenta=momenta(oscillator, q_dot),
        forces=contact_forces(oscillator, initial, t),
        normal_forces=normal_forces(oscillator, initial, t, spacing=spacing),
    )


def columns(motion: Record) -> dict[str, np.ndarray]:
    """Return every series of a record under a header that tells its unit, time first."""
    series = {"t [s]": motion.t}
    names = (("X", "m"), ("phi", "rad"), ("Phi", "rad"))
    series |= {f"{name} [{unit}]": row for (name, unit), row in zip(names, motion.q, strict=True)}
    series |= {f"{name}_dot [{unit}/s]": row for (name, unit), row in zip(names, motion.q_dot, strict=True)}
    groups = (
        ("{} over ground [m]", motion.over_ground),
        ("{} over block [m]", motion.over_block),
        ("velocity of {} over ground [m/s]", motion.velocity_over_ground),
        ("velocity of {} over block [m/s]", motion.velocity_over_block),
        ("energy {} [J]", motion.energies | {"total": motion.total_energy}),
        ("momentum of {} [kg m/s]", motion.body_momenta),
        ("force {} [N]", motion.forces),
        ("normal force {} [N]", motion.normal_forces),
    )
    series |= {form.format(name): values for form, group in groups for name, values in group.items()}
    return series | {"p_X [kg m/s]": motion.momenta["p_X"], "p_Phi [kg m2/s]": motion.momenta["p_Phi"]}


def table(motion: Record, friction_coefficient: float) -> str:
    """Return a record as comma-separated values: the parameters as comments, units in the header.

    Parameters
    ----------
    motion : the record
    friction_coefficient : μ; with it stand the friction that each contact needs and the greatest x₀ without slip

    Raises
    ------
    ValueError : the coefficient is not positive.
    """
    oscillator, initial = motion.oscillator, motion.initial
    needed = required_friction(oscillator, motion.compression, spacing=motion.spacing)
    largest = largest_compression(oscillator, friction_coefficient, spacing=motion.spacing)
    parameters = (
        ("m", oscillator.m, "kg"),
        ("m_prime", oscillator.m_prime, "kg"),
        ("k", oscillator.k, "N/m"),
        ("R", oscillator.radius, "m"),
        ("compression", motion.compression, "m"),
        ("X_dot at release", initial.X_dot, "m/s"),
        ("Phi_dot at release", initial.Phi_dot, "rad/s"),
        ("Omega", oscillator.natural_frequency, "rad/s"),
        ("spacing of the lower rollers", motion.spacing, "m"),
        ("mu", friction_coefficient, ""),
        ("largest compression without slip", largest, "m"),
        *((f"friction coefficient needed by {contact}", value, "") for contact, value in needed.items()),
    )
    return csv_table(
        columns(motion),
        [
            "Ramanujan's oscillator in SI units: right is positive except for X and p_X which count to the left",
            *(f"{name} = {float(value)!r} {unit}".rstrip() for name, value, unit in parameters),
        ],
    )
