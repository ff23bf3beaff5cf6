"""The game of page 5: as few evaluations as possible while the computed machine stays close to the exact one.

Question and verdict are those of the lesson’s task. The result is a point in the work–precision diagram. After the
first attempt, the diagram shows all methods.
"""

import numpy as np
import streamlit as st

from ramanujan import lesson
from ramanujan.accuracy.work_precision import STEPS_PER_PERIOD
from ramanujan.browser import stage
from ramanujan.browser.roles import container
from ramanujan.figures import speed as figures
from ramanujan.integrators import METHODS
from ramanujan.lesson import Attempt
from ramanujan.lesson.answer_tasks import PERIODS, WITHIN
from ramanujan.pages.speed import cache, downsampling, verdicts
from ramanujan.shell import address, display_mode, drawings, sidebar, stages, theme, widgets
from ramanujan.shell.sections import tasks
from ramanujan.translation import _

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


def draw() -> None:
    """Draw the challenge and its result."""
    is_projector = display_mode.is_projector()
    if is_projector:
        draw_question()
    words, picture = st.container(key="beside").columns([5, 4] if is_projector else [4, 5], gap="small")
    with words:
        with container("lead", "question"):
            if not is_projector:
                draw_question()
            st.markdown(TASK.text)
        with st.container(horizontal=True, vertical_alignment="bottom", gap="xsmall"):
            method = widgets.selectbox(METHOD, _("Method"), width="stretch")
            steps = widgets.count(STEPS, _("Steps per period"), width=190 if is_projector else "stretch")
        label = _("Run {periods} periods").format(periods=PERIODS)
        st.button(
            label, key="run", type="primary", icon=":material/play_arrow:", on_click=_add_attempt, args=(method, steps)
        )
        st.markdown(verdicts.describe_method(METHODS[method], steps))
    with picture:
        with container("observed", "race"):
            draw_machine()
        if address.update(TRIES):
            # The first computation of all methods takes long, and the machine moves meanwhile.
            cache.races()
            method, steps = _last_attempt()
            with st.container(key="race_result"):
                tasks.draw_verdict(TASK, Attempt(method=method, steps=steps))


def draw_question() -> None:
    """Draw the question of the game."""
    st.title(_("Speed and accuracy"), anchor=False)
    st.markdown(
        _(
            "**How accurate does a simulation have to be, and what does that cost?** Most simulations advance in small "
            "time steps. This machine can also be solved exactly, so every error can be seen."
        )
    )


def draw_machine() -> None:
    """Draw the exact machine, and the last run as an outline over it."""
    computed = None
    if address.current(TRIES):
        computed = downsampling.stage_payload(cache.run(*_last_attempt(), PERIODS, "float64"))
        computed |= {"run": st.session_state.get(_RUN, 0), "screen_period": _ANIMATION / PERIODS}
    payload = stage.payload(sidebar.oscillator(), sidebar.compression(), computed=computed)
    stages.mount(payload, key="stage_race", label=_("The exact motion"), clock="speed", compact=True, layers=())


def draw_diagram() -> None:
    """Draw the attempts in the work–precision diagram of all methods."""
    curves = {curve.method: curve for curve in cache.races()}
    points = []
    for attempt in address.current(TRIES):
        method, steps = _read_attempt(attempt)
        curve = curves[method]
        index = int(np.argmax(curve.steps_per_period == steps))
        points.append((int(curve.evaluations[index]), float(curve.error[index])))
    drawings.plot(
        figures.draw_work_precision(
            {
                (METHODS[name].title, curve.dtype): downsampling.costs(curve, "evaluations")
                for name, curve in curves.items()
            },
            titles=(_("evaluations of the force"), _("largest angle between both machines [turns]")),
            tolerance=WITHIN,
            marked_runs={_("your run"): figures.MarkedRun(*points[-1], symbol="diamond", size=15, color="ink")},
            tried=points[:-1],
            colors=theme.colors(),
        ),
        "tries",
        _(
            "Work–precision diagram of {periods} periods: the more often a method evaluates the force, the smaller the "
            "angle between the computed and the exact machine."
        ).format(periods=PERIODS),
    )


def _add_attempt(method: str, steps: int) -> None:
    """Callback: append an attempt to the list in the address. A repeated attempt moves to the end."""
    st.session_state[_RUN] = st.session_state.get(_RUN, 0) + 1
    attempt = f"{method}.{steps}"
    others = [tried for tried in address.current(TRIES) if tried != attempt]
    st.session_state[TRIES.name] = (*others, attempt)[-_MOST_TRIES:]


def _read_attempt(attempt: str) -> tuple[str, int]:
    """Return method and steps per period of an attempt in the address, such as "rk4.20"."""
    method, steps = attempt.split(".")
    return method, int(steps)


def _last_attempt() -> tuple[str, int]:
    return _read_attempt(address.current(TRIES)[-1])
