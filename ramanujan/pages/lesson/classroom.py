"""The class on the lesson's page, with three kinds of screens: desk, phones, and the wall (`wall`).

    draw_phone()  at the top of the page: draws only the class on a student's phone
    draw_door()   the controls to open a class or to join one
    draw_desk()   on the page of a stop: the lecturer's desk

Every screen reads the state of the class every few seconds, by a single query of the database.
"""

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial

import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.class_codes import format_code, split_key
from ramanujan.lesson.class_record import write_csv, write_spreadsheet
from ramanujan.lesson.class_states import END
from ramanujan.lesson.classes import DAY, LIFETIMES, ClassError, ClassQuestion, Phase, Seat, SeatError, Vote, shared
from ramanujan.lesson.stop import Stop
from ramanujan.pages.lesson import class_results, progress
from ramanujan.shell import address, class_session, local_time, widgets
from ramanujan.shell.class_session import leave, lecturer_key, open_class, run_or_refuse, student_seat
from ramanujan.translation import _, ngettext

DESK_INTERVAL, PHONE_INTERVAL = 2.0, 2.5
"""Interval at which a desk or a phone reads the state of the class [s]."""

_LONGEST_CODE = 20
"""Largest length of a typed code."""
HIDDEN_DRAWER = """<style>@media (width < 1000px) {
  :root:root:root { --drawer: 0px; --drawer-content: none; .st-key-bar { display: none; } }
}</style>"""
"""A style rule that hides drawer and bar on a student's phone. In page.css it would need :has(), which is slow."""
# TRANSLATORS: names of keys as your keyboards have them.
_KEY_NAMES = {"--page-up": _("PageUp"), "--page-down": _("PageDown")}
KEY_NAMES = "<style>:root {{ {} }}</style>".format("; ".join(f'{key}: "{name}"' for key, name in _KEY_NAMES.items()))
"""The names of the two keys in the labels of the moves, for page.css. Streamlit writes them in English."""
_DRAWN = "class_drawn"
"""Session state: the stop whose machine the phone shows, and whether the machine runs."""
_OPEN = "class_is_open"
"""Session state: whether the class existed when the phone's page was last drawn."""
_LAST_STOP = "class_seen"
"""Session state: the stop of the class that this desk last read."""
_ENDED = "class_ended"
"""Session state: whether the desk has ended its class, and the first page of the lesson confirms it."""


def draw_phone(show: Callable[..., None]) -> None:
    """Draw the page of a student, and end the run; do nothing for others.

    Parameters
    ----------
    show : function that draws the machine of a stop, such as `stops.draw_observation`
    """
    class_session.restore_role()
    if class_session.awaited_class():
        _draw_waiting()
        st.stop()
    seat = student_seat()
    if seat:
        _draw_student_page(seat, show)
        st.stop()


def _draw_student_page(seat: Seat, show: Callable[..., None]) -> None:
    """Draw the current question of a student, and the machine of its stop."""
    question = None
    with suppress(ClassError):
        question = class_session.read_question(seat.code)
    visible = _visible_machine(question)
    st.session_state[_DRAWN] = visible
    st.session_state[_OPEN] = question is not None
    with st.container(key="class_phone"):
        st.html(HIDDEN_DRAWER)
        above = st.container()
        # Call the fragment before the machine is drawn, because a rerun may interrupt this run before its end.
        _draw_live_question()
        below = st.container()
        _draw_leave_button()
    if visible:
        class_session.apply_settings(shared().read_machine(seat.code))
        name, running = visible
        stop = lesson.find_stop(name)
        with above:
            st.title(stop.heading, anchor=False)
            st.markdown(stop.question)
        # While the question is open, a small phone needs its room for the options, so the machine is below them.
        with above if running else below:
            show(stop, running, fixed=True)
    with suppress(ClassError):
        expires, is_storing = shared().read_expiry(seat.code), not class_session.has_no_storage()
        st.caption(class_results.storage_sentence(expires, is_browser_storing=is_storing))


