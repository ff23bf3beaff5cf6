"""Values that the app itself gives to its widgets: a preset, an exact entry, a released slab, a click on the curve.

Every message from the page carries the values of all its widgets. A message that was written before the page heard of
a given value still carries the old one, and would take the new one back: on a slow network, or after a run that was
broken off before it was delivered. So every given value has a number, the page sends a receipt for the highest number
that it has seen, and until then the given value is given again, whatever the page reports.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import streamlit as st

from ramanujan.browser import page

_WAITING = "given_waiting"
_NUMBER = "given_number"
_RECEIPT = "given_receipt"
_DRAWN = "given_drawn"
"""Session state: what the widgets held when the whole page was last drawn to its end."""
_PATIENCE = 20.0
"""Seconds after which a value counts as received: a page that sends no receipt must not hold its sliders for ever."""


@dataclass(frozen=True)
class _Given:
    value: Any
    number: int
    at: float


def give(key: str, value: Any) -> None:
    """Set the widget of this key, and hold the value until the page has received it."""
    number = st.session_state.get(_NUMBER, 0) + 1
    st.session_state[_NUMBER] = number
    waiting = st.session_state.get(_WAITING, {})
    st.session_state[_WAITING] = {**waiting, key: _Given(value, number, time.monotonic())}
    st.session_state[key] = value


def hold() -> None:
    """Give again what the page had not received when it sent its last message.

    Call it before anything reads or draws the widgets: at the start of a run, and of each callback.
    """
    received = st.session_state[_RECEIPT].received or 0 if _RECEIPT in st.session_state else 0
    oldest = time.monotonic() - _PATIENCE
    waiting = {
        key: each
        for key, each in st.session_state.get(_WAITING, {}).items()
        if each.number > received and each.at > oldest and in_browser()
    }
    st.session_state[_WAITING] = waiting
    for key, each in waiting.items():
        st.session_state[key] = each.value


def receipt() -> None:
    """Let the page tell what it has received; a receipt reruns nothing but this."""
    st.session_state.pop(_DRAWN, None)
    _receipt()


def waits() -> bool:
    """Tell whether the page has still to receive a value."""
    return bool(st.session_state.get(_WAITING))


def drawn() -> None:
    """Note what the page was drawn with, while a receipt is expected; call it at the end of a run."""
    if waits():
        st.session_state[_DRAWN] = _settings()


@st.fragment
def _receipt() -> None:
    waiting = {key: each.value for key, each in st.session_state.get(_WAITING, {}).items()}
    page.receipt(_RECEIPT, st.session_state.get(_NUMBER, 0), waiting)
    # Streamlit sends what happens in one moment as one message, and as a fragment's if one part of it is: a click that
    # meets a receipt would change the session and not the page.
    if st.session_state.get(_DRAWN, settings := _settings()) != settings:
        st.rerun()


def _settings() -> dict[str, Any]:
    """Return what the session holds in plain values, apart from what stands here."""
    plain = (bool, int, float, str, tuple, list, dict, type(None))
    return {
        key: value
        for key, value in st.session_state.items()
        if isinstance(value, plain) and not str(key).startswith("given_")
    }


def in_browser() -> bool:
    """Tell whether a browser asks: it names its time zone. A test without one waits its turn, so no messages cross."""
    return st.context.timezone is not None
