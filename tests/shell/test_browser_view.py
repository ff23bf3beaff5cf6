"""A lecturer's view in the browser: links that preserve the view, and the projector."""

import re

import pytest
from playwright.sync_api import expect

from tests.checks.browser import GO, MOUNTED, STAGE, next_frame, restyles, script, settle, traffic, until, wait_for_page
from tests.checks.layout import FITTED, OVERLAPS, SCROLLED
from tests.checks.slow_network import Network


def test_a_link_preserves_the_view(visit):
    """Check layers, speed, frame, and the moment of a pause with both clock hands, in another tab."""
    drawn = f"""() => {{
      const root = {STAGE};
      const all = (selector, read) => [...root.querySelectorAll(selector)].map(read);
      const numbers = (text) => (text?.match(/-?[\\d.]+(e-?\\d+)?/g) ?? []).map(Number);
      const lines = all(".machine > :not(defs, .ghosts) *, .hand", (node) =>
        node.closest("[style*='display: none']") ? []
          : ["transform", "d"].flatMap((name) => numbers(node.getAttribute(name))));
      const set = (node) =>
        node.type === "checkbox" ? String(node.checked) : node.value;
      return [...all(".controls :is(button, select, [type=checkbox])", set), ...lines.flat()];
    }}"""
    page = visit("motion?m_prime=0.4&glide=3", figures=False)
    page.get_by_role("button", name="Steps, speed, view").click()
    for name in ("Velocities", "Friction", "From the block"):
        page.get_by_role("checkbox", name=name).click()
    page.get_by_role("combobox", name="Speed").select_option("½×")
    for _ in range(31):
        page.get_by_role("button", name="Step forward").click()
    # A change of a paused machine restarts both hands.
    page.locator(".st-key-k input[type=range]").press("ArrowRight")
    settle(page)
    for _ in range(2):
        page.get_by_role("button", name="Step forward").click()
    page.wait_for_url(lambda url: "paused=" in url)
    settle(page)
    drawn_first = page.evaluate(drawn)
    other = visit(page.url.rpartition("/")[2], figures=False)
    again = other.evaluate(drawn)
    assert len(again) == len(drawn_first) > 100
    for before, after in zip(drawn_first, again, strict=True):
        assert after == (pytest.approx(before, abs=1e-3) if isinstance(before, float | int) else before)
    # Playing removes the pause from the link.
    other.get_by_role("button", name="Play", exact=True).click()
    other.wait_for_url(lambda url: "paused" not in url)
    assert "from=block" in other.url
    assert "speed=0.5" in other.url


# ---- on a projector

SIZES = script("small_words")
"""The texts of the present slide that are smaller than the argument.

Indices, names on bodies, and operations beside lines may be smaller.
"""
SENTENCES = script("small_sentences")
"""The small sentences of the present slide, if the slide has room."""
LAYOUT = script("slide_size")
"""The number of visible slides, their overflow, and the used share of the slide's height."""
CLIPPED_TEXTS = script("cut_figures")
"""The texts of figures that are clipped at an edge of the figure."""
BAR = """() => {
  const pager = document.querySelector('.st-key-pager').getBoundingClientRect();
  return [...document.querySelectorAll('header a, header button')].map((node) => node.getBoundingClientRect())
    .filter((box) => box.width && box.right > pager.left && box.left < pager.right && box.bottom > pager.top).length;
}"""
"""The number of names of pages that the pager covers."""
PLACE = ".st-key-pager select option:checked"
HEIGHTS = "[...document.querySelectorAll('.js-plotly-plot')].map((figure) => figure.clientHeight / innerHeight)"
SEEN = script("visible_slides")
"""Records the visible slides in each frame after a change, and whether their letters are large."""
DRAWN = """!document.querySelector("[data-testid=stSkeleton]")
    && [...document.querySelectorAll(".stPlotlyChart")].every((chart) => chart.querySelector(".main-svg"))"""
FIRST, MOTION = "?m=3.7&m_prime=0.41&k=33.3&radius=20&slide=steps", "motion?spin=3&mu=0.01"
CLOCKS, MODES = "lesson?chosen=two-clocks.far_behind", "lesson?stop=zero-modes&chosen=zero-modes.one"
SLIDES = {
    FIRST: 3,
    "derivation?route=newton&step=4": 4,
    MOTION: 8,
    "1729?left=sphere&top=shell": 5,
    "speed?slide=costs": 5,
    "lesson?stop=end": 2,
    MODES: 1,
    "worksheet": 1,
    CLOCKS: 1,
}
"""Page → number of its slides."""
FULL = {FIRST: 1, CLOCKS: 0.75, MODES: 0.75, "1729?left=sphere&top=shell": 1}
"""Page → used share of a slide's height from which its sentences may be small."""


