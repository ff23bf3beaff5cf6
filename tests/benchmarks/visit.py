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

CURVE = ".js-plotly-plot .scatterlayer path"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--megabits", type=float, default=20)
    parser.add_argument("--delay", type=float, default=40, help="milliseconds (default: 40)")
    parser.add_argument("--processes", type=int, default=0, help="1 or 2: behind HAProxy, by the recipe")
    given = parser.parse_args()
    plain = {"Accept-Encoding": "identity"}
    with deployed(given.processes) if given.processes else running(ROOT / "app.py") as started:
        address = started.address if given.processes else started
        visits = [("plain", address, plain), ("compressed", address, {"Accept-Encoding": "gzip"})]
        if given.processes:
            visits.append(("over HTTPS", started.secure, {}))
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            for _, address, headers in visits:
                visit(browser, address, headers, 1e9, 0)  # the first visitor pays for the warm-up
            print(f"{'':<14}{'bytes':>12}{'requests':>10}{'first picture':>15}{'curve':>10}")
            for name, address, headers in visits:
                size, requests, picture, curve = visit(browser, address, headers, given.megabits * 1e6 / 8, given.delay)
                print(f"{name:<14}{size:>12}{requests:>10}{picture:>13.2f} s{curve:>8.2f} s")
            browser.close()


def visit(
    browser: Browser, address: str, headers: dict[str, str], throughput: float, delay: float
) -> tuple[int, int, float, float]:
    """Visit the first page as a newcomer; return bytes, requests, and seconds until stage and curve are drawn."""
    page = browser.new_context(
        viewport={"width": 1280, "height": 720}, extra_http_headers=headers, ignore_https_errors=True
    ).new_page()
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")
    limits = {"latency": delay, "downloadThroughput": throughput, "uploadThroughput": throughput}
    client.send("Network.emulateNetworkConditions", {"offline": False, **limits})
    loaded, sizes = {}, {}
    client.on("Network.responseReceived", lambda event: loaded.update({event["requestId"]: event["response"]["url"]}))
    client.on(
        "Network.loadingFinished", lambda event: sizes.update({event["requestId"]: int(event["encodedDataLength"])})
    )
    start = perf_counter()
    page.goto(address)
    page.wait_for_function(DRAWN, timeout=120_000)
    picture = perf_counter() - start
    page.wait_for_selector(CURVE, state="attached", timeout=120_000)
    curve = perf_counter() - start
    page.wait_for_timeout(3000)
    page.context.close()
    # A font that stands in the page itself has been counted with it.
    fetched = [sizes.get(request, 0) for request, url in loaded.items() if not url.startswith("data:")]
    return sum(fetched), len(fetched), picture, curve


if __name__ == "__main__":
    main()
