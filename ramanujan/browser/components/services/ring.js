// The ring around the present machine on a curve. It follows the stage's topic drawn/NAME. `mount` in
// __init__.py documents the figure.

import { bus } from "../../bus.js";
import { plotly } from "../../plotly.js";
import { draw, erase, panelArea, shareInInset } from "../../marks.js";
import { fill, number } from "../../sentences.js";

const RING = "present-machine";
const IN_STEP = 1e-12; // only rounding errors are smaller

export default function ({ data: { ring } }, signal) {
  let graph = null;
  const show = () => {
    const { ratio, normalized } = bus.last(`drawn/${ring.stage}`) ?? {};
    if (!graph) return;
    if (normalized === undefined) erase(graph, RING);
    else if (panelArea(graph)) {
      const { xaxis, yaxis, xaxis2, yaxis2, meta } = graph.layout;
      const ariaLabel = fill(ring.label, { ratio: number(ratio, 4), normalized: number(normalized, 6) });
      for (const [i, [horizontal, vertical]] of [[xaxis, yaxis], [xaxis2, yaxis2]].entries()) {
        const node = draw(graph, RING, i, shareInInset(horizontal, ratio), shareInInset(vertical, normalized));
        node.style.borderColor = meta.ring;
        node.classList.toggle("in-step", Math.abs(normalized - 1) < IN_STEP);
        Object.assign(node, i ? { ariaHidden: true } : { role: "img", ariaLabel });
      }
    }
  };
  bus.subscribe(`drawn/${ring.stage}`, show, { signal });
  plotly.watchGraphs((drawnGraph) => {
    if (!drawnGraph.layout?.meta?.ring) return;
    graph = drawnGraph;
    show();
  }, signal);
  signal.addEventListener("abort", () => graph && erase(graph, RING));
}
