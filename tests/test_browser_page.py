"""The app in a browser: loading, announcements, assumptions about Streamlit's page, the stage by keys and as a file."""

import io
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image, ImageColor
from playwright.sync_api import Page, expect

from ramanujan.shell.theme import BODY_COLORS
from tests.browser import STAGE, inside, module, next_frame, script, settle, traffic
from tests.test_export import ENGINE, environments_nest, typeset
from tests.test_look import THEME, rgb

REGION = ".st-key-unseen-services [role=status]"


# ---- the machine first

FIRST = script("first_frame")
"""Records, at the stage's first frame, the stage's place and the number of slow elements on the page.

It also records the position of the heading above the curve in every frame.

The page requests its second run after drawing the machine, not because of the timer of ten seconds.
"""


@pytest.mark.parametrize(("height", "link"), [(720, "?k=20&m=7"), (2400, "")])
def test_the_machine_appears_before_all_slow_elements_and_does_not_move(chromium, server, height, link):
    page = chromium.new_page(viewport={"width": 1280, "height": height}, bypass_csp=True)
    page.add_init_script(FIRST)
    held = []
    if link:  # a machine at rest, and the elements that wait for it
        page.emulate_media(reduced_motion="reduce")
        page.route("**/arrival.js", lambda route: held.append(route))
    chromium.start_tracing(page=page, categories=["devtools.timeline"])
    with page.expect_request("**/arrival.js"):
        page.goto(server + link, wait_until="commit")
        page.wait_for_function("window.first")
    for route in held:
        route.continue_()
    page.locator(".st-key-curve .scatterlayer path").first.wait_for(state="attached")
    page.locator(".st-key-steps details").last.wait_for(state="attached")
    # Plotly's measurements of words do not restyle the whole page.
    events = json.loads(chromium.stop_tracing())["traceEvents"]
    styled = [each["args"].get("elementCount", 0) for each in events if each["name"] == "UpdateLayoutTree"]
    assert len(styled) > 50
    assert len([count for count in styled if count > 1000]) < 10
    first = page.evaluate("first")
    assert first["heavy"] == 0
    box = page.locator(".st-key-stage").bounding_box()
    assert first["place"] == [box["x"], box["y"], box["width"]]
    # The settings in the address apply from the first frame on, and messages about them remain.
    assert (first["m"], first["k"]) == (1, 20 if link else 10)
    assert page.locator(".st-key-k input[type=range]").input_value() == str(first["k"])
    assert page.locator("main [role=alert]").count() == bool(link)
    assert page.url.partition("?")[2] == ("k=20" if link else "")
    # Drawing the curve and the steps causes no jump.
    heights = page.evaluate("heights")
    page.close()
    assert len(heights) > 5
    assert max(heights) - min(heights) < 2


# ---- the screen reader's tree


def test_events_are_announced_once_and_the_assumptions_about_the_host_pages_are_true(visit):
    page = visit("motion?mu=1.5")
    page.emulate_media(reduced_motion="no-preference")
    region = page.locator(REGION)
    page.evaluate(
        """() => {
          const services = document.querySelector(".st-key-unseen-services [data-testid=stBidiComponentIsolated]");
          const region = services.shadowRoot.querySelector("[role=status]");
          window.announced = [];
          new MutationObserver(() => region.textContent && window.announced.push(region.textContent))
            .observe(region, { childList: true, characterData: true, subtree: true });
        }"""
    )

    def check_announced(part: str) -> None:
        page.wait_for_function(f"window.announced.some((sentence) => sentence.includes({part!r}))")
        assert len([each for each in page.evaluate("window.announced") if part in each]) == 1
        page.evaluate("window.announced = []")

    page.get_by_role("button", name="Pause", exact=True).click()
    check_announced("Paused.")
    page.get_by_role("button", name="Steps, speed, view").click()
    page.get_by_role("button", name="Step forward").click()
    check_announced("periods after release, t =")
    page.locator(".st-key-more_controls summary").first.click()
    page.get_by_text("Light rollers", exact=True).click()
    check_announced("one full turn in")
    page.locator(".st-key-mu input[type=range]").focus()
    page.keyboard.press("Home")
    check_announced("would slip")
    assert region.count() == 1
    with_sidebar = page.evaluate(HELD)
    check_assumptions(visit("", width=390, height=844, within=page), with_sidebar)


