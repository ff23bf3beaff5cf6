// What every page has lives in this one element, each part in a room of its own.

import { begin } from "../begin.js";
import { dom, reportBroken } from "./streamlit_dom.js";

// A figure is drawn as wide as the page on the screen, and on paper it must be as wide as the paper (A4: 180 mm).
const fitPaper = () => document.documentElement.style.setProperty("--printed", Math.min(1, 660 / dom.contentWidth()));
window.addEventListener("beforeprint", fitPaper);
dom.keepOneEntry();
dom.watchGraphs(dom.offerFormats, new AbortController().signal);
setTimeout(reportBroken, 10_000); // by then a page is drawn

export default function (component, signal) {
  const { parentElement } = component;
  const rooms = ["theme", "voice", "reach", "ring", "connection", "arrival"].map((name) => [
    `page/${name}`,
    parentElement.appendChild(document.createElement("div")),
  ]);
  let parts = [];
  signal.addEventListener("abort", () => parts.forEach(async (end) => (await end)()));
  return () => {
    parts = rooms.map(([name, room]) => begin({ ...component, name, parentElement: room }));
  };
}
