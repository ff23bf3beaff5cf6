// What lasts until a signal aborts: observers of the page, and what waits until things have come to rest.

/** Call a function after every change of a node. */
export function observe(node, options, look, signal) {
  const observer = new MutationObserver(look);
  observer.observe(node, options);
  signal.addEventListener("abort", () => observer.disconnect());
}

/** Return a function that has another one called, so many ms after it was called last; `cancel` takes that back. */
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
