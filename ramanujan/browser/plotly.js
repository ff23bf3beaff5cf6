// All selectors into the graphs of Plotly.

import { observe } from "./lasting.js";

export const plotly = {
  /**
   * Call a listener with each Plotly graph on the page, now or later, after each of its drawings, until the signal
   * aborts. A graph has its `layout` as a property. Streamlit has no event for a new figure, so this function observes
   * the page.
   */
  watchGraphs(listener, signal) {
    const known = new WeakSet();
    const connect = () => {
      for (const graph of plotly.graphs()) {
        if (!graph.on || known.has(graph)) continue;
        const drawn = () => signal.aborted || listener(graph);
        known.add(graph);
        graph.on("plotly_afterplot", drawn);
        if (graph.layout) drawn();
      }
    };
    observe(document.body, { childList: true, subtree: true }, connect, signal);
    connect();
  },

  /** The graphs on the page. */
  graphs: () => document.querySelectorAll(".js-plotly-plot"),

  /** The curves of a graph, with decoded arrays of numbers. */
  curves: (graph) => graph._fullData,

  /** The graph that contains a node. */
  graphOf: (node) => node.closest?.(".js-plotly-plot"),

  /** The rectangles that cover a graph's panels. */
  panels: (graph) => [...graph.querySelectorAll(".nsewdrag")],

  /** Whether a node is the rectangle over a panel. */
  isPanel: (node) => node.matches?.(".nsewdrag") ?? false,
};
