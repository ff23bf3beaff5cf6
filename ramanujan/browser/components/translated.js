// Keeps a page current that the browser has translated. Chrome's and Edge's translators put a <font> in the place of each text.
// React still changes and removes the text that it has drawn, which is no longer on the page: the old translation would stay.
// Here such a text replaces its translation as soon as it changes; the translator then translates it again.

import { observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const translations = new WeakMap(); // a text, or an earlier translation → the <font> in its place

function restore(text) {
  if (text.isConnected) return;
  let font = translations.get(text);
  while (font && !font.isConnected) font = translations.get(font);
  font?.replaceWith(text);
}

const changes = new MutationObserver((records) => records.forEach(({ target }) => restore(target)));

function note({ removedNodes, addedNodes, previousSibling, nextSibling }) {
  const font = [...addedNodes, previousSibling, nextSibling].find((node) => node?.nodeName === "FONT");
  if (!font) return;
  for (const node of removedNodes) {
    if (node.nodeName !== "FONT" && node.nodeType !== Node.TEXT_NODE) continue;
    translations.set(node, font);
    changes.observe(node, { characterData: true });
  }
}

// React removes a text, or inserts before it, without a look at where it is.
for (const method of ["removeChild", "insertBefore"]) {
  const act = Node.prototype[method];
  Node.prototype[method] = function (...nodes) {
    const text = nodes.at(-1);
    if (text && text.parentNode !== this && translations.has(text)) restore(text);
    return act.apply(this, nodes);
  };
}

export default function (component, signal) {
  const look = (records) => {
    dom.keepFromTranslation();
    records.forEach(note);
  };
  observe(document.body, { childList: true, subtree: true }, look, signal);
  dom.keepFromTranslation();
}
