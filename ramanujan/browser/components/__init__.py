"""The components beside the machine, and all code that depends on the pages of Streamlit and Plotly.

    bus.js              messages between the components
    streamlit_dom.js    every selector into the pages of Streamlit and Plotly
    page.css            style rules for all pages, and for single pages except the lesson's
    lesson.css          style rules for the lesson, its worksheet and its class
    sentences.js        templates of sentences, and notation of numbers
    lasting.js          observers and timers that end with their component

Every other file belongs to one component. No physics here.

Streamlit sends a component's HTML, CSS and script with every run of the page. Therefore a component's script has only
two lines. They import its module, which the server offers as a file (`ramanujan.browser.modules`).

The topics of the bus, where NAME is the name of a stage, CLOCK of a clock, and KEY the key of a slider:

    machine/NAME      the message of `stage.publish`; removed when the visitor leaves the page
    time/NAME         {time [s], phase [rad], periods, playing}, published by the stage in every frame with a change;
                      periods of the plain mass since both hands started together
    story/NAME        while a story runs, the duration of a period of the plain mass on the screen [s]; null at its end;
                      during a story a change of the machine keeps the angle between the hands
    drawn/NAME        {ratio, normalized, parameters}: ε, Ω²m/k and the machine as drawn, also during a drag
    seek/NAME         {time [s]}: a request to pause at this time
    view/CLOCK        the view of a class's desk, for all stages on this clock: `stage.VIEW`, with `ago`, its age [s],
                      and `own`, whether this page is the desk
    enter/KEY         a text to enter into a slider's box
    goal/KEY          a value to which a slider's thumb snaps, published by the story while it does not run
    exact/KEY         {value, text, processed}: the value, text and number of processed inputs of a slider's box
    announce          {sentence, urgent}: a sentence for the page's live region
    turned            the new stop of a lesson
    step              the number of the step that a lecture shows
    slides            {has(by)}: has(by) returns whether the projector has a slide `by` slides after the present one
    sliders           a request to open the drawer with the sliders
"""

import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import streamlit as st

from ramanujan.browser import modules
from ramanujan.translation import _, menu_languages


def mount_services(theme: str, needs_second_run: bool, on_moving: Callable[[], None]) -> bool:
    """Mount the services of every page, before all other elements. Return whether the page's machine moves.

    services.js lists the services. Among them are:

    - the page's live region for the topic `announce`
    - a notice while the page has no connection to the server
    - keyboard access to boxes that scroll sideways
    - a new run of the page after a switch of the theme, because the server draws the figures
    - a ring at the current machine on a curve. The `meta` of the figure's layout contains the ring's colour, and its
      axes are the mass ratio ε and Ω²m/k.

    Parameters
    ----------
    theme : theme of this run, light or dark
    needs_second_run : whether the page requests a second run once the machine has drawn its first frame
    on_moving : called before the second run
    """
    data = {
        "theme": theme,
        "needs_second_run": needs_second_run,
        "away": _("Reconnecting to the server. The page keeps everything that you set."),
        "label": _("Wide content: scroll it with the arrow keys"),
        "ring": {"stage": "oscillator", "label": _("Your machine: ε = {ratio}, Ω²m/k = {normalized}")},
    }
    services = modules.component("components/services")
    return bool(
        services(key="unseen-services", data=data, on_switched_change=lambda: None, on_moving_change=on_moving).moving
    )


def publish(key: str, topics: Mapping[str, Any]) -> Any:
    """Publish values on the bus of the page. A change of these values does not send any other element again.

    Parameters
    ----------
    key : key of the element, unique among the published ones
    topics : topic → value; a value equal to that of the last run is not published again
    """
    return modules.component("components/publish")(key=f"unseen-published_{key}", data=dict(topics))


