"""What an address may say: each key of the app's URLs, judged before any widget is drawn.

A page declares its keys as `KEYS`, and `quantities` those of every page. `opened` reads the address when a page is
opened. What fits goes into the session state, where the widgets find it; what does not fit is dropped, and one sentence
says so. `keep` writes into the address what a widget holds. An option stands there by its id, never by its label.

Only sliders of real numbers are bound to the address by Streamlit itself, so that a drag needs no answer from the
server. Streamlit's other bindings write labels, and break off the run where a value is empty or infinite.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import streamlit as st
from streamlit.runtime.scriptrunner import get_script_run_ctx

from ramanujan.translation import _

PRIVATE = ("lecturer",)
"""Keys that say who somebody is in a class; *Copy link* leaves them out."""

_PLACE = "links_place"
"""Session state: the page whose address was read last."""
_MET = "links_met"
"""Session state: name → whether Streamlit binds it, for the keys of every page that was opened."""
_TOLD = "links_told"
_FEW = 8
"""As many options as a sentence can list."""


@dataclass(frozen=True)
class Measure:
    """A real number within a range, held by a slider that Streamlit binds to the address."""

    bound: ClassVar[bool] = True
    name: str
    least: float
    most: float
    unit: str = ""

    def read(self, text: str) -> float:
        """Return the number, written as Streamlit's sliders read it; ValueError if it does not fit."""
        value = float(text)
        if not (math.isfinite(value) and self.least <= value <= self.most):
            raise ValueError(self.name)
        return value

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        sentence = _("The value of {name} in the address was ignored: it must be a number from {least} to {most}.")
        if self.unit:
            sentence = _(
                "The value of {name} in the address was ignored: it must be a number from {least} to {most} {unit}."
            )
        return sentence.format(name=self.name, least=f"{self.least:g}", most=f"{self.most:g}", unit=self.unit)


@dataclass(frozen=True)
class Count:
    """A whole number within a range."""

    bound: ClassVar[bool] = False
    name: str
    most: int
    default: int = 1
    least: int = 1

    def read(self, text: str) -> int:
        """Return the number; ValueError if it does not fit."""
        if not (len(text) < 20 and text.isascii() and text.isdigit() and self.least <= int(text) <= self.most):
            raise ValueError(self.name)
        return int(text)

    def write(self, value: int) -> str:
        """Return the number as the address has it."""
        return str(value)

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        return _(
            "The value of {name} in the address was ignored: it must be a whole number from {least} to {most}."
        ).format(name=self.name, least=self.least, most=self.most)


@dataclass(frozen=True)
class Choice:
    """One of several options.

    Parameters
    ----------
    name : of the key
    options : the options as session state and code have them: ids, or numbers
    default : the option that an address without this key means; None where nothing is chosen
    write : option → its text in the address
    """

    bound: ClassVar[bool] = False
    name: str
    options: tuple[Any, ...]
    default: Any = None
    write: Callable[[Any], str] = str

    def read(self, text: str) -> Any:
        """Return the option; ValueError if there is no such option."""
        offered = {self.write(option): option for option in self.options}
        if text not in offered:
            raise ValueError(self.name)
        return offered[text]

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        texts = [self.write(option) for option in self.options]
        if len(texts) > _FEW:
            return _(
                "The value of {name} in the address was ignored: it must be one of {count} options, such as {example}."
            ).format(name=self.name, count=len(texts), example=texts[0])
        return _("The value of {name} in the address was ignored: it must be one of these: {options}.").format(
            name=self.name, options=", ".join(texts)
        )


