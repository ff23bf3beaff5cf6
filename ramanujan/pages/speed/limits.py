"""The sections of page 5 on extremes: large and small numbers, long times, general solvers, kinds of arithmetic."""

from collections.abc import Sequence

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.arithmetics import MACHINE_COUNT
from ramanujan.accuracy.extremes import FORMS, Sweep
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.figures import speed_page as figures
from ramanujan.pages.speed import cache, verdicts
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.text.numerals import filled, number, unbroken
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
    """Draw the forms of Ω² over the range of floating point; return the selected sweep."""
    st.header(_("Very large and small numbers"), anchor=False)
    sentence = _(
        "Each strip is a formula for the squared natural frequency Ω². Very light bodies are on the left, very heavy "
        "ones on the right. On paper all {count} are equal. In a computer the square of a large mass overflows, and "
        "that of a small mass becomes 0: there Ω² is wrong."
    )
    st.markdown(filled(sentence, count=len(FORMS)))
    name = widgets.segmented_control(SWEEP, _("What is varied, and the precision"), label_visibility="collapsed")
    place = st.container(key="place_forms")
    with place, st.skeleton(height=348):
        sweeps, _solvers = cache.sweeps()
    sweep_name, _underscore, dtype = name.partition("_")
    selected = [sweep for sweep in sweeps if sweep.sweep_name == sweep_name and sweep.dtype == dtype]
    alternative = _("What {count} forms of Ω² return, from the least value to the greatest. {findings}.")
    findings = "; ".join(map(verdicts.describe_strip, selected))
    strips = {FORMS[sweep.form].title: verdicts.strip(sweep) for sweep in selected}
    drawn = figures.draw_forms(strips, quantity=cache.SWEEP_VARIABLES[sweep_name].title, colors=theme.colors())
    with place:
        drawings.plot(drawn, "forms", filled(alternative, count=len(FORMS), findings=findings))
    return selected


def list_failures(sweeps: Sequence[Sweep]) -> None:
    """Draw a table of the failures of each form, and the formula of each form."""
    sentence = _(
        "A computer’s numbers end at {double} in float64 and at {single} in float32. Digits are counted against a "
        "result that was computed with {digits} digits."
    )
    double, single = (number(float(np.finfo(dtype).max)) for dtype in (np.float64, np.float32))
    st.markdown(sentence.format(double=double, single=single, digits=REFERENCE.dps))
    widgets.table(verdicts.failure_table(sweeps, cache.SWEEP_VARIABLES[sweeps[0].sweep_name].symbol), "forms")
    item = _("- **{name}**: Ω² = {formula}")
    st.markdown("\n".join(item.format(name=form.title, formula=unbroken(form.formula)) for form in FORMS.values()))


def draw_phase_errors(machine: Oscillator) -> None:
    """Draw the phase error after very many periods."""
    st.header(_("Very many periods"), anchor=False)
    errors_by_periods = cache.phases(machine)
    sentence = verdicts.describe_phases(errors_by_periods)
    scale = _("Along both axes, each line is 1000 times the one before.")
    st.markdown(f"{sentence} {scale}")
    alternative = _("Phase error over the number of periods. {findings}")
    periods = [errors.periods for errors in errors_by_periods]
    curves = {
        _("Ω·<i>t</i> in float32"): [errors.float32 for errors in errors_by_periods],
        _("Ω·<i>t</i> in float64"): [errors.float64 for errors in errors_by_periods],
        _("whole turns subtracted first"): [errors.reduced for errors in errors_by_periods],
    }
    drawn = figures.draw_phase_errors(periods, curves, theme.colors())
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