def story(data: Mapping[str, Any]) -> Any:
    """Put a button on the page that starts a story, which moves a slider until a stage's machine is in step.

    The page moves the slider, and sends only the last value. Once the slider has reached the ratio, in the story or by
    hand, the page marks the ratio on the slider.

    Parameters
    ----------
    data :
        stage : name of the stage
        slider : key of the slider of m′
        ratio : ε = m′/m of the machine in step
        openings : lists of scenes {sentence, ratios, periods}; the first one in the slider's range is used
        rest : the scenes that follow
        screen_period : duration of a period of the plain mass on the screen [s]
        stills : {label, turns} of each clock for a reader who prefers reduced motion
        words : `ratio`, a template for ε; `in_step`, the sentence in step; `stills`, the sentence above the clocks;
            `mark`, the word at the mark on the slider; `begin`, `again`, `stop` and `hint` of the button
    """
    return modules.component("components/story")(key="story", data=dict(data))


def cubes(sums: Sequence[Sequence[int]], alternatives: Sequence[str], captions: Sequence[str]) -> Any:
    """Put stacks of cubes, made of unit cubes, side by side on the page. The reader can turn them and pull them apart.

    Parameters
    ----------
    sums : for each stack, the sides of its cubes in unit cubes
    alternatives, captions : for each stack, its text alternative and its caption
    """
    data = {
        "sums": [list(sides) for sides in sums],
        "alternatives": list(alternatives),
        "captions": list(captions),
        "words": {"degrees": _("{angle} degrees")},
    }
    return modules.component("components/cubes")(key="cubes", data=data)


def cursor(stage: str) -> Any:
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
    return modules.component("components/cursor")(key="cursor", data={"stage": stage, "place": place})


def moment(stage: str, time: float, label: str) -> Any:
    """Put a button on the page that pauses a stage and its time cursor at one moment.

    Parameters
    ----------
    stage : name of the stage
    time : time since release [s]
    label : label of the button
    """
    return modules.component("components/moment")(key="moment", data={"stage": stage, "time": time, "label": label})


def return_focus(*keys: str) -> None:
    """Return the keyboard focus to the page after each click on one of these widgets."""
    modules.component("components/keys")(
        key="unseen-keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)}
    )


def drawer() -> Any:
    """Put a handle on the sidebar, which is a drawer at the bottom of a narrow screen."""
    return modules.component("components/drawer")(key="handle")


STANDALONE_FILE = "ramanujans-oscillator.html"
"""The name of the standalone file, also in the address of the server."""


def link(private: Sequence[str], keys: Sequence[str]) -> Any:
    """Put the menu *Share* and the choice of a language on the page.

    Parameters
    ----------
    private : keys of the address that a copied link omits
    keys : keys of the address that the standalone file accepts
    """
    data = {
        "copied": _("Copied."),
        "by_hand": _("Copy this text:"),
        "saved": _("Saved. Open the file with a double click."),
        "failed": _("The file could not be loaded. Try again when the server can be reached."),
        "title": _("Ramanujan’s oscillator"),
        "file": STANDALONE_FILE,
        "private": list(private),
        "keys": list(keys),
        "languages": [language._asdict() for language in menu_languages()],
    }
    return modules.component("components/link")(key="link", data=data)


def exact(key: str, head: Mapping[str, Any], on_typed: Callable[[str], None]) -> Any:
    """Put the heading of a slider on the page, with a box for its exact value, in which one can type any text.

    The page publishes the shown value by the topic exact/KEY.

    Parameters
    ----------
    key : key of the slider
    head : its symbol, unit and meaning; label and maximum length of the box; default of the slider
    on_typed : called with the typed text
    """
    data = {"key": key, **head}
    return mount("components/exact", f"{key}_exact", data, event="typed", on_value=on_typed, type_example="")


def pick(figure: str, on_picked: Callable[[dict[str, float]], None]) -> Any:
    """Call a function after every click on a point of a figure, including a second click on the same point.

    Parameters
    ----------
    figure : key of the figure
    on_picked : called with the point's x and y, in the units of the axes
    """
    point = {"x": 0.0, "y": 0.0}
    key = f"unseen-pick_{figure}"
    return mount("components/pick", key, {"figure": figure}, event="picked", on_value=on_picked, type_example=point)


