"""The stages of the pages. A stage hides the parts that the link hides, and follows the sliders of the sidebar.

A script in the page (keeper.js) writes the view of a stage into the address: layers, speed and frame of reference. If
the stage is paused, the parameter `paused` contains two numbers for each machine on its clock: the turns of the hands
of the machine and of its plain mass since both started together.
"""

from collections.abc import Mapping
from typing import Any

import streamlit as st

from ramanujan.browser import stage
from ramanujan.shell import address, display_mode
from ramanujan.shell.parameters import PARAMETERS, WATCH
from ramanujan.text.translation import _

LIMITS = PARAMETERS["compression"].limits
"""Smallest and largest x₀ [m]."""
_RELEASES = "releases"
"""Session state: how often a preset or a stop of the lesson has released the machine."""


def url_parameters(prefix: str = "") -> tuple[address.URLParameter, ...]:
    """Return the URL parameters for the view of the stages with this prefix."""
    refused = _("The value of {name} in the address was ignored: it must be periods, with commas between them.")
    periods = r"-?\d{1,6}(\.\d{1,6})?"
    return (
        address.Several(f"{prefix}layers", ("none", *stage.LAYERS), gone=stage.GONE_LAYERS),
        address.Choice(f"{prefix}speed", ("1", "0.5", "0.1"), "1"),
        address.Choice(f"{prefix}from", ("ground", "block"), "ground"),
        address.Text(f"{prefix}paused", rf"{periods}(,{periods}){{1,39}}", refused),
    )


URL_PARAMETERS = url_parameters()
"""URL parameters of every page."""


def mount(payload: Mapping[str, Any] | None, **more: Any) -> None:
    """Draw a stage without the parts that the link hides.

    Parameters
    ----------
    payload : machine and motion, or None if `publish` sends them
    more : arguments of `stage.mount`. By default the stage follows the sliders (`watch`) and has the range of x₀ of its
        slider (`limits`).
    """
    defaults = {"limits": LIMITS, "watch": WATCH}
    hidden = {*display_mode.hidden_stage_parts(), *more.pop("hide", ())}
    stage.mount(payload and _with_releases(payload), **(defaults | more), hide=hidden)


def publish(payload: Mapping[str, Any], **more: Any) -> None:
    """Publish the machine of a stage that was mounted without data, with the parts that the link hides."""
    stage.publish(_with_releases(payload), hide=display_mode.hidden_stage_parts(), **more)


def release() -> None:
    """Set the hands of all stages to the start, together with the next machine. Any other change moves no hand."""
    st.session_state[_RELEASES] = st.session_state.get(_RELEASES, 0) + 1


def _with_releases(payload: Mapping[str, Any]) -> dict[str, Any]:
    return {**payload, "releases": st.session_state.get(_RELEASES, 0)}
