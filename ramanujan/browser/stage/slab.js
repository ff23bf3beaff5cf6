// Moves the slab by pointer or keys, within elastic bounds.

import { debounce } from "../components/lasting.js";
import { fill, number, withUnit } from "../components/sentences.js";
import { CM } from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { clamp } from "./motion.js";
import { set } from "./svg.js";
import { WORDS } from "./texts.js";
import { centimetres } from "./words.js";

const THRESHOLD = { mouse: 4, pen: 6, touch: 9 }; // px that a pointer must move before a click becomes a drag
const GIVE = 0.02; // m, the largest displacement beyond a bound
const KEY_STEP = 0.005; // m
const KEY_PAUSE = 400; // ms from the last key stroke until x₀ is sent

/**
 * The compression to draw if the pointer is at `wanted` [m]. Beyond a bound by more than `slack`, the slab lags behind the
 * pointer.
 */
function elastic(wanted, [least, most], slack = 0) {
  const bound = clamp(wanted, least, most);
  const excess = Math.abs(wanted - bound) - slack;
  if (excess <= 0) return wanted;
  return bound + Math.sign(wanted - bound) * (slack + GIVE * (1 - Math.exp(-excess / (2 * GIVE))));
}

/** The compression after a key, or undefined for other keys. */
function compressionAfter(key, compression, [least, most]) {
  const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5 }[key];
  if (steps) return clamp(compression + steps * KEY_STEP, least, most);
  return { Home: least, End: most }[key];
}

/**
 * Drags the slab, and undoes the last drag. A drag begins with the first move of a pointer, or with the first key. Until it ends
 * or is cancelled, `live.isDragging` is true.
 */
export class Slab {
  grip = null; // { id, x } of the pressed pointer; during its drag also { from, deformation, slack }
  before = null; // { compression, phase, plainPhase } at the begin of the present drag
  last = null; // `before` of the last finished drag
  value = null; // m, x₀ at the end of the drag

  constructor(node, stage, signal) {
    // With equal limits x₀ cannot change.
    const fixed = stage.compact || stage.limits[0] === stage.limits[1];
    Object.assign(this, { node, stage, fixed, button: stage.root.querySelector(".undo") });
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
    event.preventDefault();
    this.node.focus({ preventScroll: true });
  }

  drag({ pointerType, clientX }) {
    const { grip, stage: { picture, limits, parameters, playback } } = this;
    if (grip.from === undefined) {
      if (Math.abs(clientX - grip.x) < (THRESHOLD[pointerType] ?? THRESHOLD.touch)) return;
      this.letGoLater.cancel();
      // A slab that swings beyond its bounds is dragged from its present position.
      const deformation = FORMULAS.deformation({ ...parameters, ...playback.now() });
      const slack = Math.abs(deformation - clamp(deformation, ...limits));
      Object.assign(grip, { from: picture.toMetres(grip.x), deformation, slack });
    }
    this.compress(grip.deformation + picture.toMetres(clientX) - grip.from, grip.slack);
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
  compress(wanted, slack = 0) {
    const { limits, live, playback, parameters, voice } = this.stage, { phase, plainPhase } = playback;
    if (!live.isDragging) this.before = { compression: parameters.compression, phase, plainPhase };
    const bound = clamp(wanted, ...limits), isBeyond = bound !== wanted;
    this.value = live.rounded(bound);
    this.stage.change(() => {
      live.drag(this.value, isBeyond ? elastic(wanted, limits, slack) : this.value);
      playback.reset();
    });
    const [least, most, value] = [...limits, this.value].map(centimetres);
    const rounded = withUnit(number(this.value * CM, 3), "cm");
    voice.note(isBeyond ? fill(WORDS.bound, { least, most, value }) : fill(WORDS.dragged, { value: rounded }));
  }

  letGo() {
    if (!this.stage.live.isDragging) return;
    this.letGoLater.cancel();
    this.last = this.before;
    this.stage.change(() => this.stage.live.drop(this.value));
  }

  /** Restore the state before the drag. */
  cancel() {
    const { live, playback, voice } = this.stage;
    if (!live.isDragging) return;
    this.letGoLater.cancel();
    const { compression, phase, plainPhase } = this.before;
    this.stage.change(() => {
      live.drag(compression, null);
      Object.assign(playback, { phase, plainPhase });
    });
    voice.note(fill(WORDS.restored, { value: centimetres(compression) }));
  }

  /** Restore x₀ from before the last drag, with all its digits. Return whether a drag could be undone. */
  undo() {
    if (this.button.hidden) return false;
    this.stage.live.send(this.last.compression);
    return true;
  }

  /** Describe x₀ to screen readers, and offer to undo the last drag unless x₀ has been changed since. */
  show() {
    const { node, fixed, value, last, button, stage: { host, limits, live, parameters } } = this;
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
    const canUndo = last && Math.abs(parameters.compression - value) < 1e-9 && Math.abs(last.compression - value) > 1e-9;
    button.hidden = !canUndo || live.isDragging;
    if (canUndo) button.textContent = fill(WORDS.undo, { value: centimetres(last.compression) });
  }
}
