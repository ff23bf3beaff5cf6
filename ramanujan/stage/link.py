"""A button that copies the address of the page: everything that is set stands in it."""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

_HTML = (
    '<button type="button">Copy link</button> <output role="status"></output><input readonly hidden aria-label="Link">'
)
_CSS = """
button { font: inherit; color: inherit; background: transparent; border: 1px solid var(--st-widget-border-color);
  border-radius: var(--st-button-radius); padding: .35rem .75rem; cursor: pointer; }
button:hover { border-color: var(--st-primary-color); }
button:focus-visible { outline: 3px solid var(--st-primary-color); outline-offset: 2px; }
input { width: 100%; margin-top: .4rem; box-sizing: border-box; font: inherit; }
"""
_JS = """
export default function ({ parentElement }) {
  const [button, output, input] = ["button", "output", "input"].map((name) => parentElement.querySelector(name));
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      output.textContent = "Copied.";
    } catch {
      // Browsers keep the clipboard from pages that are not served securely: offer the text itself.
      input.hidden = false;
      input.value = location.href;
      input.select();
      output.textContent = "Copy it from here:";
    }
    setTimeout(() => (output.textContent = ""), 4000);
  };
  return () => (button.onclick = null);
}
"""


def link() -> Any:
    """Put the button on the page."""
    return _component()(key="link")


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_link", html=_HTML, css=_CSS, js=_JS)
