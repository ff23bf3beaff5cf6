"""Values of widgets that the app sets: a preset, an exact entry, a click on the curve, the machine of a stop.

Each message from the page contains the values of all widgets at the time it was sent. If the page has not yet received
a value that the app set, its message would restore the old value. This protocol prevents that for
every widget:

1. Each update has a number, and a hidden slider is set to the number of the last one.
2. Streamlit's page sets its widgets to the values from the server, the hidden slider last. Every later message
   contains the number in this slider, and thereby the last update that the page had received.
3. Updates that it had not received are set again, under a new number. If the message shows that the user has moved the
   same widget meanwhile, the user's newer value wins.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import streamlit as st

from ramanujan.translation import _

_SEEN = "update_seen"
"""The hidden slider."""
_UPDATES = "updates"


@dataclass
class _Updates:
    """Values that the page may not have received.

    Change it in place and first: Streamlit may interrupt a run at each access to the session state.
    """

    number: int = 0
    waiting: dict[str, tuple[set, Any, int]] = field(default_factory=dict)
    """Key of a widget → its previous values, its new value, and the number of the update."""


def set_widgets(values: Mapping[str, Any]) -> None:
    """Set widgets, key → value, and repeat this until the page has received the values."""
    held = {key: st.session_state.get(key) for key in values}
    waiting = _updates().waiting
    before = {key: {held[key]} | (waiting[key][0] | {waiting[key][1]} if key in waiting else set()) for key in values}
    _set({key: (before[key], value) for key, value in values.items() if key in waiting or held[key] != value})


def reassert() -> None:
    """Set the values again that the page had not received when it sent its last message.

    Call it before anything reads or draws the widgets: at the start of a run, and of each callback.
    """
    updates, seen = _updates(), st.session_state.get(_SEEN, 0)
    updates.number = max(updates.number, seen)
    updates.waiting = {key: each for key, each in updates.waiting.items() if each[2] > seen}
    now = {key: st.session_state.get(key) for key in updates.waiting}
    _set(
        {
            key: (before, value if now[key] in before else now[key])
            for key, (before, value, _number) in updates.waiting.items()
        }
    )


def waits() -> bool:
    """Return whether the page may not have received a value."""
    return bool(_updates().waiting)


def draw() -> None:
    """Draw the hidden slider, from the first run on. Call it after all widgets that are set.

    A message without this slider would leave its number as the server has set it.
    """
    if waits():
        st.session_state[_SEEN] = _updates().number
    st.slider(_("Updates"), 0, 2**31, key=_SEEN, on_change="ignore")


def _set(values: Mapping[str, tuple[set, Any]]) -> None:
    updates = _updates()
    updates.number += bool(values)
    updates.waiting |= {key: (before, value, updates.number) for key, (before, value) in values.items()}
    for key, (_before, value) in values.items():
        st.session_state[key] = value


def _updates() -> _Updates:
    return st.session_state.setdefault(_UPDATES, _Updates())
