// The app's assumptions about the pages of Streamlit and Plotly, as a function of the modules streamlit_dom.js,
// sliders.js and plotly.js. It returns, for each assumption with its purpose, whether the page satisfies it; null if
// the page has no such element.

([{ dom }, { sliders }, { plotly }]) => {
  const exists = (selector) => Boolean(document.querySelector(selector));
  const each = (selector, holds) => {
    const nodes = [...document.querySelectorAll(selector)];
    return nodes.length ? nodes.every(holds) : null;
  };
  const assumptions = {
    "a slider with the key m is a range input in an element of the class st-key-m": [
      "the stage follows a thumb, a box shows the value of its slider",
      () => ["min", "max", "step", "value"].every((name) => Number(sliders.find("m")?.[name]) > 0),
    ],
    "a slider's track is a group": [
      "a finger on a slider scrolls the page, unless it moves sideways",
      () => each(".stSlider", (slider) => slider.querySelector("[role=group]")),
    ],
    "stApp has the state of the connection and of a run as attributes": [
      "the notice that the page reconnects, the reload of an idle wall",
      () => exists("[data-testid=stApp][data-test-connection-state][data-test-script-state=notRunning]"),
    ],
    "a component has the colour scheme of the page": [
      "figures follow a switch of the theme",
      () => each("[data-testid=stBidiComponentIsolated]", (node) => dom.theme(node.shadowRoot)),
    ],
    "main scrolls, and its content is the child of stMainBlockContainer": [
      "the machine is brought into view, figures fit on paper",
      () => dom.main()?.matches("main") === true && exists(".stMainBlockContainer > *"),
    ],
    "there is one header above main": [
      "a phone's bar of pages, the surroundings of a projector's slide",
      () => document.querySelectorAll("header").length === 1,
    ],
    "the sidebar stSidebar contains the controls": [
      "the drawer of a phone, the printed page",
      () => each(".stSidebar .st-key-controls", (controls) => controls.closest("[data-testid=stSidebarUserContent]")),
    ],
    "the sidebar's links are a list in a nav, and the present page is marked": [
      "the bar of pages of a phone",
      () => each(".stSidebar nav", (nav) => nav.querySelector("ul a[data-testid=stSidebarNavLink][aria-current=page]")),
    ],
    "formulas in stMarkdown are set by KaTeX": [
      "wide formulas scroll in their own boxes",
      () => each(".stMarkdown .katex-display", (formula) => formula.querySelector(":scope > .katex .base")),
    ],
    "a graph is of the class js-plotly-plot, with curves, layout and events": [
      "ring and time cursor over the figures",
      () =>
        each(".js-plotly-plot", (graph) => plotly.curves(graph) && graph.layout && graph.on && graph.removeListener),
    ],
    "a rectangle of the class nsewdrag covers each panel of a graph": [
      "the positions of ring and time cursor",
      () =>
        each(".js-plotly-plot:has(.xaxislayer-above > *)", (graph) => {
          const [panel] = plotly.panels(graph);
          return panel && plotly.graphOf(panel) === graph;
        }),
    ],
  };
  const results = Object.entries(assumptions).map(([name, [purpose, holds]]) => [`${name} (${purpose})`, holds()]);
  return Object.fromEntries(results);
}
