"""An exercise by link: questions and tasks that the lecturer chose, one at a time, and at the end a worksheet.

The lecturer composes the link on the page Worksheet.
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.answers import QUESTIONS, find_question
from ramanujan.browser.components import turn
from ramanujan.shell import address, widgets
from ramanujan.shell.display_mode import slide
from ramanujan.shell.menu import PAGES
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.sections import tasks, typed_answer
from ramanujan.text.translation import _

ITEMS = (*QUESTIONS, *(task.id for task in lesson.TASKS))
EXERCISE = address.Several("exercise", ITEMS)
ITEM = address.Count("item", len(ITEMS) + 1)
URL_PARAMETERS = (EXERCISE, ITEM)
END = _("Your worksheet")
FILE = "exercise.md"


def draw_exercise(items: tuple[str, ...]) -> None:
    """Draw the current item of an exercise, or the worksheet after the last item."""
    headings = [*map(find_title, items), END]
    now = min(address.current(ITEM), len(headings))
    with st.container(key="lesson_head"):
        place = _("Part {now} of {count}: {heading}")
        turn.mount_lesson(headings, now, lambda to: st.session_state.update({ITEM.name: to}), place=place)
    if now > len(items):
        draw_worksheet(items)
        return
    item = items[now - 1]
    if item in QUESTIONS:
        draw_question(item)
    else:
        verdict = tasks.draw_task(lesson.find_task(item))
        if verdict.is_done:
            typed_answer.store_answer(item, verdict.sentence, is_right=True)


def draw_question(name: str) -> None:
    """Draw a question of an exercise."""
    with slide("question", find_title(name)):
        st.title(find_title(name), anchor=False)
        typed_answer.judge_typed(name)
        typed_answer.draw_question(name, with_step=False)


def find_title(item: str) -> str:
    """Return the title of a question or task."""
    return typed_answer.find_title(item) if item in QUESTIONS else lesson.find_task(item).heading


def draw_worksheet(items: tuple[str, ...]) -> None:
    """Draw the worksheet, and offer it as a file."""
    text = write_worksheet(items)
    with slide("question", END):
        st.markdown(text)
        with st.container(horizontal=True, vertical_alignment="center", key="worksheet_choices"):
            widgets.download(_("Save this worksheet"), text, FILE, "text/markdown")
            st.caption(
                _("Or print this page with Ctrl+P or Cmd+P. Your answers are kept until you close or reload it.")
            )


def write_worksheet(items: tuple[str, ...]) -> str:
    """Return the worksheet as Markdown: each item with its answer, the time it was first right, and the used hints."""
    lines = ["# " + _("Ramanujan’s oscillator: exercise"), _("Name: {line} Date: {line}").format(line="\\_" * 16), ""]
    for number, item in enumerate(items, start=1):
        text = find_question(item).prompt() if item in QUESTIONS else lesson.find_task(item).text
        lines.append(f"{number}. **{find_title(item)}.** {text}")
        lines += [f"   - {result}" for result in list_results(item)]
    return "\n".join(lines) + "\n"


def list_results(item: str) -> list[str]:
    """Return Markdown lines: the answer to a question or task, when it was first right, and the number of hints."""
    is_question = item in QUESTIONS
    answer = typed_answer.find_answer(item)
    hints = widgets.count_shown_hints(item if is_question else f"task_{item}")
    lines = []
    if answer is None:
        lines.append(_("Not answered.") if is_question else _("Not done yet."))
    else:
        text = answer.answer
        if is_question:
            # Between these marks Markdown interprets nothing.
            text = f"`` {' '.join(text.split()).replace('`', '')} ``"
        lines.append(_("Answer: {answer}").format(answer=text))
        if answer.right_since:
            lines.append(_("Right since {time}.").format(time=f"{answer.right_since:%Y-%m-%d %H:%M %Z}"))
        else:
            lines.append(_("Not right yet."))
    if hints:
        lines.append(_("Hints used: {n}").format(n=hints))
    return lines


def draw_composer() -> None:
    """Draw the editor for the link of an exercise. It is not printed."""
    with st.expander(_("Make an exercise of questions and tasks, as a link for students")):
        chosen = st.multiselect(
            _("Questions and tasks, in their order"),
            ITEMS,
            format_func=find_title,
            key="composed",
            placeholder=_("Choose questions and tasks"),
            # Streamlit has no translation of "Select all".
            select_all=False,
        )
        if not chosen:
            return
        # The link also contains the sliders of the lecturer's machine that differ from their defaults.
        machine = {
            parameter.name: parameter.write(parameter.value)
            for parameter in PARAMETERS.values()
            if parameter.value != parameter.default
        }
        query = {**machine, EXERCISE.name: EXERCISE.write(tuple(chosen))}
        link = address.link_for_others(query, PAGES["lesson"].path).geturl()
        st.markdown(_("For your students:"))
        st.code(link, language=None, wrap_lines=True)
