"""The messages between server and page, without a browser: their size and their cache."""

import asyncio
import random
from concurrent.futures import ThreadPoolExecutor

import pytest

from ramanujan.pages.motion.cache import VIEWS
from ramanujan.shell import menu
from tests.benchmarks.visitor import Visitor

PAGES = tuple(page.path for page in menu.PAGES.values())


@pytest.mark.parametrize("page", [*PAGES, *(f"motion?figure={figure}" for figure in VIEWS)])
def test_a_page_caches_no_message_that_changes_and_drops_no_message_in_use(server: str, page: str) -> None:
    """The server sends only the hash of a cached message, which fails if the page has dropped the message.

    After any move of a slider, the motion page receives at most 60 kB, even for a complete redraw.
    """

    async def visit() -> None:
        visitor, chance = Visitor(server, page), random.Random(1729)
        await visitor.open()
        await visitor.move("m", chance)
        cached = set(visitor.cache)
        for key in ("m", "m_prime", "k", "compression", *(("glide", "spin", "mu") if "figure" in page else ())):
            before = visitor.received
            await visitor.move(key, chance)
            assert "figure" not in page or 0 < visitor.received - before <= 60_000, key
        assert set(visitor.cache) == cached
        assert visitor.max_age > 10**9
        await visitor.close()

    # In another thread, because the browser of other tests has an event loop in this one.
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, visit()).result()
