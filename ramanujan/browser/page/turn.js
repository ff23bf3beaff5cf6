// Back and forward through the stops of a lesson, by two buttons, a slider and the keys. The server draws one stop at a time,
// so that nothing of the others is on the page. Until it has answered, the stop that was asked for counts.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { showPlace, turnOf } from "./turning.js";

const PATIENCE = 5000; // ms after which an answer that did not come is no longer waited for

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, (signal) => turner(parentElement, signal));
  begun.receive(data, (to) => setTriggerValue("to", to));
  return end;
}

function turner(root, signal) {
  const slider = root.querySelector("input");
  let data, send, now, asked = null;

  /** Go to a stop, and return whether there was one to go to. */
  const go = (stop) => {
    const to = Math.min(Math.max(stop, 1), data.headings.length);
    if (to === now) return false;
    asked = { stop: to, at: performance.now() };
    bus.publish("turned", to);
    now = to;
    showPlace(root, data, now, true);
    send(to);
    return true;
  };

  const on = (node, type, handler) => node.addEventListener(type, handler, { signal });
  for (const button of root.querySelectorAll("button")) on(button, "click", () => go(now + Number(button.dataset.by)));
  on(slider, "change", () => go(Number(slider.value)));
  on(document, "keydown", (event) => {
    const by = turnOf(event, { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 });
    if (!by) return;
    if (event.composedPath()[0].matches?.(dom.TAKES_KEYS)) return;
    if (event.key.startsWith("Page") && !data.clicker) return;
    // On a projector, a clicker turns the sheets of this stop first.
    if (event.key.startsWith("Page") && bus.last("sheets")?.has(by)) return;
    if (go(now + by)) event.preventDefault();
  });

  const receive = (given, sender) => {
    [data, send] = [given, sender];
    slider.max = data.headings.length;
    // An older answer cannot take back what was asked for since.
    if (asked && data.now !== asked.stop && performance.now() - asked.at < PATIENCE) return;
    asked = null;
    now = data.now;
    showPlace(root, data, now, false);
  };
  return { receive };
}