def draw_door() -> None:
    """Draw the controls to open or to join a class; draw nothing in a class."""
    if lecturer_key() or student_seat():
        return
    with st.popover(_("Class"), icon=":material/groups:", key="class_door"):
        with st.form("class_join", border=False):
            code = st.text_input(
                _("Students: type the code of your class."),
                max_chars=_LONGEST_CODE,
                key="class_code",
                autocomplete="off",
            )
            if st.form_submit_button(_("Join"), type="primary"):
                run_or_refuse(class_session.take_seat, code)
                st.rerun()
        # The open popover covers the page, so show the result of a typed code in it.
        if code:
            _draw_error()
        _explain_class()
    if not code:
        _draw_error()
    if st.session_state.get(_ENDED) and address.current(progress.STOP) == progress.STOP.default:
        st.success(_("The class has ended, and its answers are deleted."))
    else:
        st.session_state.pop(_ENDED, None)


def _explain_class() -> None:
    """Explain how a class works, with a button that opens one."""
    st.markdown(_("Lecturers: three screens play together."))
    screens = (
        (":material/co_present:", _("**The wall.** The projector shows the code, then the questions and results.")),
        (":material/smartphone:", _("**The phones.** Students scan the code and vote. No names are asked.")),
        (":material/laptop_mac:", _("**The desk.** You ask, show the result, run the machine, name the answer.")),
    )
    with st.container(key="class_screens"):
        for icon, sentence in screens:
            st.markdown(f"{icon} {sentence}")
    days = {seconds: round(seconds / DAY) for seconds in LIFETIMES}
    labels = {seconds: ngettext("{n} day", "{n} days", n).format(n=n) for seconds, n in days.items()}
    with st.container(horizontal=True, vertical_alignment="bottom"):
        lifetime = st.selectbox(_("Keep the answers for"), LIFETIMES, format_func=labels.__getitem__, key="class_kept")
        st.button(
            _("Open a class"), key="class_open", type="primary", on_click=run_or_refuse, args=(open_class, lifetime)
        )
    st.caption(class_results.storage_sentence(time.time() + lifetime))
    class_results.warn_of_local_address()


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
    class_session.show_desk_view(code)


def draw_end() -> None:
    """Draw the lecturer's desk after the last stop."""
    st.title(class_results.RESULTS_HEADING, anchor=False)
    _draw_live_desk(None, Phase.ASKED)


def _draw_error() -> None:
    """Draw the error message of the last action, if there is one."""
    sentence = class_session.read_refusal()
    if sentence:
        st.warning(sentence)


# ---- the lecturer


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
        _draw_error()
        try:
            shared().find_code(key)
            current, stop_state = class_session.read_question(code), shared().read_last_state(code, place)
        except ClassError as error:
            st.warning(str(error))
            st.button(_("Leave this class"), key="class_leave", on_click=leave)
            return
        _follow_desk(current, place)
        current_phase = stop_state.phase if stop_state else Phase.ASKED
        if current_phase != phase:
            st.rerun()
        recent = class_results.recent_sentence(shared().count_seats(key))
        st.markdown(f"**{_attendance_sentence(place, current)}** {recent}")
        with st.container(key="class_moves", horizontal=True, gap="small"):
            _draw_moves(key, stop, current, stop_state)
        if stop is None:
            class_results.draw_whole_lesson(code)
        elif stop_state and stop_state.phase > Phase.ASKED:
            class_results.show(code, stop, stop_state.vote, stop_state.phase == Phase.SOLVED)
            if stop_state.phase == Phase.SOLVED:
                class_results.draw_commonest_mistake(code, stop, stop_state.vote)
        else:
            st.markdown("\n".join(f"- {label}" for label in stop.options.values()))
        with st.container(key="class_foot", horizontal=True, vertical_alignment="center"):
            _draw_foot(key, code)


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


