"""Values that the app sets itself: a preset, an exact entry, a click on the curve, the machine of a stop.

A message of the page carries what all widgets held when it was written. If the page had not yet heard of a value that
the app has set, its message still carries the old one, and would take the new one back. This is the one protocol
against that, for every widget:

1. Each update has a number, and a hidden slider is set to the number of the last one.
2. Streamlit's page puts into its widgets what the server sets, the hidden slider last, and sends it back with every
   later message. So a message says by itself which updates the page had heard of when it was written.
3. What it had not heard of is set again, under a new number. If the message shows that somebody has moved that very
   widget meanwhile, the user's newer value wins.
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
    """Values of which the page may not have heard.

    It is changed in place and first: each access to the session is a place where Streamlit may break off a run.
    """

    number: int = 0
    waiting: dict[str, tuple[set, Any, int]] = field(default_factory=dict)
    """Key of a widget → the values that it had before, the one that it has been set to, the number of the update."""


def set_widgets(values: Mapping[str, Any]) -> None:
    """Set widgets, key → value, and keep them so until the page has heard of it."""
    held = {key: st.session_state.get(key) for key in values}
    waiting = _updates().waiting
    before = {key: {held[key]} | (waiting[key][0] | {waiting[key][1]} if key in waiting else set()) for key in values}
    _set({key: (before[key], value) for key, value in values.items() if key in waiting or held[key] != value})


def reassert() -> None:
    """Set again the values of which the page had not heard when it wrote its last message.

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
    """Tell whether the page may not have heard of a value."""
    return bool(_updates().waiting)


def draw() -> None:
    """Draw the hidden slider, from the first run on; call it after all widgets that are set.

    A message that does not contain it would leave the number that the server has set itself.
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
