// The head of a slider: its symbol, its meaning, and a box that shows the value in full and takes any number or fraction.
// Only the slider holds the value. The box shows the slider's value, also while the thumb moves. It sends a typed text to the
// server as one message, and no value of its own. When slider and server agree, the address is written. The topic goal/KEY names
// a value between the slider's steps. A thumb that comes near snaps to it, and the page sends it as if it were typed.

import { bus } from "./bus.js";
import { DECIMAL } from "./language.js";
import { atRest, observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const NEAR = 6; // px from the goal within which a thumb snaps to it; a key snaps within a step
const PAUSE = 400; // ms after the last move until the goal is sent: the slider sends its step before

export default function (component, signal) {
  const { data: { key }, parentElement: root } = component, box = root.querySelector("input");
  let received = {}; // what the server said last: value, text, judged
  box.id = root.querySelector("label").htmlFor = "box";

  const held = () => dom.held(dom.slider(key), received).replace(".", DECIMAL);
  const show = () => {
    if (dom.shows(dom.slider(key), received.value, received)) dom.writeAddress(key, received.value, component.data.default);
    const edited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!edited) box.value = box.dataset.shown = held();
  };

  const send = (text) => component.setTriggerValue("typed", text);
  // In the other languages a point before three digits could separate thousands.
  const sendValue = (text) => send(text.replace(".", DECIMAL));
  let seen, before, by; // what the slider showed last, what it held, and what moves it since: a "key", or a "thumb" let go
  const arrived = atRest(PAUSE, () => {
    const slider = dom.slider(key), goal = bus.last(`goal/${key}`);
    by = null;
    if (dom.isDragged(slider)) arrived();
    else if (slider && dom.value(slider) === goal && received.value !== goal) sendValue(String(goal));
  }, signal);
  const settle = (slider, value) => {
    dom.snap(slider, value);
    seen = slider.value;
    before = dom.value(slider);
  };
  const snap = () => {
    const slider = dom.slider(key), goal = bus.last(`goal/${key}`);
    if (!slider || slider.value === seen) return;
    const reach = { thumb: NEAR * dom.perPixel(slider), key: before !== goal && Number(slider.step) };
    // On a slow page a thumb is drawn at its last place when it has been let go.
    const within = reach[dom.isDragged(slider) ? "thumb" : by];
    const near = Boolean(within && goal) && Math.abs(slider.value - goal) <= within;
    settle(slider, near ? goal : null);
    by = null;
    if (near) arrived();
  };
  for (const type of ["keydown", "pointerup"])
    addEventListener(type, (event) => {
      const slider = dom.slider(key), pressed = event.type === "keydown" && event.composedPath().includes(slider);
      by = pressed ? "key" : dom.isDragged(slider) && "thumb";
      if (!pressed) arrived();
    }, { capture: true, signal });

  // Streamlit draws the slider after its head, and may draw it anew.
  observe(document.body, { subtree: true, attributeFilter: ["value", "aria-valuetext"] }, () => {
    snap();
    show();
  }, signal);

  const commit = () => {
    if (box.value === box.dataset.shown) return;
    box.dataset.shown = box.value;
    send(box.value);
  };
  box.addEventListener("change", commit);
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key !== "Escape") return;
    box.value = box.dataset.shown = held();
    box.select();
  });

  bus.subscribe(`exact/${key}`, (given) => {
    received = given;
    before = given.value;
    show();
  }, { signal });
  bus.subscribe(`enter/${key}`, (text) => {
    bus.forget(`enter/${key}`);
    const slider = dom.slider(key);
    if (slider) settle(slider, Number(text));
    sendValue(text);
  }, { signal });
  return () => {
    const { symbol, unit, meaning, label, longest } = component.data;
    const texts = { ".symbol": symbol, ".unit": `[${unit}]`, small: meaning };
    for (const [selector, text] of Object.entries(texts)) root.querySelector(selector).textContent = text;
    Object.assign(box, { maxLength: longest, ariaLabel: label });
    show();
  };
}
