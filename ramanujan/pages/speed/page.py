"""Page 5 in three topics: a computed machine against the exact one, the price of accuracy, the limits of numbers."""

import math

import numpy as np
import streamlit as st

from ramanujan.accuracy.extremes import FORMS
from ramanujan.accuracy.work_precision import PERIODS
from ramanujan.browser.containers import container
from ramanujan.figures import speed_page as figures
from ramanujan.lesson.answer_tasks import WITHIN
from ramanujan.pages.speed import cache, challenge, costs, limits, verdicts
from ramanujan.pages.speed.challenge import METHOD, STEPS, TRIES
from ramanujan.pages.speed.downsampling import SampledRun
from ramanujan.physics.integrators import METHODS
from ramanujan.shell import address, display_mode, drawings, sidebar, theme, widgets
from ramanujan.shell.display_mode import folded, slide
from ramanujan.text.numerals import filled
from ramanujan.text.translation import _

TOPICS = {
    "race": _("**Race** *How large is the error?*"),
    "price": _("**Price** *What does accuracy cost?*"),
    "limits": _("**Limits** *Where do numbers end?*"),
}
TOPIC = address.Choice("topic", TOPICS, "race")
ERRORS = {"phase": _("Phase"), "energy": _("Energy")}
ERROR = address.Choice("error", ERRORS, "phase")
URL_PARAMETERS = (
    TOPIC,
    METHOD,
    STEPS,
    TRIES,
    ERROR,
    costs.COST,
    costs.TOLERANCE,
    limits.EXPERIMENT,
    *limits.PREDICTIONS.values(),
)

# Error → title and limits of its axis. Streamlit would show a string below the assignment, because it runs this file.
_AXES = {
    "phase": (_("phase error [turns]"), (1e-6, 10.0)),
    "energy": (_("energy error<br>|<i>E</i>/<i>E</i>₀ − 1|"), (1e-8, 10.0)),
}
_EXPLANATIONS = {
    "phase": _(
        "The **phase error** says how many turns the computed machine is ahead or behind. One turn lasts one period."
    ),
    "energy": _("The **energy error** says how far the energy *E* is from the true energy *E*₀."),
}
# Above the price is its result (`costs`).
_LEADS = {
    "race": _("A computer calculates in small steps: each costs time and adds an error."),
    "limits": filled(
        _("A computer’s numbers have about {digits} digits and end at {largest:2}: even a right formula can fail."),
        digits=np.finfo(float).precision + 1,
        largest=float(np.finfo(float).max),
    ),
}


def show() -> None:
    """Draw the open topic, or the slides of all topics. The measurement of costs, which takes long, begins last."""
    # The address keeps the settings of the other topics.
    address.update(*URL_PARAMETERS)
    if display_mode.is_projector():
        places = {topic: st.container() for topic in TOPICS}
    else:
        st.title(_("Speed and accuracy"), anchor=False)
        places = {topic: tab for topic, tab in widgets.tabs(TOPIC).items() if tab.open}
    for topic, draw in (("race", draw_race), ("limits", draw_limits), ("price", draw_price)):
        if topic in places:
            with places[topic]:
                if topic in _LEADS and not display_mode.is_projector():
                    with st.container(key=f"topic_{topic}"):
                        st.markdown(_LEADS[topic])
                draw()


def draw_race() -> None:
    """Draw the computed machine over the exact one, and the growth of its errors."""
    if display_mode.is_projector():
        with slide("motion", _("Exact and computed")):
            st.header(_("Exact and computed"), anchor=False)
            draw_game()
        with slide("errors", _("How the errors grow")):
            draw_error_growth()
        return
    draw_game()
    draw_error_growth()
    method, steps = address.current(METHOD), address.current(STEPS)
    with display_mode.fold("methods", _("What each of the {count} methods does").format(count=len(METHODS))):
        widgets.table(verdicts.method_table(), "methods")
        st.markdown(verdicts.explain_equal_phases())
    with display_mode.fold("numbers", _("This run in numbers")):
        st.markdown(verdicts.describe_errors(cache.run(method, steps)))
        st.markdown(verdicts.describe_stability(METHODS[method], steps))


