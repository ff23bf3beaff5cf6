"""A student's phone in a class: the question, the options, and the own vote."""

from collections.abc import Callable
from contextlib import suppress

import streamlit as st

from ramanujan.classroom.codes import format_code
from ramanujan.classroom.results import find_stop
from ramanujan.classroom.rules import ClassError, ClassQuestion, Phase, Seat, SeatError, Vote, shared
from ramanujan.classroom.states import END, ClassView
from ramanujan.lesson.stop import Stop
from ramanujan.pages.classroom import shared_elements
from ramanujan.pages.classroom.desk import draw_error
from ramanujan.shell import class_session
from ramanujan.shell.class_session import leave, run_or_refuse, student_seat
from ramanujan.text.translation import _

PHONE_INTERVAL = 2.5
"""Interval at which a phone reads the state of the class [s]."""
ONLY_THE_QUESTION = """<style>
  :root:root:root { --drawer: 0px; --drawer-content: none; --bar: 0px; .st-key-bar, header, nav { display: none; } }
</style>"""
"""A style rule that hides drawer, bar and page links from a student, who can leave the class.

In page.css it would need :has(), which is slow.
"""
_DRAWN = "class_drawn"
"""Session state: the stop whose machine the phone shows, and whether the machine runs."""
_OPEN = "class_is_open"
"""Session state: whether the class existed when the phone's page was last drawn."""


def draw_phone(show: Callable[..., None]) -> None:
    """Draw the page of a student, and end the run; do nothing for others.

    Parameters
    ----------
    show : function that draws the machine of a stop, such as `stops.draw_observation`
    """
    class_session.restore_role()
    seat = student_seat()
    if seat:
        _draw_student_page(seat, show)
        st.stop()


def _draw_student_page(seat: Seat, show: Callable[..., None]) -> None:
    """Draw the current question of a student, and the machine of its stop."""
    view = None
    with suppress(ClassError):
        view = class_session.read(seat.code)
    visible = _visible_machine(view.current) if view else None
    st.session_state[_DRAWN] = visible
    st.session_state[_OPEN] = view is not None
    with st.container(key="class_phone"):
        st.html(ONLY_THE_QUESTION)
        above = st.container()
        # Call the fragment before the machine is drawn, because a rerun may interrupt this run before its end.
        _draw_live_question()
        below = st.container()
        st.button(_("Leave the class"), key="class_leave", type="tertiary", on_click=leave)
    if view and visible:
        class_session.apply_settings(view.machine)
        name, running = visible
        stop = find_stop(name)
        with above:
            st.title(stop.heading, anchor=False)
            st.markdown(shared_elements.last_sentence(stop.question) if running else stop.question)
        # While the question is open, a small phone needs its room for the options, so the machine is below them.
        with above if running else below:
            show(stop, running, fixed=True)
    if view:
        with st.expander(_("What is stored about you"), key="class_storage"):
            st.caption(shared_elements.storage_sentence(view.expires))


@st.fragment(run_every=PHONE_INTERVAL)
def _draw_live_question() -> None:
    """Draw the current question of the student, and read the class every few seconds for a new one."""
    seat = student_seat()
    if seat is None:
        st.rerun()
    try:
        view = class_session.read(seat.code, seat.voter)
    except SeatError:
        # The lecturer removed the empty seats while this phone was inactive.
        run_or_refuse(class_session.take_seat, seat.code)
        st.rerun()
    except ClassError as error:
        # The machine and the date of deletion are drawn outside of this fragment.
        if st.session_state[_OPEN]:
            st.rerun()
        st.warning(str(error))
    else:
        # The stop's text and machine are drawn outside of this fragment, so a new stop needs a rerun of the page.
        if _visible_machine(view.current) != st.session_state[_DRAWN]:
            st.rerun()
        class_session.show_desk_view(view)
        _draw_question(seat, view)


def _visible_machine(question: ClassQuestion) -> tuple[str, bool] | None:
    """Return the stop whose machine the class sees, and whether it runs; None if the class sees no machine."""
    if question.stop in (None, END):
        return None
    return question.stop, question.phase >= Phase.RUNNING


def _draw_question(seat: Seat, view: ClassView) -> None:
    """Draw the current question of the class, or how to go on before the first question and after the last."""
    question = view.current
    if question.stop is None:
        st.title(_("Class {code}").format(code=format_code(seat.code)), anchor=False)
        st.info(_("You have joined the class. The first question will appear here."))
        return
    class_session.forget_refusal((question.stop, question.vote))
    if question.stop == END:
        st.title(shared_elements.RESULTS_HEADING, anchor=False)
        shared_elements.draw_whole_lesson(seat.code, view)
        st.button(_("Go on with the whole lesson"), key="class_alone", type="primary", on_click=leave)
        return
    stop = find_stop(question.stop)
    if question.reached > Phase.ASKED:
        _draw_closed_vote(seat, stop, view)
    else:
        _draw_open_vote(stop, question)


def _draw_closed_vote(seat: Seat, stop: Stop, view: ClassView) -> None:
    """Draw a closed question: the result if it is visible now, the student's vote, and why voting is closed."""
    question = view.current
    chosen = question.answer
    draw_error()
    is_solved = question.phase == Phase.SOLVED
    if is_solved:
        shared_elements.draw_reason(stop, chosen)
    if question.phase > Phase.ASKED:
        shared_elements.show(seat.code, stop, question.vote, is_solved, chosen)
    else:
        labels = shared_elements.add_letters(stop)
        if chosen:
            labels[chosen] = _("{label} – *This was your answer.*").format(label=labels[chosen])
        shared_elements.draw_options(labels)
    st.markdown(_own_vote_sentence(stop, view))


def _own_vote_sentence(stop: Stop, view: ClassView) -> str:
    """Return whether the student's vote was counted, and why voting is closed, as sentences."""
    question = view.current
    if question.answer:
        return _("Your answer was counted. The result has been shown, so it can no longer be changed.")
    if question.vote.is_second:
        first_vote = question.vote._replace(number=1)
        first = next(each.answer for each in view.asked if (each.stop, each.vote) == (stop.id, first_vote))
        if first:
            return _(
                "**Your answer in the first vote:** {label}\\\nYou have no answer in the second vote. "
                "The result has been shown, so nobody can vote on it now."
            ).format(label=shared_elements.add_letters(stop)[first])
    return _("You have no answer to this question. The result has been shown, so nobody can vote on it now.")


def _draw_open_vote(stop: Stop, question: ClassQuestion) -> None:
    """Draw the options of an open question, with a confirmation above them."""
    chosen = question.answer
    if question.vote.is_second:
        st.markdown(_("**Second vote.** Talk to your neighbours, then answer again."))
    key = f"class_answer_{stop.id}_{question.vote.times_asked}_{question.vote.number}"
    # The database contains the valid answer, also after a reload and after an answer that came too late.
    if st.session_state.get(key) != chosen:
        st.session_state[key] = chosen
    confirmation = _("Your answer counts. You can still change it.")
    st.radio(
        f":green[:material/check_circle: {confirmation}]" if chosen else _("Your answer"),
        list(stop.options),
        index=None,
        format_func=shared_elements.add_letters(stop).__getitem__,
        key=key,
        on_change=_vote,
        args=(key, stop.id, question.vote),
        width="stretch",
    )
    draw_error()


def _vote(key: str, stop: str, vote: Vote) -> None:
    """Callback: store the option that is selected in the widget with this key, as an answer in this vote."""
    seat = student_seat()
    if seat:
        run_or_refuse(shared().vote, seat, stop, st.session_state[key], vote)
