// Links each body and its arrows to the terms of the same colour in the page's formulas, and each contact force to its
// symbol. If the pointer, a finger or the focus is on a body, an arrow, a term or a symbol, the others are highlighted.

import { dom } from "../streamlit_dom.js";
import { set } from "./svg.js";
import { WORDS } from "./texts.js";

const BODY_OF = { X: "block", x0: "spring", R: "top", shared: "hoop" }; // arrow → body, for arrows with another name
const ownerOf = (mark) => BODY_OF[mark] ?? mark;
// Text of a symbol in a formula → its contact.
const CONTACT_OF = new Map(Object.entries(WORDS.contact_force).map(([contact, parts]) => [parts.join(""), contact]));
const contactOf = (symbol) => CONTACT_OF.get(dom.symbolText(symbol));
const SYMBOL_RULE = ".katex [data-lit] { -webkit-text-stroke: .04em; text-shadow: 0 0 .4em; }";

export function linkTerms(root, signal) {
  const parts = [".stage", ".moving", ".coordinates", ".forces"].map((each) => root.querySelector(each));
  const [host, moving, marks, forces] = parts;
  const sheet = document.head.appendChild(document.createElement("style"));
  const bodies = new Map([...moving.querySelectorAll(".body, .coil")].map((node) => [node.classList[1], node]));
  const ink = (name) => getComputedStyle(bodies.get(name).querySelector(".form, .front")).stroke;
  let highlighted; // name of a body or of a contact

  /** Return the body of a node: of a part of the machine, an arrow or a term. */
  function bodyOf(node) {
    const mark = node.dataset?.of, term = dom.term(node), owner = ownerOf(mark);
    const belongsTo = (name) => (owner ? name === owner : bodies.get(name).contains(node));
    const hasColor = (name) => ink(name) === term.style.color;
    return [...bodies.keys()].find(term ? hasColor : belongsTo);
  }

  /** Highlight what belongs to the same contact or body as the target of an event. */
  function highlight(event) {
    const node = event.composedPath()[0], [arrow] = node.parentNode?.dataset?.line?.split(" ") ?? [];
    const contact = arrow ?? contactOf(dom.symbol(node)), body = contact ? undefined : bodyOf(node);
    const target = contact ?? body;
    // Between two terms of a formula the highlight stays.
    if (target === highlighted || (!target && dom.isFormula(node))) return;
    highlighted = target;
    const touching = contact?.split("_") ?? [body];
    host.classList.toggle("one-lit", Boolean(target));
    for (const [name, part] of bodies) part.classList.toggle("lit", touching.includes(name));
    for (const mark of marks.children) mark.classList.toggle("lit", ownerOf(mark.dataset.of) === body);
    for (const force of forces.querySelectorAll("[data-line]")) {
      force.classList.toggle("lit", force.dataset.line.split(" ").includes(target));
    }
    for (const symbol of dom.symbols()) {
      symbol.toggleAttribute("data-lit", Boolean(contact) && contactOf(symbol) === contact);
    }
    sheet.textContent = SYMBOL_RULE + (body ? dom.termRule(ink(body)) : "");
  }

  for (const node of bodies.values()) {
    node.removeAttribute("aria-hidden");
    set(node, { role: "img", tabindex: 0 });
  }
  for (const type of ["pointerover", "focusin"]) document.addEventListener(type, highlight, { signal });
  signal.addEventListener("abort", () => sheet.remove());
}
