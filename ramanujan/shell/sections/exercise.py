"""An exercise by link: chosen questions and tasks, one at a time, and at the end a worksheet to print or save.

The lecturer composes the link on the page Worksheet. The link for students contains the name of the exercise, and the
lecturer's link also contains its key (`shell/worksheet_keys.py`).
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.answers import QUESTIONS, question
from ramanujan.browser import components
from ramanujan.shell import address, display_mode, widgets, worksheet_keys
from ramanujan.shell.display_mode import slide
from ramanujan.shell.navigation import PAGES
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.sections import questions, tasks
from ramanujan.translation import _

ITEMS = (*QUESTIONS, *(task.id for task in lesson.TASKS))
EXERCISE = address.Several("exercise", ITEMS)
ITEM = address.Count("item", len(ITEMS) + 1)
WORKSHEET = worksheet_keys.name_parameter("exercise_name")
KEY = worksheet_keys.key_parameter("exercise_key")
URL_PARAMETERS = (EXERCISE, ITEM, WORKSHEET, KEY)
END = _("Your worksheet")
FILE = "exercise.md"


def draw_exercise(items: tuple[str, ...]) -> None:
    """Draw the current item of an exercise, or the worksheet after the last item."""
    headings, with_key = [*map(title, items), END], worksheet_keys.fits(KEY, address.current(WORKSHEET))
    now = min(address.current(ITEM), len(headings))
    with st.container(key="lesson_head"):
        place = _("Part {now} of {count}: {heading}")
        components.turn(headings, now, lambda to: st.session_state.update({ITEM.name: to}), place=place)
    if now > len(items):
        draw_worksheet(items)
    elif (name := items[now - 1]) in QUESTIONS:
        with slide("question", title(name)):
            st.title(title(name), anchor=False)
            questions.judge_typed(name)
            questions.draw_question(name, with_step=with_key)
            if with_key:
                st.latex(questions.step_to_answer(name))
    else:
        judged = tasks.draw_task(lesson.task(name))
        if judged.done:
            questions.store_answer(name, judged.sentence, is_right=True)


def title(item: str) -> str:
    """Return the title of a question or task."""
    return questions.title(item) if item in QUESTIONS else lesson.task(item).heading


def draw_worksheet(items: tuple[str, ...]) -> None:
    """Draw the worksheet, and offer it as a file."""
    written = worksheet_text(items)
    with slide("question", END):
        st.markdown(written)
        with st.container(horizontal=True, vertical_alignment="center", key="worksheet_choices"):
            widgets.download(_("Save this worksheet"), written, FILE, "text/markdown")
            st.caption(
                _("Or print this page with Ctrl+P or Cmd+P. Your answers are kept until you close or reload it.")
            )


def worksheet_text(items: tuple[str, ...]) -> str:
    """Return the worksheet as Markdown: each item with its answer, the time of the first right one, and used hints."""
    lines = ["# " + _("Ramanujan’s oscillator: exercise"), _("Name: {line} Date: {line}").format(line="\\_" * 16), ""]
    for number, item in enumerate(items, start=1):
        is_question = item in QUESTIONS
        text = question(item).prompt() if is_question else lesson.task(item).text
        given = questions.answer_to(item)
        lines.append(f"{number}. **{title(item)}.** {text}")
        if given is None:
            lines.append("   - " + (_("Not answered.") if is_question else _("Not done yet.")))
        else:
            # Between these marks Markdown interprets nothing.
            answer = f"`` {' '.join(given.answer.split()).replace('`', '')} ``" if is_question else given.answer
            lines.append("   - " + _("Answer: {answer}").format(answer=answer))
            right = _("Right since {time}.") if given.right_since else _("Not right yet.")
            time = f"{given.right_since:%Y-%m-%d %H:%M %Z}" if given.right_since else ""
            lines.append("   - " + right.format(time=time))
        if hints := widgets.hints_shown(item if is_question else f"task_{item}"):
            lines.append("   - " + _("Hints used: {n}").format(n=hints))
    return "\n".join(lines) + "\n"


def draw_composer() -> None:
    """Draw the editor for the links of an exercise. It is neither printed nor shown in the projector view."""
    if display_mode.is_projector():
        return
    with st.expander(_("Make an exercise of questions and tasks, as a link for students")):
        chosen = st.multiselect(
            _("Questions and tasks, in their order"),
            ITEMS,
            format_func=title,
            key="composed",
            placeholder=_("Choose questions and tasks"),
            # Streamlit has no translation of "Select all".
            select_all=False,
        )
        if not chosen:
            return
        machine = {each.name: f"{each.value:g}" for each in PARAMETERS.values() if each.value != each.default}
        key = st.session_state.setdefault("composed_key", worksheet_keys.new())
        query = {**machine, EXERCISE.name: EXERCISE.write(tuple(chosen)), WORKSHEET.name: worksheet_keys.name(key)}
        link = address.link_for_others(query, PAGES["lesson"].path).geturl()
        st.markdown(_("For your students:"))
        st.code(link, language=None, wrap_lines=True)
        st.markdown(_("For you, with the key:"))
        st.code(f"{link}&{KEY.name}={key}", language=None, wrap_lines=True)
