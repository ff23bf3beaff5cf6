"""The tasks of the lesson on the page: choose one, set the machine, read the verdict."""

from __future__ import annotations

import streamlit as st

from ramanujan import lesson, page, stage
from ramanujan.integrators import METHODS
from ramanujan.lesson import Setting, Task
from ramanujan.lesson.answers import FEWEST_STEPS, MOST_STEPS
from ramanujan.motion import pushed
from ramanujan.number_theory import BODIES
from ramanujan.scenes import controls, links, progress, stops
from ramanujan.scenes.controls import Control
from ramanujan.words import _

RELEASE = Control("task_x0", "x₀", _("Compression at release"), "cm", 0.0, 12.0, 8.0, 0.1, "%.1f", "", 0.01)
GLIDE = Control(
    "task_glide", "−Ẋ₀", _("Initial velocity of the machine"), "cm/s", -20.0, 20.0, 0.0, 0.5, "%.1f", "", 0.01
)
SPIN = Control("task_spin", "Φ̇₀", _("Initial spin of the top cylinder"), "rad/s", -3.0, 3.0, 0.0, 0.1, "%.1f", "")
PLACES = {"task_left": _("Left roller"), "task_right": _("Right roller"), "task_top": _("Body on top")}
PAPER = ("hoop", "cylinder", "cylinder")
SHAPES = {
    "hoop": _("hoop"),
    "shell": _("spherical shell"),
    "cylinder": _("solid cylinder"),
    "sphere": _("solid sphere"),
}
STEPS = "task_steps"
LINK = [
    *(control.in_links for control in (RELEASE, GLIDE, SPIN)),
    links.one_of("task_method", METHODS),
    *(links.one_of(place, BODIES) for place in PLACES),
    links.number(
        STEPS, FEWEST_STEPS, MOST_STEPS, _("from {least} to {most}").format(least=FEWEST_STEPS, most=MOST_STEPS)
    ),
]
_LONGEST = 200


def draw(task: Task) -> None:
    """Draw a task."""
    st.title(task.heading, anchor=False)
    words, picture = st.columns([1, 1], gap="medium") if task.stage else (st.container(), None)
    with words:
        st.markdown(task.text)
        typed = {}
        for field in task.fields:
            typed |= FIELDS[field]()
        setting = Setting(machine=controls.oscillator(), compression=controls.compression(), **typed)
        if not task.fields:
            st.markdown(f":small[{_('Set the machine with the sliders in the sidebar.')}]")
        with st.container(key="task_verdict"):
            verdict(task, setting)
        stops.hints(f"task_{task.id}", task.hints)
    if picture:
        with picture:
            machine(task, setting)


def choose() -> str:
    """Draw the choice of the task, and return its id."""
    names = {task.id: task.heading for task in lesson.TASKS}
    now = progress.kept("task", names, lesson.TASKS[0].id)
    st.session_state["task_choice"] = now
    st.selectbox(
        _("Task"),
        names,
        format_func=names.get,
        key="task_choice",
        label_visibility="collapsed",
        on_change=lambda: progress.keep("task", st.session_state["task_choice"]),
    )
    return now


def verdict(task: Task, setting: Setting) -> None:
    """Say whether the task is done, and how far away the goal is."""
    judged = task.judge(setting)
    box = st.container(border=True)
    if judged.done:
        done = _("Done.")
        box.markdown(f":green[:material/check_circle: **{done}**] {stops.plain(judged.sentence)}")
    else:
        yet = _("Not yet.")
        box.markdown(f":orange[:material/flag: **{yet}**] {stops.plain(judged.sentence)}")


def machine(task: Task, setting: Setting) -> None:
    """Draw the machine as it was set."""
    free = "release" in task.fields
    initial = pushed(setting.machine, setting.release, setting.glide, setting.spin) if free else None
    fixed = (setting.release, setting.release)
    with st.container(key="observed"):
        stage.mount(
            stage.payload(setting.machine, setting.release if free else setting.compression, initial=initial),
            limits=fixed if free else controls.limits("compression"),
            watch={key: each for key, each in controls.WATCH.items() if not (free and key == "compression")},
            key=f"stage_task_{task.id}",
            layers=(),
            narrow=True,
            hide=task.hides,
            on_released=None if free else controls.set_compression,
        )


# What is set beside the machine


def _release() -> dict[str, float]:
    return {"release": controls.page_slider(RELEASE)}


def _glide() -> dict[str, float]:
    return {"glide": controls.page_slider(GLIDE)}


def _spin() -> dict[str, float]:
    return {"spin": controls.page_slider(SPIN)}


def _part() -> dict[str, float | None]:
    text = st.text_input(_("Part of a period"), key="task_part", placeholder="1/3", max_chars=20)
    return {"part": controls.read_number(text)}


def _stopwatch() -> dict[str, float | int | None]:
    seconds = page.stopwatch("task_stopwatch")
    periods = st.number_input(_("For how many periods?"), 1, 100, 10, key="task_periods")
    return {"seconds": seconds, "periods": int(periods)}


def _formula() -> dict[str, str]:
    return {"formula": st.text_input("ε =", key="task_formula", placeholder="(sqrt(5) − 1)/2", max_chars=_LONGEST)}


def _method() -> dict[str, str]:
    return {"method": _one_of("task_method", _("Method"), {name: METHODS[name].title for name in METHODS}, "rk4")}


def _steps() -> dict[str, int]:
    text = st.query_params.get(STEPS, "")
    given = int(text) if text.isascii() and text.isdigit() and FEWEST_STEPS <= int(text[:9]) <= MOST_STEPS else 100
    st.session_state.setdefault(STEPS, st.session_state.get(f"lesson_{STEPS}", given))
    steps = st.number_input(_("Steps per period"), FEWEST_STEPS, MOST_STEPS, key=STEPS)
    progress.keep(STEPS, str(steps))
    st.session_state[f"lesson_{STEPS}"] = int(steps)
    return {"steps": int(steps)}


def _bodies() -> dict[str, tuple[str, ...]]:
    columns = st.columns(len(PLACES))
    chosen = []
    for column, (place, label), paper in zip(columns, PLACES.items(), PAPER, strict=True):
        with column:
            chosen.append(_one_of(place, label, SHAPES, paper))
    return {"bodies": tuple(chosen)}


def _one_of(key: str, label: str, labels: dict[str, str], default: str) -> str:
    """Draw a choice whose id stands in the address, and return the id."""
    now = progress.kept(key, labels, default)
    widget = f"{key}_choice"
    st.session_state[widget] = now
    st.selectbox(
        label,
        labels,
        format_func=labels.get,
        key=widget,
        on_change=lambda: progress.keep(key, st.session_state[widget]),
    )
    return now


FIELDS = {
    "release": _release,
    "glide": _glide,
    "spin": _spin,
    "part": _part,
    "stopwatch": _stopwatch,
    "formula": _formula,
    "method": _method,
    "steps": _steps,
    "bodies": _bodies,
}
"""What a task's field draws, and the part of a `Setting` that it returns."""
