"""Values of widgets that the app sets: a preset, an exact entry, a click on the curve, the machine of a stop.

Each message from the page contains the values of all widgets at the time it was sent. If the page has not yet received
a value that the app set, its message would restore the old value. This protocol prevents that for every widget:

1. Each update has a number, and a hidden slider is set to the number of the last one.
2. Streamlit's page sets its widgets to the values from the server, the hidden slider last. Every later message
   contains the number in this slider, and thereby the last update that the page had received.
3. Updates that it had not received are set again, under a new number. If the message shows that the user has moved the
   same widget meanwhile, the user's newer value wins.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import streamlit as st

from ramanujan.text.translation import _

_SEEN = "update_seen"
"""The hidden slider."""
_WAITING = "updates"
"""Session state: key of a widget → the update that the page may not have received.

The mapping is changed in place, and before the widgets: Streamlit may interrupt a run at each access to the session
state.
"""


class _Update(NamedTuple):
    """A value that the page may not have received."""

    value: Any
    old_values: set[Any]
    """Values that an older message may contain, although the user has not moved the widget."""
    number: int = 0


def set_widgets(values: Mapping[str, Any]) -> None:
    """Set widgets, key → value, and repeat this until the page has received the values."""
    waiting, updates = _waiting_updates(), {}
    for key, value in values.items():
        old_values = {st.session_state.get(key)}
        if key in waiting:
            old_values |= {*waiting[key].old_values, waiting[key].value}
        updates[key] = _Update(value, old_values)
    _set(updates)


def repeat_unreceived() -> None:
    """Set the values again that the page had not received when it sent its last message.

    Call it before anything reads or draws the widgets: at the start of a run, and of each callback.
    """
    waiting, seen = _waiting_updates(), st.session_state.get(_SEEN, 0)
    for key, update in list(waiting.items()):
        if update.number <= seen:
            del waiting[key]
    updates = {}
    for key, update in waiting.items():
        current = st.session_state.get(key)
        # Any other value comes from the user, who has moved the widget meanwhile.
        updates[key] = update if current in update.old_values else update._replace(value=current)
    _set(updates)


def are_waiting() -> bool:
    """Return whether the page may not have received a value."""
    return bool(_waiting_updates())


def draw() -> None:
    """Draw the hidden slider, from the first run on. Call it after all widgets that are set.

    A message from a page without this slider would not change the server's number in the session state. Every update
    would then count as received.
    """
    if are_waiting():
        st.session_state[_SEEN] = _last_number()
    st.slider(_("Updates"), 0, 2**31, key=_SEEN, on_change="ignore")


def _set(updates: Mapping[str, _Update]) -> None:
    """Set widgets under a new number."""
    number = _last_number() + 1
    _waiting_updates().update({key: update._replace(number=number) for key, update in updates.items()})
    for key, update in updates.items():
        st.session_state[key] = update.value


def _last_number() -> int:
    return max(st.session_state.get(_SEEN, 0), *(update.number for update in _waiting_updates().values()), 0)


def _waiting_updates() -> dict[str, _Update]:
    return st.session_state.setdefault(_WAITING, {})