def draw_game() -> None:
    """Draw the task, its controls, both machines with their clock, and the verdict."""
    with st.container(key="race"):
        # On a slide and on a wide page, the verdict replaces the task. On a narrow page it is below the machine.
        has_run = bool(challenge.tried_runs())
        if not (display_mode.is_projector() and has_run):
            with st.container(key="race_task"):
                st.markdown(challenge.TASK.text)
        if has_run or not display_mode.is_projector():
            challenge.draw_verdict()
        challenge.draw_controls()
        challenge.draw_machine()


def draw_price() -> None:
    """Draw the cost of accuracy, and that of exactness."""
    with slide("costs", _("What accuracy costs")):
        measure_and_draw = costs.draw_costs()
    fold = None
    if not display_mode.is_projector():
        fold = display_mode.fold("cheapest", _("The cheapest run of each method, and how to read the diagram"))
    folded("arithmetics", _("What exactness costs"), limits.draw_arithmetics)
    measure_and_draw()
    if fold:
        with fold:
            costs.list_cheapest_runs()
            costs.explain_measurement()


def draw_limits() -> None:
    """Draw what becomes of Ω² for very large and small masses, and of the phase after very many periods."""
    with slide("digits", limits.TITLE):
        limits.draw_digits()
    folded("forms", _("Where each of {count} forms of Ω² fails").format(count=len(FORMS)), limits.list_failures)
    with slide("periods", _("Very many periods")):
        limits.draw_phase_errors(sidebar.oscillator())
    solver = _("A general eigen-solver, which does not know this machine")
    folded("solver", solver, limits.explain_solvers, limits.list_zero_modes)


def draw_error_growth() -> None:
    """Draw how an error of all methods grows. The selected method stands out once it has run."""
    method, steps = address.current(METHOD), address.current(STEPS)
    has_run = (method, steps) in challenge.tried_runs()
    if display_mode.is_projector():
        head = st.container()
        place, words = st.columns([2, 1], gap="medium")
    else:
        # On a phone the figure is between its heading and its words, on a wide page beside both.
        row = container("columns", "growth")
        head, place, words = row.container(), row.container(), row.container()
    head.header(_("How the errors grow"), anchor=False)
    with words:
        error = widgets.segmented_control(ERROR, _("Error"), label_visibility="collapsed")
        scale = _("Each line up is 10 times the one below.")
        st.markdown(f"{_EXPLANATIONS[error]} {scale}")
        if not has_run:
            st.markdown(_("Which line belongs to your run? Press *Run*, and it stands out."))
        if not display_mode.is_projector():
            st.markdown(verdicts.describe_method(METHODS[method]))
    runs = {name: cache.run(name, steps) for name in METHODS}
    curves = {}
    for name, run in runs.items():
        # The first period is outside of the figure.
        shown = run.times >= 1
        values = run.energy if error == "energy" else run.phase / math.tau
        curves[METHODS[name].title] = run.times[shown], values[shown]
    title, ends = _AXES[error]
    figure = figures.draw_error_growth(
        curves,
        METHODS[method].title if has_run else None,
        title=title,
        limits=ends,
        allowed=WITHIN if error == "phase" else None,
        colors=theme.colors(),
    )
    alternative = _("The errors of all methods over {periods} periods, with the same steps. {errors}")
    sentences = " ".join(map(_describe_error, runs.values()))
    with place:
        drawings.plot(figure, "growth", alternative.format(periods=PERIODS, errors=sentences))


def _describe_error(run: SampledRun) -> str:
    """State the error of a run at its end."""
    worst = float(np.max(run.energy))
    if not (math.isfinite(run.phase_at_end) and math.isfinite(worst)):
        sentence = _("{method}: the energy has grown beyond the largest floating-point number.")
        return sentence.format(method=METHODS[run.method].title)
    sentence = _("{method}: phase error {turns:2} turns, relative energy error up to {energy:2↑}.")
    return filled(sentence, method=METHODS[run.method].title, turns=abs(run.phase_at_end) / math.tau, energy=worst)


if __name__ == "__main__":
    show()
