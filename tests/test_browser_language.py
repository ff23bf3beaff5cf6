"""The app in its pseudo-language: no sentence was forgotten, and longer words are neither cut nor wider than the page."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from ramanujan.scenes.pages import PAGES
from tests.browser import ROOT, count_anew, listen, running, settle

FORGOTTEN = """() => {
  const found = [];
  const skipped = ".katex, code, pre, script, style, title, noscript, [data-testid=stTooltipContent], .js-plotly-plot .xtick, .js-plotly-plot .ytick";
  const walk = (root) => {
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const text = node.textContent.trim(), parent = node.parentElement;
      // A word that gettext has seen carries an accent; names, units and file types have none.
      if (!/[a-z]{4}/.test(text) || /[áéíóúýćńśźÁÉÍÓÚÝŚ⟦⟧·]/.test(text)) continue;
      if (parent?.closest(skipped) || parent?.checkVisibility?.({ opacityProperty: true, visibilityProperty: true }) === false) continue;
      found.push(text.slice(0, 80));
    }
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      const label = node.getAttribute("aria-label") ?? "";
      if (/[a-z]{4}/.test(label) && !/[áéíóúýćńśźÁÉÍÓÚÝŚ⟦⟧·]/.test(label) && !node.closest(skipped)) found.push(`aria-label ${label.slice(0, 80)}`);
    }
  };
  walk(document.body);
  return [...new Set(found)];
}"""
CUT = """() => {
  const found = [];
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      const style = getComputedStyle(node);
      const hides = ["hidden", "clip"].includes(style.overflowX) || style.textOverflow === "ellipsis";
      if (!hides || node.clientWidth < 2 || node.scrollWidth <= node.clientWidth + 1 || !node.innerText?.trim()) continue;
      if (node.checkVisibility() && !node.closest(".katex, .js-plotly-plot")) found.push(`${node.className}: ${node.innerText.slice(0, 60)}`);
    }
  };
  walk(document.body);
  const main = document.querySelector("[data-testid=stMain]");
  if (main.scrollWidth > main.clientWidth) found.push("the page scrolls sideways");
  return found;
}"""
"""What is wider than its place and does not scroll."""

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
    assert page.evaluate(FORGOTTEN) == []
    assert page.evaluate(CUT) == []
    page.set_viewport_size({"width": 390, "height": 844})
    settle(page)
    assert page.evaluate(CUT) == []
