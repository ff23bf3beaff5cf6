// Marks laid over the panels of Plotly's figures, so that they move without a redrawing; page.css says how each looks.

import { dom } from "./streamlit_dom.js";

/** Where a value lies on an axis, as a share of its length; a logarithmic axis counts in powers of ten. */
export const along = ({ type, range: [from, to] }, value) => ((type === "log" ? Math.log10(value) : value) - from) / (to - from);

/** Where a value lies on the axis of an inset, as a share of all panels; nowhere beyond its ends. */
export function within({ domain: [from, to] = [0, 1], ...axis }, value) {
  const share = along(axis, value);
  return share >= 0 && share <= 1 ? from + share * (to - from) : NaN;
}

/** The rectangle of all panels of a graph, in shares of the graph, which may be scaled; none before they are drawn. */
export function area(graph) {
  const box = (node) => node.getBoundingClientRect(), home = box(graph), panels = dom.panels(graph).map(box);
  if (!panels.length) return null;
  const [{ left, width }] = panels, top = Math.min(...panels.map((panel) => panel.top));
  const height = Math.max(...panels.map((panel) => panel.bottom)) - top, { x, y, width: all, height: high } = home;
  return { left: (left - x) / all, top: (top - y) / high, width: width / all, height: height / high };
}

/** Put the i-th mark of a name on a graph, at shares of the width and the height of its panels; beside them it is hidden. */
export function draw(graph, name, i, x, y) {
  const { left, top, width, height } = area(graph), share = (part) => `${100 * part}%`;
  const made = () => graph.appendChild(Object.assign(document.createElement("i"), { className: name }));
  const node = graph.querySelectorAll(`.${name}`)[i] ?? made();
  node.hidden = !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
  Object.assign(node.style, { left: share(left + x * width), top: share(top + (1 - y) * height) });
  return node;
}

/** Take the marks of a name off a graph. */
export const erase = (graph, name) => graph.querySelectorAll(`.${name}`).forEach((node) => node.remove());
