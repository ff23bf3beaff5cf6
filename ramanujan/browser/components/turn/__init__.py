"""The control that turns the steps of a lecture or the stops of a lesson."""

from collections.abc import Callable, Sequence
from typing import Any

from ramanujan.browser import mounting
from ramanujan.text.translation import _, pgettext


def mount_lecture(
    route: str, headings: Sequence[str], on_turned: Callable[[str, int], None], has_onward_link: bool
) -> Any:
    """Show one step of a lecture at a time: the containers with the keys `step-1`, `step-2`, … inside `lecture`.

    The lecture begins at the step in the address. After a change of route it begins at the first step.

    Parameters
    ----------
    route : name of the route
    headings : headings of the steps in their order, for screen readers
    on_turned : called with the route and the step, a moment after the last of several turns
    has_onward_link : whether a link follows the last step, in the container with the key `onward`
    """
    data = {"route": route, "headings": list(headings), "has_onward_link": has_onward_link}
    data |= {"label": _("Steps"), "slide": _("Step"), "place": _("Step {now} of {count}: {heading}")}

    def receive(position: dict[str, Any]) -> None:
        step = min(max(position["step"], 1), len(headings))
        on_turned(position["route"], step)

    position = {"route": route, "step": 1}
    return mounting.mount(
        "components/turn/turn", "lecture_turn", data, event="at", on_value=receive, type_example=position
    )


def mount_lesson(
    headings: Sequence[str],
    now: int,
    on_turned: Callable[[int], None],
    page_keys_turn: bool = True,
    place: str = _("Stop {now} of {count}: {heading}"),
) -> Any:
    """Draw the control that turns the stops of a lesson; the server draws one stop at a time.

    Parameters
    ----------
    headings : headings of the stops in their order, then that of the ending, for screen readers
    now : number of the present stop, counted from 1; at the ending, the number of stops plus 1
    on_turned : called with the number of the requested stop
    page_keys_turn : whether the page keys, which a clicker sends, also turn stops
    place : template of a screen reader's sentence about the present stop
    """
    data = {"headings": list(headings), "now": now, "page_keys_turn": page_keys_turn}
    data |= {"label": _("Stops of the lesson"), "slide": pgettext("of the lesson", "Stop"), "place": place}

    def receive(number: int) -> None:
        on_turned(min(max(number, 1), len(headings)))

    return mounting.mount("components/turn/turn", "turn", data, event="to", on_value=receive, type_example=now)
