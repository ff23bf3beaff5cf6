// Lets a slider's thumb snap to the goal, a value between its steps from the topic goal/KEY. The slider sends the step beside the
// goal; then the page sends the goal like a typed value.

import { bus } from "./bus.js";
import { debounce } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const NEAR = 6; // px, the distance from the goal within which a thumb snaps to it; a key snaps only at the step beside it
const PAUSE = 400; // ms from the last move until the goal is sent; before that, the slider sends its step

/** Return the functions `moveTo` and `follow` for the slider with this key. `send` sends a text like a typed one. */
export function makeSnap(key, send, signal) {
  let last; // the slider's value after its last move
  let cause = null; // "key" or "thumb", until the page has drawn the move
  const goal = () => bus.last(`goal/${key}`);
  const sendGoal = debounce(PAUSE, () => {
    const slider = dom.slider(key);
    if (dom.isDragged(slider)) sendGoal();
    else if (slider && dom.value(slider) === goal()) send(String(goal()));
  }, signal);
  const on = (type, listener) => addEventListener(type, listener, { capture: true, signal });
  on("keydown", (event) => (cause = event.composedPath().includes(dom.slider(key)) ? "key" : null));
  on("pointerup", () => {
    // On a slow page, the last move of a thumb is drawn after its release.
    cause = dom.isDragged(dom.slider(key)) ? "thumb" : null;
    sendGoal();
  });

  /** Move the slider to a value that may be between two steps. Null puts it back on its own step. */
  const moveTo = (value) => {
    const slider = dom.slider(key);
    dom.snap(slider, value);
    last = slider?.value;
  };

  /** Follow a change of the slider. A value that the server has set does not snap. */
  const follow = () => {
    const slider = dom.slider(key);
    if (!slider || slider.value === last) return;
    if (dom.isDragged(slider)) cause = "thumb";
    const reach = cause === "thumb" ? NEAR * dom.perPixel(slider) : slider.step / 2;
    const isNear = cause && goal() && Math.abs(slider.value - goal()) <= reach;
    moveTo(isNear ? goal() : null); // null also ends an earlier snap
    if (isNear) sendGoal();
    cause = null;
  };
  return { moveTo, follow };
}
