// The head of a slider: its symbol, its meaning, and a box that shows the value in full and takes any number or fraction.
// Only the slider holds the value. The box shows the slider's value, also while the thumb moves. It sends a typed text to the
// server as one message, and no value of its own. The address is written where slider and server agree.

import { bus } from "./bus.js";
import { observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

export default function (component, signal) {
  const { data: { key }, parentElement: root } = component, box = root.querySelector("input");
  let told = {}; // what the server said last: value, text, judged
  box.id = root.querySelector("label").htmlFor = "box";

  const held = () => dom.held(dom.slider(key), told);
  const show = () => {
    if (dom.shows(dom.slider(key), told.value, told)) dom.writeAddress(key, told.value, component.data.default);
    const edited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!edited) box.value = box.dataset.shown = held();
  };

  // The slider is drawn after its head, and may be drawn anew.
  observe(document.body, { subtree: true, attributeFilter: ["value", "aria-valuetext"] }, show, signal);

  const send = (text) => component.setTriggerValue("typed", text);
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
    told = given;
    show();
  }, { signal });
  bus.subscribe(`enter/${key}`, (text) => {
    bus.forget(`enter/${key}`);
    send(text);
  }, { signal });
  return () => {
    const { symbol, unit, meaning, label, longest } = component.data;
    const texts = { ".symbol": symbol, ".unit": `[${unit}]`, small: meaning };
    for (const [selector, text] of Object.entries(texts)) root.querySelector(selector).textContent = text;
    Object.assign(box, { maxLength: longest, ariaLabel: label });
    show();
  };
}
