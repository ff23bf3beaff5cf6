"""Page 6: the lesson. One stop at a time: predict, observe, explain; tasks; the lecturer's notes.

Before a prediction the answer is neither drawn nor sent to the browser (`stops`).
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.browser import components
from ramanujan.pages.lesson import classroom, progress, stops, wall
from ramanujan.shell import address, class_session, sidebar, widgets
from ramanujan.shell.display_mode import columns, is_projector, slide
from ramanujan.shell.navigation import PAGES
from ramanujan.shell.sections import exercise, tasks
from ramanujan.translation import _, ngettext

URL_PARAMETERS = (*progress.URL_PARAMETERS, *tasks.URL_PARAMETERS, *exercise.URL_PARAMETERS)
# The numbers of stops whose notes, or whose results, fill a slide of the projector view.
_NOTES, _LINES = 3, 9
ENDING = _("What you have seen")
_ONWARDS = {
    "oscillator": _("Look for the ratio in step yourself, on the page Oscillator"),
    "derivation": _("Derive Ω² step by step, on the page Derivation"),
    "taxicab": _("Find out more about the number, on the page 1729"),
    "worksheet": _("Print questions with space to write, on the page Worksheet"),
}


def show() -> None:
    """Draw the page."""
    classroom.draw_phone(stops.draw_observation)
    wall.draw_wall()
    if items := address.current(exercise.EXERCISE):
        exercise.draw_exercise(items)
    else:
        draw_parts()
    # These include the parameters of parts that are hidden now.
    address.update(*URL_PARAMETERS)


def draw_parts() -> None:
    """Draw the choice between stops, tasks and notes, and the selected part."""
    with st.container(horizontal=True, vertical_alignment="center", gap="medium", key="lesson_head"):
        part = widgets.segmented_control(progress.PART, _("Part of the lesson"), label_visibility="collapsed")
        head = st.container(key="turner")
        classroom.draw_door()
    {"stops": draw_stops, "tasks": draw_task, "notes": draw_notes}[part](head)
    components.return_focus("part")


def uses_sidebar() -> bool:
    """Return whether the reader sets the machine: in a task, or on request at a stop."""
    return (
        address.current(progress.PART) == "tasks"
        or bool(address.current(exercise.EXERCISE))
        or stops.are_sliders_open()
    )


def withheld_presets() -> tuple[str, ...]:
    """Return the presets that the sidebar omits: all, except at a stop whose right answer is visible."""
    class_session.restore_role()
    if address.current(exercise.EXERCISE):
        return tuple(sidebar.PRESETS)
    name = address.current(progress.STOP)
    walks = address.current(progress.PART) == "stops" and name != progress.END
    if class_session.student_seat() or not walks or not stops.is_answered(lesson.stop(name)):
        return tuple(sidebar.PRESETS)
    return ()


def draw_stops(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the current stop or the end, and at the top the buttons that select another one."""
    path = progress.path()
    places = [*(stop.id for stop in path), progress.END]
    number = places.index(address.current(progress.STOP)) + 1

    def turned(to: int) -> None:
        if not (number < to and number <= len(path) and stops.needs_confirmation(path[number - 1])):
            select_stop(places[to - 1])

    with head:
        # At the desk of a class, a clicker presses the button of the next move instead.
        components.turn(
            [*(stop.heading for stop in path), ENDING],
            number,
            turned,
            clicker=not class_session.lecturer_key(),
            refusal=stops.confirmed_stop(),
        )
    if number <= len(path):
        stops.draw(path[number - 1], number)
    elif class_session.lecturer_key():
        classroom.draw_end()
    else:
        draw_end(path)


def select_stop(place: str) -> None:
    """Select a stop or the end, in a callback."""
    stops.clear_confirmation()
    st.session_state[progress.STOP.name] = place
    if place != progress.END:
        stop = lesson.stop(place)
        stops.load_machine(stop, stops.is_running(progress.prediction(stop)[1]))


