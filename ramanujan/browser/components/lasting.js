// Observers and timers that end when a signal aborts.

/** Call a function after every change of a node. */
export function observe(node, options, look, signal) {
  const observer = new MutationObserver(look);
  observer.observe(node, options);
  signal.addEventListener("abort", () => observer.disconnect());
}

/** Return a debounced function: `act` runs when it has not been called for so many ms. `cancel` drops the pending call. */
export function atRest(ms, act, signal) {
  let timer = 0;
  const cancel = () => clearTimeout(timer);
  signal.addEventListener("abort", cancel);
  const soon = () => {
    cancel();
    timer = setTimeout(act, ms);
  };
  return Object.assign(soon, { cancel });
}
