"""A button that pauses a stage at one moment."""

from typing import Any

from ramanujan.browser import modules


def mount(stage: str, time: float, label: str) -> Any:
    """Put a button on the page that pauses a stage and its time cursor at one moment.

    Parameters
    ----------
    stage : name of the stage
    time : time since release [s]
    label : label of the button
    """
    return modules.component("components/moment/moment")(
        key="moment", data={"stage": stage, "time": time, "label": label}
    )
