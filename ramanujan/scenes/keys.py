"""The arrow keys of a lecture: after a click on a choice they go back to the page, where they turn the steps.

Without this the clicked choice keeps them, as it must for people who choose by keyboard.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

_JS = """
export default ({ data }) => {
  const release = (event) => {
    const choice = event.target.closest?.("button");
    // A click made by a key has no pointer, hence no detail: there the focus has to stay.
    if (event.detail && choice?.closest(data.choices)) setTimeout(() => choice.blur());
  };
  // On the way down: the choices keep their clicks to themselves.
  document.addEventListener("click", release, true);
  return () => document.removeEventListener("click", release, true);
};
"""


def give_back(*keys: str) -> None:
    """Let the choices under these widget keys give the keyboard back when they are clicked."""
    _component()(key="keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)})


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_keys", js=_JS)
