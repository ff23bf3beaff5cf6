// Elements with the same interface for the app's modules as in Streamlit's page: a slider, and a component.

import { begin } from "../browser/begin.js";

/** Begin a component in an element, or call it again there. `send` is called with an event and its value. */
export function mount(outer, name, key, data, send = () => {}) {
  const inner = outer.firstElementChild ?? outer.appendChild(document.createElement("div"));
  inner.dataset.testid = "stBidiComponentIsolated";
  const parentElement = inner.shadowRoot ?? inner.attachShadow({ mode: "open" });
  return begin({ name, key, data, parentElement, setTriggerValue: send, setStateValue: send });
}

/**
 * Make a slider, which sends its value at the end of a drag and after a key stroke. It marks a drag by data-dragging.
 */
export function makeSlider(key, { min, max, step, value, label = "" }, send) {
  const outer = document.createElement("div");
  outer.className = `st-key-${key} slider`;
  outer.innerHTML = '<div role="group"><input type="range" /></div>';
  const group = outer.firstChild, input = group.firstChild;
  Object.assign(input, { min, max, step, ariaLabel: label });
  input.value = value;
  const sendValue = () => send(Number(input.value));
  input.addEventListener("input", () => input.setAttribute("value", input.value)); // the modules observe the attribute
  input.addEventListener("change", sendValue);
  input.addEventListener("keydown", (event) => {
    if (event.isTrusted) return; // the browser moves the thumb itself
    input[event.key === "ArrowRight" ? "stepUp" : "stepDown"]();
    input.dispatchEvent(new Event("input", { bubbles: true }));
    sendValue();
  });
  input.addEventListener("pointerdown", () => group.toggleAttribute("data-dragging", true));
  for (const type of ["pointerup", "pointercancel"])
    input.addEventListener(type, () => group.toggleAttribute("data-dragging", false));
  return outer;
}
