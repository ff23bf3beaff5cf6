"""The parameters of the app's URLs, which are validated before any widget is drawn.

A page declares its own parameters as `URL_PARAMETERS`; `parameters` declares those of every page. `read_once` reads the
address when a page is opened. It copies valid values to the session state, where widgets read them. It removes invalid
values, with a message for each. `keep` writes the values of widgets into the address. An option is written as its id.

Streamlit binds only the sliders of real numbers to the address, so that a drag does not wait for the server.
Other bindings of Streamlit would write labels, and raise an error for an empty or infinite value.
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

*Copy link* omits them.
"""

UNKNOWN = _("The address contains a setting that this page does not know. It was ignored.")
"""Message about a parameter of no page."""

_THIS_COMPUTER = ("localhost", "127.0.0.1", "::1")
_EVERYWHERE = (None, "", "0.0.0.0", "::")
"""Values of Streamlit's option `server.address` for which the app listens in every network of its computer."""
_ELSEWHERE = ("198.51.100.1", 9)
"""An address and port outside of every network, reserved for documentation."""

_PLACE = "address_page"
"""Session state: the page whose address was read last."""
_MET = "address_met"
"""Session state: name → whether Streamlit binds it, for the URL parameters of every page that was opened."""
_WARNED = "address_warned"
_FEW = 8
"""Largest number of options in a message."""
_AROUND = " \t\n\u00a0\u202f.,;:!?…()[]{}<>«»‹›\"'`“”„‟‘’‚‛*|"
"""Characters that may surround a link in a sentence, and that a copy of the link may contain."""


class URLParameter(ABC):
    """A parameter of the app's URLs. If an address does not contain it, its value is the default."""

    bound: ClassVar[bool] = False
    """Whether Streamlit binds a widget to the parameter."""
    name: str
    default: Any
    refused: str
    """Template of the message for an invalid text; its slots are the fields of the parameter."""

    @abstractmethod
    def read(self, text: str) -> Any:
        """Parse a text. Raise `ValueError` if it is invalid."""

    def tidied(self, text: str) -> str:
        """Return a text without surrounding punctuation, if only that makes it valid."""
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
        """Return the text of a value in the address."""
        return str(value)

    def message(self) -> str:
        """Return the message for an invalid text."""
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
        """Return the number. Raise `ValueError` for an invalid text."""
        if not (len(text) < 20 and text.isascii() and text.isdigit() and self.least <= int(text) <= self.most):
            raise ValueError(self.name)
        return int(text)


@dataclass(frozen=True)
class Choice(URLParameter):
    """One of several options.

    Parameters
    ----------
    name : name of the URL parameter
    options : ids or numbers, as in the session state and in the address; or a mapping from these to labels
    default : value for an address without this parameter, or None
    """

    name: str
    options: Collection[Any]
    default: Any = None
    refused = _("The value of {name} in the address was ignored: it must be one of these: {options}.")

    def read(self, text: str) -> Any:
        """Return the option. Raise `ValueError` if there is no such option."""
        offered = {self.write(option): option for option in self.options}
        if text not in offered:
            raise ValueError(self.name)
        return offered[text]

    def message(self) -> str:
        """Return the message for an invalid text. It contains the options, or the first few of many."""
        texts = list(map(str, self.options))
        few, more = ", ".join(texts[:_FEW]), len(texts) - _FEW
        listed = few if more <= 0 else _("{few} and {more} more").format(few=few, more=more)
        return self.refused.format(name=self.name, options=listed)


@dataclass(frozen=True)
class Several(Choice):
    """Any number of options in any order, separated by commas."""

    default: tuple[str, ...] = ()
    refused = _(
        "The value of {name} in the address was ignored: it must be one or more of these, with commas between them: "
        "{options}."
    )

    def read(self, text: str) -> tuple[str, ...]:
        """Return the options without repetitions. Raise `ValueError` if one of them does not exist."""
        asked = dict.fromkeys(each.strip() for each in text.split(","))
        if not asked.keys() <= set(self.options):
            raise ValueError(self.name)
        return tuple(asked)

    def write(self, value: tuple[str, ...]) -> str:
        """Return the text of the options in the address."""
        return ",".join(value)


@dataclass(frozen=True)
class Text(URLParameter):
    """A text that matches the regular expression `form`. The code that uses it checks its meaning."""

    name: str
    form: str
    refused: str
    default: str = ""

    def read(self, text: str) -> str:
        """Return the text. Raise `ValueError` if it does not match."""
        if not re.fullmatch(self.form, text, re.ASCII):
            raise ValueError(self.name)
        return text


def bare(text: str) -> str:
    """Return a text without the brackets, quotation marks, full stops and spaces around it."""
    return text.strip(_AROUND)


