// The time cursor on the page: a line across every figure over time, a dot on every orbit. The contract with the figures
// is in __init__.py, the drawing in marks.js. The cursor is kept as a share of the time shown, so that it stays when the
// machine changes. It follows the stage by the topic time/NAME, unless a hand takes it.

const CURSOR = "time-cursor";

export default function ({ data, parentElement }) {
  const slider = parentElement.querySelector("input");
  const output = parentElement.querySelector("output");
  const stop = new AbortController();
  let frame = 0;
  let inHand = false;
  let stageTime = null;

  // Moving over any figure takes the cursor along.
  const follow = (event) => {
    const graph = hosts.graphOf(event.target);
    inHand = graph?.layout?.meta?.cursor === "time" && hosts.isPanel(event.target);
    if (!inHand) return;
    const { period, periods } = graph.layout.meta;
    const [from, to] = graph.layout.xaxis.range;
    const { left, width } = event.target.getBoundingClientRect();
    const time = Number(from) + ((event.clientX - left) / width) * (to - from);
    slider.value = time / (period * periods);
  };
  document.addEventListener("pointermove", follow, { signal: stop.signal });

  /** Take over the stage's time, if that has moved and nobody holds the cursor. */
  const goAlong = ({ period, periods }) => {
    const time = bus.last(`time/${data.stage}`)?.time;
    if (time === stageTime || inHand || parentElement.activeElement === slider) return;
    stageTime = time;
    const share = time / (period * periods);
    slider.value = share - Math.floor(share);
  };

  const tick = () => {
    const first = hosts.graphs()[0]?.layout?.meta;
    if (first?.cursor) goAlong(first);
    const share = Number(slider.value);
    for (const graph of hosts.graphs()) {
      const meta = graph.layout?.meta;
      if (!meta?.cursor) continue;
      const panels = hosts.panels(graph).map((panel) => panel.getBoundingClientRect());
      if (panels.length) mark(graph, meta, share, panels);
      say(meta, share);
    }
    frame = requestAnimationFrame(tick);
  };

  const say = ({ period, periods }, share) => {
    const text = `t = ${(share * period * periods).toFixed(2)} s, ${(share * periods).toFixed(2)} periods`;
    if (output.textContent === text) return;
    output.textContent = text;
    slider.setAttribute("aria-valuetext", text);
  };

  frame = requestAnimationFrame(tick);
  return () => {
    cancelAnimationFrame(frame);
    stop.abort();
    for (const node of document.querySelectorAll(`.${CURSOR}`)) node.remove();
  };
}

function mark(graph, meta, share, panels) {
  const home = graph.getBoundingClientRect();
  const [top, bottom] = [Math.min(...panels.map((p) => p.top)), Math.max(...panels.map((p) => p.bottom))];
  const { left, width } = panels[0];
  if (meta.cursor === "time") {
    const x = place(graph.layout.xaxis.range, share * meta.period * meta.periods);
    const line = { background: "currentColor", width: "2px", height: `${bottom - top}px`, borderRadius: "0" };
    draw(graph, CURSOR, 0, x, { ...line, left: `${left - home.left + x * width - 1}px`, top: `${top - home.top}px` });
    return;
  }
  graph.data.forEach((orbit, i) => {
    const x = place(graph.layout.xaxis.range, between(numbers(orbit, "x"), share));
    const y = place(graph.layout.yaxis.range, between(numbers(orbit, "y"), share));
    const dot = { background: "currentColor", width: "12px", height: "12px", borderRadius: "50%" };
    const style = { left: `${left - home.left + x * width - 6}px`, top: `${bottom - home.top - y * (bottom - top) - 6}px` };
    draw(graph, CURSOR, i, orbit.visible === "legendonly" || y < 0 || y > 1 ? -1 : x, { ...dot, ...style });
  });
}

function between(values, share) {
  const at = share * (values.length - 1);
  const i = Math.min(Math.floor(at), values.length - 2);
  return values[i] + (at - i) * (values[i + 1] - values[i]);
}

const decoded = new WeakMap();

/** The numbers of a trace, as Plotly got them: an array, or single precision in base 64. */
function numbers(trace, axis) {
  const given = trace[axis];
  if (!given.bdata) return given;
  if (!decoded.has(given)) {
    const bytes = Uint8Array.from(atob(given.bdata), (letter) => letter.charCodeAt(0));
    decoded.set(given, new Float32Array(bytes.buffer));
  }
  return decoded.get(given);
}
