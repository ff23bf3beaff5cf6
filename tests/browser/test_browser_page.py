"""The app in a browser: loading, announcements, assumptions about Streamlit's page, the stage by keys and as a file."""

import io
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageColor
from playwright.sync_api import Page, expect

from ramanujan.shell.theme import BODY_COLORS
from tests.checks.bare import THEME
from tests.checks.browser import STAGE, inside, module, next_frame, restyles, script, settle, traffic
from tests.checks.engines import new_context
from tests.checks.layout import ADDRESSES
from tests.checks.look import rgb

REGION = ".st-key-unseen-services [role=status]"


# ---- the machine first

FIRST = script("first_frame")
"""Records, at the stage's first frame, the stage's place and the number of slow elements on the page.

It also records the position of the heading above the curve in every frame.

The page requests its second run after drawing the machine, not because of the timer of ten seconds.
"""


@pytest.mark.parametrize(("height", "link"), [(720, "?k=20&m=7"), (2400, "")])
def test_the_machine_appears_before_all_slow_elements_and_does_not_move(chromium, server, height, link):
    page = new_context(chromium, viewport={"width": 1280, "height": height}, bypass_csp=True).new_page()
    page.add_init_script(FIRST)
    held = []
    if link:  # a machine at rest, and the elements that wait for it
        page.emulate_media(reduced_motion="reduce")
        page.route("**/arrival.js", lambda route: held.append(route))
    with restyles(page) as styled:
        with page.expect_request("**/arrival.js"):
            page.goto(server + link, wait_until="commit")
            page.wait_for_function("window.first")
        for route in held:
            route.continue_()
        page.locator(".st-key-curve .scatterlayer path").first.wait_for(state="attached")
        page.locator(".st-key-six_steps details").last.wait_for(state="attached")
    # Plotly's measurements of words do not restyle the whole page.
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
    page.context.close()
    assert len(heights) > 5
    assert max(heights) - min(heights) < 2


# ---- the screen reader's tree


def test_events_are_announced_once_and_the_assumptions_about_the_host_pages_are_true(visit):
    page = visit("motion?mu=1.5&figure=forces")
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
    page.locator("[data-testid=stExpandSidebarButton]").click()
    page.locator(".st-key-more_controls summary").first.click()
    page.get_by_text("Light rollers", exact=True).click()
    check_announced("one full turn in")
    page.locator(".st-key-mu input[type=range]").focus()
    page.keyboard.press("Home")
    check_announced("would slip")
    assert region.count() == 1
    with_sidebar = page.evaluate(HELD)
    check_assumptions(visit("", width=390, height=844, within=page), with_sidebar)


_SELECTORS = ", ".join(map(module, ("streamlit_dom", "sliders", "plotly")))
HELD = f"Promise.all([{_SELECTORS}]).then({script('assumptions')})"


def check_assumptions(page, elsewhere):
    """Check the app's assumptions about Streamlit's page, on this or on another page."""
    page.locator(".st-key-six_steps summary").nth(3).click()
    for awaited in (".katex-display .base", ".js-plotly-plot .nsewdrag"):
        page.wait_for_selector(awaited, state="attached")
    settle(page)
    holds = page.evaluate(HELD)
    assert len(holds) > 10
    assert [name for name, held in holds.items() if not (held or (held is None and elsewhere[name]))] == []
    # Negative control: a missing slider satisfies no assumption, and the server's value is shown.
    moved = f"""async () => {{
      const {{ sliders }} = await {module("sliders")}, find = sliders.find;
      sliders.find = () => null;
      const held = await {HELD}, shows = sliders.shows("m", 1);
      sliders.find = find;
      return [shows, ...Object.values(held).slice(0, 2)];
    }}"""
    assert page.evaluate(moved) == [True, False, True]
    # Streamlit draws a slider moved by the page, and sends nothing.
    sent = len(traffic(page).sent)
    page.evaluate(f"{module('sliders')}.then(({{ sliders }}) => sliders.move('compression', 5))")
    expect(page.locator(".st-key-compression [data-testid=stSliderThumbValue]")).to_have_text("5.0")
    settle(page)
    assert len(traffic(page).sent) == sent


@pytest.mark.parametrize(("width", "height"), [(1280, 720), (390, 844)])
def test_a_sketch_reserves_the_places_of_the_page_before_its_text(chromium, server, width, height):
    """Heading, text and picture have their places although the server does not answer."""
    page = new_context(chromium, viewport={"width": width, "height": height}, bypass_csp=True).new_page()
    page.route_web_socket(re.compile("_stcore"), lambda _silent: None)
    page.goto(server)
    page.wait_for_selector("[data-testid=stApp]", state="attached")
    page.add_style_tag(content=":root { --patience: 3600s; }")  # for a slow machine
    next_frame(page)
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    paper = picture.getpixel((20, height - 20))
    for y in (80, 140, 300):
        assert picture.getpixel((50, y)) != paper, y
    page.context.close()


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


def check_saved_stage(page: Page, folder: Path) -> None:
    """Check that the saved picture of the stage is in the light theme, and that every body is painted."""
    with page.expect_download() as download:
        page.get_by_role("button", name="Save picture", exact=True).click()
    file = folder / "ramanujan-machine.png"
    assert download.value.suggested_filename == file.name
    download.value.save_as(file)
    image = np.asarray(Image.open(file).convert("RGB"), dtype=int)
    assert image.shape[:2] == (1200, 2400)
    assert tuple(image[0, 0]) == rgb(THEME["light"]["backgroundColor"])
    for body, colour in BODY_COLORS.items():
        edge = np.array(rgb(THEME["light"][f"{colour}TextColor"]))
        assert (np.abs(image - edge).sum(axis=2) < 6).sum() > 500, body


def check_saved_curve(page: Page, folder: Path) -> None:
    """Check the file of a figure, which Plotly saves itself."""
    file = folder / "ramanujan-curve.png"
    page.locator(".st-key-curve .js-plotly-plot").hover()
    with page.expect_download() as download:
        page.locator(".st-key-curve .modebar-btn").click()
    assert download.value.suggested_filename == file.name
    download.value.save_as(file)
    with Image.open(file) as saved:
        assert saved.width > 2000
        assert saved.convert("RGBA").getpixel((0, 0)) == (*ImageColor.getrgb(THEME["dark"]["backgroundColor"]), 255)


def test_the_stage_is_operated_by_keys_and_saved(visit, tmp_path):
    page = visit(theme="dark")
    check_stage_without_data(page)
    check_keys(page)
    page.get_by_role("button", name="Steps, speed, view").click()
    page.get_by_role("button", name="Step forward").click()
    page.get_by_role("checkbox", name="Friction").check()
    next_frame(page)
    check_saved_stage(page, tmp_path)
    check_saved_curve(page, tmp_path)


def test_a_page_whose_end_does_not_arrive_is_shown_without_it(visit):
    page = visit(ADDRESSES["worksheet"])
    title = page.locator("h1").first
    assert title.is_visible()
    page.evaluate("document.querySelector('.st-key-bar').remove()")
    assert page.locator("main :is(h1, p, label)").filter(visible=True).count() == 0
    title.wait_for()
