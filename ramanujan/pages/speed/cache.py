"""The caches of page 5: the results of its experiments, once for all visitors of this server.

Errors and evaluations of a method are the same for every machine (`accuracy.runs`). Therefore the cache keys omit m, m′
and k. Streamlit computes a result once, also if several visitors request it at the same time.
"""

import functools
import threading
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.arithmetics import Price, measure_arithmetics
from ramanujan.accuracy.digits import compare
from ramanujan.accuracy.extremes import Sweep, sweep_forms
from ramanujan.accuracy.general_solvers import EigenSweep, sweep_solvers
from ramanujan.accuracy.phase import PhaseErrors, phase_errors
from ramanujan.accuracy.runs import error_history, seconds_per_step
from ramanujan.accuracy.work_precision import (
    DTYPES,
    PERIODS,
    ClosedForm,
    WorkPrecision,
    diagram_curve,
    diagram_line,
    measure_closed_form,
)
from ramanujan.pages.speed import downsampling
from ramanujan.pages.speed.downsampling import SampledRun
from ramanujan.physics.integrators import METHODS
from ramanujan.shell.shared_cache import responsive
from ramanujan.text.translation import _

_CURVES = [(method, dtype) for dtype in DTYPES for method in METHODS]
"""The methods and precisions that are compared."""

_MEASURING = threading.Lock()
"""Lock of the time measurements, because two simultaneous measurements would disturb each other."""

_measure_step = functools.cache(seconds_per_step)
_measure_closed_form = functools.cache(measure_closed_form)
_measure_arithmetics = functools.cache(measure_arithmetics)

compare_digits = functools.cache(compare)


@st.cache_data(show_spinner=False, max_entries=512)
def run(method: str, steps: int) -> SampledRun:
    """Return one integration over the periods of the race. It is the same for every machine."""
    return downsampling.downsample(error_history(method, steps, PERIODS), steps, PERIODS)


def parts_of_diagram() -> list[Callable[[], object]]:
    """Return functions without arguments that fill the caches of the diagram part by part."""
    parts: list[Callable[[], object]] = [partial(_compute_curve, *curve) for curve in _CURVES]
    parts += [partial(_compute_line, method) for method in METHODS]
    parts += [partial(_step_seconds, *curve) for curve in _CURVES]
    return [*parts, closed_form]


def _compute_curve(method: str, dtype: str) -> None:
    with responsive():
        diagram_curve(method, dtype)


def _compute_line(method: str) -> None:
    with responsive():
        diagram_line(method)


def diagram() -> list[WorkPrecision]:
    """Return all runs of each method in each precision, with the last measured times."""
    return [replace(diagram_curve(*curve), step_seconds=_step_seconds(*curve)) for curve in _CURVES]


def diagram_lines() -> list[WorkPrecision]:
    """Return the line of each method in the work-precision diagram, with the last measured times."""
    return [replace(diagram_line(method), step_seconds=_step_seconds(method, "float64")) for method in METHODS]


def _step_seconds(method: str, dtype: str) -> float:
    with _MEASURING:
        return _measure_step(method, dtype)


def closed_form() -> ClosedForm:
    """Return error and time of the closed form after the periods of the diagram."""
    with _MEASURING:
        return _measure_closed_form()


def forget_seconds() -> None:
    """Clear the measured times. Errors and evaluations do not change."""
    _measure_step.cache_clear()
    _measure_closed_form.cache_clear()


@st.cache_resource(show_spinner=_("Computing all powers of ten …"), max_entries=1)
def sweeps() -> tuple[list[Sweep], list[EigenSweep]]:
    """Return the errors of the forms of Ω², and of the eigen-solvers, over the range of floating point."""
    return sweep_forms(), sweep_solvers()


def arithmetics() -> dict[str, Price]:
    """Return time and error of Ω² in several kinds of arithmetic, measured once for all visitors."""
    with _MEASURING:
        return _measure_arithmetics()


@st.cache_data(show_spinner=False, max_entries=64)
def phases(machine: Oscillator) -> list[PhaseErrors]:
    """Return the phase errors after 1 … 1e15 periods, which takes some hundredths of a second."""
    return phase_errors(machine)
