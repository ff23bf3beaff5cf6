"""Sliders, boxes and presets under a hand; what a slow network does to them is in test_browser_lost."""

import pytest
from playwright.sync_api import expect

from ramanujan import Oscillator
from tests.browser import inside, next_frame, settle, thumb


def box(page, key: str):
    return page.locator(f".st-key-{key}_exact input")


def slider(page, key: str):
    return page.locator(f".st-key-{key} input[type=range]")


def normalized(page) -> float:
    return float(inside(page, "root.querySelector('[data-read=normalized]').textContent"))


def test_a_slider_dragged_away_and_back_to_its_start_ends_where_it_began(visit):
    page = visit("?hide=curve,steps")
    before = normalized(page)
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 80, y, steps=8)
    next_frame(page)
    assert normalized(page) < before - 0.1
    page.mouse.move(x, y, steps=8)
    next_frame(page)
    assert normalized(page) == before
    page.mouse.up()
    settle(page)
    assert normalized(page) == before
    # Where the start is off the slider's steps, it is not rounded as long as no hand is on that slider.
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    page.locator(".st-key-k input[type=range]").press("ArrowRight")
    settle(page)
    assert normalized(page) == 1
    assert page.locator(".st-key-m_prime input[type=range]").input_value() == "1.13"
    assert "m_prime=1.1272568270162107" in page.url
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=6)
    page.mouse.move(x, y, steps=6)
    next_frame(page)
    # Away and back, the thumb is on a step of its own: that is what is drawn, and what letting go sends.
    stepped = Oscillator(m_prime=1.13).normalized_frequency_squared
    box = page.locator(".st-key-m_prime_exact input")
    for let_go in (lambda: None, page.mouse.up):
        let_go()
        assert normalized(page) == pytest.approx(stepped, abs=1e-6)
        assert box.input_value() == "1.13"
        settle(page)
    assert "m_prime=1.13" in page.url
    assert page.evaluate("ramanujan.last('machine/oscillator').parameters")["m_prime"] == 1.13
    page.get_by_text("In step (1729)", exact=True).click()
    settle(page)
    assert normalized(page) == 1


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
