"""Checks the widget states that a page sends, before Streamlit reads them.

A browser sends what the widget on its page holds. Whoever writes to the server without one can send anything, and
Streamlit would then read a text where a number belongs: every run of that session ends with an exception in the log.
Such a state is left out, and the widget stays as it was.
"""

import json
from typing import Any

from google.protobuf.message import DecodeError
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg
from streamlit.proto.NumberInput_pb2 import NumberInput
from streamlit.proto.Slider_pb2 import Slider
from streamlit.proto.WidgetStates_pb2 import WidgetState

_HOLDS = {
    "bidi_component": "json_value",
    "button": "trigger_value",
    "button_group": "string_array_value",
    "checkbox": "bool_value",
    "download_button": "trigger_value",
    "multiselect": "string_array_value",
    "number_input": "double_value",
    "plotly_chart": "string_value",
    "radio": "string_value",
    "selectbox": "string_value",
    "slider": "double_array_value",
    "text_input": "string_value",
}
"""Kind of widget → the field of its state."""
_EVENTS = "__events"
"""End of the id under which Streamlit takes a component’s events."""
_MOST = 20_000
"""Widgets that are remembered; all pages together have some hundreds."""


class CheckedStates:
    """Middleware that leaves out the states that no widget can have."""

    def __init__(self, app: Any) -> None:
        self.app = app
        self._fields: dict[str, str] = {}
        """Widget’s id → the field of its state, as the pages that were sent out say; ids are the same for everybody."""

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        if scope["type"] != "websocket":
            await self.app(scope, receive, send)
            return

        async def checked() -> dict[str, Any]:
            message = await receive()
            if data := message.get("bytes"):
                message = {**message, "bytes": self._check(data)}
            return message

        async def noted(message: dict[str, Any]) -> None:
            if b"$$ID-" in (message.get("bytes") or b""):
                self._note(ForwardMsg.FromString(message["bytes"]).delta)
            await send(message)

        await self.app(scope, checked, noted)

    def _note(self, delta: Any) -> None:
        """Remember which field the widget of a message has, if the message draws one."""
        kind = delta.new_element.WhichOneof("type")
        if kind not in _HOLDS:
            return
        widget, field = getattr(delta.new_element, kind), _HOLDS[kind]
        if kind == "slider" and widget.type == Slider.SELECT_SLIDER:
            field = "string_array_value"
        elif kind == "number_input" and widget.data_type == NumberInput.INT:
            field = "int_value"
        if len(self._fields) >= _MOST:
            self._fields.clear()
        self._fields[widget.id] = field

    def _check(self, data: bytes) -> bytes:
        """Return a page's message without the states that do not fit."""
        try:
            asked = BackMsg.FromString(data)
        except DecodeError:
            return data  # Streamlit closes the connection
        states = asked.rerun_script.widget_states.widgets
        kept = [state for state in states if self._fits(state)]
        if len(kept) == len(states):
            return data
        del states[:]
        states.extend(kept)
        return asked.SerializeToString()

    def _fits(self, state: WidgetState) -> bool:
        """Tell whether a state may be that of its widget; an unknown widget may have any."""
        field = state.WhichOneof("value")
        expected = "json_trigger_value" if state.id.endswith(_EVENTS) else self._fields.get(state.id, field)
        if field in ("json_value", "json_trigger_value"):
            try:
                held = json.loads(getattr(state, field))
            except (ValueError, RecursionError):
                return False
            if field == "json_value" and not isinstance(held, dict):
                return False
        return field in (None, expected)
