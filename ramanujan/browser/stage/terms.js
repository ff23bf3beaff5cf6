// Links each body and its arrows to the terms of the same colour in the page's formulas. If the pointer, a finger or the focus is
// on a body, an arrow or a term, the others are highlighted.

import { dom } from "../components/streamlit_dom.js";
import { set } from "./svg.js";

const BODY_OF = { X: "block", x0: "spring", R: "top", shared: "hoop" }; // arrow → body, for arrows with another name
const ownerOf = (mark) => BODY_OF[mark] ?? mark;

export function linkTerms(root, signal) {
  const [host, moving, marks] = [".stage", ".moving", ".coordinates"].map((each) => root.querySelector(each));
  const sheet = document.head.appendChild(document.createElement("style"));
  const bodies = new Map([...moving.querySelectorAll(".body, .coil")].map((node) => [node.classList[1], node]));
  const ink = (name) => getComputedStyle(bodies.get(name).querySelector(".form, .front")).stroke;
  let highlighted; // name of a body

  /** Highlight what belongs to the same body as the target of an event. */
  function highlight(event) {
    const node = event.composedPath()[0], mark = node.dataset?.of, term = dom.term(node);
    const owner = ownerOf(mark);
    const belongsTo = (name) => (owner ? name === owner : bodies.get(name).contains(node));
    const hasColor = (name) => ink(name) === term.style.color;
    const body = [...bodies.keys()].find(term ? hasColor : belongsTo);
    // Between two terms of a formula the highlight stays.
    if (body === highlighted || (!body && dom.isFormula(node))) return;
    highlighted = body;
    host.classList.toggle("one-lit", Boolean(body));
    for (const part of moving.children) part.classList.toggle("lit", part === bodies.get(body));
    for (const arrow of marks.children) arrow.classList.toggle("lit", ownerOf(arrow.dataset.of) === body);
    sheet.textContent = body ? dom.termRule(ink(body)) : "";
  }

  for (const node of bodies.values()) {
    node.removeAttribute("aria-hidden");
    set(node, { role: "img", tabindex: 0 });
  }
  for (const type of ["pointerover", "focusin"]) document.addEventListener(type, highlight, { signal });
  signal.addEventListener("abort", () => sheet.remove());
}
