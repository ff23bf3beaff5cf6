"""The integrators on the machine's oscillating mode: error against cost, and the growth of the error.

This module computes the work–precision diagram, the history of one run, and the cheapest run for a tolerance.

Only the oscillating mode φ″ = −Ω²φ is integrated. X and Φ are each a steady drift, which every method here follows
exactly, plus a multiple of φ. A run starts at φ = 1, φ′ = 0 and lasts a whole number of periods T, so that the exact
final state is the initial one. With s = (φ, φ′/Ω), all errors are relative to the amplitude 1:

    state error    |s − s_exact|
    phase error    angle of s_exact against s, unwrapped [rad]; positive where the run is ahead
    energy error   |s|² − 1
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ramanujan.accuracy.progress import Piece, Timing, float_type, measure
from ramanujan.integrators import METHODS, Acceleration, Method, Runs, trajectory
from ramanujan.oscillator import Oscillator
from ramanujan.quantities import instance, integer, one_of, positive, sequence
from ramanujan.words import _

STEPS_PER_PERIOD: tuple[int, ...] = tuple(int(n) for n in np.rint(np.geomspace(6, 192, 12)))
DTYPES = ("float32", "float64")
LONGEST_RUN = 10_000_000
"""The most steps of one run; at some microseconds a step they take minutes."""

_BLOCK = 256
"""Steps between two reports, some hundredths of a second of work."""


@dataclass(frozen=True, eq=False)
class WorkPrecision:
    """Error and cost of one method in one dtype after `periods` periods; each array has one element per run.

    Parameters
    ----------
    method, dtype : name in METHODS; "float32" or "float64"
    periods : length of every run, in periods of the machine
    steps_per_period : n, so that h = T/n
    state_error, phase_error, energy_error : see the module docstring; NaN or ∞ where the run left the range
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


@dataclass(frozen=True, eq=False)
class History:
    """One run and the exact motion; each array has one element per recorded step, the start included.

    t [s]; q and q_exact, φ over its amplitude; phase_error [rad] and energy_error as in the module docstring;
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
    ValueError : an argument is outside its range, or a run would take more than LONGEST_RUN steps.

    >>> pieces = work_precision(Oscillator(), 10, [20], ["velocity_verlet"], ["float64"])
    >>> [curve] = [piece.result for piece in pieces if piece.result]
    >>> curve.evaluations
    array([201])
    """
    instance("oscillator", oscillator, Oscillator)
    periods = integer("periods", periods, 1, LONGEST_RUN // 3)
    steps = np.unique([_steps(n, periods) for n in sequence("steps_per_period", steps_per_period)])
    if steps.size == 0:
        raise ValueError(_("steps_per_period must not be empty"))
    chosen = [(name, _method("methods", name)) for name in sequence("methods", methods)]
    kinds = [(name, float_type("dtypes", name)) for name in sequence("dtypes", dtypes)]
    return _diagram(oscillator, periods, steps, chosen, kinds)


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
    n = _steps(steps_per_period, periods)
    every = integer("every", every, 1, n * periods)
    return _history(
        oscillator, (method, _method("method", method)), n, periods, (dtype, float_type("dtype", dtype)), every
    )


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
            for number, s, so_far in _blocks(oscillator, method, kind, steps, periods):
                running = slice(steps.size - s.shape[1], None)
                phases, energies = _errors(number, s, steps[running], phase[running])
                phase[running], energy[running], state[running] = phases[-1], energies[-1], np.abs(s[-1] - 1)
                evaluations[running] = so_far
                largest[running] = np.maximum(largest[running], np.abs(energies).max(axis=0))
                yield Piece((finished + method.evaluations * number[-1] / (steps[-1] * periods)) / work)
            finished += method.evaluations
            timing = _seconds_per_step(oscillator, method, kind)
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
    for number, s, evaluations in _blocks(oscillator, named_method[1], named_kind[1], steps, periods):  # noqa: B007
        phase_block, energy_block = _errors(number, s, steps, phase)
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
            q_exact=_exact(number, steps)[:, 0].real,
            phase_error=np.concatenate(phases),
            energy_error=np.concatenate(energies),
            evaluations=evaluations,
        ),
    )


def _blocks(
    oscillator: Oscillator, method: Method, kind: type[np.floating], steps: np.ndarray, periods: int
) -> Iterator[tuple[np.ndarray, np.ndarray, int]]:
    """Yield blocks of steps: their numbers (rows,), the states s = φ − iφ′/Ω, complex, shape (rows, runs still under
    way), and how often the acceleration has been evaluated so far.

    `steps` ascends. A block ends where the shortest run under way ends: its last row is that run's final state.
    """
    omega = oscillator.natural_frequency
    harmonic, evaluations = _harmonic(oscillator, kind), 0

    def acceleration(q: Runs) -> Runs:
        nonlocal evaluations
        evaluations += 1
        return harmonic(q)

    with np.errstate(over="ignore"):
        h = (oscillator.period / steps).astype(kind)
    states = trajectory(method, acceleration, np.ones(steps.size, kind), np.zeros(steps.size, kind), h)
    done = 0
    for ended, total in enumerate((steps * periods).tolist()):
        while done < total:
            rows = min(_BLOCK, total - done)
            s = np.empty((rows, steps.size - ended), complex)
            # A run whose values grow beyond float64 is a result here, not a fault.
            with np.errstate(over="ignore", invalid="ignore"):
                for row in range(rows):
                    q, v = next(states)
                    s.real[row], s.imag[row] = q[ended:], v[ended:]
                s.imag /= -omega
            yield np.arange(done + 1, done + rows + 1), s, evaluations
            done += rows


def _errors(
    number: np.ndarray, s: np.ndarray, steps: np.ndarray, phase_before: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return phase and energy error of a block, each (rows, runs); the phase error goes on from the row before."""
    with np.errstate(over="ignore", invalid="ignore"):
        # The error is unwrapped, not the phase: it moves by less than half a turn a step and keeps its last digits.
        angle = np.angle(s * _exact(number, steps).conj())
        phase = np.unwrap(np.concatenate([phase_before[None], angle]), axis=0)[1:]
        return phase, s.real**2 + s.imag**2 - 1


def _exact(number: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """Return s = e^{iΩt} at t = number·T/steps, shape (rows, runs); whole turns are taken off as integers."""
    return np.exp(2j * np.pi * (number[:, None] % steps) / steps)


def _harmonic(oscillator: Oscillator, kind: type[np.floating]) -> Acceleration:
    """Return a(φ) = −Ω²φ in the given dtype."""
    with np.errstate(over="ignore"):
        minus_omega_squared = kind(-oscillator.natural_frequency_squared)
    return lambda q: minus_omega_squared * q


def _seconds_per_step(oscillator: Oscillator, method: Method, kind: type[np.floating]) -> Timing:
    """Measure a step of a single run, by itself."""
    acceleration = _harmonic(oscillator, kind)
    q, v = np.ones(1, kind), np.zeros(1, kind)
    states = trajectory(method, acceleration, q, v, oscillator.period / 100)
    # Explicit Euler overflows during a long timing; its speed stays the same.
    with np.errstate(over="ignore", invalid="ignore"):
        return measure(lambda: next(states))


def _method(parameter: str, name: object) -> Method:
    """Return the method of that name, or raise ValueError with the names that exist."""
    return METHODS[one_of(parameter, name, METHODS)]


def _steps(n: object, periods: int) -> int:
    """Return n steps per period as an int from 3 on, or raise ValueError."""
    return integer("steps_per_period", n, 3, LONGEST_RUN // periods)
