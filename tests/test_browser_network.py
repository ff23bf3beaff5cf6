"""Slow, broken and restarted connections: whatever the network does, the app goes on and keeps what was set.

RAMANUJAN_CHANGES sets how many quick changes each page sees at each delay (500 for a thorough run).
"""

from __future__ import annotations

import asyncio
import os
import random
import re
from concurrent.futures import ThreadPoolExecutor

import pytest
from playwright.sync_api import expect

from ramanujan.pages.motion.cache import VIEWS
from ramanujan.shell import navigation
from tests.benchmarks.visitor import Visitor
from tests.browser import ROOT, listen, running, settle
from tests.slow_network import delayed, network
from tests.test_browser_access import OF_STREAMLIT

CHANGES = int(os.environ.get("RAMANUJAN_CHANGES", "2"))
DELAYS = (0.1,) if CHANGES < 100 else (0.0, 0.1, 0.6)
PAGES = tuple(page.address for page in navigation.PAGES.values())
LINKS = "document.querySelectorAll('[data-testid=stTopNavLink]')"


def ready(tab: object) -> None:
    tab.wait_for_selector("[data-testid=stMainBlockContainer] h1", timeout=60_000)
    settle(tab)


def open_tab(profile: object, address: str) -> object:
    tab = profile.new_page()
    tab.set_viewport_size({"width": 1280, "height": 720})
    tab.emulate_media(reduced_motion="reduce")
    listen(tab)
    tab.goto(address)
    ready(tab)
    return tab


def alive(tab: object) -> None:
    """Check that the app says nothing of a connection error and still answers."""
    assert tab.get_by_role("dialog").count() == 0, tab.get_by_role("dialog").first.inner_text()
    before = slider(tab).input_value()
    move(tab)
    assert slider(tab).input_value() != before


def slider(tab: object) -> object:
    return tab.locator(".st-key-m input[type=range]").first


def connected(tab: object) -> None:
    """Wait until the widgets can be moved again: until then Streamlit disables them."""
    tab.wait_for_timeout(1000)
    tab.wait_for_selector(".st-key-m input[type=range]:enabled", timeout=60_000)


def move(tab: object, key: str = "ArrowRight") -> None:
    slider(tab).focus()
    tab.keyboard.press(key)
    tab.wait_for_timeout(400)
    settle(tab)


@pytest.mark.parametrize("delay", DELAYS)
def test_quick_changes_over_a_slow_network_never_end_the_app(server: str, profile: object, delay: float) -> None:
    chance = random.Random(1729)
    with delayed(server, delay) as address:
        tab = open_tab(profile, address)
        for _ in range(CHANGES * len(PAGES)):
            tab.evaluate(f"{LINKS}[{chance.randrange(len(PAGES))}].click()")
            tab.wait_for_timeout(100)
        tab.evaluate(f"{LINKS}[0].click()")
        tab.wait_for_timeout(1000 * delay + 500)
        ready(tab)
        alive(tab)
        if CHANGES >= 100:
            for place in range(len(PAGES)):
                tab.evaluate(f"{LINKS}[{place}].click()")
                settle(tab)
                slider(tab).focus()
                for _ in range(CHANGES):
                    tab.keyboard.press(chance.choice(["ArrowRight", "ArrowLeft"]))
                    tab.wait_for_timeout(100)
                settle(tab)
                alive(tab)
        tab.close()


@pytest.mark.parametrize("page", [*PAGES, *(f"motion?figure={figure}" for figure in VIEWS)])
def test_a_page_keeps_no_message_that_changes_and_forgets_none(server: str, page: str) -> None:
    """The cause: what a page forgets between its question and the answer can no longer be answered by its name.

    Wherever a slider is moved to, the motion page's figures come in 60 kB, even where the whole page is drawn anew.
    """

    async def visit() -> None:
        visitor, chance = Visitor(server, page), random.Random(1729)
        await visitor.open()
        await visitor.move("m", chance)
        kept = set(visitor.cache)
        for key in ("m", "m_prime", "k", "compression", *(("glide", "spin", "mu") if "figure" in page else ())):
            before = visitor.received
            await visitor.move(key, chance)
            assert "figure" not in page or 0 < visitor.received - before <= 60_000, key
        assert set(visitor.cache) == kept
        assert visitor.max_age > 10**9
        await visitor.close()

    # In a thread of its own: the browser of the other tests keeps an event loop in this one.
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, visit()).result()


def test_the_network_goes_away_for_a_while(server: str, profile: object) -> None:
    with network(server) as way:
        tab = open_tab(profile, f"{way.address}/motion?m=2&mu=0.4")
        move(tab)
        address = tab.url
        assert "m=2.01" in address
        way.down()
        tab.wait_for_timeout(20_000 if CHANGES >= 100 else 3_000)
        with tab.expect_websocket(timeout=60_000):
            way.up()
        connected(tab)
        assert tab.url == address
        move(tab)
        assert tab.url == address.replace("2.01", "2.02")
        assert tab.locator(".st-key-mu input[type=range]").input_value() == "0.4"
        tab.close()


def test_a_restarted_server_finds_everything_again(profile: object) -> None:
    first = running(ROOT / "app.py")
    with first as address, network(address) as way:
        tab = open_tab(profile, f"{way.address}/derivation?m=2&step=3")
        move(tab)
        first.process.kill()
        first.process.wait()
        way.down()
        with running(ROOT / "app.py") as address:
            way.lead_to(address)
            with tab.expect_websocket(timeout=60_000):
                way.up()
            connected(tab)
            move(tab)
            assert "m=2.02" in tab.url
            assert "step=3" in tab.url
            assert tab.get_by_text("3.", exact=False).count()
            for page in PAGES if CHANGES >= 100 else PAGES[1:2]:
                tab.goto(f"{way.address}/{page}{'&' if '?' in page else '?'}m=2.5")
                ready(tab)
                tab.reload()
                ready(tab)
                assert slider(tab).input_value() == "2.5"
                assert "m=2.5" in tab.url
            tab.close()


def test_back_and_forward_through_pages(server: str, profile: object) -> None:
    tab = open_tab(profile, f"{server}/?m=2")
    titles = []
    for place in (1, 4, 0, 2):
        tab.evaluate(f"{LINKS}[{place}].click()")
        settle(tab)
        titles.append((tab.locator("h1").first.inner_text(), slider(tab).input_value()))
    assert {value for _, value in titles} == {"2"}
    for expected in reversed(titles[:-1]):
        tab.go_back()
        expect(tab.locator("h1").first).to_have_text(expected[0])
        expect(slider(tab)).to_have_value(expected[1])
        settle(tab)
    for expected in titles[1:]:
        tab.go_forward()
        expect(tab.locator("h1").first).to_have_text(expected[0])
        expect(slider(tab)).to_have_value(expected[1])
        settle(tab)
    tab.close()


def test_a_letter_that_the_app_s_fonts_lack_is_seen_to_bring_streamlits(visit):
    """Negative control of what test_browser_access says of every page: none asks for these."""
    page = visit("worksheet")
    with page.expect_request(lambda request: re.search(OF_STREAMLIT, request.url)):
        page.evaluate("document.querySelector('h1').append(' Ж')")
    page.goto("about:blank")
