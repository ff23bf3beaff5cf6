"""The time cursor, which marks one moment in every figure."""

from typing import Any

from ramanujan.browser import modules
from ramanujan.text.translation import _


def mount(stage: str) -> Any:
    """Put the time cursor on the page: it marks one moment in every figure, and moves without the server.

    The cursor marks a figure if the `meta` of the figure's layout contains:

    cursor : "time" if the horizontal axis is t, or "orbit" if the points of a curve are at equal steps of time
    period : the period [s]
    periods : the number of periods in the figure

    Parameters
    ----------
    stage : name of the stage with the same clock
    """
    place = _("t = {time}, {periods} periods")
    return modules.component("components/cursor/cursor")(key="cursor", data={"stage": stage, "place": place})
