// The slab in a hand: dragged by the pointer or moved by the keys, within bounds that give way softly.

import { bus } from "../components/bus.js";
import { atRest } from "../components/lasting.js";
import { fill, number, withUnit } from "../components/sentences.js";
import { CM } from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { clamp } from "./motion.js";
import { set } from "./svg.js";
import { WORDS } from "./texts.js";
import { centimetres } from "./words.js";

const THRESHOLD = { mouse: 4, pen: 6, touch: 9 }; // px that a pointer must move before a click becomes a drag
const GIVE = 0.02; // m, the most by which the slab gives way beyond its bounds
const KEY_STEP = 0.005; // m
const KEY_PAUSE = 400; // ms after the last key stroke until x₀ is sent

/** Where the slab is drawn when a hand wants it elsewhere; the first `slack` beyond a bound are free. */
function yielding(wanted, [least, most], slack = 0) {
  const bound = clamp(wanted, least, most);
  const excess = Math.abs(wanted - bound) - slack;
  if (excess <= 0) return wanted;
  return bound + Math.sign(wanted - bound) * (slack + GIVE * (1 - Math.exp(-excess / (2 * GIVE))));
}

/** What the key wants of the compression, or undefined. */
function keyed(key, compression, [least, most]) {
  const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5 }[key];
  if (steps) return clamp(compression + steps * KEY_STEP, least, most);
  return { Home: least, End: most }[key];
}

/**
 * Drags the slab, and undoes the last drag. A drag lasts from the first move of a pointer, or the first key, until it ends or
 * is cancelled. `hand.isHolding` is true while it lasts.
 */
export class Slab {
  grip = null; // { id, x, from, deformation, slack } of the pointer that is down; `from` as soon as it drags

  constructor(node, stage, signal) {
    // Where x₀ has no room, there is nothing to drag.
    const fixed = stage.compact || stage.limits[0] === stage.limits[1];
    Object.assign(this, { node, stage, fixed, button: stage.root.querySelector(".undo") });
    stage.host.classList.toggle("fixed", fixed);
    if (fixed) return set(node, { "aria-hidden": true });
    this.soon = atRest(KEY_PAUSE, () => this.letGo(), signal); // one message for a run of key strokes
    const on = (type, act, options = {}) => node.addEventListener(type, act, { ...options, signal });
    const ofGrip = (act) => (event) => event.pointerId === this.grip?.id && act(event);
    on("pointerdown", (event) => this.press(event));
    // A finger on the slab drags it, and must not scroll the page as well.
    on("touchstart", (event) => event.preventDefault(), { passive: false });
    on("pointermove", ofGrip((event) => this.drag(event)));
    on("pointercancel", ofGrip(() => this.end(() => this.giveUp())));
    for (const type of ["pointerup", "lostpointercapture"]) on(type, ofGrip(() => this.end(() => this.letGo())));
    on("keydown", (event) => this.key(event));
    on("blur", () => this.grip || this.letGo());
    const elsewhere = (event) => event.composedPath().includes(node) || this.grip || this.letGo();
    document.addEventListener("pointerdown", elsewhere, { capture: true, signal });
  }

  // ---- what a pointer and keys do

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
      this.soon.cancel();
      // Where the slab swings beyond its bounds, it is taken where it is.
      const deformation = FORMULAS.deformation({ ...parameters, ...playback.now() });
      const slack = Math.abs(deformation - clamp(deformation, ...limits));
      Object.assign(grip, { from: picture.toMetres(grip.x), deformation, slack });
    }
    this.compress(grip.deformation + picture.toMetres(clientX) - grip.from, grip.slack);
  }

  end(finish) {
    const dragged = this.grip.from !== undefined;
    this.grip = null;
    if (dragged) finish();
  }

  key(event) {
    if (event.key === "Escape") {
      if (this.grip?.from !== undefined) this.grip = null;
      return this.giveUp();
    }
    const wanted = keyed(event.key, this.compression(), this.stage.limits);
    if (wanted === undefined || this.grip || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.compress(wanted);
    this.soon();
  }

  // ---- what this does to the stage

  compression() {
    return clamp(this.stage.parameters.compression, ...this.stage.limits);
  }

  /** Hold the machine at rest with the spring compressed by so much, to a step of its slider. */
  compress(wanted, slack = 0) {
    const { limits, hand, playback, parameters, voice } = this.stage, { phase, plainPhase } = playback;
    if (!hand.isHolding) this.before = { compression: parameters.compression, text: hand.text(), phase, plainPhase };
    const bound = clamp(wanted, ...limits), beyond = bound !== wanted;
    this.value = hand.rounded(bound);
    this.stage.change(() => {
      hand.hold(this.value, beyond ? yielding(wanted, limits, slack) : this.value);
      playback.reset();
    });
    const [least, most, value] = [...limits, this.value].map(centimetres);
    const held = withUnit(number(this.value * CM, 3), "cm");
    voice.note(beyond ? fill(WORDS.bound, { least, most, value }) : fill(WORDS.held, { value: held }));
  }

  letGo() {
    if (!this.stage.hand.isHolding) return;
    this.soon.cancel();
    this.last = this.before;
    this.stage.change(() => this.stage.hand.drop(this.value));
  }

  /** Have everything as it was when the slab was taken. */
  giveUp() {
    const { hand, playback, voice } = this.stage;
    if (!hand.isHolding) return;
    this.soon.cancel();
    const { compression, phase, plainPhase } = this.before;
    this.stage.change(() => {
      hand.giveUp(compression);
      Object.assign(playback, { phase, plainPhase });
    });
    voice.note(fill(WORDS.kept, { value: centimetres(compression) }));
  }

  /** Set the x₀ from before the slab was last let go, with all of its digits; return whether there was one. */
  undo() {
    if (this.button.hidden) return false;
    bus.publish(`enter/${this.stage.hand.slabKey}`, this.last.text);
    return true;
  }

  /** Show x₀ to those who cannot see it, and the way back as long as nobody else has set another. */
  show() {
    const { node, fixed, value, last, button, stage: { host, limits, hand, parameters } } = this;
    if (fixed) return;
    const [least, most, now] = [...limits, this.compression()].map((metres) => metres * CM);
    node.querySelector(".handle text").textContent = fill(WORDS.drag, { value: centimetres(this.compression()) });
    host.classList.toggle("held", hand.isHolding);
    // With its value: before that it is no slider.
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
    const back = last && Math.abs(parameters.compression - value) < 1e-9 && Math.abs(last.compression - value) > 1e-9;
    button.hidden = !back || hand.isHolding;
    if (back) button.textContent = fill(WORDS.undo, { value: centimetres(last.compression) });
  }
}
