"""Bytes and durations of visits over a classroom's Wi-Fi.

    python -m tests.benchmarks.visit [--megabits 20] [--delay 40] [--processes 0]
    python -m tests.benchmarks.visit --clients 60

First visit: bytes, and seconds until the first picture, with and without compression. --megabits limits the bandwidth
[Mbit/s], and --delay adds a latency to each request [ms]. "plain" is a browser that does not accept compression.

Later visit, with all scripts in the browser's cache: seconds until the machine moves, compared with a bare page with
two sliders. The measurement is repeated with a processor of a quarter of the speed.

With --clients, this number of clients requests the twelve largest scripts from a new server at once, and then again.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

import streamlit
from playwright.sync_api import Browser, BrowserContext, sync_playwright

from tests.benchmarks.classroom import processor_time
from tests.browser import CHROMIUM, FLAGS, ROOT, get, running
from tests.deployed import deployed

DRAWN = """[...document.querySelectorAll('[data-testid=stBidiComponentIsolated]')].some(
  (component) => component.shadowRoot?.querySelector('svg .slab[transform]'))"""

BARE = "import streamlit as st\nfor name in 'ab': st.slider(name, 0.5, 5.0, 1.0, 0.01)\n"
SLIDERS = "document.querySelectorAll('input[type=range]').length === 2"
VISITS = 5

CURVE = ".js-plotly-plot .scatterlayer path"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--megabits", type=float, default=20)
    parser.add_argument("--delay", type=float, default=40, help="milliseconds (default: 40)")
    parser.add_argument("--processes", type=int, default=0, help="1 or 2: behind HAProxy, by the recipe")
    parser.add_argument("--clients", type=int, default=0, help="so many ask a fresh server at once")
    given = parser.parse_args()
    if given.clients:
        at_once(given.clients)
        return
    plain = {"Accept-Encoding": "identity"}
    with deployed(given.processes) if given.processes else running(ROOT / "app.py") as started:
        address = started.address if given.processes else started
        visits = [("plain", address, plain), ("compressed", address, {"Accept-Encoding": "gzip"})]
        if given.processes:
            visits.append(("over HTTPS", started.secure, {}))
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            for _, address, headers in visits:
                visit(browser, address, headers, 1e9, 0)  # warm up the server
            print(f"{'':<14}{'bytes':>12}{'requests':>10}{'first picture':>15}{'curve':>10}")
            for name, address, headers in visits:
                size, requests, picture, curve = visit(browser, address, headers, given.megabits * 1e6 / 8, given.delay)
                print(f"{name:<14}{size:>12}{requests:>10}{picture:>13.2f} s{curve:>8.2f} s")
            later_visits(browser, visits[1][1])
            browser.close()


def at_once(clients: int) -> None:
    """Print how long clients wait for the twelve largest scripts, and the processor time of the server."""
    folder = Path(streamlit.__file__).parent / "static"
    scripts = sorted(folder.glob("static/js/*.js"), key=lambda path: path.stat().st_size)[-12:]
    for coding in ("gzip", "br"):
        server = running(ROOT / "app.py")
        with server as address, ThreadPoolExecutor(clients) as pool:
            wanted = [f"{address}/{script.relative_to(folder).as_posix()}" for script in scripts] * clients
            for words in ("fresh server", "once more"):
                work, start = processor_time([server.process.pid]), perf_counter()
                size = sum(pool.map(lambda script: len(get(script, Accept_Encoding=coding)[1]), wanted))  # noqa: B023
                work, seconds = processor_time([server.process.pid]) - work, perf_counter() - start
                print(f"{coding:<6}{words:<14}{size:>12} bytes{seconds:>8.2f} s, server’s processor {work:.2f} s")


def later_visits(browser: Browser, address: str) -> None:
    """Print the seconds until the machine moves, and until a bare page is complete, with cached scripts."""
    with TemporaryDirectory() as folder:
        (script := Path(folder) / "bare.py").write_text(BARE)
        with running(script) as bare:
            pages = {"machine": (address, DRAWN), "bare page": (bare, SLIDERS)}
            profiles = {
                name: browser.new_context(viewport={"width": 1280, "height": 720}, bypass_csp=True) for name in pages
            }
            for slower in (1, 1, 4):  # the first round fills the browser's cache
                seconds = {name: [] for name in pages}
                for _ in range(VISITS):
                    for name, (place, drawn) in pages.items():
                        seconds[name].append(later_visit(profiles[name], place, drawn, slower))
                machine, sliders = (median(seconds[name]) for name in pages)
                print(
                    f"later, processor 1/{slower}: {machine:.2f} s, bare {sliders:.2f} s, {machine / sliders:.2f} times"
                )


def later_visit(profile: BrowserContext, address: str, drawn: str, slower: int) -> float:
    """Return the seconds until `drawn` is true, measured by the browser."""
    page = profile.new_page()
    profile.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slower})
    page.add_init_script(
        f"const look = () => ({drawn}) ? (window.at = performance.now()) : requestAnimationFrame(look); look();"
    )
    page.goto(address, wait_until="commit")
    page.wait_for_function("window.at", timeout=120_000)
    at = page.evaluate("at")
    page.close()
    return at / 1000


def visit(
    browser: Browser, address: str, headers: dict[str, str], throughput: float, delay: float
) -> tuple[int, int, float, float]:
    """Visit the first page with an empty cache; return bytes, requests, and seconds until stage and curve exist."""
    page = browser.new_context(
        viewport={"width": 1280, "height": 720}, extra_http_headers=headers, ignore_https_errors=True, bypass_csp=True
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
    # The bytes of a data URL are already part of its page.
    fetched = [sizes.get(request, 0) for request, url in loaded.items() if not url.startswith("data:")]
    return sum(fetched), len(fetched), picture, curve


if __name__ == "__main__":
    main()
