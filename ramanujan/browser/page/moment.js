// A button that takes a stage, and with it every figure over time, to one instant and holds them there. Which instant and what
// the button says come by the topic moment/NAME.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function ({ data, parentElement }) {
  return live(parentElement, (signal) => {
    const button = parentElement.querySelector("button");
    let moment = null;
    bus.subscribe(`moment/${data.stage}`, (given) => {
      moment = given;
      button.textContent = given.label;
    }, { signal });
    button.addEventListener("click", () => {
      if (!moment) return;
      bus.publish(`seek/${data.stage}`, { time: moment.time, by: "moment" });
      const away = dom.stageAway();
      if (away < 0) dom.main().scrollBy({ top: away });
    }, { signal });
  }).end;
}
