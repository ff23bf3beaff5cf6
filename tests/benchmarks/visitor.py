"""A client of Streamlit's websocket protocol, which behaves like a page in a browser, including the message cache.

The client caches large messages, and sends the hashes of all cached messages with each request. The server then sends
the hash instead of a message. The client removes a message that has not been used for `max_cached_message_age` runs.
"""

import asyncio
import random
from dataclasses import dataclass, field
from time import perf_counter
from urllib.parse import parse_qsl, urlencode, urlsplit

import websockets
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.Element_pb2 import Element
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg
from streamlit.proto.NumberInput_pb2 import NumberInput
from streamlit.proto.Radio_pb2 import Radio
from streamlit.proto.Slider_pb2 import Slider
from streamlit.proto.WidgetStates_pb2 import WidgetState

TIMEOUT = 60.0
"""Timeout of an answer [s]."""

_LARGEST_MESSAGE = 2**24


class VisitError(Exception):
    """An error of the connection, of the protocol, or on the page."""


@dataclass
class Visitor:
    """One open page.

    address : address of the server, for example http://127.0.0.1:8501
    page : path of the page, optionally with a query, for example "motion?figure=Energy"
    received, sent : number of bytes
    messages : number of received messages
    runs : number of finished runs
    cache : hash of a cached message → value of `runs` when it was last used
    """

    address: str
    page: str = ""
    received: int = 0
    sent: int = 0
    messages: int = 0
    runs: int = 0
    widgets: dict[str, WidgetState] = field(default_factory=dict)
    sliders: dict[str, Slider] = field(default_factory=dict)
    buttons: set[str] = field(default_factory=set)
    radios: dict[str, Radio] = field(default_factory=dict)
    fragment: str = ""
    cache: dict[str, int] = field(default_factory=dict)

    async def open(self) -> float:
        """Open the page and return the seconds until its first run has ended."""
        path, _, query = self.page.partition("?")
        self.path, self.query = path, dict(parse_qsl(query))
        self.script_hash, self.max_age, self.new_session = "", 2, False
        start = perf_counter()
        cookie = await _cookie(self.address)
        host = urlsplit(self.address).netloc
        self.socket = await websockets.connect(
            f"ws://{host}/_stcore/stream",
            subprotocols=["streamlit"],
            additional_headers={"Cookie": cookie} if cookie else {},
            compression=None,
            max_size=_LARGEST_MESSAGE,
            open_timeout=TIMEOUT,
            ping_interval=None,
        )
        await self._request_run()
        await self._wait_for_end()
        seconds = perf_counter() - start
        if not path:  # the first page requests the rest when its machine moves
            await self._request_run()
            await self._wait_for_end()
        return seconds

    async def close(self) -> None:
        """Close the connection."""
        await self.socket.close()

    async def move(self, key: str, chance: random.Random) -> float:
        """Set the slider with this widget key to a random step; return the seconds until the answer."""
        identifier, slider = next(
            ((name, slider) for name, slider in self.sliders.items() if name.endswith(f"-{key}")), (None, None)
        )
        if slider is None:
            raise VisitError(f"the page has no slider {key}")
        steps = round((slider.max - slider.min) / slider.step)
        value = round(slider.min + chance.randint(0, steps) * slider.step, 10)
        self.widgets[identifier].double_array_value.data[:] = [value]
        # A bound slider writes its value into the URL, unless it is the default.
        self.query[key] = f"{value:g}"
        if value == slider.default[0]:
            del self.query[key]
        start = perf_counter()
        await self._request_run()
        await self._wait_for_end()
        return perf_counter() - start

    async def press(self, key: str, timeout: float) -> float:
        """Press the button with this widget key; return the seconds until the run has ended."""
        identifier = next((name for name in self.buttons if name.endswith(f"-{key}")), None)
        if identifier is None:
            raise VisitError(f"the page has no button {key}")
        start = perf_counter()
        await self._request_run(WidgetState(id=identifier, trigger_value=True))
        await self._wait_for_end(timeout)
        return perf_counter() - start

    async def choose(self, number: int) -> float:
        """Choose an option of the last radio on the page; return the seconds until the answer."""
        identifier, radio = list(self.radios.items())[-1]
        self.widgets[identifier] = WidgetState(id=identifier, string_value=radio.options[number])
        return await self.poll()

    async def poll(self) -> float:
        """Run the fragment that repeats every few seconds; return the seconds until the answer."""
        start = perf_counter()
        await self._request_run(fragment=self.fragment)
        await self._wait_for_end()
        return perf_counter() - start

    async def _request_run(self, *pressed: WidgetState, fragment: str = "") -> None:
        request = BackMsg()
        state = request.rerun_script
        state.fragment_id = fragment
        state.query_string = urlencode(self.query)
        state.page_script_hash = self.script_hash
        state.page_name = "" if self.script_hash else self.path
        state.widget_states.widgets.extend([*self.widgets.values(), *pressed])
        state.cached_message_hashes.extend(self.cache)
        state.context_info.url = f"{self.address}/{self.path}"
        state.context_info.timezone, state.context_info.locale = "UTC", "en-US"
        state.context_info.color_scheme = "light"
        self.new_session = False
        data = request.SerializeToString()
        self.sent += len(data)
        await self.socket.send(data)

    async def _wait_for_end(self, timeout: float = TIMEOUT) -> None:
        """Receive messages until a run has ended that began after the request."""
        try:
            async with asyncio.timeout(timeout):
                while not self._receive(await self.socket.recv()):
                    pass
        except TimeoutError:
            raise VisitError("no answer") from None
        except websockets.ConnectionClosed as closed:
            raise VisitError(f"the connection was closed: {closed}") from None

    def _receive(self, data: bytes) -> bool:
        """Process one message; return whether it ends a run."""
        self.received += len(data)
        self.messages += 1
        message = ForwardMsg.FromString(data)
        kind = message.WhichOneof("type")
        if kind == "ref_hash":
            if message.ref_hash not in self.cache:
                raise VisitError("a message that the page no longer keeps")
            self.cache[message.ref_hash] = self.runs
        elif message.metadata.cacheable:
            self.cache[message.hash] = self.runs
        if kind == "delta" and message.delta.WhichOneof("type") == "new_element":
            self._receive_element(message.delta.new_element)
        elif kind == "auto_rerun":
            self.fragment = message.auto_rerun.fragment_id
        elif kind == "navigation":
            self.script_hash = message.navigation.page_script_hash
        elif kind == "new_session":
            self.new_session = True
            self.max_age = message.new_session.config.max_cached_message_age
        elif kind == "script_finished":
            return self._end_of_run(message.script_finished)
        return False

    def _end_of_run(self, status: int) -> bool:
        if status == ForwardMsg.FINISHED_WITH_COMPILE_ERROR:
            raise VisitError("the script does not compile")
        if status == ForwardMsg.FINISHED_EARLY_FOR_RERUN or not self.new_session:
            return False
        self.runs += 1
        self.cache = {name: seen for name, seen in self.cache.items() if self.runs - seen <= self.max_age}
        return True

    def _receive_element(self, element: Element) -> None:
        kind = element.WhichOneof("type")
        if kind == "exception":
            raise VisitError(f"{element.exception.type}: {element.exception.message}")
        widget = getattr(element, kind)
        if kind == "slider" and widget.type != Slider.SELECT_SLIDER:
            self.sliders[widget.id] = widget
        if kind == "radio":
            self.radios[widget.id] = widget
        if kind == "button":
            self.buttons.add(widget.id)
        if kind in _STATES and (widget.id not in self.widgets or getattr(widget, "set_value", False)):
            state = WidgetState(id=widget.id)
            _STATES[kind](widget, state)
            self.widgets[widget.id] = state


