// Moves the slab by pointer or keys, within the bounds of x₀.

import { debounce } from "../lasting.js";
import { fill, number, withUnit } from "../sentences.js";
import { CM } from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { clamp } from "./motion.js";
import { set } from "./svg.js";
import { WORDS } from "./texts.js";
import { centimetres } from "./words.js";

const THRESHOLD = { mouse: 4, pen: 6, touch: 9 }; // px that a pointer must move before a click becomes a drag
const KEY_STEP = 0.005; // m
const KEY_PAUSE = 400; // ms from the last key stroke until x₀ is sent

/** The compression after a key, or undefined for other keys. */
function compressionAfter(key, compression, [least, most]) {
  const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5 }[key];
  if (steps) return clamp(compression + steps * KEY_STEP, least, most);
  return { Home: least, End: most }[key];
}

/**
 * Drags the slab. A drag begins with the first move of a pointer, or with the first key. Until it ends or is cancelled,
 * `live.isDragging` is true.
 */
export class Slab {
  grip = null; // { id, x } of the pressed pointer; during its drag also { from, deformation }
  before = null; // { compression, phase, plainPhase } at the begin of the present drag

  constructor(node, stage, signal) {
    // With equal limits x₀ cannot change.
    const fixed = stage.compact || stage.limits[0] === stage.limits[1];
    Object.assign(this, { node, stage, fixed });
    stage.host.classList.toggle("fixed", fixed);
    if (fixed) return set(node, { "aria-hidden": true });
    this.letGoLater = debounce(KEY_PAUSE, () => this.letGo(), signal); // one message for a series of key strokes
    const on = (type, listener, options = {}) => node.addEventListener(type, listener, { ...options, signal });
    // Only the pressed pointer drags the slab; a second finger does not.
    const ofGrip = (listener) => (event) => event.pointerId === this.grip?.id && listener(event);
    on("pointerdown", (event) => this.press(event));
    // A finger that drags the slab must not also scroll the page. A scroll in progress cannot be cancelled.
    on("touchstart", (event) => event.cancelable && event.preventDefault(), { passive: false });
    on("pointermove", ofGrip((event) => this.drag(event)));
    on("pointercancel", ofGrip(() => this.end(() => this.cancel())));
    for (const type of ["pointerup", "lostpointercapture"]) on(type, ofGrip(() => this.end(() => this.letGo())));
    on("keydown", (event) => this.key(event));
    on("blur", () => this.grip || this.letGo());
    const letGoElsewhere = (event) => event.composedPath().includes(node) || this.grip || this.letGo();
    document.addEventListener("pointerdown", letGoElsewhere, { capture: true, signal });
  }

  // ---- events

  press(event) {
    if (this.grip || event.button !== 0 || !event.isPrimary) return;
    this.grip = { id: event.pointerId, x: event.clientX };
    this.node.setPointerCapture(event.pointerId);
  }

  drag({ pointerType, clientX }) {
    const { grip, stage: { picture, parameters, playback } } = this;
    if (grip.from === undefined) {
      if (Math.abs(clientX - grip.x) < (THRESHOLD[pointerType] ?? THRESHOLD.touch)) return;
      this.letGoLater.cancel();
      const deformation = FORMULAS.deformation({ ...parameters, ...playback.now() });
      Object.assign(grip, { from: picture.toMetres(grip.x), deformation });
    }
    this.compress(grip.deformation + picture.toMetres(clientX) - grip.from);
  }

  /** Release the pointer. Call `finish` if it has dragged the slab. */
  end(finish) {
    const dragged = this.grip.from !== undefined;
    this.grip = null;
    if (dragged) finish();
  }

  key(event) {
    if (event.key === "Escape") {
      if (this.grip?.from !== undefined) this.grip = null;
      return this.cancel();
    }
    const wanted = compressionAfter(event.key, this.compression(), this.stage.limits);
    if (wanted === undefined || this.grip || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.compress(wanted);
    this.letGoLater();
  }

  // ---- effects on the stage

  compression() {
    return clamp(this.stage.parameters.compression, ...this.stage.limits);
  }

  /** Show the machine at rest with the spring compressed by `wanted` [m], rounded to a step of its slider. */
  compress(wanted) {
    const { limits, live, playback, parameters, voice } = this.stage, { phase, plainPhase } = playback;
    if (!live.isDragging) this.before = { compression: parameters.compression, phase, plainPhase };
    const bound = clamp(wanted, ...limits), value = live.rounded(bound);
    this.stage.change(() => {
      live.drag(value);
      playback.reset();
    });
    const [least, most] = limits.map(centimetres), rounded = withUnit(number(value * CM, 3), "cm");
    voice.note(bound === wanted ? fill(WORDS.dragged, { value: rounded }) : fill(WORDS.bound, { least, most }));
  }

  letGo() {
    if (!this.stage.live.isDragging) return;
    this.letGoLater.cancel();
    this.stage.change(() => this.stage.live.drop());
  }

  /** Restore the state before the drag. */
  cancel() {
    const { live, playback, voice } = this.stage;
    if (!live.isDragging) return;
    this.letGoLater.cancel();
    const { compression, phase, plainPhase } = this.before;
    this.stage.change(() => {
      live.cancel(compression);
      Object.assign(playback, { phase, plainPhase });
    });
    voice.note(fill(WORDS.restored, { value: centimetres(compression) }));
  }

  /** Describe x₀ to screen readers, and on the slab. */
  show() {
    const { node, fixed, stage: { host, limits, live } } = this;
    if (fixed) return;
    const [least, most, now] = [...limits, this.compression()].map((metres) => metres * CM);
    node.querySelector(".handle text").textContent = fill(WORDS.drag, { value: centimetres(this.compression()) });
    host.classList.toggle("dragged", live.isDragging);
    // The role and the value are set together, because a slider needs a value.
    set(node, {
      role: "slider",
      tabindex: 0,
      "aria-label": WORDS.slab_slider,
      "aria-orientation": "horizontal",
      "aria-valuemin": least,
      "aria-valuemax": most,
      "aria-valuenow": now,
      "aria-valuetext": withUnit(number(now, 3), "cm"),
    });
  }
}
