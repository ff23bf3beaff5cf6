"""The wall of a class: one large, read-only page for the projector that follows the lecturer's desk.

Before the first question it shows how to join. Then it shows the question and the votes, with the machine below them.
At the end it shows the results of the class. It contains no key of the lecturer.
"""

import math
from collections.abc import Callable

import streamlit as st

from ramanujan.browser.containers import container
from ramanujan.classroom.codes import format_code
from ramanujan.classroom.results import find_stop
from ramanujan.classroom.rules import ClassError, ClassQuestion, Phase
from ramanujan.classroom.states import END, ClassView
from ramanujan.lesson.stop import Stop
from ramanujan.pages.classroom import shared_elements
from ramanujan.shell import address, class_session, display_mode
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.text.translation import _

WALL_STYLE = (
    "<style>html:root { font-size: 3.55vh } #root#root :is(.st-key-pager, header) { visibility: hidden }</style>"
)
"""Letters of at least 3.5 % of the height, and no pager, because nobody turns pages on a wall.

A style sheet for all pages would need :has(), which adds 2 s to the loading time of Motion.
"""

_LETTERS = {"wide": 112, "middle": 96, "narrow": 86}
"""Numbers of letters in a line of a wall of 16:9, 3:2 and 4:3."""
_SHARE_LETTERS, _OPTION_MARGIN = 9, 0.7
"""Width of an option's margins and share in the first vote, in letters, and height of its margins, in lines."""
_UNCHANGED_READS = "wall_reads"
"""Session state: the last state of the class → how often the wall has read that state again."""
_REDRAW_AFTER = 6
"""Number of unchanged reads after which the wall is redrawn once.

A busy server can lose elements of a run if the page requests the next run meanwhile (streamlit#9921).
"""


def draw_wall(show: Callable[..., None]) -> None:
    """Draw the wall and end the run, if this session is the wall of a class; for others do nothing.

    Parameters
    ----------
    show : function that draws the machine of a stop, such as `stops.draw_observation`
    """
    code = class_session.wall_code()
    if code:
        _draw(code, show)
        st.stop()


def _draw(code: str, show: Callable[..., None]) -> None:
    """Draw the wall of the class with this code."""
    with st.container(key="class_wall"):
        st.html(WALL_STYLE)
        try:
            view = class_session.read(code)
        except ClassError:
            # Otherwise the fragment would rerun the page once more.
            st.session_state.pop(_UNCHANGED_READS, None)
            _follow_class(code)
            st.button(_("Leave this class"), key="class_leave", on_click=class_session.leave)
            return
        class_session.apply_settings(view.machine)
        # Call the fragment first, because a rerun may interrupt this run before its end.
        _follow_class(code)
        if view.current.stop is None:
            _draw_invitation(code)
        elif view.current.stop == END:
            _draw_results(code, view)
        else:
            _draw_question(code, find_stop(view.current.stop), view.current, show)


def _draw_question(code: str, stop: Stop, question: ClassQuestion, show: Callable[..., None]) -> None:
    """Draw a question and its votes across the wall, with the machine in the same place below.

    The result appears in the options, which keep their places.
    """
    is_running = question.phase >= Phase.RUNNING
    is_second = question.vote.is_second
    lines = "; ".join(f"--{wall}-lines: {count_lines(stop, n, is_second)}" for wall, n in _LETTERS.items())
    st.html(f"<style>:root {{ {lines} }}</style>")
    with st.container(key="wall_result" if question.phase == Phase.SOLVED else "wall_asked"):
        st.title(stop.heading, anchor=False)
        if question.phase == Phase.SOLVED:
            shared_elements.draw_answer(code, stop, question.vote)
        else:
            st.markdown(stop.question)
            if is_second:
                talk = _("**Second vote.** Talk to your neighbours, then answer again.")
                st.markdown(talk if question.phase == Phase.ASKED else _("**First vote → second vote**"))
            with st.container(key=f"wall_options_{question.vote.number}"):
                if question.phase == Phase.ASKED:
                    shared_elements.draw_options(shared_elements.add_letters(stop))
                else:
                    shared_elements.draw_options_with_shares(code, stop, question.vote)
        if is_running and stop.sliders:
            st.markdown(f"**{PARAMETERS['m_prime'].equation(PARAMETERS['m_prime'].value)}**")
    with container("wall", "running" if is_running else "still"):
        show(stop, is_running, fixed=True)


