// A stopwatch: started and stopped by hand, it runs on the page and tells the server the time between.

import { bus } from "./bus.js";
import { fill } from "./sentences.js";

export default function (component, signal) {
  const button = component.parentElement.querySelector("button"), output = component.parentElement.querySelector("output");
  let started = null, shown = 0, frame = 0;

  const write = () => {
    const { start, stop, seconds } = component.data;
    button.textContent = started === null ? start : stop;
    output.textContent = fill(seconds, { seconds: shown.toFixed(started === null ? 2 : 1) });
  };
  const tick = () => {
    shown = (performance.now() - started) / 1000;
    write();
    frame = requestAnimationFrame(tick);
  };
  button.addEventListener("click", (event) => {
    if (started === null) {
      started = event.timeStamp;
      tick();
      return;
    }
    cancelAnimationFrame(frame);
    shown = (event.timeStamp - started) / 1000;
    started = null;
    write();
    bus.publish("say", { sentence: output.textContent, urgent: true });
    component.setStateValue("seconds", shown);
  });
  signal.addEventListener("abort", () => cancelAnimationFrame(frame));
  return write;
}
