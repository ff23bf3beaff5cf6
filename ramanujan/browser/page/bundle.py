"""The files of this folder put together: one script for all components, one style sheet, without their comments."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from functools import cache
from html import escape
from pathlib import Path

from ramanujan.translation import _

__all__ = ["ask", "library", "script", "style"]

_HERE = Path(__file__).parent
_PARTS = {
    "connection": ("connection.js",),
    "cursor": ("marks.js", "cursor.js"),
    "exact": ("exact.js",),
    "feed": ("feed.js",),
    "keys": ("keys.js",),
    "link": ("link.js",),
    "moment": ("moment.js",),
    "pager": ("turning.js", "pager.js"),
    "pick": ("pick.js",),
    "reach": ("reach.js",),
    "ring": ("marks.js", "ring.js"),
    "sheet": ("touch.js", "sheet.js"),
    "steps": ("turning.js", "steps.js"),
    "stopwatch": ("stopwatch.js",),
    "theme": ("theme.js",),
    "turn": ("turning.js", "turn.js"),
    "voice": ("voice.js",),
}
"""Component → its script's files; its HTML and CSS are the files of its name, or of its look, if there are any."""
_LOOKS = {"turn": "steps"}
"""Component → the one that it looks like."""

_TEXTS = {
    "cursor": {"cursor": _("Time cursor")},
    "pager": {"sheets": _("Sheets of this page"), "back": _("Back"), "next": _("Next")},
    "link": {"copy": _("Copy link"), "link": _("Link")},
    "sheet": {"handle": _("Sliders and presets")},
    "steps": {"steps": _("Steps"), "step": _("Step"), "back": _("Back"), "next": _("Next")},
    "stopwatch": {"stopwatch": _("Stopwatch")},
    "turn": {"steps": _("Stops of the lesson"), "step": _("Stop"), "back": _("Back"), "next": _("Next")},
}
"""Component → the texts for the slots of its HTML."""

_FONT = re.compile(r"url\(([\w/]+\.woff2)\)")


def script(*paths: Path | str) -> str:
    """Return one script: the shared files, then these (names are of this folder), without comments."""
    return "\n".join(map(_bare, ("bus.js", "hosts.js", "sentences.js", *paths)))


def ask(name: str) -> str:
    """Return the script of one component: it asks the library for its part."""
    return _text(_HERE / "ask.js").replace("NAME", json.dumps(name))


def library() -> str:
    """Return the script that holds all components, each under its name."""
    parts = "\n".join(_part(name, files) for name, files in _PARTS.items())
    return f"{script()}\nconst parts = {{}};\n{parts}\n{_bare('library.js')}"


@cache
def style(name: str = "page.css") -> str:
    """Return a style sheet of this folder without comments: page.css, or projector.css, which goes on top of it."""
    whole = (_HERE / name).read_text(encoding="utf-8")
    return _FONT.sub(_inline, re.sub(r"/\*.*?\*/|\n\s*", "", whole, flags=re.DOTALL))


def _inline(link: re.Match[str]) -> str:
    """Put the font that a style sheet names into the sheet itself."""
    return f"url(data:font/woff2;base64,{b64encode((_HERE / link[1]).read_bytes()).decode()})"


def _part(name: str, files: tuple[str, ...]) -> str:
    """Return the text of `parts.NAME`: the component's look, and the function that its script exports."""
    style, html = (_text(_HERE / f"{_LOOKS.get(name, name)}.{kind}") for kind in ("css", "html"))
    if name in _TEXTS:
        html = html.format(**{slot: escape(text) for slot, text in _TEXTS[name].items()})
    look = (f"<style>{style}</style>" if style else "") + html
    body = "\n".join(map(_bare, files)).replace("export default", "const begin =")
    return f"parts.{name} = {{ look: {json.dumps(look)}, begin: (() => {{\n{body}\nreturn begin;\n}})() }};"


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.exists() else ""


def _bare(path: Path | str) -> str:
    """Return a script without its comments, which stay here."""
    text = re.sub(r"^\s*/\*\*.*?\*/$", "", (_HERE / path).read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    lines = (line.strip() for line in text.splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//"))
