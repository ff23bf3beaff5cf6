"""How the app is shown: on a projector, and without the parts that a lecturer's link hides.

Both stand in the address of every page, as `view=projector` and `hide=numbers,curve,clocks`, so that it can be passed
on.
"""

from __future__ import annotations

import streamlit as st

from ramanujan import stage
from ramanujan.scenes import links
from ramanujan.words import _

PARTS = {
    **stage.PARTS,
    "curve": "the curve of Ω²m/k over the mass ratio",
    "steps": "the derivation in six steps",
}
"""Part that a link can hide → what it is."""
VIEW = links.Choice("view", ("projector",))
HIDE = links.Several("hide", tuple(PARTS))
KEYS = (VIEW, HIDE)
"""What every page keeps in its address beside the machine."""

_SWITCH = "projector"
_OLD = {"lecture", "reading"}


def take_old() -> None:
    """Understand an address from when the derivation page kept its own choice under `view`; call it before `opened`."""
    text = st.query_params.get("view", "").lower()
    if text in _OLD:
        st.query_params["show"] = text
        del st.query_params["view"]


def is_projector() -> bool:
    """Tell whether the app is shown on a projector: large words, one picture at a time, the sidebar folded."""
    return links.held(VIEW) == "projector"


def hides(*parts: str) -> bool:
    """Tell whether the link hides one of these parts."""
    return not set(parts).isdisjoint(links.held(HIDE))


def on_stage() -> tuple[str, ...]:
    """Return the hidden parts that belong to a stage."""
    return tuple(part for part in links.held(HIDE) if part in stage.PARTS)


def switch() -> None:
    """Draw the switch for the projector."""
    st.session_state[_SWITCH] = is_projector()
    st.toggle(
        _("Projector"),
        key=_SWITCH,
        on_change=_switched,
        help=_("Larger words and one picture at a time, for a lecture hall. The sidebar is folded away."),
    )


def _switched() -> None:
    st.session_state[VIEW.name] = "projector" if st.session_state[_SWITCH] else None
