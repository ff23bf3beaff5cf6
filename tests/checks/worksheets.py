"""Worksheets: machines, keys and names."""

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.pages.worksheet import keys

MACHINES = [
    Oscillator(k=10.0),
    Oscillator(1.0, UNIT_MASS_RATIO, 10.0),
    Oscillator(1.1, 2.35, 33.5, 0.05),
    Oscillator(1.0, 5 / 6, 10.0),
]


def key_of(number: int) -> str:
    """Return a key for this number."""
    return f"{number:016x}"


def name_of(number: int) -> str:
    """Return the name of the sheet with the key for this number."""
    return keys.name(key_of(number))
