"""The class on the lesson's page: a lecturer opens one and asks, students answer on their phones.

The lesson's page calls `panel(stop)` once a run, before it draws anything that gives the answer of the stop away. Who
belongs to a class is known from the session, and after a reload from the address:

    class       the code, in everybody's address; alone it is the link that students get
    lecturer    the lecturer's key, in the lecturer's own address
    voter       a student's random name, in the student's own address

*Copy link* leaves out what `PRIVATE` names. Every phone asks every few seconds what the class is asked now; that is one
read by keys, and what has been revealed is kept in the session, since it no longer changes.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from urllib.parse import urlencode, urlsplit

import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.class_codes import spaced
from ramanujan.lesson.classes import ClassError, Desk, Question, Seat, shared
from ramanujan.lesson.stop import Stop
from ramanujan.scenes import class_results
from ramanujan.words import _, ngettext

PRIVATE = ("lecturer", "voter")
"""Keys of the address that are nobody else's."""

_KEY, _SEAT = "class_key", "class_seat"
"""Session state: the lecturer's key; the student's seat."""
_SESSION = "class_session"
_JUDGED = "class_link_judged"
_SAID = "class_said"
"""Session state: what is to be said about the last thing that somebody did here."""
_DESK_EVERY, _PHONE_EVERY = 2.0, 2.5
"""Seconds between two looks at what is new, at the lecturer's desk and on a phone."""


def panel(stop: Stop) -> bool:
    """Draw what the class needs on the page of a stop, and return whether the class has seen the right answer to it.

    A student sees what the class is asked, whatever stop the page shows, and nothing more: the run of the page ends.
    """
    _arrive()
    if _KEY in st.session_state:
        desk = _desk_of(st.session_state[_KEY])
        _desk(stop)
        return bool(desk and desk.stop == stop.id and desk.solved)
    if _SEAT in st.session_state:
        _phone()
        st.stop()
    _door()
    return False


# ---- who is here


def _arrive() -> None:
    """Know a lecturer and a student again by their address, once a session; later the address follows the session."""
    link = st.query_params
    if not st.session_state.setdefault(_JUDGED, False):
        st.session_state[_JUDGED] = True
        if key := link.get("lecturer"):
            _try(_sit_at_desk, key)
        elif code := link.get("class"):
            _try(_take_seat, code, link.get("voter", ""))
    if _KEY in st.session_state:
        _write_address({"class": st.session_state[_KEY].partition("-")[0], "lecturer": st.session_state[_KEY]})
    elif _SEAT in st.session_state:
        seat = st.session_state[_SEAT]
        _write_address({"class": seat.code, "voter": seat.voter})


def _write_address(wanted: dict[str, str]) -> None:
    """Let the address say this of the class, and nothing else."""
    for name in ("class", *PRIVATE):
        if st.query_params.get(name) == wanted.get(name):
            continue
        if name in wanted:
            st.query_params[name] = wanted[name]
        else:
            del st.query_params[name]


def _sit_at_desk(key: str) -> None:
    shared().code_of(key)
    st.session_state[_KEY] = key


def _open_class() -> None:
    st.session_state[_KEY] = shared().open_class().key


def _take_seat(code: str, voter: str = "") -> None:
    session = st.session_state.setdefault(_SESSION, secrets.token_urlsafe(9))
    st.session_state[_SEAT] = shared().join(code, session, voter)


def _leave() -> None:
    """Belong to no class any more; the next run cleans the address."""
    st.session_state.pop(_KEY, None)
    st.session_state.pop(_SEAT, None)
    _write_address({})


def _try(act: Callable, *values: object) -> None:
    """Do something with the class, or keep the sentence that says why not."""
    st.session_state.pop(_SAID, None)
    try:
        act(*values)
    except ClassError as error:
        st.session_state[_SAID] = str(error)


def _say() -> None:
    if sentence := st.session_state.get(_SAID):
        st.warning(sentence)


# ---- who belongs to no class


def _door() -> None:
    """Let a lecturer open a class, and a student join one."""
    _say()
    with st.popover(_("Join or open a class"), icon=":material/groups:"):
        with st.form("class_door", border=False):
            code = st.text_input(_("Code of the class"), max_chars=20, key="class_code", autocomplete="off")
            if st.form_submit_button(_("Join")):
                _try(_take_seat, code)
                st.rerun()
        st.caption(
            _(
                "Lecturer: open a class of your own. You get a code for your students, and they answer on their phones. "
                "Nobody gives a name, and everything is deleted after 24 hours."
            )
        )
        st.button(_("Open a class"), key="class_open", on_click=_try, args=(_open_class,))


# ---- the lecturer


def _desk_of(key: str) -> Desk | None:
    try:
        return shared().desk(key)
    except ClassError as error:
        st.session_state[_SAID] = str(error)
        return None


@st.fragment(run_every=_DESK_EVERY)
def _desk(stop: Stop) -> None:
    """Draw the lecturer's desk: code, numbers of students, and what can be done now."""
    if (key := st.session_state.get(_KEY)) is None:
        return
    desk = _desk_of(key)
    code = key.partition("-")[0]
    with st.container(key="class_desk"):
        _say()
        if desk is None:
            if st.button(_("Leave this class"), key="class_leave", on_click=_leave):
                st.rerun()
            return
        _invitation(code, desk)
        with st.container(horizontal=True, vertical_alignment="center"):
            st.markdown(f"**{spaced(code)}**", width="content")
            st.markdown(_attendance(stop, desk), width="content")
            _next_moves(key, stop, desk)
            _end(key)
        if desk.stop == stop.id and desk.revealed:
            class_results.show(key, stop, desk.round, desk.solved)


