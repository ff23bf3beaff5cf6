"""The parameters of the app's URLs, which are validated before any widget is drawn.

A page declares its own parameters in its `menu.Entry`, which adds those of every page. `read_once` reads
the address when a page is opened. It copies valid values to the session state, where widgets read them. It removes
invalid values with a message for each, and unknown parameters without a message: mail programs add their own.
`update` writes the values of widgets into the address. An option is written as its id. Only the page writes the view of
a stage (browser/page_address.js).

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

from ramanujan.text.translation import _

PRIVATE = ("lecturer", "key", "frame")
"""URL parameters that contain a lecturer's key, or belong to a frame. *Copy link* omits them."""

_LOCAL_HOSTS = ("localhost", "127.0.0.1", "::1")
_ALL_INTERFACES = (None, "", "0.0.0.0", "::")
"""Values of Streamlit's option `server.address` for which the app listens in every network of its computer."""
_DISTANT_ADDRESS = ("198.51.100.1", 9)
"""An address and port outside of every network, reserved for documentation."""

_LAST_PAGE = "address_page"
"""Session state: name of the page for which the address was last read."""
_BOUND = "address_bound"
"""Session state: names of the URL parameters that Streamlit binds, of all pages opened in this session."""
_MOST_LISTED = 8
"""Largest number of options in a message."""
_PUNCTUATION = " \t\n\u00a0\u202f.,;:!?…()[]{}<>«»‹›\"'`“”„‟‘’‚‛*|"
"""Characters that can follow a link in a sentence, and that a chat may include in the link."""


class URLParameter(ABC):
    """A parameter of the app's URLs. If an address does not contain it, its value is the default."""

    is_bound: ClassVar[bool] = False
    """Whether Streamlit binds a widget to the parameter."""
    name: str
    default: Any
    template: str
    """Template of the message for an invalid text; its slots are the fields of the parameter."""

    @abstractmethod
    def read(self, text: str) -> Any:
        """Parse a text. Raise `ValueError` if it is invalid."""

    def write(self, value: Any) -> str:
        """Return the text of a value in the address."""
        return str(value)

    def message(self, text: str = "") -> str:
        """Return the message for an invalid text."""
        return self.template.format(**vars(self))


@dataclass(frozen=True)
class Count(URLParameter):
    """A whole number within a range."""

    name: str
    most: int
    default: int = 1
    least: int = 1
    template = _("The value of {name} in the address was ignored: it must be a whole number from {least} to {most}.")

    def read(self, text: str) -> int:
        """Return the number. Raise `ValueError` for an invalid text."""
        is_whole = text.isascii() and text.isdigit()
        # `int` is slow for a very long text.
        if not is_whole or len(text) >= 20:
            raise ValueError(self.name)
        value = int(text)
        if not self.least <= value <= self.most:
            raise ValueError(self.name)
        return value


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
    template = _("The value of {name} in the address was ignored: it must be one of these: {options}.")

    def read(self, text: str) -> Any:
        """Return the option. Raise `ValueError` if there is no such option."""
        offered = {self.write(option): option for option in self.options}
        if text not in offered:
            raise ValueError(self.name)
        return offered[text]

    def message(self, text: str = "") -> str:
        """Return the message for an invalid text. It contains the options, or the first few of many."""
        texts = list(map(str, self.options))
        listed = ", ".join(texts[:_MOST_LISTED])
        omitted = len(texts) - _MOST_LISTED
        if omitted > 0:
            listed = _("{few} and {more} more").format(few=listed, more=omitted)
        return self.template.format(name=self.name, options=listed)


@dataclass(frozen=True)
class Several(Choice):
    """Any number of options in any order, separated by commas.

    Links of an earlier version can contain its options `gone`, which are ignored without a message.
    """

    default: tuple[str, ...] = ()
    gone: tuple[str, ...] = ()
    template = _(
        "The value of {name} in the address was ignored: it must be one or more of these, with commas between them: "
        "{options}."
    )

    def read(self, text: str) -> tuple[str, ...]:
        """Return the options without repetitions. Raise `ValueError` if an option does not exist."""
        # A dictionary removes repetitions and preserves the order.
        values = dict.fromkeys(part.strip() for part in text.split(","))
        for option in self.gone:
            values.pop(option, None)
        if not values.keys() <= set(self.options):
            raise ValueError(self.name)
        return tuple(values)

    def write(self, value: tuple[str, ...]) -> str:
        """Return the text of the options in the address."""
        return ",".join(value)


@dataclass(frozen=True)
class Text(URLParameter):
    """A text that matches the regular expression `pattern`. Its meaning is checked where the value is used."""

    name: str
    pattern: str
    template: str
    default: str = ""

    def read(self, text: str) -> str:
        """Return the text. Raise `ValueError` if it does not match."""
        if not re.fullmatch(self.pattern, text, re.ASCII):
            raise ValueError(self.name)
        return text


def read_once(page: str, parameters: Sequence[URLParameter]) -> list[str]:
    """Read the address after a page was opened, or after the back button; return a message for each problem.

    Call it once in each run, before any widget of these parameters is drawn.

    Parameters
    ----------
    page : name of the page
    parameters : all URL parameters of the page
    """
    is_history_navigation = _is_history_navigation()
    if st.session_state.get(_LAST_PAGE) == page and not is_history_navigation:
        return []
    st.session_state[_LAST_PAGE] = page
    messages = []
    for parameter in parameters:
        message = _copy_to_session(parameter, use_default=is_history_navigation)
        if message:
            messages.append(message)
    _remove_others(parameters)
    return messages


