"""The sections of page 5 on extremes: lost digits, long times, general solvers, kinds of arithmetic."""

import math
from html import escape
from typing import Any

import numpy as np
import streamlit as st

from ramanujan import Oscillator
from ramanujan.accuracy.arithmetics import MACHINE_COUNT
from ramanujan.accuracy.digits import DIGITS, Evaluation, Sample
from ramanujan.accuracy.extremes import FORMS, RIGHT, USED_FORM
from ramanujan.accuracy.measurement import REFERENCE
from ramanujan.browser.components import digits
from ramanujan.browser.containers import container
from ramanujan.figures import speed_page as figures
from ramanujan.pages.speed import cache, verdicts
from ramanujan.shell import address, drawings, theme, widgets
from ramanujan.shell.display_mode import columns
from ramanujan.text.numerals import DECIMAL, filled, number, superscript
from ramanujan.text.translation import _

TITLE = _("Equal on paper, not in a computer")
EXPERIMENTS = {"time": _("short times"), "ratio": _("mass ratio"), "scale": _("all masses")}
EXPERIMENT = address.Choice("extreme", EXPERIMENTS, "time")
_QUESTIONS = {
    "time": _(
        "After a time *t* the spring has lost the share 1 − cos Ω*t* of its compression. On paper this equals "
        "2 sin²(Ω*t*/2). Which formula is still right after 10⁻⁹ of a period?"
    ),
    "ratio": _(
        "The rollers become 10²⁰⁰ times as heavy as the other bodies. On paper both formulas for Ω² are equal. Which "
        "one is still right?"
    ),
    "scale": _(
        "All masses and *k* become 10²⁰⁰ times smaller, so Ω² remains the same. On paper both formulas for Ω² are "
        "equal. Which one is still right?"
    ),
}
_LABELS = {"time": _("Time after the release, in periods"), "ratio": "ε = m′/m", "scale": "m/kg = m′/kg = k/(N/m)"}
_MASS_FORMULAS = FORMS["paper"].formula, FORMS[USED_FORM].formula
_FORMULAS = {"time": ("1 − cos Ωt", "2 sin²(Ωt/2)"), "ratio": _MASS_FORMULAS, "scale": _MASS_FORMULAS}
"""Experiment → the plain formula, and the one that the app uses."""
_BY_PLACE = {"plain": _("the first"), "used": _("the second"), "both": _("both")}
# Short formulas are options themselves. The others are in the rows of the table.
_ANSWERS = {
    "time": {**_BY_PLACE, **dict(zip(_BY_PLACE, _FORMULAS["time"], strict=False))},
    "ratio": _BY_PLACE,
    "scale": _BY_PLACE,
}
PREDICTIONS = {name: address.Choice(f"predict_{name}", answers) for name, answers in _ANSWERS.items()}
_STEPS = {"time": ("cos Ωt", "sin(Ωt/2)"), "ratio": ("(m′ + m)²", "ε"), "scale": ("(m′ + m)²", "ε")}
"""Experiment → the critical steps of both formulas."""
_SWEEPS = {
    "ratio": ("ε", _("**Mass ratio** ε = *m*′/*m*, with *m* = 1 kg and *k* = 1 N/m")),
    "scale": ("s", _("**Scale** *s* = *m*/kg = *m*′/kg = *k*/(N/m)")),
}
"""Name of a sweep → the symbol of its variable, and the title of its table."""
_START = {"time": -1, "ratio": 75, "scale": 75}
"""Experiment → the first sample shown, where both formulas are right."""

# The note on a sample, by what the critical step of the plain formula returns.
_AGREE = _("Both are right to {digits} digits. Now drag the slider, and watch the digits.")
_PREDICT = _("Choose an answer first.")
_NOTES = {
    "time": {
        "losing": _(
            "The cosine begins with more and more nines. The subtraction removes them, and few digits remain. The sine "
            "keeps all its digits."
        ),
        "vanished": _(
            "The cosine has become exactly 1, so the subtraction leaves nothing. The second formula does not subtract."
        ),
    },
    "mass": {
        "losing": _("The square is so small that the computer no longer stores all its digits."),
        "vanished": _(
            "The square is smaller than the computer’s smallest number, so it became 0. The result looks right, but it "
            "is wrong. The second formula squares no mass."
        ),
        "infinite": _(
            "The square is larger than {largest:2}, the computer’s largest number, so it became ∞. Division by ∞ gives "
            "0. The second formula squares no mass."
        ),
    },
}


def draw_digits() -> None:
    """Draw a question on two formulas, and after the prediction a slider to the extremes."""
    with st.container(key="digits_head"):
        st.header(TITLE, anchor=False)
        name = widgets.segmented_control(EXPERIMENT, _("What becomes extreme"), label_visibility="collapsed")
    with container("lead", "digits"):
        st.markdown(_QUESTIONS[name])
    prediction = widgets.pills(PREDICTIONS[name], _("Your prediction"), label_visibility="collapsed")
    digits.mount(f"digits_{name}", _payload(name, prediction))


