// Reads the settings of the sidebar's sliders and of the slab before the server has received them. Only Streamlit's sliders
// store values. The server's value is current while its slider shows it, rounded to a step. If the slider shows another value,
// the visitor has moved it, and the server has not answered yet. A drag of the slab moves the slider of x₀. After the drag,
// this slider sends its value like after a key stroke, or as soon as the connection to the server is restored.

import { bus } from "../components/bus.js";
import { dom } from "../components/streamlit_dom.js";

export class Hand {
  held = null; // m, x₀ as drawn during a drag of the slab, and until its slider has sent it
  due = null; // m, x₀ that the slider has not sent yet
  isHolding = false;
  inputs = new Map(); // key of a slider → its input
  seen = "{}"; // the settings in the last drawn picture

  /** `watch` is part of the stage's payload; `received()` returns the server's parameters. */
  constructor(watch, received) {
    Object.assign(this, { watch, received });
    this.slabKey = Object.keys(watch).find((key) => watch[key].parameter === "compression");
  }

  input(key) {
    if (!this.inputs.get(key)?.isConnected) this.inputs.set(key, dom.slider(key));
    return this.inputs.get(key);
  }

  /** The parameters that the visitor has changed, by name. */
  values() {
    const set = {}, received = this.received();
    for (const [key, { parameter, scale }] of Object.entries(this.watch)) {
      const input = this.input(key);
      if (input && !dom.shows(input, received[parameter] / scale, received)) set[parameter] = dom.value(input) * scale;
    }
    if (this.held !== null) set.compression = this.held;
    this.seen = JSON.stringify(set);
    return set;
  }

  /** x₀ as in its box, with all digits. */
  text() {
    return dom.held(this.input(this.slabKey), bus.last(`exact/${this.slabKey}`));
  }

  /** Read the sliders, once a frame; return whether a value has changed. */
  look() {
    if (this.due !== null) {
      if (dom.sendSlider(this.input(this.slabKey), this.due / this.watch[this.slabKey].scale)) this.due = null;
    } else if (!this.isHolding) this.held = null; // the slider has sent it since the last frame
    const before = this.seen;
    this.values();
    return this.seen !== before;
  }

  // ---- the slab

  /** The nearest x₀ on a step of the slider [m]. */
  rounded(compression) {
    const { scale, step } = this.watch[this.slabKey];
    return Number((Math.round(compression / scale / step) * step * scale).toPrecision(10));
  }

  /** Set x₀ [m] and move its slider. `drawn` may be beyond the bounds, where the slab follows the pointer only partly. */
  hold(compression, drawn = compression) {
    this.isHolding = true;
    this.held = drawn;
    this.due = null;
    dom.moveSlider(this.input(this.slabKey), compression / this.watch[this.slabKey].scale);
  }

  drop(compression) {
    this.isHolding = false;
    this.held = this.due = compression;
  }

  /** Restore the earlier x₀ [m], without sending it. */
  giveUp(compression) {
    this.hold(compression);
    this.isHolding = false;
    this.held = null;
  }
}
