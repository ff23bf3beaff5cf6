"""The caches of page 5: the results of its experiments, once for all visitors of this server.

Errors and evaluations of a method are the same for every machine (`accuracy.runs`). Therefore the cache keys omit m, m′
and k. Streamlit computes a result once, also if several visitors request it at the same time.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.choices import (
    ClosedForm,
    measure_arithmetics,
    measure_caching,
    measure_chord_errors,
    measure_closed_form,
    seconds_per_reduction,
)
from ramanujan.accuracy.extremes import Sweep, sweep_forms
from ramanujan.accuracy.general_solvers import EigenSweep, sweep_solvers
from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.phase import PhaseErrors, phase_errors
from ramanujan.accuracy.runs import error_history, seconds_per_step
from ramanujan.accuracy.work_precision import DTYPES, WorkPrecision, work_precision
from ramanujan.figures import MASS_RATIO, EncodedFigure
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.lesson import answer_tasks
from ramanujan.pages.speed import downsampling
from ramanujan.pages.speed.downsampling import SampledRun
from ramanujan.shell.cache import responsive
from ramanujan.translation import _


class SweepVariable(NamedTuple):
    """The variable of a sweep: its symbol, and the title of its axis."""

    symbol: str
    title: str


SWEEP_VARIABLES = {
    "ratio": SweepVariable(
        "ε", _("{mass_ratio}, with <i>m</i> = 1 kg and <i>k</i> = 1 N/m").format(mass_ratio=MASS_RATIO)
    ),
    "scale": SweepVariable("s", _("scale <i>s</i> = <i>m</i>/kg = <i>m</i>′/kg = <i>k</i>/(N/m)")),
}
"""Name of a sweep → its variable."""

PERIODS = (1, 3, 10, 30, 100, 300)
"""The numbers of periods that a visitor can select."""
_CACHED_PERIODS = (1, 3, *range(10, PERIODS[-1] + 1, 10))
"""Checkpoints: the runs of a diagram are integrated and cached in parts that end after these numbers of periods.

Each part takes some tenths of a second.
"""

_CURVES = [(method, dtype) for dtype in DTYPES for method in METHODS]
"""The curves of a work-precision diagram."""

_WORK, _PAUSE = 0.03, 0.015
"""Duration of a stretch of work, and of the pause for other visitors after it [s]."""
_MEASURING = threading.Lock()
"""Lock of the time measurements, because two simultaneous measurements would disturb each other."""


@st.cache_resource(show_spinner=False, max_entries=512)
@responsive()
def run(method: str, steps: int, periods: int, dtype: str) -> SampledRun:
    """Return one integration. It is the same for every machine."""
    return downsampling.downsample(error_history(method, steps, periods, dtype), steps, periods)


@st.cache_resource(show_spinner=_("Computing all methods …"), max_entries=1)
@responsive()
def races() -> tuple[WorkPrecision, ...]:
    """Return the runs of all methods in the challenge."""
    return answer_tasks.run_all_integrators()


def parts_of_diagram(periods: int) -> list[Callable[[], object]]:
    """Return functions without arguments that fill the caches of a diagram part by part: first errors, then times."""
    parts: list[Callable[[], object]] = []
    for method, dtype in _CURVES:
        parts += [partial(errors, method, dtype, part) for part in _CACHED_PERIODS if part <= periods]
    parts.append(partial(closed_form, periods))
    parts += [partial(_step_seconds, method, dtype) for method, dtype in _CURVES]
    return parts


def diagram(periods: int) -> list[WorkPrecision]:
    """Return the curves of the work-precision diagram, with the last measured times."""
    return [replace(errors(*curve, periods), step_timing=_step_seconds(*curve)) for curve in _CURVES]


@st.cache_resource(show_spinner=False, max_entries=2 * len(METHODS) * len(_CACHED_PERIODS))
def errors(method: str, dtype: str, periods: int) -> WorkPrecision:
    """Return the runs of one method for a number of periods. They continue the cached runs with fewer periods."""
    shorter = max((part for part in _CACHED_PERIODS if part < periods), default=None)
    previous = None if shorter is None else errors(method, dtype, shorter)
    last_pause = time.monotonic()

    def pause_for_others() -> None:
        nonlocal last_pause
        if time.monotonic() - last_pause > _WORK:
            time.sleep(_PAUSE)
            last_pause = time.monotonic()

    with responsive():
        return work_precision(method, dtype, periods, previous=previous, after_block=pause_for_others)


@st.cache_resource(show_spinner=False, max_entries=2 * len(METHODS))
def _step_seconds(method: str, dtype: str) -> Timing:
    with _MEASURING:
        return seconds_per_step(method, dtype)


@st.cache_resource(show_spinner=False, max_entries=len(PERIODS))
def closed_form(periods: int) -> ClosedForm:
    """Return error and time [s] of the closed form."""
    with _MEASURING:
        return measure_closed_form(Oscillator(), [periods])[0]


def forget_seconds() -> None:
    """Clear the measured times. Errors and evaluations do not change."""
    _step_seconds.clear()
    closed_form.clear()


@st.cache_resource(show_spinner=_("Computing all powers of ten …"), max_entries=1)
@responsive()
def sweeps() -> tuple[list[Sweep], list[EigenSweep]]:
    """Return the errors of the forms of Ω², and of the eigen-solvers, over the range of floating point."""
    return sweep_forms(), sweep_solvers()


@dataclass(frozen=True)
class Choices:
    """Error and cost of the app's own methods, for the machine with m = m′ = 1 kg and k = 1 N/m.

    Parameters
    ----------
    states : states of the closed form after different numbers of periods
    reduction : time [s] for a phase from which whole turns are subtracted
    curves : curve → number of points → distance from the curve [pixels]
    arithmetics : kind of arithmetic → seconds for a value of Ω²
    speedups : result → the factor by which a cache makes it faster
    """

    states: list[ClosedForm]
    reduction: float
    curves: dict[str, dict[int, float]]
    arithmetics: dict[str | int, float]
    speedups: dict[str, float]


@st.cache_resource(show_spinner=_("Measuring what the app itself uses …"), max_entries=1)
def choices() -> Choices:
    """Measure the app's own methods, once for all visitors."""
    machine = Oscillator()
    with _MEASURING:
        return Choices(
            states=measure_closed_form(machine),
            reduction=seconds_per_reduction(machine),
            curves=measure_chord_errors(),
            arithmetics=measure_arithmetics(),
            speedups=measure_caching(machine),
        )


@st.cache_data(show_spinner=False, max_entries=64)
def phases(machine: Oscillator) -> list[PhaseErrors]:
    """Return the phase errors after 1 … 1e15 periods, which takes some hundredths of a second."""
    return phase_errors(machine)


@st.cache_resource(show_spinner=False, max_entries=64)
def phases_figure(machine: Oscillator, colors: dict[str, str]) -> EncodedFigure:
    """Return the figure of the phase errors in the given colours."""
    errors_by_periods = phases(machine)
    curves = {
        _("Ω·<i>t</i> in float32"): [entry.float32 for entry in errors_by_periods],
        _("Ω·<i>t</i> in float64"): [entry.float64 for entry in errors_by_periods],
        _("whole turns subtracted first"): [entry.reduced for entry in errors_by_periods],
    }
    return figures.draw_phase_errors([entry.periods for entry in errors_by_periods], curves, colors)
