// All selectors into the pages of Streamlit and Plotly. If an assumption about these pages fails, the function that relies on it
// returns null, false or nothing. Its feature then has no effect. tests/scripts/assumptions.js explains each assumption;
// .github/upgrading.md explains how to upgrade Streamlit.

import { observe } from "./lasting.js";

const draggedAway = new WeakMap(); // data from the server → the slider whose thumb has been dragged away from its value
const snapped = new WeakMap(); // slider → the value between two steps to which its thumb has snapped, until the server sends it

const STANDALONE = "standalone" in document.documentElement.dataset;
const SAVE = ".js-plotly-plot .modebar-group:first-child > .modebar-btn:first-child";

export const dom = {
  /** The input of the Streamlit slider with this key; its value follows the thumb during a drag. */
  slider: (key) => document.querySelector(`.st-key-${CSS.escape(key)} input[type="range"]`),

  /**
   * Whether a slider shows the server's value, rounded to a step; false for a missing slider. `received` is the object with the
   * value. After a drag away from the value and back, the slider will send its step, so the two values must be equal.
   */
  shows(slider, value, received) {
    if (!slider) return false;
    const distance = Math.abs(dom.value(slider) - value), isNear = distance <= 0.501 * Number(slider.step);
    if (snapped.has(slider)) return distance === 0 && snapped.delete(slider);
    if (!isNear && dom.isDragged(slider)) draggedAway.set(received, slider);
    return isNear && (distance < 1e-9 || draggedAway.get(received) !== slider);
  },

  /** A slider's value: the value to which its thumb has snapped, or the value of its step. */
  value: (slider) => snapped.get(slider) ?? Number(slider.value),

  /** Snap a slider's thumb to a value between its steps, or release it (null). */
  snap(slider, value) {
    snapped.delete(slider);
    if (!slider || value === null) return;
    snapped.set(slider, value);
    dom.moveSlider(slider, value);
  },

  /**
   * Format every slider's number by a function, above the thumb and for screen readers, until the signal aborts. React's
   * text remains in the page, but page.css hides it if the formatted text exists.
   */
  watchSliderValues(write, signal) {
    const update = () => {
      for (const input of document.querySelectorAll("[data-testid=stSlider] input[type=range]")) {
        const text = input.ariaValueText ?? "";
        if (!/^-?\d+(\.\d+)?$/.test(text)) continue;
        const thumb = input.closest("[data-testid=stSlider]").querySelector("[data-testid=stSliderThumbValue]");
        const written = write(text);
        if (written !== text) input.ariaValueText = written;
        if (thumb && thumb.dataset.written !== written) thumb.dataset.written = written;
      }
    };
    observe(document.body, { subtree: true, childList: true, attributeFilter: ["aria-valuetext"] }, update, signal);
    update();
  },

  /** Whether a slider's thumb is being dragged; the change of a slider's value per pixel. */
  isDragged: (slider) => Boolean(slider?.closest("[data-dragging]")),
  perPixel: (slider) => (slider.max - slider.min) / slider.closest("[role=group]").clientWidth,

  /**
   * Move a slider's thumb on the page. The event triggers React's handler, and Streamlit draws the thumb. Streamlit sends
   * values only after a drag or a key stroke (streamlit#4541).
   */
  moveSlider(input, value) {
    if (!input) return;
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set.call(input, value);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  },

  /**
   * Send a value by a slider: move it to the adjacent step, then to the value by an arrow key. Return false if the slider
   * is missing or disabled, for example without a server.
   */
  sendSlider(input, value) {
    if (!input || input.disabled) return false;
    const [by, key] = value - input.min < input.step ? [1, "ArrowLeft"] : [-1, "ArrowRight"];
    dom.moveSlider(input, value + by * input.step);
    // React draws the slider in a microtask, which is already queued.
    queueMicrotask(() => input.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));
    return true;
  },

  /** Mark a value on a slider's track, with a word below it; page.css draws the mark. Return whether the slider exists. */
  markSlider(key, value, word) {
    const input = dom.slider(key), style = input?.closest(`.st-key-${CSS.escape(key)}`).style;
    style?.setProperty("--mark", (value - input.min) / (input.max - input.min));
    style?.setProperty("--mark-word", JSON.stringify(word));
    return Boolean(style);
  },

  /** The settings in the address: after ? in the app, after # in the standalone file. */
  settings: () => new URLSearchParams(STANDALONE ? location.hash.slice(1) : location.search),

  /** Write settings into the address; an entry is [key, value, default]. Omit a value that equals its default. */
  writeSettings(entries) {
    const settings = dom.settings();
    for (const [key, value, byDefault] of entries) value === byDefault ? settings.delete(key) : settings.set(key, value);
    if (String(settings) === String(dom.settings())) return;
    const url = new URL(location.href);
    url.search = settings;
    // An empty # differs from no #: a saved file then begins with the defaults.
    history.replaceState(history.state, "", STANDALONE ? `#${settings}` : url);
  },

  /**
   * Add at most one entry to the browser's history per action of the reader. Streamlit adds one for every value that its server
   * writes into the address (streamlit#9279). The way back to another page would then have several steps, some with a mixture
   * of two machines.
   */
  limitHistory() {
    let hasActed = false;
    // A screen reader can click without a pointer or a key.
    for (const type of ["pointerdown", "keydown", "click"]) addEventListener(type, () => (hasActed = true), { capture: true });
    const push = history.pushState.bind(history);
    history.pushState = (...entry) => {
      hasActed ? push(...entry) : history.replaceState(...entry);
      hasActed = false;
    };
  },

  /** Whether the server runs the page's script. */
  isRunning: () => !document.querySelector("[data-test-script-state=notRunning]"),

  /** Call a listener at the start and the end of each run of the page's script. */
  watchRuns: (listener, signal) =>
    observe(document.querySelector("[data-testid=stApp]"), { attributeFilter: ["data-test-script-state"] }, listener, signal),

  /** Whether this page is the wall of a class without a running script. */
  isIdleWall: () => Boolean(document.querySelector("[data-test-script-state=notRunning] .st-key-class_wall")),

  /** Call a listener at every run and every change of the connection, with whether the page is connected to the server. */
  watchConnection(listener, signal) {
    const app = document.querySelector("[data-testid=stApp]");
    const call = () => listener(app.dataset.testConnectionState === "CONNECTED");
    if (app) observe(app, { attributeFilter: ["data-test-connection-state", "data-test-script-state"] }, call, signal);
  },

  /** A colour of the theme, which Streamlit provides to components. */
  color: (parentElement, name) =>
    getComputedStyle(parentElement.host ?? parentElement).getPropertyValue(`--st-${name}-color`).trim(),

  /** Whether a component's theme is light or dark. */
  theme: (parentElement) => getComputedStyle(parentElement.host ?? parentElement).colorScheme.match(/^(light|dark)$/)?.[0],

  /**
   * Call a listener with each Plotly graph on the page, now or later, after each of its drawings, until the signal aborts. A
   * graph has its `layout` as a property. Streamlit has no event for a new figure, so this function observes the page.
   */
  watchGraphs(listener, signal) {
    const known = new WeakSet();
    const connect = () => {
      for (const graph of document.querySelectorAll(".js-plotly-plot")) {
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

  /** Add a button for PNG beside Plotly's button, which saves a graph as SVG. */
  offerFormats(graph) {
    const svg = graph.querySelector(SAVE);
    if (!svg || svg.nextSibling?.textContent) return;
    const png = svg.cloneNode(true);
    png.addEventListener("click", () => {
      const options = graph._context.toImageButtonOptions;
      options.format = "png";
      svg.click();
      options.format = "svg";
    });
    svg.after(png);
    for (const [button, format] of [[svg, "SVG"], [png, "PNG"]]) {
      button.append(format);
      button.dataset.title = button.ariaLabel += ` (${format})`;
    }
  },

  /** The curves of a graph, with decoded arrays of numbers. */
  curves: (graph) => graph._fullData,

  /** The graph that contains a node. */
  graphOf: (node) => node.closest?.(".js-plotly-plot"),

  /** The rectangles that cover a graph's panels. */
  panels: (graph) => [...graph.querySelectorAll(".nsewdrag")],

  /** Whether a node is the rectangle over a panel. */
  isPanel: (node) => node.matches?.(".nsewdrag") ?? false,

  /** Selectors of the elements that use the arrow and page keys, or the space bar, while they have the focus. */
  TAKES_KEYS: `input:not([type=button], [type=checkbox]), textarea, select, [contenteditable=true], .stage, [data-scrolls],
    [role=slider], [role=radio], [role=tab], [role=listbox], [role=option], [role=toolbar] *`,
  TAKES_SPACE: `input, textarea, select, button, summary, a[href], [contenteditable=true], .stage, [role=slider], [role=radio],
    [role=tab], [role=button], [role=option]`,

  /** The elements that may be too wide: formulas, paragraphs with formulas, tables and their boxes. */
  boxes: () => [...document.querySelectorAll(".stMarkdown :is(.katex-display, table, p:has(.katex)), [class*='st-key-table-']")],

  /** Whether a box can be scrolled sideways. */
  scrollsAside: (box) => box.scrollWidth > box.clientWidth && /auto|scroll/.test(getComputedStyle(box).overflowX),

  /** The container of a lecture's steps. */
  lecture: () => document.querySelector(".st-key-lecture"),
  /** The link after the last step of a lecture. */
  onward: () => document.querySelector(".st-key-lecture .st-key-onward a"),

  /** Exclude formulas, figures and codes from translation. */
  keepFromTranslation() {
    const nodes = document.querySelectorAll(":is(.katex, .js-plotly-plot, code, .st-key-class_letters):not([translate])");
    for (const node of nodes) node.translate = false;
  },

  /** The formulas in a node. */
  formulas: (node) => [...node.querySelectorAll(".katex")],
  /** The formula that contains a node. */
  formulaOf: (node) => (node.closest ? node : node.parentElement)?.closest(".katex-display, .katex"),
  /** The LaTeX of a formula, and whether it is displayed on its own line. */
  source: (formula) => ({
    latex: formula.querySelector("annotation").textContent,
    isDisplayed: formula.querySelector("math").getAttribute("display") === "block",
  }),

  /** Whether a node is part of a formula. */
  isFormula: (node) => Boolean(node.closest?.(".katex")),
  /** The coloured term of a formula that contains a node. */
  term: (node) => node.closest?.(".katex [style*='color']"),
  /** A style rule that highlights all terms of a colour. */
  termRule: (color) => `.katex [style*="${color}"] { -webkit-text-stroke: .04em; text-shadow: 0 0 .4em; }`,

  /** Whether more than 30 % of a node's height, or of the window's if smaller, is on the screen. */
  inView(node) {
    const box = node?.getBoundingClientRect();
    if (!box?.height || !node.checkVisibility({ visibilityProperty: true })) return false;
    const visible = Math.min(box.bottom, innerHeight) - Math.max(box.top, 0);
    return visible > 0.3 * Math.min(box.height, innerHeight);
  },

  /** The media query for the sidebar as a drawer, as in page.css. */
  NARROW: "(max-width: 999px)",

  /** The slides of the page in their order. Streamlit may draw a slide's title later. */
  slides: () =>
    [...document.querySelectorAll("[class*='st-key-slide-']")].map((node) => ({
      node,
      name: /st-key-slide-([a-z0-9_]+)/.exec(node.className)[1],
      title: node.querySelector("[data-slide]")?.dataset.slide,
    })),

  /** Whether the content of a slide, or of a table on it, exceeds its box. */
  overflows(slide) {
    // Plotly draws a figure in its new size only later, so a picture may still be larger than its box.
    const bottom = (node) => node.getBoundingClientRect().bottom;
    const isTooHigh = (box) =>
      [...box.querySelectorAll(".stElementContainer, .stPlotlyChart")].some((node) => bottom(node) > bottom(box) + 1);
    return slide.scrollHeight > slide.clientHeight + 1 || [...slide.children].filter(dom.hasFigure).some(isTooHigh) ||
      [slide, ...slide.querySelectorAll("[class*='st-key-table-']")].some(dom.scrollsAside);
  },
  /** Shrink each formula of a slide that is too wide for its box (projector.css). */
  fitFormulas(slide) {
    const formulas = [...slide.querySelectorAll(".katex-display")];
    for (const { style } of formulas) style.setProperty("--formula", 1);
    for (const { style, scrollWidth, clientWidth } of formulas.filter(dom.scrollsAside)) {
      style.setProperty("--formula", (0.95 * clientWidth) / scrollWidth);
    }
  },
  /** Whether a slide has a figure, which fills the space beside the text. */
  hasFigure: (slide) => Boolean(slide.querySelector(".stPlotlyChart")),

  /** The width of the page's content. */
  contentWidth: () => document.querySelector(".stMainBlockContainer > *")?.clientWidth || innerWidth,

  /** The element that scrolls the page. */
  main: () => document.querySelector("[data-testid=stMain]"),

  /** The scroll distance until the stage is at the top, below the bar of pages; 0 without a stage. */
  distanceToStage: () => (document.querySelector("[class*=st-key-stage]")?.getBoundingClientRect().top ?? 56) - 56,

  isPageLink: (node) => Boolean(node.closest?.("[data-testid=stSidebarNavLink], [data-testid=stPageLink] a")),

  /** Scroll the bar of pages to the name of the present page. */
  showPresentPage() {
    const link = document.querySelector("[data-testid=stSidebarNavLink][aria-current=page]");
    link?.scrollIntoView({ block: "nearest", inline: "center" });
  },

  /** Whether a node is part of the draggable area of a Streamlit slider. */
  isSliderTrack: (node) => Boolean(node.closest?.("[data-testid=stSlider] [role=group]")),
};
