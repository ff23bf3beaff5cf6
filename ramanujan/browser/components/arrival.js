// Tells the server that the first page's machine moves. Only then does the server send what a browser is slow to load.

import { bus } from "./bus.js";

const PATIENCE = 10000; // ms after which the rest is asked for without a machine

export default function (component, signal) {
  let told = false;
  const tell = () => {
    if (told || !component.data.waits) return;
    told = true;
    component.setStateValue("moving", true);
  };
  // A drawing is on the screen when the next frame begins.
  bus.subscribe("time/oscillator", () => told || requestAnimationFrame(tell), { signal });
  setTimeout(tell, PATIENCE);
}
