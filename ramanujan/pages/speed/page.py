"""Page 5: how exact a scene has to be and what that costs, measured on the machine that serves the page."""

from __future__ import annotations

import math

import numpy as np
import streamlit as st

from ramanujan.browser import stage
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.numerals import number, quantity
from ramanujan.pages.speed import cache, downsampling, experiments, verdicts
from ramanujan.pages.speed.costs import COST, TOLERANCE, costs
from ramanujan.pages.speed.extremes import SWEEP, forms_at_extremes, general_solver, many_periods, what_the_app_uses
from ramanujan.pages.speed.measured import CHOSEN, OTHERS, Setting, chart
from ramanujan.shell import address, sidebar, stages, theme, widgets
from ramanujan.translation import _

METHOD = address.Choice("method", tuple(METHODS), "velocity_verlet")
STEPS = address.Choice("steps", (3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192), 12)
PERIODS = address.Choice("periods", (1, 3, 10, 30, 100, 300), 30)
PRECISION = address.Choice("precision", ("float64", "float32"), "float64")
KEYS = (METHOD, STEPS, PERIODS, PRECISION, COST, TOLERANCE, SWEEP)

PRECISION_WORDS = {"float64": _("float64"), "float32": _("float32")}


def show() -> None:
    """Draw the page, then take its experiments."""
    st.title(_("Speed and accuracy"), anchor=False)
    st.html("<style>[class*=st-key-table_]{overflow:auto hidden}</style>")
    st.markdown(
        _(
            "**How exact does this simulation have to be, and what does that cost?** Most simulations advance in small "
            "time steps. This machine can also be solved exactly: it oscillates with the angular frequency Ω. So every "
            "error can be seen and measured."
        )
    )
    setting = choose()
    run = side_by_side(setting)
    growing_errors(setting, run)
    costs(setting)
    sweeps = forms_at_extremes(setting)
    many_periods(setting)
    general_solver(sweeps)
    what_the_app_uses(setting, sweeps)
    experiments.work([task[1:] for task in sorted(setting.tasks, key=lambda task: task[0])])


def choose() -> Setting:
    """Draw the choice of method, steps per period, periods and precision."""
    first, second, third, fourth = st.columns([1.2, 1.2, 1.2, 1], gap="medium")
    with first:
        method = widgets.menu(METHOD, _("Method"), {name: METHODS[name].title for name in METHODS})
    with second:
        steps = widgets.ladder(STEPS, _("Steps per period"))
    with third:
        periods = widgets.ladder(PERIODS, _("Number of periods"))
    with fourth:
        precision = widgets.chips(PRECISION, _("Precision"), PRECISION_WORDS)
    return Setting(sidebar.oscillator(), method, steps, periods, precision)


def side_by_side(setting: Setting) -> downsampling.Run | None:
    """Draw the computed motion beside the exact one, and return the run that it shows."""
    title = _("Running this method: {method} …").format(method=METHODS[setting.method].title)
    record = setting.run_of(setting.method, CHOSEN, title, st.empty())
    if record.results is not None:
        st.session_state["speed_run"] = record.results[0]
    run: downsampling.Run | None = st.session_state.get("speed_run")
    two_stages(setting, run)
    return run


def two_stages(setting: Setting, run: downsampling.Run | None) -> None:
    """Draw the exact machine and the computed one on one clock."""
    machine, compression = setting.machine, sidebar.compression()
    shared = {"clock": "speed", "compact": True}
    left, right = st.columns(2, gap="small")
    with left:
        stages.mount(stage.payload(machine, compression), key="exact", label=_("Exact: the closed form"), **shared)
    most = stages.LIMITS[1]
    played, first, last, leaves = downsampling.samples(run, machine, compression, most) if run else (None, 0, 0, False)
    with right:
        stages.mount(
            stage.payload(machine, compression, samples=played, awaiting=run is None),
            key="stepped",
            label=_("Computed step by step"),
            **shared,
        )
    if run:
        said = [_what_is_shown(run, first + 1, last), verdicts.errors_of(run)]
        if leaves:
            said.insert(1, _("Soon after, the slab leaves the picture."))
        facts = verdicts.method_facts(METHODS[run.method], run.steps)
        st.markdown(f"{' '.join(said)}  \n:small[{facts}]")


def _what_is_shown(run: downsampling.Run, first: int, last: int) -> str:
    sentence = (
        _("**{method}, {steps} steps per period, {precision}**, shown in period {last}.")
        if first == last
        else _("**{method}, {steps} steps per period, {precision}**, shown from period {first} to period {last}.")
    )
    title = METHODS[run.method].title
    return sentence.format(method=title, steps=run.steps, precision=run.dtype, first=first, last=last)


def growing_errors(setting: Setting, run: downsampling.Run | None) -> None:
    """Draw how the errors of all methods grow."""
    st.header(_("How the errors grow"), anchor=False)
    place = st.empty()
    runs = [run] if run else []
    for name in METHODS:
        if name != setting.method:
            record = setting.run_of(name, OTHERS, _("Running the other methods with the same steps …"), place)
            # The run that is shown may be an older one, of a method that is one of the others by now.
            runs += [r for r in record.results or () if not (run and r.method == run.method)]
    reach = max([run.periods if run else 1, 10])
    exact = np.array([(p.periods, p.reduced) for p in cache.phases(*setting.parameters) if p.periods <= reach])
    found = [_found(r) for r in runs]
    chart(
        figures.error_growth(
            [downsampling.growth(r, chosen=r is run) for r in runs], (exact[:, 0], exact[:, 1]), theme.colors()
        ),
        "growth",
        _(
            "Energy error and phase error over the number of periods: the methods’ phase errors grow with time, that "
            "of the closed form does not. {errors}"
        ).format(errors=" ".join(found)),
    )
    st.caption(
        _(
            "Each curve shows the largest error so far, and all methods take the same steps. Below its stability limit "
            "a symplectic method keeps its energy error bounded, but its phase error grows steadily."
        )
    )


def _found(run: downsampling.Run) -> str:
    """Say how far a run is off at its end."""
    worst = float(np.max(run.energy))
    if not (math.isfinite(run.phase_at_end) and math.isfinite(worst)):
        return _("{method}: the energy has grown beyond all bounds.").format(method=METHODS[run.method].title)
    return _("{method}: phase error {phase}, relative energy error up to {energy}.").format(
        method=METHODS[run.method].title, phase=quantity(abs(run.phase_at_end), "rad"), energy=number(worst)
    )


if __name__ == "__main__":
    show()
