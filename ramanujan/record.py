"""A record of one motion: positions, velocities, energies, momenta and forces at equal steps of time, also as CSV.

This module collects and names the series; `motion`, `energy` and `contact` compute them. The table is
for programs, and numpy reads it back exactly:

    # a comment line for each remark and parameter
    t [s],X [m],…            one header line: each name with its unit
    0.0,0.04,…               one line for each time: the fewest digits that give back the very same doubles
"""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ramanujan.contact import contact_forces, largest_compression, normal_forces, required_friction, travel_amplitude
from ramanujan.energy import body_momenta, energies, momenta
from ramanujan.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    with_initial_velocities,
)
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _
from ramanujan.validation import positive

MOST_POINTS = 10**7
"""The most times that a record may hold; with all its series it then takes some gigabytes."""


@dataclass(frozen=True)
class Record:
    """A motion at the times t: arrays in SI units, right positive, with the keys of the functions they come from.

    Only X, Ẋ and the momentum p_X are positive to the LEFT, as in the paper.
    `body_momenta` are m v of each body relative to the ground [kg·m/s].
    """

    oscillator: Oscillator
    compression: float
    initial: InitialState
    spacing: float
    t: NDArray[np.float64]
    q: NDArray[np.float64]
    q_dot: NDArray[np.float64]
    over_ground: dict[str, NDArray[np.float64]]
    over_block: dict[str, NDArray[np.float64]]
    velocity_over_ground: dict[str, NDArray[np.float64]]
    velocity_over_block: dict[str, NDArray[np.float64]]
    energies: dict[str, NDArray[np.float64]]
    body_momenta: dict[str, NDArray[np.float64]]
    momenta: dict[str, NDArray[np.float64]]
    forces: dict[str, NDArray[np.float64]]
    normal_forces: dict[str, NDArray[np.float64]]

    @property
    def total_energy(self) -> NDArray[np.float64]:
        """E [J], the sum of all energies."""
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
    """Return the motion after a release with a push, at equally spaced times, both ends included.

    Parameters
    ----------
    oscillator, compression, glide, spin : as in `with_initial_velocities`
    spacing : L, distance between the axes of hoop and lower cylinder [m]
    periods : how long, in periods of the machine
    points : number of times, from 2 on

    Returns
    -------
    the record; every series in it comes from one evaluation of the motion

    Raises
    ------
    ValueError : a value is not a finite number, periods is not positive, points is out of range, or the slab tips off
        its rollers.

    Source: `motion`, `energy` and `contact`, where each series is computed.

    >>> motion = record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5)
    >>> motion.q.shape
    (3, 5)
    """
    initial = with_initial_velocities(oscillator, compression, glide, spin)
    if not 2 <= points <= MOST_POINTS:
        raise ValueError(f"points must be an integer from 2 to {MOST_POINTS}, not {points}")
    t = np.linspace(0, positive("periods", periods) * oscillator.period, points)
    q, q_dot = motion(oscillator, initial, t)
    # The slab must stay on its rollers between the recorded times as well.
    widest = travel_amplitude(oscillator, initial) / oscillator.radius
    normal_forces(oscillator, (0.0, widest, 0.0), spacing=spacing)
    return Record(
        oscillator=oscillator,
        compression=float(compression),
        initial=initial,
        spacing=float(spacing),
        t=t,
        q=q,
        q_dot=q_dot,
        over_ground=ground_positions(oscillator, q),
        over_block=relative_positions(oscillator, q),
        velocity_over_ground=ground_velocities(oscillator, q_dot),
        velocity_over_block=relative_velocities(oscillator, q_dot),
        energies=energies(oscillator, q, q_dot),
        body_momenta=body_momenta(oscillator, q_dot),
        momenta=momenta(oscillator, q_dot),
        forces=contact_forces(oscillator, q),
        normal_forces=normal_forces(oscillator, q, spacing=spacing),
    )


def columns(motion: Record) -> dict[str, NDArray[np.float64]]:
    """Return every series of a record under a header with its unit, time first.

    Parameters
    ----------
    motion : the record

    Returns
    -------
    dict of header → series, each of shape (points,)

    >>> list(columns(record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5)))[:3]
    ['t [s]', 'X [m]', 'phi [rad]']
    """
    series = {"t [s]": motion.t}
    names = (("X", "m"), ("phi", "rad"), ("Phi", "rad"))
    series |= {f"{name} [{unit}]": row for (name, unit), row in zip(names, motion.q, strict=True)}
    series |= {f"{name}_dot [{unit}/s]": row for (name, unit), row in zip(names, motion.q_dot, strict=True)}
    groups = (
        ("{} relative to ground [m]", motion.over_ground),
        ("{} relative to block [m]", motion.over_block),
        ("velocity of {} relative to ground [m/s]", motion.velocity_over_ground),
        ("velocity of {} relative to block [m/s]", motion.velocity_over_block),
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
    friction_coefficient : μ; the comments state the largest x₀ at which no contact slips with it

    Returns
    -------
    the table as text; its first line says how many lines numpy has to skip:
    `numpy.loadtxt(file, delimiter=",", skiprows=…)`

    Raises
    ------
    ValueError : the coefficient is not positive.

    >>> text = table(record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5), 0.3)
    >>> text.splitlines()[2]
    '# m = 1.0 kg'
    """
    oscillator, initial = motion.oscillator, motion.initial
    needed = required_friction(oscillator, motion.compression, spacing=motion.spacing)
    largest = largest_compression(oscillator, friction_coefficient, spacing=motion.spacing)
    # TRANSLATORS: in a file; {contact} is a name from the program such as hoop_slab.
    friction = _("friction coefficient needed by {contact}")
    parameters = (
        ("m", oscillator.m, "kg"),
        ("m_prime", oscillator.m_prime, "kg"),
        ("k", oscillator.k, "N/m"),
        ("R", oscillator.radius, "m"),
        (_("compression"), motion.compression, "m"),
        (_("X_dot at release"), initial.X_dot, "m/s"),
        (_("Phi_dot at release"), initial.Phi_dot, "rad/s"),
        ("Omega", oscillator.natural_frequency, "rad/s"),
        (_("spacing of the lower rollers"), motion.spacing, "m"),
        ("mu", friction_coefficient, ""),
        (_("largest compression without slip"), largest, "m"),
        *((friction.format(contact=contact), value, "") for contact, value in needed.items()),
    )
    title = _("Ramanujan’s oscillator in SI units: positive to the right. X, X_dot and p_X are positive to the left.")
    advice = _("numbers begin after {n} lines; numpy.loadtxt takes that number as skiprows")
    comments = [title, *(f"{name} = {float(value)!r} {unit}".rstrip() for name, value, unit in parameters)]
    series, text = columns(motion), io.StringIO()
    # A comment is plain text. The writer would put quotation marks around one with a comma.
    text.writelines(f"# {comment}\n" for comment in (advice.format(n=len(comments) + 2), *comments))
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(series)
    writer.writerows(zip(*(values.tolist() for values in series.values()), strict=True))
    return text.getvalue()
