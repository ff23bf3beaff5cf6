// Says at once that the server is away and that nothing is lost. Streamlit itself only disables its widgets until the server
// is back, or covers the page with a box that asks for the internet (page.css hides it).
//
// A class's wall looks for news twice a second. A busy server can lose what makes Streamlit's page look again
// (streamlit#9921), and nobody stands at a wall to reload it: one on which nothing has run for LONGEST ms is loaded anew.

import { bus } from "./bus.js";
import { atRest } from "./lasting.js";
import { dom } from "./streamlit_dom.js";

const LONGEST = 20_000;

export default function ({ data, parentElement }, signal) {
  const notice = parentElement.querySelector(".away");
  notice.textContent = data.away;
  let connected = true;
  const act = () => (connected && dom.isIdleWall() && !document.hidden ? location.reload() : stalled());
  const stalled = atRest(LONGEST, act, signal);
  stalled();
  dom.watchConnection((isConnected) => {
    connected = isConnected;
    stalled();
    const told = !notice.hidden;
    notice.hidden = isConnected;
    document.documentElement.toggleAttribute("data-offline", !isConnected);
    if (!isConnected && !told) bus.publish("say", { sentence: data.away, urgent: true });
  }, signal);
}
