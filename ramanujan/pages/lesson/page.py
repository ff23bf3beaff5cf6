"""Page 6: the lesson. One stop at a time: predict, observe, explain; tasks; the lecturer's notes.

Before a prediction the answer is neither drawn nor sent to the browser (`stops`).
"""

from collections.abc import Sequence
from contextlib import nullcontext
from functools import partial

import streamlit as st

from ramanujan import lesson
from ramanujan.browser.components import keys, turn
from ramanujan.classroom.rules import Phase
from ramanujan.pages.classroom import desk, door, phone, wall
from ramanujan.pages.classroom.shared_elements import last_sentence
from ramanujan.pages.lesson import stops
from ramanujan.shell import address, class_session, progress, sidebar, widgets
from ramanujan.shell.display_mode import columns, is_projector, picture_and_words, slide
from ramanujan.shell.menu import PAGES
from ramanujan.shell.sections import cubes, exercise, tasks
from ramanujan.text.translation import _, ngettext, pgettext

URL_PARAMETERS = (*progress.URL_PARAMETERS, *tasks.URL_PARAMETERS, *exercise.URL_PARAMETERS)
# Numbers of stops on a slide of the projector view: with their notes, and with their results.
_NOTES_PER_SLIDE, _RESULTS_PER_SLIDE = 3, 7
ENDING = _("What you have seen")
# A style rule without the drawer of sliders and the value of Ω²m/k, which the first stops have not yet explained.
# In page.css it would need :has(), which is slow.
_WITHOUT_DRAWER = "<style>:root:root:root { --drawer: 0px; --drawer-content: none; --stage-readouts: none; }</style>"
# The sizes of clock and machine at a stop with a slider below them. See _WITHOUT_DRAWER.
_ABOVE_SLIDER = "<style>:root { @media (width >= 1000px) { --clock: 24vh; --picture: 36vh; } }</style>"
_ONWARDS = {
    "oscillator": _("Look for the ratio in step yourself, on the page Oscillator"),
    "derivation": _("Derive Ω² step by step, on the page Derivation"),
    "taxicab": _("Find out more about the number, on the page 1729"),
    "worksheet": _("Print questions with space to write, on the page Worksheet"),
}


def draw_header() -> bool:
    """Draw the slider of m′ if the stop asks for it, and return whether it does. The style sheet places it last."""
    class_session.restore_role()
    stop = find_current_stop()
    is_reader = not (class_session.student_seat() or class_session.wall_code() or is_projector())
    if not (stop and stop.sliders and is_reader and stops.is_running(read_prediction(stop)[1])):
        return False
    withheld = withheld_presets()
    st.html(_ABOVE_SLIDER)
    with st.container(key="stop_slider"):
        st.markdown(stop.sliders)
        sidebar.draw_slider("m_prime", snaps=not withheld)
    sidebar.draw(withheld, PAGES["lesson"].folded_parameters, placed=("m_prime",))
    return True


def show() -> None:
    """Draw the page."""
    phone.draw_phone(stops.draw_observation)
    wall.draw_wall(stops.draw_observation)
    items = address.current(exercise.EXERCISE)
    if items:
        exercise.draw_exercise(items)
    else:
        draw_parts()
    # Also write the parameters of parts that are hidden now.
    address.update(*URL_PARAMETERS)


def draw_parts() -> None:
    """Draw the choice between stops, tasks and notes, and the selected part."""
    with st.container(horizontal=True, vertical_alignment="center", gap="medium", key="lesson_head"):
        part = widgets.segmented_control(progress.PART, _("Part of the lesson"), label_visibility="collapsed")
        head = st.container(key="turner")
        door.draw_door()
    {"stops": draw_stops, "tasks": draw_task, "notes": draw_notes}[part](head)
    keys.return_focus("part")


def uses_sidebar() -> bool:
    """Return whether the reader sets the machine, in a task or exercise."""
    return address.current(progress.PART) == "tasks" or bool(address.current(exercise.EXERCISE))


def withheld_presets() -> tuple[str, ...]:
    """Return the presets that the sidebar omits: all, except at a stop whose right answer is visible."""
    # The sidebar is drawn before the page. In the first run the role is still only in the address.
    class_session.restore_role()
    stop = find_current_stop()
    if stop and not class_session.student_seat() and read_prediction(stop)[1] == progress.ANSWERED:
        return ()
    return tuple(sidebar.PRESETS)


