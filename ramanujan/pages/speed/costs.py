"""The section of page 5 on the cost of accuracy, which is measured on this server."""

from collections.abc import Callable

import streamlit as st

from ramanujan.accuracy.work_precision import PERIODS, Run, WorkPrecision, find_cheapest_runs
from ramanujan.browser.containers import container
from ramanujan.figures import speed_page as figures
from ramanujan.pages.speed import cache, challenge, verdicts
from ramanujan.physics.integrators import METHODS
from ramanujan.shell import address, drawings, sidebar, theme, widgets
from ramanujan.shell.display_mode import is_projector
from ramanujan.text.numerals import duration, number
from ramanujan.text.translation import _

COST = address.Choice("cost", {"evaluations": _("evaluations"), "seconds": _("seconds")}, "evaluations")
TOLERANCE = address.Choice("tolerance", {f"1e-{n}": number(10.0**-n, 1) for n in range(1, 9)}, "1e-2")
_QUESTION = _("Smaller steps cost more and err less: which method is the cheapest?")
"""The sentence above the diagram during its first measurement. The result replaces it."""
_COST_TITLES = {"evaluations": _("evaluations of the force"), "seconds": _("time on this server")}
_HOW_TO_READ = {
    "evaluations": _(
        "Each line is a method; further right, its steps are smaller. The first line to reach the dashed one, at the "
        "ring, is the cheapest. One evaluation computes the force of the spring once."
    ),
    "seconds": _(
        "Each line is a method; further right, its steps are smaller. The first line to reach the dashed one, at the "
        "ring, is the fastest."
    ),
}
_LIMITS = 1e-9, 1.0
"""The limits of the error axis, which contain the errors of all lines in the diagram [turns]."""

_COMPLETE = "speed_complete"
"""Session state: whether the diagram is complete."""


def draw_costs() -> Callable[[], None]:
    """Draw the fast part of the section; return a function that measures and draws the diagram."""
    if is_projector():
        st.header(_("What accuracy costs"), anchor=False)
    finding = st.container(key="topic_price").empty()
    if is_projector():
        figure, controls = st.columns([5, 2], gap="medium")
    else:
        # On a phone the diagram is above its controls, on a wide page beside them.
        row = container("columns", "costs")
        controls, figure = row.container(key="cost_controls"), row.container(key="place_costs")
    with controls:
        tolerance = float(widgets.select_slider(TOLERANCE, _("Largest error allowed [turns]")))
        st.caption(verdicts.describe_tolerance(tolerance, sidebar.compression()))
        by = widgets.segmented_control(COST, _("Cost"))
        if not is_projector():
            st.markdown(_HOW_TO_READ[by])
        attempt = st.container()

    def measure_and_draw() -> None:
        if not st.session_state.get(_COMPLETE):
            finding.markdown(_QUESTION)
        with figure:
            measure()
            finding.markdown(draw_diagram(by, tolerance))
        runs = find_tried_runs()
        if runs:
            attempt.markdown(verdicts.describe_tried_run(runs[-1], tolerance))

    return measure_and_draw


def measure() -> None:
    """Measure the missing parts of the diagram one by one, with a progress bar.

    If the visitor moves a slider or leaves the page, Streamlit interrupts the script. The cached parts remain.
    """
    if st.session_state.get(_COMPLETE):
        return
    title = _("Measuring {periods} periods on this server …").format(periods=PERIODS)
    bar = st.progress(0.0, title)
    parts = cache.parts_of_diagram()
    for done, part in enumerate(parts, start=1):
        part()
        bar.progress(done / len(parts), title)
    bar.empty()
    st.session_state[_COMPLETE] = True


def draw_diagram(by: str, tolerance: float) -> str:
    """Draw the work–precision diagram; return the sentence on the cheapest run.

    Parameters
    ----------
    by : kind of cost, an option of `COST`
    tolerance : error that the visitor allows [turns]
    """
    closed = cache.closed_form()
    ranked = find_cheapest_runs(_select_double_precision(), tolerance, by)
    sentence = verdicts.recommend_run(ranked, tolerance, by)
    marked_runs = {}
    write_cost = number if by == "evaluations" else duration
    if ranked:
        best = ranked[0]
        text = write_cost(getattr(best, by))
        marked_runs[_("cheapest")] = figures.MarkedRun(
            cost=getattr(best, by), error=best.error, symbol="circle-open", size=22, color="primary", cost_text=text
        )
    if by == "seconds":
        marked_runs[_("closed form")] = figures.MarkedRun(
            cost=closed.seconds, error=closed.error, symbol="star", size=15, color="ink", is_named=True
        )
    tried = find_tried_runs()
    if tried:
        last = tried[-1]
        marked_runs[_("your run")] = figures.MarkedRun(
            cost=getattr(last, by), error=last.error, symbol="diamond", size=15, color="ink"
        )
    chosen = METHODS[ranked[0].method].title if ranked else None
    diagram = figures.draw_work_precision(
        {
            METHODS[curve.method].title: (getattr(curve, by), curve.error, curve.steps_per_period)
            for curve in cache.diagram_lines()
        },
        chosen=chosen,
        titles=(_COST_TITLES[by], _("largest error [turns], at most ½")),
        limits=_LIMITS,
        tolerance=tolerance,
        marked_runs=marked_runs,
        tried=[(getattr(run, by), run.error) for run in tried[:-1]],
        write_cost=write_cost,
        colors=theme.colors(),
    )
    alternative = _("Work–precision diagram: the error of each method falls as its cost rises. {finding}")
    drawings.plot(diagram, "work_precision", alternative.format(finding=sentence.replace("**", "")))
    return sentence


def explain_measurement() -> None:
    """Explain the diagram, and offer to repeat the measurement of times."""
    sentence = _(
        "Each line joins runs of one method over {periods} periods. Along both axes, each grid line is 10 times the "
        "one before. Each run of your own in *Race* appears as ◆. The runs in the diagram compute with 16 digits. The "
        "table also lists runs with 7 digits."
    )
    st.markdown(sentence.format(periods=PERIODS))
    sentence = _(
        "The error is the largest angle between the hands, so it is at most half a turn; *Race* also counts whole "
        "turns. If the amplitude more than doubles, the run counts as half a turn off. Each time is the median of "
        "repeated runs on this server."
    )
    st.markdown(f"{sentence} {verdicts.describe_closed_form(cache.closed_form())}")
    st.button(_("Measure again"), key="measure", icon=":material/timer:", on_click=_forget_measurement)


def list_cheapest_runs() -> None:
    """Draw a table of the cheapest run of each method."""
    ranked = find_cheapest_runs(cache.diagram(), float(address.current(TOLERANCE)), address.current(COST))
    if ranked:
        widgets.table(verdicts.choice_table(ranked), "cheapest")
    else:
        st.markdown(_("No run has an error that small."))


def _forget_measurement() -> None:
    """Callback: measure the times again in the next run."""
    cache.forget_seconds()
    st.session_state.pop(_COMPLETE, None)


def find_tried_runs() -> list[Run]:
    """Return the runs that the visitor has tried in the challenge, the last one at the end."""
    tried = challenge.tried_runs()
    if not tried:
        return []
    by_method = {curve.method: curve for curve in _select_double_precision()}
    return [by_method[method].select(steps) for method, steps in tried]


def _select_double_precision() -> list[WorkPrecision]:
    """Return the runs with the numbers of the app, float64. The table also lists float32."""
    return [curve for curve in cache.diagram() if curve.dtype == "float64"]
