"""The class on the lesson's page: a lecturer opens one and asks, students answer on their phones.

    guests()      at the head of the page: a student sees what the class is asked, and nothing else of the page;
                  a lecturer who invites sees code and address alone
    door()        where a visitor opens a class or joins one
    panel(stop)   on the page of a stop: the lecturer's desk

Every phone asks every few seconds what the class is asked now: one read by keys.
"""

from __future__ import annotations

from collections.abc import Callable
from urllib.parse import urlencode, urlsplit

import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.class_codes import parts_of, spaced
from ramanujan.lesson.classes import ClassError, Desk, Question, Seat, shared
from ramanujan.lesson.stop import Stop
from ramanujan.pages.lesson import class_results
from ramanujan.shell.class_session import (
    arrive,
    attempt,
    change_seat,
    forget_refusal,
    has_seen,
    is_solved,
    key_held,
    leave,
    open_class,
    refusal,
    seat_held,
    take_seat,
)
from ramanujan.translation import _, ngettext

DESK_EVERY, PHONE_EVERY = 2.0, 2.5
"""Seconds between two looks at what is new, at the lecturer's desk and on a phone."""

_INVITING = "class_inviting"
_LONGEST_CODE = 20
_ONLY_HERE = ("localhost", "127.0.0.1", "::1")


def guests() -> None:
    """Draw the page of a student, or of a lecturer who invites, and end the run; for others do nothing."""
    arrive()
    if _invites():
        _invitation()
        st.stop()
    if seat_held():
        _phone()
        st.stop()


def door() -> None:
    """Let a lecturer open a class, and a student join one; for whoever is in a class there is nothing to draw."""
    if key_held() or seat_held():
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
                attempt(take_seat, code)
                st.rerun()
        # Whoever typed a code looks here, and sees nothing of what stands below.
        if code:
            _warn()
        st.markdown(_("Lecturer: open a class, and your students answer on their phones."))
        st.button(_("Open a class"), key="class_open", on_click=_begin)
        st.caption(_("Nobody gives a name. Everything is deleted after 24 hours."))
    if not code:
        _warn()


def panel(stop: Stop) -> bool | None:
    """Draw the lecturer's desk: the options, or how the class has voted, and what can be done next.

    Returns
    -------
    None for whoever has no class; else whether the class has seen the right answer, so that the page may show it, too
    """
    if (solved := has_seen(stop)) is not None:
        _desk(stop, solved)
    return solved


def _warn() -> None:
    if sentence := refusal():
        st.warning(sentence)


# ---- the lecturer


def _begin() -> None:
    attempt(open_class)
    st.session_state[_INVITING] = key_held() is not None


def _invite(inviting: bool) -> None:
    st.session_state[_INVITING] = inviting


def _invites() -> bool:
    return bool(key_held() and st.session_state.get(_INVITING))


@st.fragment(run_every=DESK_EVERY)
def _invitation() -> None:
    """Draw code and address so that the last row can read them, and how many have joined."""
    if not _invites():
        st.rerun()
    code, address = parts_of(key_held())[0], urlsplit(st.context.url or "")
    shown = f"{address.netloc}{address.path}"
    with st.container(key="class_invitation"):
        st.title(_("Join the class"), anchor=False)
        words, picture = st.columns([2, 1], gap="large", vertical_alignment="center")
        with words:
            st.markdown(_("On your phone, open"))
            with st.container(key="class_address"):
                # As plain text: an address is whatever the browser says it is.
                st.text(shown)
            st.markdown(_("then choose **Class** and type"))
            with st.container(key="class_letters"):
                st.text(spaced(code))
        with picture:
            _qr_code(f"{address.scheme}://{shown}?{urlencode({'class': code})}")
        if address.hostname in _ONLY_HERE:
            st.warning(
                _(
                    "Phones cannot open this address, because it means this computer only. Open the app under the "
                    "computer’s address in the network, then open a class there."
                )
            )
        with st.container(horizontal=True, vertical_alignment="center", gap="large"):
            try:
                st.markdown(_joined(shared().desk(key_held()).joined), width="content")
            except ClassError as error:
                st.warning(str(error))
            st.button(_("Go to the questions"), key="class_go", type="primary", on_click=_invite, args=(False,))


def _qr_code(address: str) -> None:
    """Draw the students' link as a QR code, where the package segno is installed."""
    try:
        import segno
    except ImportError:
        return
    picture = segno.make(address, micro=False).svg_inline(scale=8, border=3, light="white")
    st.image(picture, width="stretch")


def _joined(people: int) -> str:
    return ngettext("{n} student has joined.", "{n} students have joined.", people).format(n=people)


