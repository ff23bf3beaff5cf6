// The head of a slider: symbol, meaning, and a box that shows the full value and accepts any number or fraction.
// Only the slider stores the value. The box shows the slider's value, also during a drag, and sends each typed text to the
// server. When slider and server agree, the value is written into the address. The topic goal/KEY contains a value between
// the slider's steps. A thumb near this value snaps to it, and the page sends it like a typed value.

import { bus } from "./bus.js";
import { DECIMAL } from "./language.js";
import { atRest, observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const NEAR = 6; // px, the distance from the goal within which a thumb snaps to it; after a key stroke, the distance is a step
const PAUSE = 400; // ms after the last move until the goal is sent: the slider sends its step before

export default function (component, signal) {
  const { data: { key }, parentElement: root } = component, box = root.querySelector("input");
  let received = {}; // the last data from the server: value, text, judged
  box.id = root.querySelector("label").htmlFor = "box";

  const held = () => dom.held(dom.slider(key), received).replace(".", DECIMAL);
  const show = () => {
    if (dom.shows(dom.slider(key), received.value, received)) dom.writeAddress(key, received.value, component.data.default);
    const edited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!edited) box.value = box.dataset.shown = held();
  };

  const send = (text) => component.setTriggerValue("typed", text);
  // In some languages, a point before three digits would be a thousands separator.
  const sendValue = (text) => send(text.replace(".", DECIMAL));
  let seen, before, by; // the slider's last shown value, its last full value, and the cause of its move: "key" or "thumb"
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
    // On a slow page, the last move of a thumb is drawn after its release.
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

  // Streamlit draws the slider after its head, and may redraw it.
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
