// Turns the steps of a lecture in the browser. All steps are on the page, and one is visible, so a key press does not wait for
// the server. The number of the step is sent later, and the server writes it into the address.

import { bus } from "./bus.js";
import { debounce } from "./lasting.js";
import { dom } from "./streamlit_dom.js";
import { Turner } from "./turning.js";

const PAUSE = 300; // ms from the last turn until the step is sent to the server

export default function (component, signal) {
  const sheet = document.head.appendChild(document.createElement("style"));
  // Page Up, Page Down and the space bar also scroll the page, so they turn only while the lecture is in view.
  const mayTurn = ({ key }) => key.startsWith("Arrow") || dom.inView(dom.lecture());
  const turner = new Turner(component, signal, { sliderEvent: "input", mayTurn, onTurned, onward: dom.onward });
  const send = debounce(PAUSE, () => component.setStateValue("at", { route, step: turner.now }), signal);
  let route;
  signal.addEventListener("abort", () => sheet.remove());

  /** Show the present step and hide all others. */
  function reveal() {
    // The doubled class takes precedence over page.css, which hides all steps.
    const step = `.st-key-step-${turner.now}`;
    sheet.textContent = `#root .st-key-lecture ${step}${step} { display: var(--step, flex); }`;
    bus.publish("step", turner.now);
  }

  function onTurned() {
    reveal();
    send();
  }

  return () => {
    const { data } = component;
    if (data.route !== route) {
      // The lecture begins at the step in the address. After a change of route it begins at the first step.
      const inAddress = Number(new URLSearchParams(location.search).get("step"));
      send.cancel();
      turner.now = !route && data.headings[inAddress - 1] ? inAddress : 1;
      route = data.route;
    }
    turner.show(Math.min(turner.now, data.headings.length));
    reveal();
  };
}
