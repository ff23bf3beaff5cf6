// The ring around the present machine on a curve. It follows the stage by the topic present/NAME; the contract with the
// figure is in __init__.py, the drawing in marks.js.

const RING = "present-machine";
const SIZE = 22;

export default function ({ data }) {
  let frame = 0;
  let shown = null;

  const tick = () => {
    frame = requestAnimationFrame(tick);
    const machine = bus.last(`present/${data.stage}`);
    const graph = hosts.graphs().find((graph) => graph.layout?.meta?.ring);
    const panel = graph && hosts.panels(graph)[0];
    if (!machine || !panel) return;
    const now = { machine, graph, width: graph.offsetWidth, height: graph.offsetHeight };
    const same = shown && Object.keys(now).every((key) => now[key] === shown[key]);
    if (same && graph.querySelector(`.${RING}`)) return;
    mark(machine, graph, panel.getBoundingClientRect());
    shown = now;
  };

  frame = requestAnimationFrame(tick);
  return () => {
    cancelAnimationFrame(frame);
    for (const node of document.querySelectorAll(`.${RING}`)) node.remove();
  };
}

function mark({ ratio, normalized }, graph, panel) {
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
  node.setAttribute("aria-label", `this machine: ε = ${ratio.toPrecision(4)}, Ω²m/k = ${normalized.toPrecision(6)}`);
}

/** Where a value lies on an axis, as a share of its length; a logarithmic axis counts in powers of ten. */
const along = ({ type, range }, value) => place(range, type === "log" ? Math.log10(value) : value);
