// Observers and timers that stop when a signal aborts.

/** Call a function after every change of a node. */
export function observe(node, options, act, signal) {
  const observer = new MutationObserver(act);
  observer.observe(node, options);
  signal.addEventListener("abort", () => observer.disconnect());
}

/** Return a debounced function: `act` runs `ms` milliseconds after its last call. Its method `cancel` drops a pending call. */
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
