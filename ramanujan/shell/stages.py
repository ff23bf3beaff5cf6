"""The stages of the pages: each hides what the link hides, and follows the sliders of the sidebar."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import stage
from ramanujan.shell import display_mode
from ramanujan.shell.parameters import PARAMETERS, WATCH

LIMITS = PARAMETERS["compression"].limits
"""The least and the largest x₀ [m]."""


def mount(payload: Mapping[str, Any] | None, **more: Any) -> None:
    """Put a stage on the page as `stage.mount` does, without what the link hides.

    It follows the sliders, and x₀ has their range, unless `limits` and `watch` say otherwise.
    """
    hidden = {*display_mode.on_stage(), *more.pop("hide", ())}
    stage.mount(payload, **{"limits": LIMITS, "watch": WATCH, **more}, hide=hidden)


def tell(payload: Mapping[str, Any], **more: Any) -> None:
    """Tell a stage that was mounted without a payload which machine it shows, as `stage.tell` does."""
    stage.tell(payload, hide=display_mode.on_stage(), **more)
