"""Clicks on the points of a figure."""

from collections.abc import Callable
from typing import Any

from ramanujan.browser import mounting


def mount(figure: str, on_picked: Callable[[dict[str, float]], None]) -> Any:
    """Call a function after every click on a point of a figure, including a second click on the same point.

    Parameters
    ----------
    figure : key of the figure
    on_picked : called with the point's x and y, in the units of the axes
    """
    point = {"x": 0.0, "y": 0.0}
    key = f"unseen-pick_{figure}"
    return mounting.mount(
        "components/pick/pick", key, {"figure": figure}, event="picked", on_value=on_picked, type_example=point
    )
