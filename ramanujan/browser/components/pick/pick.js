// Sends a message for each click on a point of a figure. Streamlit reports only changes of the selection, and a second
// click on the same point changes nothing.

import { plotly } from "../../plotly.js";

export default function (component, signal) {
  const send = ({ points }) => points.length && component.setTriggerValue("picked", { x: points[0].x, y: points[0].y });
  const listen = (event) => {
    const graph = plotly.graphOf(event.target);
    if (!graph?.on || !event.target.closest(`.st-key-${CSS.escape(component.data.figure)}`)) return;
    // Plotly loses its listeners when it redraws a figure.
    graph.removeListener("plotly_click", send);
    graph.on("plotly_click", send);
  };
  document.addEventListener("pointerdown", listen, { capture: true, signal });
}