def _attendance(stop: Stop, desk: Desk) -> str:
    """Return who is there and how many have answered, as a sentence."""
    if desk.stop is None:
        return ngettext("{joined} student has joined.", "{joined} students have joined.", desk.joined).format(
            joined=desk.joined
        )
    if desk.stop != stop.id:
        return _("The class is still at “{heading}”.").format(heading=lesson.stop(desk.stop).heading)
    words = (
        ngettext(
            "{answered} of {joined} student has answered.",
            "{answered} of {joined} students have answered.",
            desk.joined,
        )
        if desk.round == 1
        else ngettext(
            "Second vote: {answered} of {joined} student.", "Second vote: {answered} of {joined} students.", desk.joined
        )
    )
    return words.format(answered=desk.answered, joined=desk.joined)


def _next_moves(key: str, stop: Stop, desk: Desk) -> None:
    """Draw a button for each thing that the lecturer may do next; the usual one stands out."""
    classes = shared()

    def button(label: str, name: str, act: Callable, *more: object, usual: bool = False) -> bool:
        kind = "primary" if usual else "secondary"
        return st.button(label, key=f"class_{name}", type=kind, on_click=_try, args=(act, key, *more))

    if desk.stop != stop.id:
        button(_("Ask the class"), "ask", classes.present, stop.id, [each.id for each in stop.options], usual=True)
        return
    if not desk.revealed:
        button(_("Show the result"), "reveal", classes.reveal, usual=True)
    if desk.round == 1 and not desk.solved:
        button(_("Ask again"), "again", classes.ask_again, usual=desk.revealed)
    # The page itself may show the answer now, too.
    if (
        desk.revealed
        and not desk.solved
        and button(_("Show the right answer"), "solve", classes.solve, usual=desk.round > 1)
    ):
        st.rerun()


def _end(key: str) -> None:
    def end() -> None:
        shared().close(key)
        _leave()

    with st.popover(_("End")):
        st.markdown(_("The class ends, and all its answers are deleted."))
        if st.button(_("End the class"), key="class_close", on_click=_try, args=(end,)):
            st.rerun()


def _invitation(code: str, desk: Desk) -> None:
    """Draw code and address so that the last row can read them; open until the first question is asked."""
    address = urlsplit(st.context.url or "")
    shown = f"{address.netloc}{address.path}" or _("this page")
    with st.expander(_("How to join"), expanded=desk.stop is None), st.container(key="class_invitation"):
        words, picture = st.columns([3, 1], vertical_alignment="center")
        with words:
            st.markdown(_("Open this page on your phone:"))
            # As plain text: an address is whatever the browser says it is.
            st.text(shown)
            st.markdown(_("Choose *Join or open a class* and type the code:"))
            st.text(spaced(code))
        with picture:
            _qr_code(f"{address.scheme}://{shown}?{urlencode({'class': code})}")
        if address.hostname in ("localhost", "127.0.0.1", "::1"):
            st.warning(
                _(
                    "Phones cannot open this address: it means this computer only. Open this page under the "
                    "computer’s address in the network, then open a class there."
                )
            )


def _qr_code(address: str) -> None:
    """Draw the students' link as a QR code, where the package segno is installed."""
    try:
        import segno
    except ImportError:
        return
    st.image(segno.make(address, micro=False).svg_inline(scale=8, border=3, light="white"), width="stretch")


# ---- a student


@st.fragment(run_every=_PHONE_EVERY)
def _phone() -> None:
    """Draw what a student is asked now, and look every few seconds whether it is still that."""
    if _SEAT not in st.session_state:
        return
    with st.container(key="class_phone"):
        try:
            question = _question()
        except ClassError as error:
            st.warning(str(error))
        else:
            _asked(st.session_state[_SEAT], question)
        if st.button(_("Leave the class"), key="class_leave", type="tertiary", on_click=_leave):
            st.rerun()


def _question() -> Question:
    """Return what the student is asked; whoever has lost the seat to a neighbour with the same address gets another."""
    seat: Seat = st.session_state[_SEAT]
    question = shared().question(seat)
    if question.kept:
        return question
    st.session_state[_SEAT] = shared().move(seat)
    _arrive()
    return shared().question(st.session_state[_SEAT])


def _asked(seat: Seat, question: Question) -> None:
    if question.stop is None:
        st.info(_("You are in class {code}. The first question will appear here.").format(code=spaced(seat.code)))
        return
    stop = lesson.stop(question.stop)
    st.subheader(stop.heading, anchor=False)
    st.markdown(stop.question)
    if question.revealed:
        st.session_state.pop(_SAID, None)
        class_results.show(seat.code, stop, question.round, question.solved, question.chosen)
        return
    if question.round > 1:
        st.markdown(_("**Second vote.** Talk to your neighbour, then answer again."))
    key = f"class_answer_{stop.id}_{question.round}"
    # What counts is what the class’s file says, also after a reload and after an answer that came too late.
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
    _say()
    if question.chosen:
        st.success(_("Your answer counts. You can change it until the result is shown."))


def _vote(key: str, stop: str, round_: int) -> None:
    seat, option = st.session_state[_SEAT], st.session_state[key]
    _try(shared().vote, seat.code, seat.voter, stop, option, round_)
