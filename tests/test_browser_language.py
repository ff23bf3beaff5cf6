"""The app in its pseudo-language: no sentence was forgotten, and longer words are neither cut nor too wide."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from ramanujan.scenes.pages import PAGES
from tests.browser import ROOT, count_anew, listen, running, settle

UNTOUCHED = """(text) => /[a-z]{4}/.test(text) && !/[áéíóúýćńśźÁÉÍÓÚÝŚ⟦⟧·]/.test(text)"""
"""Whether a text has words, none of which gettext has seen: those would carry accents."""
STREAMLITS_OWN = (
    "Skip to main content",
    *(f"aria-label: {label}" for label in ("Sidebar", "Collapse sidebar", "App pages", "Link to heading")),
    *(f"aria-label: {label}" for label in ("Decrement", "Increment", "Copy to clipboard", "Fullscreen")),
    *(f"aria-label: {label}" for label in ("Download plot as a PNG", "Autoscale", "Reset axes")),
)
"""What Streamlit and Plotly say by themselves, in English always; no setting changes it."""
NAMES = ("float32", "float64", "Markdown")
"""Names of formats, the same in every language."""
ICONS = "[data-testid=stIconMaterial], [role=img][aria-label$=' icon']"
NO_WORDS = f"{ICONS}, .katex, code, pre, script, style, title, noscript, .xtick, .ytick"
FORGOTTEN = f"""() => {{
  const untouched = {UNTOUCHED}, found = new Set();
  const walk = (root) => {{
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {{
      const parent = node.parentElement, text = node.textContent.trim();
      if (!untouched(text) || parent?.closest("{NO_WORDS}")) continue;
      if (parent?.checkVisibility({{ visibilityProperty: true }}) !== false) found.add(text.slice(0, 80));
    }}
    for (const node of root.querySelectorAll("*")) {{
      if (node.shadowRoot) walk(node.shadowRoot);
      const label = node.getAttribute("aria-label") ?? "";
      if (untouched(label) && !node.closest("{NO_WORDS}")) found.add(`aria-label: ${{label.slice(0, 80)}}`);
    }}
  }};
  walk(document.body);
  return [...found];
}}"""
CUT = """() => {
  const found = [];
  const cut = (node) => {
    const style = getComputedStyle(node);
    const hides = ["hidden", "clip"].includes(style.overflowX) || style.textOverflow === "ellipsis";
    return hides && node.clientWidth > 1 && node.scrollWidth > node.clientWidth + 1 && node.innerText?.trim()
      && node.checkVisibility() && !node.closest(".katex, .js-plotly-plot, .rc-overflow");
  };
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      if (cut(node)) found.push(`${node.className}: ${node.innerText.slice(0, 60)}`);
    }
  };
  walk(document.body);
  const main = document.querySelector("[data-testid=stMain]");
  if (main.scrollWidth > main.clientWidth) found.push("the page scrolls sideways");
  return found;
}"""
"""What is wider than its place and does not scroll; Streamlit's bar of pages folds what does not fit into a menu."""

pytestmark = pytest.mark.xdist_group("browser test_browser_language")


@pytest.fixture(scope="module")
def page(profile: object) -> Iterator[object]:
    """A tab for the app that speaks the pseudo-language, with its address in `app`."""
    os.environ["RAMANUJAN_LANGUAGE"] = "pseudo"
    try:
        with running(ROOT / "app.py") as address:
            tab = profile.new_page()
            tab.app = address
            listen(tab)
            tab.emulate_media(reduced_motion="reduce")
            yield tab
            tab.close()
    finally:
        del os.environ["RAMANUJAN_LANGUAGE"]


@pytest.mark.parametrize("name", PAGES)
def test_no_sentence_was_forgotten_and_none_is_cut(page, name):
    page.set_viewport_size({"width": 1280, "height": 720})
    count_anew(page)
    page.goto(f"{page.app}/{PAGES[name].address}")
    page.wait_for_selector("[data-testid=stMainBlockContainer] h1")
    settle(page)
    assert "⟦" in page.locator("[data-testid=stMainBlockContainer]").inner_text()
    assert [text for text in page.evaluate(FORGOTTEN) if text not in (*STREAMLITS_OWN, *NAMES)] == []
    assert page.evaluate(CUT) == []
    page.set_viewport_size({"width": 390, "height": 844})
    settle(page)
    assert page.evaluate(CUT) == []
