// Back and forward through the stops of a lesson, by two buttons, a slider and the keys. The server draws one stop at a time,
// so that nothing of the others is on the page. Until it has answered, the stop that was asked for counts.

import { bus } from "./bus.js";
import { Turner } from "./turning.js";

const PATIENCE = 5000; // ms after which an answer that did not come is no longer waited for

export default function (component, signal) {
  const turner = new Turner(component, signal, { moves: "change", turns, turned });
  let asked = null;

  function turned(stop) {
    asked = { stop, held: component.data.held, at: performance.now() };
    bus.publish("turned", stop);
    component.setTriggerValue("to", stop);
  }

  // On a projector, a clicker turns the slides of this stop first.
  function turns({ key }, by) {
    return key.startsWith("Arrow") || (key.startsWith("Page") && component.data.clicker && !bus.last("slides")?.has(by));
  }

  return () => {
    const { now, held, clicker } = component.data;
    // At the desk of a class, the primary button is the one that moves the class.
    component.parentElement.querySelector('[data-by="1"]').classList.toggle("primary", clicker);
    // An older answer cannot take back what was asked for since; a refusal can.
    if (asked && held === asked.held && now !== asked.stop && performance.now() - asked.at < PATIENCE) return;
    asked = null;
    turner.show(now);
  };
}
