"""The wall of a class: one large, read-only page for the projector that follows the lecturer's desk.

Before the first question it shows how to join. Then it shows the question and the votes, with the machine below them.
At the end it shows the results of the class. It contains no key of the lecturer.
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.browser.roles import container
from ramanujan.lesson.class_codes import format_code
from ramanujan.lesson.class_states import END
from ramanujan.lesson.classes import ClassError, ClassQuestion, Phase, shared
from ramanujan.lesson.stop import Stop
from ramanujan.pages.lesson import class_results, stops
from ramanujan.shell import address, class_session, display_mode
from ramanujan.translation import _

WALL_STYLE = (
    "<style>html:root { font-size: 3.55vh } #root#root :is(.st-key-pager, header) { visibility: hidden }</style>"
)
"""Letters of at least 3.5 % of the height, and no pager, because nobody turns pages on a wall.

A style sheet for all pages would need :has(), which adds 2 s to the loading time of Motion.
"""

_UNCHANGED_READS = "wall_reads"
"""Session state: the last state of the class → how often the wall has read that state again."""
_REDRAW_AFTER = 6
"""Number of unchanged reads after which the wall is redrawn once.

A busy server can lose elements of a run if the page requests the next run meanwhile (streamlit#9921).
"""


def draw_wall() -> None:
    """Draw the wall and end the run, if this session is the wall of a class; for others do nothing."""
    code = class_session.wall_code()
    if code:
        _draw(code)
        st.stop()


def _draw(code: str) -> None:
    """Draw the wall of the class with this code."""
    with st.container(key="class_wall"):
        st.html(WALL_STYLE)
        try:
            question = class_session.read_question(code)
        except ClassError:
            # Otherwise the fragment would rerun the page once more.
            st.session_state.pop(_UNCHANGED_READS, None)
            _follow_class(code)
            st.button(_("Leave this class"), key="class_leave", on_click=class_session.leave)
            return
        class_session.apply_settings(shared().read_machine(code))
        # Call the fragment first, because a rerun may interrupt this run before its end.
        _follow_class(code)
        if question.stop is None:
            _draw_invitation(code)
        elif question.stop == END:
            _draw_results(code)
        else:
            _draw_question(code, lesson.find_stop(question.stop), question)


def _draw_question(code: str, stop: Stop, question: ClassQuestion) -> None:
    """Draw a question and its votes across the wall, with the machine in the remaining height."""
    is_solved = question.phase == Phase.SOLVED
    is_running = question.phase >= Phase.RUNNING
    with st.container(key="wall_asked" if question.phase == Phase.ASKED else "wall_result"):
        st.title(stop.heading, anchor=False)
        if not is_solved:
            st.markdown(stop.question)
        if question.phase == Phase.ASKED:
            if question.vote.is_second:
                st.markdown(_("**Second vote.** Talk to your neighbours, then answer again."))
            with st.container(key="wall_options"):
                st.markdown("\n".join(f"- {label}" for label in stop.options.values()))
        elif is_solved:
            class_results.draw_answer(code, stop, question.vote)
        else:
            class_results.show(code, stop, question.vote, is_solved=False)
    with container("wall", "running" if is_running else "still"):
        stops.draw_observation(stop, running=is_running, fixed=True)


@st.fragment(run_every=class_session.VIEW_INTERVAL)
def _follow_class(code: str) -> None:
    """Draw the numbers that change often. Rerun the page when the class moves on or ends.

    A further rerun, after `_REDRAW_AFTER` unchanged reads, restores elements that a busy server may have lost. The
    fragment also mirrors the desk's view and sliders.
    """
    try:
        current = class_session.read_question(code)
    except ClassError as error:
        if st.session_state.pop(_UNCHANGED_READS, None):
            st.rerun()
        st.warning(str(error))
        return
    state = (current.stop, current.vote, current.phase)
    unchanged_reads = st.session_state.get(_UNCHANGED_READS, {}).get(state, -1) + 1
    st.session_state[_UNCHANGED_READS] = {state: unchanged_reads}
    if unchanged_reads in (0, _REDRAW_AFTER) or class_session.settings_differ(shared().read_machine(code)):
        st.rerun()
    class_session.show_desk_view(code)
    with st.container(key="class_wall_foot", horizontal=True, vertical_alignment="center", gap="large"):
        if not current.is_known:
            st.markdown(class_results.unknown_stop_sentence(), width="content")
        elif current.stop is None:
            st.markdown(class_results.joined_sentence(current.present), width="content")
        elif current.stop != END:
            if current.reached == Phase.ASKED:
                st.markdown(f"**{class_results.answers_sentence(current)}**", width="content")
            url = address.link_for_others({})
            st.text(f"{url.netloc}{url.path}  ·  {format_code(code)}", width="content")


def _draw_results(code: str) -> None:
    """Draw the results of the class and the address of the whole lesson, without the code of the class."""
    url = address.link_for_others({})
    table, words = display_mode.picture_and_words()
    with table:
        st.title(class_results.RESULTS_HEADING, anchor=False)
        class_results.draw_whole_lesson(code)
    with words:
        st.markdown(_("The whole lesson, to go on alone:"))
        class_results.draw_qr_code(url.geturl())
        st.text(f"{url.netloc}{url.path}")


def _draw_invitation(code: str) -> None:
    """Draw code and address in letters that students in the last row can read."""
    url = address.link_for_others({"class": code})
    picture, words = display_mode.picture_and_words(2)
    with picture:
        class_results.draw_qr_code(url.geturl())
    with words, st.container(key="class_invitation"):
        st.title(_("Join the class"), anchor=False)
        st.markdown(_("On your phone, open"))
        # Use plain text, because the address comes from the browser.
        st.container(key="class_address").text(f"{url.netloc}{url.path}")
        st.markdown(_("then choose **Class** and type"))
        st.container(key="class_letters").text(format_code(code))
        class_results.warn_of_local_address()