def _payload(name: str, prediction: str | None) -> dict[str, Any]:
    """Return the samples of an experiment in texts, for `digits.mount`."""
    samples, is_predicted = cache.compare_digits(name), prediction is not None
    reasons = _NOTES["time" if name == "time" else "mass"]
    notes = dict.fromkeys(["right", *reasons], _PREDICT)
    if prediction:
        verdict = _judge(name, prediction, samples)
        notes = {"right": _AGREE} | {kind: f"{verdict} {reason}" for kind, reason in reasons.items()}
    numbers = {"digits": DIGITS, "largest": float(np.finfo(float).max)}
    used = _("used by this app") if is_predicted else ""
    plain, own = _FORMULAS[name]
    kinds = list(notes)
    return {
        "label": _LABELS[name],
        "start": _START[name] % len(samples),
        "locked": not is_predicted,
        "head": [_("Formula"), _("A step on the way"), _("Result"), _("Correct digits")],
        "rows": [
            escape(plain),
            f"{escape(own)} <small>{used}</small>",
            _("exact"),
        ],
        "all": DIGITS,
        "samples": [_describe_sample(name, sample, kinds) for sample in samples],
        "notes": [filled(note, **numbers) for note in notes.values()],
    }


def _judge(experiment: str, prediction: str, samples: list[Sample]) -> str:
    """Return whether a prediction names the formulas that keep all their digits."""
    least = {name: min(getattr(sample, name).digits for sample in samples) for name in ("plain", "used")}
    right = [name for name, digits in least.items() if digits >= DIGITS - 1]
    if prediction == ("both" if len(right) > 1 else right[0]):
        return _("Your prediction was right.")
    return _("Not right. You predicted: {answer}.").format(answer=_ANSWERS[experiment][prediction])


def _describe_sample(name: str, sample: Sample, kinds: list[str]) -> list[Any]:
    """Return the texts of a sample: its x, the cells of each row, and the number of its note."""
    cells = []
    for step, evaluation in zip(_STEPS[name], (sample.plain, sample.used), strict=True):
        value = number(evaluation.step, 16 if name == "time" else 6, strip=True)
        cells.append([f"{step} = {value}", *_split_digits(evaluation), evaluation.digits])
    exact = Evaluation(0.0, float(sample.truth), DIGITS)
    critical = sample.plain.step
    kind = "right"
    if math.isinf(critical):
        kind = "infinite"
    elif critical in (0, 1) and sample.plain.digits == 0:
        kind = "vanished"
    elif sample.plain.digits < DIGITS - 1:
        kind = "losing"
    return [number(sample.x, 2, strip=True), [*cells, ["", *_split_digits(exact), None]], kinds.index(kind)]


def _split_digits(evaluation: Evaluation) -> tuple[str, str, str]:
    """Return the correct digits of a value, its wrong digits, and its power of ten."""
    if evaluation.value == 0 or not math.isfinite(evaluation.value):
        return "", number(evaluation.value), ""
    mantissa, _e, exponent = f"{abs(evaluation.value):.{DIGITS - 1}e}".partition("e")
    end = evaluation.digits + (evaluation.digits > 1)  # the decimal mark
    mantissa = mantissa.replace(".", DECIMAL)
    return mantissa[:end], mantissa[end:], f"×10{superscript(int(exponent))}" if int(exponent) else ""


def list_failures() -> None:
    """Draw a table of the failures of each form of Ω², in both precisions."""
    sentence = _(
        "A computer’s numbers end at {double} in float64 and at {single} in float32. Digits are counted against a "
        "result that was computed with {digits} digits."
    )
    double, single = (number(float(np.finfo(dtype).max)) for dtype in (np.float64, np.float32))
    st.markdown(sentence.format(double=double, single=single, digits=REFERENCE.dps))
    forms, _solvers = cache.sweeps()
    for sweep_name, (symbol, title) in _SWEEPS.items():
        st.markdown(title)
        selected = [sweep for sweep in forms if sweep.sweep_name == sweep_name]
        # The form with the largest share of right values is the last one.
        selected.sort(key=lambda sweep: float(np.mean(sweep.verdict == RIGHT)))
        widgets.table(verdicts.failure_table(selected, symbol), f"forms_{sweep_name}")


def draw_phase_errors(machine: Oscillator) -> None:
    """Draw the phase error after very many periods."""
    words, place = columns("phases")
    errors_by_periods = cache.phases(machine)
    sentence = verdicts.describe_phases(errors_by_periods, machine.period)
    with words:
        st.header(_("Very many periods"), anchor=False)
        st.markdown(sentence)
    alternative = _("Phase error over the number of periods. {findings}")
    periods = [errors.periods for errors in errors_by_periods]
    curves = {
        _("7 digits"): [errors.float32 for errors in errors_by_periods],
        _("16 digits"): [errors.float64 for errors in errors_by_periods],
        _("turns subtracted"): [errors.reduced for errors in errors_by_periods],
    }
    drawn = figures.draw_phase_errors(periods, curves, _("16 digits"), theme.colors())
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
