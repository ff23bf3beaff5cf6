"""The sections of page 5 on extremes: large and small numbers, long times, general solvers, the app's own methods."""

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.choices import DIGITS, HEIGHT, STATE_COUNT
from ramanujan.accuracy.extremes import FORMS, Sweep
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.browser.roles import container
from ramanujan.figures import speed as figures
from ramanujan.numerals import duration, filled, number, unbroken
from ramanujan.pages.speed import cache, verdicts
from ramanujan.pages.speed.downsampling import SCREEN_HEIGHT
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.shell.display_mode import columns
from ramanujan.translation import _

SWEEPS = {
    "ratio_float64": _("mass ratio, float64"),
    "ratio_float32": _("mass ratio, float32"),
    "scale_float64": _("scale, float64"),
    "scale_float32": _("scale, float32"),
}
"""A key of `cache.SWEEP_VARIABLES` and a precision → the label of the sweep."""
SWEEP = address.Choice("sweep", SWEEPS, "ratio_float64")


_CHOICES = (
    _(
        "**Motion, stage and figures**: the closed form. For equal masses of 1\u202fkg and k\u00a0=\u00a01\u202fN/m "
        "its phase error is at most {phase_error:2↑ rad} from {first} to {last:2} periods. A state takes {state}. "
        "The error grows with the number of periods. If whole turns were subtracted first, it would stay below "
        "{reduced_error:2↑ rad}, but each state would take {reduced} more."
    ),
    _(
        "**Ω² of a machine, and the curve of Ω²m/k**: the effective mass, {formula}. The error is at most "
        "{error:2↑} ulp for {machines:2} random machines whose ratios m′/m and k/m are of every size. A value takes "
        "{float64} by itself and {array} in an array. Exact integers have an error of at most {integers_error:2↑} ulp "
        "and take {integers}. Fractions give the same digits in {fraction}."
    ),
    _(
        "**Formulas and steps of the derivation**: exact fractions. One value of Ω² takes {fraction} and has no "
        "error. With mpmath it takes {few} with {few_digits} digits and {many} with {many_digits} digits."
    ),
    _(
        "**Curves**: enough points for an error below half a pixel. In a figure {height} pixels high, {cosine} points "
        "draw one period to within {cosine_error:2↑} pixel. The curve of Ω² takes {frequency} points for "
        "{frequency_error:2↑} pixel."
    ),
    _(
        "**Numbers sent to the browser**: float32. They take half the bytes of float64. Rounding changes a number by "
        "at most one part in {part:2↓}, {finer:2} times less than half a pixel of a screen {screen} pixels high."
    ),
    _("**Ω** is stored with its machine. Reading it again is {kept_frequency:2} times faster than computing it."),
    _("**The solution** is stored with its machine. The next state is {kept_state:2} times faster than the first."),
    _("**Many states** are computed in one call. For {n} states this is {kept_states:2} times faster than one by one."),
)
"""The app's own methods with their uses and reasons."""
_FIRST = 3
"""Number of methods in the first part of the list."""


def draw_forms() -> list[Sweep]:
    """Draw the forms of Ω² over the range of floating point; return the selected sweep."""
    st.header(filled(_("Extreme values: {count:word} ways to write Ω²"), count=len(FORMS)), anchor=False)
    words, figure = columns("forms")
    with words:
        sentence = _(
            "On paper all of them are equal. A computer’s numbers end at {double} in float64 and at {single} in "
            "float32. The square of a large mass overflows and that of a small mass becomes 0, yet the answer may "
            "still look right."
        )
        double, single = (number(float(np.finfo(dtype).max)) for dtype in (np.float64, np.float32))
        st.markdown(sentence.format(double=double, single=single))
    with figure, st.skeleton(height=480):
        sweeps, _solvers = cache.sweeps()
    with figure:
        name = widgets.segmented_control(SWEEP, _("What is varied, and the precision"), label_visibility="collapsed")
        sweep_name, _underscore, dtype = name.partition("_")
        selected = [sweep for sweep in sweeps if sweep.sweep_name == sweep_name and sweep.dtype == dtype]
        alternative = _("What {count:word} forms of Ω² return, from the least value to the greatest. {findings}.")
        findings = "; ".join(map(verdicts.describe_strip, selected))
        strips = {FORMS[sweep.form].title: verdicts.strip(sweep) for sweep in selected}
        drawn = figures.draw_forms(strips, quantity=cache.SWEEP_VARIABLES[sweep_name].title, colors=theme.colors())
        drawings.plot(drawn, "forms", filled(alternative, count=len(FORMS), findings=findings))
    with words:
        sentence = _(
            "A strip for each form: where it is right, and what it returns where it fails. A wrong value may look "
            "right. Errors are in ulp (unit in the last place), measured against {digits} digits."
        )
        st.caption(sentence.format(digits=REFERENCE.dps))
    return selected


