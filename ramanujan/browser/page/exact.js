// The head of a slider: its symbol, its meaning, and a box that shows the value in full and takes any number or fraction.
// The slider is the only holder of the value. The box shows what the slider holds, also while it moves, and hands a typed
// text to the server as one message; it sends no value of its own. The address follows slider and server where they agree.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, (signal) => exactBox(parentElement, data.key, signal));
  begun.send = (text) => setTriggerValue("typed", text);
  return end;
}

function exactBox(root, key, signal) {
  const box = root.querySelector("input"), begun = {};
  let data; // what the library knows of the slider of this key
  let told = {}; // what the server said last: value, text, judged
  let watched;
  box.id = root.querySelector("label").htmlFor = "box";

  const held = () => dom.held(dom.slider(key), told);
  const show = () => {
    if (data && dom.shows(dom.slider(key), told.value)) dom.writeAddress(key, told.value, data.default);
    const edited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!edited) box.value = box.dataset.shown = held();
  };

  const changes = new MutationObserver(show);
  signal.addEventListener("abort", () => changes.disconnect());
  const watch = () => {
    const slider = dom.slider(key);
    if (!slider || slider === watched) return;
    watched = slider;
    changes.disconnect();
    changes.observe(slider, { attributes: true, attributeFilter: ["value", "aria-valuetext"] });
  };
  // The slider is drawn after its head, and may be drawn anew.
  for (const type of ["pointerdown", "focusin"]) document.addEventListener(type, () => watch(), { capture: true, signal });

  const commit = () => {
    if (box.value === box.dataset.shown) return;
    box.dataset.shown = box.value;
    begun.send(box.value);
  };
  box.addEventListener("change", commit, { signal });
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key !== "Escape") return;
    box.value = box.dataset.shown = held();
    box.select();
  }, { signal });

  bus.subscribe(`box/${key}`, (given) => {
    data = given;
    box.maxLength = data.longest;
    box.setAttribute("aria-label", data.label);
    for (const [selector, text] of [[".symbol", data.symbol], [".unit", `[${data.unit}]`], ["small", data.meaning]])
      root.querySelector(selector).textContent = text;
    show();
  }, { signal });
  bus.subscribe(`exact/${key}`, (given) => {
    told = given;
    watch();
    show();
  }, { signal });
  bus.subscribe(`enter/${key}`, (text) => {
    bus.forget(`enter/${key}`);
    begun.send(text);
  }, { signal });
  return begun;
}
