// A stopwatch that runs on the page and sends the measured time to the server.

import { bus } from "../../bus.js";
import { fill, fixed } from "../../sentences.js";

export default function (component, signal) {
  const [button, output] = component.parentElement.querySelectorAll("button, output");
  let startTime = null, measured = 0, timer = 0;

  const write = () => {
    const { start, stop, seconds } = component.data, isRunning = startTime !== null;
    const running = (performance.now() - startTime) / 1000;
    button.textContent = isRunning ? stop : start;
    output.textContent = fill(seconds, { seconds: isRunning ? fixed(running, 1) : fixed(measured, 2) });
  };
  button.addEventListener("click", ({ timeStamp }) => {
    clearInterval(timer);
    if (startTime === null) {
      startTime = timeStamp;
      timer = setInterval(write, 50);
      return write();
    }
    measured = (timeStamp - startTime) / 1000;
    startTime = null;
    write();
    bus.publish("announce", { sentence: output.textContent, urgent: true });
    component.setStateValue("seconds", measured);
  });
  signal.addEventListener("abort", () => clearInterval(timer));
  return write;
}
