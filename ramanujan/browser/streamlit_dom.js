// The selectors into the pages of Streamlit, except those into its sliders (sliders.js). If an assumption about these
// pages fails, the function that relies on it returns null, false or nothing. Its feature then has no effect.
// tests/checks/scripts/assumptions.js explains each assumption; .github/upgrading.md explains how to upgrade Streamlit.

import { debounce, observe } from "./lasting.js";

export const dom = {
  /** Whether the server runs the page's script. */
  isRunning: () => !document.querySelector("[data-test-script-state=notRunning]"),

  /** Call a listener at the start and the end of each run of the page's script. */
  watchRuns(listener, signal) {
    const app = document.querySelector("[data-testid=stApp]");
    if (app) observe(app, { attributeFilter: ["data-test-script-state"] }, listener, signal);
  },

  /** Whether this page is the wall of a class without a running script. */
  isIdleWall: () => Boolean(document.querySelector("[data-test-script-state=notRunning] .st-key-class_wall")),

  /**
   * Call a listener at every run and every change of the connection, with whether the page is connected to the server.
   */
  watchConnection(listener, signal) {
    const app = document.querySelector("[data-testid=stApp]");
    const call = () => listener(app.dataset.testConnectionState === "CONNECTED");
    if (app) observe(app, { attributeFilter: ["data-test-connection-state", "data-test-script-state"] }, call, signal);
  },

  /** A colour of the theme, which Streamlit provides to components. */
  color: (parentElement, name) =>
    getComputedStyle(parentElement.host ?? parentElement).getPropertyValue(`--st-${name}-color`).trim(),

  /** Whether a component's theme is light or dark. */
  theme: (parentElement) =>
    getComputedStyle(parentElement.host ?? parentElement).colorScheme.match(/^(light|dark)$/)?.[0],

  /** Selectors of the elements that use the arrow and page keys, or the space bar, while they have the focus. */
  TAKES_KEYS: `input:not([type=button], [type=checkbox]), textarea, select, [contenteditable=true], .stage,
    [data-scrolls], [role=slider], [role=radio], [role=tab], [role=listbox], [role=option], [role=toolbar] *`,
  TAKES_SPACE: `input, textarea, select, button, summary, a[href], [contenteditable=true], .stage, [role=slider],
    [role=radio], [role=tab], [role=button], [role=option]`,

  /** The elements that may be too wide: formulas, paragraphs with formulas, tables and their boxes. */
  boxes: () => [
    ...document.querySelectorAll(".stMarkdown :is(.katex-display, table, p:has(.katex)), [class*='st-key-table-']"),
  ],

  /** Whether a box can be scrolled sideways. */
  scrollsAside: (box) => box.scrollWidth > box.clientWidth && /auto|scroll/.test(getComputedStyle(box).overflowX),

  /** Whether a node is part of a button or link, except a preset. */
  isButton: (node) => Boolean(node.closest?.("button, a") && !node.closest(".st-key-preset")),

  /** The label of the preset that contains a node. */
  preset: (node) => node.closest?.(".st-key-preset button")?.textContent,

  /** The container of a lecture's steps. */
  lecture: () => document.querySelector(".st-key-lecture"),
  /** The link after the last step of a lecture. */
  onward: () => document.querySelector(".st-key-lecture .st-key-onward a"),

  /** Exclude formulas, figures and codes from translation. */
  keepFromTranslation() {
    const excluded = ":is(.katex, .js-plotly-plot, code, .st-key-class_letters):not([translate])";
    for (const node of document.querySelectorAll(excluded)) node.translate = false;
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
  /** The symbol with a subscript, such as F of the hoop, that contains a node of a formula. */
  symbol: (node) => node.closest?.(".katex-html .mord:has(> .msupsub)"),
  symbols: () => [...document.querySelectorAll(".katex-html .mord:has(> .msupsub)")],
  /** Letter and subscript of such a symbol. KaTeX adds an invisible space. */
  symbolText: (node) => node?.textContent.replace("\u200b", ""),
  /** A style rule that highlights all terms of a colour. */
  termRule: (color) => `.katex [style*="${color}"] { -webkit-text-stroke: .04em; text-shadow: 0 0 .4em; }`,

  /** Whether more than 30 % of a node's height, or of the window's if smaller, is on the screen. */
  inView(node) {
    const box = node?.getBoundingClientRect();
    if (!box?.height || !node.checkVisibility({ visibilityProperty: true })) return false;
    const visible = Math.min(box.bottom, innerHeight) - Math.max(box.top, 0);
    return visible > 0.3 * Math.min(box.height, innerHeight);
  },

  /** The media query for the sidebar as a drawer, as in streamlit.css. */
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
      [...box.querySelectorAll(".stElementContainer, .stPlotlyChart")]
        .some((node) => node.checkVisibility() && bottom(node) > bottom(box) + 1);
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

  isPageLink: (node) =>
    Boolean(node.closest?.("[data-testid=stSidebarNavLink], :is([data-testid=stTopNav], [data-testid=stPageLink]) a")),

  /**
   * Call a listener before Streamlit requests another page. Until the server answers, a message to a fragment still
   * names the old page, and Streamlit would then remove the content of the new page. So drop the messages that wait.
   */
  watchLeaving(listener, signal) {
    const options = { capture: true, signal };
    // With such a key, the link opens another window, and this page stays.
    const leaves = (event) => !(event.ctrlKey || event.metaKey || event.shiftKey) && dom.isPageLink(event.target);
    addEventListener("click", (event) => leaves(event) && listener(), options);
    addEventListener("popstate", listener, options);
  },

  /**
   * Debounce a message to the server, and hold it from the request for another page until the server's next run. Until
   * then Streamlit sends a message for the page before. The server would draw that page's components without the
   * content of the new page.
   */
  debounceMessage(ms, send, signal) {
    let isLeaving = false;
    const debounced = debounce(ms, () => (isLeaving ? debounced() : send()), signal);
    dom.watchLeaving(() => {
      isLeaving = true;
      debounced.cancel();
    }, signal);
    dom.watchRuns(() => {
      isLeaving &&= !dom.isRunning();
    }, signal);
    return debounced;
  },

  /** Scroll the bar of pages to the name of the present page. */
  showPresentPage() {
    const link = document.querySelector("[data-testid=stSidebarNavLink][aria-current=page]");
    link?.scrollIntoView({ block: "nearest", inline: "center" });
  },
};
