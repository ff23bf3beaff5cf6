// Says that the server is away and that nothing is lost. Streamlit itself only disables its widgets until the server is back.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";

const PAUSE = 300; // ms without a server before it is said

export default function ({ data, parentElement }) {
  return live(parentElement, (signal) => {
    const notice = parentElement.querySelector("p");
    let timer;
    const say = () => {
      notice.textContent = data.away;
      notice.hidden = false;
      bus.publish("say", { sentence: data.away, urgent: true });
    };
    const observer = new MutationObserver(() => {
      clearTimeout(timer);
      if (dom.isConnected()) notice.hidden = true;
      else if (notice.hidden) timer = setTimeout(say, PAUSE);
    });
    dom.watchConnection(observer);
    signal.addEventListener("abort", () => {
      clearTimeout(timer);
      observer.disconnect();
    });
  }).end;
}
