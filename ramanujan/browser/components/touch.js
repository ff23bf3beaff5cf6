// A finger on a figure scrolls the page. On a slider a horizontal move or a tap moves the slider; everything else scrolls. So
// this file keeps a touch from Streamlit until it knows which of them it is. Where the page scrolls, the browser ends the touch.

import { dom } from "./streamlit_dom.js";

const INTENT = 8; // px along the slider after which a touch is a drag

export default function (_component, signal) {
  let waiting = null; // the pointerdown of the touch that is not yet known to be a drag
  let replayed = false;
  const on = (type, handler, options) => window.addEventListener(type, handler, { capture: true, signal, ...options });
  const replay = (event) => {
    replayed = true;
    waiting.target.dispatchEvent(new PointerEvent(event.type, event));
    replayed = false;
  };
  on("pointerdown", (event) => {
    if (replayed || event.pointerType !== "touch" || !dom.isSliderTrack(event.target)) return;
    event.stopImmediatePropagation();
    waiting = event;
  });
  on("touchstart", (event) => dom.isSliderTrack(event.target) && event.stopImmediatePropagation());
  // Plotly takes every touch for the start of a drag, and a wheel for a zoom. It hears only of taps, which come as clicks.
  for (const type of ["touchstart", "touchmove", "wheel"])
    on(type, (event) => dom.graphOf(event.target) && event.stopImmediatePropagation(), { passive: true });
  on("pointermove", (event) => {
    if (replayed || waiting?.pointerId !== event.pointerId) return;
    const [x, y] = [event.clientX - waiting.clientX, event.clientY - waiting.clientY];
    event.stopImmediatePropagation();
    if (Math.abs(x) < INTENT || Math.abs(x) < Math.abs(y)) return;
    replay(waiting); // from where the finger came down, so that a thumb that was touched stays under it
    waiting = null;
  });
  on("pointerup", (event) => {
    if (replayed || waiting?.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    replay(waiting);
    replay(event);
    waiting = null;
  });
  on("pointercancel", (event) => {
    if (waiting?.pointerId === event.pointerId) waiting = null;
  });
}
