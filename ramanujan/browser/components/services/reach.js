// Makes boxes that scroll sideways, with wide formulas or tables, focusable, so that they can be scrolled by keyboard.
// Boxes appear, disappear and change their width with the page, so this module observes the page.

import { debounce, observe } from "../../lasting.js";
import { dom } from "../../streamlit_dom.js";

const PAUSE = 250; // ms from a change of the page until its boxes are checked

export default function ({ data }, signal) {
  const mark = (box, scrolls) => {
    if (box.hasAttribute("data-scrolls") === scrolls) return;
    const marks = { "data-scrolls": "", tabindex: "0", "aria-label": data.label };
    // A table keeps its role for screen readers.
    if (!box.matches("table")) marks.role = "group";
    for (const [name, value] of Object.entries(marks))
      scrolls ? box.setAttribute(name, value) : box.removeAttribute(name);
  };
  const check = () => {
    // Measure all boxes before the first change, so that the browser lays out the page only once.
    const measured = dom.boxes().map((box) => [box, dom.scrollsAside(box)]);
    for (const [box, scrolls] of measured) mark(box, scrolls);
  };
  const scheduleCheck = debounce(PAUSE, check, signal);
  observe(document.body, { childList: true, subtree: true }, scheduleCheck, signal);
  addEventListener("resize", scheduleCheck, { signal });
  // A font that loads late changes the width of a formula. Opening an expander or a tab adds no node to the page.
  document.fonts.addEventListener("loadingdone", scheduleCheck, { signal });
  for (const type of ["click", "keyup"]) document.addEventListener(type, scheduleCheck, { capture: true, signal });
  scheduleCheck();
}