def steps(route: str, headings: Sequence[str], on_turned: Callable[[str, int], None], has_onward_link: bool) -> Any:
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
    data["place"] = _("Step {now} of {count}: {heading}")

    def receive(position: dict[str, Any]) -> None:
        step = min(max(position["step"], 1), len(headings))
        on_turned(position["route"], step)

    position = {"route": route, "step": 1}
    return mount("components/steps", "lecture_turn", data, event="at", on_value=receive, type_example=position)


def turn(
    headings: Sequence[str],
    now: int,
    on_turned: Callable[[int], None],
    page_keys_turn: bool = True,
    place: str = _("Stop {now} of {count}: {heading}"),
    refusal: str = "",
) -> Any:
    """Draw the control that turns the stops of a lesson; the server draws one stop at a time.

    Parameters
    ----------
    headings : headings of the stops in their order, then that of the ending, for screen readers
    now : number of the present stop, counted from 1; at the ending, the number of stops plus 1
    on_turned : called with the number of the requested stop
    page_keys_turn : whether the page keys, which a clicker sends, also turn stops
    place : template of a screen reader's sentence about the present stop
    refusal : a text that changes when the server has refused a turn
    """
    settings = {"place": place, "page_keys_turn": page_keys_turn, "refusal": refusal, "has_ending": True}
    data = {"headings": list(headings), "now": now, **settings}

    def receive(number: int) -> None:
        on_turned(min(max(number, 1), len(headings)))

    return mount("components/turn", "turn", data, event="to", on_value=receive, type_example=now)


def pager(on_turned: Callable[[str], None]) -> Any:
    """Show one slide of the page at a time, for a projector, with a control that turns the slides.

    A slide is a container with the key "slide-NAME". Its title is the attribute `data-slide` of a node in it.

    Parameters
    ----------
    on_turned : called with the name of the slide, a moment after the last of several turns; with "" for the first slide
    """
    data = {"place": "{now} / {count}: {title}"}
    return mount("components/pager", "pager", data, event="at", on_value=on_turned, type_example="")


def stopwatch(key: str) -> float | None:
    """Put a stopwatch on the page. Return its last measured time [s], or None.

    Parameters
    ----------
    key : Streamlit's key of the element
    """
    data = {"start": _("Start"), "stop": _("Stop"), "seconds": _("{seconds}\u202fs")}
    element = modules.component("components/stopwatch")(key=key, data=data, on_seconds_change=lambda: None)
    return element.seconds if _has_type_of(element.seconds, 0.0) else None


def mount(
    name: str, key: str, data: Mapping[str, Any], event: str, on_value: Callable[[Any], None], type_example: Any
) -> Any:
    """Put a component on the page that sends values to the server.

    Parameters
    ----------
    name : name of the component's module
    key : Streamlit's key of the element
    data : data of the component
    event : name of the component's trigger or state
    on_value : called with each value of the example's type. Any other value is ignored.
    type_example : an example of a value, which determines the type
    """

    def receive() -> None:
        value = getattr(st.session_state.get(key), event, None)
        if _has_type_of(value, type_example):
            on_value(value)

    return modules.component(name)(key=key, data=data, **{f"on_{event}_change": receive})


def _has_type_of(value: Any, example: Any) -> bool:
    """Return whether a value has the type of an example.

    A whole number is also accepted for a float. Infinity, NaN and numbers beyond the largest float are not.

    >>> _has_type_of(1, 0.5), _has_type_of(10**400, 0.5), _has_type_of(True, 0.5)
    (True, False, False)
    """
    if isinstance(example, dict):
        return isinstance(value, dict) and all(_has_type_of(value.get(name), part) for name, part in example.items())
    if isinstance(value, bool):
        return False
    if isinstance(example, float) and isinstance(value, int | float):
        return abs(value) <= sys.float_info.max
    return isinstance(value, type(example))
