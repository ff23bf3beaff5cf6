"""The page's side: the components beside the machine, and everything that depends on Streamlit's and Plotly's pages.

bus.js carries messages between the components, streamlit_dom.js holds every selector into the host pages, page.css
every style rule for them. sentences.js fills the templates that Python sends and writes numbers, lasting.js ends with a
component what it observes and waits for. The other files belong to one component each. No physics here.

Streamlit sends a component's HTML, CSS and script with every run of the page. So a component brings only two lines that
import its module, which the server offers as a file (`ramanujan.browser.modules`).

The topics of the bus, where NAME is the name of a stage:

    machine/NAME      what `stage.payload` returns; published by the stage’s messages, forgotten when the page is left
    time/NAME         {time [s], phase [rad], periods, playing}: published by the stage in every frame in which it
                      changed; periods of the plain mass since both hands started together
    story/NAME        how many seconds a period of the plain mass lasts while a story is told, during which the hands
                      keep the angle between them; null ends it
    drawn/NAME        {ratio, normalized, parameters}: ε, Ω²m/k and the machine that is drawn, also while a thumb moves
    seek/NAME         {time [s]}: somebody asks the stage to go to that time and to stay there
    seen/CLOCK        what is seen at the desk of a class, which the stages on this clock show, too: `stage.SEEN`, and
                      ago, how long ago that was [s]
    enter/KEY         a text that somebody else wants to be typed into the box of a slider
    goal/KEY          a value that a slider’s thumb snaps to, published by the story while it is not told
    exact/KEY         {value, text, judged}: what the box of a slider shows; published by the sidebar
    say               {sentence, urgent}: news for the page's live region
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import streamlit as st

from ramanujan.browser import modules
from ramanujan.translation import _, offered


def mount_services(theme: str, waits: bool, on_moving: Callable[[], None]) -> bool:
    """Mount the services that every page needs, before all else; return whether the page’s machine moves.

    These are the page’s one live region, which says what the topic `say` brings; a notice while the server is
    away; the keyboard's access to boxes that scroll sideways; a new run of the page when the visitor switches the
    theme, so that figures follow; and a ring that follows the first page's machine on a curve. A figure has the
    ring if its layout's `meta` names the ring's colour; its axes are the mass ratio ε and Ω²m/k.

    Parameters
    ----------
    theme : the one that this run draws with, light or dark
    waits : whether the page requests a second run once the machine of the first page has drawn its first frame
    on_moving : called before the second run
    """
    data = {
        "theme": theme,
        "waits": waits,
        "away": _("Reconnecting to the server. The page keeps everything that you set."),
        "label": _("Wide content: scroll it with the arrow keys"),
        "ring": {"stage": "oscillator", "label": _("Your machine: ε = {ratio}, Ω²m/k = {normalized}")},
    }
    services = modules.component("components/services")
    return bool(services(key="services", data=data, on_switched_change=lambda: None, on_moving_change=on_moving).moving)


def publish(key: str, topics: Mapping[str, Any]) -> Any:
    """Publish values on the bus of the page; after a change only these values are sent.

    Parameters
    ----------
    key : of the element
    topics : topic → value; a value that has not changed since the last run is not published again
    """
    return modules.component("components/publish")(key=key, data=dict(topics))


def story(stage: str, slider: str, ratio: float, script: Mapping[str, Any], words: Mapping[str, str]) -> Any:
    """Put a button on the page that tells a story: it moves a slider until a stage's machine is in step.

    The page itself moves the slider, as a hand does, and sends the last value alone. Once the ratio has been found, by
    the story or by hand, the page marks it on the slider.

    Parameters
    ----------
    stage : the name of the stage
    slider : key of the slider of m′
    ratio : ε = m′/m of the machine in step
    script : openings, each a list of scenes {sentence, ratios, periods}, the first of which that the slider can show is
        taken; rest, the scenes that follow; pace, the seconds that a period of the plain mass lasts; stills, {label,
        turns} of each clock for someone who asked for less motion; marked, whether the slider marks the ratio from the
        start
    words : ratio, a template for ε; there, what is said in step; mark, begin, again, stop, hint
    """
    return modules.component("components/story")(key="story", data=story_data(stage, slider, ratio, script, words))


def story_data(
    stage: str, slider: str, ratio: float, script: Mapping[str, Any], words: Mapping[str, str]
) -> dict[str, Any]:
    """Return the data of the component `story`, with the same parameters."""
    return {"stage": stage, "slider": slider, "ratio": ratio, "said": words, **script}


def cubes(sums: Sequence[Sequence[int]], sees: Sequence[str], captions: Sequence[str]) -> Any:
    """Put stacks of cubes of unit cubes on the page, side by side, which a hand turns and pulls apart.

    Parameters
    ----------
    sums : of each stack the sides of its cubes, in unit cubes
    sees, captions : of each stack its text alternative, and what stands below it
    """
    said = {"sees": list(sees), "captions": list(captions), "words": {"degrees": _("{angle} degrees")}}
    return modules.component("components/cubes")(key="cubes", data={"sums": [list(sides) for sides in sums], **said})


def cursor(stage: str) -> Any:
    """Put the time cursor on the page: one moment, marked in every figure, moved without the server.

    A figure takes part by its layout's `meta`: cursor ("time": t runs to the right; "orbit": points at equal steps of
    time), period [s] and periods, the number of them that it shows. The marks are computed from the figure's own data.

    Parameters
    ----------
    stage : the name of the stage that shares the cursor's clock
    """
    place = _("t = {time}, {periods} periods")
    return modules.component("components/cursor")(key="cursor", data={"stage": stage, "place": place})


def moment(stage: str, time: float, label: str) -> Any:
    """Put a button on the page that moves a stage and all figures against time to one moment and stops them there.

    Parameters
    ----------
    stage : the name of the stage
    time : the moment, since release [s]
    label : of the button
    """
    return modules.component("components/moment")(key="moment", data={"stage": stage, "time": time, "label": label})


def give_back(*keys: str) -> None:
    """After a click on one of these widgets, return the keyboard focus to the page."""
    modules.component("components/keys")(key="keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)})


def drawer() -> Any:
    """Put a handle on the sidebar, which is a drawer at the bottom of a narrow screen; fingers can scroll it."""
    return modules.component("components/drawer")(key="handle")


STANDALONE_FILE = "ramanujans-oscillator.html"
"""The name of the standalone file, also in the address of the server."""


def link(private: Sequence[str], keys: Sequence[str]) -> Any:
    """Put the menu *Share* on the page, and the choice of a language.

    Parameters
    ----------
    private : keys of the address that are left out of a copied link
    keys : keys of the address that the standalone file knows
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
        "languages": [each._asdict() for each in offered()],
    }
    return modules.component("components/link")(key="link", data=data)