def projected(visit, path: str, *scripts: str, **more):
    page = visit(f"{path}{'&' if '?' in path else '?'}view=projector", *scripts, **more)
    page.wait_for_selector(PLACE, state="attached")
    page.wait_for_function(DRAWN)
    next_frame(page)
    return page


@pytest.mark.parametrize("half", [0, 1])
def test_a_projector_shows_one_slide_at_a_time_large_filled_and_without_scrolling(visit, server, half):
    page = None
    with Network(server) as network:
        # The switch is tested last, because it opens the sidebar.
        for path in sorted(list(SLIDES)[half::2], key=MOTION.__eq__):
            if path == MOTION:
                page = visit(path, tab=page, width=1920, height=1080, network=network.address)
                check_switched_on(page)
                page.set_viewport_size({"width": 1280, "height": 720})
            else:
                is_first = not page
                if path == "worksheet":
                    turn_on_a_slow_network(page, network)
                page = projected(visit, path, *([SEEN] if is_first else []), within=page, network=network.address)
                network.seconds = traffic(page).late = 0
                if is_first:
                    check_loading(page, path)
            if path in (FIRST, MOTION):
                check_a_text_in_a_figure_restyles_little(page)
            if path == FIRST:
                check_address(page)
            check_slides(page, SLIDES[path], FULL.get(path))
            if path == FIRST:
                check_zoomed(page, 1, "svg.machine", "svg.dial")
                check_leaving(page, network)
            if path == MOTION:
                check_switched_off(page)
        if half:
            check_clicker(projected(visit, "lesson?chosen=two-clocks.ahead", within=page))


def turn_on_a_slow_network(page, network: Network) -> None:
    """Turn a slide before and after a request for another page, which the app answers late.

    The pager sends a slide's name after 0.4 seconds. Before the answer, it must not send it.
    """
    network.seconds = traffic(page).late = 0.5
    page.keyboard.press("PageUp")
    traffic(page).begin()
    page.evaluate(GO, "1729?view=projector")
    page.keyboard.press("PageDown")
    page.wait_for_function("document.querySelectorAll('[data-slide]').length > 2")
    wait_for_page(page)
    assert page.locator("[data-slide]").count() > 2
    page.keyboard.press("PageUp")


def check_loading(page, path: str) -> None:
    """Check that during loading only the requested slide was visible, with large letters."""
    (drawn_first,) = page.evaluate("[...window.seen]")
    assert drawn_first.endswith(" true")
    assert ("slide=" not in path) or drawn_first == f"{path.partition('slide=')[2]} true"


def check_a_text_in_a_figure_restyles_little(page) -> None:
    """Check that one more node in a figure does not restyle the page.

    Plotly adds and measures hundreds of texts, so that the machine would move seconds later. A rule such as
    `A:has(x) > B` can be the cause.
    """
    page.wait_for_function(FITTED)
    settle(page)
    with restyles(page) as styled:
        page.evaluate(
            """() => {
              const figure = document.querySelector(".stPlotlyChart .main-svg");
              const text = figure.appendChild(document.createElementNS(figure.namespaceURI, "text"));
              figure.getBoundingClientRect();
              text.remove();
            }"""
        )
        next_frame(page)
    # Without the fault at most 69 of 10,700 and of 2,800 elements.
    assert 0 < max(styled) < 1000


def check_slides(page, count: int, full: float | None) -> None:
    """Check the slides of one page, one after the other.

    With `full`, check them on a narrow projector. There, other words have at least 2.2 % of the height. For readers in
    the last row, sentences have 3.5 %. They may be smaller on a slide of which more than the share `full` is used.
    """
    least = 23.9
    if full:
        page.set_viewport_size({"width": 1024, "height": 768})
        least = 0.022 * 768
    slides = page.locator(".st-key-pager select")
    titles = slides.locator("option").all_inner_texts()
    assert len(titles) == count == len(set(titles))
    assert slides.is_visible() == (count > 1)
    if count > 1:
        slides.select_option(titles[0])
    wrong = []
    for slide, title in enumerate(titles, start=1):
        expect(page.locator(PLACE)).to_have_text(title)
        # A figure that becomes visible may be redrawn, and the letters then fit the slide again.
        for _ in range(40):
            layout = page.evaluate(LAYOUT)
            fits = layout["visible"] == 1 and max(layout["over"], layout["wide"]) <= 2 and layout["filled"] > 1 / 3
            faults = page.evaluate(OVERLAPS) + page.evaluate(CLIPPED_TEXTS) + ([] if fits else [layout])
            if not faults:
                break
            page.wait_for_timeout(300)
        faults += page.evaluate(SIZES, least)
        if full:
            faults += page.evaluate(SENTENCES, [0.035, full]) + page.evaluate(SCROLLED)
        wrong += [(title, each) for each in faults]
        if slide < len(titles):
            page.locator(".st-key-pager .next").click()
            next_frame(page)
    # The pager sends the last slide's name after 0.4 seconds.
    page.wait_for_timeout(500)
    settle(page)
    assert wrong == []
    page.set_viewport_size({"width": 1920, "height": 1080})
    next_frame(page)
    assert page.evaluate(BAR) == 0
    page.wait_for_function(f"({CLIPPED_TEXTS})().length === 0", polling=200)
    assert page.evaluate(SIZES, 23.9) == []


