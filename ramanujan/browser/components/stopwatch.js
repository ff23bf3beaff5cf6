// A stopwatch: started and stopped by hand, it runs on the page and tells the server the time between.

import { bus } from "./bus.js";
import { fill, fixed } from "./sentences.js";

export default function (component, signal) {
  const [button, output] = component.parentElement.querySelectorAll("button, output");
  let started = null, taken = 0, timer = 0;

  const write = () => {
    const { start, stop, seconds } = component.data, runs = started !== null;
    button.textContent = runs ? stop : start;
    output.textContent = fill(seconds, { seconds: runs ? fixed((performance.now() - started) / 1000, 1) : fixed(taken, 2) });
  };
  button.addEventListener("click", ({ timeStamp }) => {
    clearInterval(timer);
    if (started === null) {
      started = timeStamp;
      timer = setInterval(write, 50);
      return write();
    }
    taken = (timeStamp - started) / 1000;
    started = null;
    write();
    bus.publish("say", { sentence: output.textContent, urgent: true });
    component.setStateValue("seconds", taken);
  });
  signal.addEventListener("abort", () => clearInterval(timer));
  return write;
}
