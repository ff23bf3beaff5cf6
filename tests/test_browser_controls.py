"""Sliders, boxes and presets under a hand; what a slow network does to them is in test_browser_lost."""

from playwright.sync_api import expect

from tests.browser import settle, thumb


def box(page, key: str):
    return page.locator(f".st-key-{key}_exact input")


def slider(page, key: str):
    return page.locator(f".st-key-{key} input[type=range]")


def test_the_box_follows_the_thumb_without_the_server(visit):
    page = visit()
    x, y = thumb(page, "m")
    sent = len(page.frames_sent)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=5)
    expect(box(page, "m")).to_have_value(slider(page, "m").input_value())
    assert float(box(page, "m").input_value()) > 1.5
    assert len(page.frames_sent) == sent
    page.mouse.move(x, y, steps=5)
    page.mouse.up()
    settle(page)
    assert float(box(page, "m").input_value()) == 1.0


def test_a_bad_entry_is_answered_at_its_box(visit):
    page = visit("?k=20")
    box(page, "k").fill("1e9")
    box(page, "k").press("Enter")
    sentence = page.get_by_text("k must be between 1 and 200 N/m. The old value, 20 N/m, was kept.")
    sentence.wait_for()
    at, entry = sentence.bounding_box(), box(page, "k").bounding_box()
    assert 0 <= at["y"] - entry["y"] - entry["height"] < 40
    assert at["y"] + at["height"] <= 720
    expect(box(page, "k")).to_have_value("20.0")


def test_a_second_click_on_the_same_mark_is_heard(visit):
    page = visit(height=1300)
    mark = page.locator(".st-key-curve .scatterlayer .trace").last.locator(".point")
    mark.wait_for(state="attached")
    for other in ("2", "3"):
        page.wait_for_timeout(400)  # Plotly draws anew after an answer
        place = mark.bounding_box()
        page.mouse.move(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
        page.mouse.click(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
        expect(box(page, "m_prime")).to_have_value("1.1272568270162107")
        settle(page)
        box(page, "m_prime").fill(other)
        box(page, "m_prime").press("Enter")
        page.wait_for_url(f"**m_prime={other}**")
        settle(page)


def test_the_sidebar_fits_the_screen_and_is_open_only_where_it_matters(visit):
    page = visit("motion")
    controls = page.locator(".st-key-controls")
    expect(controls).to_be_in_viewport(ratio=1)
    assert controls.bounding_box()["y"] < 25
    page.get_by_role("link", name="Worksheet", exact=True).first.click()
    settle(page)
    expect(controls).not_to_be_in_viewport()
    # Who unfolds it has it as long as the page is open.
    page.locator("[data-testid=stExpandSidebarButton]").click()
    page.get_by_role("button", name="New sheet with its key").click()
    settle(page)
    expect(controls).to_be_in_viewport()