def draw_end(path: tuple[lesson.Stop, ...]) -> None:
    """Draw the end: each answered stop with the right answer and the prediction."""
    right, answered, lines = 0, 0, []
    for stop in path:
        chosen, phase = progress.prediction(stop)
        if chosen is None or phase != progress.ANSWERED:
            lines.append(_("- **{heading}** – Not answered yet.").format(heading=stop.heading))
            continue
        answered, right = answered + 1, right + (chosen == stop.right)
        line = (
            _("- **{heading}** – :green[:material/check_circle:] {right}")
            if chosen == stop.right
            else _("- **{heading}** – You predicted: {chosen} :green[**Right:**] {right}")
        )
        named = {"chosen": stop.options[chosen], "right": stop.options[stop.right]}
        lines.append(line.format(heading=stop.heading, **named))
    sentence = _("You answered {answered} of {stops} questions. Your prediction was right at {right} of them.")
    first = _LINES if is_projector() else len(lines)
    with slide("seen", ENDING):
        st.title(ENDING, anchor=False)
        st.markdown(sentence.format(answered=answered, stops=len(path), right=right))
        st.markdown("\n".join(lines[:first]))
    if lines[first:]:
        with slide("seen_on", _("{heading}, continued").format(heading=ENDING)):
            st.markdown("\n".join(lines[first:]))
    with slide("onwards", _("Where to go on")):
        st.markdown(_("Where to go on:"))
        label, turned = _("Set the machine yourself: twelve tasks"), {progress.PART.name: "tasks"}
        st.button(label, key="to_tasks", on_click=st.session_state.update, args=(turned,))
        for name, label in _ONWARDS.items():
            st.page_link(PAGES[name].file, label=label, icon=":material/arrow_forward:")


def draw_task(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the current task, and at the top the choice of another one."""
    with head:
        name = widgets.selectbox(progress.TASK, _("Task"), label_visibility="collapsed")
    tasks.draw_task(lesson.task(name))


def draw_notes(_head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the lecturer's notes, and the choice between all stops and a short lesson."""
    # At the desk of a class the notes are open. A reader first gets a warning that they contain answers.
    label = _("Show the notes on all stops. They name the right answers.")
    with slide("notes", _("Lecturer’s notes")):
        _draw_introduction()
        if not (class_session.lecturer_key() or st.toggle(label, key="notes_shown")):
            return
    halves = columns("notes")
    for start in range(0, len(lesson.STOPS), _NOTES):
        numbered = list(enumerate(lesson.STOPS, start=1))[start : start + _NOTES]
        with halves[2 * start >= len(lesson.STOPS)], slide(f"notes_{start}", numbered[0][1].heading):
            for number, stop in numbered:
                _draw_note(number, stop)
    with slide("sources", _("Sources")):
        st.markdown("\n".join(f"{number}. {source}" for number, source in enumerate(lesson.SOURCES, start=1)))


def _draw_introduction() -> None:
    st.title(_("Lecturer’s notes"), anchor=False)
    lengths = {"short": [stop for stop in lesson.STOPS if stop.short], "all": lesson.STOPS}
    sentence = _("{stops} stops in {minutes} minutes")
    words = {
        name: sentence.format(stops=len(chosen), minutes=sum(stop.minutes for stop in chosen))
        for name, chosen in lengths.items()
    }
    widgets.pills(progress.LENGTH, _("How long is the lesson?"), words)
    st.caption(_("Without a choice, a class goes through the short lesson, and a reader through all of it."))
    st.markdown(lesson.INTRODUCTION)


def _draw_note(number: int, stop: lesson.Stop) -> None:
    time = ngettext("{n} minute", "{n} minutes", stop.minutes).format(n=stop.minutes)
    right = _("Right answer: {label}").format(label=stop.options[stop.right])
    st.markdown(f"##### {number}. {stop.heading} :small[({time})]\n{stop.purpose} {stop.expect}  \n:small[{right}]")


if __name__ == "__main__":
    show()