def _attendance_sentence(place: str, current: ClassQuestion) -> str:
    """Return a sentence about the class for a desk at this place.

    It states attendance or answers. If the class is at another place, it states that place instead.
    """
    if not current.is_known:
        return class_results.unknown_stop_sentence()
    if current.stop is None or current.stop == place == END:
        return class_results.joined_sentence(current.present)
    if current.stop == END:
        return _("The class is at the end of the lesson.")
    if current.stop != place:
        return _("The class is still at “{heading}”.").format(heading=lesson.find_stop(current.stop).heading)
    return class_results.answers_sentence(current)


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


def _draw_moves(key: str, stop: Stop | None, current: ClassQuestion, stop_state: ClassQuestion | None) -> None:
    """Draw a button for each possible move. A clicker presses the first two: back and forward.

    Parameters
    ----------
    key : the lecturer's key
    stop : the stop of this desk, None at the end
    current : the current question of the class
    stop_state : the last state of this stop in the class, None if the class was never at this stop
    """
    st.html(KEY_NAMES)
    place = stop.id if stop else END
    shows_result = current.stop == place and current.phase > Phase.ASKED
    can_go_back = shows_result or progress.find_previous_stop(place) is not None
    back = _Move(_("Go back"), "back", _go_back, (place,))
    back.draw(key, shortcut="PageUp", disabled=not can_go_back)
    is_over = current.stop == place == END
    forward = _choose_forward_move(stop, current, stop_state)
    forward.draw(key, shortcut="PageDown", is_primary=True, disabled=is_over)
    if stop and current.stop != place and stop_state:
        ask_anew = partial(shared().ask, anew=True)
        _Move(_("Ask this question again"), "anew", ask_anew, (place, list(stop.options))).draw(key)
    if current.stop == place != END and not current.vote.is_second and current.reached < Phase.RUNNING:
        _Move(_("Ask again"), "again", shared().begin_second_vote).draw(key)


def _choose_forward_move(stop: Stop | None, current: ClassQuestion, stop_state: ClassQuestion | None) -> _Move:
    """Return the move of the forward button. The parameters are those of `_draw_moves`."""
    finish = _Move(_("Show what the class has learned"), "finish", _show_end)
    if stop is None:
        return finish
    if current.stop != stop.id:
        label = _("Return to this question") if stop_state else _("Ask the class")
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
    current, previous = shared().read_question(code), progress.find_previous_stop(place)
    is_here = current.stop == place
    if is_here and current.phase > Phase.ASKED:
        shared().show(key, Phase(current.phase - 1))
    elif previous and is_here and shared().read_last_state(code, previous.id):
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


def _draw_foot(key: str, code: str) -> None:
    """Draw the code, links to the other screens, and the controls for seats, results and the end of the class."""
    st.text(format_code(code), width="content")
    st.link_button(
        _("Open the wall"),
        address.link({"class": code, "wall": "on", "view": "projector"}).geturl(),
        icon=":material/co_present:",
        type="tertiary",
    )
    with st.popover(_("Open the desk on your phone"), key="class_second_desk", type="tertiary"):
        st.markdown(_("Scan this with your own phone. Whoever has this picture leads the class."))
        class_results.draw_qr_code(address.link_for_others({"class": code, "lecturer": key}).geturl())
    with st.popover(_("Manage the seats"), key="class_seats", type="tertiary"):
        _manage_seats(key)
    with st.popover(_("Download the results"), key="class_files", type="tertiary"):
        _offer_votes(key, "class_csv")
    _draw_ending(key)


