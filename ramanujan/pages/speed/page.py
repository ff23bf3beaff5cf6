"""Page 5: how exact a scene has to be and what that costs, measured on the machine that serves the page."""

import math
from functools import partial

import numpy as np
import streamlit as st

from ramanujan.browser import stage
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.numerals import filled
from ramanujan.pages.speed import cache, downsampling, extremes, verdicts
from ramanujan.pages.speed.costs import COST, TOLERANCE, costs
from ramanujan.pages.speed.extremes import SWEEP
from ramanujan.shell import address, display_mode, drawings, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import folded, sheet
from ramanujan.translation import _

METHOD = address.Choice("method", {name: method.title for name, method in METHODS.items()}, "velocity_verlet")
STEPS = address.Choice("steps", (3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192), 12)
PERIODS = address.Choice("periods", cache.PERIODS, 30)
PRECISION = address.Choice("precision", ("float64", "float32"), "float64")
URL_PARAMETERS = (METHOD, STEPS, PERIODS, PRECISION, COST, TOLERANCE, SWEEP)


def show() -> None:
    """Draw the page, then take its experiments."""
    with sheet("motion", _("Exact and computed")):
        the_question()
        method, steps, periods, precision = widgets.beside(
            [1.2, 1.2, 1.2, 1],
            partial(widgets.menu, METHOD, _("Method")),
            partial(widgets.ladder, STEPS, _("Steps per period")),
            partial(widgets.ladder, PERIODS, _("Number of periods")),
            partial(widgets.chips, PRECISION, _("Precision")),
        )
        run = two_stages(method, steps, periods, precision)
    with sheet("errors", _("How the errors grow")):
        growing_errors(run)
    with sheet("costs", _("What accuracy costs")):
        costs_on_this_server = costs(periods)
    with sheet("forms", _("Extreme values")):
        forms = extremes.forms_at_extremes()
    if not display_mode.is_projector():
        with st.expander(_("Where each form fails, and the formulas")):
            extremes.where_forms_fail(forms)
    with sheet("periods", _("Very many periods")):
        extremes.many_periods(sidebar.oscillator())
    folded("solver", _("A general eigen-solver, which does not know this machine"), extremes.general_solver)
    folded("choices", _("What this app uses, and why"), extremes.what_the_app_uses)
    # What may take long comes when all else is drawn.
    costs_on_this_server()


def the_question() -> None:
    """Draw the title, and what the page asks."""
    st.title(_("Speed and accuracy"), anchor=False)
    st.markdown(
        _(
            "**How accurate does a simulation have to be, and what does that cost?** Most simulations advance in small "
            "time steps. This machine can also be solved exactly: it oscillates with the angular frequency Ω. So every "
            "error can be seen and measured."
        )
    )


def two_stages(method: str, steps: int, periods: int, precision: str) -> downsampling.Run:
    """Draw the exact machine and the computed one on one clock; return the run that is shown."""
    machine, compression = sidebar.oscillator(), sidebar.compression()
    shared = {"clock": "speed", "compact": True}
    if display_mode.is_projector():
        shared["layers"] = ()
    left, right = st.columns(2, gap="small")
    with left:
        exact = stage.payload(machine, compression)
        with st.container(key="observed_exact"):
            stages.mount(exact, key="stage_exact", label=_("Exact: the closed form"), **shared)
        st.markdown(verdicts.method_facts(METHODS[method], steps))
    with right:
        run = cache.run(method, steps, periods, precision)
        played, first, last, leaves = downsampling.samples(run, machine, compression, stages.LIMITS[1])
        payload = stage.payload(machine, compression, samples=played)
        with st.container(key="observed_stepped"):
            stages.mount(payload, key="stage_stepped", label=_("Computed step by step"), **shared)
        said = [_what_is_shown(run, first + 1, last), verdicts.errors_of(run)]
        if leaves:
            said.insert(1, _("Soon after, the slab leaves the picture."))
        st.markdown(" ".join(said))
    return run


def _what_is_shown(run: downsampling.Run, first: int, last: int) -> str:
    sentence = (
        _("**{method}, {steps} steps per period, {precision}**, shown in period {last}.")
        if first == last
        else _("**{method}, {steps} steps per period, {precision}**, shown from period {first} to period {last}.")
    )
    title = METHODS[run.method].title
    return sentence.format(method=title, steps=run.steps, precision=run.dtype, first=first, last=last)


def growing_errors(run: downsampling.Run) -> None:
    """Draw how the errors of all methods grow."""
    st.header(_("How the errors grow"), anchor=False)
    with st.skeleton(height=480):
        runs = [cache.run(name, run.steps, run.periods, run.dtype) for name in METHODS]
    machine = sidebar.oscillator()
    phases = cache.phases(machine)
    exact = np.array([(p.periods, p.reduced) for p in phases if p.periods <= max(run.periods, 10)])
    curves = {METHODS[each.method].title: (each.reach, each.energy, each.phase) for each in runs}
    figure = figures.error_growth(curves, METHODS[run.method].title, (exact[:, 0], exact[:, 1]), theme.colors())
    sees = _(
        "Energy error and phase error over the number of periods: the methods’ phase errors grow with time, that of "
        "the closed form does not. {errors}"
    )
    drawings.plot(figure, "growth", sees.format(errors=" ".join(map(_found, runs))))
    st.caption(
        _(
            "Each curve shows the largest error so far, and all methods take the same steps. Below its stability limit "
            "a symplectic method keeps its energy error bounded, but its phase error grows steadily. In the gray zone, "
            "where rounding errors are, each power of ten takes an eighth of its usual height."
        )
    )


def _found(run: downsampling.Run) -> str:
    """Say how far a run is off at its end."""
    worst = float(np.max(run.energy))
    if not (math.isfinite(run.phase_at_end) and math.isfinite(worst)):
        sentence = _("{method}: the energy has grown beyond the largest floating-point number.")
        return sentence.format(method=METHODS[run.method].title)
    sentence = _("{method}: phase error {phase:2 rad}, relative energy error up to {energy:2}.")
    return filled(sentence, method=METHODS[run.method].title, phase=abs(run.phase_at_end), energy=worst)


if __name__ == "__main__":
    show()
