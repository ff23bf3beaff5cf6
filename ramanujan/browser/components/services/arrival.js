// Requests the second run of the first page, with everything except the machine, once the machine moves
// (shell/first_run.py).

import { bus } from "../../bus.js";

const PATIENCE = 10000; // ms after which the second run is requested even if no machine moves

export default function (component, signal) {
  let isRequested = false;
  const requestSecondRun = () => {
    if (isRequested || !component.data.needs_second_run) return;
    isRequested = true;
    component.setStateValue("moving", true);
  };
  // The first drawing is on the screen when the next frame begins.
  bus.subscribe("time/oscillator", () => isRequested || requestAnimationFrame(requestSecondRun), { signal });
  setTimeout(requestSecondRun, PATIENCE);
}
