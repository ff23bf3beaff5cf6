"""What the tests share: the app under AppTest, a running server, a Chromium.

Browser tests need a Chromium or Chrome on the system; without one they are skipped, unless RAMANUJAN_REQUIRE_BROWSER
is set, as it is in CI. Those of one file stay together in one worker, which starts one server and one browser for all.
"""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from streamlit.testing.v1 import AppTest

ROOT = Path(__file__).parent.parent
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]

STAGE = "document.querySelector('.st-key-stage [data-testid=stBidiComponentIsolated]').shadowRoot"
WATCH_LAG = f"""() => {{
  const input = document.querySelector('.st-key-m_prime input[type=range]');
  const readout = {STAGE}.querySelector('[data-read=normalized]');
  let value = input.value, shown = readout.textContent, since = null;
  window.lags = [];
  const watch = () => {{
    if (input.value !== value) {{
      value = input.value;
      since ??= 0;
    }}
    if (readout.textContent !== shown) {{
      shown = readout.textContent;
      if (since !== null) window.lags.push(since);
      since = null;
    }} else if (since !== null) since += 1;
    requestAnimationFrame(watch);
  }};
  requestAnimationFrame(watch);
}}"""
"""Counts, into window.lags, the animation frames from each move of the m′ slider to the stage's readout."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if "server" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.xdist_group(f"browser {item.path.stem}"))


@pytest.fixture
def app() -> AppTest:
    """The app before its first run."""
    return AppTest.from_file(str(ROOT / "app.py"), default_timeout=60)


@pytest.fixture(scope="session")
def server() -> Iterator[str]:
    """The address of the running app."""
    with running(ROOT / "app.py") as address:
        yield address


class running:  # noqa: N801 (reads as a sentence: with running(app) as address)
    """Run a Streamlit script on a free port for as long as the block lasts."""

    def __init__(self, script: Path) -> None:
        self.script = script

    def __enter__(self) -> str:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        command = [sys.executable, "-m", "streamlit", "run", str(self.script), "--server.headless", "true"]
        self.process = subprocess.Popen(
            [*command, "--server.address", "127.0.0.1", "--server.port", str(port)],
            cwd=ROOT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        address = f"http://127.0.0.1:{port}"
        for _ in range(240):
            try:
                urllib.request.urlopen(f"{address}/_stcore/health", timeout=1)
                return address
            except OSError:
                time.sleep(0.25)
        self.__exit__()
        raise RuntimeError("the app did not start")

    def __exit__(self, *_: object) -> None:
        self.process.terminate()
        self.process.wait()


@pytest.fixture(scope="session")
def chromium(server: str) -> Iterator[object]:
    """One headless browser."""
    if CHROMIUM is None:
        if os.environ.get("RAMANUJAN_REQUIRE_BROWSER"):
            pytest.fail("no Chromium or Chrome on this system, and RAMANUJAN_REQUIRE_BROWSER is set")
        pytest.skip("no Chromium or Chrome on this system (on Debian: apt-get install chromium)")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def profile(chromium: object) -> Iterator[object]:
    """One browser profile for all tests: Streamlit's scripts are loaded and compiled once, not for every page."""
    context = chromium.new_context()
    yield context
    context.close()


@pytest.fixture
def visit(profile: object, server: str) -> Iterator[Callable[..., object]]:
    """Open a page of the app: visit("?m=2", width=390, height=844, theme="dark"); it must end without an error.

    The stage stands still unless motion="no-preference" is asked for: to draw sixty frames a second without a graphics
    card takes a processor of its own.
    """
    pages, errors = [], []

    def open_page(
        address: str = "", *, width: int = 1280, height: int = 720, theme: str = "light", motion: str = "reduce"
    ) -> object:
        page = profile.new_page()
        pages.append(page)
        page.set_viewport_size({"width": width, "height": height})
        page.emulate_media(color_scheme=theme, reduced_motion=motion)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.frames_sent, page.frames_received = [], []

        def watch(socket_: object) -> None:
            socket_.on("framesent", lambda data: page.frames_sent.append(len(data)))
            socket_.on("framereceived", lambda data: page.frames_received.append(len(data)))

        page.on("websocket", watch)
        page.goto(f"{server}/{address}")
        page.wait_for_selector("[data-testid=stMainBlockContainer]")
        settle(page)
        return page

    yield open_page
    for page in pages:
        page.close()
    assert errors == []


def settle(page: object) -> None:
    """Wait until the app has answered: nothing running, nothing received for a quarter of a second."""
    page.wait_for_selector("[data-testid=stApp][data-test-script-state=notRunning]", timeout=60_000)
    seen = -1
    while seen != len(page.frames_received):
        seen = len(page.frames_received)
        page.wait_for_timeout(250)
