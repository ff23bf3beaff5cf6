// The time cursor: a line across every figure over time, and a dot on every orbit. `mount` in __init__.py documents
// the figures. The cursor follows the stage (topic time/NAME), and the stage follows the cursor (topic seek/NAME). The
// reader moves the cursor by the slider, by dragging the line, or by a click on a figure over time.

import { bus } from "../../bus.js";
import { plotly } from "../../plotly.js";
import { draw, erase, panelArea, shareOf } from "../../marks.js";
import { fill, fixed, withUnit } from "../../sentences.js";
import { between } from "../../stage/motion.js";

const CURSOR = "time-cursor";
const STILL = 5; // px, the largest movement of a click

export default ({ data, parentElement }, signal) => void new Cursor(parentElement, data, signal);

class Cursor {
  share = 0; // of the time span; unchanged when the machine changes
  graphs = new Set();

  constructor(root, { stage, place }, signal) {
    Object.assign(this, { stage, place });
    this.slider = root.querySelector("input");
    this.output = root.querySelector("output");
    const on = (target, type, handler) => target.addEventListener(type, handler, { signal });
    on(this.slider, "input", () => this.seek(Number(this.slider.value)));
    on(document, "pointerdown", (event) => this.press(event));
    on(document, "pointermove", (event) => this.drag(event));
    on(document, "pointerup", (event) => this.letGo(event));
    on(document, "pointercancel", () => (this.pressed = null));
    plotly.watchGraphs((graph) => this.addGraph(graph), signal);
    bus.subscribe(`time/${stage}`, ({ time }) => this.goTo(time), { signal });
    signal.addEventListener("abort", () => this.graphs.forEach((graph) => erase(graph, CURSOR)));
  }

  /** The time span of the figures [s]. */
  get span() {
    return this.meta.period * this.meta.periods;
  }

  /** Mark a graph that Plotly has drawn, and forget graphs that are no longer on the page. */
  addGraph(graph) {
    for (const old of this.graphs) if (!old.isConnected) this.graphs.delete(old);
    const meta = graph.layout?.meta;
    if (!meta?.cursor) return;
    const changed = this.meta?.period !== meta.period;
    this.graphs.add(graph);
    this.meta = meta;
    const time = bus.last(`time/${this.stage}`)?.time;
    if (changed && time !== undefined) this.goTo(time);
    else this.show(graph);
  }

  goTo(time) {
    if (!this.meta) return;
    this.share = Math.min(1, Math.max(0, time / this.span));
    if (Math.abs(Number(this.slider.value) - this.share) > 5e-4) this.slider.value = this.share;
    this.graphs.forEach((graph) => this.show(graph));
  }

  seek(share) {
    if (!this.meta) return;
    const time = Math.min(1, Math.max(0, share)) * this.span;
    this.goTo(time);
    bus.publish(`seek/${this.stage}`, { time });
  }

  show(graph) {
    if (panelArea(graph)) mark(graph, this.share);
    const time = withUnit(fixed(this.share * this.span, 2), "s");
    const text = fill(this.place, { time, periods: fixed(this.share * this.meta.periods, 2) });
    if (this.output.textContent === text) return;
    this.output.textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
  }

  // ---- the pointer on a figure over time

  press(event) {
    const graph = plotly.graphOf(event.target), isOnLine = event.target.matches?.(`.${CURSOR}`);
    if (event.button !== 0 || !event.isPrimary || graph?.layout?.meta?.cursor !== "time") return;
    if (!isOnLine && !plotly.isPanel(event.target)) return;
    this.pressed = { graph, isOnLine, id: event.pointerId, x: event.clientX, y: event.clientY };
    if (!isOnLine) return;
    event.target.setPointerCapture(event.pointerId);
    event.preventDefault();
  }

  drag(event) {
    if (this.pressed?.isOnLine && event.pointerId === this.pressed.id) this.seek(this.shareAt(event));
  }

  letGo(event) {
    if (event.pointerId !== this.pressed?.id) return;
    const { x, y, isOnLine } = this.pressed;
    if (!isOnLine && Math.hypot(event.clientX - x, event.clientY - y) < STILL) this.seek(this.shareAt(event));
    this.pressed = null;
  }

  shareAt({ clientX }) {
    const { graph } = this.pressed, [from, to] = graph.layout.xaxis.range.map(Number);
    const { left, width } = plotly.panels(graph)[0].getBoundingClientRect();
    return (from + ((clientX - left) / width) * (to - from)) / this.span;
  }
}

/** Draw the cursor in a graph at a share of the time span: a line, or a dot on each curve. */
function mark(graph, share) {
  const { xaxis, yaxis, meta } = graph.layout;
  if (meta.cursor === "time") {
    const line = draw(graph, CURSOR, 0, shareOf(xaxis, share * meta.period * meta.periods), 0.5);
    line.style.height = `${100 * panelArea(graph).height}%`;
    return;
  }
  plotly.curves(graph).forEach(({ x, y, visible, line }, i) => {
    const across = visible === true ? shareOf(xaxis, between(x, share)) : NaN;
    const dot = draw(graph, CURSOR, i, across, shareOf(yaxis, between(y, share)));
    dot.classList.add("dot");
    dot.style.color = line.color;
  });
}
