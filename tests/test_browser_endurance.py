"""A page that is open for a whole lesson: neither its memory nor its listeners grow.

With RAMANUJAN_DEEP, the stage runs for an hour of its clock, and the tab makes fifty rounds through all pages.
"""

import itertools
from collections import Counter
from collections.abc import Callable

import pytest

from ramanujan import Oscillator
from tests.checks.browser import clock_rate, next_frame, settle
from tests.checks.look import switch
from tests.checks.picture import Picture
from tests.settings import DEEP

MINUTES = 60 if DEEP else 0.3
ROUNDS = 50 if DEEP else 1
PLACES = (*range(1, 5), 0) if ROUNDS > 1 else (2, 0)
"""The tested pages: all pages with a stage, or the two with marks in their figures."""
KEYS = ("ArrowRight", "ArrowLeft")
LINKS = "document.querySelectorAll('[data-testid=stTopNavLink]')"
CURSORS = """[...document.querySelectorAll('.js-plotly-plot')].reduce((sum, {layout, data}) =>
  sum + (layout.meta.cursor === 'orbit' ? data.length : 1), 0)"""
"""Expected number of marks of the time cursor in the figures of the page."""
TOPICS = ("machine", "time", "drawn", "seek", "story", "view")
"""The topics of a stage."""


def performance_client(tab: object) -> object:
    """Return the client of the browser's debugging protocol for `counts`."""
    client = tab.context.new_cdp_session(tab)
    client.send("Performance.enable")
    return client


def counts(tab: object, client: object) -> dict[str, float]:
    """Return the page's memory, listeners and nodes after a garbage collection."""
    for _ in range(2):
        client.send("HeapProfiler.collectGarbage")
        tab.wait_for_timeout(300)
    metrics = {metric["name"]: metric["value"] for metric in client.send("Performance.getMetrics")["metrics"]}
    return {name: metrics[name] for name in ("JSHeapUsedSize", "JSEventListeners", "Nodes")}


def test_theme_and_page_changes_leave_nothing_behind(visit: Callable) -> None:
    tab = visit()
    client = performance_client(tab)

    def topics_with_value(stage: str) -> set[str]:
        """Return the topics of a stage with a value on the bus."""
        return {topic for topic in TOPICS if tab.evaluate(f"ramanujan.last('{topic}/{stage}') !== undefined")}

    def count_listeners() -> Counter:
        """Return the number of listeners of each topic."""
        bus = client.send("Runtime.evaluate", {"expression": "globalThis.ramanujan"})["result"]["objectId"]
        listeners = client.send("DOMDebugger.getEventListeners", {"objectId": bus})["listeners"]
        return Counter(each["type"] for each in listeners)

    themes = itertools.cycle(("dark", "light"))

    def go_round() -> Counter:
        for place in PLACES:
            tab.evaluate(f"{LINKS}[{place}].click()")
            settle(tab)
            if place == 0:
                tab.wait_for_selector(".present-machine", state="attached")
                assert tab.locator(".present-machine").count() == 2
            if place == 2:
                tab.wait_for_selector(".time-cursor", state="attached")
                assert topics_with_value("oscillator") == set()
                switch(tab, next(themes))
                settle(tab)
                assert tab.locator(".time-cursor").count() == tab.evaluate(CURSORS)
        assert topics_with_value("motion") == set()
        return count_listeners()

    # The first round loads the modules of each page.
    first = go_round()
    before = counts(tab, client)
    for _ in range(ROUNDS):
        assert go_round() == first
    after = counts(tab, client)
    # Streamlit and Plotly keep a few listeners and nodes of every page.
    assert after["JSEventListeners"] <= 1.1 * before["JSEventListeners"] + 50, (before, after)
    assert after["Nodes"] <= 1.2 * before["Nodes"] + 500, (before, after)
    assert after["JSHeapUsedSize"] <= before["JSHeapUsedSize"] + 2**20 * (5 + ROUNDS / 2), (before, after)


@pytest.mark.parametrize("engine", ["chromium"])
def test_a_running_stage_and_a_hundred_changes_leave_nothing_behind(bare: Callable) -> None:
    here = bare()
    here.sliders(m=1, m_prime=1, k=10, compression=8, radius=10)
    picture, tab = Picture(here), here.page
    tab.evaluate(clock_rate(60))
    tab.evaluate("setReducedMotion(false)")
    client = performance_client(tab)

    def change(times: int, key: str) -> None:
        """Change the machine by keys, and once by a message from the server."""
        tab.evaluate("document.querySelector('.st-key-k input').focus()")
        for _ in range(times):
            tab.keyboard.press(key)
            next_frame(tab)
        picture.show(Oscillator(k=float(tab.evaluate("document.activeElement.value"))), 0.08)

    tab.evaluate("(window.drawn = 0), bus.subscribe('drawn/oscillator', () => (window.drawn += 1))")
    for key in KEYS:
        change(10, key)
    before, drawn = counts(tab, client), tab.evaluate("drawn")
    tab.wait_for_timeout(1000 * MINUTES)
    for key in KEYS * 2:
        change(25, key)
    after, drawn = counts(tab, client), tab.evaluate("drawn") - drawn
    assert drawn >= 100
    # A listener or a node for each change would be 100 and more.
    assert after["JSEventListeners"] < before["JSEventListeners"] + 50, (before, after)
    assert after["Nodes"] < before["Nodes"] + 80, (before, after)
    assert after["JSHeapUsedSize"] < before["JSHeapUsedSize"] + 4e6, (before, after)
