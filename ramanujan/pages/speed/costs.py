"""The section of page 5 on what accuracy costs: measured on this server when a person asks for it."""

from __future__ import annotations

from typing import Any

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy import cheapest
from ramanujan.accuracy.choices import ClosedForm
from ramanujan.accuracy.work_precision import DTYPES, STEPS_PER_PERIOD, WorkPrecision
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.numerals import number, percent, quantity
from ramanujan.pages.speed import cache, downsampling, experiments, verdicts
from ramanujan.pages.speed.measured import MEASURED, Setting, chart, show_table
from ramanujan.shell import address, theme, widgets
from ramanujan.translation import _, ngettext

COST = address.Choice("cost", ("evaluations", "seconds"), "evaluations")
TOLERANCE = address.Choice("tolerance", tuple(range(1, 16)), 3, write=lambda digits: f"1e-{digits}")
COST_WORDS = {"evaluations": _("evaluations of the force"), "seconds": _("seconds on this server")}


def costs(setting: Setting) -> None:
    """Draw what accuracy costs on this server: measured when a person asks for it."""
    st.header(_("What accuracy costs on this server"), anchor=False)
    present = (*setting.parameters, setting.periods)
    if cache.diagram(*present).results is not None and not experiments.current("diagram"):
        st.session_state["speed_diagram"] = present
    asked = st.session_state.get("speed_diagram")
    found: tuple[Any, ...] = cache.diagram(*asked).results or () if asked else ()
    by, tolerance = costs_controls(setting)
    place = st.empty()
    if job := experiments.current("diagram"):
        setting.add(MEASURED, "diagram", job, place)
        found = tuple(job.results)
    if any(isinstance(result, WorkPrecision) for result in found):
        cost_diagram(found, asked, by, tolerance, follows=asked == present)
    elif job:
        st.markdown(_("The first curve comes in a moment."))
    else:
        what_is_measured(setting.periods)


def costs_controls(setting: Setting) -> tuple[str, float]:
    """Draw what measures and what chooses; return the kind of cost and the error that is allowed."""
    busy = experiments.current("diagram") is not None
    with st.container(horizontal=True, vertical_alignment="bottom"):
        more = {"icon": ":material/timer:", "type": "primary", "disabled": busy}
        st.button(
            _("Measure on this server"),
            key="measure",
            on_click=measure,
            args=(setting.machine, setting.periods),
            **more,
        )
        st.button(_("Stop"), key="stop_measuring", on_click=experiments.drop, args=("diagram",), disabled=not busy)
        by = widgets.chips(COST, _("Cost"), {"evaluations": _("evaluations"), "seconds": _("seconds")})
        errors = {digits: number(10.0**-digits, 1) for digits in TOLERANCE.options}
        digits = widgets.ladder(TOLERANCE, _("Error that you allow"), errors, width=320)
    return by, 10.0**-digits


def measure(machine: Oscillator, periods: int) -> None:
    """Begin to measure the diagram for a machine and a number of periods."""
    present = (machine.m, machine.m_prime, machine.k, periods)
    experiments.drop("diagram")
    title = ngettext("Measuring {n} period on this server …", "Measuring {n} periods on this server …", periods)
    experiments.job(
        "diagram",
        cache.diagram(*present),
        lambda: cache.diagram_pieces(machine, periods),
        title.format(n=periods),
        timed=True,
    )
    st.session_state["speed_diagram"] = present


def cost_diagram(found: tuple[Any, ...], asked: tuple[Any, ...], by: str, tolerance: float, follows: bool) -> None:
    """Draw the work-precision diagram, the cheapest run, and how both were measured."""
    curves = [result for result in found if isinstance(result, WorkPrecision)]
    closed = next((result for result in found if isinstance(result, ClosedForm)), None)
    ranked = cheapest(curves, tolerance, by)
    best = ranked[0] if ranked else None
    sentence = verdicts.what_to_take(ranked, tolerance, by, closed)
    st.markdown(sentence)
    chart(
        figures.work_precision(
            [downsampling.costs(curve, by) for curve in curves],
            cost_title=COST_WORDS[by],
            tolerance=tolerance,
            cheapest=(getattr(best, by), best.state_error) if best else None,
            exact=(closed.seconds.median, closed.phase_error) if closed and by == "seconds" else None,
            colors=theme.colors(),
        ),
        "work_precision",
        _("Work–precision diagram: the error of each method falls as its cost rises. {finding}").format(
            finding=sentence.replace("**", "")
        ),
    )
    spread = float(np.median([(c.seconds_high[0] - c.seconds_low[0]) / c.seconds[0] for c in curves]))
    st.caption(_how_measured(asked, spread))
    if not follows:
        st.caption(_("The sliders have moved since. Measure again to follow them."))
    with st.expander(_("The cheapest run of each method")):
        if ranked:
            show_table(verdicts.choice_table(ranked), "cheapest")
        else:
            st.markdown(_("No run has an error that small."))


def _how_measured(asked: tuple[Any, ...], spread: float) -> str:
    m, m_prime, k, periods = asked
    return ngettext(
        "Measured on this server for m = {m}, m′ = {m_prime}, k = {k} and {n} period. Solid: float64; dotted: "
        "float32. Times are medians of repeated runs; the middle half of the runs typically spans {spread} of the "
        "median.",
        "Measured on this server for m = {m}, m′ = {m_prime}, k = {k} and {n} periods. Solid: float64; dotted: "
        "float32. Times are medians of repeated runs; the middle half of the runs typically spans {spread} of the "
        "median.",
        periods,
    ).format(
        m=quantity(m, "kg", 6, strip=True),
        m_prime=quantity(m_prime, "kg", 6, strip=True),
        k=quantity(k, "N/m", 6, strip=True),
        n=periods,
        spread=percent(spread),
    )


def what_is_measured(periods: int) -> None:
    """Say what the button would measure."""
    counts = {"methods": len(METHODS), "precisions": len(DTYPES), "sizes": len(STEPS_PER_PERIOD), "n": periods}
    st.markdown(
        ngettext(
            "Press the button: this server then runs {methods} methods in {precisions} precisions with {sizes} step "
            "sizes, {n} period each, while you watch. Then choose the error that you allow.",
            "Press the button: this server then runs {methods} methods in {precisions} precisions with {sizes} step "
            "sizes, {n} periods each, while you watch. Then choose the error that you allow.",
            periods,
        ).format(**counts)
    )
