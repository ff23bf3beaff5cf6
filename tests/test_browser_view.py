"""A lecturer's view in the browser: what is hidden is nowhere on the page, and a projector shows large words and no scroll."""

from __future__ import annotations

import re

import pytest

from ramanujan import Oscillator
from tests.browser import next_frame, settle

MACHINE = Oscillator(1.0, 2.0, 10.0)
LINK = "m=1&m_prime=2&k=10"
TELLTALE = {
    "Ω²m/k": f"{MACHINE.normalized_frequency_squared:.7f}"[:6],
    "Ω": f"{MACHINE.natural_frequency:.3f}",
    "period": f"{MACHINE.period:.2f}",
    "turns to part": f"{1 / abs(MACHINE.normalized_frequency_squared**0.5 - 1):.1f}",
    "slower": "slower",
}
DOCUMENT = """() => {
  const all = (root) => [...root.querySelectorAll('*')].flatMap((node) => [node, ...(node.shadowRoot ? all(node.shadowRoot) : [])]);
  const told = (node) => [...node.childNodes].filter((each) => each.nodeType === 3).map((each) => each.data);
  return all(document.body).filter((node) => !node.closest('script, style')).flatMap((node) =>
    [...told(node), ...[...node.attributes].filter((each) => each.name.startsWith('aria') || each.name === 'title').map((each) => each.value)]
  ).join('\\n');
}"""
"""All words of the page, those for the eye and those for a screen reader, also inside the components."""

SAID = "globalThis.ramanujan?.last('machine/oscillator') && ramanujan.last('say') === undefined"
"""The stage has drawn, and the live region has said what it had to say."""


def use(page) -> str:
    """Do what a reader may do to find out, and return all that the page says meanwhile."""
    page.wait_for_function(SAID)
    said = [page.evaluate(DOCUMENT)]
    for name in ("Step forward", "Step back"):
        if page.get_by_role("button", name=name, exact=True).count():
            page.get_by_role("button", name=name, exact=True).click()
            next_frame(page)
            said.append(page.evaluate(DOCUMENT))
    entry = page.locator(".st-key-m_exact input")
    entry.fill("1.000")
    entry.press("Enter")
    settle(page)
    page.wait_for_function(SAID)
    return "\n".join([*said, page.evaluate(DOCUMENT)])


def test_what_a_link_hides_is_nowhere_on_the_page(visit):
    page = visit(f"?{LINK}&hide=numbers,curve,clocks")
    said = use(page)
    assert "Velocities" in said
    assert not [name for name, words in TELLTALE.items() if words in said]
    assert page.locator(".js-plotly-plot").count() == 0
    parts = ".dial, .gauge, .verdict, .parting, .readouts, .legend b"
    assert page.locator(f".st-key-stage :is({parts})").count() == 0
    assert page.evaluate("ramanujan.last('present/oscillator').normalized") is None
    assert page.locator(".st-key-stage [data-step]:not([data-step=''])").count() == 0


def test_without_the_link_all_of_it_is_said(visit):
    """Negative control: the same search finds every word on the page that hides nothing."""
    said = use(visit(f"?{LINK}"))
    assert [name for name, words in TELLTALE.items() if words not in said] == []


@pytest.mark.parametrize("hide", ["motion", "motion,plain,numbers"])
def test_a_machine_whose_motion_is_hidden_stands_still(visit, hide):
    page = visit(f"?{LINK}&hide={hide}", motion="no-preference")
    where = "node => node.getAttribute('transform')"
    slab = page.locator(".st-key-stage .moving .body.slab")
    before = slab.evaluate(where)
    page.locator(".st-key-stage .stage").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(200)
    assert slab.evaluate(where) == before
    assert page.get_by_role("button", name="Pause", exact=True).count() == 0
    assert re.fullmatch(r"translate\(8 -?0\)|translate\(8,? ?-?0\)", before)
