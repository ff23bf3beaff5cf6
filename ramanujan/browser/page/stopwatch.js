// A stopwatch: started and stopped by hand, it runs on the page and tells the server the time between.

import { bus, live } from "./bus.js";
import { fill } from "./sentences.js";

export default function ({ data, parentElement, setStateValue }) {
  const { begun, end } = live(parentElement, (signal) => watch(parentElement, signal));
  begun.receive(data, (seconds) => setStateValue("seconds", seconds));
  return end;
}

function watch(root, signal) {
  const button = root.querySelector("button"), output = root.querySelector("output");
  let data, send, started = null, shown = 0, frame = 0;

  const write = () => {
    button.textContent = started === null ? data.start : data.stop;
    output.textContent = fill(data.seconds, { seconds: shown.toFixed(started === null ? 2 : 1) });
  };
  const tick = () => {
    shown = (performance.now() - started) / 1000;
    write();
    frame = requestAnimationFrame(tick);
  };
  const press = (event) => {
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
    send(shown);
  };
  button.addEventListener("click", press, { signal });
  signal.addEventListener("abort", () => cancelAnimationFrame(frame));

  const receive = (given, sender) => {
    [data, send] = [given, sender];
    if (started === null) write();
  };
  return { receive };
}
