// Texts and labels that have words, none of which gettext has seen: those would carry accents.
() => {
  const untouched = (text) => /[a-z]{4}/.test(text) && !/[áéíóúýćńśźÁÉÍÓÚÝŚ⟪⟫·]/.test(text), found = new Set();
  const walk = (root) => {
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const parent = node.parentElement, text = node.textContent.trim();
      const point = /\d\.\d/.test(text) && !parent?.closest("[data-testid=stSlider], script, style");
      if (!point && (!untouched(text) || parent?.closest("[data-testid=stIconMaterial], [role=img][aria-label$=' icon'], .katex, code, pre, script, style, title, noscript, .xtick, .ytick"))) continue;
      if (parent?.checkVisibility({ visibilityProperty: true }) !== false) found.add(text.slice(0, 80));
    }
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      const label = node.getAttribute("aria-label") ?? "";
      const point = /\d\.\d/.test(label) && !node.closest("[data-testid=stSlider]");
      if ((point || untouched(label)) && !node.closest("[data-testid=stIconMaterial], [role=img][aria-label$=' icon'], .katex, code, pre, script, style, title, noscript, .xtick, .ytick")) found.add(`aria-label: ${label.slice(0, 80)}`);
    }
  };
  walk(document.body);
  return [...found];
}
