// Lets a finger on a figure scroll the page. On a slider, a horizontal move or a tap moves the slider; a vertical move
// scrolls. This module withholds a touch from Streamlit until its direction is known. When the page scrolls, the
// browser ends the touch.

import { plotly } from "../../plotly.js";
import { sliders } from "../../sliders.js";

const INTENT = 8; // px along the slider after which a touch is a drag

export default function (_component, signal) {
  let pendingTouch = null; // the pointerdown of a touch whose direction is not yet known
  let isReplaying = false;
  const on = (type, handler, options) => window.addEventListener(type, handler, { capture: true, signal, ...options });
  const replay = (event) => {
    isReplaying = true;
    pendingTouch.target.dispatchEvent(new PointerEvent(event.type, event));
    isReplaying = false;
  };
  on("pointerdown", (event) => {
    if (isReplaying || event.pointerType !== "touch" || !sliders.isTrack(event.target)) return;
    event.stopImmediatePropagation();
    pendingTouch = event;
  });
  on("touchstart", (event) => sliders.isTrack(event.target) && event.stopImmediatePropagation());
  // Plotly interprets a touch as a drag, and the wheel as a zoom. It receives only taps, as clicks.
  for (const type of ["touchstart", "touchmove", "wheel"])
    on(type, (event) => plotly.graphOf(event.target) && event.stopImmediatePropagation(), { passive: true });
  on("pointermove", (event) => {
    if (isReplaying || pendingTouch?.pointerId !== event.pointerId) return;
    const [x, y] = [event.clientX - pendingTouch.clientX, event.clientY - pendingTouch.clientY];
    event.stopImmediatePropagation();
    if (Math.abs(x) < INTENT || Math.abs(x) < Math.abs(y)) return;
    replay(pendingTouch); // at the first position of the finger, so that the thumb stays under it
    pendingTouch = null;
  });
  on("pointerup", (event) => {
    if (isReplaying || pendingTouch?.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    replay(pendingTouch);
    replay(event);
    pendingTouch = null;
  });
  on("pointercancel", (event) => {
    if (pendingTouch?.pointerId === event.pointerId) pendingTouch = null;
  });
}
