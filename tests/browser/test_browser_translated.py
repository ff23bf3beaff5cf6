"""A page translated by the browser: after a change it shows the same text as an untranslated page."""

import re

import pytest
from playwright.sync_api import Page, expect

from ramanujan import Oscillator, lesson
from tests.checks.browser import script, settle
from tests.checks.class_pages import RERUN_ON_DEMAND, VOTES, rerun

TRANSLATE = script("translate")
WORDS = """() => [...document.querySelectorAll("main, .stSidebar")].map((part) => part.innerText).join(" ")
  .toUpperCase().replace(/\\s+/g, " ")"""
TRANSLATED = "() => document.querySelectorAll('main font').length"
KEPT = (
    "() => [...document.querySelectorAll('.katex, .js-plotly-plot, code')].every((node) => !node.querySelector('font'))"
)


def set_number(page: Page, key: str, text: str) -> None:
    box = page.locator(f".st-key-{key}_exact input")
    box.fill(text)
    box.press("Enter")
    settle(page)


def test_your_machine_shows_the_numbers_of_the_core(visit):
    page = visit("", figures=False)
    page.evaluate(TRANSLATE)
    assert page.evaluate(TRANSLATED) > 5
    for m_prime in (1.05, 4.0, 0.3):
        set_number(page, "m_prime", str(m_prime))
        text = page.locator(".st-key-your_machine").inner_text()
        shown = [
            float(number) for number in re.findall(r"= ?(\d+\.?\d*)", text.replace("\u202f", " ").replace("\xa0", " "))
        ]
        machine = Oscillator(1.0, m_prime, 10.0)
        expected = [machine.mass_ratio, machine.normalized_frequency_squared, machine.natural_frequency]
        assert shown[:3] == pytest.approx(expected, rel=1e-4)
        assert "YOUR MACHINE" in text
        assert page.evaluate(KEPT)


def test_react_can_remove_translated_texts(visit):
    errors: list[str] = []
    page = visit("1729", figures=False)
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.evaluate(TRANSLATE)
    for choice in (0, 1):
        page.locator(".st-key-top").get_by_role("radio").nth(choice).click()
        settle(page)
    assert [error for error in errors if "NotFoundError" in error] == []


def test_a_translated_class_shows_the_present_question(visit):
    def screen(query: str, **options: object) -> Page:
        page = visit(f"lesson?{query}", RERUN_ON_DEMAND, **options)
        page.evaluate(TRANSLATE)
        return page

    desk = screen("")
    desk.locator(".st-key-class_door button").first.click()
    desk.locator(".st-key-class_open button").click()
    settle(desk)
    query = desk.locator("a[href*='wall=on']").get_attribute("href").partition("?")[2]
    wall = screen(query)
    phone = screen(query.replace("&wall=on", ""), width=390, height=844)
    stops = [stop for stop in lesson.STOPS if stop.is_in_short_lesson][:2]
    for stop in stops:
        for phase in range(4):
            desk.locator(".st-key-class_moves [data-testid=stBaseButton-primary]").click()
            settle(desk)
            for page in (phone, wall):
                rerun(page)
                settle(page)
                rerun(page)
                expect(page.locator("h1")).to_have_text(stop.heading.upper())
            if phase == 0:
                phone.locator(VOTES).nth(1).click()
                settle(phone)
            others = [other.heading.upper() for other in lesson.STOPS if other is not stop]
            for page in (phone, wall):
                words = page.evaluate(WORDS)
                assert [heading for heading in others if heading in words] == []
                if phase > 0:
                    assert "100 %" in words
