// The slab in a hand: dragged by the pointer or moved by the keys, within bounds that give way softly.

import { bus } from "../page/bus.js";
import { fill, number, withUnit } from "../page/sentences.js";
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
 * Listen to the slab's node. `stage` answers: deformation() [m], compression() [m], take(), compress(wanted, slack),
 * letGo(), giveUp().
 */
function listenToSlab(node, { picture, limits, stage, signal }) {
  let grip = null; // { id, x, from, slack } of the pointer that is down; `from` as soon as it drags
  let typing = 0; // timer of a run of key strokes
  const on = (type, handler, options = {}) => node.addEventListener(type, handler, { ...options, signal });

  on("pointerdown", (event) => {
    if (grip || event.button !== 0 || !event.isPrimary) return;
    grip = { id: event.pointerId, x: event.clientX };
    node.setPointerCapture(event.pointerId);
    event.preventDefault();
    node.focus({ preventScroll: true });
  });
  // A finger on the slab drags it, and must not scroll the page as well.
  on("touchstart", (event) => event.preventDefault(), { passive: false });

  on("pointermove", (event) => {
    if (event.pointerId !== grip?.id) return;
    if (grip.from === undefined && !begin(event)) return;
    stage.compress(grip.deformation + picture.toMetres(event.clientX) - grip.from, grip.slack);
  });

  function begin(event) {
    const threshold = THRESHOLD[event.pointerType] ?? THRESHOLD.touch;
    if (Math.abs(event.clientX - grip.x) < threshold) return false;
    const deformation = stage.deformation();
    if (!typing) stage.take();
    clearTimeout(typing);
    typing = 0;
    // Where the slab swings beyond its bounds, it is taken where it is.
    const slack = Math.abs(deformation - clamp(deformation, ...limits));
    Object.assign(grip, { from: picture.toMetres(grip.x), deformation, slack });
    return true;
  }

  function end(finish) {
    const dragged = grip?.from !== undefined;
    grip = null;
    if (dragged) finish();
  }
  on("pointerup", (event) => event.pointerId === grip?.id && end(() => stage.letGo()));
  on("pointercancel", (event) => event.pointerId === grip?.id && end(() => stage.giveUp()));
  on("lostpointercapture", (event) => event.pointerId === grip?.id && end(() => stage.letGo()));

  const endTyping = (finish) => {
    if (!typing) return;
    clearTimeout(typing);
    typing = 0;
    finish();
  };
  on("keydown", (event) => {
    if (event.key === "Escape") {
      if (grip?.from !== undefined) end(() => stage.giveUp());
      else endTyping(() => stage.giveUp());
      return;
    }
    const wanted = keyed(event.key, stage.compression(), limits);
    if (wanted === undefined || grip || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    if (!typing) stage.take();
    stage.compress(wanted);
    clearTimeout(typing);
    typing = setTimeout(() => endTyping(() => stage.letGo()), KEY_PAUSE); // one message for a run of key strokes
  });
  const leave = () => endTyping(() => stage.letGo());
  on("blur", leave);
  const elsewhere = (event) => event.composedPath().includes(node) || leave();
  document.addEventListener("pointerdown", elsewhere, { capture: true, signal });
  signal.addEventListener("abort", () => clearTimeout(typing));
}

/** What a hand on the slab does to its stage, and how the last x₀ is had back. */
export class Slab {
  constructor(node, stage, signal) {
    // Where x₀ has no room, there is nothing to drag.
    const fixed = stage.compact || stage.limits[0] === stage.limits[1];
    Object.assign(this, { node, stage, fixed, button: stage.root.querySelector(".undo") });
    stage.host.classList.toggle("fixed", fixed);
    if (fixed) set(node, { "aria-hidden": true });
    else bus.subscribe("dragged", () => stage.host.classList.add("dragged"), { signal });
    if (!fixed) listenToSlab(node, { picture: stage.picture, limits: stage.limits, stage: this, signal });
  }

  deformation() {
    const { parameters, playback } = this.stage;
    return FORMULAS.deformation({ ...parameters, ...playback.now() });
  }

  compression() {
    return clamp(this.stage.parameters.compression, ...this.stage.limits);
  }

  take() {
    const { hand, playback, host } = this.stage;
    this.before = { compression: this.stage.parameters.compression, text: hand.text(), phase: playback.phase, plainPhase: playback.plainPhase };
    host.classList.add("held");
  }

  /** Hold the machine at rest with the spring compressed by so much, to a step of its slider. */
  compress(wanted, slack = 0) {
    const { limits, hand, playback } = this.stage;
    const bound = clamp(wanted, ...limits), beyond = bound !== wanted;
    this.value = hand.rounded(bound);
    const drawn = beyond ? yielding(wanted, limits, slack) : this.value;
    this.stage.change(() => {
      hand.hold(this.value, drawn);
      playback.reset();
    });
    const [least, most] = limits.map(centimetres), value = centimetres(this.value);
    this.stage.voice.note(beyond ? fill(WORDS.bound, { least, most, value }) : fill(WORDS.held, { value: withUnit(number(this.value * CM, 3), "cm") }));
  }

  letGo() {
    this.stage.change(() => this.stage.hand.drop(this.value));
    this.stage.host.classList.remove("held");
    bus.publish("dragged", true);
    this.last = this.before.compression;
    this.show(this.value);
  }

  /** Have everything as it was when the slab was taken. */
  giveUp() {
    const { hand, playback } = this.stage, { compression, phase, plainPhase } = this.before;
    this.stage.change(() => {
      hand.giveUp(compression);
      Object.assign(playback, { phase, plainPhase });
    });
    this.stage.voice.note(fill(WORDS.kept, { value: centimetres(compression) }));
    this.stage.host.classList.remove("held");
  }

  /** Set the x₀ from before the slab was last let go, with all of its digits; return whether there was one. */
  undo() {
    if (this.button.hidden) return false;
    bus.publish(`enter/${this.stage.hand.slabKey}`, this.before.text);
    return true;
  }

  /** Show x₀ to those who cannot see it, and the way back as long as nobody else has set another. */
  show(compression) {
    if (this.fixed) return;
    const [least, most] = this.stage.limits, value = this.compression();
    // With its value: before that it is no slider.
    set(this.node, {
      role: "slider",
      tabindex: 0,
      "aria-label": WORDS.slab_slider,
      "aria-orientation": "horizontal",
      "aria-valuemin": least * CM,
      "aria-valuemax": most * CM,
      "aria-valuenow": value * CM,
      "aria-valuetext": withUnit(number(value * CM, 3), "cm"),
    });
    const back = this.last !== undefined && Math.abs(compression - this.value) < 1e-9 && Math.abs(this.last - this.value) > 1e-9;
    this.button.hidden = !back || this.stage.hand.isHolding;
    if (back) this.button.textContent = fill(WORDS.undo, { value: centimetres(this.last) });
  }
}
