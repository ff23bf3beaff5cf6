"""A first visit over a classroom's Wi-Fi: bytes, and seconds to the first picture, with and without compression.

    python -m tests.benchmarks.visit [--megabits 20] [--delay 40] [--processes 0]

The browser is slowed down to so many megabits a second, and each request by so many milliseconds. "plain" is what
Streamlit sends by itself, as to a browser that takes no compressed answer.
"""

from __future__ import annotations

import argparse
from time import perf_counter

from playwright.sync_api import Browser, sync_playwright

from tests.browser import CHROMIUM, FLAGS, ROOT, running
from tests.deployed import deployed

DRAWN = """[...document.querySelectorAll('[data-testid=stBidiComponentIsolated]')].some(
  (component) => component.shadowRoot?.querySelector('svg .body'))"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--megabits", type=float, default=20)
    parser.add_argument("--delay", type=float, default=40, help="milliseconds (default: 40)")
    parser.add_argument("--processes", type=int, default=0, help="1 or 2: behind HAProxy, by the recipe")
    given = parser.parse_args()
    with deployed(given.processes) if given.processes else running(ROOT / "app.py") as started:
        address = started.address if given.processes else started
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            visit(browser, address, {}, 1e9, 0)  # the first visitor pays for the warm-up
            print(f"{'':<14}{'bytes':>12}{'requests':>10}{'first picture':>15}")
            for name, headers in (("plain", {"Accept-Encoding": "identity"}), ("compressed", {})):
                size, requests, seconds = visit(browser, address, headers, given.megabits * 1e6 / 8, given.delay)
                print(f"{name:<14}{size:>12}{requests:>10}{seconds:>13.2f} s")
            browser.close()


def visit(
    browser: Browser, address: str, headers: dict[str, str], throughput: float, delay: float
) -> tuple[int, int, float]:
    """Visit the first page as a newcomer; return bytes, requests, and seconds until the stage has drawn."""
    page = browser.new_context(viewport={"width": 1280, "height": 720}, extra_http_headers=headers).new_page()
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")
    limits = {"latency": delay, "downloadThroughput": throughput, "uploadThroughput": throughput}
    client.send("Network.emulateNetworkConditions", {"offline": False, **limits})
    sizes: list[int] = []
    client.on("Network.loadingFinished", lambda event: sizes.append(int(event["encodedDataLength"])))
    start = perf_counter()
    page.goto(address)
    page.wait_for_function(DRAWN, timeout=120_000)
    seconds = perf_counter() - start
    page.wait_for_timeout(3000)
    page.context.close()
    return sum(sizes), len(sizes), seconds


if __name__ == "__main__":
    main()