@st.fragment(run_every=DESK_EVERY)
def _desk(stop: Stop, solved: bool) -> None:
    """Draw the desk beside a page that shows the right answer or not; where that has changed, run the whole page."""
    if (key := key_held()) is None or _invites():
        st.rerun()
    with st.container(key="class_desk"):
        _warn()
        try:
            desk = shared().desk(key)
        except ClassError as error:
            st.warning(str(error))
            st.button(_("Leave this class"), key="class_leave", on_click=leave)
            return
        if is_solved(stop, desk) != solved:
            st.rerun()
        st.markdown(f"**{_attendance(stop, desk)}**")
        with st.container(horizontal=True, gap="small"):
            _next_moves(key, stop, desk)
        if desk.stop == stop.id and desk.revealed:
            class_results.show(key, stop, desk.round, desk.solved)
        else:
            st.markdown("\n".join(f"- {option.label}" for option in stop.options))
        with st.container(key="class_foot", horizontal=True, vertical_alignment="center"):
            st.text(spaced(parts_of(key)[0]), width="content")
            if st.button(
                _("Show code and address"), key="class_invite", on_click=_invite, args=(True,), type="tertiary"
            ):
                st.rerun()
            _ending(key)


def _attendance(stop: Stop, desk: Desk) -> str:
    """Return who is there and how many have answered, as a sentence."""
    if desk.stop is None:
        return _joined(desk.joined)
    if desk.stop != stop.id:
        return _("The class is still at “{heading}”.").format(heading=lesson.stop(desk.stop).heading)
    numbers = {"answered": desk.answered, "joined": desk.joined}
    if desk.round > 1:
        return ngettext(
            "Second vote: {answered} of {joined} student has answered.",
            "Second vote: {answered} of {joined} students have answered.",
            desk.joined,
        ).format(**numbers)
    return ngettext(
        "{answered} of {joined} student has answered.", "{answered} of {joined} students have answered.", desk.joined
    ).format(**numbers)


def _next_moves(key: str, stop: Stop, desk: Desk) -> None:
    """Draw a button for each thing that the lecturer may do next; the usual one stands out."""
    classes = shared()

    def button(label: str, name: str, act: Callable, *more: object, usual: bool) -> None:
        kind = "primary" if usual else "secondary"
        st.button(label, key=f"class_{name}", type=kind, on_click=attempt, args=(act, key, *more))

    if desk.stop != stop.id:
        button(_("Ask the class"), "ask", classes.present, stop.id, [each.id for each in stop.options], usual=True)
        return
    if not desk.revealed:
        button(_("Show the result"), "reveal", classes.reveal, usual=True)
    if desk.round == 1 and not desk.solved:
        button(_("Ask again"), "again", classes.ask_again, usual=desk.revealed)
    if desk.revealed and not desk.solved:
        button(_("Show the right answer"), "solve", classes.solve, usual=desk.round > 1)


def _ending(key: str) -> None:
    def end() -> None:
        shared().close(key)
        leave()

    with st.popover(_("End"), key="class_ending", type="tertiary"):
        st.markdown(_("The class ends, and all its answers are deleted."))
        st.button(_("End the class"), key="class_close", on_click=attempt, args=(end,))


# ---- a student


@st.fragment(run_every=PHONE_EVERY)
def _phone() -> None:
    """Draw what a student is asked now, and look every few seconds whether it is still that."""
    if (seat := seat_held()) is None:
        st.rerun()
    with st.container(key="class_phone"):
        try:
            question = shared().question(seat)
            if not question.kept:
                seat = change_seat()
                question = shared().question(seat)
        except ClassError as error:
            st.warning(str(error))
        else:
            _asked(seat, question)
        st.button(_("Leave the class"), key="class_leave", type="tertiary", on_click=leave)


def _asked(seat: Seat, question: Question) -> None:
    if question.stop is None:
        st.title(_("Class {code}").format(code=spaced(seat.code)), anchor=False)
        st.info(_("You have joined the class. The first question will appear here."))
        return
    forget_refusal((question.stop, question.round))
    stop = lesson.stop(question.stop)
    st.title(stop.heading, anchor=False)
    st.markdown(stop.question)
    if question.revealed:
        _warn()
        class_results.show(seat.code, stop, question.round, question.solved, question.chosen)
        return
    if question.round > 1:
        st.markdown(_("**Second vote.** Talk to your neighbours, then answer again."))
    key = f"class_answer_{stop.id}_{question.round}"
    # What the file says counts, also after a reload and after an answer that came too late.
    if st.session_state.get(key) != question.chosen:
        st.session_state[key] = question.chosen
    st.radio(
        _("Your answer"),
        [option.id for option in stop.options],
        index=None,
        format_func=lambda name: stop.option(name).label,
        key=key,
        on_change=_vote,
        args=(key, stop.id, question.round),
    )
    _warn()
    if question.chosen:
        st.success(_("Your answer counts. You can change it until the result is shown."))


def _vote(key: str, stop: str, round_: int) -> None:
    if seat := seat_held():
        attempt(shared().vote, seat.code, seat.voter, stop, st.session_state[key], round_)
