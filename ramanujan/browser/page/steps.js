// The steps of a lecture, turned on the page itself: all of them are there, and one is shown. No press waits for the server,
// which is told afterwards where the lecture has come to, so that the address holds the place.

import { live } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { showPlace, turnOf } from "./turning.js";

const TELL = 300; // ms without a press after which the server is told

export default function ({ data, parentElement, setStateValue }) {
  const { begun, end } = live(parentElement, (signal) => lecture(parentElement, signal));
  begun.receive(data, (at) => setStateValue("at", at));
  return end;
}

function lecture(root, signal) {
  const slider = root.querySelector("input");
  const sheet = document.head.appendChild(document.createElement("style"));
  let data, send, timer;
  let now = 0;
  signal.addEventListener("abort", () => {
    clearTimeout(timer);
    sheet.remove();
  });

  const show = (speak) => {
    // The server draws the steps; which one is seen is decided here alone.
    sheet.textContent = `#root .st-key-lecture .st-key-step_${now}.st-key-step_${now} { display: flex; }`;
    showPlace(root, data, now, speak);
  };

  /** Go to a step, and return whether there was one to go to. */
  const go = (step) => {
    const to = Math.min(Math.max(step, 1), data.headings.length);
    if (to === now) return false;
    now = to;
    show(true);
    clearTimeout(timer);
    timer = setTimeout(() => send({ route: data.route, step: now }), TELL);
    return true;
  };

  const on = (node, type, handler) => node.addEventListener(type, handler, { signal });
  for (const button of root.querySelectorAll("button")) on(button, "click", () => go(now + Number(button.dataset.by)));
  on(slider, "input", () => go(Number(slider.value)));
  on(document, "keydown", (event) => {
    const by = turnOf(event, { ArrowRight: 1, PageDown: 1, " ": 1, ArrowLeft: -1, PageUp: -1 });
    if (!by) return;
    const focused = event.composedPath()[0];
    if (focused.matches?.(event.key === " " ? dom.TAKES_SPACE : dom.TAKES_KEYS)) return;
    // These keys also scroll the page: they turn a step only while the lecture is what one looks at.
    if (!event.key.startsWith("Arrow") && !dom.inView(dom.lecture())) return;
    if (go(now + (event.shiftKey && event.key === " " ? -by : by)) || event.key === " ") event.preventDefault();
  });

  const receive = (given, sender) => {
    const another = data && given.route !== data.route;
    const first = !data;
    [data, send] = [given, sender];
    slider.max = data.headings.length;
    if (another) clearTimeout(timer);
    if (first || another) now = another ? 1 : named(data.headings.length);
    show(false);
  };
  return { receive };
}

/** The step that the address names, if there is such a step, else the first. */
function named(count) {
  const text = new URLSearchParams(location.search).get("step") ?? "";
  return /^\d+$/.test(text) && Number(text) >= 1 && Number(text) <= count ? Number(text) : 1;
}
