// A button that pauses a stage, and with it the time cursor in all figures, at one moment.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function (component) {
  const button = component.parentElement.querySelector("button");
  button.addEventListener("click", () => {
    const { stage, time } = component.data, away = dom.stageAway();
    bus.publish(`seek/${stage}`, { time });
    if (away < 0) dom.main().scrollBy({ top: away });
  });
  return () => (button.textContent = component.data.label);
}
