// Says at once that the server is away and that nothing is lost. Streamlit itself only disables its widgets until the server
// is back.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function ({ data, parentElement }, signal) {
  const notice = parentElement.querySelector(".away");
  notice.textContent = data.away;
  dom.watchConnection((isConnected) => {
    const told = !notice.hidden;
    notice.hidden = isConnected;
    if (!isConnected && !told) bus.publish("say", { sentence: data.away, urgent: true });
  }, signal);
}
