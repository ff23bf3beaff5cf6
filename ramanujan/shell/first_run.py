"""The first run of a visit to the first page draws only the words of the opening and the machine.

Once the machine moves, the page requests a second run with everything else: menu, sliders, curve and steps. In a single
run, Plotly's scripts block the browser before the machine is drawn. The first picture took 7.8 times as long as that
of a bare page. `tests/benchmarks/app.py` measures the ratio with two runs.
"""

import streamlit as st

from ramanujan.browser.components import services
from ramanujan.shell import address, display_mode, menu, messages, theme

_ONLY_MACHINE = "only_machine"
"""Session state: whether this run draws only the machine; missing before the first run."""


def begin() -> bool:
    """Mount the services of the page, and return whether this run draws only the machine."""
    is_first = _ONLY_MACHINE not in st.session_state and menu.is_first_page()
    # Without a browser no machine moves, and the projector view needs all slides from the start.
    needs_second_run = is_first and display_mode.is_browser() and not address.read_value(display_mode.VIEW)
    # After a restart of the server, the machine of an open page is already moving.
    is_moving = services.mount(theme.current(), needs_second_run, on_moving=messages.keep_in_next_run)
    st.session_state[_ONLY_MACHINE] = needs_second_run and not is_moving
    return draws_only_machine()


def draws_only_machine() -> bool:
    """Return whether this run draws only the machine."""
    return st.session_state[_ONLY_MACHINE]
