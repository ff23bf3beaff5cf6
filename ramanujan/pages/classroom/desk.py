"""The lecturer's desk in a class: the options or the votes beside a stop, the next moves, the seats and the end."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

import streamlit as st

from ramanujan.classroom.codes import format_code, split_key
from ramanujan.classroom.results import find_stop, write_csv
from ramanujan.classroom.rules import ClassError, ClassQuestion, Phase, shared
from ramanujan.classroom.states import END, ClassView
from ramanujan.lesson.stop import Stop
from ramanujan.pages.classroom import shared_elements
from ramanujan.shell import address, class_session, local_time, progress, widgets
from ramanujan.shell.class_session import leave, lecturer_key, run_or_refuse
from ramanujan.text.translation import _

DESK_INTERVAL = 2.0
"""Interval at which the desk reads the state of the class [s]."""
_CODE_WIDTH = 300
"""Width of the QR code [px], so that its popover fits a window of 720 px."""
_CODE_PLACE = '<div style="aspect-ratio: 1"></div>'
"""The place of a QR code, so that the browser finds room for the popover before it has the code."""
_LAST_STOP = "class_seen"
"""Session state: the stop of the class that this desk last read."""
FOOT = "<style>:root { --foot: 3.5rem; @media (width >= 1000px) { --stage-picture: 34vh; --stage-dial: 27vh } }</style>"
"""The heights of the desk’s last line, picture and clock. In page.css they would need :has(), which is slow."""
ENDED = "class_ended"
"""Session state: whether the desk has ended its class, and the first page of the lesson confirms it."""


def draw_desk(stop: Stop, phase: Phase) -> None:
    """Draw the lecturer's desk next to a stop, in the current phase of the class.

    Draw the options or the votes, and the buttons of the next moves.
    """
    key = lecturer_key()
    if key is None:
        return
    class_session.send_settings(key)
    code, _secret = split_key(key)
    _follow_stage(code)
    _draw_live_desk(stop, phase)


@st.fragment(run_every=class_session.VIEW_INTERVAL)
def _follow_stage(code: str) -> None:
    """Mirror the view of another desk of this class."""
    with suppress(ClassError):
        class_session.show_desk_view(class_session.read(code))


def draw_end() -> None:
    """Draw the lecturer's desk after the last stop."""
    st.title(shared_elements.RESULTS_HEADING, anchor=False)
    _draw_live_desk(None, Phase.ASKED)


def draw_error() -> None:
    """Draw the error message of the last action, if there is one."""
    sentence = class_session.read_refusal()
    if sentence:
        st.warning(sentence)


@st.fragment(run_every=DESK_INTERVAL)
def _draw_live_desk(stop: Stop | None, phase: Phase) -> None:
    """Draw the desk at a stop in this phase, or at the end. Rerun the page when stop or phase has changed."""
    key = lecturer_key()
    if key is None:
        st.rerun()
    st.session_state.setdefault(_LAST_STOP, None)
    code, _secret = split_key(key)
    place = stop.id if stop else END
    with st.container(key="class_desk"):
        draw_error()
        try:
            view = class_session.read_desk(key)
        except ClassError as error:
            st.warning(str(error))
            st.button(_("Leave this class"), key="class_leave", on_click=leave)
            return
        _follow_desk(view.current, place)
        last_vote = view.find_last_vote(place)
        current_phase = last_vote.phase if last_vote else Phase.ASKED
        if current_phase != phase:
            st.rerun()
        with st.container(key="class_moves", horizontal=True, gap="small"):
            _draw_moves(key, stop, view.current, last_vote)
        if phase == Phase.ASKED or view.current.stop != place:
            st.markdown(f"**{_attendance_sentence(place, view)}**")
        if stop is None:
            shared_elements.draw_whole_lesson(code, view)
        elif last_vote and last_vote.phase > Phase.ASKED:
            shared_elements.show(code, stop, last_vote.vote, last_vote.phase == Phase.SOLVED)
            if last_vote.phase == Phase.SOLVED:
                shared_elements.draw_commonest_mistake(code, stop, last_vote.vote)
        else:
            shared_elements.draw_options(shared_elements.add_letters(stop))
        st.html(FOOT)
        with st.container(key="class_foot", horizontal=True, vertical_alignment="center"):
            _draw_foot(key, code, view)


