"""Links modified by people and programs, and texts copied from a page."""

import string
from urllib.parse import parse_qsl, quote

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan.lesson.class_codes import ALPHABET, LETTERS, format_code
from ramanujan.shell.links import parameters_of, tidy
from ramanujan.shell.navigation import PAGES
from tests.test_addresses import OF_A_CLASS, valid_text

UNTRIED = OF_A_CLASS | {"slide", "frame"}
"""Excluded parameters: codes have another test; a slide and the seat in a frame can have any name."""
AROUND = st.text(".,;:!?)]}>”’\"' \u00a0", max_size=4)
CODES = st.text(ALPHABET, min_size=LETTERS, max_size=LETTERS)
SEPARATORS = ("", " ", "-", "+", "%C2%A0", "%20", ".")
TRACKING = "utm_source utm_campaign fbclid gclid dclid gbraid wbraid msclkid yclid ttclid twclid mc_cid mc_eid _ga _gl"


@pytest.mark.parametrize("name", PAGES)
@settings(deadline=None)
@given(end=AROUND)
def test_punctuation_after_a_link_is_not_part_of_its_value(name, end):
    page = PAGES[name]
    for parameter in parameters_of(page):
        if parameter.name in UNTRIED or parameter.name.endswith("paused"):
            continue
        text = valid_text(parameter)
        link = tidy(page.path, f"{parameter.name}={quote(text + end)}")
        [(_name, kept)] = parse_qsl(link.partition("?")[2]) if link else [(parameter.name, text + end)]
        assert parameter.read(kept) == parameter.read(text), parameter


@settings(deadline=None)
@given(code=CODES, separator=st.sampled_from(SEPARATORS), end=AROUND, lower=st.booleans())
def test_a_class_code_is_read_as_printed_on_the_wall(code, separator, end, lower):
    text = format_code(code).replace(" ", separator)
    link = tidy("lesson", f"class={text.lower() if lower else text}{quote(end)}") or f"lesson?class={text}"
    assert link.upper() == f"LESSON?CLASS={code}"


@settings(deadline=None)
@given(query=st.text(string.printable + "éε²“”\x00\ud800", max_size=40))
def test_a_valid_address_is_unchanged(query):
    for page in PAGES.values():
        text = query.encode("utf-8", "replace").decode("latin-1")
        link = tidy(page.path, text)
        assert link is None or tidy(*link.partition("?")[::2]) is None


def test_a_number_has_the_same_meaning_in_the_address_and_in_the_box():
    for text, value in {"9/8": 1.125, "9%2F8": 1.125, "1,050": 1.05, "9/7)": 9 / 7, "+3/4.": 0.75}.items():
        [(name, number)] = parse_qsl(tidy("", f"m_prime={text}").removeprefix("?"))
        assert (name, float(number)) == ("m_prime", value)
    assert tidy("", "m_prime=1.05&k=2e1") is None
    # The page rejects these.
    for text in ("9/0", "abc", "1/2/3", ""):
        assert tidy("", f"m_prime={text}") is None


def test_parameters_of_other_programs_are_dropped():
    for name in TRACKING.split():
        assert tidy("", f"{name}=x1&m=2") == "?m=2"
    # Negative control: an unknown setting is kept, so that the page can report it.
    assert tidy("", "colour=red") is None


def test_a_link_opens_its_page(visit, server):
    app = visit("Derivation).?utm_source=mail&m_prime=9/8).&route=newton,&fbclid=abc", figures=False)
    assert app.url == f"{server}/derivation?m_prime=1.125&route=newton"
    assert app.get_by_role("alert").count() == 0
    assert float(app.locator(".st-key-m_prime_exact input").input_value()) == 1.125
    assert app.locator("h1").text_content() == "Many ways to one frequency"


COPIED = """(node) => {
  getSelection().selectAllChildren(node);
  const event = new ClipboardEvent("copy", { clipboardData: new DataTransfer(), bubbles: true, cancelable: true });
  document.body.dispatchEvent(event);
  return ["text/plain", "text/html"].map((kind) => event.clipboardData.getData(kind));
}"""


@pytest.mark.parametrize("engine", ["chromium", "firefox"])
def test_a_copied_text_contains_each_formula_once(window, server, engine):
    page = window(name=engine)
    page.goto(f"{server}/derivation?show=reading")
    step = page.locator(".stMarkdown", has_text="Multiply the").first
    step.wait_for()
    text, html = step.evaluate(COPIED)
    assert "Multiply the X equation by 3/2" in text
    assert "katex" not in html
    [display] = page.locator(".katex-display", has_text="rolling without slipping").all()[:1]
    text, _html = display.evaluate(COPIED)
    assert text.startswith(r"$$\begin{aligned}{v_{\text{block}}} &= {- \dot{X}} &&\quad")
    assert text.count(r"{v_{\text{slab}}} &= {2\,R\,\dot{\varphi}}{ - \dot{X}}") == 1
    assert len(text.splitlines()) == 1
    # A selection that begins inside a formula contains all of it; without formulas the browser copies the text.
    assert display.locator(".mord").first.evaluate(COPIED)[0] == text
    assert page.locator("h1").evaluate(COPIED) == ["", ""]
    assert page.locator("body > div:last-child").evaluate("node => node.style.opacity") != "0"
