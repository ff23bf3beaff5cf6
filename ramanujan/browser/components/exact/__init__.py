"""The heading of a slider with a box for its exact value."""

from collections.abc import Callable, Mapping
from typing import Any

from ramanujan.browser import mounting


def mount(key: str, head: Mapping[str, Any], on_typed: Callable[[str], None]) -> Any:
    """Put the heading of a slider on the page, with a box for its exact value, in which one can type any text.

    The page publishes the shown value by the topic exact/KEY.

    Parameters
    ----------
    key : key of the slider
    head : its symbol, unit and meaning; label and maximum length of the box; default of the slider; `shown_ratio`, the
        multiple of m up to which the slider shows its values, or None for all; `snap_ratios`, the multiples of m to
        which it snaps; `reset`, label of the preset that restores all values, and its value, or None if only the
        server knows it; `ratios`, label of a preset → m′/m for m′, or None
    on_typed : called with the typed text
    """
    data = {"key": key, **head}
    return mounting.mount(
        "components/exact/exact", f"{key}_exact", data, event="typed", on_value=on_typed, type_example=""
    )
