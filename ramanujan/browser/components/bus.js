// The page's bus: one module publishes a value under a topic, and others subscribe to it. If one listener fails, the others are
// still called.

class Bus extends EventTarget {
  #values = new Map(); // topic → last value

  publish(topic, value) {
    this.#values.set(topic, value);
    this.dispatchEvent(new CustomEvent(topic, { detail: value }));
  }

  /** Call the listener with the last value, if there is one, and with every later one until the signal aborts. */
  subscribe(topic, listener, { signal } = {}) {
    if (signal?.aborted) return;
    this.addEventListener(topic, ({ detail }) => listener(detail), { signal });
    if (this.#values.has(topic)) listener(this.last(topic));
  }

  last(topic) {
    return this.#values.get(topic);
  }

  forget(topic) {
    this.#values.delete(topic);
  }
}

/** The bus is the app's only global, for tests and for the console. */
export const bus = (globalThis.ramanujan = new Bus());
