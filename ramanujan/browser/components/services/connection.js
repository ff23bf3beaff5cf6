// Shows a notice while the page has no connection to the server. Streamlit only disables its widgets, or covers the
// page with a dialog about the internet connection (streamlit.css hides it).
//
// The wall of a class reruns twice a second. On a busy server these reruns can stop (streamlit#9921), and nobody is at
// the wall to reload the page. Therefore a wall reloads itself after LONGEST_IDLE ms without a run.

import { bus } from "../../bus.js";
import { debounce } from "../../lasting.js";
import { dom } from "../../streamlit_dom.js";

const LONGEST_IDLE = 20_000;

export default function ({ data, parentElement }, signal) {
  const notice = parentElement.querySelector(".away");
  notice.textContent = data.away;
  let connected = true;
  const reloadIdleWall = () => {
    if (connected && dom.isIdleWall() && !document.hidden) location.reload();
    else restartTimer();
  };
  const restartTimer = debounce(LONGEST_IDLE, reloadIdleWall, signal);
  restartTimer();
  dom.watchConnection((isConnected) => {
    connected = isConnected;
    restartTimer();
    const wasAway = !notice.hidden;
    notice.hidden = isConnected;
    document.documentElement.toggleAttribute("data-offline", !isConnected);
    if (!isConnected && !wasAway) bus.publish("announce", { sentence: data.away, urgent: true });
  }, signal);
}
