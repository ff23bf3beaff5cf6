"""The stages of the pages: each hides the parts that the link names, and follows the sliders of the sidebar.

The page itself writes into the address what is seen of a stage (keeper.js): its layers, its speed, from where it is
seen, and where it is paused, as the periods since release of machine and plain mass, for every machine on one clock.
"""

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import stage
from ramanujan.shell import address, display_mode
from ramanujan.shell.parameters import PARAMETERS, WATCH
from ramanujan.translation import _

LIMITS = PARAMETERS["compression"].limits
"""The least and the largest x₀ [m]."""


def url_parameters(kept: str = "") -> tuple[address.URLParameter, ...]:
    """Return the URL parameters that keep the view of the stages with this prefix."""
    refused = _("The value of {name} in the address was ignored: it must be periods, with commas between them.")
    turns = r"-?\d{1,6}(\.\d{1,6})?"
    return (
        address.Several(f"{kept}layers", ("none", *stage.LAYERS)),
        address.Choice(f"{kept}speed", ("1", "0.5", "0.1"), "1"),
        address.Choice(f"{kept}from", ("ground", "block"), "ground"),
        address.Text(f"{kept}paused", rf"{turns}(,{turns}){{1,39}}", refused),
    )


URL_PARAMETERS = url_parameters()
"""Every page keeps these in its address."""


def mount(payload: Mapping[str, Any] | None, **more: Any) -> None:
    """Put a stage on the page as `stage.mount` does, without what the link hides.

    It follows the sliders, and x₀ has their range, unless `limits` and `watch` say otherwise.
    """
    hidden = {*display_mode.on_stage(), *more.pop("hide", ())}
    stage.mount(payload, **{"limits": LIMITS, "watch": WATCH, **more}, hide=hidden)


def tell(payload: Mapping[str, Any], **more: Any) -> None:
    """Tell a stage that was mounted without a payload which machine it shows, as `stage.tell` does."""
    stage.tell(payload, hide=display_mode.on_stage(), **more)
