// The handle of the sidebar on a narrow screen, where the sidebar is a drawer at the bottom (page.css). An open drawer
// leaves the machine visible; the choice of another page closes it.

import { dom } from "../../streamlit_dom.js";

const PULL = 16; // px, the shortest pull that opens or closes the drawer; a shorter one is a tap

export default function ({ parentElement }, signal) {
  const button = parentElement.querySelector("button");
  const root = document.documentElement;
  const narrow = matchMedia(dom.NARROW);
  let scrollBefore = null; // scroll position before the drawer scrolled to the machine
  let pullStart = null;

  const setOpen = (open, { scrolls = true } = {}) => {
    root.dataset.drawer = open ? "open" : "closed";
    button.setAttribute("aria-expanded", String(open));
    if (!scrolls || !narrow.matches) return;
    const main = dom.main();
    if (open) {
      scrollBefore = main?.scrollTop ?? null;
      const distance = dom.distanceToStage();
      if (distance) main.scrollBy({ top: distance });
    } else if (scrollBefore !== null) {
      main.scrollTo({ top: scrollBefore });
      scrollBefore = null;
    }
  };
  // A page begins with a closed drawer, so that the text is visible.
  setOpen(false, { scrolls: false });
  const on = (node, type, handler, options = {}) => node.addEventListener(type, handler, { ...options, signal });
  on(button, "pointerdown", (event) => (pullStart = event.clientY));
  on(button, "pointerup", (event) => {
    const by = pullStart === null ? 0 : event.clientY - pullStart;
    pullStart = null;
    if (Math.abs(by) < PULL) return;
    setOpen(by < 0);
    button.dataset.pulled = "yes"; // ignore the click that follows a pull
  });
  on(button, "click", () => {
    if (!button.dataset.pulled) setOpen(root.dataset.drawer !== "open");
    delete button.dataset.pulled;
  });
  on(document, "click", (event) => {
    if (!dom.isPageLink(event.target)) return;
    scrollBefore = null;
    setOpen(false, { scrolls: false });
  });
  signal.addEventListener("abort", () => delete root.dataset.drawer);
  dom.showPresentPage();
}
