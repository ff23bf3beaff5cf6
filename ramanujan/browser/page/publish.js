// Carries news from Python to the bus: topics and their values. It has no content of its own, and is forgotten with its page.

import { bus } from "./bus.js";

export default function (component, signal) {
  const told = new Map();
  signal.addEventListener("abort", () => told.forEach((_, topic) => bus.forget(topic)));
  return () => {
    for (const [topic, value] of Object.entries(component.data)) {
      const text = JSON.stringify(value);
      if (told.get(topic) === text) continue;
      told.set(topic, text);
      bus.publish(topic, value);
    }
  };
}