def _offer_votes(key: str, name: str) -> None:
    """Offer the votes of the class as a CSV file for spreadsheets and as one for programs.

    Parameters
    ----------
    key : the lecturer's key
    name : key of the button for the second file; with the suffix “_spreadsheet”, that for the first
    """
    results = shared().read_results_for_lecturer(key)
    code, _secret = split_key(key)
    widgets.download(
        _("Download for a spreadsheet"),
        write_spreadsheet(results),
        f"class-{code}-spreadsheet.csv",
        "text/csv",
        key=f"{name}_spreadsheet",
    )
    widgets.download(_("Download as CSV"), write_csv(results), f"class-{code}.csv", "text/csv", key=name)


def _manage_seats(key: str) -> None:
    """Draw the number of seats, and the controls against a visitor who takes many seats."""
    seats = shared().count_seats(key)
    st.markdown(class_results.seats_sentence(seats))
    label = _("Let nobody else join") if seats.is_open else _("Let students join again")
    st.button(label, key="class_bar", on_click=run_or_refuse, args=(shared().let_join, key, not seats.is_open))
    st.markdown(
        _(
            "A seat is empty if its student’s page is closed. With the seat, the answer to the present question is "
            "removed, unless its result is shown. A student who comes back gets a new seat."
        )
    )
    st.button(
        _("Remove the empty seats"), key="class_clear", on_click=run_or_refuse, args=(shared().remove_absent, key)
    )


def _draw_ending(key: str) -> None:
    """Draw the expiry date of the class, a last download, and the button that ends the class."""

    def end() -> None:
        shared().close(key)
        leave()
        st.session_state[progress.PART.name] = progress.PART.default
        st.session_state[progress.STOP.name] = progress.STOP.default
        st.session_state[_ENDED] = True

    with st.popover(_("End the class"), key="class_ending", type="tertiary"):
        st.markdown(
            _("The class ends, and all its answers are deleted. Otherwise that happens on {date}.").format(
                date=local_time.date_and_time(shared().read_expiry(split_key(key)[0]))
            )
        )
        _offer_votes(key, "class_csv_last")
        label = _("End the class and delete its answers")
        st.button(label, key="class_close", on_click=run_or_refuse, args=(end,))


# ---- a student


@st.fragment(run_every=PHONE_INTERVAL)
def _draw_waiting() -> None:
    """Retry joining, and draw why the student has to wait. The students of one network get their seats in turn."""
    code = class_session.awaited_class()
    if code:
        run_or_refuse(class_session.take_seat, code)
    code = class_session.awaited_class()
    # The student has got a seat.
    if code is None:
        st.rerun()
    with st.container(key="class_phone"):
        st.html(HIDDEN_DRAWER)
        st.title(_("Class {code}").format(code=format_code(code)), anchor=False)
        st.info(class_session.read_refusal())
        _draw_leave_button()


def _draw_leave_button() -> None:
    """Draw the button that leaves the class."""
    st.button(_("Leave the class"), key="class_leave", type="tertiary", on_click=leave)


@st.fragment(run_every=PHONE_INTERVAL)
def _draw_live_question() -> None:
    """Draw the current question of the student, and read the class every few seconds for a new one."""
    seat = student_seat()
    if seat is None:
        st.rerun()
    try:
        question = class_session.read_question(seat.code)
        chosen = shared().read_answer(seat, question)
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
        if _visible_machine(question) != st.session_state[_DRAWN]:
            st.rerun()
        class_session.show_desk_view(seat.code)
        _draw_question(seat, question, chosen)
        _offer_own_tab(seat.code)


def _offer_own_tab(code: str) -> None:
    """Offer a separate tab if this page is in a frame where it cannot recognize its browser after a reload."""
    if class_session.has_no_storage():
        st.warning(
            _(
                "Your browser stores nothing for a page inside another site. Your answer counts once, but after a "
                "reload this page does not know it any more."
            )
        )
        st.link_button(_("Open the class in a tab of its own"), address.link({"class": code}).geturl())


