"""The stages of the pages. A stage hides the parts that the link hides, and follows the sliders of the sidebar.

A script in the page (keeper.js) writes the view of a stage into the address: layers, speed and frame of reference. If
the stage is paused, the parameter `paused` contains two numbers for each machine on its clock: the periods since the
release of the machine and of its plain mass.
"""

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import stage
from ramanujan.shell import address, display_mode
from ramanujan.shell.parameters import PARAMETERS, WATCH
from ramanujan.translation import _

LIMITS = PARAMETERS["compression"].limits
"""Smallest and largest x₀ [m]."""


def url_parameters(prefix: str = "") -> tuple[address.URLParameter, ...]:
    """Return the URL parameters for the view of the stages with this prefix."""
    refused = _("The value of {name} in the address was ignored: it must be periods, with commas between them.")
    periods = r"-?\d{1,6}(\.\d{1,6})?"
    return (
        address.Several(f"{prefix}layers", ("none", *stage.LAYERS)),
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
    stage.mount(payload, **(defaults | more), hide=hidden)


def publish(payload: Mapping[str, Any], **more: Any) -> None:
    """Publish the machine of a stage that was mounted without data, with the parts that the link hides."""
    stage.publish(payload, hide=display_mode.hidden_stage_parts(), **more)
