"""Page 5: how exact a scene has to be and what that costs, measured on the machine that serves the page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import streamlit as st

from ramanujan import stage
from ramanujan.accuracy import FORMS, cheapest
from ramanujan.accuracy.choices import ClosedForm
from ramanujan.accuracy.extremes import EigenSweep, Sweep
from ramanujan.accuracy.progress import REFERENCE
from ramanujan.accuracy.work_precision import DTYPES, STEPS_PER_PERIOD, WorkPrecision
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.scenes import controls, experiments, links, look, thinned, verdicts, view
from ramanujan.scenes.cached import speed as cached
from ramanujan.scenes.verdicts import number

STEPS = (3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192)
PERIODS = (1, 3, 10, 30, 100, 300)
PRECISIONS = ("float64", "float32")
COSTS = {"evaluations": "evaluations of the force", "seconds": "seconds on this server"}
TOLERANCES = tuple(range(1, 16))
LINK = [
    links.one_of("method", [method.title for method in METHODS.values()]),
    links.one_of("steps", map(str, STEPS)),
    links.one_of("periods", map(str, PERIODS)),
    links.one_of("precision", PRECISIONS),
    links.one_of("cost", COSTS),
    links.one_of("tolerance", [f"1e-{digits}" for digits in TOLERANCES], "no power of ten from 1e-1 to 1e-15"),
    links.one_of("sweep", cached.SWEEPS, "none of those on this page"),
]
QUIET = {"displayModeBar": False}


def chip(label: str, options: Sequence[str], key: str, **more: Any) -> str:
    """Draw a row of choices of which exactly one stands."""
    return st.segmented_control(label, options, default=options[0], key=key, bind="query-params", required=True, **more)


def choose() -> tuple[str, int, int, str]:
    """Draw the chooser and return method, steps per period, periods and precision."""
    first, second, third, fourth = st.columns([1.2, 1.2, 1.2, 1], gap="medium")
    with first:
        names = list(METHODS)
        method = st.selectbox(
            "Method",
            names,
            index=names.index("velocity_verlet"),
            format_func=lambda name: METHODS[name].title,
            key="method",
            bind="query-params",
        )
    with second:
        steps = st.select_slider("Steps per period", STEPS, 12, key="steps", bind="query-params")
    with third:
        periods = st.select_slider("Number of periods", PERIODS, 30, key="periods", bind="query-params")
    with fourth:
        precision = chip("Precision", PRECISIONS, "precision")
    return method, steps, periods, precision


def show_table(rows: verdicts.Table, key: str) -> None:
    """Draw a table that scrolls by itself where the page is narrow."""
    with st.container(key=f"table_{key}"):
        st.markdown(verdicts.table(rows))


machine, compression, colors = controls.oscillator(), controls.compression(), look.colors()
parameters = (machine.m, machine.m_prime, machine.k)

st.title("Speed and accuracy", anchor=False)
st.html("<style>[class*=st-key-table_]{overflow-x:auto}</style>")
st.markdown(
    "**How exact does this scene have to be, and what does it cost?** Most simulations take small steps in time. This "
    "machine can also be solved exactly, so every error can be seen, and measured."
)
controls.complain(links.complaints(LINK))
method, steps, periods, precision = choose()
tasks: list[tuple[str, experiments.Job, Any]] = []


def run_of(name: str) -> tuple[str, Any, Any]:
    """Return the key, the record and the pieces of a method's run with the present settings."""
    settings = (name, steps, periods, precision)
    return f"run {name}", cached.run(*parameters, *settings), lambda: thinned.run_pieces(machine, *settings)


# ---- the wrong motion beside the right one

progress = st.empty()
key, record, pieces = run_of(method)
if record.results is None:
    job = experiments.job(key, record, pieces, f"{METHODS[method].title} takes its steps …")
    # Most runs are over before the eye misses them.
    if not job.advance(0.15):
        tasks.append((key, job, progress))
if record.results is not None:
    st.session_state["speed_run"] = record.results[0]
run: thinned.Run | None = st.session_state.get("speed_run")

left, right = st.columns(2, gap="small")
least, most = controls.limits("compression")
shared = {"limits": (least, most), "watch": controls.WATCH, "clock": "speed", "compact": True, "hide": view.on_stage()}
with left:
    stage.mount(stage.payload(machine, compression), key="exact", label="Exact: the closed form", **shared)