def current(parameter: URLParameter) -> Any:
    """Return the value of a URL parameter that Streamlit does not bind, or its default value."""
    value = st.session_state.get(parameter.name)
    return parameter.default if value is None else value


def update(*parameters: URLParameter) -> Any:
    """Write the values of parameters into the address, and return the value of the last one.

    A default is not written. An invalid value of a bound parameter is removed.
    """
    for parameter in parameters:
        if parameter.is_bound:
            if read_value(parameter) is None:
                st.query_params.pop(parameter.name, None)
            continue
        value = current(parameter)
        if value == parameter.default:
            st.query_params.pop(parameter.name, None)
            continue
        text = parameter.write(value)
        if st.query_params.get(parameter.name) != text:
            st.query_params[parameter.name] = text
    return current(parameters[-1])


def link(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return the URL of this page in the browser, with another query and optionally another path."""
    url = urlsplit(st.context.url or "")
    if path is None:
        path = url.path
    else:
        folder = url.path.rpartition("/")[0]
        path = f"{folder}/{path}"
    return url._replace(path=path, query=urlencode(query, safe=","), fragment="")


def link_for_others(query: Mapping[str, str], path: str | None = None) -> SplitResult:
    """Return the same URL as `link`, but with a host name that works on other computers.

    A browser on the server's own computer may use `localhost`, which other computers cannot open.
    """
    url = link(query, path)
    if url.hostname not in _LOCAL_HOSTS:
        return url
    host, port = _network_host(), url.port or 80
    # Another port belongs to a proxy or a tunnel, which may not be reachable at this host.
    if host is None or port != st.get_option("server.port"):
        return url
    return url._replace(netloc=f"{host}:{port}")


def is_only_for_this_computer() -> bool:
    """Return whether no known URL opens this page on other computers."""
    return link_for_others({}).hostname in _LOCAL_HOSTS


def _network_host() -> str | None:
    """Return the IP address of this computer in its network; None without one, or if the app does not listen there."""
    if st.get_option("server.address") not in _ALL_INTERFACES:
        return None
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            # Connecting a datagram socket sends nothing, but the system selects the network interface.
            probe.connect(_DISTANT_ADDRESS)
        except OSError:
            return None
        host = probe.getsockname()[0]
    return None if ipaddress.ip_address(host).is_loopback else host


def read_value(parameter: URLParameter) -> Any:
    """Return the value of a parameter in the address; None if the address contains no valid value."""
    value, _sentence = _read(parameter)
    return value


def _texts(parameter: URLParameter) -> list[str]:
    """Return the texts of a parameter in the address, without punctuation at the end."""
    return [text.rstrip(_PUNCTUATION) for text in st.query_params.get_all(parameter.name)]


def _read(parameter: URLParameter) -> tuple[Any, str | None]:
    """Return the value of a parameter in the address or None, and the message for an invalid value or None."""
    texts = _texts(parameter)
    if len(texts) > 1:
        return None, _("The address contains {name} more than once, so it was ignored.").format(name=parameter.name)
    try:
        return parameter.read(texts[0]) if texts else None, None
    except ValueError:
        return None, parameter.message(texts[0])


def _is_plain_number(text: str) -> bool:
    """Return whether Streamlit reads a text in the address as a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def _copy_to_session(parameter: URLParameter, use_default: bool) -> str | None:
    """Copy a value from the address to the session state; remove an invalid value and return a message.

    If the address does not contain the parameter, `use_default` copies the default instead.
    """
    value, sentence = _read(parameter)
    if parameter.is_bound:
        # A bound slider reads a plain number itself, and removes any other text. Such a text can be valid: 9/8. In the
        # new session after a restart of the server, the page's slider may be newer than the address, so a plain number
        # must not replace its value.
        if value is not None and not _is_plain_number(st.query_params[parameter.name]):
            st.session_state.setdefault(parameter.name, value)
        return sentence
    if sentence:
        del st.query_params[parameter.name]
    elif value is not None:
        st.session_state[parameter.name] = value
        # Scripts of the page read the address, too.
        [text] = _texts(parameter)
        if st.query_params[parameter.name] != text:
            st.query_params[parameter.name] = text
    elif use_default:
        st.session_state[parameter.name] = parameter.default
    return sentence


def _remove_others(parameters: Iterable[URLParameter]) -> None:
    """Remove all parameters that the current page does not have, except for those that Streamlit manages itself."""
    bound = st.session_state.setdefault(_BOUND, set())
    names = {parameter.name for parameter in parameters}
    for name in set(st.query_params) - names - bound:
        del st.query_params[name]
    bound.update(parameter.name for parameter in parameters if parameter.is_bound)


def current_page() -> str:
    """Return Streamlit's id of the page of this run; in a callback, already of the page that is about to be drawn."""
    # In a callback, `st.context.url` may be the address of the last page.
    context = get_script_run_ctx()
    return context.page_script_hash if context else ""


def _is_history_navigation() -> bool:
    """Return whether the user pressed the back or forward button. Then the address overrides the session state."""
    # Streamlit documents this function, but only for threads. There is no documented way to detect the back button.
    context = get_script_run_ctx()
    return context is not None and context.is_history_navigation
