// Starts the services of every page; `mount` in __init__.py lists them.

import arrival from "./arrival.js";
import connection from "./connection.js";
import copy from "./copy.js";
import reach from "./reach.js";
import ring from "./ring.js";
import sliderValues from "./slider_values.js";
import { sliders } from "../../sliders.js";
import { address } from "../../page_address.js";
import { plotly } from "../../plotly.js";
import { dom } from "../../streamlit_dom.js";
import theme from "./theme.js";
import touch from "./touch.js";
import translated from "./translated.js";
import voice from "./voice.js";

const PAPER_WIDTH = 660; // px, slightly less than the 180 mm (680 px) between the margins of A4
// On the screen a figure has the width of the page, or of its column beside a text, which is above it on paper. For
// printing, print.css scales it to the width of the paper.
const fitPaper = () => {
  for (const graph of plotly.graphs()) {
    const width = graph.closest('[class*="st-key-columns-"]') ? graph.clientWidth : dom.contentWidth();
    graph.style.setProperty("--printed", Math.min(1, PAPER_WIDTH / width));
  }
};
window.addEventListener("beforeprint", fitPaper);
window.addEventListener("copy", copy);
address.limitHistory();
if (new URLSearchParams(location.search).get("view") === "projector") import("../pager/pager.js");

export default function (component, signal) {
  sliders.watchReleased(signal);
  const begins = [theme, voice, reach, ring, connection, touch, arrival, sliderValues, translated];
  const updates = begins.map((begin) => begin(component, signal));
  return () => updates.forEach((update) => update?.());
}
