"""The CSV file of page 3: the settings, then every series under a header in words."""

import math
from collections.abc import Iterable
from typing import TypeVar

import numpy as np

from ramanujan.pages.motion import cache
from ramanujan.physics.contact import largest_compression, required_friction
from ramanujan.physics.record import Record
from ramanujan.text.names import PARTS
from ramanujan.text.spreadsheet import DIGITS, Cell, numpy_call, spreadsheet
from ramanujan.text.translation import _

Value = TypeVar("Value")
_MOST_DECIMALS = 15


def sheet(motion: Record, friction_coefficient: float, settings: Iterable[tuple[str, float]]) -> str:
    """Return a record as a CSV file for spreadsheets; its first row is the line by which NumPy reads the numbers.

    Parameters
    ----------
    motion : the record
    friction_coefficient : μ
    settings : labels with units, and values
    """
    series = columns(motion)
    values = zip(*(_without_noise(column).tolist() for column in series.values()), strict=True)
    title = _("Ramanujan’s oscillator in SI units: positive to the right. X, Ẋ and p_X are positive to the left.")
    rows = [[title], *settings, *_results(motion, friction_coefficient), [], list(series)]
    # The row with this advice is skipped, too.
    advice = _("In Python, this reads the numbers: {call}").format(call=numpy_call(len(rows) + 1))
    return spreadsheet([[advice], *rows, *values])


def _without_noise(values: np.ndarray) -> np.ndarray:
    """Return the values of a column without the digits that are rounding errors of its largest number.

    A column that should be zero has only rounding errors, below the last of at most 15 decimal places.
    """
    largest = float(np.max(np.abs(values)))
    power = math.floor(math.log10(largest)) if largest else 0
    # The sum with 0 turns −0 into 0.
    return np.round(values, min(DIGITS - 1 - power, _MOST_DECIMALS)) + 0.0


def columns(motion: Record) -> dict[str, np.ndarray]:
    """Return every series of a record under a header with its unit, time first."""
    series: dict[str, np.ndarray] = {"t [s]": motion.t}
    series |= dict(zip(("X [m]", "φ [rad]", "Φ [rad]"), motion.q, strict=True))
    series |= dict(zip(("Ẋ [m/s]", "φ̇ [rad/s]", "Φ̇ [rad/s]"), motion.q_dot, strict=True))
    energies = {cache.energy_name(key): values for key, values in motion.energies.items()}
    friction = dict(motion.forces)
    spring = friction.pop("spring")
    groups = (
        (_("displacement relative to the ground: {name} [m]"), _rename(PARTS, motion.ground_positions)),
        (_("displacement relative to the block: {name} [m]"), _rename(PARTS, motion.relative_positions)),
        (_("velocity relative to the ground: {name} [m/s]"), _rename(PARTS, motion.ground_velocities)),
        (_("velocity relative to the block: {name} [m/s]"), _rename(PARTS, motion.relative_velocities)),
        (_("energy: {name} [J]"), energies | {_("total energy"): motion.total_energy}),
        (_("momentum: {name} [kg·m/s]"), _rename(PARTS, motion.body_momenta)),
        (_("friction: {name} [N]"), _rename(cache.CONTACTS, friction)),
        (_("force: {name} [N]"), {PARTS["spring"]: spring}),
        (_("normal force: {name} [N]"), _rename(cache.CONTACTS, motion.normal_forces)),
    )
    for header, group in groups:
        series |= {header.format(name=name): values for name, values in group.items()}
    return series | {"p_X [kg·m/s]": motion.momenta["p_X"], "p_Φ [kg·m²/s]": motion.momenta["p_Phi"]}


def _results(motion: Record, friction_coefficient: float) -> list[tuple[str, Cell]]:
    """Return the results for the settings: labels with units, and values."""
    needed = required_friction(motion.oscillator, motion.compression, spacing=motion.spacing)
    largest = largest_compression(motion.oscillator, friction_coefficient, spacing=motion.spacing)
    contact = _("friction coefficient that this contact needs: {name}")
    return [
        (_("angular frequency, Ω [rad/s]"), motion.oscillator.natural_frequency),
        (_("period, T [s]"), motion.oscillator.period),
        (_("distance between the axes of the lower rollers [m]"), motion.spacing),
        (_("largest compression without slip [m]"), largest),
        *((contact.format(name=name), float(value)) for name, value in _rename(cache.CONTACTS, needed).items()),
    ]


def _rename(names: dict[str, str], values: dict[str, Value]) -> dict[str, Value]:
    """Return the values with each key replaced by its name in `names`."""
    return {names[key]: value for key, value in values.items()}
