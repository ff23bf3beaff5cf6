"""The game of page 5: as few evaluations as possible while the computed machine stays close to the exact one.

Question and verdict are those of the lesson’s task. The work–precision diagram of the page marks each attempt.
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.accuracy.work_precision import PERIODS, STEPS_PER_PERIOD, Run, diagram_curve
from ramanujan.browser import stage
from ramanujan.browser.containers import container
from ramanujan.lesson import Attempt
from ramanujan.lesson.answer_tasks import WITHIN
from ramanujan.pages.speed import cache, downsampling
from ramanujan.physics.integrators import METHODS
from ramanujan.shell import address, display_mode, sidebar, stages, widgets
from ramanujan.shell.sections import tasks
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

TASK = lesson.find_task("cheapest")
METHOD = address.Choice("method", {name: method.title for name, method in METHODS.items()}, "velocity_verlet")
STEPS = address.Count("steps", STEPS_PER_PERIOD[-1], default=12, least=STEPS_PER_PERIOD[0])
TRIES = address.Several("tries", tuple(f"{method}.{steps}" for method in METHODS for steps in STEPS_PER_PERIOD))

_RUN = "speed_run"
"""Session state: number of runs that the visitor has started."""
_MOST_TRIES = 12
"""Largest number of attempts in the address."""
_ANIMATION = 12.0
"""Duration of the first animation of a run [s]."""


def draw_controls() -> None:
    """Draw the method, its steps, the button that starts the race, and the best run so far."""
    side = st.container(key="race_side", gap="xsmall")
    with side.container(horizontal=True, vertical_alignment="bottom", gap="xsmall", key="race_controls"):
        # TRANSLATORS: {idea} continues the name of a method: velocity Verlet uses the velocity at mid-step.
        template = _("{method}: {idea}")
        labels = {name: template.format(method=method.title, idea=method.idea) for name, method in METHODS.items()}
        # Large letters leave no room for the ideas.
        shown = None if display_mode.is_projector() else labels
        method = widgets.selectbox(METHOD, _("Method"), shown, width="stretch")
        steps = widgets.count(STEPS, _("Steps per period"), width="stretch")
        attempt = method, steps
        st.button(_("Run"), key="run", type="primary", on_click=_add_attempt, args=attempt)
    with side:
        draw_best_run()


def draw_machine() -> None:
    """Draw the exact machine, the last run as an outline over it, and the phase of both on a clock.

    Before the first run, the selected one is drawn.
    """
    selected = address.current(METHOD), address.current(STEPS)
    method, steps = [selected, *tried_runs()][-1]
    computed = downsampling.stage_payload(cache.run(method, steps))
    run_name = _("{method}, {steps} steps per period").format(method=METHODS[method].title, steps=steps)
    computed |= {
        "run_name": run_name,
        "within": WITHIN,
        "run": st.session_state.get(_RUN, 0),
        "screen_period": _ANIMATION / PERIODS,
    }
    payload = stage.payload(sidebar.oscillator(), sidebar.compression(), computed=computed)
    with container("observed", "race"):
        stages.mount(payload, key="stage_race", label=_("The exact motion"), clock="speed", compact=True, layers=())


def draw_verdict() -> None:
    """Draw the verdict on the last run, or before the first run what a run does."""
    with st.container(key="race_result"):
        if address.update(TRIES):
            method, steps = tried_runs()[-1]
            tasks.draw_verdict(TASK, Attempt(method=method, steps=steps))
        else:
            sentence = _("*Run* starts both machines again and checks the error after {periods} periods.")
            st.caption(sentence.format(periods=PERIODS))


def draw_best_run() -> None:
    """Draw the run with the fewest evaluations whose error was allowed."""
    with st.container(key="race_best"):
        best = find_best_run()
        if best is None:
            sentence = _("Your best run: none yet. The error must not exceed {goal} of a turn.")
            st.markdown(sentence.format(goal=number(WITHIN, 1)))
            return
        sentence = _("Your best run: **{cost} evaluations**, by {method} with {steps} steps per period.")
        method = METHODS[best.method].title
        st.markdown(filled(sentence, cost=best.evaluations, method=method, steps=best.steps_per_period))


def find_best_run() -> Run | None:
    """Return the attempt with the fewest evaluations among those whose error was allowed."""
    runs = [diagram_curve(method).select(steps) for method, steps in tried_runs()]
    return min((run for run in runs if run.error <= WITHIN), key=lambda run: run.evaluations, default=None)


def _add_attempt(method: str, steps: int) -> None:
    """Callback: append an attempt to the list in the address. A repeated attempt moves to the end.

    Of too many attempts, the oldest is removed that is not the best one.
    """
    st.session_state[_RUN] = st.session_state.get(_RUN, 0) + 1
    attempt = f"{method}.{steps}"
    others = [tried for tried in address.current(TRIES) if tried != attempt]
    best = find_best_run()
    while len(others) >= _MOST_TRIES:
        is_first_best = best is not None and others[0] == f"{best.method}.{best.steps_per_period}"
        others.pop(1 if is_first_best else 0)
    st.session_state[TRIES.name] = (*others, attempt)


def tried_runs() -> list[tuple[str, int]]:
    """Return method and steps per period of each attempt in the address, such as "rk4.20"."""
    tried = []
    for attempt in address.current(TRIES):
        method, steps = attempt.split(".")
        tried.append((method, int(steps)))
    return tried
