"""A button that copies the address of the page: everything that is set stands in it."""

from __future__ import annotations

from functools import cache
from typing import Any

import streamlit as st

_HTML = (
    '<button type="button">Copy link</button> <output role="status"></output><input readonly hidden aria-label="Link">'
)
_CSS = """
button, input { font: inherit; color: inherit; background: none; padding: .35rem .75rem;
  border: 1px solid var(--st-widget-border-color); border-radius: var(--st-button-radius); }
:focus-visible { outline: 3px solid var(--st-primary-color); }
"""
# Browsers keep the clipboard from pages that are not served securely: there the text itself is offered.
_JS = """
export default ({ parentElement }) => {
  const [button, output, input] = parentElement.querySelectorAll("button, output, input");
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      output.textContent = "Copied.";
    } catch {
      output.textContent = "Copy it from here:";
      input.hidden = false;
      input.value = location.href;
      input.select();
    }
  };
};
"""


def link() -> Any:
    """Put the button on the page."""
    return _component()(key="link")


@cache
def _component() -> Any:
    return st.components.v2.component("ramanujan_link", html=_HTML, css=_CSS, js=_JS)
