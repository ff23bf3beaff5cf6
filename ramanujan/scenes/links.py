"""What a link may say: every key of the app's URLs, and one sentence for each that cannot be meant.

Streamlit takes the values of bound widgets from the URL and ignores, without a word, what does not fit; here a person
is told. A key is judged once a session, when the page that it belongs to is opened.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import streamlit as st

PAGES = {
    "derivation": ("route", "show", "values", "step", "body", "question"),
    "motion": ("glide", "spin", "mu", "figure"),
    "1729": ("left", "right", "top", "p", "q", "digits"),
    "lesson": (
        "part",
        "stop",
        "chosen",
        "task",
        "task_x0",
        "task_glide",
        "task_spin",
        "task_method",
        "task_steps",
        "task_left",
        "task_right",
        "task_top",
    ),
    "worksheet": ("paper", "seed"),
    "speed": ("method", "steps", "periods", "precision", "tolerance", "cost", "sweep"),
}
"""Page → the keys that it keeps in the URL beside the machine's; no two pages share one."""
EVERYWHERE = ("view", "hide")
"""Keys of the URL that mean the same on every page; `view` reads them."""

_JUDGED = "links_judged"


@dataclass(frozen=True)
class Key:
    """A key of the URL: its name, whether a text fits, and what to call a text that does not."""

    name: str
    fits: Callable[[str], bool]
    misfit: str


def one_of(name: str, offered: Iterable[str], misfit: str | None = None) -> Key:
    """Return a key that takes one of the texts on offer."""
    texts = tuple(offered)
    return Key(name, texts.__contains__, misfit or f"none of {', '.join(texts)}")


def number(name: str, least: float, most: float, words: str) -> Key:
    """Return a key that takes a number in a range, written as Streamlit's sliders read it."""
    return Key(name, lambda text: least <= _as_streamlit_reads(text) <= most, f"no number {words}")


def count(name: str, most: int) -> Key:
    """Return a key that takes an integer from 1 on."""
    return Key(name, lambda text: _is_count(text, most), f"no whole number from 1 to {most}")


def complaints(keys: Iterable[Key]) -> list[str]:
    """Return a sentence on each key that the link gives more than once or with a text that does not fit."""
    judged = st.session_state.setdefault(_JUDGED, set())
    fresh = [key for key in keys if key.name not in judged]
    judged.update(key.name for key in fresh)
    return list(filter(None, map(_complaint, fresh)))


def unknown(machine: Iterable[str]) -> list[str]:
    """Return a sentence, once a session, if the link names neither a key of the machine nor one of a page."""
    judged = st.session_state.setdefault(_JUDGED, set())
    if "" in judged:
        return []
    judged.add("")
    if set(machine).union(EVERYWHERE, *PAGES.values()).issuperset(st.query_params):
        return []
    return ["The link names a quantity that this machine does not have; it is ignored."]


def _complaint(key: Key) -> str | None:
    texts = st.query_params.get_all(key.name)
    if len(texts) > 1:
        return f"The link gives {key.name} more than once; it is ignored."
    if texts and not key.fits(texts[0]):
        return f"The link’s {key.name} is {key.misfit}; it is ignored."
    return None


def _as_streamlit_reads(text: str) -> float:
    """Return the number that a bound slider takes from a link, NaN where it takes none; fractions are for the boxes."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def _is_count(text: str, most: int) -> bool:
    return len(text) < 20 and text.isascii() and text.isdigit() and 1 <= int(text) <= most
