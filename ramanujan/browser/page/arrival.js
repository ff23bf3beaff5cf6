// Tells the server that the first page's machine moves: what takes a browser long to load is sent after it.

import { bus, live } from "./bus.js";

const PATIENCE = 10000; // ms after which the rest is asked for without a machine

export default function ({ data, parentElement, setStateValue }) {
  const { begun, end } = live(parentElement, (signal) => {
    const begun = {};
    const tell = () => begun.waits && begun.send();
    // What has just been drawn is on the screen when the next frame begins.
    bus.subscribe("time/oscillator", () => begun.waits && requestAnimationFrame(tell), { signal });
    setTimeout(tell, PATIENCE);
    return begun;
  });
  begun.waits = data.waits;
  begun.send = () => {
    begun.waits = false;
    setStateValue("moving", true);
  };
  return end;
}
