// The head of a slider: its symbol, its meaning, and a box that shows the value in full and takes any number or fraction.
// The slider is the only holder of the value. The box shows what the slider holds, also while it moves, and hands a typed
// text to the server as one message; it sends no value of its own.

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, (signal) => exactBox(parentElement, signal));
  begun.receive(data.key, (text) => setTriggerValue("typed", text));
  return end;
}

function exactBox(root, signal) {
  const box = root.querySelector("input");
  const label = root.querySelector("label");
  let key, send, watched;
  let data; // what the library knows of the slider of this key
  let told = {}; // what the server said last: value, text, judged
  let slab = null; // x₀ while the slab is held, and until the server has answered
  let inHand = false;
  box.id = "box";
  label.htmlFor = "box";

  /** What the slider holds: the server's text in full, unless the thumb stands elsewhere by now. */
  const held = () => {
    if (slab !== null) return slab;
    const slider = hosts.slider(key);
    return hosts.shows(slider, told.value) ? told.text ?? "" : slider.value;
  };
  const edited = () => root.activeElement === box && box.value !== box.dataset.shown;
  const show = () => {
    if (edited()) return;
    box.value = box.dataset.shown = held();
  };

  const changes = new MutationObserver(() => {
    if (!inHand) slab = null;
    show();
  });
  signal.addEventListener("abort", () => changes.disconnect());
  const watch = () => {
    const slider = hosts.slider(key);
    if (!slider || slider === watched) return;
    watched = slider;
    changes.disconnect();
    changes.observe(slider, { attributes: true, attributeFilter: ["value", "aria-valuetext"] });
  };
  // The slider is drawn after its head, and may be drawn anew.
  for (const type of ["pointerdown", "focusin"]) document.addEventListener(type, () => watch(), { capture: true, signal });

  const commit = () => {
    const typed = box.value;
    if (typed === box.dataset.shown) return;
    box.dataset.shown = typed;
    send(typed);
  };
  box.addEventListener("change", commit, { signal });
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key !== "Escape") return;
    box.value = box.dataset.shown = held();
    box.select();
  }, { signal });

  const hear = (given) => {
    const before = told.text;
    told = given;
    watch();
    // A new value from the server is what the slab was let go at, or what has been set since.
    if (!inHand && told.text !== before) slab = null;
    show();
  };
  const begin = () => {
    box.maxLength = data.longest;
    box.setAttribute("aria-label", data.label);
    for (const [selector, text] of [[".symbol", data.symbol], [".unit", `[${data.unit}]`], ["small", data.meaning]])
      root.querySelector(selector).textContent = text;
    bus.subscribe(`exact/${key}`, hear, { signal });
    // While the slab is held, the value moves on the page alone.
    for (const name of data.stages)
      bus.subscribe(`compression/${name}`, (moved) => {
        inHand = moved.held;
        slab = String(Number((moved.value / data.scale).toPrecision(10)));
        show();
      }, { signal });
  };
  return {
    receive(name, sender) {
      const first = !key;
      [key, send] = [name, sender];
      if (first) bus.subscribe(`box/${key}`, (given) => {
        const known = data;
        data = given;
        if (!known) begin();
      }, { signal });
    },
  };
}
