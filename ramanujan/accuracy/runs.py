"""Runs of the integrators on the machine's oscillating mode, block by block, and their errors.

Only the oscillating mode φ″ = −Ω²φ is integrated. X and Φ are each a steady drift, which every method here follows
exactly, plus a multiple of φ. A run starts at φ = 1, φ′ = 0 and lasts a whole number of periods T, so that the exact
final state is the initial one. With s = (φ, φ′/Ω), all errors are relative to the amplitude 1:

    state error    |s − s_exact|
    phase error    angle of s_exact against s, unwrapped [rad]; positive where the run is ahead
    energy error   |s|² − 1
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ramanujan.accuracy.progress import Timing, measure
from ramanujan.integrators import METHODS, Acceleration, Method, Runs, trajectory
from ramanujan.oscillator import Oscillator
from ramanujan.validation import integer, one_of

LONGEST_RUN = 10_000_000
"""The most steps of one run; at some microseconds a step they take minutes."""

_BLOCK = 256
"""Steps between two reports, some hundredths of a second of work."""


def blocks(
    oscillator: Oscillator, method: Method, kind: type[np.floating], steps: np.ndarray, periods: int
) -> Iterator[tuple[np.ndarray, np.ndarray, int]]:
    """Yield blocks of steps: their numbers (rows,), the states s = φ − iφ′/Ω, complex, shape (rows, runs still under
    way), and how often the acceleration has been evaluated so far.

    `steps` ascends. A block ends where the shortest run under way ends: its last row is that run's final state.

    >>> for number, s, evaluations in blocks(Oscillator(), METHODS["rk4"], np.float64, np.array([10, 20]), 1):
    ...     print(number[-1], s.shape, evaluations)
    10 (10, 2) 40
    20 (10, 1) 80
    """
    omega = oscillator.natural_frequency
    harmonic, evaluations = _harmonic(oscillator, kind), 0

    def acceleration(q: Runs) -> Runs:
        nonlocal evaluations
        evaluations += 1
        return harmonic(q)

    with np.errstate(over="ignore"):
        h = (oscillator.period / steps).astype(kind)
    q, v = np.ones(steps.size, kind), np.zeros(steps.size, kind)
    # Plain floats give the very bits of arrays of one float64, in a fifth of the time.
    alone = steps.size == 1 and kind is np.float64
    states = trajectory(method, acceleration, *(x.item() if alone else x for x in (q, v, h)))
    done = 0
    for ended, total in enumerate((steps * periods).tolist()):
        while done < total:
            rows = min(_BLOCK, total - done)
            s = np.empty((rows, steps.size - ended), complex)
            # A run whose values grow beyond float64 is a result here, not a fault.
            with np.errstate(over="ignore", invalid="ignore"):
                for row in range(rows):
                    q, v = next(states)
                    s.real[row], s.imag[row] = (q, v) if alone else (q[ended:], v[ended:])
                s.imag /= -omega
            yield np.arange(done + 1, done + rows + 1), s, evaluations
            done += rows


def errors(
    number: np.ndarray, s: np.ndarray, steps: np.ndarray, phase_before: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return phase and energy error of a block, each (rows, runs); the phase error goes on from the row before.

    >>> errors(np.array([3]), np.array([[-2.0 + 0j]]), np.array([6]), np.zeros(1))[1]
    array([[3.]])
    """
    with np.errstate(over="ignore", invalid="ignore"):
        # The error is unwrapped, not the phase: it moves by less than half a turn a step and keeps its last digits.
        angle = np.angle(s * exact(number, steps).conj())
        phase = np.unwrap(np.concatenate([phase_before[None], angle]), axis=0)[1:]
        return phase, s.real**2 + s.imag**2 - 1


def exact(number: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """Return s = e^{iΩt} at t = number·T/steps, shape (rows, runs); whole turns are taken off as integers.

    >>> exact(np.array([6, 9]), np.array([6])).real
    array([[ 1.],
           [-1.]])
    """
    return np.exp(2j * np.pi * (number[:, None] % steps) / steps)


def seconds_per_step(oscillator: Oscillator, method: Method, kind: type[np.floating]) -> Timing:
    """Measure a step of a single run, by itself.

    >>> seconds_per_step(Oscillator(), METHODS["rk4"], np.float64).median > 0
    True
    """
    acceleration = _harmonic(oscillator, kind)
    q, v = np.ones(1, kind), np.zeros(1, kind)
    states = trajectory(method, acceleration, q, v, oscillator.period / 100)
    # Explicit Euler overflows during a long timing; its speed stays the same.
    with np.errstate(over="ignore", invalid="ignore"):
        return measure(lambda: next(states))


def method_named(parameter: str, name: object) -> Method:
    """Return the method of that name, or raise ValueError with the names that exist.

    >>> method_named("method", "rk4").order
    4
    """
    return METHODS[one_of(parameter, name, METHODS)]


def steps_within(n: object, periods: int) -> int:
    """Return n steps per period as an int from 3 on, or raise ValueError.

    >>> steps_within(np.int64(3), 10)
    3
    """
    return integer("steps_per_period", n, 3, LONGEST_RUN // periods)


def _harmonic(oscillator: Oscillator, kind: type[np.floating]) -> Acceleration:
    """Return a(φ) = −Ω²φ in the given dtype."""
    with np.errstate(over="ignore"):
        rounded = kind(-oscillator.natural_frequency_squared)
    minus_omega_squared = rounded.item() if kind is np.float64 else rounded
    return lambda q: minus_omega_squared * q
