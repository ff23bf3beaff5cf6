// Streamlit's sliders: selectors of their inputs, and functions that read, move and mark them. Only Streamlit sends
// their values to the server.

import { bus } from "./bus.js";
import { observe } from "./lasting.js";

// Key of a slider → the value that the visitor wants, until the server has it. The thumb is at its nearest step.
const wanted = new Map();

export const sliders = {
  /** The input of the Streamlit slider with this key; its value follows the thumb during a drag. */
  find: (key) => document.querySelector(`.st-key-${CSS.escape(key)} input[type="range"]`),

  /** Whether a thumb is at the step nearest to a value. */
  isAt: (input, value) => Math.abs(input.value - value) <= 0.501 * input.step,

  /** Whether a slider shows the server's value: exactly if the visitor wants a value, or else rounded to a step. */
  shows(key, value) {
    const input = sliders.find(key);
    if (wanted.has(key)) return Math.abs(wanted.get(key) - value) < 1e-9;
    return !input || sliders.isAt(input, value);
  },

  /** A slider's value: the wanted value, the server's, or that of a thumb that has left it. */
  value(key) {
    const stored = bus.last(`exact/${key}`)?.value;
    return wanted.get(key) ?? (sliders.shows(key, stored) ? stored : Number(sliders.find(key).value));
  },

  /** The value that the visitor wants for a slider, if the server does not have it yet. */
  wanted: (key) => wanted.get(key),

  /** Store the value that the visitor wants for a slider, and move its thumb to the nearest step. */
  want(key, value) {
    wanted.set(key, value);
    draw(sliders.find(key), value);
  },

  /** Let a slider follow the server again. */
  forget: (key) => wanted.delete(key),

  /** Whether a slider's value is between two of its steps. */
  isBetweenSteps(key) {
    const { min, step } = sliders.find(key) ?? {}, steps = (sliders.value(key) - min) / step;
    return Math.abs(steps - Math.round(steps)) > 1e-6;
  },

  /**
   * Format every slider's number by a function, above the thumb and for screen readers, until the signal aborts.
   * React's text remains in the page, but streamlit.css hides it if the formatted text exists.
   */
  watchValues(write, signal) {
    const update = () => {
      for (const input of document.querySelectorAll("[data-testid=stSlider] input[type=range]")) {
        const text = input.ariaValueText ?? "";
        if (!/^-?\d+(\.\d+)?$/.test(text)) continue;
        const thumb = input.closest("[data-testid=stSlider]").querySelector("[data-testid=stSliderThumbValue]");
        const written = write(text);
        if (written !== text) input.ariaValueText = written;
        if (thumb && thumb.dataset.written !== written) thumb.dataset.written = written;
      }
    };
    observe(document.body, { subtree: true, childList: true, attributeFilter: ["aria-valuetext"] }, update, signal);
    update();
  },

  /** Whether a slider's thumb is being dragged. */
  isDragged: (slider) => Boolean(slider?.closest("[data-dragging]")),

  /**
   * Show the part of a slider's track up to a value, or all of it for a larger one. The style sheets enlarge the track
   * by --zoom, and cut off the rest. Streamlit would replace a slider whose range changes, and so end a drag.
   */
  showUpTo(slider, value) {
    const most = Math.min(Math.round(value / slider.step) * slider.step, slider.max);
    const zoom = (slider.max - slider.min) / (most - slider.min);
    slider.closest("[class*=st-key-]").style.setProperty("--zoom", zoom);
  },

  /** The largest value on the shown part of a slider's track. */
  largestShown(slider) {
    const zoom = Number(slider.closest("[class*=st-key-]").style.getPropertyValue("--zoom")) || 1;
    return Number((Number(slider.min) + (slider.max - slider.min) / zoom).toPrecision(10));
  },

  /** Move a slider's thumb on the page, without a message. */
  move(key, value) {
    sliders.forget(key);
    draw(sliders.find(key), value);
  },

  /** Send a value by an enabled slider: move it to the adjacent step, then to the value by an arrow key. */
  send(key, value) {
    const input = sliders.find(key);
    if (!input || input.disabled) return;
    const [by, arrow] = value - input.min < input.step ? [1, "ArrowLeft"] : [-1, "ArrowRight"];
    draw(input, value + by * input.step);
    const stroke = new KeyboardEvent("keydown", { key: arrow, bubbles: true, cancelable: true });
    // React draws the slider in a microtask, which is already queued.
    queueMicrotask(() => input.dispatchEvent(stroke));
  },

  /**
   * Until the signal aborts, send the value of every thumb that was released without a connection, as soon as its
   * slider is enabled. Streamlit disables all sliders while there is no connection, and then ignores the end of a drag.
   */
  watchReleased(signal) {
    const released = new Set();
    const store = () => {
      for (const input of document.querySelectorAll("[data-testid=stSlider] [data-dragging] input:disabled"))
        released.add(input);
    };
    const send = () => {
      for (const input of released) {
        if (input.disabled) continue;
        released.delete(input);
        sliders.send(keyOf(input), Number(input.value));
      }
    };
    for (const type of ["pointerup", "pointercancel"]) addEventListener(type, store, { capture: true, signal });
    observe(document.body, { subtree: true, childList: true, attributeFilter: ["disabled"] }, send, signal);
  },

  /**
   * Mark a value on a slider's track, with a word below it; the page.css of the story draws them. Return whether the
   * slider exists.
   */
  mark(key, value, word) {
    const input = sliders.find(key), style = input?.closest(`.st-key-${CSS.escape(key)}`).style;
    style?.setProperty("--mark", (value - input.min) / (input.max - input.min));
    style?.setProperty("--mark-word", JSON.stringify(word));
    return Boolean(style);
  },

  /** Whether a node is part of the draggable area of a Streamlit slider. */
  isTrack: (node) => Boolean(node.closest?.("[data-testid=stSlider] [role=group]")),
};

/** The key of the slider with this input. */
const keyOf = (input) => /st-key-([\w-]+)/.exec(input.closest("[class*=st-key-]").className)[1];

/**
 * Draw a slider's thumb at a value. The event triggers React's handler, and Streamlit moves the thumb to a step.
 * Streamlit sends values only after a drag or a key stroke (streamlit#4541).
 */
function draw(input, value) {
  if (!input) return;
  Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set.call(input, value);
  input.dispatchEvent(new Event("input", { bubbles: true }));
}
