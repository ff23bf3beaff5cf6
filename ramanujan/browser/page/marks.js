// Marks laid over Plotly's figures, so that they move without a redrawing.

export const place = ([from, to], value) => (value - from) / (to - from);

/** Put the i-th mark of a name on the graph, or hide it where x lies beside the panel. */
export function draw(graph, name, i, x, style) {
  const marks = graph.querySelectorAll(`.${name}`);
  const node = marks[i] ?? graph.appendChild(Object.assign(document.createElement("i"), { className: name }));
  Object.assign(node.style, { position: "absolute", pointerEvents: "none", ...style });
  node.style.display = x >= 0 && x <= 1 ? "" : "none";
  return node;
}

/** Take the marks of a name off a graph. */
export const erase = (graph, name) => graph.querySelectorAll(`.${name}`).forEach((node) => node.remove());
