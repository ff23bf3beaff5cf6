"""What page 5 keeps: what its experiments have found, by machine and settings, for all visitors of this server.

A record is made empty and filled in pieces while somebody looks at the page (`scenes.experiments`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy import (
    Piece,
    arithmetics,
    caching,
    closed_form,
    curve_sampling,
    eigen_solvers,
    error_history,
    extremes,
    phase_errors,
    work_precision,
)
from ramanujan.accuracy.phase import PhaseErrors
from ramanujan.accuracy.work_precision import History
from ramanujan.scenes.experiments import Record

SAMPLES_PER_PERIOD = 32
"""A run with more steps than that is thinned: straight pieces between so many points of a swing look round."""
BINS = 96
"""Points of an error curve: about as many as it has pixels to rise in."""


@dataclass(frozen=True, eq=False)
class Run:
    """One integration, thinned to what the screen shows.

    Parameters
    ----------
    method, dtype, steps, periods : how it was made
    per_period : samples in a period
    q : φ over its amplitude at the samples, the start included, shape (periods·per_period + 1,)
    reach : where each error curve has its points [periods], shape (bins,)
    phase, energy : the largest |phase error| [rad] and |energy error| since the point before, shape (bins,)
    phase_at_end, energy_at_end : the errors at the end, with their signs
    """

    method: str
    dtype: str
    steps: int
    periods: int
    per_period: int
    q: np.ndarray
    reach: np.ndarray
    phase: np.ndarray
    energy: np.ndarray
    phase_at_end: float
    energy_at_end: float


@st.cache_resource(show_spinner=False, max_entries=256)
def run(m: float, m_prime: float, k: float, method: str, steps: int, periods: int, dtype: str) -> Record[Run]:
    """Return what is known of one integration."""
    return Record()


@st.cache_resource(show_spinner=False, max_entries=64)
def diagram(m: float, m_prime: float, k: float, periods: int) -> Record:
    """Return the work-precision diagram that was measured here last, and the closed form's error and cost."""
    return Record()


@st.cache_resource(show_spinner=False, max_entries=1)
def sweeps() -> Record:
    """Return the forms of Ω² and the eigen-solvers over the range of floating point."""
    return Record()


@st.cache_resource(show_spinner=False, max_entries=1)
def choices() -> Record:
    """Return error and cost of what the app itself chooses, measured here last."""
    return Record()


@st.cache_data(show_spinner=False, max_entries=64)
def phases(m: float, m_prime: float, k: float) -> list[PhaseErrors]:
    """Return the phase errors after 1 … 1e15 periods; some hundredths of a second."""
    return [piece.result for piece in phase_errors(Oscillator(m=m, m_prime=m_prime, k=k))]


def run_pieces(oscillator: Oscillator, method: str, steps: int, periods: int, dtype: str) -> Iterator[Piece[Run]]:
    """Yield one integration in pieces, the last with its `Run`."""
    for piece in error_history(oscillator, method, steps, periods, dtype):
        yield Piece(piece.done, None if piece.result is None else _thinned(piece.result, steps, periods))


def diagram_pieces(oscillator: Oscillator, periods: int) -> Iterator[Piece]:
    """Yield the work-precision diagram in pieces, the closed form first."""
    exact = (Piece(0.0, piece.result) for piece in closed_form(oscillator, [periods]))
    return chain(exact, work_precision(oscillator, periods))


def sweep_pieces() -> Iterator[Piece]:
    """Yield the sweeps to the extremes in pieces."""
    return _one_after_another([extremes(), eigen_solvers()])


def choice_pieces() -> Iterator[Piece]:
    """Yield the app's own choices in pieces, for the machine with m = m′ = 1 kg and k = 1 N/m."""
    machine = Oscillator()
    return _one_after_another([closed_form(machine), curve_sampling(), arithmetics(), caching(machine)])


def _one_after_another(experiments: list[Iterator[Piece]]) -> Iterator[Piece]:
    for number, experiment in enumerate(experiments):
        for piece in experiment:
            yield Piece((number + piece.done) / len(experiments), piece.result)


def _thinned(history: History, steps: int, periods: int) -> Run:
    every = next(n for n in range(-(-steps // SAMPLES_PER_PERIOD), steps + 1) if steps % n == 0)
    # Each bin ends at a step; equal ratios of their ends show how an error grows.
    ends = np.unique(np.rint(np.geomspace(1, steps * periods, BINS)).astype(int))
    starts = np.r_[1, ends[:-1] + 1]
    with np.errstate(over="ignore"):
        q = history.q[::every].astype(np.float32)
    return Run(
        method=history.method,
        dtype=history.dtype,
        steps=steps,
        periods=periods,
        per_period=steps // every,
        q=q,
        reach=(ends / steps).astype(np.float32),
        phase=np.maximum.reduceat(np.abs(history.phase_error), starts),
        energy=np.maximum.reduceat(np.abs(history.energy_error), starts),
        phase_at_end=float(history.phase_error[-1]),
        energy_at_end=float(history.energy_error[-1]),
    )