@dataclass(frozen=True)
class Several:
    """Any number of options, with commas between them."""

    bound: ClassVar[bool] = False
    name: str
    options: tuple[str, ...]
    default: tuple[str, ...] = ()

    def read(self, text: str) -> tuple[str, ...]:
        """Return the options, in their own order; ValueError if one of them does not exist."""
        asked = {each.strip() for each in text.split(",")}
        if not asked <= set(self.options):
            raise ValueError(self.name)
        return tuple(option for option in self.options if option in asked)

    def write(self, value: tuple[str, ...]) -> str:
        """Return the options as the address has them."""
        return ",".join(value)

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        return _(
            "The value of {name} in the address was ignored: it must be one or more of these, with commas between "
            "them: {options}."
        ).format(name=self.name, options=", ".join(self.options))


@dataclass(frozen=True)
class Name:
    """The name of something that only the drawn page knows; one that does not exist means the default."""

    bound: ClassVar[bool] = False
    name: str
    default: str = ""

    def read(self, text: str) -> str:
        """Return the name; ValueError if it cannot be one."""
        if not re.fullmatch(r"[a-z0-9_]{1,40}", text):
            raise ValueError(self.name)
        return text

    def write(self, value: str) -> str:
        """Return the name as the address has it."""
        return value

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        return _("The value of {name} in the address was ignored: it must be a short name.").format(name=self.name)


Key = Measure | Count | Choice | Several | Name


def opened(page: str, keys: Sequence[Key]) -> list[str]:
    """Read the address if a page has just been opened or gone back to; return what is to be said of it.

    Call it once a run, before any widget of these keys is drawn.

    Parameters
    ----------
    page : name of the page
    keys : all that its address may contain
    """
    back = _goes_back()
    if st.session_state.get(_PLACE) == page and not back:
        return []
    st.session_state[_PLACE] = page
    said = [sentence for key in keys if (sentence := _take(key, back))]
    met = st.session_state.setdefault(_MET, {})
    said += _strangers({key.name for key in keys}, met)
    met.update({key.name: key.bound for key in keys})
    return said


def held(key: Choice | Count | Several) -> Any:
    """Return the value of a key that Streamlit does not bind."""
    return st.session_state.get(key.name, key.default)


def keep(*keys: Choice | Count | Several) -> None:
    """Write into the address what is chosen; a default stands there without words."""
    for key in keys:
        value = held(key)
        text = None if value == key.default else key.write(value)
        if st.query_params.get(key.name) == text:
            continue
        if text is None:
            del st.query_params[key.name]
        else:
            st.query_params[key.name] = text


def fits(key: Key) -> bool:
    """Tell whether the address says nothing of a key, or says it once and readably."""
    texts = st.query_params.get_all(key.name)
    try:
        return not texts or (len(texts) == 1 and key.read(texts[0]) is not None)
    except ValueError:
        return False


def _take(key: Key, back: bool) -> str | None:
    """Put what the address says of a key into the session, or drop it and return a sentence."""
    texts = st.query_params.get_all(key.name)
    if not texts:
        if back and not key.bound:
            st.session_state[key.name] = key.default
        return None
    if len(texts) > 1:
        sentence = _("The address contains {name} more than once, so it was ignored.").format(name=key.name)
    else:
        try:
            value = key.read(texts[0])
        except ValueError:
            sentence = key.complaint()
        else:
            if not key.bound:
                st.session_state[key.name] = value
            return None
    # A bound slider drops by itself what it cannot use.
    if not key.bound:
        del st.query_params[key.name]
    return sentence


def _strangers(names: Iterable[str], met: Mapping[str, bool]) -> list[str]:
    """Drop what pages that were left behind have kept in the address; return a sentence on what nobody knows."""
    strange = set(st.query_params).difference(names)
    for name in strange & met.keys():
        if not met[name]:
            del st.query_params[name]
    if not strange - met.keys() or st.session_state.get(_TOLD):
        return []
    st.session_state[_TOLD] = True
    return [_("The address contains a setting that this page does not know. It was ignored.")]


def _goes_back() -> bool:
    """Tell whether the browser's back or forward button has led here; then the address decides."""
    context = get_script_run_ctx()
    return context is not None and context.is_history_navigation
