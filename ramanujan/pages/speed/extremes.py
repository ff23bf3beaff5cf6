"""The sections of page 5 on the extremes: large and small numbers, long times, a general solver, what the app uses."""

from collections.abc import Sequence

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.extremes import FORMS, Sweep
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.numerals import number
from ramanujan.pages.speed import cache, own_choices, verdicts
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.translation import _

SWEEPS = {
    "ratio_float64": _("mass ratio, float64"),
    "ratio_float32": _("mass ratio, float32"),
    "scale_float64": _("scale, float64"),
    "scale_float32": _("scale, float32"),
}
"""What is varied, one of `cache.ALONG`, and the precision → what one reads."""
SWEEP = address.Choice("sweep", SWEEPS, "ratio_float64")


def forms_at_extremes() -> list[Sweep]:
    """Draw the forms of Ω² over the range of floating point; return what is shown."""
    st.header(_("Extreme values: {count} ways to write Ω²").format(count=len(FORMS)), anchor=False)
    st.markdown(
        _(
            "On paper all of them are equal. A computer’s numbers end at {double} in float64 and at {single} in "
            "float32. The square of a large mass overflows and that of a small mass becomes 0, yet the answer may "
            "still look right."
        ).format(double=number(float(np.finfo(np.float64).max)), single=number(float(np.finfo(np.float32).max)))
    )
    swept, _solvers = cache.sweeps()
    name = widgets.chips(SWEEP, _("What is varied, and the precision"), label_visibility="collapsed")
    along, _between, dtype = name.partition("_")
    shown = [s for s in swept if (s.along, s.dtype) == (along, dtype)]
    drawings.plot(
        cache.forms_figure(name, theme.colors(), shown),
        "forms",
        _("What {count} forms of Ω² return, from the least value to the greatest. {findings}.").format(
            count=len(FORMS), findings="; ".join(map(verdicts.in_words, shown))
        ),
    )
    sentence = _(
        "A strip for each form: where it is right, and what it returns where it fails. A wrong value may look right. "
        "Errors are in ulp (unit in the last place), measured against {digits} digits."
    )
    st.caption(sentence.format(digits=REFERENCE.dps))
    return shown


def where_forms_fail(shown: Sequence[Sweep]) -> None:
    """Say where each form fails, and which formulas they are."""
    widgets.table(verdicts.failure_table(shown, cache.ALONG[shown[0].along][0]), "forms")
    item = _("- **{name}**: Ω² = {formula}")
    st.markdown("\n".join(item.format(name=form.title, formula=form.formula) for form in FORMS.values()))


def many_periods(machine: Oscillator) -> None:
    """Draw the phase error after very many periods."""
    st.header(_("Extreme times: very many periods"), anchor=False)
    parameters = machine.m, machine.m_prime, machine.k
    sentence = verdicts.how_phases_grow(cache.phases(*parameters))
    drawings.plot(
        cache.phases_figure(*parameters, theme.colors()),
        "phase_errors",
        _("Phase error over the number of periods. {findings}").format(findings=sentence.replace("**", "")),
    )
    st.markdown(sentence)


def general_solver() -> None:
    """Say what general eigen-solvers make of the zero modes, and list them."""
    _forms, sweeps = cache.sweeps()
    st.markdown(
        _(
            "A library can find Ω² from the mass matrix M and the stiffness matrix K without knowing this machine. "
            "The machine also has two zero modes, whose eigenvalue is 0: it can glide, and the top cylinder can roll "
            "freely."
        )
    )
    st.markdown(verdicts.zero_modes(sweeps))
    widgets.table(verdicts.zero_mode_table(sweeps), "zero_modes")


def what_the_app_uses() -> None:
    """List what the app itself uses where."""
    swept, _solvers = cache.sweeps()
    st.markdown(own_choices.what_the_app_uses(*cache.choices(), swept))
