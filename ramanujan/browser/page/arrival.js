// Tells the server that the machine moves: what takes a browser long to load is sent after it.

import { bus, live } from "./bus.js";

const PATIENCE = 10000; // ms after which the rest is asked for without a machine

export default function ({ data, parentElement, setStateValue }) {
  return live(parentElement, (signal) => {
    const told = new AbortController();
    const tell = () => {
      told.abort();
      // What has just been drawn is on the screen when the next frame begins.
      requestAnimationFrame(() => signal.aborted || setStateValue("seen", true));
    };
    const timer = setTimeout(tell, PATIENCE);
    for (const end of [signal, told.signal]) end.addEventListener("abort", () => clearTimeout(timer));
    bus.subscribe(`time/${data.stage}`, tell, { signal: AbortSignal.any([signal, told.signal]) });
  }).end;
}
