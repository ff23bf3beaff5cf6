"""The page's side: what runs in the browser beside the machine, and all that knows Streamlit's and Plotly's pages.

bus.js carries the news between the components, hosts.js holds every selector into the host pages, page.css every style
rule for them. The other files belong to one component each. No physics here.

Streamlit sends a component's HTML, CSS and script with every run of the page. So all of them travel together, in one
message that is large enough for the page to keep (`bring`); each component brings a few lines that ask for it.

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

import json
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import streamlit as st

from ramanujan.words import _

_HERE = Path(__file__).parent
_PARTS = {
    "cursor": ("marks.js", "cursor.js"),
    "exact": ("exact.js",),
    "feed": ("feed.js",),
    "keys": ("keys.js",),
    "link": ("link.js",),
    "moment": ("moment.js",),
    "pager": ("pager.js",),
    "pick": ("pick.js",),
    "receipt": ("receipt.js",),
    "ring": ("marks.js", "ring.js"),
    "sheet": ("touch.js", "sheet.js"),
    "steps": ("steps.js",),
    "stopwatch": ("stopwatch.js",),
    "theme": ("theme.js",),
    "turn": ("turn.js",),
    "voice": ("voice.js",),
}
"""Component → its script's files; its HTML and CSS are the files of its name, or of another's look, if there are any."""
_LOOKS = {"turn": "steps"}

_ASK = (_HERE / "ask.js").read_text(encoding="utf-8")


def script(*paths: Path | str) -> str:
    """Return one script: bus.js, hosts.js, then these files (names are of this folder), without comments."""
    return "\n".join(map(_bare, ("bus.js", "hosts.js", *paths)))


def bring() -> None:
    """Bring page.css and the scripts of all components to the page; call it before any of them is drawn."""
    _library()(key="library")


def style(name: str = "page.css") -> str:
    """Return a style sheet of this folder without comments: page.css, or projector.css, which goes on top of it."""
    whole = (_HERE / name).read_text(encoding="utf-8")
    return re.sub(r"/\*.*?\*/|\n\s*", "", whole, flags=re.DOTALL)


def feed(key: str, topics: Mapping[str, Any]) -> Any:
    """Bring values to the bus of the page; only they travel at a change.

    Parameters
    ----------
    key : of the element
    topics : topic → value; what has not changed since the last run is not published again
    """
    return _component("feed")(key=key, data=dict(topics))


def ring(stage: str) -> Any:
    """Let a ring around the present machine follow a stage on a curve; call it once, beside the figure.

    A figure takes part by its layout's `meta`: ring is the colour. Its axes are the mass ratio ε and Ω²m/k.

    Parameters
    ----------
    stage : the name of the stage
    """
    return _component("ring")(key="ring", data={"stage": stage})


def cursor(stage: str) -> Any:
    """Put the time cursor on the page: one instant, marked in every figure, moved without the server.

    A figure takes part by its layout's `meta`: cursor ("time": t runs to the right; "orbit": points at equal steps of
    time), period [s] and periods, the number of them that it shows. What is marked is the figure's own data.

    Parameters
    ----------
    stage : the name of the stage that shares the cursor's clock
    """
    return _component("cursor")(key="cursor", data={"stage": stage})


def moment(stage: str) -> Any:
    """Put a button on the page that takes a stage, and all figures over time, to one instant and holds them there.

    The topic moment/NAME says which: {time [s], label}.

    Parameters
    ----------
    stage : the name of the stage
    """
    return _component("moment")(key="moment", data={"stage": stage})


def give_back(*keys: str) -> None:
    """Let the choices under these widget keys give the keyboard back to the page when they are clicked."""
    _component("keys")(key="keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)})


def voice() -> Any:
    """Put the live region on the page, the only one: it says what the topic `say` brings."""
    return _component("voice")(key="voice")


def follow_theme(theme: str) -> Any:
    """Run the page again when the visitor switches the theme, so that figures follow.

    Parameters
    ----------
    theme : the one that this run draws with, light or dark
    """
    return _component("theme")(key="theme", data={"theme": theme}, on_switched_change=lambda: None)


def sheet() -> Any:
    """Put the handle on the sidebar, which is a sheet at the bottom of a narrow screen; fingers may scroll over it."""
    return _component("sheet")(key="sheet")


def link() -> Any:
    """Put a button on the page that copies its address, in which everything stands that is set."""
    return _component("link")(key="link")


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

    return _component("exact")(key=key, data=dict(data), on_typed_change=typed)


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

    return _component("pick")(key=key, data={"figure": figure}, on_picked_change=picked)


def receipt(key: str, number: int) -> Any:
    """Let the page tell the highest number that has reached it: it stands in the state of this key as `received`.

    Parameters
    ----------
    key : of the element
    number : what the page is to receive
    """
    return _component("receipt")(key=key, data={"number": number}, on_received_change=lambda: None)


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
    return _component("steps")(key="steps", data=data, on_at_change=turned)


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
    return _component("turn")(key="turn", data=data, on_to_change=turned)


def pager() -> Any:
    """Show one picture of the page at a time, as a projector needs it, and put on the page what turns to the next."""
    words = {"label": _("Pictures of this page"), "back": _("Back"), "next": _("Next"), "place": "{now} / {count}"}
    return _component("pager")(key="pager", data=words)


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
    watch = _component("stopwatch")
    return watch(key=key, data=data, on_seconds_change=lambda: None).seconds


def _component(name: str) -> Any:
    """Return a component of this folder, which asks the page's library for its part."""
    return _asking(name)


@cache
def _asking(name: str) -> Any:
    return st.components.v2.component(f"ramanujan_{name}", js=_ASK.replace("NAME", json.dumps(name)))


@cache
def _library() -> Any:
    parts = "\n".join(_part(name, files) for name, files in _PARTS.items())
    given = f"const STYLE = {json.dumps(style())};\nconst parts = {{}};"
    return st.components.v2.component("ramanujan_library", js=f"{script()}\n{given}\n{parts}\n{_bare('library.js')}")


def _part(name: str, files: tuple[str, ...]) -> str:
    """Return the text of `parts.NAME`: the component's look, and the function that its script exports."""
    look = "".join(
        text if kind == "html" else f"<style>{text}</style>"
        for kind in ("css", "html")
        if (text := _text(_HERE / f"{_LOOKS.get(name, name)}.{kind}"))
    )
    body = "\n".join(map(_bare, files)).replace("export default", "const begin =")
    return f"parts.{name} = {{ look: {json.dumps(look)}, begin: (() => {{\n{body}\nreturn begin;\n}})() }};"


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.exists() else ""


def _bare(path: Path | str) -> str:
    """Return a script without its comments, which stay here."""
    text = re.sub(r"^\s*/\*\*.*?\*/$", "", (_HERE / path).read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    lines = (line.strip() for line in text.splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//"))
