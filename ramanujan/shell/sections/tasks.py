"""The tasks of the lesson on the page: choose a task, set the machine, read the verdict."""

from dataclasses import replace

import streamlit as st

from ramanujan.accuracy.work_precision import STEPS_PER_PERIOD
from ramanujan.browser import stage
from ramanujan.browser.components import stopwatch
from ramanujan.browser.containers import container
from ramanujan.lesson import Attempt, Task, TaskVerdict
from ramanujan.physics.integrators import METHODS
from ramanujan.physics.motion import with_initial_velocities
from ramanujan.shell import address, parameters, sidebar, stages, widgets
from ramanujan.shell.display_mode import is_projector, picture_and_words, slide
from ramanujan.shell.parameters import WATCH, Parameter
from ramanujan.shell.sections import places
from ramanujan.text.names import SHAPES
from ramanujan.text.reading import explain_ambiguous_number, read_number
from ramanujan.text.translation import _

# As in `parameters`: name, symbol, meaning, unit, least, most, default, step, format, scale.
RELEASE = Parameter("task_x0", "x₀", _("Compression at release"), "cm", 0.0, 12.0, 8.0, 0.1, "%.1f", 0.01)
GLIDE, SPIN = replace(parameters.GLIDE, name="task_glide"), replace(parameters.SPIN, name="task_spin")
METHOD = address.Choice("task_method", {name: method.title for name, method in METHODS.items()}, "rk4")
STEPS = address.Count("task_steps", STEPS_PER_PERIOD[-1], default=100, least=STEPS_PER_PERIOD[0])
PERIODS = address.Count("task_periods", 100, default=10)
BODY_PARAMETERS = [address.Choice(f"task_{place}", SHAPES, body) for place, body in places.PAPER_BODIES.items()]
"""The URL parameters of the bodies at the places left, right and top."""
URL_PARAMETERS = (RELEASE, GLIDE, SPIN, METHOD, STEPS, PERIODS, *BODY_PARAMETERS)
_EXAMPLE = _("For example {entry}")


def draw_task(task: Task) -> TaskVerdict:
    """Draw a task, and return the verdict on the current settings."""
    with slide("task", task.heading):
        both = st.container(key="beside" if task.has_stage else None)
        if task.has_stage and is_projector():
            picture, words = picture_and_words()
        elif task.has_stage:
            words, picture = both.columns(2, gap="medium")
        else:
            words = picture = both
        with words, container("lead", "question"):
            st.title(task.heading, anchor=False)
            st.markdown(task.text)
        with words:
            typed = {field: FIELDS[field]() for field in task.fields}
            attempt = Attempt(machine=sidebar.oscillator(), compression=sidebar.compression(), **typed)
            if not task.fields:
                st.markdown(_(":small[Set the machine with its sliders.]"))
        if task.has_stage:
            with picture:
                draw_machine(task, attempt)
        # In the projector view there is room below a machine without clocks.
        with picture if is_projector() and task.fields else words:
            with st.container(key="task_verdict"):
                verdict = draw_verdict(task, attempt)
            widgets.draw_hints(f"task_{task.id}", [widgets.escape(hint) for hint in task.hints])
    return verdict


def draw_verdict(task: Task, attempt: Attempt) -> TaskVerdict:
    """Draw whether the task is complete, and the distance to the goal; return the verdict."""
    verdict = task.judge(attempt)
    sentence = widgets.escape(verdict.sentence)
    if not verdict.is_judged:
        st.markdown(f":small[{sentence}]")
        return verdict
    done, not_yet = _("Done."), _("Not yet.")
    if verdict.is_done:
        heading = f":green[:material/check_circle: **{done}**]"
    else:
        heading = f":orange[:material/flag: **{not_yet}**]"
    st.container(border=True).markdown(f"{heading} {sentence}")
    return verdict


def draw_machine(task: Task, attempt: Attempt) -> None:
    """Draw the machine of a task as the visitor has set it."""
    has_formula = "formula" in task.fields
    options = {
        "key": f"stage_task_{task.id}",
        "narrow": True,
        "hide": task.hides,
        "compact": has_formula,
        "layers": ("coordinates",) if has_formula else (),
    }
    with container("observed", "part"):
        if "release" not in task.fields:
            stages.mount(stage.payload(attempt.machine, attempt.compression), **options)
            return
        # The initial motion of this machine has its own controls. Equal limits of x₀ fix the slab.
        initial = with_initial_velocities(attempt.machine, attempt.release, attempt.glide, attempt.spin)
        _least, most = RELEASE.limits
        stages.mount(
            stage.payload(attempt.machine, attempt.release, initial=initial),
            limits=(most, most),
            watch={key: settings for key, settings in WATCH.items() if key != "compression"},
            **options,
        )


def _bodies() -> tuple[str, ...]:
    """Draw a menu for the body at each place, and return the three bodies."""
    bodies = []
    for column, parameter, label in zip(st.columns(3), BODY_PARAMETERS, places.PLACE_WORDS.values(), strict=True):
        with column:
            bodies.append(widgets.selectbox(parameter, label))
    return tuple(bodies)


def _part() -> float | None:
    """Draw the box for a part of a period; return the typed number, or None for an invalid or ambiguous text."""
    text = st.text_input(_("Part of a period"), key="task_part", placeholder=_EXAMPLE.format(entry="1/3"))
    refusal = explain_ambiguous_number(text)
    if refusal:
        st.markdown(f":small[{widgets.escape(refusal)}]")
        return None
    return read_number(text)


FIELDS = {
    "release": lambda: widgets.page_slider(RELEASE),
    "glide": lambda: widgets.page_slider(GLIDE),
    "spin": lambda: widgets.page_slider(SPIN),
    "part": _part,
    "seconds": lambda: stopwatch.mount("task_stopwatch"),
    "periods": lambda: widgets.count(PERIODS, _("For how many periods?")),
    "formula": lambda: st.text_input("ε =", key="task_formula", placeholder=_EXAMPLE.format(entry="(sqrt(5) − 1)/2")),
    "method": lambda: widgets.selectbox(METHOD, _("Method")),
    "steps": lambda: widgets.count(STEPS, _("Steps per period")),
    "bodies": _bodies,
}
"""Name of a field of `Attempt` → function that draws its control and returns its value."""
