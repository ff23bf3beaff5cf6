"""The first run of a visit to the first page draws the machine below its opening, alone.

Once the machine moves, the browser asks for all the rest, which takes it as long again: the pages’ bar, the sidebar,
curve and steps.
"""

import streamlit as st

from ramanujan.browser import components
from ramanujan.shell import display_mode, messages, navigation, theme

_ALONE = "alone"
"""Session state: whether this run draws the machine alone; missing until the first run."""


def begin() -> bool:
    """Begin a run: mount the page's services, and return whether this run draws the machine alone."""
    first = _ALONE not in st.session_state and navigation.is_first_page()
    # Without a browser nothing ever moves; a projector's slides are there from the start.
    waits = first and display_mode.in_browser() and st.query_params.get("view") != "projector"
    # A page whose machine moves says so to a server that was started anew, too, and keeps all that it has.
    moves = components.mount_services(theme.current(), waits, messages.stay)
    st.session_state[_ALONE] = waits and not moves
    return alone()


def alone() -> bool:
    """Tell whether this run draws the machine alone."""
    return st.session_state[_ALONE]
