// The page's bus: one module publishes a value under a topic, and others subscribe to it. If one listener fails, the others are
// still called.

class Bus extends EventTarget {
  #values = new Map(); // topic → owner → value; the last one holds

  publish(topic, value, owner = this) {
    const values = this.#values.get(topic) ?? new Map();
    values.delete(owner);
    this.#values.set(topic, values.set(owner, value));
    this.dispatchEvent(new CustomEvent(topic, { detail: value }));
  }

  /** Call the listener with the last value, if there is one, and with every later one until the signal aborts. */
  subscribe(topic, listener, { signal } = {}) {
    if (signal?.aborted) return;
    this.addEventListener(topic, ({ detail }) => listener(detail), { signal });
    if (this.#values.has(topic)) listener(this.last(topic));
  }

  last(topic) {
    return [...(this.#values.get(topic)?.values() ?? [])].at(-1);
  }

  /** Forget what an owner published. A page can hold one component twice for a moment, so the value of the other one stays. */
  forget(topic, owner = this) {
    const values = this.#values.get(topic);
    values?.delete(owner);
    if (!values?.size) this.#values.delete(topic);
  }
}

/** The bus is the app's only global, for tests and for the console. */
export const bus = (globalThis.ramanujan = new Bus());
