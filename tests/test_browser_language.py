"""The app in its pseudo-language: no sentence or decimal comma was forgotten, and longer words are not cut or covered.

They fit a narrow phone, too, where nothing scrolls sideways.
"""

from collections.abc import Iterator

import pytest

from ramanujan.shell.navigation import PAGES
from tests.browser import ROOT, running, settle

UNTOUCHED = """(text) => /[a-z]{4}/.test(text) && !/[áéíóúýćńśźÁÉÍÓÚÝŚ⟪⟫·]/.test(text)"""
"""Whether a text has words, none of which gettext has seen: those would carry accents."""
SLIDERS = "[data-testid=stSlider]"
"""Streamlit's sliders write numbers as the browser's own language has them; all others have a decimal comma here."""
STREAMLITS_OWN = (
    "Skip to main content",
    *(f"{n} more" for n in (1, 2, 3)),
    *(f"aria-label: {label}" for label in ("Sidebar", "Collapse sidebar", "App pages", "Link to heading")),
    *(
        f"aria-label: {label}"
        for label in ("Expand sidebar", "Decrement", "Increment", "Copy to clipboard", "Fullscreen")
    ),
    *(f"aria-label: {label}" for label in ("Download plot (SVG)", "Download plot (PNG)", "Autoscale", "Reset axes")),
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
      const point = /\\d\\.\\d/.test(text) && !parent?.closest("{SLIDERS}, script, style");
      if (!point && (!untouched(text) || parent?.closest("{NO_WORDS}"))) continue;
      if (parent?.checkVisibility({{ visibilityProperty: true }}) !== false) found.add(text.slice(0, 80));
    }}
    for (const node of root.querySelectorAll("*")) {{
      if (node.shadowRoot) walk(node.shadowRoot);
      const label = node.getAttribute("aria-label") ?? "";
      const point = /\\d\\.\\d/.test(label) && !node.closest("{SLIDERS}");
      if ((point || untouched(label)) && !node.closest("{NO_WORDS}")) found.add(`aria-label: ${{label.slice(0, 80)}}`);
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
OVERLAPS = """() => {
  const pieces = [], clips = new Map();
  const up = (node) => node.assignedSlot ?? node.parentElement ?? node.getRootNode().host;
  const main = document.querySelector("[data-testid=stMain]");
  // What an element shows of its content, and the layer that it lies on: a bar that is fixed covers what scrolls.
  const clip = (node) => {
    if (!node || node === document.body) return { left: -1e6, right: 1e6, top: -1e6, bottom: 1e6, layer: null };
    if (clips.has(node)) return clips.get(node);
    const style = getComputedStyle(node);
    let found = clip(up(node));
    if (style.clipPath === "inset(50%)") found = { ...found, right: -1e6 }; // for a screen reader alone
    if (["fixed", "sticky"].includes(style.position)) found = { ...clip(document.body), layer: node };
    if (style.overflow !== "visible" && style.display !== "inline" && !node.contains(main)) {
      const box = node.getBoundingClientRect();
      found = { ...found, left: Math.max(found.left, box.left), right: Math.min(found.right, box.right),
        top: Math.max(found.top, box.top), bottom: Math.min(found.bottom, box.bottom) };
    }
    clips.set(node, found);
    return found;
  };
  const add = (owner, box, text, parent) => {
    const seen = clip(parent), rest = 0.2 * box.height;
    const left = Math.max(box.left, seen.left), right = Math.min(box.right, seen.right);
    const top = Math.max(box.top + rest, seen.top), bottom = Math.min(box.bottom - rest, seen.bottom);
    if (right - left > 2 && bottom - top > 2) pieces.push({ owner, left, right, top, bottom, text, layer: seen.layer });
  };
  // A slanted text fills little of the box around it: it counts as small squares along its middle line.
  const boxes = (node) => {
    const { a, b, c, d, e, f } = node.getScreenCTM(), box = node.getBBox();
    if (Math.abs(a * b) < 0.01) return [node.getBoundingClientRect()];
    const side = box.height * Math.hypot(a, b), count = Math.max(1, Math.floor(box.width / box.height));
    return Array.from({ length: count }, (_, index) => {
      const x = box.x + ((index + 0.5) * box.width) / count, y = box.y + box.height / 2;
      return new DOMRect(a * x + c * y + e - 0.3 * side, b * x + d * y + f - side / 2, 0.6 * side, side);
    });
  };
  const shown = (node) => node?.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const walk = (root) => {
    for (const node of root.querySelectorAll("svg text")) {
      const text = node.textContent.trim();
      if (text && shown(node)) for (const box of boxes(node)) add(node, box, text, node.parentElement);
    }
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT), range = document.createRange();
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const parent = node.parentElement, text = node.textContent.trim();
      if (!text || parent?.closest("svg, .katex, script, style, noscript") || !shown(parent)) continue;
      range.selectNodeContents(node);
      for (const box of range.getClientRects()) add(node, box, text, parent);
    }
    for (const node of root.querySelectorAll("*")) if (node.shadowRoot) walk(node.shadowRoot);
  };
  walk(document.body);
  const found = new Set();
  pieces.sort((one, other) => one.top - other.top);
  pieces.forEach((one, index) => {
    for (const other of pieces.slice(index + 1)) {
      if (other.top > one.bottom - 2) break;
      const wide = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      if (wide > 2 && one.owner !== other.owner && one.layer === other.layer)
        found.add(`${one.text.slice(0, 40)} × ${other.text.slice(0, 40)}`);
    }
  });
  return [...found];
}"""
"""Pieces of text that lie on one another; of a line's height the middle three fifths count."""
COVER = """() => {
  const [h1, tick] = [document.querySelector("h1"), document.querySelector(".js-plotly-plot svg .xtick text")];
  h1.insertAdjacentHTML("afterend", "<div style='position:relative;height:0;top:-3rem;margin:0'>over the title</div>");
  if (tick) tick.parentElement.appendChild(tick.cloneNode()).textContent = "over a tick";
  return tick ? ["over the title", "over a tick"] : ["over the title"];
}"""
"""Puts a text over the title, and one over a figure's tick; returns them."""


SMALL = """() => [...document.querySelectorAll("main button, [data-testid=stSidebarNavLink]")]
  .filter((node) => node.offsetParent && node.tabIndex >= 0)
  .filter((node) => !node.closest(".modebar, .stTooltipIcon, [role=tablist]"))
  .filter((node) => node.getBoundingClientRect().height < 43.5).map((node) => node.outerHTML.slice(0, 160))"""
"""What a finger could miss."""
WIDTHS = (
    """[document.documentElement, document.querySelector("[data-testid=stMain]")].map((each) => each.scrollWidth)"""
)
ADDRESSES = {name: page.address for name, page in PAGES.items()}
ADDRESSES["taxicab"] += "?p=1000&q=999&digits=1000&left=sphere"
"""Name of a page → its address, with the longest numbers."""


@pytest.fixture
def pseudo(monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """The address of an app that speaks the pseudo-language."""
    monkeypatch.setenv("RAMANUJAN_LANGUAGE", "pseudo")
    with running(ROOT / "app.py") as address:
        yield address


def test_no_sentence_was_forgotten_and_longer_words_fit_on_a_screen_and_on_a_narrow_phone(visit, pseudo):
    page = None
    for address in ADDRESSES.values():
        page = visit(address, network=pseudo, tab=page)
        assert "⟪" in page.locator("[data-testid=stMainBlockContainer]").inner_text()
        assert page.locator("html").get_attribute("lang") == "pseudo"
        assert [text for text in page.evaluate(FORGOTTEN) if text not in (*STREAMLITS_OWN, *NAMES)] == []
        check_fit(page)
        client = page.context.new_cdp_session(page)
        become_phone(client, 390, 844)
        settle(page)
        check_fit(page)
        become_phone(client, 320, 640)
        check_narrow(page)
        # Negative control: a text that is put over another one is found.
        covers = page.evaluate(COVER)
        found = page.evaluate(OVERLAPS)
        assert all(any(cover in pair for pair in found) for cover in covers), found
        client.detach()


def become_phone(client, width: int, height: int) -> None:
    """Make a tab as large as a phone's screen, and touched."""
    size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": True}
    client.send("Emulation.setDeviceMetricsOverride", size)
    client.send("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 5})


def check_fit(page) -> None:
    """Check that nothing is cut, and that no text lies on another one."""
    assert page.evaluate(CUT) == []
    assert page.evaluate(OVERLAPS) == []


def check_narrow(page) -> None:
    """Check that under every tab nothing scrolls sideways down to 320 px, and nothing is too small for a finger."""
    for tab in page.get_by_role("tab").all() or [page.locator("h1")]:
        tab.click()
        settle(page)
        assert max(page.evaluate(WIDTHS)) <= 320
        assert page.evaluate(SMALL) == []