HELD = f"{module('components/streamlit_dom')}.then({script('assumptions')})"


def check_assumptions(page, elsewhere):
    """Check the app's assumptions about Streamlit's page, on this or on another page."""
    page.locator(".st-key-steps summary").nth(3).click()
    for awaited in (".katex-display .base", ".js-plotly-plot .nsewdrag"):
        page.wait_for_selector(awaited, state="attached")
    settle(page)
    holds = page.evaluate(HELD)
    assert len(holds) > 10
    assert [name for name, held in holds.items() if not (held or (held is None and elsewhere[name]))] == []
    # Negative control: a missing slider satisfies no assumption.
    moved = f"""async () => {{
      const {{ dom }} = await {module("components/streamlit_dom")}, slider = dom.slider;
      dom.slider = () => null;
      const held = await {HELD}, shows = dom.shows(dom.slider("m"), 1);
      dom.slider = slider;
      return [shows, ...Object.values(held).slice(0, 2)];
    }}"""
    assert page.evaluate(moved) == [False, False, True]
    # Streamlit draws a slider moved by the page, and sends nothing.
    sent = len(traffic(page).sent)
    page.evaluate(
        f"{module('components/streamlit_dom')}.then(({{ dom }}) => dom.moveSlider(dom.slider('compression'), 5))"
    )
    expect(page.locator(".st-key-compression [data-testid=stSliderThumbValue]")).to_have_text("5.0")
    settle(page)
    assert len(traffic(page).sent) == sent


@pytest.mark.parametrize(("width", "height"), [(1280, 720), (390, 844)])
def test_a_sketch_reserves_the_places_of_the_page_before_its_text(chromium, server, width, height):
    """Heading, text and picture have their places although the server does not answer."""
    page = chromium.new_page(viewport={"width": width, "height": height}, bypass_csp=True)
    page.route_web_socket(re.compile("_stcore"), lambda _silent: None)
    page.goto(server)
    page.wait_for_selector("[data-testid=stApp]", state="attached")
    page.add_style_tag(content=":root { --patience: 3600s; }")  # for a slow machine
    next_frame(page)
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    paper = picture.getpixel((20, height - 20))
    for y in (80, 140, 300):
        assert picture.getpixel((50, y)) != paper, y
    page.close()


# ---- the stage by keys, and as a file


def check_stage_without_data(page):
    """Check that a stage without data shows no label without a value."""
    unnamed = """async (begin) => {
      const root = document.body.appendChild(document.createElement("div"));
      const data = { stage: "untold", clock: "untold", layers: [], limits: { compression: [0, 0.1] }, watch: {} };
      await (await begin).begin({ name: "stage/stage", data, parentElement: root });
      return root.querySelectorAll("[role=img]:not([aria-label]), [role=slider]:not([aria-valuenow])").length;
    }"""
    assert page.evaluate(f"({unnamed})({module('begin')})") == 0


def check_keys(page):
    """Check that arrow keys move between the controls of the stage, and operate them."""
    stage = page.locator(".st-key-stage")
    focused = f"{STAGE}.activeElement.getAttribute('aria-label') ?? {STAGE}.activeElement.textContent"
    show = stage.get_by_role("button", name="Steps, speed, view")
    show.press("Enter")
    stops = "root.querySelectorAll('.transport button[tabindex=\"0\"]').length"
    assert inside(page, stops) == 1
    stage.get_by_role("button", name="Release again").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate(focused) == "Step back"
    page.keyboard.press("End")
    assert page.evaluate(focused) == "Step forward"
    page.keyboard.press("ArrowRight")
    assert page.evaluate(focused) == "Release again"
    # A menu uses the browser's keys.
    for _ in ("speed", "viewpoint", "energy"):
        page.keyboard.press("Tab")
    page.keyboard.press("Space")
    assert inside(page, "root.querySelector('.energy').checkVisibility()")
    page.keyboard.press("Escape")
    expect(stage.get_by_role("checkbox", name="Energy")).to_be_hidden()
    scrub = stage.get_by_role("slider", name="Position in the period")
    scrub.fill("0.5")
    next_frame(page)
    assert "0.50 periods" in scrub.get_attribute("aria-valuetext")


