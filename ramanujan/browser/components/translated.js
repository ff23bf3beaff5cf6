// Updates a page that the browser has translated. The translators of Chrome and Edge replace each text by a <font>. React still
// changes its own text, which is no longer on the page. So the old translation would remain. Here a changed text replaces its
// translation, and the translator translates it again.

import { observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const translations = new WeakMap(); // a text, or an earlier translation → the <font> that replaced it

function restore(text) {
  if (text.isConnected) return;
  let font = translations.get(text);
  while (font && !font.isConnected) font = translations.get(font);
  font?.replaceWith(text);
}

const changes = new MutationObserver((records) => records.forEach(({ target }) => restore(target)));

function recordTranslation({ removedNodes, addedNodes, previousSibling, nextSibling }) {
  const font = [...addedNodes, previousSibling, nextSibling].find((node) => node?.nodeName === "FONT");
  if (!font) return;
  for (const node of removedNodes) {
    if (node.nodeName !== "FONT" && node.nodeType !== Node.TEXT_NODE) continue;
    translations.set(node, font);
    changes.observe(node, { characterData: true });
  }
}

// React removes a text, or inserts before it, without checking its parent.
for (const method of ["removeChild", "insertBefore"]) {
  const original = Node.prototype[method];
  Node.prototype[method] = function (...nodes) {
    const text = nodes.at(-1);
    if (text && text.parentNode !== this && translations.has(text)) restore(text);
    return original.apply(this, nodes);
  };
}

export default function (component, signal) {
  const update = (records) => {
    dom.keepFromTranslation();
    records.forEach(recordTranslation);
  };
  observe(document.body, { childList: true, subtree: true }, update, signal);
  dom.keepFromTranslation();
}
