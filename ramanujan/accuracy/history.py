"""The history of one run: the integrated motion beside the exact one, and both errors as they grow."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.progress import Piece, float_type
from ramanujan.accuracy.runs import LONGEST_RUN, blocks, errors, exact, method_named, steps_within
from ramanujan.integrators import Method
from ramanujan.oscillator import Oscillator
from ramanujan.validation import instance, integer


@dataclass(frozen=True, eq=False)
class History:
    """One run and the exact motion; each array has one element per recorded step, the start included.

    t [s]; q and q_exact, φ over its amplitude; phase_error [rad] and energy_error as in `runs`;
    evaluations : evaluations of the acceleration in the run, counted one by one
    """

    method: str
    dtype: str
    t: np.ndarray
    q: np.ndarray
    q_exact: np.ndarray
    phase_error: np.ndarray
    energy_error: np.ndarray
    evaluations: int


def error_history(
    oscillator: Oscillator, method: str, steps_per_period: int, periods: int, dtype: str = "float64", every: int = 1
) -> Iterator[Piece[History]]:
    """Return an iterator over one run; its last piece carries the `History`.

    Parameters
    ----------
    oscillator : the machine
    method : name in METHODS
    steps_per_period : n, so that h = T/n; at least 3
    periods : length of the run [periods], whole
    dtype : "float32" or "float64"
    every : a step is recorded when its number is a multiple of this

    Returns
    -------
    iterator over pieces of work

    Raises
    ------
    ValueError : an argument is outside its range.

    >>> *_, last = error_history(Oscillator(), "rk4", 20, 10)
    >>> last.result.evaluations
    800
    """
    instance("oscillator", oscillator, Oscillator)
    periods = integer("periods", periods, 1, LONGEST_RUN // 3)
    n = steps_within(steps_per_period, periods)
    every = integer("every", every, 1, n * periods)
    return _history(
        oscillator, (method, method_named("method", method)), n, periods, (dtype, float_type("dtype", dtype)), every
    )


def _history(
    oscillator: Oscillator,
    named_method: tuple[str, Method],
    n: int,
    periods: int,
    named_kind: tuple[str, type[np.floating]],
    every: int,
) -> Iterator[Piece[History]]:
    steps, phase = np.array([n]), np.zeros(1)
    numbers, states, phases, energies = [np.zeros(1, int)], [np.ones(1, complex)], [np.zeros(1)], [np.zeros(1)]
    evaluations = 0
    for number, s, evaluations in blocks(oscillator, named_method[1], named_kind[1], steps, periods):  # noqa: B007
        phase_block, energy_block = errors(number, s, steps, phase)
        phase = phase_block[-1]
        recorded = number % every == 0
        for record, block in ((states, s), (phases, phase_block), (energies, energy_block)):
            record.append(block[recorded, 0])
        numbers.append(number[recorded])
        yield Piece(number[-1] / (n * periods + 1))
    number = np.concatenate(numbers)
    yield Piece(
        1.0,
        History(
            method=named_method[0],
            dtype=named_kind[0],
            t=number * (oscillator.period / n),
            q=np.concatenate(states).real,
            q_exact=exact(number, steps)[:, 0].real,
            phase_error=np.concatenate(phases),
            energy_error=np.concatenate(energies),
            evaluations=evaluations,
        ),
    )
