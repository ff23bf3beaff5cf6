"""Every page at every width: no words overlap, nothing jumps, and the number of controls is small.

test_browser_access opens each page in a laptop's window, and calls these checks at all widths.
"""

from tests.browser import script
from tests.test_browser_language import ADDRESSES, OVERLAPS

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
"""Counts the controls in view; a menu counts once, a slider's box while it has its frame."""
MOST_OFFERED = {"oscillator": 17, "derivation": 21, "motion": 17, "taxicab": 11, "speed": 19}


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
        # Plotly adapts figures a moment later.
        for _ in range(20):
            faults = page.evaluate(OVERLAPS) + page.evaluate(CUT_LABELS)
            if not faults:
                break
            page.wait_for_timeout(250)
        else:
            wrong[width] = faults
    assert wrong == {}


def test_a_page_whose_end_does_not_arrive_is_shown_without_it(visit):
    page = visit(ADDRESSES["worksheet"])
    title = page.locator("h1").first
    assert title.is_visible()
    page.evaluate("document.querySelector('.st-key-bar').remove()")
    assert page.locator("main :is(h1, p, label)").filter(visible=True).count() == 0
    title.wait_for()
