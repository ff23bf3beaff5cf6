"""Page 5: the accuracy of the closed form and of integrators, and its cost, measured on the server of this page."""

import math
from functools import partial

import numpy as np
import streamlit as st

from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.numerals import filled
from ramanujan.pages.speed import cache, challenge, extremes, verdicts
from ramanujan.pages.speed.challenge import METHOD, STEPS, TRIES
from ramanujan.pages.speed.costs import COST, TOLERANCE, draw_costs
from ramanujan.pages.speed.downsampling import SampledRun
from ramanujan.pages.speed.extremes import SWEEP
from ramanujan.shell import address, display_mode, drawings, sidebar, theme, widgets
from ramanujan.shell.display_mode import columns, folded, slide
from ramanujan.translation import _

COMPARED = address.Choice("compare", {"own": _("your method"), "all": _("all methods")}, "own")
PERIODS = address.Choice("periods", cache.PERIODS, 30)
PRECISION = address.Choice("precision", ("float64", "float32"), "float64")
URL_PARAMETERS = (METHOD, STEPS, TRIES, COMPARED, PERIODS, PRECISION, COST, TOLERANCE, SWEEP)
FOLDED_PARAMETERS = ("compression",)


def show() -> None:
    """Draw the page. The measurement of costs, which takes long, begins last."""
    with slide("motion", _("Exact and computed")), st.container(key="race"):
        challenge.draw()
        if address.current(TRIES) and not display_mode.is_projector():
            challenge.draw_diagram()
    if address.current(TRIES) and display_mode.is_projector():
        with slide("tries", _("What was tried")):
            challenge.draw_diagram()
    with slide("errors", _("How the errors grow")):
        periods = draw_error_growth(address.current(METHOD), address.current(STEPS))
    with slide("costs", _("What accuracy costs")):
        measure_costs = draw_costs(periods)
    with slide("forms", _("Extreme values")):
        forms = extremes.draw_forms()
    if not display_mode.is_projector():
        with st.expander(_("Where each form fails, and the formulas")):
            extremes.list_failures(forms)
    with slide("periods", _("Very many periods")):
        extremes.draw_phase_errors(sidebar.oscillator())
    solver = _("A general eigen-solver, which does not know this machine")
    folded("solver", solver, extremes.explain_solvers, extremes.list_zero_modes)
    folded("choices", _("What this app uses, and why"), *extremes.CHOICES)
    # Long computations follow after all other elements are drawn.
    measure_costs()


def draw_error_growth(method: str, steps: int) -> int:
    """Draw how the errors of one method and the closed form, or of all methods, grow; return the number of periods."""
    st.header(_("How the errors grow"), anchor=False)
    words, place = columns("errors")
    with words:
        compared, periods, precision = widgets.draw_in_columns(
            [1.2, 1.2, 1] if display_mode.is_projector() else 1,
            partial(widgets.segmented_control, COMPARED, _("Show")),
            partial(widgets.select_slider, PERIODS, _("Number of periods")),
            partial(widgets.segmented_control, PRECISION, _("Precision")),
        )
    with place, st.skeleton(height=480):
        runs = [cache.run(name, steps, periods, precision) for name in METHODS if compared == "all" or name == method]
    run = cache.run(method, steps, periods, precision)
    phase_errors = cache.phases(sidebar.oscillator())
    # At least two points make a curve.
    shown_errors = [errors for errors in phase_errors if errors.periods <= max(periods, 10)]
    closed_form = (
        np.array([errors.periods for errors in shown_errors]),
        np.array([errors.float64 for errors in shown_errors]),
    )
    curves = {METHODS[run.method].title: (run.times, run.energy, run.phase) for run in runs}
    titles = [method.title for method in METHODS.values()]
    figure = figures.draw_error_growth(curves, METHODS[method].title, closed_form, titles, theme.colors())
    alternative = _(
        "Energy error and phase error over the number of periods. The phase errors of the methods grow with time. That "
        "of the closed form grows too, but it stays near the rounding error. {errors}"
    )
    with place:
        drawings.plot(figure, "growth", alternative.format(errors=" ".join(map(_describe_error, runs))))
    with words:
        st.markdown(verdicts.describe_errors(run))
        # A slide of the projector view has no room for the caption.
        if not display_mode.is_projector():
            st.caption(
                _(
                    "Each curve shows the largest error so far, and all methods take the same steps. Below its "
                    "stability limit a symplectic method keeps its energy error bounded, but its phase error grows "
                    "steadily. In the gray zone, where rounding errors are, each power of ten takes an eighth of its "
                    "usual height."
                )
            )
    return periods


def _describe_error(run: SampledRun) -> str:
    """State the error of a run at its end."""
    worst = float(np.max(run.energy))
    if not (math.isfinite(run.phase_at_end) and math.isfinite(worst)):
        sentence = _("{method}: the energy has grown beyond the largest floating-point number.")
        return sentence.format(method=METHODS[run.method].title)
    sentence = _("{method}: phase error {phase:2 rad}, relative energy error up to {energy:2↑}.")
    return filled(sentence, method=METHODS[run.method].title, phase=abs(run.phase_at_end), energy=worst)


if __name__ == "__main__":
    show()
