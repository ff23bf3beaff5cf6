// The ring around the present machine on a curve. It follows the stage by the topic drawn/NAME; the contract with the
// figure is in __init__.py.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { along, area, draw, erase } from "./marks.js";
import { fill, number } from "./sentences.js";

const RING = "present-machine";
const IN_STEP = 1e-12; // only rounding is as small

export default function ({ data: { ring } }, signal) {
  let graph = null;
  const show = () => {
    const { ratio, normalized } = bus.last(`drawn/${ring.stage}`) ?? {};
    if (!graph) return;
    if (normalized === undefined) erase(graph, RING);
    else if (area(graph)) {
      const { xaxis, yaxis, meta } = graph.layout;
      const node = draw(graph, RING, 0, along(xaxis, ratio), along(yaxis, normalized));
      node.style.borderColor = meta.ring;
      node.classList.toggle("in-step", Math.abs(normalized - 1) < IN_STEP);
      node.role = "img";
      node.ariaLabel = fill(ring.label, { ratio: number(ratio, 4), normalized: number(normalized, 6) });
    }
  };
  const drawn = (each) => {
    if (!each.layout?.meta?.ring) return;
    graph = each;
    show();
  };
  bus.subscribe(`drawn/${ring.stage}`, show, { signal });
  dom.watchGraphs(drawn, signal);
  signal.addEventListener("abort", () => graph && erase(graph, RING));
}
