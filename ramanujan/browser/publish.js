// Publishes topics and values from Python on the bus. When the element leaves the page, the values are removed.

import { bus } from "./bus.js";

export default function (component, signal) {
  const published = new Map();
  signal.addEventListener("abort", () => published.forEach((_, topic) => bus.forget(topic, signal)));
  return () => {
    for (const [topic, value] of Object.entries(component.data)) {
      const text = JSON.stringify(value);
      if (published.get(topic) === text) continue;
      published.set(topic, text);
      bus.publish(topic, value, signal);
    }
  };
}
