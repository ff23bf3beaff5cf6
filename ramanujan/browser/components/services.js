// Mounts the services that every page needs.

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

// On the screen a figure is as wide as the page. For printing it is scaled to the width of the paper (A4: 180 mm).
const fitPaper = () => document.documentElement.style.setProperty("--printed", Math.min(1, 660 / dom.contentWidth()));
window.addEventListener("beforeprint", fitPaper);
window.addEventListener("copy", copy);
dom.keepOneEntry();
dom.watchGraphs(dom.offerFormats, new AbortController().signal);
if (new URLSearchParams(location.search).get("view") === "projector") import("./pager.js");

export default function (component, signal) {
  const begins = [theme, voice, reach, ring, connection, touch, arrival, sliderValues, translated];
  const updates = begins.map((begin) => begin(component, signal));
  return () => updates.forEach((update) => update?.());
}
