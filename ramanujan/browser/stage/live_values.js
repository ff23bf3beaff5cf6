// Reads the settings of the sidebar's sliders and of the slab before the server has received them. Only Streamlit's
// sliders store values. The server's value is current while its slider shows it, rounded to a step. If the slider shows
// another value, the visitor has moved it, and the server has not answered yet. A drag of the slab moves the slider of
// x₀. After the drag, this slider sends its value like after a key stroke.

import { sliders } from "../sliders.js";

export class LiveValues {
  drawn = null; // m, x₀ as drawn during a drag of the slab
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
      const hasMoved = !sliders.shows(key, received[parameter] / scale);
      if (hasMoved) changed[parameter] = sliders.value(key) * scale;
    }
    if (this.isDragging) changed.compression = this.drawn;
    this.seen = JSON.stringify(changed);
    return changed;
  }

  /** Read the sliders, once a frame; return whether a value has changed. */
  update() {
    const before = this.seen;
    this.values();
    return this.seen !== before;
  }

  // ---- the slab

  /** x₀ [m] in the unit of its slider. */
  inSliderUnit(compression) {
    return Number((compression / this.watch[this.slabKey].scale).toPrecision(12));
  }

  /** The nearest x₀ on a step of the slider [m]. */
  rounded(compression) {
    const { scale, step } = this.watch[this.slabKey];
    return Number((Math.round(compression / scale / step) * step * scale).toPrecision(10));
  }

  /** Set x₀ [m] and move its slider. */
  drag(compression) {
    this.drawn = compression;
    sliders.move(this.slabKey, this.inSliderUnit(compression));
  }

  /** End the drag without a message, and move the slider back to x₀ [m]. */
  cancel(compression) {
    this.drag(compression);
    this.drawn = null;
  }

  /** End the drag, and send x₀. */
  drop() {
    const value = this.inSliderUnit(this.drawn);
    sliders.want(this.slabKey, value);
    sliders.send(this.slabKey, value);
    this.drawn = null;
  }
}
