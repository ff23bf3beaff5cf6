"""How far a reader has come in the lesson: in the address, and in the session while they look at another page."""

from __future__ import annotations

from collections.abc import Collection

import streamlit as st

from ramanujan import lesson
from ramanujan.scenes import links
from ramanujan.words import _

_CHOSEN = "chosen"


def kept(key: str, allowed: Collection[str], default: str) -> str:
    """Return what the address says of a key, else what was kept in this session, else the default; keep it."""
    text = st.query_params.get(key)
    value = text if text in allowed else st.session_state.get(f"lesson_{key}", default)
    keep(key, value)
    return value


def keep(key: str, value: str) -> None:
    """Keep a value in the address and in the session; an empty one is taken out of the address."""
    st.session_state[f"lesson_{key}"] = value
    if value and st.query_params.get(key) != value:
        st.query_params[key] = value
    if not value:
        st.query_params.pop(key, None)


def predictions() -> dict[str, str]:
    """Return stop → option of the predictions that have been made."""
    text = st.query_params.get(_CHOSEN) or ""
    made = _read(text)
    made = st.session_state.get(f"lesson_{_CHOSEN}_made", {}) if made is None or not text else made
    _keep(made)
    return made


def predict(stop: str, option: str | None) -> None:
    """Make a prediction, or take it back."""
    made = {name: chosen for name, chosen in predictions().items() if name != stop}
    _keep(made | ({stop: option} if option else {}))


def _keep(made: dict[str, str]) -> None:
    st.session_state[f"lesson_{_CHOSEN}_made"] = made
    keep(_CHOSEN, "~".join(f"{stop}.{option}" for stop, option in made.items()))


def _read(text: str) -> dict[str, str] | None:
    """Return the predictions that a text lists, such as block.opposite~radius.same; None if it is no such list."""
    made = {}
    for entry in text.split("~") if text else ():
        name, _dot, option = entry.partition(".")
        try:
            made[name] = lesson.stop(name).option(option).id
        except ValueError:
            return None
    return made


PREDICTIONS = links.Key(_CHOSEN, lambda text: _read(text) is not None, _("no list of predictions"))
"""What a link may say of the predictions."""