with right:
    played, first, last, leaves = thinned.samples(run, machine, compression, most) if run else (None, 0, 0, False)
    stage.mount(
        stage.payload(machine, compression, samples=played, awaiting=run is None),
        key="stepped",
        label="Computed step by step",
        **shared,
    )
if run:
    span = f"period {last}" if last == first + 1 else f"periods {first + 1} to {last}"
    out = " Soon after, the slab leaves the picture." if leaves else ""
    st.markdown(
        f"**{METHODS[run.method].title}, {run.steps} steps a period, {run.dtype}**; shown: {span}.{out} "
        f"{verdicts.errors_of(run)}  \n:small[{verdicts.method_facts(METHODS[run.method], run.steps)}]"
    )

# ---- errors that grow

st.subheader("How the errors grow", anchor=False)
others = st.empty()
runs = [run] if run else []
for name in METHODS:
    key, record, pieces = run_of(name)
    if record.results is None and name != method:
        tasks.append((key, experiments.job(key, record, pieces, "The other methods take the same steps …"), others))
    elif record.results is not None and not (run and name == run.method):
        runs.append(record.results[0])
phases = cached.phases(*parameters)
reach = max([run.periods if run else 1, 10])
exact = [(p.periods, p.reduced) for p in phases if p.periods <= reach]
st.plotly_chart(
    figures.error_growth(
        [thinned.growth(r, chosen=r is run) for r in runs], (np.array(exact)[:, 0], np.array(exact)[:, 1]), colors
    ),
    key="growth",
    theme=None,
    config=QUIET,
    alt="Energy error and phase error over the number of periods. "
    + " ".join(
        f"{METHODS[r.method].title}: phase off by {number(abs(r.phase_at_end))} rad, energy by up to "
        f"{number(float(np.max(r.energy)))}."
        for r in runs
    ),
)
st.caption(
    "Each curve shows the largest error so far; all methods take the same steps. Below its "
    "stability limit a symplectic method keeps its energy error within bounds, while its phase runs away steadily."
)

# ---- work and precision, measured here

st.subheader("What accuracy costs on this server", anchor=False)


def measure() -> None:
    """Begin to measure the diagram for the present machine and periods."""
    experiments.drop("diagram")
    experiments.job(
        "diagram",
        cached.diagram(*parameters, periods),
        lambda: cached.diagram_pieces(machine, periods),
        f"Measuring {periods} periods on this server …",
        timed=True,
    )
    st.session_state["speed_diagram"] = (*parameters, periods)


record = cached.diagram(*parameters, periods)
if record.results is not None and not experiments.current("diagram"):
    st.session_state["speed_diagram"] = (*parameters, periods)
asked = st.session_state.get("speed_diagram")
found: tuple[Any, ...] = cached.diagram(*asked).results or () if asked else ()
with st.container(horizontal=True, vertical_alignment="bottom"):
    busy = experiments.current("diagram") is not None
    label = "Measure again" if found else "Measure on this server"
    st.button(label, key="measure", on_click=measure, icon=":material/timer:", type="primary", disabled=busy)
    st.button("Stop", key="stop", on_click=experiments.drop, args=("diagram",), disabled=not busy)
    by = chip("Cost", list(COSTS), "cost")
    digits = st.select_slider(
        "Error that you allow",
        TOLERANCES,
        3,
        format_func=lambda digits: f"1e-{digits}",
        key="tolerance",
        bind="query-params",
        width=320,
    )
tolerance = 10.0**-digits
place = st.empty()
job = experiments.current("diagram")
if job:
    tasks.insert(len([task for task in tasks if task[2] is progress]), ("diagram", job, place))
    found = tuple(job.results)
