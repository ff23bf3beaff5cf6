"""A question with a box for a typed formula, hints and a verdict, on page 2 and in exercises."""

from dataclasses import dataclass
from datetime import datetime

import streamlit as st

from ramanujan.answers import QUESTIONS, Verdict, judge, question, shown_step
from ramanujan.answers.grammar import UnreadableError, typeset
from ramanujan.answers.questions import EQUATION
from ramanujan.browser import stage
from ramanujan.derivation.rows import row
from ramanujan.shell import address, local_time, sidebar, stages, widgets
from ramanujan.shell.cache import responsive
from ramanujan.shell.formulas import beside_the_machine
from ramanujan.translation import _

QUESTION = address.Choice("question", tuple(QUESTIONS), next(iter(QUESTIONS)))
VERDICTS = {
    "right": (st.success, ":material/check_circle:"),
    "unsimplified": (st.info, ":material/compress:"),
    "wrong": (st.warning, ":material/lightbulb:"),
    "unreadable": (st.error, ":material/help:"),
}
_LONGEST = 1000
"""Largest length of a stored answer."""
_ANSWERS = "answers_given"
"""Session state: question or task → its `Given`."""


@dataclass(frozen=True)
class GivenAnswer:
    """The last answer, or the first right one with its time."""

    answer: str
    right_since: datetime | None


def draw_section() -> None:
    """Draw a question with its verdict, and list the solved questions."""
    st.header(_("Try it yourself"), anchor=False)
    # These labels must not change, because the browser identifies an option by its label.
    name = widgets.selectbox(QUESTION, _("What do you want to work out?"), {name: title(name) for name in QUESTIONS})
    judge_typed(name)
    draw_question(name)
    if solved := [*filter(is_solved, QUESTIONS)]:
        st.markdown(_("**Solved so far: {n} of {all}**").format(n=len(solved), all=len(QUESTIONS)))
        st.markdown("\n".join(f"- :green[:material/check_circle:] {title(name)}" for name in solved))


def title(name: str) -> str:
    """Return the title of a question."""
    quantity = question(name).quantity
    return quantity[:1].upper() + quantity[1:]


def is_solved(name: str) -> bool:
    """Return whether a question has a right answer."""
    return bool((answer := answer_to(name)) and answer.right_since)


def judge_typed(name: str, place: str = "") -> None:
    """Judge a typed answer to a question, and store it."""
    if text := st.session_state.get(f"answer_{place}{name}"):
        store_answer(name, text, verdict_on(name, text).kind == "right")


def store_answer(name: str, answer: str, is_right: bool) -> None:
    """Store an answer for the session. The first right answer is not replaced."""
    before = answer_to(name)
    if before is None or not before.right_since:
        now = datetime.now(local_time.time_zone()) if is_right else None
        st.session_state.setdefault(_ANSWERS, {})[name] = GivenAnswer(answer[:_LONGEST], now)


def answer_to(name: str) -> GivenAnswer | None:
    """Return the answer to a question or task."""
    return st.session_state.get(_ANSWERS, {}).get(name)


def draw_question(name: str, with_step: bool = True, place: str = "") -> None:
    """Draw one question with hints. The last hint, if available, shows the step.

    If no other `place` is given, the machine with its coordinates is next to the question.
    """
    if place:
        draw_box(name, with_step, place)
        return
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


def draw_box(name: str, with_step: bool, place: str = "") -> None:
    """Draw a question with its box and verdict. Draw its hints only if `place` is empty."""
    shown = question(name)
    st.markdown(shown.prompt())
    names = " ".join(f"`{each}`" for each in (*shown.accepted, "sqrt( )"))
    st.markdown(_(":small[You may use numbers and] {names}").format(names=names))
    with st.form(f"form_{place}{name}", border=False):
        text = st.text_input(
            _("Your equation") if shown.kind == EQUATION else _("Your formula"),
            key=f"answer_{place}{name}",
            placeholder=_("For example {formula}").format(formula=shown.example),
        )
        st.form_submit_button(_("Check"), type="primary")
    if text:
        verdict, read = verdict_on(name, text), as_parsed(text, shown.kind == EQUATION)
        box, icon = VERDICTS[verdict.kind]
        if read:
            st.latex(read)
        box(widgets.plain(verdict.message), icon=icon)
    if not place and widgets.hints(name, shown.hints, _("Show me this step") if with_step else ""):
        st.latex(step_to_answer(name))
    with st.spinner(_("Deriving the answer …"), show_time=False):
        verdict_on(name, "1")


@st.cache_data(show_spinner=False)
def step_to_answer(name: str) -> str:
    """Return the step that leads to the answer of a question, as one block of LaTeX."""
    return beside_the_machine([row(each) for each in shown_step(name)])


@st.cache_data(show_spinner=False, max_entries=512)
@responsive()
def verdict_on(name: str, text: str) -> Verdict:
    """Return the verdict on an answer. The first call for a question also derives its answer and typical mistakes."""
    return judge(name, text)


@st.cache_data(show_spinner=False, max_entries=512)
def as_parsed(text: str, is_equation: bool = False) -> str | None:
    """Return a formula as LaTeX as the parser understands it, or None if it is invalid."""
    try:
        return typeset(text, is_equation=is_equation)
    except UnreadableError:
        return None
