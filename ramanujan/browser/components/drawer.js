// On a narrow screen the sidebar is a drawer at the bottom (page.css): this is its handle, which opens and closes it. With the
// drawer open, sliders and machine are seen together; choosing a page closes it.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";

const PULL = 16; // px that the handle must be pulled to open or close the drawer; less is a tap

export default function ({ parentElement }, signal) {
  const button = parentElement.querySelector("button");
  const root = document.documentElement;
  const narrow = matchMedia(dom.NARROW);
  let back = null; // where the page was scrolled to before the drawer brought the machine into view
  let pulled = null;

  const set = (open, bring = true) => {
    root.dataset.drawer = open ? "open" : "closed";
    button.setAttribute("aria-expanded", String(open));
    if (!bring || !narrow.matches) return;
    const main = dom.main();
    if (open) {
      back = main?.scrollTop ?? null;
      const away = dom.stageAway();
      if (away) main.scrollBy({ top: away });
    } else if (back !== null) {
      main.scrollTo({ top: back });
      back = null;
    }
  };
  // A page opens with its drawer closed: people want to read first.
  set(false, false);
  bus.subscribe("sliders", () => set(true), { signal });
  const on = (node, type, handler, options = {}) => node.addEventListener(type, handler, { ...options, signal });
  on(button, "pointerdown", (event) => (pulled = event.clientY));
  on(button, "pointerup", (event) => {
    const by = pulled === null ? 0 : event.clientY - pulled;
    pulled = null;
    if (Math.abs(by) < PULL) return;
    set(by < 0);
    button.dataset.pulled = "yes"; // the click that follows is part of the pull
  });
  on(button, "click", () => {
    if (!button.dataset.pulled) set(root.dataset.drawer !== "open");
    delete button.dataset.pulled;
  });
  on(document, "click", (event) => {
    if (!dom.isPageLink(event.target)) return;
    back = null;
    set(false, false);
  });
  signal.addEventListener("abort", () => delete root.dataset.drawer);
  dom.showPresentPage();
}
