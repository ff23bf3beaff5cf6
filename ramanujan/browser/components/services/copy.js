// Copies a formula as its LaTeX. KaTeX writes each formula twice into the page, as HTML and as MathML, and a plain copy
// contains both.

import { dom } from "../../streamlit_dom.js";

const IS_PLAIN = /^[^\\{}^_&]*$/;
const COLOR = /\\textcolor\{#\w+\}/g; // KaTeX's own command, not standard LaTeX

/** Copy a selection that contains formulas. */
export default function copy(event) {
  const selection = getSelection();
  if (event.defaultPrevented || selection.isCollapsed || !selection.rangeCount) return;
  const range = selection.getRangeAt(0).cloneRange();
  // Extend the selection to whole formulas.
  const [first, last] = [range.startContainer, range.endContainer].map(dom.formulaOf);
  if (first) range.setStartBefore(first);
  if (last) range.setEndAfter(last);
  const copied = document.createElement("div");
  copied.append(range.cloneContents());
  const formulas = dom.formulas(copied);
  if (!formulas.length) return;
  for (const formula of formulas) formula.replaceWith(asText(dom.source(formula)));
  // innerText contains line breaks only for an element with a layout.
  Object.assign(copied.style, { position: "fixed", opacity: 0 });
  document.body.append(copied);
  event.clipboardData.setData("text/plain", copied.innerText);
  event.clipboardData.setData("text/html", copied.innerHTML);
  copied.remove();
  event.preventDefault();
}

/** Return a formula as text: plain if its LaTeX is plain, otherwise between dollar signs, as in LaTeX and Markdown. */
function asText({ latex, isDisplayed }) {
  const text = latex.replace(COLOR, "");
  if (IS_PLAIN.test(text)) return text;
  return isDisplayed ? `$$${text}$$` : `$${text}$`;
}
