"""The lecturer's sliders, as the wall follows them."""

from urllib.parse import parse_qsl, urlencode

import streamlit as st

from ramanujan import Oscillator
from ramanujan.lesson.classes import ClassError, shared
from ramanujan.shell import messages, sidebar
from ramanujan.shell.parameters import MACHINE

_TOLD = "class_settings_told"


def tell(key: str) -> None:
    """Tell the wall what the sliders of the lecturer's desk hold, if that has changed."""
    machine = sidebar.oscillator()
    held = {name: getattr(machine, name) for name in MACHINE} | {"compression": sidebar.compression()}
    if (text := urlencode(held)) != st.session_state.get(_TOLD):
        try:
            shared().set_machine(key, text)
        except ClassError:
            return
        st.session_state[_TOLD] = text


def take(told: str | None) -> None:
    """Give the sliders of the wall what those of the desk hold."""
    st.session_state[_TOLD] = told
    if told:
        held = {name: float(text) for name, text in parse_qsl(told)}
        compression = held.pop("compression")
        machine = Oscillator(**held)
        if not sidebar.holds(machine, compression):
            sidebar.take_machine(machine, compression)
            messages.run_again()


def differ(told: str | None) -> bool:
    """Tell whether the desk has moved its sliders since the wall was drawn."""
    return told != st.session_state.get(_TOLD)
