// Sets a slider to what the visitor wants: by a key, a drag, a typed value or a preset. The wanted value (sliders.js)
// always wins over the values of the server until the server has it, so that a late answer moves nothing.
//
// A value on a step is sent by the slider, and a value between two steps like a typed one. A drag and a key go from
// step to step, with Shift to fine steps. The step nearest to a goal is replaced by the goal.

import { bus } from "../../bus.js";
import { debounce, observe } from "../../lasting.js";
import { dom } from "../../streamlit_dom.js";
import { plotly } from "../../plotly.js";
import { sliders } from "../../sliders.js";

const PAUSE = 200; // ms from the last move until a value is sent
const whenIdle = globalThis.requestIdleCallback ?? setTimeout; // WebKit has only the latter
const FINE = 0.1; // the step with Shift, in steps of the slider
const STEPS = {
  ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10, Home: -Infinity, End: Infinity,
};

/** The nearest multiple of a step, or the goal that replaces it. */
const snap = (value, step, goals) => {
  const index = Math.round(value / step);
  return goals.find((goal) => Math.round(goal / step) === index) ?? Number((index * step).toPrecision(10));
};

/**
 * Return a function that sets the slider with this key to a value; without a value within its range, the server will
 * choose one. `goals` returns the values of the goals. `sendText` sends a value like a typed one. `show` is called
 * after each change of the value.
 */
export function makeSetter(key, { goals, sendText, show }, signal) {
  let held = null; // the event by which the visitor has taken the thumb, until the page has drawn its last move
  let isUndrawn = false; // whether the pointer has moved since the page has drawn the held thumb
  let isUnsent = false; // whether the visitor has set a value that is sent after a pause
  const on = (type, listener, node = window) => node.addEventListener(type, listener, { capture: true, signal });
  const stored = () => bus.last(`exact/${key}`)?.value;

  const send = () => {
    const value = sliders.wanted(key);
    if (value === undefined || (sliders.find(key)?.disabled ?? true)) return;
    isUnsent = false;
    sliders.want(key, value); // draws the thumb, which an outdated value may have moved
    sliders.isBetweenSteps(key) ? sendText(String(value)) : sliders.send(key, value);
  };

  /** Send the wanted value if it is new, or if the server has answered with another one. Forget a stored value. */
  const settle = debounce(PAUSE, () => {
    if (held || sliders.wanted(key) === undefined) return;
    const isStored = sliders.shows(key, stored());
    if (isUnsent || (!isStored && !dom.isRunning())) send();
    if (isStored) sliders.forget(key);
  }, signal);

  const set = (value) => {
    const { min, max } = sliders.find(key) ?? {};
    isUnsent = false;
    value >= min && value <= max ? sliders.want(key, value) : sliders.forget(key);
    show();
  };

  /** Set a value by hand, which is sent after the last move. */
  const setByHand = (value) => {
    set(value);
    isUnsent = true;
    settle();
  };

  const pressKey = (event) => {
    const slider = sliders.find(key), hasModifier = event.ctrlKey || event.altKey || event.metaKey;
    if (!event.isTrusted || hasModifier || event.target !== slider || !(event.key in STEPS)) return;
    // Streamlit would move the slider by whole steps.
    event.preventDefault();
    event.stopPropagation();
    const step = slider.step * (event.shiftKey ? FINE : 1), value = sliders.value(key);
    const next = (Math.round(value / step) + STEPS[event.key]) * step;
    setByHand(snap(Math.min(Math.max(next, slider.min), slider.max), step, goals()));
    if (sliders.isBetweenSteps(key)) slider.ariaValueText = Number(sliders.value(key).toFixed(4)); // is read aloud
  };

  /** Draw the wanted value again, and send it, unless the visitor holds the thumb. */
  const restore = () => {
    const slider = sliders.find(key), value = sliders.wanted(key);
    if (!slider || value === undefined || sliders.isAt(slider, value)) return;
    held ? sliders.want(key, value) : send();
  };

  /** Follow a thumb that the visitor moves. Move it back if an outdated answer of the server has moved it. */
  const follow = () => {
    const slider = sliders.find(key);
    if (!slider || sliders.isAt(slider, sliders.wanted(key) ?? stored())) return;
    // Before the frame is drawn, `sliders.send` moves the thumb away and back.
    if (!held || !isUndrawn) return requestAnimationFrame(restore);
    isUndrawn = false;
    setByHand(snap(Math.min(slider.value, sliders.largestShown(slider)), slider.step, goals()));
  };

  const press = (event) => {
    held = sliders.find(key)?.closest("[role=group]").contains(event.target) ? event : null;
    isUndrawn = true; // a press on the track moves the thumb, too
  };
  /** Follow the server after a click on a curve or on a button, which may set another value. */
  const yieldTo = (event) => {
    const [target] = event.composedPath();
    if (!plotly.graphOf(target) && !dom.isButton(target)) return;
    if (isUnsent) send();
    if (!isUnsent) sliders.forget(key);
  };
  const release = () => {
    const taken = held;
    // A busy page draws the last move of a thumb after its release. A thumb that was not moved keeps its value.
    if (held) whenIdle(() => {
      if (held !== taken) return;
      held = null;
      setByHand(sliders.value(key));
    }, { timeout: PAUSE });
  };
  on("pointerdown", press);
  on("pointermove", ({ buttons }) => (isUndrawn ||= buttons > 0));
  // A click comes after the text that leaving a box has entered.
  for (const type of ["pointerdown", "click"]) on(type, yieldTo);
  on("pointerup", release);
  on("pointercancel", release);
  on("keydown", pressKey, document.body);
  observe(document.body, { subtree: true, attributeFilter: ["value"] }, follow, signal);
  dom.watchConnection(settle, signal);
  dom.watchLeaving(() => {
    settle.cancel();
    sliders.forget(key);
  }, signal);
  bus.subscribe(`exact/${key}`, settle, { signal });
  return set;
}
