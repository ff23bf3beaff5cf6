// Copies a formula once, as its LaTeX: KaTeX's page holds each formula twice, for the eye and for screen readers.

import { dom } from "./streamlit_dom.js";

const IS_PLAIN = /^[^\\{}^_&]*$/;
const COLOR = /\\textcolor\{#\w+\}/g; // the page's own, and not LaTeX

/** Copy a selection that contains formulas. */
export default function copy(event) {
  const selection = getSelection();
  if (event.defaultPrevented || selection.isCollapsed || !selection.rangeCount) return;
  const range = selection.getRangeAt(0).cloneRange();
  // A selection that cuts a formula takes all of it.
  const [first, last] = [range.startContainer, range.endContainer].map(dom.formulaOf);
  if (first) range.setStartBefore(first);
  if (last) range.setEndAfter(last);
  const holder = document.createElement("div");
  holder.append(range.cloneContents());
  const formulas = dom.formulas(holder);
  if (!formulas.length) return;
  for (const formula of formulas) formula.replaceWith(written(dom.source(formula)));
  // Only what is laid out has lines.
  Object.assign(holder.style, { position: "fixed", opacity: 0 });
  document.body.append(holder);
  event.clipboardData.setData("text/plain", holder.innerText);
  event.clipboardData.setData("text/html", holder.innerHTML);
  holder.remove();
  event.preventDefault();
}

/** A formula as text: plain where its LaTeX is plain, otherwise between the dollars that LaTeX and Markdown read. */
function written({ latex, isDisplayed }) {
  const text = latex.replace(COLOR, "");
  if (IS_PLAIN.test(text)) return text;
  return isDisplayed ? `$$${text}$$` : `$${text}$`;
}
