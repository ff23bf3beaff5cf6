"""The parameters of the app's URLs, checked before any widget is drawn.

A page declares its own as `URL_PARAMETERS`, `parameters` those of every page. `read_once` reads the address when a page
is opened. Valid values go into the session state, where the widgets find them. Invalid ones are dropped, and a sentence
reports each. `keep` writes the values of widgets into the address, an option by its id, never by its label.

Only sliders of real numbers are bound to the address by Streamlit itself, so that a drag needs no answer from the
server. Streamlit's other bindings write labels, and break off the run where a value is empty or infinite.
"""

import ipaddress
import re
import socket
from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar
from urllib.parse import SplitResult, urlencode, urlsplit

import streamlit as st
from streamlit.runtime.scriptrunner import get_script_run_ctx

from ramanujan.translation import _

PRIVATE = ("lecturer", "key", "exercise_key", "frame")
"""URL parameters of one person: of the lecturer, in a class or with a worksheet, or of one browser in a frame.

*Copy link* leaves them out.
"""

_THIS_COMPUTER = ("localhost", "127.0.0.1", "::1")
_EVERYWHERE = (None, "", "0.0.0.0", "::")
"""Values of Streamlit's option `server.address` with which the app listens in every network of its computer."""
_ELSEWHERE = ("198.51.100.1", 9)
"""An address and port outside of every network, reserved for documentation."""

_PLACE = "address_page"
"""Session state: the page whose address was read last."""
_MET = "address_met"
"""Session state: name → whether Streamlit binds it, for the URL parameters of every page that was opened."""
_WARNED = "address_warned"
_FEW = 8
"""The most options that a sentence lists."""
_AROUND = " \t\n\u00a0\u202f.,;:!?…()[]{}<>«»‹›\"'`“”„‟‘’‚‛*|"
"""Characters of the sentence around a link that a copy of the link may contain."""


class URLParameter(ABC):
    """A parameter of the app's URLs; one that is missing means its default."""

    bound: ClassVar[bool] = False
    """Whether Streamlit itself binds a widget to it."""
    name: str
    default: Any
    refused: str
    """The sentence for a text that does not fit; its slots are the fields of the parameter."""

    @abstractmethod
    def read(self, text: str) -> Any:
        """Return the value that a text means; ValueError if it does not fit."""

    def tidied(self, text: str) -> str:
        """Return a text of the address without the punctuation around it, if it fits without it."""
        if self._fits(text):
            return text
        return bare(text) if self._fits(bare(text)) else text

    def _fits(self, text: str) -> bool:
        try:
            self.read(text)
        except ValueError:
            return False
        return True

    def write(self, value: Any) -> str:
        """Return a value as the address has it."""
        return str(value)

    def message(self) -> str:
        """Return the sentence for a text that does not fit."""
        return self.refused.format(**vars(self))


@dataclass(frozen=True)
class Count(URLParameter):
    """A whole number within a range."""

    name: str
    most: int
    default: int = 1
    least: int = 1
    refused = _("The value of {name} in the address was ignored: it must be a whole number from {least} to {most}.")

    def read(self, text: str) -> int:
        """Return the number; ValueError if it does not fit."""
        if not (len(text) < 20 and text.isascii() and text.isdigit() and self.least <= int(text) <= self.most):
            raise ValueError(self.name)
        return int(text)


@dataclass(frozen=True)
class Choice(URLParameter):
    """One of several options.

    Parameters
    ----------
    name : of the URL parameter
    options : the options as session state, code and address have them: ids or numbers; or these → what a person reads
    default : the option that an address without this parameter means; None where nothing is chosen
    """

    name: str
    options: Collection[Any]
    default: Any = None
    refused = _("The value of {name} in the address was ignored: it must be one of these: {options}.")

    def read(self, text: str) -> Any:
        """Return the option; ValueError if there is no such option."""
        offered = {self.write(option): option for option in self.options}
        if text not in offered:
            raise ValueError(self.name)
        return offered[text]

    def message(self) -> str:
        """Return the sentence for a text that does not fit, with the options; of many, the first few."""
        texts = list(map(str, self.options))
        few, more = ", ".join(texts[:_FEW]), len(texts) - _FEW
        listed = few if more <= 0 else _("{few} and {more} more").format(few=few, more=more)
        return self.refused.format(name=self.name, options=listed)


@dataclass(frozen=True)
class Several(Choice):
    """Any number of options in any order, with commas between them."""

    default: tuple[str, ...] = ()
    refused = _(
        "The value of {name} in the address was ignored: it must be one or more of these, with commas between them: "
        "{options}."
    )

    def read(self, text: str) -> tuple[str, ...]:
        """Return the options, each once; ValueError if one of them does not exist."""
        asked = dict.fromkeys(each.strip() for each in text.split(","))
        if not asked.keys() <= set(self.options):
            raise ValueError(self.name)
        return tuple(asked)

    def write(self, value: tuple[str, ...]) -> str:
        """Return the options as the address has them."""
        return ",".join(value)