def exact(key: str, head: Mapping[str, Any], on_typed: Callable[[str], None]) -> Any:
    """Put the heading of a slider on the page, with a box that shows its full value and accepts any text.

    What changes comes by the topic exact/KEY: value, its full text, and judged, the number of texts that have been
    answered so far.

    Parameters
    ----------
    key : of the slider
    head : its symbol, unit and meaning; label and longest text of the box; default of the slider
    on_typed : called with what was typed
    """
    return asks("components/exact", f"{key}_exact", {"key": key, **head}, "typed", on_typed, "")


def pick(figure: str, on_picked: Callable[[dict[str, float]], None]) -> Any:
    """Call a function at every click on a point of a figure, also at a second click on the same point.

    Parameters
    ----------
    figure : key of the figure
    on_picked : called with the point's x and y, in the units of the axes
    """
    return asks("components/pick", f"{figure}_pick", {"figure": figure}, "picked", on_picked, {"x": 0.0, "y": 0.0})


def steps(route: str, headings: Sequence[str], on_turned: Callable[[str, int], None], onward: bool) -> Any:
    """Show one step of a lecture at a time: the containers with the keys `step_1`, `step_2`, … inside `lecture`.

    The lecture begins at the step that the address names, every further route at its first step.

    Parameters
    ----------
    route : name of the route
    headings : of the steps in their order, for screen readers
    on_turned : called with the route and the step, some time after the last change
    onward : whether the last step leads on to a link, in the container with this key
    """
    data = {"route": route, "headings": list(headings), "onward": onward}
    data["place"] = _("Step {now} of {count}: {heading}")

    def act(at: dict[str, Any]) -> None:
        on_turned(at["route"], min(max(at["step"], 1), len(headings)))

    return asks("components/steps", "lecture_turn", data, "at", act, {"route": route, "step": 1})


def turn(
    headings: Sequence[str],
    now: int,
    on_turned: Callable[[int], None],
    clicker: bool = True,
    place: str = _("Stop {now} of {count}: {heading}"),
    held: str = "",
) -> Any:
    """Draw the control that turns the stops of a lesson; the server draws one stop at a time.

    Parameters
    ----------
    headings : of the stops in their order and of the ending, which has no number; for screen readers
    now : number of the stop that is drawn, from 1 on; one more at the ending
    on_turned : called with the number of the requested stop
    clicker : whether the page keys turn stops, too
    place : template of a screen reader's sentence on the present stop
    held : changes when the server has refused a turn
    """
    settings = {"place": place, "clicker": clicker, "held": held, "ending": True}
    data = {"headings": list(headings), "now": now, **settings}
    return asks("components/turn", "turn", data, "to", lambda to: on_turned(min(max(to, 1), len(headings))), now)


def pager(on_turned: Callable[[str], None]) -> Any:
    """Show one slide of the page at a time, as a projector needs it, and put on the page what turns to the next.

    A slide is a container with the key "slide-NAME"; its first node with `data-slide` says there what it shows.

    Parameters
    ----------
    on_turned : called with the name of the slide some time after the last turn, with "" for the first one
    """
    return asks("components/pager", "pager", {"place": "{now} / {count}: {title}"}, "at", on_turned, "")


def stopwatch(key: str) -> float | None:
    """Put a stopwatch on the page and return the time that it showed when it was last stopped [s].

    Parameters
    ----------
    key : of the element
    """
    data = {"start": _("Start"), "stop": _("Stop"), "seconds": _("{seconds}\u202fs")}
    taken = modules.component("components/stopwatch")(key=key, data=data, on_seconds_change=lambda: None).seconds
    return taken if _is_like(taken, 0.0) else None


def asks(name: str, key: str, data: Mapping[str, Any], event: str, act: Callable[[Any], None], example: Any) -> Any:
    """Put a component on the page; a function is called with each value like the example that it sends by this event.

    What else comes, no page has sent.
    """

    def sent() -> None:
        if _is_like(value := getattr(st.session_state.get(key), event, None), example):
            act(value)

    return modules.component(name)(key=key, data=data, **{f"on_{event}_change": sent})


def _is_like(value: Any, example: Any) -> bool:
    """Tell whether a value has the type of an example; a number is finite, and a whole one may stand for any."""
    if isinstance(example, dict):
        return isinstance(value, dict) and all(_is_like(value.get(name), each) for name, each in example.items())
    if isinstance(example, float):
        return isinstance(value, int | float) and math.isfinite(value)
    return isinstance(value, type(example)) and not isinstance(value, bool)