def check_address(page) -> None:
    """Check that the address contains the slide, and that figures are large."""
    expect(page.locator(PLACE)).to_have_text(re.compile("^Slide 3/3"))
    # While Streamlit draws a page, another slide may appear before the requested one.
    page.evaluate("""async () => {
      const slide = document.querySelector(".st-key-slide-steps"), { parentElement } = slide;
      slide.remove();
      await new Promise((resolve) => setTimeout(resolve, 100));
      parentElement.append(slide);
    }""")
    expect(page.locator(PLACE)).to_have_text(re.compile("^Slide 3/3"))
    page.keyboard.press("PageUp")
    page.wait_for_url("**slide=curve*")
    page.wait_for_function(f"Math.max(...{HEIGHTS}) > 0.6")


def check_zoomed(page, slide: int, *parts: str) -> None:
    """Check that parts are in view on a screen of 1280×720 pixels at 150 %, without the drawer of a phone."""
    page.set_viewport_size({"width": 853, "height": 480})
    slides = page.locator(".st-key-pager select")
    if slides.is_visible():
        slides.select_option(index=slide - 1)
    next_frame(page)
    assert page.evaluate(BAR) == 0
    assert not page.locator(".st-key-handle").is_visible()
    for part in parts:
        for box in [node.bounding_box() for node in page.locator(part).all() if node.is_visible()]:
            assert box["y"] + box["height"] <= 480
    page.set_viewport_size({"width": 1920, "height": 1080})
    next_frame(page)


def check_leaving(page, network: Network) -> None:
    """Check that another page begins with its own first slide, even while a turned slide is still to be sent."""
    turn_on_a_slow_network(page, network)
    page.get_by_role("link", name="Motion").first.click()
    expect(page.locator(PLACE)).to_have_text(re.compile("^Slide 1/8"))
    page.wait_for_url(lambda url: "slide=" not in url)
    settle(page)
    expect(page.locator(PLACE)).to_have_text(re.compile("^Slide 1/8"))
    network.seconds = traffic(page).late = 0


def check_clicker(page) -> None:
    """Check that a clicker turns the stops of the lesson, and at its end the slides."""
    stop = page.locator(".st-key-turn [data-testid=stBidiComponentIsolated] output")

    def at(slide: str, place: str) -> None:
        expect(stop).to_have_text(re.compile(f"^{place}"))
        settle(page)
        expect(page.locator(PLACE)).to_have_text(re.compile(f"^Slide {slide}"))

    at("1/1", "1/")
    page.keyboard.press("PageDown")
    at("1/1", "2/")
    # The machine is to the left of the question.
    assert page.locator("[data-away]").count() == 0
    words, machine = (page.locator(place).first.bounding_box() for place in (".st-key-lead-question", "svg.machine"))
    assert machine["x"] + machine["width"] <= words["x"]
    assert abs(words["y"] - machine["y"]) < machine["height"]
    check_zoomed(page, 1, "svg.machine", "svg.dial", ".st-key-options button")
    page.keyboard.press("PageUp")
    at("1/1", "1/")
    page.evaluate(GO, "lesson?stop=huge-ratio&view=projector")
    wait_for_page(page)
    for slide in (1, 2):
        page.keyboard.press("PageDown")
        at(f"{slide}/2", "✓")
    for slide, place in (("1/2", "✓"), ("1/1", "17/")):
        page.keyboard.press("PageUp")
        at(slide, place)


def check_switched_on(page) -> None:
    """Check that the switch puts the view into the address."""
    # Negative control: without a projector, letters and figures are smaller, and the page is not divided.
    assert page.evaluate(SIZES, 23.9)
    page.wait_for_function(f"Math.max(...{HEIGHTS}) < 0.6")
    assert page.locator(PLACE).count() == 0
    page.locator(".st-key-projector label").click()
    page.wait_for_url("**view=projector*")
    page.wait_for_selector(PLACE, state="attached")
    settle(page)
    until(page, MOUNTED)
    page.keyboard.press("PageDown")
    expect(page.locator(PLACE)).to_have_text(re.compile(r"^Slide 2/"))


def check_switched_off(page) -> None:
    """Check that the switch takes the view out of the address."""
    if page.locator("[data-testid=stExpandSidebarButton]").is_visible():
        page.locator("[data-testid=stExpandSidebarButton]").click()
    page.locator(".st-key-projector label").click()
    page.wait_for_function("!location.search.includes('projector')")
    page.wait_for_function("!document.querySelector('[data-away]')")
