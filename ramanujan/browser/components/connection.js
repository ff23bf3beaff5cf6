// Says at once that the server is away and that nothing is lost. Streamlit itself only disables its widgets until the server
// is back, or covers the page with a box that asks for the internet (page.css hides it).

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";

export default function ({ data, parentElement }, signal) {
  const notice = parentElement.querySelector(".away");
  notice.textContent = data.away;
  dom.watchConnection((isConnected) => {
    const told = !notice.hidden;
    notice.hidden = isConnected;
    document.documentElement.toggleAttribute("data-offline", !isConnected);
    if (!isConnected && !told) bus.publish("say", { sentence: data.away, urgent: true });
  }, signal);
}
