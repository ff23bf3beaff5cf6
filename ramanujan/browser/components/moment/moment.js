// A button that pauses a stage, and with it the time cursor in all figures, at one moment.

import { bus } from "../../bus.js";
import { dom } from "../../streamlit_dom.js";

export default function (component) {
  const button = component.parentElement.querySelector("button");
  button.addEventListener("click", () => {
    const { stage, time } = component.data, distance = dom.distanceToStage();
    bus.publish(`seek/${stage}`, { time });
    if (distance < 0) dom.main().scrollBy({ top: distance });
  });
  return () => (button.textContent = component.data.label);
}
