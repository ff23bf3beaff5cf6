"""A record of one motion: positions, velocities, energies, momenta and forces on a uniform time grid, also as CSV.

This module collects and names the series. `motion`, `energy` and `contact` compute them. Format of the table:

    # m = 1.0 kg             a comment line for each parameter
    t [s],X [m],…            one header line with names and units
    0.0,0.04,…               one line for each time; numbers as Python's repr, so that NumPy reads the same doubles
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
    if not 2 <= points <= MOST_POINTS:
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


def columns(recorded: Record) -> dict[str, NDArray[np.float64]]:
    """Return every series of a record with its header, time first.

    Parameters
    ----------
    recorded : the record

    Returns
    -------
    header, a name with its unit → series of shape (points,)

    >>> list(columns(record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5)))[:3]
    ['t [s]', 'X [m]', 'phi [rad]']
    """
    series = {"t [s]": recorded.t}
    coordinates = (("X", "m"), ("phi", "rad"), ("Phi", "rad"))
    series |= {f"{name} [{unit}]": row for (name, unit), row in zip(coordinates, recorded.q, strict=True)}
    series |= {f"{name}_dot [{unit}/s]": row for (name, unit), row in zip(coordinates, recorded.q_dot, strict=True)}
    groups = (
        ("{} relative to ground [m]", recorded.ground_positions),
        ("{} relative to block [m]", recorded.relative_positions),
        ("velocity of {} relative to ground [m/s]", recorded.ground_velocities),
        ("velocity of {} relative to block [m/s]", recorded.relative_velocities),
        ("energy {} [J]", recorded.energies | {"total": recorded.total_energy}),
        ("momentum of {} [kg m/s]", recorded.body_momenta),
        ("force {} [N]", recorded.forces),
        ("normal force {} [N]", recorded.normal_forces),
    )
    for header, group in groups:
        series |= {header.format(name): values for name, values in group.items()}
    series["p_X [kg m/s]"] = recorded.momenta["p_X"]
    series["p_Phi [kg m2/s]"] = recorded.momenta["p_Phi"]
    return series


def table(recorded: Record, friction_coefficient: float) -> str:
    """Return a record as comma-separated values, in the format of the module docstring.

    Parameters
    ----------
    recorded : the record
    friction_coefficient : μ; one of the comments is the largest compression without slip for this μ

    Returns
    -------
    the table as text; its first line contains the value of skiprows for
    `numpy.loadtxt(file, delimiter=",", skiprows=…)`

    Raises
    ------
    ValueError : friction_coefficient is not positive.

    >>> text = table(record(Oscillator(), 0.08, spacing=0.29, periods=1, points=5), 0.3)
    >>> text.splitlines()[2]
    '# m = 1.0 kg'
    """
    comments = _comments(recorded, friction_coefficient)
    # The line with this advice and the header are skipped, too.
    advice = _("numbers begin after {n} lines; numpy.loadtxt takes that number as skiprows").format(n=len(comments) + 2)
    series = columns(recorded)
    text = io.StringIO()
    # The CSV writer would quote a comment that contains a comma, so it writes only the header and the numbers.
    text.writelines(f"# {comment}\n" for comment in (advice, *comments))
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(series)
    writer.writerows(zip(*(values.tolist() for values in series.values()), strict=True))
    return text.getvalue()


def _comments(recorded: Record, friction_coefficient: float) -> list[str]:
    """Return the title of a table, and one line "name = value unit" for each parameter."""
    oscillator, initial = recorded.oscillator, recorded.initial
    needed = required_friction(oscillator, recorded.compression, spacing=recorded.spacing)
    largest = largest_compression(oscillator, friction_coefficient, spacing=recorded.spacing)
    # TRANSLATORS: in a file; {contact} is a name from the program such as hoop_slab.
    friction = _("friction coefficient needed by {contact}")
    parameters = [
        ("m", oscillator.m, "kg"),
        ("m_prime", oscillator.m_prime, "kg"),
        ("k", oscillator.k, "N/m"),
        ("R", oscillator.radius, "m"),
        (_("compression"), recorded.compression, "m"),
        (_("X_dot at release"), initial.X_dot, "m/s"),
        (_("Phi_dot at release"), initial.Phi_dot, "rad/s"),
        ("Omega", oscillator.natural_frequency, "rad/s"),
        (_("spacing of the lower rollers"), recorded.spacing, "m"),
        ("mu", friction_coefficient, ""),
        (_("largest compression without slip"), largest, "m"),
    ]
    parameters += [(friction.format(contact=contact), value, "") for contact, value in needed.items()]
    title = _("Ramanujan’s oscillator in SI units: positive to the right. X, X_dot and p_X are positive to the left.")
    return [title, *(f"{name} = {float(value)!r} {unit}".rstrip() for name, value, unit in parameters)]