def save_stage(page: Page, folder: Path) -> dict[str, bytes]:
    """Download the picture of the stage in each format. Return file suffix → content."""
    files = {}
    for label in ("SVG", "PNG", "TikZ"):
        with page.expect_download() as download:
            page.get_by_role("button", name=label, exact=True).click()
        file = folder / download.value.suggested_filename
        download.value.save_as(file)
        files[file.name.partition(".")[2]] = file.read_bytes()
    return files


def check_svg(page: Page, svg: bytes) -> None:
    """Check that the file is self-contained, in the light theme, and has the shapes of the page."""
    root = ElementTree.fromstring(svg)
    _left, _top, width, height = (float(number) for number in root.get("viewBox").split())
    assert width == pytest.approx(2 * height, rel=1e-6)
    assert all(word not in svg.decode() for word in ("var(", "--", "class=", "http://127", "<script"))
    assert not re.search(rb"url\((?!&quot;#|#|\"#)", svg)
    painted = {node.get(kind) for node in root.iter() for kind in ("fill", "stroke")}
    for colour in BODY_COLORS.values():
        assert "rgb({}, {}, {})".format(*rgb(THEME["light"][f"{colour}TextColor"])) in painted
    texts = {"".join(node.itertext()) for node in root.iter("{http://www.w3.org/2000/svg}text")}
    assert {"m", "m′", "k"} <= texts
    slab = inside(page, "root.querySelector('.moving .slab').getAttribute('transform')")
    assert slab in {node.get("transform") for node in root.iter()}, "the slab is where it is on the page"


def check_png(png: bytes) -> None:
    image = np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), dtype=int)
    assert image.shape[:2] == (1200, 2400)
    green = np.array(rgb(THEME["light"]["greenTextColor"]))
    assert (np.abs(image - green).sum(axis=2) < 6).sum() > 500, "the slab's edge is painted"


def check_tikz(tikz: str, folder: Path) -> None:
    assert environments_nest(tikz)
    assert tikz.count("\\begin{tikzpicture}") == tikz.count("\\clip (0pt,0pt)") == 1
    assert tikz.count("svg {") > 15
    for d in re.findall(r"svg \{(.*?)\}", tikz):
        assert re.fullmatch(r"[MLHVChvlmz\d\s.e,-]+", d), d
    assert "$m'$" in tikz
    assert tikz.isascii()
    if ENGINE:
        document = r"\documentclass{article}\usepackage{tikz}\usetikzlibrary{svg.path}\textwidth=50in\begin{document}%s"
        document += r"\end{document}"
        assert "Overfull" not in typeset(document % tikz, folder)


def check_saved_curve(page: Page, folder: Path) -> None:
    """Check the files of a figure, which Plotly saves itself."""
    page.locator(".st-key-curve .modebar-btn", has_text="PNG").wait_for(state="attached")
    page.locator(".st-key-curve .js-plotly-plot").hover()
    for format in ("SVG", "PNG"):
        with page.expect_download() as download:
            page.locator(".st-key-curve .modebar-btn", has_text=format).click()
        assert download.value.suggested_filename == f"ramanujan-curve.{format.lower()}"
        download.value.save_as(folder / download.value.suggested_filename)
    with Image.open(folder / "ramanujan-curve.png") as saved:
        assert saved.width > 2000
        assert saved.convert("RGBA").getpixel((0, 0)) == (*ImageColor.getrgb(THEME["dark"]["backgroundColor"]), 255)
    figure = (folder / "ramanujan-curve.svg").read_text(encoding="utf-8")
    assert ElementTree.fromstring(figure).get("viewBox")
    assert set(re.findall(r"https?://[^\"')]+", figure)) <= {
        "http://www.w3.org/1999/xlink",
        "http://www.w3.org/2000/svg",
    }
    assert "equal masses" in figure


def test_the_stage_is_operated_by_keys_and_saved_as_svg_png_and_tikz(visit, tmp_path):
    """The downloaded files are complete, self-contained, in the light theme, and not empty."""
    page = visit(theme="dark")
    check_stage_without_data(page)
    check_keys(page)
    page.get_by_role("button", name="Steps, speed, view").click()
    page.get_by_role("button", name="Step forward").click()
    page.get_by_role("checkbox", name="Forces").check()
    next_frame(page)
    files = save_stage(page, tmp_path)
    check_svg(page, files["svg"])
    check_png(files["png"])
    check_tikz(files["tex"].decode(), tmp_path)
    check_saved_curve(page, tmp_path)
