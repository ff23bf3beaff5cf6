"""The JavaScript modules, style sheets and fonts of the page: files of this folder, and four modules from Python.

Their address contains the hash of their contents, so that browsers can cache them forever. The browser resolves the
imports. A style sheet also contains the sheets of the same name in the folders of components and pages. These modules
are generated:

    markup.js                 HTML and CSS of each component, which Streamlit would send again with every run
    stage/formulas.js         the stage's formulas, printed by SymPy
    stage/texts.js            the stage's texts
    language.js               the decimal mark
"""

import json
import re
from collections.abc import Callable, Iterable
from functools import cache
from hashlib import sha256
from html import escape
from pathlib import Path
from typing import Any

import streamlit as st

from ramanujan.browser.components.texts import TEXTS
from ramanujan.browser.stage import words
from ramanujan.browser.stage.formulas import collect_formulas, collect_labels
from ramanujan.derivation.printers import javascript
from ramanujan.text.numerals import DECIMAL

_HERE = Path(__file__).parent
_PAGES = _HERE.parent / "pages"
_COMMON = _HERE / "common.css"


@cache
def collect_files() -> dict[str, bytes]:
    """Return path → content of all files: modules, style sheets, and fonts."""
    paths = [path for pattern in ("**/*.js", "**/*.woff2") for path in sorted(_HERE.glob(pattern))]
    components = sorted(
        f"components/{path.parent.name}/{path.stem}" for path in paths if path.match("components/*/*.js")
    )
    sentences = {**words.SENTENCES, **collect_labels(), "slips": words.SLIPS, "bodies": words.BODY_WORDS}
    generated = {
        "language.js": f'export const DECIMAL = "{DECIMAL}";',
        "markup.js": markup(["stage/stage", *components]),
        "stage/formulas.js": f"export const FORMULAS = {javascript(collect_formulas())};",
        "stage/texts.js": f"export const WORDS = {json.dumps(sentences, ensure_ascii=False)};\n"
        f"export const LIGHT = {json.dumps(_light_colors())};",
    }
    files = {path.relative_to(_HERE).as_posix(): path.read_bytes() for path in paths}
    return files | {name: text.encode() for name, text in (generated | _join_sheets()).items()}


def _join_sheets() -> dict[str, str]:
    """Return the style sheets of the page. Those of components and pages are part of them, to save requests."""
    beside = [*sorted(_HERE.glob("components/*")), *sorted(_PAGES.glob("*"))]
    sheets = {
        name: _read_text(_HERE / name) + "".join(_read_text(folder / name) for folder in beside)
        for name in ("contrast.css", "page.css", "print.css", "projector.css", "type.css")
    }
    sheets["page.css"] = _read_text(_HERE / "streamlit.css") + sheets["page.css"]
    # Components are printed in the light theme.
    light_colors = _light_colors() | {"--st-background-color": "#fff"}
    declarations = "".join(f"{name}: {color}; " for name, color in light_colors.items())
    sheets["print.css"] += f"#root .stBidiComponent {{ &, * {{ {declarations}}} }}"
    return sheets


@cache
def folder_url() -> str:
    """Return the URL of the folder with the files, relative to the app's URL; it changes with their contents."""
    listing = repr(sorted(collect_files().items()))
    version = sha256(listing.encode()).hexdigest()[:12]
    return f"modules/{version}"


@cache
def component(name: str) -> Callable[..., Any]:
    """Return the component of a module, such as components/link. Its script loads the module by begin.js."""
    # All components have the same script, so a browser parses it once. It is short, because Streamlit sends it with
    # every run of the page. It has two lines, because Streamlit interprets a single line as the name of a file.
    begin = f'new URL("{folder_url()}/begin.js", document.baseURI)'
    return st.components.v2.component(name, js=f"export default async (c) =>\n(await import({begin})).begin(c)")


def markup(names: Iterable[str], appended: str = "") -> str:
    """Return the module markup.js, which contains the HTML and CSS of components.

    Parameters
    ----------
    names : names of the components, such as stage/stage
    appended : HTML that is added to that of each component
    """
    parts = {}
    for name in names:
        short = name.rpartition("/")[2]
        if name == "stage/stage":
            html = _markup(name, words.TEXTS, layer_boxes=_write_layer_boxes())
        else:
            html = _markup(name, TEXTS.get(short, {}))
        parts[name] = html + appended if html else ""
    return f"export const MARKUP = {json.dumps(parts, ensure_ascii=False)};"


def _markup(name: str, texts: dict[str, str], **parts: str) -> str:
    """Return a component's style sheet and HTML, with its texts and HTML parts inserted; both files are optional."""
    style, html = (_read_text(_HERE / f"{name}.{kind}") for kind in ("css", "html"))
    html = html.format(**{slot: escape(text) for slot, text in texts.items()}, **parts)
    return f"<style>{_read_text(_COMMON)}{style}</style>{html}" if style else html


def _write_layer_boxes() -> str:
    """Return the tick boxes of the stage's layers as HTML."""
    return "".join(
        f'<label data-layer="{layer}" title="{escape(description)}"><input type="checkbox" /> {escape(title)}</label>'
        for layer, (title, description) in words.LAYERS.items()
    )


def theme_colors(theme: str, style: str) -> dict[str, str]:
    """Return the colours of a theme that a style sheet uses, by their custom properties such as --st-text-color.

    Streamlit derives the colours of its widgets itself, so these are left out.
    """
    names = sorted(set(re.findall(r"--st-(?!widget)[a-z-]+-color", style)))
    options = {name: re.sub("-([a-z])", lambda match: match[1].upper(), name.removeprefix("--st-")) for name in names}
    colors = {name: st.get_option(f"theme.{theme}.{option}") for name, option in options.items()}
    return {name: color for name, color in colors.items() if color}


def _light_colors() -> dict[str, str]:
    """Return the stage's colours in the light theme, for saved pictures."""
    return theme_colors("light", _read_text(_HERE / "stage/stage.css"))


def _read_text(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.exists() else ""
