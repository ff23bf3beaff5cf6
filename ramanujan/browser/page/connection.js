// Says at once that the server is away and that nothing is lost. Streamlit itself only disables its widgets until the server
// is back.

import { bus, live } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function ({ data, parentElement }) {
  return live(parentElement, (signal) => {
    const notice = parentElement.querySelector("p");
    const observer = new MutationObserver(() => {
      const told = !notice.hidden;
      notice.hidden = dom.isConnected();
      if (notice.hidden || told) return;
      notice.textContent = data.away;
      bus.publish("say", { sentence: data.away, urgent: true });
    });
    dom.watchConnection(observer);
    signal.addEventListener("abort", () => observer.disconnect());
  }).end;
}
