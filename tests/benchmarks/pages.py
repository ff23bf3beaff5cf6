"""What a change of a slider sends on every page, and how long other visitors wait while one has the server measure.

    python -m tests.benchmarks.pages [--seconds 8]

The wait is that of a request to the server's health address, which the same process answers as all pages; what it takes
on an idle server, most of it the connection's own delay, is printed beside it.
"""

import argparse
import statistics
from http.client import HTTPConnection
from time import monotonic, perf_counter, sleep

from playwright.sync_api import Page, sync_playwright

from ramanujan.shell import navigation
from tests.browser import CHROMIUM, FLAGS, ROOT, count_anew, listen, running, settle

PAGES = {page.name: page.address for page in navigation.PAGES.values()} | {"motion, energy": "motion?figure=energy"}
CHANGES = 5


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seconds", type=float, default=8, help="how long to watch the waits (default: 8)")
    seconds = parser.parse_args().seconds
    with running(ROOT / "app.py") as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        page = browser.new_page()
        page.emulate_media(reduced_motion="reduce")
        listen(page)
        print("bytes per change, median")
        for name, link in PAGES.items():
            open_page(page, f"{address}/{link}")
            print(f"{name:<24}{statistics.median(bytes_of_a_change(page) for _ in range(CHANGES)):>10.0f}")

        open_page(page, f"{address}/speed?periods=300&steps=8")
        print(f"\n{'another visitor waits':<24}{'p50':>10}{'p99':>10}{'longest':>10}")
        report("server idle", waits(address, seconds))
        page.get_by_role("button", name="Measure").click()
        page.get_by_text("Measuring 300 periods").wait_for()
        report("while one measures", waits(address, seconds))
        browser.close()


def open_page(page: Page, address: str) -> None:
    """Open a page and wait until it has done what it does by itself."""
    count_anew(page)
    page.goto(address)
    page.wait_for_selector("[data-testid=stMainBlockContainer]")
    rest(page)


def rest(page: Page) -> None:
    """Wait until the page has run itself again as often as it wants to."""
    seen = -1
    while seen != len(page.frames_received):
        seen = len(page.frames_received)
        page.wait_for_timeout(1500)
        settle(page)


def bytes_of_a_change(page: Page) -> int:
    """Move m′ by one step and return what the server sent."""
    before = len(page.frames_received)
    page.locator(".st-key-m_prime input[type=range]").first.focus()
    page.keyboard.press("ArrowRight")
    rest(page)
    return sum(page.frames_received[before:])


def waits(address: str, seconds: float) -> list[float]:
    """Return how long each of many requests took [s]."""
    connection = HTTPConnection(address.removeprefix("http://"))
    times, end = [], monotonic() + seconds
    while monotonic() < end:
        start = perf_counter()
        connection.request("GET", "/_stcore/health")
        connection.getresponse().read()
        times.append(perf_counter() - start)
        sleep(0.02)
    return times


def report(what: str, times: list[float]) -> None:
    quantiles = statistics.quantiles(times, n=100)
    print(f"{what:<24}" + "".join(f"{1000 * value:>7.1f} ms" for value in (quantiles[49], quantiles[98], max(times))))


if __name__ == "__main__":
    main()
