"""How the app is shown: on a projector, and without the parts that a lecturer's link hides.

Both stand in the address of every page, as `view=projector` and `hide=numbers,curve,clocks`, so that it can be passed
on.
"""

from __future__ import annotations

import streamlit as st

from ramanujan.browser import stage
from ramanujan.shell import address
from ramanujan.translation import _

PARTS = {
    **stage.PARTS,
    "curve": "the curve of Ω²m/k over the mass ratio",
    "steps": "the derivation in six steps",
}
"""Part that a link can hide → what it is."""
VIEW = address.Choice("view", ("projector",))
HIDE = address.Several("hide", tuple(PARTS))
KEYS = (VIEW, HIDE)
"""What every page keeps in its address beside the machine."""

_SWITCH = "projector"


def is_projector() -> bool:
    """Tell whether the app is shown on a projector: large words, one picture at a time, the sidebar folded."""
    return address.held(VIEW) == "projector"


def hides(*parts: str) -> bool:
    """Tell whether the link hides one of these parts."""
    return not set(parts).isdisjoint(address.held(HIDE))


def on_stage() -> tuple[str, ...]:
    """Return the hidden parts that belong to a stage."""
    return tuple(part for part in address.held(HIDE) if part in stage.PARTS)


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
