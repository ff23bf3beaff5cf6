// Sends one message for each click on a point of a figure. Streamlit reports selections, and a second click on the same point
// changes no selection.

import { dom } from "./streamlit_dom.js";

export default function (component, signal) {
  const tell = ({ points }) => points.length && component.setTriggerValue("picked", { x: points[0].x, y: points[0].y });
  const listen = (event) => {
    const graph = dom.graphOf(event.target);
    if (!graph?.on || !event.target.closest(`.st-key-${CSS.escape(component.data.figure)}`)) return;
    // Plotly forgets its listeners when it draws a figure anew.
    graph.removeListener("plotly_click", tell);
    graph.on("plotly_click", tell);
  };
  document.addEventListener("pointerdown", listen, { capture: true, signal });
}
