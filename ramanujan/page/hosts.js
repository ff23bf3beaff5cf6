// What the app assumes about the pages of Streamlit and Plotly: every selector into them stands in this file. Where an
// assumption breaks, a function here returns null or nothing, and what depends on it stays still without an error.

const hosts = {
  /** The input of the Streamlit slider with this key; its value follows the thumb while that is dragged. */
  slider: (key) => document.querySelector(`.st-key-${CSS.escape(key)} input[type="range"]`),

  /** Let the thumb of a slider and its label stand at a value before the server knows it; the slider itself is not told. */
  moveThumb(key, value) {
    const input = hosts.slider(key);
    const thumb = input?.closest("[style*='left']");
    if (!thumb) return;
    const [least, most] = [Number(input.min), Number(input.max)];
    thumb.style.left = `${(100 * (value - least)) / (most - least)}%`;
    const shown = thumb.querySelector("[data-testid=stSliderThumbValue] p");
    if (shown) shown.textContent = value.toFixed((input.step.split(".")[1] ?? "").length);
  },

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

  /** What needs the arrow and page keys for itself when it has the focus, and what needs the space bar. */
  TAKES_KEYS: "input:not([type=button], [type=checkbox]), textarea, select, [contenteditable=true], [role=slider], [role=radio], [role=tab], [role=listbox], [role=option], [role=toolbar] *, .stage",
  TAKES_SPACE: "input, textarea, select, button, summary, a[href], [contenteditable=true], [role=slider], [role=radio], [role=tab], [role=button], [role=option], .stage",

  /** The box in which a lecture's steps are drawn. */
  lecture: () => document.querySelector(".st-key-lecture"),

  /** Whether a good part of a node is on the screen. */
  inView(node) {
    const box = node?.getBoundingClientRect();
    if (!box?.height) return false;
    const seen = Math.min(box.bottom, innerHeight) - Math.max(box.top, 0);
    return seen > 0.3 * Math.min(box.height, innerHeight);
  },
};
