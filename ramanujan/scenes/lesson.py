"""Page 6: the lesson. One stop at a time: predict, observe, explain; tasks; the lecturer's notes.

Where a reader is, and what they have chosen, stands in the address and is kept while they look at other pages
(`progress`). Before a prediction nothing of the answer is on the page: it is not drawn, not said, and not sent.
"""

from __future__ import annotations

import streamlit as st

from ramanujan import lesson, page
from ramanujan.lesson import Stop
from ramanujan.lesson.notes import INTRODUCTION
from ramanujan.scenes import controls, links, progress, stops, tasks
from ramanujan.words import _, ngettext

PARTS = {"stops": _("Stops"), "tasks": _("Tasks"), "notes": _("Lecturer’s notes")}


def choose_part() -> str:
    """Draw the choice between stops, tasks and notes, and return the id of the part that is chosen."""
    now = progress.kept("part", PARTS, "stops")
    st.session_state["lesson_part_choice"] = now
    st.segmented_control(
        _("Part of the lesson"),
        PARTS,
        format_func=PARTS.get,
        required=True,
        key="lesson_part_choice",
        label_visibility="collapsed",
        on_change=lambda: progress.keep("part", st.session_state["lesson_part_choice"]),
    )
    return now


def walk() -> None:
    """Draw the present stop."""
    names = [stop.id for stop in lesson.STOPS]
    now = progress.kept("stop", names, names[0])
    with head:
        page.turn([stop.heading for stop in lesson.STOPS], names.index(now) + 1, lambda to: turn(lesson.STOPS[to - 1]))
    stops.draw(lesson.stop(now), names.index(now) + 1)


def turn(stop: Stop) -> None:
    """Go to a stop."""
    progress.keep("stop", stop.id)
    stops.load(stop, stop.id in progress.predictions())


def work() -> None:
    """Draw the present task."""
    with head:
        name = tasks.choose()
    tasks.draw(lesson.task(name))


def notes() -> None:
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
        right = _("Right: {label}").format(label=stop.option(stop.answer()).label)
        st.markdown(f"##### {number}. {stop.heading} :small[({time})]\n{note.purpose} {note.expect}  \n:small[{right}]")
    st.markdown("\n".join(f"{number}. {source}" for number, source in enumerate(lesson.SOURCES, start=1)))


offered = {"part": PARTS, "stop": [stop.id for stop in lesson.STOPS], "task": [task.id for task in lesson.TASKS]}
keys = [links.one_of(key, texts) for key, texts in offered.items()]
controls.complain(links.complaints([*keys, progress.PREDICTIONS, *tasks.LINK]))
with st.container(horizontal=True, vertical_alignment="center", gap="medium", key="lesson_head"):
    part = choose_part()
    head = st.container(key="turner")
{"stops": walk, "tasks": work, "notes": notes}[part]()
page.give_back("lesson_part_choice")
