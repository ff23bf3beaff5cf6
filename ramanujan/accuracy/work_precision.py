"""The work–precision diagram: error against cost of every integrator, and the cheapest run for a tolerance.

The errors are those of `runs`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.progress import Piece, float_type
from ramanujan.accuracy.runs import LONGEST_RUN, blocks, errors, method_named, seconds_per_step, steps_within
from ramanujan.integrators import METHODS, Method
from ramanujan.numerals import quantity
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _
from ramanujan.validation import instance, integer, one_of, positive, sequence

STEPS_PER_PERIOD: tuple[int, ...] = tuple(int(n) for n in np.rint(np.geomspace(6, 192, 12)))
DTYPES = ("float32", "float64")


@dataclass(frozen=True, eq=False)
class WorkPrecision:
    """Error and cost of one method in one dtype after `periods` periods; each array has one element per run.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    periods : length of every run, in periods of the machine
    steps_per_period : n, so that h = T/n
    state_error, phase_error, energy_error : see `runs`; NaN or ∞ where the run left the range
    largest_energy_error : the largest |energy error| at any step of the run
    evaluations : evaluations of the acceleration until the run ended, counted one by one
    seconds, seconds_low, seconds_high : the run's steps times the measured seconds per step: median and quartiles
    """

    method: str
    dtype: str
    periods: int
    steps_per_period: np.ndarray
    state_error: np.ndarray
    phase_error: np.ndarray
    energy_error: np.ndarray
    largest_energy_error: np.ndarray
    evaluations: np.ndarray
    seconds: np.ndarray
    seconds_low: np.ndarray
    seconds_high: np.ndarray


@dataclass(frozen=True)
class Choice:
    """One run within a tolerance: method, precision, step size, state error and cost."""

    method: str
    dtype: str
    steps_per_period: int
    state_error: float
    evaluations: int
    seconds: float


def work_precision(
    oscillator: Oscillator,
    periods: int = 100,
    steps_per_period: Sequence[int] = STEPS_PER_PERIOD,
    methods: Iterable[str] = tuple(METHODS),
    dtypes: Iterable[str] = DTYPES,
) -> Iterator[Piece[WorkPrecision]]:
    """Return an iterator over the work-precision diagram: one `WorkPrecision` per method and dtype.

    All runs of one method are one array program: they step together until the longest has ended.

    Parameters
    ----------
    oscillator : the machine
    periods : length of a run [periods], whole
    steps_per_period : n of every run, whole numbers from 3 on, so that a step turns less than half a circle
    methods, dtypes : names in METHODS; "float32", "float64"

    Returns
    -------
    iterator over pieces of work, some of which carry a `WorkPrecision`

    Raises
    ------
    ValueError : an argument is outside its range, Ω² outside that of a dtype, or a run would take more than LONGEST_RUN
        steps.

    >>> pieces = work_precision(Oscillator(), 10, [20], ["velocity_verlet"], ["float64"])
    >>> [curve] = [piece.result for piece in pieces if piece.result]
    >>> curve.evaluations
    array([201])
    """
    instance("oscillator", oscillator, Oscillator)
    periods = integer("periods", periods, 1, LONGEST_RUN // 3)
    steps = np.unique([steps_within(n, periods) for n in sequence("steps_per_period", steps_per_period)])
    if steps.size == 0:
        raise ValueError(_("steps_per_period must not be empty"))
    chosen = [(name, method_named("methods", name)) for name in sequence("methods", methods)]
    kinds = [(name, float_type("dtypes", name)) for name in sequence("dtypes", dtypes)]
    squared = oscillator.natural_frequency_squared
    for name, kind in kinds:
        if not float(np.finfo(kind).tiny) <= squared <= float(np.finfo(kind).max):
            sentence = _("oscillator has Ω² = {squared}, which {dtype} cannot hold")
            raise ValueError(sentence.format(squared=quantity(squared, "s⁻²", 3), dtype=name))
    return _diagram(oscillator, periods, steps, chosen, kinds)


def cheapest(curves: Iterable[WorkPrecision], tolerance: float, by: str = "evaluations") -> list[Choice]:
    """Return the cheapest run of each curve whose state and phase errors are within the tolerance, in order of cost.

    Parameters
    ----------
    curves : results of `work_precision`
    tolerance : largest allowed state error, relative to the amplitude, and phase error [rad]
    by : the cost that counts, "evaluations" or "seconds"

    Returns
    -------
    at most one choice for each curve; a curve without such a run has none

    Raises
    ------
    ValueError : curves are not results of `work_precision`, the tolerance is not a finite positive number, or the cost
        has another name.

    >>> pieces = work_precision(Oscillator(), 10, [20, 100], ["rk4"], ["float64"])
    >>> [choice] = cheapest([piece.result for piece in pieces if piece.result], tolerance=1e-3)
    >>> choice.steps_per_period
    100
    """
    one_of("by", by, ("evaluations", "seconds"))
    tolerance = positive("tolerance", tolerance)
    curves = [instance("curves", curve, WorkPrecision) for curve in sequence("curves", curves)]
    found = [choice for curve in curves if (choice := _cheapest_run(curve, tolerance))]
    return sorted(found, key=lambda choice: getattr(choice, by))


def _cheapest_run(curve: WorkPrecision, tolerance: float) -> Choice | None:
    """Return the run with the fewest steps within the tolerance; a NaN is within none."""
    # A run that is late by a whole turn is in the right state by chance; its phase error shows it.
    good = np.flatnonzero((curve.state_error <= tolerance) & (np.abs(curve.phase_error) <= tolerance))
    if good.size == 0:
        return None
    run = good[np.argmin(curve.steps_per_period[good])]
    return Choice(
        curve.method,
        curve.dtype,
        int(curve.steps_per_period[run]),
        float(curve.state_error[run]),
        int(curve.evaluations[run]),
        float(curve.seconds[run]),
    )


def _diagram(
    oscillator: Oscillator,
    periods: int,
    steps: np.ndarray,
    methods: list[tuple[str, Method]],
    kinds: list[tuple[str, type[np.floating]]],
) -> Iterator[Piece[WorkPrecision]]:
    work = sum(method.evaluations for _name, method in methods) * len(kinds)
    finished = 0
    for dtype, kind in kinds:
        for name, method in methods:
            phase, energy, largest = np.zeros((3, steps.size))
            state, evaluations = np.zeros(steps.size), np.zeros(steps.size, int)
            for number, s, so_far in blocks(oscillator, method, kind, steps, periods):
                running = slice(steps.size - s.shape[1], None)
                phases, energies = errors(number, s, steps[running], phase[running])
                phase[running], energy[running], state[running] = phases[-1], energies[-1], np.abs(s[-1] - 1)
                evaluations[running] = so_far
                largest[running] = np.maximum(largest[running], np.abs(energies).max(axis=0))
                yield Piece((finished + method.evaluations * number[-1] / (steps[-1] * periods)) / work)
            finished += method.evaluations
            timing = seconds_per_step(oscillator, method, kind)
            total = steps * periods
            yield Piece(
                finished / work,
                WorkPrecision(
                    method=name,
                    dtype=dtype,
                    periods=periods,
                    steps_per_period=steps,
                    state_error=state,
                    phase_error=phase,
                    energy_error=energy,
                    largest_energy_error=largest,
                    evaluations=evaluations,
                    seconds=total * timing.median,
                    seconds_low=total * timing.low,
                    seconds_high=total * timing.high,
                ),
            )
