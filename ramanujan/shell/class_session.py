"""The role of this session in a class: lecturer with a key, student with a seat, wall, or none.

The role is stored in the session state, and after a reload it is read from the address (`class_keys`). A random cookie
of the browser identifies a student (`server.cookies`), so all tabs of a phone share one vote. A frame of another site
receives no cookie, so a student needs a tab.

The wall also follows the sliders of the lecturer's desk.
"""

import json
import secrets
from collections.abc import Callable
from contextlib import suppress
from typing import Any
from urllib.parse import parse_qsl, urlencode

import streamlit as st

from ramanujan import Oscillator
from ramanujan.browser import topics
from ramanujan.classroom.codes import hash_browser, split_key
from ramanujan.classroom.results import find_stop
from ramanujan.classroom.rules import ClassError, Phase, Seat, Vote, shared
from ramanujan.classroom.states import END, ClassView
from ramanujan.lesson.stop import Stop
from ramanujan.shell import address, messages, sidebar
from ramanujan.shell.class_keys import CLASS, COOKIE, FRAME, LECTURER, WALL
from ramanujan.shell.parameters import MACHINE

VIEW_INTERVAL = 0.5
"""Interval at which a wall or another desk reads the view of the desk [s]."""

_KEY, _SEAT, _WALL = "class_key", "class_seat", "class_wall"
"""Session state: the lecturer's key, the student's seat, and the code of the class if this session is its wall."""
_SESSION = "class_session"
"""Session state: a random name, used if the browser stores no cookies."""
_SETTINGS = "class_settings"
"""Session state: the settings of the desk that this session last sent or received."""
_FOLLOWED = "class_followed"
"""Session state: the desk’s last message about its stage, and the message to the stage of this screen."""
_ADDRESS_WAS_READ = "class_address_read"
"""Session state: whether the role was read from the address."""
_REFUSAL = "class_refusal"
"""Session state: the error message of the last action."""
_REFUSED_QUESTION = "class_refused_question"
"""Session state: the question with which the error message was first shown."""


def restore_role() -> None:
    """Read the role from the address, once in a session. Afterwards write the role into the address."""
    if not st.session_state.get(_ADDRESS_WAS_READ):
        st.session_state[_ADDRESS_WAS_READ] = True
        _take_role_in_address()
    key, wall, seat = lecturer_key(), wall_code(), student_seat()
    if key:
        code, _secret = split_key(key)
        _write_address(code, lecturer=key)
    elif wall:
        _write_address(wall, wall="on")
    elif seat:
        _write_address(seat.code)


def _take_role_in_address() -> None:
    """Make this session the lecturer's, the wall or a student's, as the address requests."""
    code, key = address.current(CLASS), address.current(LECTURER)
    if key:
        run_or_refuse(_become_lecturer, key)
    elif code and address.current(WALL):
        st.session_state[_WALL] = code
    elif code and not needs_own_tab():
        run_or_refuse(take_seat, code)


def lecturer_key() -> str | None:
    """Return the lecturer's key, if this session is the lecturer's."""
    return st.session_state.get(_KEY)


def student_seat() -> Seat | None:
    """Return the student's seat, if this session is a student's."""
    return st.session_state.get(_SEAT)


def wall_code() -> str | None:
    """Return the code of the class, if this session is its wall."""
    return st.session_state.get(_WALL)


def find_class_phase(stop: Stop) -> Phase | None:
    """Return the phase of a stop in the class; None if this is not the lecturer’s session.

    A stop that was not asked yet, or whose class has ended, is in the first phase.
    """
    key = lecturer_key()
    if key is None:
        return None
    last_vote = None
    with suppress(ClassError):
        last_vote = read_desk(key).find_last_vote(stop.id)
    return last_vote.phase if last_vote else Phase.ASKED


def read(code: str, voter: str = "") -> ClassView:
    """Return a class. Raise `ClassError` if this version of the app does not have one of its stops."""
    return _check_stops(shared().read(code, voter))


def read_desk(key: str) -> ClassView:
    """Return the lecturer's class. Raise `ClassError` if this version of the app does not have one of its stops."""
    return _check_stops(shared().read_for_lecturer(key))


def _check_stops(view: ClassView) -> ClassView:
    """Return a class whose stops this version of the app has."""
    for question in (view.current, *view.asked):
        if question.stop not in (None, END):
            find_stop(question.stop)
    return view


