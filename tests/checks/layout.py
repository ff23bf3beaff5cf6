"""The layout of a page: overlapping and cut texts, jumps."""

from ramanujan.shell.menu import PAGES
from tests.checks.browser import script, until

OVERLAPS = script("overlaps")
"""Overlapping texts; only the middle three fifths of a line's height count."""
ADDRESSES = {name: page.path for name, page in PAGES.items()}
ADDRESSES["taxicab"] += "?p=1000&q=999&left=sphere"
"""Name of a page → its address, with the longest numbers."""

CUT = """[...document.querySelectorAll(".stMain .stColumn")].filter((each) => each.clientWidth).flatMap((column) =>
    [...column.querySelectorAll("button, label, [data-testid=stPageLink] a, [role=combobox]")]
        .filter((node) => node.getBoundingClientRect().right > column.getBoundingClientRect().right + 1)
        .map((node) => node.textContent))"""
"""The controls that extend beyond their column."""

SCROLLED = """() => [...document.querySelectorAll("[class*=st-key-slide-]:not([data-away]) .katex-display")]
  .filter((node) => node.scrollWidth > node.clientWidth + 1).map((node) => node.textContent.slice(0, 30))"""
"""The formulas of the present slide that are wider than their boxes."""

OPEN = """() => {
  for (const each of document.querySelectorAll("details:not([open]) > summary")) each.click();
}"""

WIDTHS = (320, 390, 480, 768, 900, 999, 1000, 1280, 1600, 3840)
WITH_FIGURES = (320, 1280)
"""Widths at which figures are also drawn, because drawing a figure takes longer than the rest of the page."""
CUT_LABELS = """() => [...document.querySelectorAll(".js-plotly-plot")].flatMap((graph) => {
  const home = graph.getBoundingClientRect();
  return [...graph.querySelectorAll(".annotation-text, .infolayer .legendtext")].filter((label) => {
    const box = label.getBoundingClientRect();
    return box.left < home.left - 1 || box.right > home.right + 1 || box.top < home.top - 1;
  }).map((label) => label.textContent);
})"""
"""The labels that are clipped at an edge of their figure."""
FITTED = """() => [...document.querySelectorAll(".stPlotlyChart")].every((chart) => {
  const picture = chart.querySelector(".main-svg");
  return !chart.clientWidth || (picture && Math.abs(picture.getBoundingClientRect().width - chart.clientWidth) < 2);
})"""
"""Whether each visible figure has the width of its place. Plotly adapts figures a moment after a change."""
WITHOUT_FIGURES = """() => {
  window.withoutFigures = new CSSStyleSheet();
  withoutFigures.replaceSync(".stPlotlyChart { display: none }");
  document.adoptedStyleSheets.push(withoutFigures);
}"""
SHIFTS = """window.shifts = [];
const patient = new CSSStyleSheet();
patient.replaceSync(":root { --patience: 3600s; }");
document.adoptedStyleSheets = [patient];
const describe = ({ node, previousRect, currentRect }) => {
  const element = node instanceof Element ? node : node?.parentElement;
  const [before, after] = [previousRect, currentRect].map(({ x, y, width, height }) => [x, y, width, height].join());
  return `${element?.tagName} ${element?.getAttribute("class")}: ${before} to ${after}`;
};
new PerformanceObserver((list) => {
  for (const { value, sources } of list.getEntries()) window.shifts.push({ value, moved: sources.map(describe) });
}).observe({ type: "layout-shift", buffered: true });"""
"""Records the layout shifts that the browser measures, independent of the speed of the machine, and what moved."""
MOST_SHIFT = 0.02
OFFERED = script("offered")
"""Counts the controls in view; a menu counts once, and so does a slider with its box."""
# Eight of these controls are in the bar of pages. On 1729 four are the page's own; on Speed eight belong to the
# race. On Motion the sliders and the tabs are side by side.
MOST_OFFERED = {"oscillator": 19, "derivation": 18, "motion": 19, "taxicab": 15, "speed": 20}


def shift(page) -> float:
    return page.evaluate("window.shifts.reduce((sum, { value }) => sum + value, 0)")


def check_calm(page, name: str) -> None:
    """Check that nothing has jumped since a page's first frame, and that the page has few controls."""
    assert shift(page) < MOST_SHIFT, page.evaluate("window.shifts")
    assert page.evaluate(OFFERED) <= MOST_OFFERED.get(name, 30)


def check_widths(page) -> None:
    """Check that no words overlap and no label of a figure is cut at any width."""
    page.evaluate(WITHOUT_FIGURES)
    wrong = {}
    for width in sorted(WIDTHS, key=WITH_FIGURES.__contains__):
        page.evaluate("(drawn) => (withoutFigures.disabled = drawn)", width in WITH_FIGURES)
        page.set_viewport_size({"width": width, "height": 900})
        until(page, FITTED)
        # Plotly places labels a moment after it has changed the width.
        for _ in range(20):
            faults = page.evaluate(OVERLAPS) + page.evaluate(CUT_LABELS)
            if not faults:
                break
            page.wait_for_timeout(250)
        else:
            wrong[width] = faults
    assert wrong == {}
