"""How the app is shown: on a projector, and without the parts that a lecturer's link hides.

Both are read from the address when a session begins, `view=projector` and `hide=numbers,curve,clocks`, and stay in it
on every page, so that the address can be passed on.
"""

from __future__ import annotations

import streamlit as st
from streamlit.errors import StreamlitAPIException

from ramanujan import stage
from ramanujan.words import _

PROJECTOR = "projector"
PARTS = {
    **stage.PARTS,
    "curve": "the curve of Ω²m/k over the mass ratio",
    "steps": "the derivation in six steps",
}
"""Part that a link can hide → what it is."""

_SWITCH = "projector"
_HIDDEN = "view_hidden"
_COMPLAINTS = "view_complaints"


def begin() -> None:
    """Read the address once a session, and keep in it what was read. Called first in every run."""
    if _HIDDEN not in st.session_state:
        _read()
    _write("view", PROJECTOR if is_projector() else "")
    _write("hide", ",".join(hidden()))


def complaints() -> list[str]:
    """Return a sentence, once a session, for each of the two that the link gets wrong."""
    return st.session_state.pop(_COMPLAINTS, [])


def is_projector() -> bool:
    """Tell whether the app is shown on a projector: large words, one picture at a time, the sidebar folded."""
    return bool(st.session_state.get(_SWITCH))


def hidden() -> tuple[str, ...]:
    """Return the parts that the link hides, in the order of `PARTS`."""
    return st.session_state.get(_HIDDEN, ())


def hides(part: str) -> bool:
    """Tell whether the link hides a part."""
    return part in hidden()


def on_stage() -> tuple[str, ...]:
    """Return the hidden parts that belong to a stage."""
    return tuple(part for part in hidden() if part in stage.PARTS)


def switch() -> None:
    """Draw the switch for the projector."""
    st.toggle(
        _("Projector"),
        key=_SWITCH,
        help=_("Larger words and one picture at a time, for a lecture hall. The sidebar is folded away."),
    )


def way(path: str, label: str, icon: str) -> None:
    """Draw a link to a page of the app, or nothing where the app has no such page."""
    try:
        st.page_link(path, label=label, icon=icon)
    except StreamlitAPIException:
        return


def _read() -> None:
    """Take the view and the hidden parts from the address, and note what cannot be meant."""
    views, parts = (_texts(key) for key in ("view", "hide"))
    said = []
    # The derivation once kept its own choice under this key.
    old = next((text for text in views if text.capitalize() in ("Lecture", "Reading")), None)
    if old:
        st.session_state["show"] = old.capitalize()
    elif set(views) - {PROJECTOR}:
        said.append(_("The link names a view that this app does not have. It was ignored."))
    if set(parts) - set(PARTS):
        sentence = _("The link hides a part that this app does not have. The parts that can be hidden are {parts}.")
        said.append(sentence.format(parts=", ".join(PARTS)))
    st.session_state[_SWITCH] = PROJECTOR in views
    st.session_state[_HIDDEN] = tuple(part for part in PARTS if part in parts)
    st.session_state[_COMPLAINTS] = said


def _texts(key: str) -> list[str]:
    """Return the short texts between the commas of a key of the address."""
    given = ",".join(st.query_params.get_all(key))
    return [text.strip() for text in given.split(",") if text.strip()]


def _write(key: str, text: str) -> None:
    """Keep a key of the address as it is meant; an address that says so already is not touched."""
    if not text:
        st.query_params.pop(key, None)
    elif st.query_params.get_all(key) != [text]:
        st.query_params[key] = text
