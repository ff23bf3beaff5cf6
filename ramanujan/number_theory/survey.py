"""All 40 machines that four kinds of bodies make, and those that are one body away from the paper’s."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import combinations_with_replacement

from ramanujan.number_theory.bodies import BODIES, BodyChoice


def machines(target: int | Fraction = 1) -> list[BodyChoice]:
    """Return all 40 machines: each unordered pair of lower rollers with each top body, in the order of BODIES.

    Parameters
    ----------
    target : w = Ω²m/k, dimensionless

    Returns
    -------
    the machines

    Raises
    ------
    ValueError : the target is not an exact number that all 40 machines can reach.

    >>> sorted(machine.discriminant for machine in machines() if machine.cubes)
    [1064, 1729, 5896]
    """
    pairs = combinations_with_replacement(BODIES, 2)
    return [BodyChoice(left, right, top, target) for left, right in pairs for top in BODIES]


def one_change_away() -> list[BodyChoice]:
    """Return the nine of the 40 machines that differ from the paper's in exactly one body.

    Returns
    -------
    the machines, in the order of `machines`

    >>> len(one_change_away())
    9
    """
    paper = BodyChoice()
    return [machine for machine in machines() if _bodies_changed(machine, paper) == 1]


def _bodies_changed(one: BodyChoice, other: BodyChoice) -> int:
    """Return how many bodies must be exchanged to turn one machine into the other; lower rollers have no order."""
    lower = Counter([one.left, one.right]) - Counter([other.left, other.right])
    return lower.total() + (one.top != other.top)
