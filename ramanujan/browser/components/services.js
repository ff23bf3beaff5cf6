// Starts the services of every page; `mount_services` in __init__.py lists them.

import arrival from "./arrival.js";
import connection from "./connection.js";
import copy from "./copy.js";
import reach from "./reach.js";
import ring from "./ring.js";
import sliderValues from "./slider_values.js";
import { dom } from "./streamlit_dom.js";
import theme from "./theme.js";
import touch from "./touch.js";
import translated from "./translated.js";
import voice from "./voice.js";

const PAPER_WIDTH = 660; // px, slightly less than the 180 mm (680 px) between the margins of A4
// On the screen a figure has the width of the page. For printing, print.css scales it to the width of the paper.
const fitPaper = () => document.documentElement.style.setProperty("--printed", Math.min(1, PAPER_WIDTH / dom.contentWidth()));
window.addEventListener("beforeprint", fitPaper);
window.addEventListener("copy", copy);
dom.limitHistory();
dom.watchGraphs(dom.offerFormats, new AbortController().signal);
if (new URLSearchParams(location.search).get("view") === "projector") import("./pager.js");

export default function (component, signal) {
  const begins = [theme, voice, reach, ring, connection, touch, arrival, sliderValues, translated];
  const updates = begins.map((begin) => begin(component, signal));
  return () => updates.forEach((update) => update?.());
}
