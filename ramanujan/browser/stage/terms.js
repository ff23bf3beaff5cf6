// Links each body, with the arrows that belong to it, to its terms in the page's formulas: they have its ink. What a pointer, a
// finger or the focus is on lights its partners.

import { dom } from "../components/streamlit_dom.js";
import { set } from "./svg.js";

const OF = { X: "block", x0: "spring", R: "top", shared: "hoop" }; // the bodies of arrows that are named otherwise

export function linkTerms(root, signal) {
  const [host, moving, marks] = [".stage", ".moving", ".coordinates"].map((each) => root.querySelector(each));
  const sheet = document.head.appendChild(document.createElement("style"));
  const bodies = new Map([...moving.querySelectorAll(".body, .coil")].map((node) => [node.classList[1], node]));
  const ink = (name) => getComputedStyle(bodies.get(name).querySelector(".form, .front")).stroke;
  let lit;

  function point(event) {
    const node = event.composedPath()[0], mark = node.dataset?.of, term = dom.term(node);
    const isOf = (name) => (mark ? name === (OF[mark] ?? mark) : bodies.get(name).contains(node));
    const has = (name) => ink(name) === term.style.color;
    const found = [...bodies.keys()].find(term ? has : isOf);
    if (found === lit || (!found && dom.isFormula(node))) return;
    lit = found;
    host.classList.toggle("one-lit", Boolean(lit));
    for (const each of moving.children) each.classList.toggle("lit", each === bodies.get(lit));
    for (const each of marks.children) each.classList.toggle("lit", (OF[each.dataset.of] ?? each.dataset.of) === lit);
    sheet.textContent = lit ? dom.termRule(ink(lit)) : "";
  }

  for (const node of bodies.values()) {
    node.removeAttribute("aria-hidden");
    set(node, { role: "img", tabindex: 0 });
  }
  for (const type of ["pointerover", "focusin"]) document.addEventListener(type, point, { signal });
  signal.addEventListener("abort", () => sheet.remove());
}
