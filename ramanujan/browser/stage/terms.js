// Links each body and its arrows to the terms of the same colour in the page's formulas. The pointer, a finger or the focus on
// one of them highlights the others.

import { dom } from "../components/streamlit_dom.js";
import { set } from "./svg.js";

const BODY_OF = { X: "block", x0: "spring", R: "top", shared: "hoop" }; // arrow → body, for arrows with another name

export function linkTerms(root, signal) {
  const [host, moving, marks] = [".stage", ".moving", ".coordinates"].map((each) => root.querySelector(each));
  const sheet = document.head.appendChild(document.createElement("style"));
  const bodies = new Map([...moving.querySelectorAll(".body, .coil")].map((node) => [node.classList[1], node]));
  const ink = (name) => getComputedStyle(bodies.get(name).querySelector(".form, .front")).stroke;
  let lit;

  function point(event) {
    const node = event.composedPath()[0], mark = node.dataset?.of, term = dom.term(node);
    const contains = (name) => (mark ? name === (BODY_OF[mark] ?? mark) : bodies.get(name).contains(node));
    const hasColor = (name) => ink(name) === term.style.color;
    const body = [...bodies.keys()].find(term ? hasColor : contains);
    if (body === lit || (!body && dom.isFormula(node))) return;
    lit = body;
    host.classList.toggle("one-lit", Boolean(lit));
    for (const each of moving.children) each.classList.toggle("lit", each === bodies.get(lit));
    for (const each of marks.children) each.classList.toggle("lit", (BODY_OF[each.dataset.of] ?? each.dataset.of) === lit);
    sheet.textContent = lit ? dom.termRule(ink(lit)) : "";
  }

  for (const node of bodies.values()) {
    node.removeAttribute("aria-hidden");
    set(node, { role: "img", tabindex: 0 });
  }
  for (const type of ["pointerover", "focusin"]) document.addEventListener(type, point, { signal });
  signal.addEventListener("abort", () => sheet.remove());
}
