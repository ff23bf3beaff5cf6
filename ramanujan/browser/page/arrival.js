// Tells the server that the machine moves: what takes a browser long to load is sent after it.

import { bus, live } from "./bus.js";

const PATIENCE = 10000; // ms after which the rest is asked for without a machine

export default function ({ data, parentElement, setStateValue }) {
  return live(parentElement, (signal) => {
    let told = false;
    const tell = () => {
      if (told || signal.aborted) return;
      told = true;
      // What has just been drawn is on the screen when the next frame begins.
      requestAnimationFrame(() => signal.aborted || setStateValue("seen", true));
    };
    bus.subscribe(`time/${data.stage}`, tell, { signal });
    setTimeout(tell, PATIENCE);
  }).end;
}