@dataclass(frozen=True)
class Text(URLParameter):
    """A text that fits a regular expression, its form; whether it names anything is known where it is used."""

    name: str
    form: str
    refused: str
    default: str = ""

    def read(self, text: str) -> str:
        """Return the text; ValueError if it does not fit."""
        if not re.fullmatch(self.form, text, re.ASCII):
            raise ValueError(self.name)
        return text


def bare(text: str) -> str:
    """Return a text without the brackets, quotation marks, full stops and spaces around it."""
    return text.strip(_AROUND)


def read_once(page: str, parameters: Sequence[URLParameter]) -> list[str]:
    """Read the address if a page was just opened or gone back to; return a sentence about each problem.

    Call it once a run, before any widget of these parameters is drawn.

    Parameters
    ----------
    page : name of the page
    parameters : all that its address may contain
    """
    back = _goes_back()
    if st.session_state.get(_PLACE) == page and not back:
        return []
    st.session_state[_PLACE] = page
    said = [sentence for parameter in parameters if (sentence := _take(parameter, back))]
    met = st.session_state.setdefault(_MET, {})
    said += _strangers({parameter.name for parameter in parameters}, met)
    met.update({parameter.name: parameter.bound for parameter in parameters})
    return said


def held(parameter: URLParameter) -> Any:
    """Return the value of a URL parameter that Streamlit does not bind; its default where nothing is chosen."""
    value = st.session_state.get(parameter.name)
    return parameter.default if value is None else value


def keep(*parameters: URLParameter) -> Any:
    """Write the chosen values into the address, and return the last of them.

    A default is left out, and so is what a bound widget cannot use.
    """
    for parameter in parameters:
        if parameter.bound:
            if not fits(parameter):
                st.query_params.pop(parameter.name, None)
            continue
        value = held(parameter)
        text = None if value == parameter.default else parameter.write(value)
        if text is None:
            st.query_params.pop(parameter.name, None)
        elif st.query_params.get(parameter.name) != text:
            st.query_params[parameter.name] = text
    return held(parameters[-1])


def link(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return the address of this page, or of the one with another path, as the browser has it, with another query."""
    here = urlsplit(st.context.url or "")
    path = here.path if path is None else f"{here.path.rpartition('/')[0]}/{path}"
    return here._replace(path=path, query=urlencode(query, safe=","), fragment="")


def link_for_others(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return what `link` returns, as other computers open it.

    A browser on the server's own computer may have opened the app at `localhost`, which no other computer can open.
    """
    here = link(query, path)
    if here.hostname not in _THIS_COMPUTER:
        return here
    host = _network_host()
    return here._replace(netloc=f"{host}:{here.port}") if host and here.port == st.get_option("server.port") else here


def is_for_this_computer_alone() -> bool:
    """Tell whether no address is known under which other computers can open this page."""
    return link_for_others({}).hostname in _THIS_COMPUTER


def _network_host() -> str | None:
    """Return the IP address of this computer in its network; None without one, or if the app does not listen there."""
    if st.get_option("server.address") not in _EVERYWHERE:
        return None
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            # Connecting a datagram socket sends nothing. The system chooses the network card for the way.
            probe.connect(_ELSEWHERE)
        except OSError:
            return None
        host = probe.getsockname()[0]
    return None if ipaddress.ip_address(host).is_loopback else host


def fits(parameter: URLParameter) -> bool:
    """Tell whether the address says nothing of a parameter, or says it once and readably."""
    _value, sentence = _read(parameter)
    return sentence is None


def _read(parameter: URLParameter) -> tuple[Any, str | None]:
    """Return the value that the address has of a parameter, if any, and the sentence on what it cannot use."""
    texts = st.query_params.get_all(parameter.name)
    if len(texts) > 1:
        return None, _("The address contains {name} more than once, so it was ignored.").format(name=parameter.name)
    try:
        return parameter.read(texts[0]) if texts else None, None
    except ValueError:
        return None, parameter.message()


def _take(parameter: URLParameter, back: bool) -> str | None:
    """Put a parameter of the address into the session, or drop it and return a sentence."""
    value, sentence = _read(parameter)
    # A bound slider takes by itself what it can use, and drops the rest.
    if parameter.bound:
        return sentence
    if sentence:
        del st.query_params[parameter.name]
    elif value is not None or back:
        st.session_state[parameter.name] = parameter.default if value is None else value
    return sentence


def _strangers(names: Iterable[str], met: Mapping[str, bool]) -> list[str]:
    """Drop the settings of pages that were left; return a sentence about settings that no page knows."""
    strange = set(st.query_params).difference(names)
    for name in strange & met.keys():
        if not met[name]:
            del st.query_params[name]
    if not strange - met.keys() or st.session_state.get(_WARNED):
        return []
    st.session_state[_WARNED] = True
    return [_("The address contains a setting that this page does not know. It was ignored.")]


def _goes_back() -> bool:
    """Tell whether the browser's back or forward button has led here; then the address decides."""
    # Streamlit documents this function, for threads; nothing that is documented says how a page was reached.
    context = get_script_run_ctx()
    return context is not None and context.is_history_navigation
