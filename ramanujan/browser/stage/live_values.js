// Reads the settings of the sidebar's sliders and of the slab before the server has received them. Only Streamlit's sliders
// store values. The server's value is current while its slider shows it, rounded to a step. If the slider shows another value,
// the visitor has moved it, and the server has not answered yet. A drag of the slab moves the slider of x₀. After the drag, this
// slider sends its value like after a key stroke. Without a connection, it sends the value when the connection is restored.

import { bus } from "../components/bus.js";
import { dom } from "../components/streamlit_dom.js";

export class LiveValues {
  drawn = null; // m, x₀ as drawn during a drag of the slab
  unsent = null; // m, x₀ that the slab's slider has to send
  seen = "{}"; // the settings in the last drawn picture

  /** `watch` is part of the stage's payload; `received()` returns the server's parameters. */
  constructor(watch, received) {
    Object.assign(this, { watch, received });
    this.slabKey = Object.keys(watch).find((key) => watch[key].parameter === "compression");
  }

  /** Whether the slab is being dragged. */
  get isDragging() {
    return this.drawn !== null;
  }

  /** The parameters that the visitor has changed, by name. */
  values() {
    const changed = {}, received = this.received();
    for (const [key, { parameter, scale }] of Object.entries(this.watch)) {
      const slider = dom.slider(key);
      if (slider && !dom.shows(slider, received[parameter] / scale, received)) changed[parameter] = dom.value(slider) * scale;
    }
    const compression = this.drawn ?? this.unsent;
    if (compression !== null) changed.compression = compression;
    this.seen = JSON.stringify(changed);
    return changed;
  }

  /** Read the sliders, once a frame; return whether a value has changed. Send x₀, unless the server is away. */
  update() {
    if (this.unsent !== null && dom.sendSlider(this.slider, this.inSliderUnit(this.unsent))) {
      // The slider shows the value after a microtask that is already queued; until then, `unsent` replaces it.
      queueMicrotask(() => (this.unsent = null));
    }
    const before = this.seen;
    this.values();
    return this.seen !== before;
  }

  // ---- the slab

  get slider() {
    return dom.slider(this.slabKey);
  }

  /** x₀ [m] in the unit of its slider. */
  inSliderUnit(compression) {
    return Number((compression / this.watch[this.slabKey].scale).toPrecision(12));
  }

  /** The nearest x₀ on a step of the slider [m]. */
  rounded(compression) {
    const { scale, step } = this.watch[this.slabKey];
    return Number((Math.round(compression / scale / step) * step * scale).toPrecision(10));
  }

  /**
   * Set x₀ [m] and move its slider. `drawn` may be beyond the bounds, where the slab follows the pointer only partly; null ends
   * the drag without a message.
   */
  drag(compression, drawn = compression) {
    this.drawn = drawn;
    this.unsent = null;
    dom.moveSlider(this.slider, this.inSliderUnit(compression));
  }

  /** End the drag. `update` then sends x₀ [m]. */
  drop(compression) {
    this.drawn = null;
    this.unsent = compression;
  }

  /** Send x₀ [m] like a typed value, which may be between two steps. */
  send(compression) {
    bus.publish(`enter/${this.slabKey}`, String(this.inSliderUnit(compression)));
  }
}