def _visible_machine(question: ClassQuestion | None) -> tuple[str, bool] | None:
    """Return the stop whose machine the class sees, and whether it runs; None if the class sees no machine."""
    if question is None or question.stop in (None, END):
        return None
    return question.stop, question.phase >= Phase.RUNNING


def _draw_question(seat: Seat, question: ClassQuestion, chosen: str | None) -> None:
    """Draw the current question of the class, or how to go on before the first question and after the last."""
    if question.stop is None:
        st.title(_("Class {code}").format(code=format_code(seat.code)), anchor=False)
        st.info(_("You have joined the class. The first question will appear here."))
        if not question.is_known:
            st.warning(class_results.unknown_stop_sentence())
        return
    class_session.forget_refusal((question.stop, question.vote))
    if question.stop == END:
        st.title(class_results.RESULTS_HEADING, anchor=False)
        class_results.draw_whole_lesson(seat.code)
        st.button(_("Go on with the whole lesson"), key="class_alone", type="primary", on_click=leave)
        return
    stop = lesson.find_stop(question.stop)
    if question.reached > Phase.ASKED:
        _draw_closed_vote(seat, stop, question, chosen)
    else:
        _draw_open_vote(stop, question, chosen)


def _draw_closed_vote(seat: Seat, stop: Stop, question: ClassQuestion, chosen: str | None) -> None:
    """Draw a closed question: the result if it is visible now, the student's vote, and why voting is closed."""
    _draw_error()
    is_solved = question.phase == Phase.SOLVED
    if is_solved:
        class_results.draw_reason(stop, chosen)
    if question.phase > Phase.ASKED:
        class_results.show(seat.code, stop, question.vote, is_solved, chosen)
    else:
        labels = dict(stop.options)
        if chosen:
            labels[chosen] = _("{label} – *This was your answer.*").format(label=stop.options[chosen])
        st.markdown("\n".join(f"- {label}" for label in labels.values()))
    st.markdown(_own_vote_sentence(seat, stop, question, chosen))


def _own_vote_sentence(seat: Seat, stop: Stop, question: ClassQuestion, chosen: str | None) -> str:
    """Return whether the student's vote was counted, and why voting is closed, as sentences."""
    if chosen:
        return _("Your answer was counted. The result has been shown, so it can no longer be changed.")
    if question.vote.is_second:
        first_question = replace(question, vote=question.vote._replace(number=1))
        first = shared().read_answer(seat, first_question)
        if first:
            return _(
                "**Your answer in the first vote:** {label}\\\nYou have no answer in the second vote. "
                "The result has been shown, so nobody can vote on it now."
            ).format(label=stop.options[first])
    return _("You have no answer to this question. The result has been shown, so nobody can vote on it now.")


def _draw_open_vote(stop: Stop, question: ClassQuestion, chosen: str | None) -> None:
    """Draw the options of an open question, with a confirmation at the student's answer."""
    if question.vote.is_second:
        st.markdown(_("**Second vote.** Talk to your neighbours, then answer again."))
    key = f"class_answer_{stop.id}_{question.vote.times_asked}_{question.vote.number}"
    # The database contains the valid answer, also after a reload and after an answer that came too late.
    if st.session_state.get(key) != chosen:
        st.session_state[key] = chosen
    confirmation = _("Your answer counts. You can still change it.")
    captions = None
    if chosen:
        caption = f":green[:material/check_circle: {confirmation}]"
        captions = [caption if option == chosen else "" for option in stop.options]
    st.radio(
        _("Your answer"),
        list(stop.options),
        index=None,
        format_func=stop.options.__getitem__,
        captions=captions,
        key=key,
        on_change=_vote,
        args=(key, stop.id, question.vote),
    )
    _draw_error()


def _vote(key: str, stop: str, vote: Vote) -> None:
    """Callback: store the option that is selected in the widget with this key, as an answer in this vote."""
    seat = student_seat()
    if seat:
        run_or_refuse(shared().vote, seat, stop, st.session_state[key], vote)
