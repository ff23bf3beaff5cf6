"""A question with a box for a typed formula, hints and a verdict, on the page Derivation and in exercises."""

from dataclasses import dataclass
from datetime import datetime
from functools import cache

import streamlit as st

from ramanujan.answers import QUESTIONS, Verdict, find_answer_equations, find_question, judge
from ramanujan.answers.grammar import UnreadableError, typeset
from ramanujan.answers.questions import EQUATION
from ramanujan.browser import stage
from ramanujan.derivation.rows import make_row
from ramanujan.shell import address, local_time, sidebar, stages, widgets
from ramanujan.shell.equation_blocks import typeset_beside_machine
from ramanujan.shell.shared_cache import responsive
from ramanujan.text.translation import _

QUESTION = address.Choice("question", tuple(QUESTIONS))
"""The open question. The page then leaves out its steps and results, which contain the answers."""
VERDICTS = {
    "right": (st.success, ":material/check_circle:"),
    "unsimplified": (st.info, ":material/compress:"),
    "wrong": (st.warning, ":material/lightbulb:"),
    "unreadable": (st.error, ":material/help:"),
}
"""Kind of a verdict → the function that draws it, and its icon."""
_LONGEST = 1000
"""Largest length of a stored answer."""
_ANSWERS = "answers_given"
"""Session state: question or task → its `GivenAnswer`."""


@dataclass(frozen=True)
class GivenAnswer:
    """A stored answer to a question or task: the last answer, or the first right one with its time."""

    answer: str
    right_since: datetime | None


def draw_section() -> None:
    """Draw a button for each question, which opens it."""
    st.header(_("Try it yourself"), anchor="try")
    solved = [name for name in QUESTIONS if is_solved(name)]
    if solved:
        st.markdown(_("**Solved so far: {n} of {all}**").format(n=len(solved), all=len(QUESTIONS)))
    with st.container(key="questions"):
        for name in QUESTIONS:
            icon = ":material/check_circle:" if name in solved else ":material/edit:"
            st.button(find_title(name), key=f"open_{name}", type="tertiary", icon=icon, on_click=choose, args=(name,))


def draw_chosen(name: str) -> None:
    """Draw the chosen question with its verdict, and buttons that lead to the next one and back to the page."""
    st.title(find_title(name), anchor=False)
    judge_typed(name)
    draw_question(name)
    following = find_unsolved(name)
    with st.container(horizontal=True, key="after_question"):
        if is_solved(name) and following:
            label = _("Next: {title}").format(title=find_title(following))
            st.button(label, key="next_question", type="primary", on_click=choose, args=(following,))
        st.button(_("Back to the derivation"), key="close_question", on_click=choose, args=(None,))


def find_unsolved(name: str) -> str | None:
    """Return the first unsolved question after a question; after the last one, begin again. None if all are solved."""
    names = list(QUESTIONS)
    place = names.index(name) + 1
    return next((question for question in names[place:] + names[:place] if not is_solved(question)), None)


def choose(name: str | None) -> None:
    """Callback: open a question, or close it."""
    st.session_state[QUESTION.name] = name


def find_title(name: str) -> str:
    """Return the title of a question."""
    quantity = find_question(name).quantity
    return quantity[:1].upper() + quantity[1:]


def is_solved(name: str) -> bool:
    """Return whether a question has a right answer."""
    answer = find_answer(name)
    return answer is not None and answer.right_since is not None


def judge_typed(name: str) -> None:
    """Judge the answer in the box of a question, if there is one, and store it."""
    text = st.session_state.get(f"answer_{name}")
    if text:
        verdict = judge_answer(name, text)
        store_answer(name, text, is_right=verdict.kind == "right")


def store_answer(name: str, answer: str, is_right: bool) -> None:
    """Store an answer for the session. The first right answer is not replaced."""
    if is_solved(name):
        return
    right_since = datetime.now(local_time.time_zone()) if is_right else None
    answers = st.session_state.setdefault(_ANSWERS, {})
    answers[name] = GivenAnswer(answer[:_LONGEST], right_since)


def find_answer(name: str) -> GivenAnswer | None:
    """Return the stored answer to a question or task, or None."""
    return st.session_state.get(_ANSWERS, {}).get(name)


def draw_question(name: str, with_step: bool = True) -> None:
    """Draw a question next to the machine with its coordinates.

    Parameters
    ----------
    name : name of the question
    with_step : whether the last hint shows the step to the answer
    """
    with st.container(key="asked"):
        words, picture = st.columns(2)
    with picture:
        label = _("The machine and its coordinates")
        stages.mount(None, key="stage_asked", layers=("coordinates",), compact=True, label=label)
        publish_machine()
    with words:
        draw_box(name, with_step)


@st.fragment(key="asked_machine")
def publish_machine() -> None:
    """Publish the settings of the machine next to a question."""
    stages.publish(stage.payload(sidebar.oscillator(), sidebar.compression()), key="stage_asked")


def draw_box(name: str, with_step: bool) -> None:
    """Draw the text of a question, its box, the verdict and the hints.

    Parameters
    ----------
    name, with_step : as for `draw_question`
    """
    shown = find_question(name)
    is_equation = shown.kind == EQUATION
    st.markdown(shown.prompt())
    names = " ".join(f"`{letter}`" for letter in (*shown.accepted_names, "sqrt( )"))
    st.markdown(_(":small[You may use numbers and] {names}").format(names=names))
    with st.form(f"form_{name}", border=False):
        text = st.text_input(
            _("Your equation") if is_equation else _("Your formula"),
            key=f"answer_{name}",
            placeholder=_("For example {formula}").format(formula=shown.example),
        )
        st.form_submit_button(_("Check"), type="primary")
    verdict = judge_answer(name, text) if text else None
    if verdict:
        draw_verdict(verdict, typeset_as_parsed(text, is_equation))
    is_right = verdict is not None and verdict.kind == "right"
    if not is_right and widgets.draw_hints(name, shown.hints, _("Show me this step") if with_step else ""):
        st.latex(typeset_answer_step(name))
    # Derive the right answer now, so that the first verdict does not take long.
    with st.spinner(_("Deriving the answer …"), show_time=False):
        judge_answer(name, "1")


def draw_verdict(verdict: Verdict, formula: str | None) -> None:
    """Draw the typed formula as LaTeX, unless it is unreadable, and the verdict."""
    if formula:
        st.latex(formula)
    draw, icon = VERDICTS[verdict.kind]
    draw(widgets.escape(verdict.message), icon=icon)


@cache
def typeset_answer_step(name: str) -> str:
    """Return the step that leads to the answer of a question, as one block of LaTeX."""
    return typeset_beside_machine([make_row(equation) for equation in find_answer_equations(name)])


@st.cache_data(show_spinner=False, max_entries=512)
@responsive()
def judge_answer(name: str, text: str) -> Verdict:
    """Return the verdict on an answer. The first call for a question also derives its answer and typical mistakes."""
    return judge(name, text)


@st.cache_data(show_spinner=False, max_entries=512)
def typeset_as_parsed(text: str, is_equation: bool = False) -> str | None:
    """Return a typed formula as LaTeX, as the parser understands it; None if the parser cannot read it."""
    try:
        return typeset(text, is_equation=is_equation)
    except UnreadableError:
        return None
