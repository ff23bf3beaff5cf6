// Turns the stops of a lesson by two buttons, a slider and keys. The server draws one stop at a time, and the page does not
// contain the others. Until the server answers, the control shows the requested stop.

import { bus } from "./bus.js";
import { Turner } from "./turning.js";

const TIMEOUT = 5000; // ms after which a request without an answer is dropped

export default function (component, signal) {
  const turner = new Turner(component, signal, { sliderEvent: "change", mayTurn, onTurned });
  let request = null; // { stop, refusal, time } of the last turn without an answer

  function onTurned(stop) {
    request = { stop, refusal: component.data.refusal, time: performance.now() };
    bus.publish("turned", stop);
    component.setTriggerValue("to", stop);
  }

  // On a projector, a clicker's page keys first turn the slides of the present stop, up to the first or last one.
  function mayTurn({ key }, by) {
    const isAtEndOfSlides = !bus.last("slides")?.has(by);
    return key.startsWith("Arrow") || (key.startsWith("Page") && component.data.page_keys_turn && isAtEndOfSlides);
  }

  return () => {
    const { now, refusal, page_keys_turn: pageKeysTurn } = component.data;
    // At the desk of a class, another button is primary: the one that moves the class.
    component.parentElement.querySelector('[data-by="1"]').classList.toggle("primary", pageKeysTurn);
    // Ignore the answer to an earlier request, unless it is a refusal.
    const isPending = request && refusal === request.refusal && performance.now() - request.time < TIMEOUT;
    if (isPending && now !== request.stop) return;
    request = null;
    turner.show(now);
  };
}