def count_lines(stop: Stop, letters: int, is_second: bool = False) -> float:
    """Return the height of a stop's longest text, in lines with this number of letters.

    That is the question with the options, or the right answer with the reply to the most common mistake. In a second
    vote, a line above the options and a second share need room.
    """

    def count(text: str, letters: int = letters) -> int:
        return math.ceil(len(text) / letters)

    letters_of_option = letters // 2 - _SHARE_LETTERS - 6 * is_second
    labels = [count(label, letters_of_option) for label in shared_elements.add_letters(stop).values()]
    options = sum(max(labels[first : first + 2]) + _OPTION_MARGIN for first in range(0, len(labels), 2))
    mistake = shared_elements.MISTAKE
    replies = (
        count(mistake.format(label=label, reply=stop.reply(option)))
        for option, label in stop.options.items()
        if option != stop.right
    )
    reason = count(f"{stop.options[stop.right]} {stop.explanation()}")
    return max(count(stop.question) + is_second + options, reason + max(replies)) + bool(stop.sliders)


@st.fragment(run_every=class_session.VIEW_INTERVAL)
def _follow_class(code: str) -> None:
    """Draw the numbers that change often. Rerun the page when the class moves on or ends.

    A further rerun, after `_REDRAW_AFTER` unchanged reads, restores elements that a busy server may have lost. The
    fragment also mirrors the desk's view and sliders.
    """
    try:
        view = class_session.read(code)
    except ClassError as error:
        if st.session_state.pop(_UNCHANGED_READS, None):
            st.rerun()
        st.warning(str(error))
        return
    current = view.current
    state = (current.stop, current.vote, current.phase)
    unchanged_reads = st.session_state.get(_UNCHANGED_READS, {}).get(state, -1) + 1
    st.session_state[_UNCHANGED_READS] = {state: unchanged_reads}
    if unchanged_reads in (0, _REDRAW_AFTER) or class_session.settings_differ(view.machine):
        st.rerun()
    class_session.show_desk_view(view)
    with st.container(key="class_wall_foot", horizontal=True, vertical_alignment="center", gap="large"):
        if current.stop is None:
            st.markdown(shared_elements.joined_sentence(view.present), width="content")
        elif current.stop != END:
            if current.reached == Phase.ASKED:
                st.markdown(f"**{shared_elements.answers_sentence(view)}**", width="content")
            else:
                st.markdown(shared_elements.votes_sentence(code, current.stop, current.vote), width="content")
            url = address.link_for_others({})
            st.text(f"{url.netloc}{url.path}  ·  {format_code(code)}", width="content")


def _draw_results(code: str, view: ClassView) -> None:
    """Draw the results of the class and the address of the whole lesson, without the code of the class."""
    url = address.link_for_others({})
    table, words = display_mode.picture_and_words()
    with table:
        st.title(shared_elements.RESULTS_HEADING, anchor=False)
        shared_elements.draw_whole_lesson(code, view)
    with words:
        st.markdown(_("The whole lesson, to go on alone:"))
        shared_elements.draw_qr_code(url.geturl())
        st.text(f"{url.netloc}{url.path}")


def _draw_invitation(code: str) -> None:
    """Draw code and address in letters that students in the last row can read."""
    url = address.link_for_others({"class": code})
    picture, words = display_mode.picture_and_words(2)
    with picture:
        shared_elements.draw_qr_code(url.geturl())
    with words, st.container(key="class_invitation"):
        st.title(_("Join the class"), anchor=False)
        st.markdown(_("On your phone, open"))
        # Use plain text, because the address comes from the browser.
        st.container(key="class_address").text(f"{url.netloc}{url.path}")
        st.markdown(_("then choose **Class** and type"))
        st.container(key="class_letters").text(format_code(code))
        shared_elements.warn_of_local_address()
