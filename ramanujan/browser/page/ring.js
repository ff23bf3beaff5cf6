// The ring around the present machine on a curve. It follows the stage by the topic present/NAME; the contract with the
// figure is in __init__.py, the drawing in marks.js.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { draw, erase, place } from "./marks.js";
import { fill, number } from "./sentences.js";

const RING = "present-machine";
const SIZE = 22;

export default function ({ data: { ring }, parentElement }) {
  return live(parentElement, (signal) => {
    let graph = null;
    const show = () => {
      const machine = bus.last(`present/${ring.stage}`);
      const panel = graph && dom.panels(graph)[0];
      if (!machine || machine.normalized === undefined) graph && erase(graph, RING);
      else if (panel) mark(machine, graph, panel.getBoundingClientRect(), ring.label);
    };
    const drawn = (each) => {
      if (!each.layout?.meta?.ring) return;
      graph = each;
      show();
    };
    bus.subscribe(`present/${ring.stage}`, show, { signal });
    dom.watchGraphs(drawn, signal);
    signal.addEventListener("abort", () => graph && erase(graph, RING));
  }).end;
}

function mark({ ratio, normalized }, graph, panel, label) {
  const home = graph.getBoundingClientRect();
  const x = along(graph.layout.xaxis, ratio);
  const y = along(graph.layout.yaxis, normalized);
  const node = draw(graph, RING, 0, x, {
    left: `${panel.left - home.left + x * panel.width - SIZE / 2}px`,
    top: `${panel.bottom - home.top - y * panel.height - SIZE / 2}px`,
    width: `${SIZE}px`,
    height: `${SIZE}px`,
    boxSizing: "border-box",
    border: `3px solid ${graph.layout.meta.ring}`,
    borderRadius: "50%",
  });
  node.setAttribute("role", "img");
  node.setAttribute("aria-label", fill(label, { ratio: number(ratio, 4), normalized: number(normalized, 6) }));
}

/** Where a value lies on an axis, as a share of its length; a logarithmic axis counts in powers of ten. */
const along = ({ type, range }, value) => place(range, type === "log" ? Math.log10(value) : value);
