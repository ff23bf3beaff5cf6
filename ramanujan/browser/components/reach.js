// A wide formula or table scrolls in a box of its own. Such a box must take the focus, or nobody could scroll it by keyboard.
// Boxes come, go and change their width with the page, so this file observes the page.

import { atRest, observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const PAUSE = 250; // ms from a change of the page to the next look at its boxes

export default function ({ data }, signal) {
  const mark = (box, scrolls) => {
    if (box.hasAttribute("data-scrolls") === scrolls) return;
    const marks = { "data-scrolls": "", tabindex: "0", "aria-label": data.label };
    // A table has to stay one for a screen reader.
    if (!box.matches("table")) marks.role = "group";
    for (const [name, value] of Object.entries(marks)) scrolls ? box.setAttribute(name, value) : box.removeAttribute(name);
  };
  const look = () => {
    for (const [box, scrolls] of dom.boxes().map((box) => [box, dom.scrollsAside(box)])) mark(box, scrolls);
  };
  const soon = atRest(PAUSE, look, signal);
  observe(document.body, { childList: true, subtree: true }, soon, signal);
  addEventListener("resize", soon, { signal });
  // A font that comes late makes a formula wider, and an expander or a tab that opens adds nothing to the page.
  document.fonts.addEventListener("loadingdone", soon, { signal });
  for (const type of ["click", "keyup"]) document.addEventListener(type, soon, { capture: true, signal });
  soon();
}
