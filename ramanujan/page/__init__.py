"""The page's side: what runs in the browser beside the machine, and all that knows Streamlit's and Plotly's pages.

bus.js carries the news between the components, hosts.js holds every selector into the host pages, page.css every style
rule for them. The other files belong to one component each. Components v2 takes one script for each component: `script`
puts the files together, without a build step, and every script begins with bus.js and hosts.js. No physics here.

The topics of the bus, where NAME is the name of a stage:

    machine/NAME      what `stage.payload` returns; published by the stage's feed, forgotten when the page is left
    time/NAME         {time [s], phase [rad], playing}: published by the stage in every frame in which it changed
    present/NAME      {ratio, normalized, parameters}: ε, Ω²m/k and the machine that is drawn, also while a thumb moves
                      (normalized is left out while the stage hides its numbers)
    seek/NAME         {time [s], by}: somebody asks the stage to go to that time and to stay there
    compression/NAME  {value [m], held}: the slab's x₀ while it is held or moved by keys, before the server knows it
    exact/KEY         {value, text, judged}: what the box of a slider shows; published by the sidebar's feed
    moment/NAME       {time [s], label}: the instant to which a button takes the stage, and what the button says
    say               {sentence, urgent}: news for the page's live region
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import streamlit as st

from ramanujan.words import _

_HERE = Path(__file__).parent
_BASE = ("bus.js", "hosts.js")


def script(*paths: Path | str, base: tuple[str, ...] = _BASE) -> str:
    """Return one script: its base, then the given files (names are of this folder) in this order, without comments.

    Comments stay here, since a script travels with every message of its component.

    Parameters
    ----------
    paths : the component's own files
    base : what the component needs of bus.js and hosts.js
    """
    whole = "\n".join((_HERE / path).read_text(encoding="utf-8") for path in (*base, *paths))
    bare = re.sub(r"^\s*/\*\*.*?\*/$", "", whole, flags=re.DOTALL | re.MULTILINE)
    lines = (line.strip() for line in bare.splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//"))


def style() -> str:
    """Return page.css without comments."""
    whole = (_HERE / "page.css").read_text(encoding="utf-8")
    return re.sub(r"/\*.*?\*/|\n\s*", "", whole, flags=re.DOTALL)


def feed(key: str, topics: Mapping[str, Any]) -> Any:
    """Bring values to the bus of the page; only they travel at a change.

    Parameters
    ----------
    key : of the element
    topics : topic → value; what has not changed since the last run is not published again
    """
    return _component("feed", "feed.js", base=("bus.js",))(key=key, data=dict(topics))


def ring(stage: str) -> Any:
    """Let a ring around the present machine follow a stage on a curve; call it once, beside the figure.

    A figure takes part by its layout's `meta`: ring is the colour. Its axes are the mass ratio ε and Ω²m/k.

    Parameters
    ----------
    stage : the name of the stage
    """
    return _component("ring", "marks.js", "ring.js")(key="ring", data={"stage": stage})


def cursor(stage: str) -> Any:
    """Put the time cursor on the page: one instant, marked in every figure, moved without the server.

    A figure takes part by its layout's `meta`: cursor ("time": t runs to the right; "orbit": points at equal steps of
    time), period [s] and periods, the number of them that it shows. What is marked is the figure's own data.

    Parameters
    ----------
    stage : the name of the stage that shares the cursor's clock
    """
    return _component("cursor", "marks.js", "cursor.js")(key="cursor", data={"stage": stage})


def moment(stage: str) -> Any:
    """Put a button on the page that takes a stage, and all figures over time, to one instant and holds them there.

    The topic moment/NAME says which: {time [s], label}.

    Parameters
    ----------
    stage : the name of the stage
    """
    return _component("moment", "moment.js")(key="moment", data={"stage": stage})


def give_back(*keys: str) -> None:
    """Let the choices under these widget keys give the keyboard back to the page when they are clicked."""
    _component("keys", "keys.js")(key="keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)})


def voice() -> Any:
    """Put the live region on the page, the only one: it says what the topic `say` brings."""
    return _component("voice", "voice.js")(key="voice")


def follow_theme(theme: str) -> Any:
    """Run the page again when the visitor switches the theme, so that figures follow.

    Parameters
    ----------
    theme : the one that this run draws with, light or dark
    """
    return _component("theme", "theme.js")(key="theme", data={"theme": theme}, on_switched_change=lambda: None)


def sheet() -> Any:
    """Put the handle on the sidebar, which is a sheet at the bottom of a narrow screen; fingers may scroll over it."""
    return _component("sheet", "touch.js", "sheet.js")(key="sheet")


def link(private: Sequence[str] = ()) -> Any:
    """Put a button on the page that copies its address, in which everything stands that is set.

    Parameters
    ----------
    private : keys of the address that are left out of the copy
    """
    return _component("link", "link.js")(key="link", data={"private": list(private)})


def exact(key: str, data: Mapping[str, Any], on_typed: Callable[[str], None]) -> Any:
    """Put the head of a slider on the page, with a box that shows its value in full and takes any text.

    Parameters
    ----------
    key : of the element
    data : key of the slider; symbol, unit and meaning; label of the box; scale to SI units; longest text; stages whose
        slab moves the value. What changes comes by the topic exact/KEY: value, its full text, and judged, the number of
        texts that have been answered so far
    on_typed : called with what was typed
    """

    def typed() -> None:
        if (text := st.session_state[key].typed) is not None:
            on_typed(text)

    return _component("exact", "exact.js")(key=key, data=dict(data), on_typed_change=typed)


def pick(figure: str, on_picked: Callable[[dict[str, float]], None]) -> Any:
    """Hear of every click on a point of a figure, also of a second one on the same point.

    Parameters
    ----------
    figure : key of the figure
    on_picked : called with the point's x and y, in the units of the axes
    """
    key = f"{figure}_pick"

    def picked() -> None:
        if (point := st.session_state[key].picked) is not None:
            on_picked(point)

    return _component("pick", "pick.js")(key=key, data={"figure": figure}, on_picked_change=picked)


def receipt(key: str, number: int) -> Any:
    """Let the page tell the highest number that has reached it: it stands in the state of this key as `received`.

    Parameters
    ----------
    key : of the element
    number : what the page is to receive
    """
    return _component("receipt", "receipt.js", base=())(
        key=key, data={"number": number}, on_received_change=lambda: None
    )


def steps(route: str, headings: Sequence[str], on_turned: Callable[[str, int], None]) -> Any:
    """Turn the steps of a lecture on the page: the containers with the keys `step_1`, `step_2`, … inside `lecture`.

    The lecture begins at the step that the address names, any further route at its first.

    Parameters
    ----------
    route : name of what is lectured
    headings : of the steps in their order, for screen readers
    on_turned : called with the route and the step, some time after the last turn
    """

    def turned() -> None:
        at = st.session_state["steps"].at
        on_turned(at["route"], at["step"])

    data = {"route": route, "headings": list(headings), "place": "Step {now} of {count}:"}
    return _component("steps", "steps.js")(key="steps", data=data, on_at_change=turned)


def turn(headings: Sequence[str], now: int, on_turned: Callable[[int], None]) -> Any:
    """Put on the page what turns the stops of a lesson; the server draws one of them at a time.

    Parameters
    ----------
    headings : of the stops in their order, for screen readers
    now : the number of the stop that is drawn, from 1 on
    on_turned : called with the number of the stop that is asked for
    """

    def turned() -> None:
        if (to := st.session_state["turn"].to) is not None:
            on_turned(to)

    words = {
        "label": _("Stops of the lesson"),
        "place": _("Stop {now} of {count}:"),
        "back": _("Back"),
        "next": _("Next"),
    }
    data = {"headings": list(headings), "now": now, **words}
    return _component("turn", "turn.js", look="steps")(key="turn", data=data, on_to_change=turned)


def stopwatch(key: str) -> float | None:
    """Put a stopwatch on the page and return the time that it showed when it was last stopped [s].

    Parameters
    ----------
    key : of the element
    """
    data = {
        "label": _("Stopwatch"),
        "start": _("Start"),
        "stop": _("Stop"),
        "seconds": _("{seconds}\u202fs"),
    }
    watch = _component("stopwatch", "stopwatch.js")
    return watch(key=key, data=data, on_seconds_change=lambda: None).seconds


@cache
def _component(name: str, *scripts: str, base: tuple[str, ...] = _BASE, look: str | None = None) -> Any:
    """Return a component of this folder; its HTML and CSS are the files of its name, or of another's look."""
    files = {
        kind: (_HERE / f"{look or name}.{kind}").read_text(encoding="utf-8")
        for kind in ("html", "css")
        if (_HERE / f"{look or name}.{kind}").exists()
    }
    return st.components.v2.component(f"ramanujan_{name}", js=script(*scripts, base=base), **files)