def _follow_desk(current: ClassQuestion, place: str) -> None:
    """Open the stop to which another desk has taken the class.

    Parameters
    ----------
    current : the current question of the class
    place : the stop that this desk shows, or END
    """
    if current.stop != st.session_state[_LAST_STOP]:
        st.session_state[_LAST_STOP] = current.stop
        st.session_state[progress.STOP.name] = current.stop or place
    # The desk's own buttons also need this rerun: they rerun only the desk, not the stop next to it.
    if address.current(progress.STOP) != place:
        st.rerun()


def _attendance_sentence(place: str, view: ClassView) -> str:
    """Return a sentence about the class for a desk at this place.

    It states attendance or answers. If the class is at another place, it states that place instead.
    """
    current = view.current
    if current.stop is None or current.stop == place == END:
        return shared_elements.joined_sentence(view.present)
    if current.stop == END:
        return _("The class is at the end of the lesson.")
    if current.stop != place:
        return _("The class is still at “{heading}”.").format(heading=find_stop(current.stop).heading)
    return shared_elements.answers_sentence(view)


@dataclass(frozen=True)
class _Move:
    """A button of the desk that changes the state of the class.

    Parameters
    ----------
    label : text of the button
    name : end of the button's key
    action : callback, with the lecturer's key as its first argument
    arguments : the other arguments
    """

    label: str
    name: str
    action: Callable[..., None]
    arguments: tuple[object, ...] = ()

    def draw(self, key: str, shortcut: str | None = None, is_primary: bool = False, disabled: bool = False) -> None:
        """Draw the button. `key` is the lecturer's key, `shortcut` the key of the keyboard that presses the button."""
        st.button(
            self.label,
            key=f"class_{self.name}",
            type="primary" if is_primary else "secondary",
            shortcut=shortcut,
            on_click=run_or_refuse,
            args=(self.action, key, *self.arguments),
            disabled=disabled,
        )


def _draw_moves(key: str, stop: Stop | None, current: ClassQuestion, last_vote: ClassQuestion | None) -> None:
    """Draw a button for each possible move. A clicker presses the first two: back and forward.

    Parameters
    ----------
    key : the lecturer's key
    stop : the stop of this desk, None at the end
    current : the current question of the class
    last_vote : the last vote on this stop, None if the class was never at this stop
    """
    place = stop.id if stop else END
    shows_result = current.stop == place and current.phase > Phase.ASKED
    can_go_back = shows_result or progress.find_previous_stop(place) is not None
    back = _Move(_("Go back"), "back", _go_back, (place,))
    back.draw(key, shortcut="PageUp", disabled=not can_go_back)
    is_over = current.stop == place == END
    forward = _choose_forward_move(stop, current, last_vote)
    forward.draw(key, shortcut="PageDown", is_primary=True, disabled=is_over)
    if stop and current.stop != place and last_vote:
        ask_anew = partial(shared().ask, anew=True)
        _Move(_("Ask this question again"), "anew", ask_anew, (place, list(stop.options))).draw(key)
    if current.stop == place != END and not current.vote.is_second and current.reached < Phase.RUNNING:
        _Move(_("Ask again"), "again", shared().begin_second_vote).draw(key)


def _choose_forward_move(stop: Stop | None, current: ClassQuestion, last_vote: ClassQuestion | None) -> _Move:
    """Return the move of the forward button. The parameters are those of `_draw_moves`."""
    finish = _Move(_("Show what the class has learned"), "finish", _show_end)
    if stop is None:
        return finish
    if current.stop != stop.id:
        label = _("Return to this question") if last_vote else _("Ask the class")
        return _Move(label, "ask", _show_stop, (stop,))
    if current.phase == Phase.SOLVED:
        following = progress.find_next_stop(stop)
        return _Move(_("Ask the next question"), "next", _show_stop, (following,)) if following else finish
    labels = {
        Phase.ASKED: (_("Show the result"), "reveal"),
        Phase.REVEALED: (stop.observation, "run"),
        Phase.RUNNING: (_("Name the answer"), "solve"),
    }
    label, name = labels[current.phase]
    return _Move(label, name, shared().show, (Phase(current.phase + 1),))


def _go_back(key: str, place: str) -> None:
    """Take the class back by one view. If the class is at another stop, move only this desk."""
    code, _secret = split_key(key)
    view, previous = shared().read(code), progress.find_previous_stop(place)
    current = view.current
    is_here = current.stop == place
    if is_here and current.phase > Phase.ASKED:
        shared().show(key, Phase(current.phase - 1))
    elif previous and is_here and view.find_last_vote(previous.id):
        _show_stop(key, previous)
    elif previous:
        st.session_state[progress.STOP.name] = previous.id


