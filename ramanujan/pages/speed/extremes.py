"""The sections of page 5 on the extremes: large and small numbers, long times, a general solver, what the app uses."""

from __future__ import annotations

from typing import Any

import numpy as np
import streamlit as st

from ramanujan.accuracy import FORMS
from ramanujan.accuracy.extremes import Sweep
from ramanujan.accuracy.general_solvers import EigenSweep
from ramanujan.accuracy.progress import REFERENCE
from ramanujan.numerals import number
from ramanujan.pages.speed import cache, experiments, own_choices, verdicts
from ramanujan.pages.speed.measured import OTHERS, Setting, chart, show_table
from ramanujan.shell import address, theme, widgets
from ramanujan.translation import _

SWEEP = address.Choice("sweep", tuple(cache.SWEEPS), next(iter(cache.SWEEPS)))
SWEEP_WORDS = {
    "ratio_float64": _("mass ratio, float64"),
    "ratio_float32": _("mass ratio, float32"),
    "scale_float64": _("scale, float64"),
    "scale_float32": _("scale, float32"),
}


def forms_at_extremes(setting: Setting) -> tuple[Any, ...]:
    """Draw the forms of Ω² over the range of floating point; return all sweeps that are there."""
    st.header(
        _("Extreme values: {count} ways to write Ω²").format(count=len(FORMS)),
        anchor=False,
    )
    st.markdown(
        _(
            "On paper all of them are equal. A computer’s numbers end at {double} in float64 and at {single} in "
            "float32. The square of a large mass overflows and that of a small mass becomes 0, yet the answer may "
            "still look right."
        ).format(double=number(float(np.finfo(np.float64).max)), single=number(float(np.finfo(np.float32).max)))
    )
    place, record = st.empty(), cache.sweeps()
    if record.results is None:
        job = experiments.job("sweeps", record, cache.sweep_pieces, _("Computing all powers of ten …"))
        setting.add(OTHERS, "sweeps", job, place)
        return ()
    name = widgets.chips(SWEEP, _("What is varied, and the precision"), SWEEP_WORDS, label_visibility="collapsed")
    sweep = cache.SWEEPS[name]
    shown = [s for s in record.results if isinstance(s, Sweep) and (s.along, s.dtype) == (sweep.along, sweep.dtype)]
    sentence = verdicts.where_forms_fail(shown, sweep.symbol)
    chart(
        cache.forms_figure(name, theme.colors(), shown),
        "forms",
        _("Ω² and its error for {count} forms. {findings}").format(
            count=len(FORMS), findings=sentence.replace("**", "").replace("- ", "")
        ),
    )
    st.markdown(sentence)
    st.caption(
        _(
            "A gap means the formula returned 0, infinity or NaN. A flat line away from the gray band is a wrong value "
            "that looks right. Errors are in ulp (unit in the last place), measured against {digits} digits."
        ).format(digits=REFERENCE.dps)
    )
    with st.expander(_("The formulas")):
        item = _("- **{name}**: Ω² = {formula}")
        st.markdown("\n".join(item.format(name=form.title, formula=form.formula) for form in FORMS.values()))
    return record.results


def many_periods(setting: Setting) -> None:
    """Draw the phase error after very many periods."""
    st.header(_("Extreme times: very many periods"), anchor=False)
    sentence = verdicts.how_phases_grow(cache.phases(*setting.parameters))
    chart(
        cache.phases_figure(*setting.parameters, theme.colors()),
        "phase_errors",
        _("Phase error over the number of periods. {findings}").format(findings=sentence.replace("**", "")),
    )
    st.markdown(sentence)


def general_solver(found: tuple[Any, ...]) -> None:
    """Say what a general eigen-solver makes of the zero modes."""
    sweeps = [sweep for sweep in found if isinstance(sweep, EigenSweep)]
    if not sweeps:
        return
    st.header(_("A general eigen-solver"), anchor=False)
    st.markdown(
        _(
            "A library can find Ω² from the mass matrix M and the stiffness matrix K without knowing this machine. The "
            "machine also has two zero modes, whose eigenvalue is 0: it can glide, and the top cylinder can roll "
            "freely."
        )
    )
    st.markdown(verdicts.zero_modes(sweeps))
    show_table(verdicts.zero_mode_table(sweeps), "zero_modes")


def what_the_app_uses(setting: Setting, found: tuple[Any, ...]) -> None:
    """List what the app itself uses where, once that has been measured."""
    st.header(_("What this app uses, and why"), anchor=False)
    place, record = st.empty(), cache.choices()
    if record.results is None:
        title = _("Measuring what the app itself uses …")
        job = experiments.job("choices", record, cache.choice_pieces, title, timed=True)
        setting.add(OTHERS, "choices", job, place)
    elif sweeps := [sweep for sweep in found if isinstance(sweep, Sweep)]:
        st.markdown(own_choices.what_the_app_uses(record.results, sweeps))