def _slider(widget: Slider, state: WidgetState) -> None:
    if widget.type == Slider.SELECT_SLIDER:
        default = (widget.options[int(value)] for value in widget.default)
        state.string_array_value.data.extend(widget.raw_value if widget.set_value else default)
    else:
        state.double_array_value.data.extend(widget.value if widget.set_value else widget.default)


def _number(widget: NumberInput, state: WidgetState) -> None:
    value = widget.value if widget.set_value else widget.default
    if widget.data_type == NumberInput.INT:
        state.int_value = int(value)
    else:
        state.double_value = value


def _group(widget: object, state: WidgetState) -> None:
    state.string_array_value.SetInParent()
    default = (widget.options[index].content for index in widget.default)
    state.string_array_value.data.extend(widget.raw_values if widget.set_value else default)


def _text(widget: object, state: WidgetState) -> None:
    state.string_value = widget.value if widget.set_value else widget.default


def _choice(widget: object, state: WidgetState) -> None:
    state.string_value = widget.raw_value if widget.set_value else widget.options[widget.default]


def _checkbox(widget: object, state: WidgetState) -> None:
    state.bool_value = widget.value if widget.set_value else widget.default


_STATES = {
    "slider": _slider,
    "number_input": _number,
    "button_group": _group,
    "text_input": _text,
    "selectbox": _choice,
    "checkbox": _checkbox,
}
"""Type of an element → a function that writes the value of the widget into its `WidgetState`."""


async def _cookie(address: str) -> str:
    """Request the HTML page, as a browser does first, and return its cookies."""
    parts = urlsplit(address)
    reader, writer = await asyncio.open_connection(parts.hostname, parts.port)
    writer.write(f"GET / HTTP/1.1\r\nHost: {parts.netloc}\r\nConnection: close\r\n\r\n".encode())
    head = (await reader.readuntil(b"\r\n\r\n")).decode("latin-1")
    writer.close()
    lines = (line.partition(":") for line in head.split("\r\n"))
    cookies = (value.strip() for name, _, value in lines if name.lower() == "set-cookie")
    return "; ".join(cookie.partition(";")[0] for cookie in cookies)