def _show_end(key: str) -> None:
    """Take the class and this desk to the end."""
    shared().finish(key)
    st.session_state[_LAST_STOP] = st.session_state[progress.STOP.name] = END


def _show_stop(key: str, stop: Stop) -> None:
    """Take the class and this desk to a stop."""
    shared().ask(key, stop.id, list(stop.options))
    st.session_state[_LAST_STOP] = st.session_state[progress.STOP.name] = stop.id


def _draw_foot(key: str, code: str, view: ClassView) -> None:
    """Draw the code, links to the other screens, and the controls for seats, results and the end of the class."""
    st.text(format_code(code), width="content")
    st.link_button(
        _("Open the wall"),
        address.link({"class": code, "wall": "on", "view": "projector"}).geturl(),
        icon=":material/co_present:",
        type="tertiary",
    )
    # A tick of the desk writes neither a code nor a file for a closed popover.
    with st.popover(_("Download the results"), key="class_files", type="tertiary", on_change="rerun") as files:
        _offer_votes(key, "class_csv", is_open=bool(files.open))
    label = _("Open the desk on your phone")
    with st.popover(label, key="class_second_desk", type="tertiary", on_change="rerun") as second_desk:
        st.markdown(_("Scan this with your own phone. Whoever has this picture leads the class."))
        with st.container(width=_CODE_WIDTH):
            if second_desk.open:
                shared_elements.draw_qr_code(address.link_for_others({"class": code, "lecturer": key}).geturl())
            else:
                st.html(_CODE_PLACE)
    with st.popover(_("Manage the seats"), key="class_seats", type="tertiary", on_change="rerun") as seats:
        _manage_seats(key, view, is_open=bool(seats.open))
    _draw_ending(key, view)


def _offer_votes(key: str, name: str, *, is_open: bool) -> None:
    """Offer the votes of the class as a CSV file.

    Parameters
    ----------
    key : the lecturer's key
    name : key of the button
    is_open : whether the popover with the button is open; only then the file is written
    """
    all_results = shared().read_results_for_lecturer(key) if is_open else []
    code, _secret = split_key(key)
    csv = write_csv(all_results)
    widgets.download(_("Download as CSV"), csv, f"class-{code}.csv", "text/csv", key=name, disabled=not is_open)


def _manage_seats(key: str, view: ClassView, *, is_open: bool) -> None:
    """Draw the numbers of seats, and the controls against a visitor who takes many seats.

    Parameters
    ----------
    key : the lecturer's key
    view : the class
    is_open : whether the popover is open; only then the seats without a vote are counted
    """
    st.markdown(shared_elements.seats_sentence(view))
    if is_open:
        silent, new = shared().count_unusual_seats(key)
        st.markdown(
            _("Seats that never voted: {silent}. Seats taken in the last minute: {new}.").format(silent=silent, new=new)
        )
    label = _("Let nobody else join") if view.is_open else _("Let students join again")
    st.button(label, key="class_bar", on_click=run_or_refuse, args=(shared().let_join, key, not view.is_open))
    st.markdown(
        _(
            "A seat is empty if its student’s page is closed. With the seat, the answer to the present question is "
            "removed, unless its result is shown. A student who comes back gets a new seat."
        )
    )
    st.button(
        _("Remove the empty seats"), key="class_clear", on_click=run_or_refuse, args=(shared().remove_absent, key)
    )


def _draw_ending(key: str, view: ClassView) -> None:
    """Draw the expiry date of the class, a last download, and the button that ends the class."""

    def end() -> None:
        shared().close(key)
        leave()
        st.session_state[progress.PART.name] = progress.PART.default
        st.session_state[progress.STOP.name] = progress.STOP.default
        st.session_state[ENDED] = True

    with st.popover(_("End the class"), key="class_ending", type="tertiary", on_change="rerun") as ending:
        st.markdown(
            _("The class ends, and all its answers are deleted. Otherwise that happens on {date}.").format(
                date=local_time.date_and_time(view.expires)
            )
        )
        _offer_votes(key, "class_csv_last", is_open=bool(ending.open))
        label = _("End the class and delete its answers")
        st.button(label, key="class_close", on_click=run_or_refuse, args=(end,))
