// Translates the page as Chrome and Edge do: it replaces each text, also later ones, by a <font>. The translation
// consists of capital letters. As in Chrome, shadow trees are not translated.
() => {
  const EXCLUDED = "script, style, textarea, svg, [translate=no], .notranslate, font";
  const translate = (node) => {
    if (!node.isConnected) return;
    if (node.nodeType === Node.ELEMENT_NODE) {
      const walker = document.createTreeWalker(node, NodeFilter.SHOW_TEXT), texts = [];
      while (walker.nextNode()) texts.push(walker.currentNode);
      texts.forEach(translate);
    } else if (node.nodeType === Node.TEXT_NODE && node.data.trim() && !node.parentElement.closest(EXCLUDED)) {
      const outer = document.createElement("font"), inner = document.createElement("font");
      inner.textContent = node.data.toUpperCase();
      outer.append(inner);
      node.replaceWith(outer);
    }
  };
  translate(document.body);
  // A translator reacts some time after a change.
  new MutationObserver((records) => {
    const changed = ({ addedNodes, target, type }) => (type === "characterData" ? target : [...addedNodes]);
    const nodes = records.flatMap(changed);
    setTimeout(() => nodes.forEach(translate), 50);
  }).observe(document.body, { childList: true, subtree: true, characterData: true });
}
