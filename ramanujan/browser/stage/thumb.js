// Reads what a person sets by hand, with a slider of the sidebar or by the slab. Streamlit's sliders own the values; this file
// stores none. The server's value counts as long as its slider shows it, rounded to a step. If the slider shows another value,
// a person has moved it, and the server has not answered yet. A drag of the slab moves the slider of x₀ along. When the drag
// ends, that slider sends its value as after a key stroke, or as soon as the server is back.

import { bus } from "../components/bus.js";
import { dom } from "../components/streamlit_dom.js";

export class Hand {
  held = null; // m, x₀ as it is drawn while the slab is in a hand, and until its slider has sent it
  due = null; // m, x₀ that the slider has still to send
  isHolding = false;
  inputs = new Map(); // key of a slider → its input
  seen = "{}"; // what a hand had set when the picture was drawn last

  /** `watch` is the contract's; `received()` the server's parameters. */
  constructor(watch, received) {
    Object.assign(this, { watch, received });
    this.slabKey = Object.keys(watch).find((key) => watch[key].parameter === "compression");
  }

  input(key) {
    if (!this.inputs.get(key)?.isConnected) this.inputs.set(key, dom.slider(key));
    return this.inputs.get(key);
  }

  /** The parameters that a hand has set, by name. */
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

  /** x₀ as its box shows it, with all digits. */
  text() {
    return dom.held(this.input(this.slabKey), bus.last(`exact/${this.slabKey}`));
  }

  /** Look at the sliders, once a frame; return whether a value has changed. */
  look() {
    if (this.due !== null) {
      if (dom.sendSlider(this.input(this.slabKey), this.due / this.watch[this.slabKey].scale)) this.due = null;
    } else if (!this.isHolding) this.held = null; // the slider has sent it since the last frame
    const before = this.seen;
    this.values();
    return this.seen !== before;
  }

  // ---- the slab

  /** The nearest x₀ that the slider can have [m]. */
  rounded(compression) {
    const { scale, step } = this.watch[this.slabKey];
    return Number((Math.round(compression / scale / step) * step * scale).toPrecision(10));
  }

  /** Set x₀ [m]; its slider goes along. `drawn` may lie beyond the bounds, where the slab gives way. */
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

  /** Give x₀ back as it was. */
  giveUp(compression) {
    this.hold(compression);
    this.isHolding = false;
    this.held = null;
  }
}
