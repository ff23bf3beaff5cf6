"""Mount a component that sends values to the server, and validate these values."""

import sys
from collections.abc import Callable, Mapping
from typing import Any

import streamlit as st

from ramanujan.browser import modules


def mount(
    name: str, key: str, data: Mapping[str, Any], event: str, on_value: Callable[[Any], None], type_example: Any
) -> Any:
    """Put a component on the page that sends values to the server.

    Parameters
    ----------
    name : name of the component's module
    key : Streamlit's key of the element
    data : data of the component
    event : name of the component's trigger or state
    on_value : called with each value of the example's type. Any other value is ignored.
    type_example : an example of a value, which determines the type
    """

    def receive() -> None:
        value = getattr(st.session_state.get(key), event, None)
        if has_type_of(value, type_example):
            on_value(value)

    return modules.component(name)(key=key, data=data, **{f"on_{event}_change": receive})


def has_type_of(value: Any, example: Any) -> bool:
    """Return whether a value has the type of an example.

    A whole number is also accepted for a float. Infinity, NaN and numbers beyond the largest float are not.

    >>> has_type_of(1, 0.5), has_type_of(10**400, 0.5), has_type_of(True, 0.5)
    (True, False, False)
    """
    if isinstance(example, dict):
        return isinstance(value, dict) and all(has_type_of(value.get(name), part) for name, part in example.items())
    if isinstance(value, bool):
        return False
    if isinstance(example, float) and isinstance(value, int | float):
        return abs(value) <= sys.float_info.max
    return isinstance(value, type(example))
