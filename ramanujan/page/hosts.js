// What the app assumes about the pages of Streamlit and Plotly: every selector into them stands in this file. Where an
// assumption breaks, a function here returns null or nothing, and what depends on it stays still without an error.

const hosts = {
  /** The input of the Streamlit slider with this key; its value follows the thumb while that is dragged. */
  slider: (key) => document.querySelector(`.st-key-${CSS.escape(key)} input[type="range"]`),

  /** Which of these keys belongs to the slider that contains a node. */
  sliderKey: (node, keys) => keys.find((key) => node.closest?.(`.st-key-${CSS.escape(key)}`)),

  /** Plotly's graphs on the page; each carries its own `data` and `layout`. */
  graphs: () => [...document.querySelectorAll(".js-plotly-plot")],

  /** The graph that contains a node. */
  graphOf: (node) => node.closest?.(".js-plotly-plot"),

  /** The rectangles that cover a graph's panels. */
  panels: (graph) => [...graph.querySelectorAll(".nsewdrag")],

  /** Whether a node is the rectangle over a panel. */
  isPanel: (node) => node.matches?.(".nsewdrag") ?? false,
};
