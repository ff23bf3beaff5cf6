"""The section of page 5 on the cost of accuracy, which is measured on this server on request."""

import time
from collections.abc import Callable

import numpy as np
import streamlit as st

from ramanujan.accuracy.work_precision import DTYPES, STEPS_PER_PERIOD, find_cheapest_runs
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.numerals import filled, number, percent
from ramanujan.pages.speed import cache, downsampling, verdicts
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.shell.display_mode import columns, is_projector
from ramanujan.translation import _, ngettext

COST = address.Choice("cost", {"evaluations": _("evaluations"), "seconds": _("seconds")}, "evaluations")
TOLERANCE = address.Choice("tolerance", {f"1e-{n}": number(10.0**-n, 1) for n in range(1, 16)}, "1e-3")
_COST_TITLES = {"evaluations": _("evaluations of the force"), "seconds": _("seconds on this server")}


_REQUESTED, _COMPLETE = "speed_requested", "speed_complete"
"""Session state: whether the visitor requested the diagram, and the number of periods for which it is complete."""
_PATIENCE = 0.2
"""Duration after which a progress bar appears [s]."""


def draw_costs(periods: int) -> Callable[[], None]:
    """Draw the fast part of the section; return a function that measures and draws the diagram."""
    st.header(_("What accuracy costs on this server"), anchor=False)
    is_requested = st.session_state.get(_REQUESTED, is_projector())  # A slide shows its diagram at once.
    by, tolerance = draw_controls(is_requested)
    if not is_requested:
        explain_measurement()
        return lambda: None
    container = st.container()

    def measure_and_draw() -> None:
        with container:
            measure(periods)
            draw_diagram(periods, by, tolerance)

    return measure_and_draw


def draw_controls(is_requested: bool) -> tuple[str, float]:
    """Draw the button and the options; return the kind of cost and the tolerated error."""
    with st.container(horizontal=True, vertical_alignment="bottom"):
        label = _("Measure again") if is_requested else _("Measure on this server")
        st.button(label, key="measure", icon=":material/timer:", type="primary", on_click=_request_measurement)
        by = widgets.segmented_control(COST, _("Cost"))
        return by, float(widgets.select_slider(TOLERANCE, _("Error that you allow"), width=320))


def _request_measurement() -> None:
    """Callback: request the diagram. A second request repeats the measurement of times."""
    if st.session_state.get(_REQUESTED):
        cache.forget_seconds()
    st.session_state[_REQUESTED] = True
    st.session_state.pop(_COMPLETE, None)


def measure(periods: int) -> None:
    """Measure the missing parts of the diagram one by one, with a progress bar.

    Streamlit interrupts the script at the next progress report if the visitor presses Stop, moves a slider or leaves.
    The cached parts remain.
    """
    if st.session_state.get(_COMPLETE) == periods:
        return
    place, start = st.empty(), time.monotonic()
    bar = None
    title = ngettext("Measuring {n} period on this server …", "Measuring {n} periods on this server …", periods)
    parts = cache.parts_of_diagram(periods)
    for done, part in enumerate(parts):
        if bar is None and time.monotonic() - start > _PATIENCE:
            with place.container(horizontal=True, vertical_alignment="bottom"):
                bar = st.empty()
                st.button(
                    _("Stop"), key="stop_measuring", on_click=st.session_state.update, args=({_REQUESTED: False},)
                )
        if bar is not None:
            bar.progress(done / len(parts), title.format(n=periods))
        part()
    place.empty()
    st.session_state[_COMPLETE] = periods


def draw_diagram(periods: int, by: str, tolerance: float) -> None:
    """Draw the work–precision diagram, the cheapest run, and how times and errors were measured.

    Parameters
    ----------
    periods : number of periods
    by : kind of cost, an option of `COST`
    tolerance : error that the visitor allows, relative to the amplitude
    """
    curves, closed = cache.diagram(periods), cache.closed_form(periods)
    ranked = find_cheapest_runs(curves, tolerance, by)
    sentence = verdicts.recommend_run(ranked, tolerance, by, closed)
    words, figure = columns("costs")
    with words:
        st.markdown(sentence)
    marked_runs = {}
    if ranked:
        best = ranked[0]
        marked_runs[_("cheapest")] = figures.MarkedRun(
            cost=getattr(best, by), error=best.error, symbol="circle-open", size=22, color="primary"
        )
    if by == "seconds":
        marked_runs[_("closed form")] = figures.MarkedRun(
            cost=closed.seconds.median, error=closed.phase_error, symbol="star", size=15, color="ink"
        )
    diagram = figures.draw_work_precision(
        {(METHODS[curve.method].title, curve.dtype): downsampling.costs(curve, by) for curve in curves},
        titles=(_COST_TITLES[by], _("largest error, relative to the amplitude")),
        tolerance=tolerance,
        marked_runs=marked_runs,
        colors=theme.colors(),
    )
    alternative = _("Work–precision diagram: the error of each method falls as its cost rises. {finding}")
    with figure:
        drawings.plot(diagram, "work_precision", alternative.format(finding=sentence.replace("**", "")))
    spread = float(np.median([curve.spread for curve in curves]))
    with words:
        explanation = verdicts.explain_slope(curves, cache.run)
        if explanation:
            st.markdown(explanation)
    if is_projector():
        return
    with words:
        st.caption(_describe_measurement(periods, spread))
    with st.expander(_("The cheapest run of each method")):
        if ranked:
            widgets.table(verdicts.choice_table(ranked), "cheapest")
        else:
            st.markdown(_("No run has an error that small."))


def _describe_measurement(periods: int, spread: float) -> str:
    """Return the caption of the diagram; `spread` is the typical width of the middle half of times."""
    points = ngettext(
        "Each point is the largest error in one period.",
        "Each point is the largest error in {n:word} periods.",
        periods,
    )
    times = _(
        "Errors and evaluations are the same for every machine. Solid: float64; dotted: float32. Times were measured "
        "on this server: each is the median of repeated runs, and half of these lie within a range of typically "
        "{spread} of the median."
    ).format(spread=percent(spread))
    return f"{filled(points, n=periods)} {times}"


def explain_measurement() -> None:
    """Explain the measurement that the button starts."""
    sentence = _(
        "Press the button: this server then runs {methods:word} methods in {precisions:word} precisions with {least} "
        "to {most} steps per period. Then choose the error that you allow."
    )
    least, most = STEPS_PER_PERIOD[0], STEPS_PER_PERIOD[-1]
    st.markdown(filled(sentence, methods=len(METHODS), precisions=len(DTYPES), least=least, most=most))
