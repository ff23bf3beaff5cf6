"""Page 4 in a browser: text alternatives of figures, a click that builds a machine, the layout on a phone."""

import re

from playwright.sync_api import expect

from tests.checks.browser import settle, traffic


def shown(page: object) -> object:
    return page.locator(".st-key-stage_bodies [data-read=normalized]")


def test_figures_have_text_alternatives_and_a_click_builds_a_machine(visit: object) -> None:
    page = visit("1729")
    page.wait_for_selector(".st-key-machines .js-plotly-plot")
    settle(page)
    labels = page.evaluate("[...document.querySelectorAll('.stPlotlyChart')].map(e => e.getAttribute('aria-label'))")
    assert len(labels) == 3
    assert all(label and any(map(str.isdigit, label)) for label in labels)
    assert page.locator(".st-key-cubes svg").count() == 2
    # The number of the equation ends the captions of both stacks, on the same background.
    assert page.locator(".st-key-cubes figcaption b").all_inner_texts() == ["1729"] * 2
    ends = page.locator(".st-key-in_step").locator(".colorbox, figcaption b").all()
    assert len({end.evaluate("(node) => getComputedStyle(node).backgroundColor") for end in ends}) == 1
    assert len(ends) == 3
    # A click on a machine builds it; test_scene_taxicab checks that its ratio brings it into step.
    expect(shown(page)).to_have_text(re.compile(r"1\.05"))
    number = page.locator(".st-key-machines text", has_text="5896").first
    number.scroll_into_view_if_needed()
    box = number.bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.wait_for_url("**top=sphere**")
    settle(page)
    assert "right=shell" in page.url
    assert page.get_by_text("hoop and shell; on top: sphere", exact=False).count() == 1
    # The picture's text alternative names its bodies, and the slab is a slider.
    stage = page.locator(".st-key-stage_bodies")
    named = stage.locator("svg.machine [role=img]").get_attribute("aria-label")
    assert "a hoop on the left and a spherical shell on the right" in named
    assert "a sphere rolls freely" in named
    assert stage.locator("[role=img] [role=slider]").count() == 0
    assert stage.get_by_role("slider", name="Slab: compression x₀").get_attribute("aria-valuetext") == "8.00\u202fcm"
    # The choice of bodies brings the machine into step.
    expect(shown(page)).to_have_text("1.000000")
    assert max(traffic(page).received) < 200_000
