"""The arrow keys of a lecture: after a click on a choice they go back to the page, where they turn the steps.

Without this the clicked choice keeps them, as it must for people who choose by keyboard.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

_JS = """
export default ({ data }) => {
  // Once for as long as the page is open: a run of the script draws this again and again.
  if (globalThis.ramanujanKeys) return;
  globalThis.ramanujanKeys = true;
  // On the way down, since the choices keep their clicks to themselves.
  document.addEventListener("click", (event) => {
    // A click made by a key has no pointer, hence no detail: there the focus has to stay.
    if (!event.detail || !event.target.closest?.(data.choices)) return;
    // Not always the button that was clicked: a group gives the focus back to where it was before.
    setTimeout(() => document.activeElement.closest(data.choices) && document.activeElement.blur());
  }, true);
};
"""


def give_back(*keys: str) -> None:
    """Let the choices under these widget keys give the keyboard back when they are clicked."""
    _component()(key="keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)})


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_keys", js=_JS)
