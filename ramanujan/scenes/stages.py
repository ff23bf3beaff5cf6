"""The stages of the pages: each hides what the link hides, and follows the sliders of the sidebar."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ramanujan import stage
from ramanujan.scenes import view
from ramanujan.scenes.quantities import QUANTITIES, WATCH

LIMITS = QUANTITIES["compression"].limits
"""The least and the largest x₀ [m]."""


def mount(payload: Mapping[str, Any] | None, **more: Any) -> Any:
    """Put a stage on the page as `stage.mount` does, without what the link hides.

    It follows the sliders, and x₀ has their range, unless `limits` and `watch` say otherwise.
    """
    hidden = {*view.on_stage(), *more.pop("hide", ())}
    return stage.mount(payload, **{"limits": LIMITS, "watch": WATCH, **more}, hide=hidden)


def tell(payload: Mapping[str, Any], **more: Any) -> None:
    """Tell a stage that was mounted without a payload which machine it shows, as `stage.tell` does."""
    stage.tell(payload, hide=view.on_stage(), **more)
