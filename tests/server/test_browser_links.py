"""A link modified by people and programs, and texts copied from a page."""

import pytest


def test_a_link_opens_its_page(visit, server):
    app = visit("derivation?utm_source=mail&m_prime=9/8).&layers=arrows)&route=newton,&fbclid=abc", figures=False)
    app.wait_for_url(f"{server}/derivation?layers=arrows&route=newton&m_prime=1.125", wait_until="commit")
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
