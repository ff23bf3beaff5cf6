// Back and forward through the stops of a lesson, by two buttons, a slider and the keys. The server draws one stop at a time,
// so that nothing of the others is on the page. Until it has answered, the stop that was asked for counts.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { Turner, turnOf } from "./turning.js";

const PATIENCE = 5000; // ms after which an answer that did not come is no longer waited for

export default function (component, signal) {
  const turner = new Turner(component, signal, { moves: "change", keyed, turned });
  let asked = null;

  function turned(stop) {
    asked = { stop, at: performance.now() };
    bus.publish("turned", stop);
    component.setTriggerValue("to", stop);
  }

  function keyed(event) {
    const by = turnOf(event, { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 });
    if (!by || event.composedPath()[0].matches?.(dom.TAKES_KEYS)) return 0;
    // On a projector, a clicker turns the sheets of this stop first.
    const ofPages = event.key.startsWith("Page") && (!component.data.clicker || bus.last("sheets")?.has(by));
    return ofPages ? 0 : by;
  }

  return () => {
    const { now } = component.data;
    // An older answer cannot take back what was asked for since.
    if (asked && now !== asked.stop && performance.now() - asked.at < PATIENCE) return;
    asked = null;
    turner.show(now);
  };
}
