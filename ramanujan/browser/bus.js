// The page's message bus: a module publishes a value under a topic, and other modules subscribe to the topic. An
// exception in one listener does not affect the others. topics.py lists the topics.

class Bus extends EventTarget {
  #values = new Map(); // topic → owner → value; the last value is valid

  publish(topic, value, owner = this) {
    const values = this.#values.get(topic) ?? new Map();
    values.delete(owner); // then `set` appends the owner at the end
    this.#values.set(topic, values.set(owner, value));
    this.dispatchEvent(new CustomEvent(topic, { detail: value }));
  }

  /** Call the listener with the last value, if any, and with every later value until the signal aborts. */
  subscribe(topic, listener, { signal } = {}) {
    if (signal?.aborted) return;
    this.addEventListener(topic, ({ detail }) => listener(detail), { signal });
    if (this.#values.has(topic)) listener(this.last(topic));
  }

  last(topic) {
    return [...(this.#values.get(topic)?.values() ?? [])].at(-1);
  }

  /** Remove an owner's value. A component can be on the page twice for a moment, so the other owner's value stays. */
  forget(topic, owner = this) {
    const values = this.#values.get(topic);
    values?.delete(owner);
    if (!values?.size) this.#values.delete(topic);
  }
}

/** The bus is the app's only global, for tests and for the console. */
export const bus = (globalThis.ramanujan = new Bus());
