"""The wall of a class: one large, read-only page for the projector that follows the lecturer's desk.

Before the first question it shows how to join. Then the machine stands to the left, in the state that the desk tells,
and the question, the votes, and the right answer with its reason to the right. At the end it shows what the class has
learned. No key of the lecturer is on it.
"""

import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.class_codes import spaced
from ramanujan.lesson.class_states import END
from ramanujan.lesson.classes import ClassError, Phase, Question, shared
from ramanujan.lesson.stop import Stop
from ramanujan.pages.lesson import class_results, stops
from ramanujan.shell import address, class_session, display_mode
from ramanujan.translation import _

NOTHING_TO_TURN = (
    "<style>html:root { font-size: min(2.6vh, 1.7vw) } "
    "#root#root :is(.st-key-pager, header) { visibility: hidden }</style>"
)
"""Words are as large as both sides of a wall allow; address and code stand in the bar of pages. A rule for all pages
would need :has(), 2 s of Motion’s load."""

_LOOKS, _AGAIN = "wall_looks", 6
"""Session state: how often the wall has seen the present view of the class. After so many looks it is drawn again: a
busy server can lose what a run has drawn if the page has asked for the next run meanwhile (Streamlit issue 9921)."""
_ONLY_HERE = ("localhost", "127.0.0.1", "::1")


def guests() -> None:
    """Draw the wall and end the run, if this session is one; for others do nothing."""
    if code := class_session.wall_held():
        _draw(code)
        st.stop()


def _draw(code: str) -> None:
    """Draw the wall of the class with this code."""
    try:
        question = shared().question(code)
    except ClassError:
        st.session_state.pop(_LOOKS, None)
        _watch(code)
        st.button(_("Leave this class"), key="class_leave", on_click=class_session.leave)
        return
    with st.container(key="class_wall"):
        st.html(NOTHING_TO_TURN)
        class_session.take_settings(shared().machine(code))
        # Before the rest: what keeps the wall looking must not be lost with the end of a run.
        _watch(code)
        if question.stop is None:
            _how_to_join(code)
        elif question.stop == END:
            _look_back(code)
        else:
            _show(code, lesson.stop(question.stop), question)


def _show(code: str, stop: Stop, question: Question) -> None:
    """Draw a question as far as the class has come with it."""
    solved = question.phase == Phase.SOLVED
    asks = question.phase == Phase.ASKED
    picture, words = display_mode.picture_and_words()
    with picture:
        stops.show(stop, running=question.phase >= Phase.RUNNING, fixed=True)
    with words, st.container(key="wall_asked" if asks else None):
        st.title(stop.heading, anchor=False)
        if not solved:
            st.markdown(stop.question)
        if asks:
            if question.vote.is_second:
                st.markdown(_("**Second vote.** Talk to your neighbours, then answer again."))
            st.markdown("\n".join(f"- {label}" for label in stop.options.values()))
            return
        class_results.show(code, stop, question.vote, solved)
        if solved:
            st.markdown(stop.explanation())
            class_results.comment(code, stop, question.vote)


@st.fragment(run_every=class_session.FOLLOWED_EVERY)
def _watch(code: str) -> None:
    """Draw what changes all the time, and run the whole page where the class has gone on, and once more after that."""
    try:
        now = shared().question(code)
    except ClassError as error:
        st.warning(str(error))
        return
    view = (now.stop, now.vote, now.phase)
    looks = st.session_state.get(_LOOKS, {}).get(view, -1) + 1
    st.session_state[_LOOKS] = {view: looks}
    if looks in (0, _AGAIN) or class_session.settings_differ(shared().machine(code)):
        st.rerun()
    class_session.follow(code)
    with st.container(key="class_wall_foot", horizontal=True, vertical_alignment="center", gap="large"):
        if now.stop is None:
            st.markdown(class_results.joined(now.present), width="content")
        elif now.stop != END:
            if now.reached == Phase.ASKED:
                st.markdown(f"**{class_results.answered(now)}**", width="content")
            here = address.link({})
            st.text(f"{here.netloc}{here.path}  ·  {spaced(code)}", width="content")


def _look_back(code: str) -> None:
    """Draw what the class has learned, and where the whole lesson is; the code of the class has gone."""
    here = address.link({})
    table, words = display_mode.picture_and_words()
    with table:
        st.title(class_results.LEARNED, anchor=False)
        class_results.learned(code)
    with words:
        st.markdown(_("The whole lesson, to go on alone:"))
        class_results.qr_code(here.geturl())
        st.text(f"{here.netloc}{here.path}")


def _how_to_join(code: str) -> None:
    """Draw code and address so that the last row can read them."""
    here = address.link({"class": code})
    picture, words = display_mode.picture_and_words()
    with picture:
        class_results.qr_code(here.geturl())
    with words, st.container(key="class_invitation"):
        st.title(_("Join the class"), anchor=False)
        st.markdown(_("On your phone, open"))
        # As plain text: an address is whatever the browser says it is.
        st.container(key="class_address").text(f"{here.netloc}{here.path}")
        st.markdown(_("then choose **Class** and type"))
        st.container(key="class_letters").text(spaced(code))
        if here.hostname in _ONLY_HERE:
            st.warning(
                _(
                    "Phones cannot open this address, because it means this computer only. Open the app under the "
                    "computer’s address in the network, then open a class there."
                )
            )