def open_class() -> None:
    """Open a new class with this session as its lecturer."""
    st.session_state[_KEY] = shared().open_class().key


def take_seat(code: str) -> None:
    """Join the class with this code. A session has at most one seat."""
    name = identify_browser() or st.session_state.setdefault(_SESSION, secrets.token_urlsafe(9))
    st.session_state.pop(_SEAT, None)
    st.session_state[_SEAT] = shared().join(code, hash_browser(name, code))


def identify_browser() -> str:
    """Return the random name of this browser; an empty text if the browser stores no cookies."""
    return st.context.cookies.get(COOKIE, "")


def needs_own_tab() -> bool:
    """Return whether this page cannot recognize its browser, because it is in a frame of another site."""
    return bool(address.current(FRAME)) and not identify_browser()


def leave() -> None:
    """Give up the role in the class."""
    for name in (_KEY, _SEAT, _WALL, _REFUSAL):
        st.session_state.pop(name, None)
    _write_address()


def run_or_refuse(action: Callable[..., object], *arguments: object) -> None:
    """Call a function of the class. If it raises `ClassError`, store the message (see `read_refusal`)."""
    for name in (_REFUSAL, _REFUSED_QUESTION):
        st.session_state.pop(name, None)
    try:
        action(*arguments)
    except ClassError as error:
        st.session_state[_REFUSAL] = str(error)


def read_refusal() -> str | None:
    """Return the error message of the last call of `run_or_refuse`, or None."""
    return st.session_state.get(_REFUSAL)


def forget_refusal(question: tuple[str, Vote]) -> None:
    """Delete the error message if it was first shown with another question. A question is a stop and a vote."""
    if _REFUSAL not in st.session_state:
        return
    first_question = st.session_state.setdefault(_REFUSED_QUESTION, question)
    if question != first_question:
        st.session_state.pop(_REFUSAL)


def send_settings(key: str) -> None:
    """Send the values of the desk's sliders to the wall if they have changed."""
    machine = sidebar.oscillator()
    values = {name: getattr(machine, name) for name in MACHINE} | {"compression": sidebar.compression()}
    text = urlencode(values)
    if text == st.session_state.get(_SETTINGS):
        return
    with suppress(ClassError):
        shared().set_machine(key, text)
        st.session_state[_SETTINGS] = text


def apply_settings(settings: str | None) -> None:
    """Set the sliders of the wall to the values of the desk's sliders."""
    st.session_state[_SETTINGS] = settings
    if not settings:
        return
    values = {name: float(text) for name, text in parse_qsl(settings)}
    compression = values.pop("compression")
    machine = Oscillator(**values)
    if not sidebar.shows_machine(machine, compression):
        sidebar.request_machine(machine, compression)
        messages.run_again()


def settings_differ(settings: str | None) -> bool:
    """Return whether the desk's sliders have changed since the wall was drawn."""
    return settings != st.session_state.get(_SETTINGS)


def send_view(stop: Stop, view: dict[str, Any]) -> None:
    """Send the desk's view of a stop's machine to all screens, if this is the current stop of the class."""
    key = lecturer_key()
    if key is None:
        return
    code, _secret = split_key(key)
    with suppress(ClassError):
        if shared().read(code).current.stop != stop.id:
            return
        message = {"stop": stop.id, **view}
        text = json.dumps(message)
        shared().set_view(key, text)
        st.session_state[_FOLLOWED] = text, {**message, "ago": 0.0, "own": True}


def show_desk_view(class_view: ClassView) -> None:
    """Show the desk's last view on the stage of this screen. The screen is a wall, a phone or another desk."""
    text = class_view.desk_view
    if text is None:
        return
    last_text, view = st.session_state.get(_FOLLOWED, (None, None))
    if text != last_text:
        view = {**json.loads(text), "ago": class_view.desk_view_age}
        st.session_state[_FOLLOWED] = text, view
    topics.publish("class_seen", {f"view/stop_{view['stop']}": view})


def _become_lecturer(key: str) -> None:
    """Make this session the lecturer's. Raise `ClassError` if no class has this key."""
    shared().find_code(key)
    st.session_state[_KEY] = key


def _write_address(code: str = "", lecturer: str = "", wall: str | None = None) -> None:
    """Write the role in a class into the address, or remove it."""
    for parameter, value in ((CLASS, code), (LECTURER, lecturer), (WALL, wall)):
        st.session_state[parameter.name] = value
    address.update(CLASS, LECTURER, WALL)
