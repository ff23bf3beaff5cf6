// Gives page.css the theme's colours, which only components get from Streamlit. After a switch of the theme it asks for a run of
// the page, since figures take their colours on the server.

import { dom } from "./streamlit_dom.js";

const PAUSE = 400; // ms until the question, since Streamlit's own messages learn of the new theme later than its components
const COLORS = {
  paper: "background", under: "secondary-background", faint: "border", primary: "primary",
  gray: "gray", orange: "orange", blue: "blue", green: "green", violet: "violet", red: "red",
};
const TIMES = 5; // that a switch is asked about: a server that does not follow is not asked for ever

export default function (component, signal) {
  let timer = 0, asked = 0;
  const ask = () => {
    const seen = dom.theme(component.parentElement);
    if (!seen || seen === component.data.theme || asked >= TIMES) return;
    asked += 1;
    component.setTriggerValue("switched", `${seen} ${asked}`);
    timer = setTimeout(ask, 4 * PAUSE);
  };
  signal.addEventListener("abort", () => clearTimeout(timer));
  return () => {
    document.documentElement.dataset.theme = component.data.theme;
    // When a page has been drawn its colours are known; to ask earlier would style all of it once more.
    requestAnimationFrame(() => setTimeout(giveColors, 0, component.parentElement));
    asked = 0;
    clearTimeout(timer);
    timer = setTimeout(ask, PAUSE);
  };
}

function giveColors(parentElement) {
  // The loop reads all colours before it sets the first, for the same reason.
  const colors = Object.entries(COLORS).map(([name, its]) => [`--${name}`, dom.color(parentElement, its)]);
  for (const each of colors) document.documentElement.style.setProperty(...each);
}
