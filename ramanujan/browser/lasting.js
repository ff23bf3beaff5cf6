// Observers and timers that stop when a signal aborts.

/** Call a function after every change of a node. */
export function observe(node, options, callback, signal) {
  const observer = new MutationObserver(callback);
  observer.observe(node, options);
  signal.addEventListener("abort", () => observer.disconnect());
}

/**
 * Return a function that calls `callback` after `ms` milliseconds without another call. Its method `cancel` drops a
 * pending call.
 */
export function debounce(ms, callback, signal) {
  let timer = 0;
  const cancel = () => clearTimeout(timer);
  signal.addEventListener("abort", cancel);
  const debounced = () => {
    cancel();
    timer = setTimeout(callback, ms);
  };
  return Object.assign(debounced, { cancel });
}
