// A finger on a slider: only a horizontal move or a tap is meant for the slider, everything else scrolls. The touch is kept
// from Streamlit until it is known which of them it is; the browser itself ends it where the page scrolls.

import { dom } from "./streamlit_dom.js";

const INTENT = 8; // px along the slider after which a touch is a drag

export function deferSliders(signal) {
  let waiting = null; // the touch that is not yet known to be a drag
  let replayed = false;
  const on = (type, handler) => window.addEventListener(type, handler, { capture: true, signal });
  const replay = (type, from, at) => {
    replayed = true;
    const { pointerId, pointerType, isPrimary } = from;
    const common = { bubbles: true, cancelable: true, composed: true, pointerId, pointerType, isPrimary, button: 0 };
    const { clientX, clientY } = at;
    waiting.target.dispatchEvent(new PointerEvent(type, { ...common, buttons: type === "pointerup" ? 0 : 1, clientX, clientY }));
    replayed = false;
  };
  on("pointerdown", (event) => {
    if (replayed || event.pointerType !== "touch" || !dom.isSliderTrack(event.target)) return;
    event.stopImmediatePropagation();
    waiting = { target: event.target, down: event };
  });
  on("touchstart", (event) => {
    if (dom.isSliderTrack(event.target)) event.stopImmediatePropagation();
  });
  on("pointermove", (event) => {
    if (replayed || waiting?.down.pointerId !== event.pointerId) return;
    const [x, y] = [event.clientX - waiting.down.clientX, event.clientY - waiting.down.clientY];
    event.stopImmediatePropagation();
    if (Math.abs(x) < INTENT || Math.abs(x) < Math.abs(y)) return;
    // From where the finger came down, so that a thumb that was touched stays under it.
    replay("pointerdown", waiting.down, dom.onThumb(waiting.target) ? waiting.down : event);
    waiting = null;
  });
  on("pointerup", (event) => {
    if (replayed || waiting?.down.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    replay("pointerdown", waiting.down, waiting.down);
    replay("pointerup", event, waiting.down);
    waiting = null;
  });
  on("pointercancel", (event) => {
    if (waiting?.down.pointerId === event.pointerId) waiting = null;
  });
}
