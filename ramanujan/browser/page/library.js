// What every page has lives in this one element, each part in a room of its own.

import { begin } from "../begin.js";
import { bus } from "./bus.js";
import { dom, reportBroken } from "./streamlit_dom.js";

// A figure is drawn as wide as the page on the screen, and on paper it must be as wide as the paper (A4: 180 mm).
const fitPaper = () => document.documentElement.style.setProperty("--printed", Math.min(1, 660 / dom.contentWidth()));
window.addEventListener("beforeprint", fitPaper);
dom.keepOneEntry();
dom.watchGraphs(dom.offerFormats, new AbortController().signal);
setTimeout(reportBroken, 10_000); // by then a page is drawn

const rooms = new WeakMap(); // parentElement → part → its room

export default async (component) => {
  const { data, parentElement } = component;
  for (const [key, box] of Object.entries(data.boxes)) bus.publish(`box/${key}`, box);
  if (!rooms.has(parentElement)) {
    const own = ["theme", "voice", "reach", "ring", "connection", "arrival"].map((name) => [name, parentElement.appendChild(document.createElement("div"))]);
    rooms.set(parentElement, own);
  }
  const parts = rooms.get(parentElement).map(([name, room]) => begin({ ...component, name: `page/${name}`, parentElement: room }));
  const ends = await Promise.all(parts);
  return () => ends.forEach((end) => end());
};
