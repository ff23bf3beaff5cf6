// The head of a slider: symbol, meaning and box. The box shows the full value and accepts any number or fraction. Only the slider
// stores the value. The box shows the slider's value, also during a drag, and sends each typed text to the server. When slider
// and server agree, the value is written into the address.

import { bus } from "./bus.js";
import { DECIMAL } from "./language.js";
import { observe } from "./lasting.js";
import { makeSnap } from "./snap.js";
import { dom } from "./streamlit_dom.js";

export default function (component, signal) {
  const { data: { key }, parentElement: root } = component, box = root.querySelector("input");
  let received = {}; // the last data from the server: value, text, and `processed`, the number of processed inputs
  box.id = root.querySelector("label").htmlFor = "box";

  const send = (text) => component.setTriggerValue("typed", text);
  // In some languages, a point before three digits would be a thousands separator, so send the decimal mark.
  const sendValue = (text) => send(text.replace(".", DECIMAL));
  const snap = makeSnap(key, sendValue, signal);

  const write = () => {
    const slider = dom.slider(key), isMoved = slider && !dom.shows(slider, received.value, received);
    const text = isMoved ? String(dom.value(slider)) : received.text ?? "";
    box.value = box.dataset.shown = text.replace(".", DECIMAL);
  };
  const show = () => {
    // Streamlit's server always writes the complete address, which can be older than the slider.
    if (dom.shows(dom.slider(key), received.value, received)) dom.writeSettings([[key, received.value, component.data.default]]);
    const isEdited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!isEdited) write();
  };
  const sendTyped = () => {
    if (box.value === box.dataset.shown) return;
    box.dataset.shown = box.value;
    send(box.value);
  };

  // Streamlit draws the slider after its head, and may redraw it.
  observe(document.body, { subtree: true, attributeFilter: ["value", "aria-valuetext"] }, () => {
    snap.follow();
    show();
  }, signal);
  box.addEventListener("change", sendTyped);
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") sendTyped();
    if (event.key !== "Escape") return;
    write();
    box.select();
  });
  bus.subscribe(`exact/${key}`, (data) => {
    received = data;
    show();
  }, { signal });
  bus.subscribe(`enter/${key}`, (text) => {
    bus.forget(`enter/${key}`);
    snap.moveTo(Number(text));
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
