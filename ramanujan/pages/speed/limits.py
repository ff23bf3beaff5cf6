"""The sections of page 5 on extremes: large and small numbers, long times, general solvers, kinds of arithmetic."""

import math
from collections.abc import Sequence
from html import escape

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.arithmetics import MACHINE_COUNT
from ramanujan.accuracy.extremes import FORMS, RIGHT, USED_FORM, Sweep
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.figures import speed_page as figures
from ramanujan.pages.speed import cache, verdicts
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.shell.display_mode import columns
from ramanujan.text.numerals import filled, number, power_of_ten
from ramanujan.text.translation import _

SWEEPS = {
    "ratio_float64": _("mass ratio, 16 digits"),
    "ratio_float32": _("mass ratio, 7 digits"),
    "scale_float64": _("scale, 16 digits"),
    "scale_float32": _("scale, 7 digits"),
}
"""A key of `cache.SWEEP_VARIABLES` and a precision → the label of the sweep."""
SWEEP = address.Choice("sweep", SWEEPS, "ratio_float64")


def draw_forms() -> list[Sweep]:
    """Draw the forms of Ω² over the range of floating point, the worst at the top; return the selected sweep."""
    place = st.container(key="forms")
    with place:
        with st.container(key="forms_head"):
            st.header(_("Very large and small numbers"), anchor=False)
            name = widgets.segmented_control(
                SWEEP, _("What is varied, and the precision"), label_visibility="collapsed"
            )
        sentence = _("On paper all {count} formulas are equal. Which survive in a computer?")
        st.markdown(filled(sentence, count=len(FORMS)))
        with st.skeleton(height=400):
            sweeps, _solvers = cache.sweeps()
    sweep_name, _underscore, dtype = name.partition("_")
    selected = [sweep for sweep in sweeps if sweep.sweep_name == sweep_name and sweep.dtype == dtype]
    selected.sort(key=_rank)
    with place:
        st.html(_forms_html(selected, cache.SWEEP_VARIABLES[sweep_name]))
        st.markdown(
            _(
                "This app uses the last one: it divides m′ by m first and never squares a mass, so no step leaves the "
                "range of the numbers."
            )
        )
    return selected


def _rank(sweep: Sweep) -> tuple[float, bool]:
    """Return the share of right values, and whether the app uses this form, so that the best form is the last."""
    return float(np.mean(sweep.verdict == RIGHT)), sweep.form == USED_FORM


def _forms_html(sweeps: Sequence[Sweep], variable: cache.SweepVariable) -> str:
    """Return the forms with their strips, above an axis of powers of ten."""
    rows = "".join(map(_form_html, sweeps))
    first, last = (math.log10(sweeps[0].x[index]) for index in (0, -1))
    step = 10 if last < 100 else 100
    ticks = []
    for exponent in range(math.ceil(first / step) * step, math.floor(last / step) * step + 1, step):
        place = 100 * (exponent - first) / (last - first)
        ticks.append(f'<i style="--at:{place:.1f}%">{power_of_ten(exponent) if exponent else 1}</i>')
    least, greatest = variable.ends
    axis = f'<div class="ticks">{"".join(ticks)}</div>'
    title = f'<p class="axis"><span>← {least}</span> <span>{variable.title}</span> <span>{greatest} →</span></p>'
    return f"{rows}{axis}{title}"


def _form_html(sweep: Sweep) -> str:
    """Return the name of a form, its formula, and its strip."""
    form = FORMS[sweep.form]
    title = _("{form}, used by this app") if sweep.form == USED_FORM else "{form}"
    heading = f"<b>{escape(title.format(form=form.title))}</b> <span>Ω² = {escape(form.formula)}</span>"
    parts = [
        f'<span class="{part.verdict}" style="flex-grow:{part.end - part.start:.2f}" title="{part.label}">'
        f"<span>{part.label}</span></span>"
        for part in verdicts.strip(sweep)
    ]
    return f'<p>{heading}</p><div class="strip">{"".join(parts)}</div>'


def list_failures(sweeps: Sequence[Sweep]) -> None:
    """Draw a table of the failures of each form."""
    sentence = _(
        "A computer’s numbers end at {double} in float64 and at {single} in float32. Digits are counted against a "
        "result that was computed with {digits} digits."
    )
    double, single = (number(float(np.finfo(dtype).max)) for dtype in (np.float64, np.float32))
    st.markdown(sentence.format(double=double, single=single, digits=REFERENCE.dps))
    widgets.table(verdicts.failure_table(sweeps, cache.SWEEP_VARIABLES[sweeps[0].sweep_name].symbol), "forms")


def draw_phase_errors(machine: Oscillator) -> None:
    """Draw the phase error after very many periods."""
    words, place = columns("phases")
    errors_by_periods = cache.phases(machine)
    sentence = verdicts.describe_phases(errors_by_periods)
    with words:
        st.header(_("Very many periods"), anchor=False)
        st.markdown(_("The phase is Ω·t. For how long does a computer know it?"))
        st.markdown(sentence)
    alternative = _("Phase error over the number of periods. {findings}")
    periods = [errors.periods for errors in errors_by_periods]
    curves = {
        "float32": [errors.float32 for errors in errors_by_periods],
        "float64": [errors.float64 for errors in errors_by_periods],
        _("turns subtracted"): [errors.reduced for errors in errors_by_periods],
    }
    drawn = figures.draw_phase_errors(periods, curves, "float64", theme.colors())
    with place:
        drawings.plot(drawn, "phase_errors", alternative.format(findings=sentence.replace("**", "")))


def explain_solvers() -> None:
    """Explain which zero modes general eigen-solvers find."""
    _forms, sweeps = cache.sweeps()
    st.markdown(
        _(
            "A library can find Ω² from the mass matrix M and the stiffness matrix K without knowing this machine. "
            "The machine also has two zero modes, whose eigenvalue is 0: it can glide, and the top cylinder can roll "
            "freely."
        )
    )
    st.markdown(verdicts.describe_zero_modes(sweeps))


def list_zero_modes() -> None:
    """Draw a table of the zero modes that general eigen-solvers find."""
    _forms, sweeps = cache.sweeps()
    widgets.table(verdicts.zero_mode_table(sweeps), "zero_modes")


def draw_arithmetics() -> None:
    """Draw a table of the time and the error of Ω² in several kinds of arithmetic."""
    prices = cache.arithmetics()
    own, exact = prices["float64"], prices["fractions"]
    sentence = _(
        "This app computes with float64. Its error is at most {error:2↑}, far below anything that a screen can show. "
        "Exact fractions would take {times:2} times as long."
    )
    st.markdown(filled(sentence, error=own.error, times=exact.seconds / own.seconds))
    widgets.table(verdicts.arithmetic_table(prices), "arithmetics")
    sentence = _("Measured on this server. Errors are the largest of {machines} random machines.")
    st.caption(sentence.format(machines=MACHINE_COUNT))
