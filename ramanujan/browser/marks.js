// Marks over the panels of Plotly's figures, which move without redrawing the figure. Their components style them.

import { plotly } from "./plotly.js";

/**
 * The position of a value on an axis, as a share of its length. The range of a logarithmic axis is in powers of ten.
 */
export const shareOf = ({ type, range: [from, to] }, value) =>
  ((type === "log" ? Math.log10(value) : value) - from) / (to - from);

/** The position of a value on the axis of an inset, as a share of all panels; NaN beyond the ends of the axis. */
export function shareInInset({ domain: [from, to] = [0, 1], ...axis }, value) {
  const share = shareOf(axis, value);
  return share >= 0 && share <= 1 ? from + share * (to - from) : NaN;
}

/** The rectangle around all panels of a graph, as shares of the graph's size; null before the panels are drawn. */
export function panelArea(graph) {
  const box = (node) => node.getBoundingClientRect();
  const whole = box(graph), panels = plotly.panels(graph).map(box);
  if (!panels.length) return null;
  const [{ left, width }] = panels; // panels are above each other
  const top = Math.min(...panels.map((panel) => panel.top));
  const height = Math.max(...panels.map((panel) => panel.bottom)) - top;
  return {
    left: (left - whole.x) / whole.width,
    top: (top - whole.y) / whole.height,
    width: width / whole.width,
    height: height / whole.height,
  };
}

/** Place the i-th mark with this class name at shares x, y of the panels. A mark outside of the panels is hidden. */
export function draw(graph, name, i, x, y) {
  const { left, top, width, height } = panelArea(graph), share = (part) => `${100 * part}%`;
  const create = () => graph.appendChild(Object.assign(document.createElement("i"), { className: name }));
  const node = graph.querySelectorAll(`.${name}`)[i] ?? create();
  node.hidden = !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
  Object.assign(node.style, { left: share(left + x * width), top: share(top + (1 - y) * height) });
  return node;
}

/** Remove the marks with this class name from a graph. */
export const erase = (graph, name) => graph.querySelectorAll(`.${name}`).forEach((node) => node.remove());