def list_failures(sweeps: Sequence[Sweep]) -> None:
    """Draw a table of the failures of each form, and the formula of each form."""
    widgets.table(verdicts.failure_table(sweeps, cache.SWEEP_VARIABLES[sweeps[0].sweep_name].symbol), "forms")
    item = _("- **{name}**: Ω² = {formula}")
    st.markdown("\n".join(item.format(name=form.title, formula=unbroken(form.formula)) for form in FORMS.values()))


def draw_phase_errors(machine: Oscillator) -> None:
    """Draw the phase error after very many periods."""
    st.header(_("Extreme times: very many periods"), anchor=False)
    sentence = verdicts.describe_phases(cache.phases(machine))
    words, figure = columns("periods")
    alternative = _("Phase error over the number of periods. {findings}")
    with figure:
        drawn = cache.phases_figure(machine, theme.colors())
        drawings.plot(drawn, "phase_errors", alternative.format(findings=sentence.replace("**", "")))
    with words:
        st.markdown(sentence)


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


def list_choices(sentences: Sequence[str]) -> None:
    """List the app's own methods with their uses, reasons and measurements, the named slots of the sentences."""
    choices = cache.choices()
    template = "\n".join(f"- {sentence}" for sentence in sentences)
    slots = {
        **_describe_states(choices),
        **_describe_forms(),
        **_describe_arithmetics(choices),
        **_describe_curves(choices),
        **_describe_rounding(),
        **{f"kept_{name}": factor for name, factor in choices.speedups.items()},
        "n": STATE_COUNT,
    }
    with container("list", "choices" if sentences == _CHOICES[:_FIRST] else "choices_on"):
        st.markdown(filled(template, **slots))


CHOICES = (partial(list_choices, _CHOICES[:_FIRST]), partial(list_choices, _CHOICES[_FIRST:]))
"""Functions that draw the two parts of the list of methods."""


def _describe_states(choices: cache.Choices) -> dict[str, object]:
    """Return the slots about the closed form."""
    states = choices.states
    return {
        "first": states[0].periods,
        "last": states[-1].periods,
        "phase_error": max(state.phase_error for state in states),
        "state": duration(float(np.median([state.seconds.median for state in states]))),
        "reduced_error": max(errors.reduced for errors in cache.phases(Oscillator())),
        "reduced": duration(choices.reduction),
    }


def _describe_forms() -> dict[str, object]:
    """Return the slots about the effective mass and about exact integers, for random machines."""
    sweeps, _solvers = cache.sweeps()
    by_form = {sweep.form: sweep for sweep in sweeps if sweep.sweep_name == "machines" and sweep.dtype == "float64"}
    own = by_form["effective_mass"]
    return {
        "formula": unbroken(FORMS[own.form].formula),
        "machines": own.x.size,
        "error": own.worst_right_ulp,
        "integers_error": by_form["integers"].worst_right_ulp,
    }


def _describe_arithmetics(choices: cache.Choices) -> dict[str, object]:
    """Return the slots about the time for a value of Ω². A key of `arithmetics` is a word or a number of digits."""
    few_digits, many_digits = DIGITS[0], DIGITS[-1]
    times = {kind: duration(seconds) for kind, seconds in choices.arithmetics.items() if isinstance(kind, str)}
    return {
        **times,
        "few": duration(choices.arithmetics[few_digits]),
        "few_digits": few_digits,
        "many": duration(choices.arithmetics[many_digits]),
        "many_digits": many_digits,
    }


def _describe_curves(choices: cache.Choices) -> dict[str, object]:
    """Return the slots about the number of points of each curve."""
    slots: dict[str, object] = {"height": HEIGHT}
    for name, distances in choices.curves.items():
        slots[name], slots[f"{name}_error"] = _fewest_points(distances)
    return slots


def _describe_rounding() -> dict[str, object]:
    """Return the slots about numbers in float32."""
    rounding = float(np.finfo(np.float32).eps) / 2
    return {"part": 1 / rounding, "finer": 0.5 / SCREEN_HEIGHT / rounding, "screen": SCREEN_HEIGHT}


def _fewest_points(distances: Mapping[int, float]) -> tuple[int, float]:
    """Return the smallest number of points that draw a curve to within half a pixel, and their error [pixels].

    Parameters
    ----------
    distances : number of points, ascending → largest distance from the curve [pixels]
    """
    return next((points, distance) for points, distance in distances.items() if distance < 0.5)
