"""The parameters of the app's URLs, which are validated before any widget is drawn.

A page declares its own parameters as `URL_PARAMETERS`; `parameters` declares those of every page. `read_once` reads the
address when a page is opened. It copies valid values to the session state, where widgets read them. It removes invalid
values, with a message for each. `update` writes the values of widgets into the address. An option is written as its id.

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
"""URL parameters that contain a lecturer's key, or identify a browser in a frame. *Copy link* omits them."""

UNKNOWN = _("The address contains a setting that this page does not know. It was ignored.")
"""Message about a parameter of no page."""

_LOCAL_HOSTS = ("localhost", "127.0.0.1", "::1")
_ALL_INTERFACES = (None, "", "0.0.0.0", "::")
"""Values of Streamlit's option `server.address` for which the app listens in every network of its computer."""
_DISTANT_ADDRESS = ("198.51.100.1", 9)
"""An address and port outside of every network, reserved for documentation."""

_LAST_PAGE = "address_page"
"""Session state: name of the page for which the address was last read."""
_KNOWN = "address_met"
"""Session state: URL parameter of a page opened in this session → whether Streamlit binds it."""
_WARNED = "address_warned"
"""Session state: whether the message `UNKNOWN` was shown."""
_MOST_LISTED = 8
"""Largest number of options in a message."""
_PUNCTUATION = " \t\n\u00a0\u202f.,;:!?…()[]{}<>«»‹›\"'`“”„‟‘’‚‛*|"
"""Characters that surround a link in a sentence, and that a visitor may copy together with the link."""


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

    def tidy(self, text: str) -> str:
        """Remove surrounding punctuation, if the text is invalid with it and valid without it."""
        if self._fits(text):
            return text
        stripped = strip_punctuation(text)
        return stripped if self._fits(stripped) else text

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

    def message(self) -> str:
        """Return the message for an invalid text. It contains the options, or the first few of many."""
        texts = list(map(str, self.options))
        listed = ", ".join(texts[:_MOST_LISTED])
        omitted = len(texts) - _MOST_LISTED
        if omitted > 0:
            listed = _("{few} and {more} more").format(few=listed, more=omitted)
        return self.template.format(name=self.name, options=listed)


@dataclass(frozen=True)
class Several(Choice):
    """Any number of options in any order, separated by commas."""

    default: tuple[str, ...] = ()
    template = _(
        "The value of {name} in the address was ignored: it must be one or more of these, with commas between them: "
        "{options}."
    )

    def read(self, text: str) -> tuple[str, ...]:
        """Return the options without repetitions. Raise `ValueError` if an option does not exist."""
        # A dictionary removes repetitions and preserves the order.
        values = dict.fromkeys(part.strip() for part in text.split(","))
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


def strip_punctuation(text: str) -> str:
    """Return a text without the brackets, quotation marks, full stops and spaces around it."""
    return text.strip(_PUNCTUATION)


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
    known = st.session_state.setdefault(_KNOWN, {})
    messages += _remove_unknown({parameter.name for parameter in parameters}, known)
    known.update({parameter.name: parameter.is_bound for parameter in parameters})
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
            if not has_valid_value(parameter):
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
    host = _network_host()
    # Another port belongs to a proxy or a tunnel, which may not be reachable at this host.
    if host is None or url.port != st.get_option("server.port"):
        return url
    return url._replace(netloc=f"{host}:{url.port}")


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


def has_valid_value(parameter: URLParameter) -> bool:
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


def _copy_to_session(parameter: URLParameter, use_default: bool) -> str | None:
    """Copy a value from the address to the session state; remove an invalid value and return a message.

    If the address does not contain the parameter, `use_default` copies the default instead.
    """
    value, sentence = _read(parameter)
    # A bound slider reads a valid value and removes an invalid one itself.
    if parameter.is_bound:
        return sentence
    if sentence:
        del st.query_params[parameter.name]
    elif value is not None:
        st.session_state[parameter.name] = value
    elif use_default:
        st.session_state[parameter.name] = parameter.default
    return sentence


def _remove_unknown(names: Iterable[str], known: Mapping[str, bool]) -> list[str]:
    """Remove the parameters of previous pages; return a message if there are parameters of no page.

    Parameters
    ----------
    names : names of the current page's parameters
    known : name → whether Streamlit binds it, for the parameters of previous pages
    """
    others = set(st.query_params).difference(names)
    for name in others & known.keys():
        # Streamlit itself manages the parameters that it binds to widgets.
        if not known[name]:
            del st.query_params[name]
    if not others - known.keys() or st.session_state.get(_WARNED):
        return []
    st.session_state[_WARNED] = True
    return [UNKNOWN]


def _is_history_navigation() -> bool:
    """Return whether the user pressed the back or forward button. Then the address overrides the session state."""
    # Streamlit documents this function, but only for threads. There is no documented way to detect the back button.
    context = get_script_run_ctx()
    return context is not None and context.is_history_navigation
