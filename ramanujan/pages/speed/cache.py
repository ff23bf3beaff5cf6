"""What page 5 keeps: what its experiments have found, by machine and settings, for all visitors of this server.

A record is made empty and filled in pieces while somebody looks at the page (`experiments`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy import (
    Piece,
    arithmetics,
    caching,
    closed_form,
    curve_sampling,
    eigen_solvers,
    extremes,
    phase_errors,
    work_precision,
)
from ramanujan.accuracy.extremes import Sweep
from ramanujan.accuracy.phase import PhaseErrors
from ramanujan.figures import Drawn
from ramanujan.figures import speed as figures
from ramanujan.pages.speed import downsampling
from ramanujan.pages.speed.downsampling import Run
from ramanujan.pages.speed.experiments import Record
from ramanujan.translation import _


@dataclass(frozen=True)
class Along:
    """One of the sweeps: what is varied, in which precision, its symbol, and what the axis says."""

    along: str
    dtype: str
    symbol: str
    quantity: str


SWEEPS = {
    f"{along}_{dtype}": Along(along, dtype, symbol, quantity)
    for along, symbol, quantity in (
        ("ratio", "ε", _("mass ratio ε = m′/m, with m = 1 kg and k = 1 N/m")),
        ("scale", "s", _("scale s = m/kg = m′/kg = k/(N/m)")),
    )
    for dtype in ("float64", "float32")
}
"""The sweeps by their ids."""


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


@st.cache_resource(show_spinner=False, max_entries=2 * len(SWEEPS))
def forms_figure(name: str, colors: dict[str, str], _shown: Sequence[Sweep]) -> Drawn:
    """Return the figure of one of the SWEEPS in the given colours."""
    exponents, truth, curves = downsampling.sweep(_shown)
    return figures.forms(exponents, truth, curves, quantity=SWEEPS[name].quantity, colors=colors)


@st.cache_resource(show_spinner=False, max_entries=64)
def phases_figure(m: float, m_prime: float, k: float, colors: dict[str, str]) -> Drawn:
    """Return the figure of the phase errors in the given colours."""
    found = phases(m, m_prime, k)
    curves = {
        _("Ω·t in float32"): [p.float32 for p in found],
        _("Ω·t in float64"): [p.float64 for p in found],
        _("whole turns subtracted first"): [p.reduced for p in found],
    }
    return figures.phase_errors([p.periods for p in found], curves, colors)


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
    return _one_after_another(
        [
            closed_form(machine),
            curve_sampling(height=downsampling.FIGURE_HEIGHT),
            arithmetics(machine.mass_ratio),
            caching(machine),
        ]
    )


def _one_after_another(experiments: list[Iterator[Piece]]) -> Iterator[Piece]:
    for number, experiment in enumerate(experiments):
        for piece in experiment:
            yield Piece((number + piece.done) / len(experiments), piece.result)
