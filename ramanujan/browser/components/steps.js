// Turns the steps of a lecture in the browser: all steps are on the page, and one of them is visible. No key press waits for
// the server. The server hears afterwards which step is shown, and writes it into the address.

import { bus } from "./bus.js";
import { atRest } from "./lasting.js";
import { dom } from "./streamlit_dom.js";
import { Turner } from "./turning.js";

const TELL = 300; // ms without a press after which the server is told

export default function (component, signal) {
  const sheet = document.head.appendChild(document.createElement("style"));
  // Keys that also scroll the page turn a step only while the lecture is in view.
  const turns = ({ key }) => key.startsWith("Arrow") || dom.inView(dom.lecture());
  const turner = new Turner(component, signal, { moves: "input", turns, turned, onward: dom.onward });
  const tell = atRest(TELL, () => component.setStateValue("at", { route, step: turner.now }), signal);
  let route;
  signal.addEventListener("abort", () => sheet.remove());

  /** Show the present step. The server draws them all. */
  function reveal() {
    const step = `.st-key-step_${turner.now}`;
    sheet.textContent = `#root .st-key-lecture ${step}${step} { display: var(--step, flex); }`;
    bus.publish("step", turner.now);
  }

  function turned() {
    reveal();
    tell();
  }

  return () => {
    const { data } = component;
    if (data.route !== route) {
      // The lecture begins at the step that the address names, every further route at its first step.
      const asked = Number(new URLSearchParams(location.search).get("step"));
      tell.cancel();
      turner.now = !route && data.headings[asked - 1] ? asked : 1;
      route = data.route;
    }
    turner.show(Math.min(turner.now, data.headings.length));
    reveal();
  };
}
