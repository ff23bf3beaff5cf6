// The page's bus: whoever knows something publishes it under a topic, whoever needs it subscribes.

const values = new Map(); // topic → last value
const listeners = new Map(); // topic → Set of listeners

/** It is also the one global of the app, for tests and for the console. */
export const bus = (globalThis.ramanujan = {
  publish(topic, value) {
    values.set(topic, value);
    // One listener that fails must not keep the news from the others.
    for (const listener of [...(listeners.get(topic) ?? [])]) {
      try {
        listener(value);
      } catch (error) {
        reportError(error);
      }
    }
  },
  /** Call the listener with the last value, if there is one, and with every later one until the signal aborts. */
  subscribe(topic, listener, { signal } = {}) {
    if (signal?.aborted) return;
    if (!listeners.has(topic)) listeners.set(topic, new Set());
    const heard = listeners.get(topic);
    heard.add(listener);
    const end = () => {
      heard.delete(listener);
      if (!heard.size && listeners.get(topic) === heard) listeners.delete(topic);
    };
    signal?.addEventListener("abort", end, { once: true });
    if (values.has(topic)) listener(values.get(topic));
  },
  last: (topic) => values.get(topic),
  forget: (topic) => values.delete(topic),
  /** What is known and who listens, for tests: topic → number of listeners. */
  census: () => Object.fromEntries([...new Set([...values.keys(), ...listeners.keys()])].map((topic) => [topic, listeners.get(topic)?.size ?? 0])),
});

const lives = new WeakMap(); // parentElement → { begun, stop, calls }

/**
 * Begin what a component does on its element, once. Streamlit calls the component's function again whenever its data or
 * the theme changes, and of all the clean-ups that these calls return it keeps the last.
 */
export function live(parentElement, begin) {
  let life = lives.get(parentElement);
  if (!life) {
    life = { stop: new AbortController(), calls: 0 };
    lives.set(parentElement, life);
    life.begun = begin(life.stop.signal);
  }
  const call = ++life.calls;
  const end = () => {
    // A clean-up of an earlier call may come late: the element lives on.
    if (call !== life.calls) return;
    lives.delete(parentElement);
    life.stop.abort();
  };
  return { begun: life.begun, end };
}