def read_once(page: str, parameters: Sequence[URLParameter]) -> list[str]:
    """Read the address after a page was opened, or after the back button; return a message for each problem.

    Call it once in each run, before any widget of these parameters is drawn.

    Parameters
    ----------
    page : name of the page
    parameters : all URL parameters of the page
    """
    back = _goes_back()
    if st.session_state.get(_PLACE) == page and not back:
        return []
    st.session_state[_PLACE] = page
    messages = []
    for parameter in parameters:
        message = _copy_to_session(parameter, back)
        if message:
            messages.append(message)
    met = st.session_state.setdefault(_MET, {})
    messages += _remove_unknown({parameter.name for parameter in parameters}, met)
    met.update({parameter.name: parameter.bound for parameter in parameters})
    return messages


def current(parameter: URLParameter) -> Any:
    """Return the value of a URL parameter that Streamlit does not bind, or its default value."""
    value = st.session_state.get(parameter.name)
    return parameter.default if value is None else value


def keep(*parameters: URLParameter) -> Any:
    """Write the values of parameters into the address, and return the value of the last one.

    A default is not written. An invalid value of a bound parameter is removed.
    """
    for parameter in parameters:
        if parameter.bound:
            if not fits(parameter):
                st.query_params.pop(parameter.name, None)
            continue
        value = current(parameter)
        text = None if value == parameter.default else parameter.write(value)
        if text is None:
            st.query_params.pop(parameter.name, None)
        elif st.query_params.get(parameter.name) != text:
            st.query_params[parameter.name] = text
    return current(parameters[-1])


def link(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return the URL of this page in the browser, with another query and optionally another path."""
    here = urlsplit(st.context.url or "")
    path = here.path if path is None else f"{here.path.rpartition('/')[0]}/{path}"
    return here._replace(path=path, query=urlencode(query, safe=","), fragment="")


def link_for_others(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return the same URL as `link`, but with a host name that works on other computers.

    A browser on the server's own computer may use `localhost`, which other computers cannot open.
    """
    here = link(query, path)
    if here.hostname not in _THIS_COMPUTER:
        return here
    host = _network_host()
    return here._replace(netloc=f"{host}:{here.port}") if host and here.port == st.get_option("server.port") else here


def is_for_this_computer_alone() -> bool:
    """Return whether no known URL opens this page on other computers."""
    return link_for_others({}).hostname in _THIS_COMPUTER


def _network_host() -> str | None:
    """Return the IP address of this computer in its network; None without one, or if the app does not listen there."""
    if st.get_option("server.address") not in _EVERYWHERE:
        return None
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            # Connecting a datagram socket sends nothing, but the system selects the network interface.
            probe.connect(_ELSEWHERE)
        except OSError:
            return None
        host = probe.getsockname()[0]
    return None if ipaddress.ip_address(host).is_loopback else host


def fits(parameter: URLParameter) -> bool:
    """Return whether the address contains no value of a parameter, or exactly one valid value."""
    _value, sentence = _read(parameter)
    return sentence is None


def _read(parameter: URLParameter) -> tuple[Any, str | None]:
    """Return the value of a parameter in the address or None, and the message for an invalid value or None."""
    texts = st.query_params.get_all(parameter.name)
    if len(texts) > 1:
        return None, _("The address contains {name} more than once, so it was ignored.").format(name=parameter.name)
    try:
        return parameter.read(texts[0]) if texts else None, None
    except ValueError:
        return None, parameter.message()


def _copy_to_session(parameter: URLParameter, back: bool) -> str | None:
    """Copy a value from the address to the session state; remove an invalid value and return a message."""
    value, sentence = _read(parameter)
    # A bound slider reads a valid value and removes an invalid one itself.
    if parameter.bound:
        return sentence
    if sentence:
        del st.query_params[parameter.name]
    elif value is not None or back:
        st.session_state[parameter.name] = parameter.default if value is None else value
    return sentence


def _remove_unknown(names: Iterable[str], met: Mapping[str, bool]) -> list[str]:
    """Remove the parameters of previous pages; return a message if there are parameters of no page."""
    unknown = set(st.query_params).difference(names)
    for name in unknown & met.keys():
        if not met[name]:
            del st.query_params[name]
    if not unknown - met.keys() or st.session_state.get(_WARNED):
        return []
    st.session_state[_WARNED] = True
    return [UNKNOWN]


def _goes_back() -> bool:
    """Return whether the user pressed the back or forward button. Then the address overrides the session state."""
    # Streamlit documents this function, but only for threads. There is no documented way to detect the back button.
    context = get_script_run_ctx()
    return context is not None and context.is_history_navigation
