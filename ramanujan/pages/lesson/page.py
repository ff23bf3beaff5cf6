"""Page 6: the lesson. One stop at a time: predict, observe, explain; tasks; the lecturer's notes.

Before a prediction nothing of the answer is on the page: it is not drawn, not said, and not sent (`stops`).
"""

from __future__ import annotations

import streamlit as st

from ramanujan import lesson
from ramanujan.browser import page
from ramanujan.lesson import Stop
from ramanujan.lesson.notes import INTRODUCTION
from ramanujan.pages.lesson import cache, classroom, progress, stops, tasks
from ramanujan.shell import address, class_session, widgets
from ramanujan.translation import _, ngettext

KEYS = (*progress.KEYS, *tasks.KEYS)
PART_WORDS = {"stops": _("Stops"), "tasks": _("Tasks"), "notes": _("Lecturer’s notes")}


def show() -> None:
    """Draw the page."""
    classroom.guests()
    with st.container(horizontal=True, vertical_alignment="center", gap="medium", key="lesson_head"):
        part = widgets.chips(progress.PART, _("Part of the lesson"), PART_WORDS, label_visibility="collapsed")
        head = st.container(key="turner")
        classroom.door()
    {"stops": walk, "tasks": work, "notes": notes}[part](head)
    keep_address()
    page.give_back("part")


def withheld() -> tuple[str, ...]:
    """Return the presets that would tell the answer of the present stop, or to a student that of any stop."""
    class_session.arrive()
    if class_session.seat_held():
        return tuple(name for stop in lesson.STOPS for name in stop.presets)
    now = lesson.stop(address.held(progress.STOP))
    if address.held(progress.PART) != "stops" or stops.is_answered(now):
        return ()
    return now.presets


def keep_address() -> None:
    """Keep in the address also what the present part of the page does not draw, and drop what it cannot use."""
    for key in KEYS:
        if not key.bound:
            address.keep(key)
        elif not address.fits(key):
            st.query_params.pop(key.name, None)


def walk(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the present stop, and in the head what turns to another one."""
    now = lesson.stop(address.held(progress.STOP))
    number = lesson.STOPS.index(now) + 1
    with head:
        page.turn([stop.heading for stop in lesson.STOPS], number, lambda to: turn(lesson.STOPS[to - 1]))
    stops.draw(now, number)


def turn(stop: Stop) -> None:
    """Go to a stop, in a callback."""
    st.session_state[progress.STOP.name] = stop.id
    stops.load(stop, stop.id in progress.predictions())


def work(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the present task, and in the head the choice of another one."""
    with head:
        name = widgets.menu(
            progress.TASK, _("Task"), {task.id: task.heading for task in lesson.TASKS}, label_visibility="collapsed"
        )
    tasks.draw(lesson.task(name))


def notes(_head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the lecturer's notes."""
    st.title(_("Lecturer’s notes"), anchor=False)
    minutes = sum(stop.minutes for stop in lesson.STOPS)
    st.markdown(
        _("The lesson has {stops} stops and takes about {minutes} minutes.").format(
            stops=len(lesson.STOPS), minutes=minutes
        )
    )
    st.markdown(INTRODUCTION)
    for number, (stop, note) in enumerate(zip(lesson.STOPS, lesson.NOTES, strict=True), start=1):
        time = ngettext("{n} minute", "{n} minutes", stop.minutes).format(n=stop.minutes)
        right = _("Right answer: {label}").format(label=cache.solution(stop.id).label)
        st.markdown(f"##### {number}. {stop.heading} :small[({time})]\n{note.purpose} {note.expect}  \n:small[{right}]")
    st.markdown("\n".join(f"{number}. {source}" for number, source in enumerate(lesson.SOURCES, start=1)))


if __name__ == "__main__":
    show()
