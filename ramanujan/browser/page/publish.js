// Carries news from Python to the bus: topics and their values. It has no content of its own, and is forgotten with its page.

import { bus, live } from "./bus.js";

export default function ({ data, parentElement }) {
  const { begun, end } = live(parentElement, (signal) => {
    const told = new Map();
    signal.addEventListener("abort", () => told.forEach((_, topic) => bus.forget(topic)));
    return told;
  });
  for (const [topic, value] of Object.entries(data)) {
    const text = JSON.stringify(value);
    if (begun.get(topic) === text) continue;
    begun.set(topic, text);
    bus.publish(topic, value);
  }
  return end;
}
