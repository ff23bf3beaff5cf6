// Updates a page that the browser has translated. The translators of Chrome and Edge replace each text by a <font>.
// React still changes its own text, which is no longer on the page. So the old translation would remain. Here a changed
// text replaces its translation, and the translator translates it again.

import { observe } from "../../lasting.js";
import { dom } from "../../streamlit_dom.js";

const translations = new WeakMap(); // a text → the <font> that replaced it

function restore(text) {
  if (!text.isConnected) translations.get(text)?.replaceWith(text);
}

const changes = new MutationObserver((records) => records.forEach(({ target }) => restore(target)));

function recordTranslation({ removedNodes, addedNodes, previousSibling, nextSibling }) {
  const font = [...addedNodes, previousSibling, nextSibling].find((node) => node?.nodeName === "FONT");
  for (const text of font ? removedNodes : []) {
    translations.set(text, font);
    changes.observe(text, { characterData: true });
  }
}

// React removes a text, or inserts before it, without checking its parent.
for (const method of ["removeChild", "insertBefore"]) {
  const original = Node.prototype[method];
  Node.prototype[method] = function (...nodes) {
    if (translations.has(nodes.at(-1))) restore(nodes.at(-1));
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
