// Gives page.css the theme's colours, which Streamlit tells to components alone, and notices that the theme has been switched:
// then it asks for a run of the page, since figures take their colours on the server. Streamlit calls this function again
// whenever the theme changes.

import { live } from "./bus.js";
import { dom } from "./streamlit_dom.js";

const PAUSE = 400; // ms until the question, since Streamlit's own messages learn of the new theme later than its components
const COLORS = { paper: "background", under: "secondary-background", faint: "border", primary: "primary" };
const TIMES = 5; // that a switch is asked about: a server that does not follow is not asked for ever

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, (signal) => {
    signal.addEventListener("abort", () => clearTimeout(begun.timer));
    return { timer: 0 };
  });
  Object.assign(begun, { drawn: data.theme, asked: 0 });
  const ask = () => {
    const seen = dom.theme(parentElement);
    if (!seen || seen === begun.drawn || begun.asked >= TIMES) return;
    begun.asked += 1;
    setTriggerValue("switched", `${seen} ${begun.asked}`);
    begun.timer = setTimeout(ask, 4 * PAUSE);
  };
  const { style, dataset } = document.documentElement;
  for (const [name, its] of Object.entries(COLORS)) style.setProperty(`--${name}`, dom.color(parentElement, its));
  dataset.theme = data.theme;
  clearTimeout(begun.timer);
  begun.timer = setTimeout(ask, PAUSE);
  return end;
}