def find_current_stop() -> lesson.Stop | None:
    """Return the stop on the page; None in another part of the lesson, in an exercise and at the end."""
    name = address.current(progress.STOP)
    is_at_stop = address.current(progress.PART) == "stops" and name != progress.END
    return lesson.find_stop(name) if is_at_stop and not address.current(exercise.EXERCISE) else None


def read_prediction(stop: lesson.Stop) -> tuple[str | None, str]:
    """Return the reader's prediction and the phase of a stop, as `progress.read_prediction`.

    The lecturer's page follows the phase of the class and ignores the lecturer's own prediction.
    """
    class_phase = class_session.find_class_phase(stop)
    if class_phase is None:
        return progress.read_prediction(stop)
    phases = {Phase.RUNNING: progress.MISSED, Phase.SOLVED: progress.ANSWERED}
    return None, phases.get(class_phase, progress.ASKED)


def draw_stops(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the current stop or the end, and at the top the buttons that select another one."""
    st.html(_WITHOUT_DRAWER)
    path = progress.list_stops()
    ids = [*(stop.id for stop in path), progress.END]
    number = ids.index(address.current(progress.STOP)) + 1

    def go_to(new_number: int) -> None:
        select_stop(ids[new_number - 1])

    with head:
        # At the desk of a class, the keys of a clicker press the buttons of the desk (`classroom`).
        turn.mount_lesson(
            [*(stop.heading for stop in path), ENDING],
            number,
            go_to,
            page_keys_turn=not class_session.lecturer_key(),
        )
    if number <= len(path):
        draw_stop(path[number - 1], number)
    elif class_session.lecturer_key():
        desk.draw_end()
    else:
        draw_end(path)


def draw_stop(stop: lesson.Stop, number: int) -> None:
    """Draw the stop with this number, for a reader or at the lecturer's desk."""
    class_phase = class_session.find_class_phase(stop)
    draw_desk = None if class_phase is None else partial(desk.draw_desk, stop, class_phase)
    stops.draw(stop, number, *read_prediction(stop), draw_desk=draw_desk)


def select_stop(name: str) -> None:
    """Callback: select a stop or the end."""
    st.session_state[progress.STOP.name] = name
    if name != progress.END:
        stop = lesson.find_stop(name)
        _option, phase = progress.read_prediction(stop)
        stops.load_machine(stop, stops.is_running(phase))


def draw_end(path: tuple[lesson.Stop, ...]) -> None:
    """Draw the end: the predictions and what happened, the number of the lesson, and where to go on."""
    rows, missed, unanswered = [], [], []
    for number, stop in enumerate(path, start=1):
        chosen, phase = progress.read_prediction(stop)
        if not chosen or phase != progress.ANSWERED:
            unanswered.append((number, stop))
            continue
        prediction = _(":green[:material/check_circle:] Right")
        if chosen != stop.right:
            missed.append((number, stop))
            prediction = stop.options[chosen]
        rows.append((f"**{number}. {stop.heading}**", prediction, stop.options[stop.right]))
    sentence = _("You have not answered a question yet.")
    if rows:
        sentence = _("You answered {answered} of {stops} questions. Your prediction was right at {right} of them.")
    heading = ENDING if rows else _("The end of the lesson")
    numbers = {"answered": len(rows), "stops": len(path), "right": len(rows) - len(missed)}
    first = _RESULTS_PER_SLIDE if is_projector() else len(rows)
    results, onwards = (nullcontext(), nullcontext()) if is_projector() else st.columns([5, 3], gap="large")
    with results, slide("seen", heading):
        st.title(heading, anchor=False)
        st.container(key="ending").markdown(sentence.format(**numbers))
        if rows:
            draw_results(rows[:first], "seen")
        # The table of a slide names the stops, and leaves room for their numbers only.
        is_short = is_projector() and bool(rows)
        if missed:
            draw_links(_("Look at the reason again:"), missed, "missed", is_short=is_short)
        # On a page, who has answered nothing begins with the first stop. The slide of a class shows all of them.
        if unanswered and (rows or is_projector()):
            draw_links(_("Still open:"), unanswered, "open", is_short=is_short)
        elif unanswered:
            draw_links(_("Begin with:"), unanswered[:1], "open", is_short=False)
    if rows[first:]:
        with results, slide("seen_on", _("{heading}, continued").format(heading=ENDING)):
            draw_results(rows[first:], "seen_on")
    with onwards, slide("onwards", _("Where to go on")), st.container(key="onwards"):
        picture, words = picture_and_words()
        # A reader's own end does not reveal the answer to the question about the number.
        if not unanswered or is_projector():
            with picture:
                st.markdown(cubes.reason())
                cubes.draw_stacks(with_values=False)
        with words:
            draw_onwards()


def draw_links(title: str, chosen_stops: Sequence[tuple[int, lesson.Stop]], key: str, *, is_short: bool) -> None:
    """Draw a title and a button for each of some numbered stops, which selects it; `is_short` omits the names."""
    with st.container(horizontal=True, vertical_alignment="center", gap="xsmall", key=f"{key}_stops"):
        st.markdown(title, width="content")
        for number, stop in chosen_stops:
            label = str(number) if is_short else f"{number}. {stop.heading}"
            st.button(label, key=f"{key}_{stop.id}", on_click=select_stop, args=(stop.id,))


def draw_onwards() -> None:
    """Draw the button of the tasks and the links to other pages."""
    st.markdown(_("Where to go on:"))
    label = _("Set the machine yourself: twelve tasks")
    new_part = {progress.PART.name: "tasks"}
    st.button(label, key="to_tasks", on_click=st.session_state.update, args=(new_part,))
    for name, label in _ONWARDS.items():
        st.page_link(PAGES[name].file, label=label, icon=":material/arrow_forward:")


def draw_results(rows: Sequence[tuple[str, str, str]], key: str) -> None:
    """Draw a table of stops, each with its prediction and what happened."""
    widgets.table([(pgettext("of the lesson", "Stop"), _("Your prediction"), _("What happened")), *rows], key)


def draw_task(head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the current task, and at the top the choice of another one."""
    with head:
        name = widgets.selectbox(progress.TASK, _("Task"), label_visibility="collapsed")
    tasks.draw_task(lesson.find_task(name))


def draw_notes(_head: st.delta_generator.DeltaGenerator) -> None:
    """Draw the choice between all stops and a short lesson, and the lecturer's notes on its stops."""
    st.html(_WITHOUT_DRAWER)
    with slide("notes", _("Lecturer’s notes")):
        shows_answers = _draw_introduction()
    with st.container(key="notes_list"):
        path = progress.list_stops()
        for start in range(0, len(path), _NOTES_PER_SLIDE):
            group = path[start : start + _NOTES_PER_SLIDE]
            with slide(f"notes_{start}", group[0].heading):
                for number, stop in enumerate(group, start=start + 1):
                    _draw_note(number, stop, shows_answers)
        heading = _("Sources")
        with slide("sources", heading):
            sources = "\n".join(f"{number}. {source}" for number, source in enumerate(lesson.SOURCES, start=1))
            st.markdown(f"##### {heading}\n{sources}")


def _draw_introduction() -> bool:
    """Draw the introduction of the notes and the choice of the lesson's length. Return whether the notes are open."""
    st.title(_("Lecturer’s notes"), anchor=False)
    lengths = {"short": [stop for stop in lesson.STOPS if stop.is_in_short_lesson], "all": lesson.STOPS}
    template = _("{stops} stops in {minutes} minutes")
    labels = {}
    for length, included in lengths.items():
        labels[length] = template.format(stops=len(included), minutes=sum(stop.minutes for stop in included))
    choice, introduction = columns("introduction")
    with choice:
        widgets.pills(progress.LENGTH, _("How long is the lesson?"), labels)
        st.caption(_("Without a choice, a class goes through the short lesson, and a reader through all of it."))
        # At the desk of a class the notes are open. A reader first gets a warning that they contain answers.
        label = _("Show the notes on all stops. They name the right answers.")
        shows_answers = bool(class_session.lecturer_key()) or st.toggle(label, key="notes_shown")
    with introduction:
        st.markdown(lesson.INTRODUCTION)
    return shows_answers


def _draw_note(number: int, stop: lesson.Stop, shows_answer: bool) -> None:
    """Draw the question of a stop, and on demand its purpose, what to expect, and the right answer."""
    time = ngettext("{n} minute", "{n} minutes", stop.minutes).format(n=stop.minutes)
    lines = [f"##### {number}. {stop.heading} :small[({time})]", last_sentence(stop.question)]
    if shows_answer:
        right = _("Right answer: {label}").format(label=stop.options[stop.right])
        lines += [f"**{right}**", f"{stop.purpose} {stop.expect}"]
    st.markdown("  \n".join(lines))


if __name__ == "__main__":
    show()