curves = [result for result in found if isinstance(result, WorkPrecision)]
closed = next((result for result in found if isinstance(result, ClosedForm)), None)
if curves:
    ranked = cheapest(curves, tolerance, by)
    best = ranked[0] if ranked else None
    sentence = verdicts.what_to_take(ranked, tolerance, by, closed)
    st.markdown(sentence)
    st.plotly_chart(
        figures.work_precision(
            [thinned.costs(curve, by) for curve in curves],
            cost_title=COSTS[by],
            tolerance=tolerance,
            cheapest=(getattr(best, by), best.state_error) if best else None,
            exact=(closed.seconds.median, closed.phase_error) if closed and by == "seconds" else None,
            colors=colors,
        ),
        key="work_precision",
        theme=None,
        config=QUIET,
        alt=f"Work-precision diagram: error over cost for each method. {sentence.replace('**', '')}",
    )
    m, m_prime, k, n = asked
    spread = float(np.median([(c.seconds_high[0] - c.seconds_low[0]) / c.seconds[0] for c in curves]))
    st.caption(
        f"Measured on this server for m = {m:g} kg, m′ = {m_prime:g} kg, k = {k:g} N/m after {n} "
        f"period{'s' if n > 1 else ''}, kept until you measure again. Solid: float64; dotted: float32. Seconds are "
        f"medians of repeats, the middle half of which typically lies within a span of {number(100 * spread)} %."
        + ("" if asked == (*parameters, periods) else " The sliders have moved on since: measure again to follow them.")
    )
    with st.expander("The cheapest run of each method"):
        if ranked:
            show_table(verdicts.choice_table(ranked), "cheapest")
        else:
            st.markdown("None is within this error.")
else:
    st.markdown(
        f"{len(METHODS)} methods, {len(DTYPES)} precisions, {len(STEPS_PER_PERIOD)} step sizes, {periods} periods "
        "each: press the button, and this server runs them while you watch. Then choose the error that you allow."
        if not job
        else "The first curve comes in a moment."
    )

# ---- the extremes

st.subheader(f"The extremes: {len(FORMS)} ways to write Ω²", anchor=False)
st.markdown(
    f"On paper all of them are equal. Numbers in a computer end, at {number(float(np.finfo(np.float64).max))} in "
    f"float64 and at {number(float(np.finfo(np.float32).max))} in float32: squares of large masses overflow, squares "
    "of small ones vanish, and the answer may still look like an answer."
)
place = st.empty()
record = cached.sweeps()
if record.results is None:
    task = experiments.job("sweeps", record, cached.sweep_pieces, "Going through all powers of ten …")
    tasks.append(("sweeps", task, place))
all_sweeps = record.results or ()
if all_sweeps:
    name = chip("Sweep", list(cached.SWEEPS), "sweep", label_visibility="collapsed")
    sweep = cached.SWEEPS[name]
    shown = [s for s in all_sweeps if isinstance(s, Sweep) and (s.along, s.dtype) == (sweep.along, sweep.dtype)]
    sentence = verdicts.where_forms_fail(shown, sweep.symbol)
    st.plotly_chart(
        cached.forms_figure(name, colors, shown),
        key="forms",
        theme=None,
        config=QUIET,
        alt=f"Ω² and its error for {len(FORMS)} forms. {sentence.replace('**', '')}",
    )
    st.markdown(sentence)
    st.caption(
        "A gap: no number, or zero, where a logarithm ends. A level stretch off the gray band: a wrong value. Errors "
        f"are counted in ulp, units in the last place, against {REFERENCE.dps} digits."
    )
    with st.expander("The forms"):
        st.markdown("\n".join(f"- **{form.title}**: Ω² = {form.formula}" for form in FORMS.values()))

st.subheader("The extremes: after very many periods", anchor=False)
sentence = verdicts.how_phases_grow(phases)
st.plotly_chart(
    cached.phases_figure(*parameters, colors),
    key="phase_errors",
    theme=None,
    config=QUIET,
    alt=f"Phase error over the number of periods. {sentence.replace('**', '')}",
)
st.markdown(sentence)

# ---- the general eigen-solver and what the app uses

solvers = [s for s in all_sweeps if isinstance(s, EigenSweep)]
if solvers:
    st.subheader("A general eigen-solver", anchor=False)
    st.markdown(
        "A library can find Ω² from the mass matrix M and the stiffness matrix K without knowing this machine. The "
        "machine has two zero modes beside: it glides, and the top cylinder rolls freely. "
        f"{verdicts.zero_modes(solvers)}"
    )
    show_table(verdicts.zero_mode_table(solvers), "zero_modes")

st.subheader("What this app uses where, and why", anchor=False)
place = st.empty()
record = cached.choices()
if record.results is None:
    task = experiments.job("choices", record, cached.choice_pieces, "Measuring what the app itself does …", timed=True)
    tasks.append(("choices", task, place))
elif all_sweeps:
    forms_found = [s for s in all_sweeps if isinstance(s, Sweep)]
    st.markdown(verdicts.what_the_app_uses(record.results, forms_found))

experiments.work(tasks)
