// Tells the server that the first page's machine moves: what takes a browser long to load is sent after it.

import { bus } from "./bus.js";

const PATIENCE = 10000; // ms after which the rest is asked for without a machine

export default function (component, signal) {
  let told = false;
  const tell = () => {
    if (told || !component.data.waits) return;
    told = true;
    component.setStateValue("moving", true);
  };
  // What has just been drawn is on the screen when the next frame begins.
  bus.subscribe("time/oscillator", () => told || requestAnimationFrame(tell), { signal });
  setTimeout(tell, PATIENCE);
}
