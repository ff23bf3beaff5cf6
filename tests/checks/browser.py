"""The app in a browser, for tests and benchmarks: start it, open it, and wait until it has answered."""

import contextlib
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from base64 import b64encode
from collections.abc import Iterator
from email.message import Message
from pathlib import Path
from urllib.parse import urlsplit
from weakref import WeakKeyDictionary

import playwright
import pytest
from playwright.sync_api import Error, Page, WebSocket
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg

from ramanujan.browser import modules
from tests.settings import PATIENCE

ROOT = Path(__file__).parents[2]
CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"))), None
)
"""The browser. The headless shell needs a quarter less processor time for the same visits."""
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]

STAGE = "document.querySelector('.st-key-stage [data-testid=stBidiComponentIsolated]').shadowRoot"
_FINISHED = {ForwardMsg.FINISHED_SUCCESSFULLY, ForwardMsg.FINISHED_FRAGMENT_RUN_SUCCESSFULLY}
_LAST_LINES = 60
"""Number of lines of the app's log in the report of a failing test."""
_QUIET = 350
"""Milliseconds without a message, measured by the page's timer, after which the page is complete.

A slider sends after 200 ms, and the steps of a lecture after 300 ms. The address changes after 150 ms.
"""


class running:  # noqa: N801 (reads as a sentence: with running(app) as address)
    """Run a Streamlit script on a free port during the block, with these variables in its environment."""

    def __init__(self, script: Path, **variables: str) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.address = f"http://127.0.0.1:{port}"
        command = [sys.executable, "-m", "streamlit", "run", str(script), "--server.headless", "true"]
        with log_file(self.address).open("w") as log:
            self.process = subprocess.Popen(
                [*command, "--server.address", "127.0.0.1", "--server.port", str(port)],
                cwd=ROOT,
                env=os.environ | variables,
                stdout=subprocess.DEVNULL,
                stderr=log,
            )

    def __enter__(self) -> str:
        try:
            return wait_for_start(self.address)
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_: object) -> None:
        stop(self.process)
        log_file(self.address).unlink(missing_ok=True)


def stop(process: subprocess.Popen) -> None:
    """End a process. Kill it if it does not end in time: a server may wait for its connections."""
    process.terminate()
    try:
        process.wait(PATIENCE / 4)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def log_file(address: str) -> Path:
    """Return the file with the errors and warnings of the app at an address."""
    return Path(tempfile.gettempdir()) / f"ramanujan-app-{urlsplit(address).port}.log"


def wait_for_start(address: str) -> str:
    """Wait until an app answers. Return its address."""
    for _ in range(240):
        with contextlib.suppress(OSError), urllib.request.urlopen(f"{address}/_stcore/health", timeout=1):
            return address
        time.sleep(0.25)
    raise RuntimeError("the app did not start")


def get(address: str, **headers: str) -> tuple[Message, bytes]:
    """Request a file with these headers. Return the headers and the content of the response."""
    names = {name.replace("_", "-"): value for name, value in headers.items()}
    with urllib.request.urlopen(urllib.request.Request(address, headers=names), timeout=PATIENCE) as response:
        return response.headers, response.read()


PAGES = pytest.StashKey[list[Page]]()
"""The pages that a test opened."""


def evidence(page: Page, name: str) -> str:
    """Save a screenshot of a page. Return its path, the page's address, the console's messages and the app's log."""
    folder = Path(tempfile.gettempdir()) / "ramanujan-failures"
    folder.mkdir(exist_ok=True)
    picture = folder / (re.sub(r"[^\w-]+", "_", name)[:100] + ".png")
    page.screenshot(path=picture, timeout=10_000)
    console = [f"console {message.type}: {message.text}" for message in page.console_messages()]
    log = log_file(page.url)
    lines = log.read_text(encoding="utf-8").splitlines()[-_LAST_LINES:] if log.exists() else []
    return "\n".join([f"screenshot: {picture}", f"address: {page.url}", *console, "log of the app:", *lines])


class Traffic:
    """The messages between a page and the app.

    Attributes
    ----------
    sent, received : sizes of the messages since the page was opened last [bytes]
    is_unanswered : whether the page waits for the end of a run
    late : delay of the network in each direction [s], which a test may set
    """

    def __init__(self, page: Page) -> None:
        self.late = 0.0
        self.begin()
        page.on("websocket", self._watch)

    def begin(self) -> None:
        """Reset the records before a page is opened."""
        self.sent: list[int] = []
        self.received: list[int] = []
        self.is_unanswered = True

    def _watch(self, websocket: WebSocket) -> None:
        websocket.on("framesent", self._count_sent)
        websocket.on("framereceived", self._count_received)

    def _count_sent(self, data: bytes) -> None:
        self.sent.append(len(data))
        self.is_unanswered |= BackMsg.FromString(data).HasField("rerun_script")

    def _count_received(self, data: bytes) -> None:
        self.received.append(len(data))
        message = ForwardMsg.FromString(data)
        if message.WhichOneof("type") == "script_finished" and message.script_finished in _FINISHED:
            self.is_unanswered = False


_TRAFFIC: WeakKeyDictionary[Page, Traffic] = WeakKeyDictionary()


def traffic(page: Page) -> Traffic:
    """Return the traffic of a page, recorded from the first call on."""
    if page not in _TRAFFIC:
        _TRAFFIC[page] = Traffic(page)
    return _TRAFFIC[page]


def open_address(page: Page, address: str, *scripts: str) -> None:
    """Open an address in a tab, run these scripts before the page's own, and wait until the page is complete."""
    messages = traffic(page)
    for script in scripts:
        page.add_init_script(script)
    messages.begin()
    page.goto(address)
    wait_for_page(page)


GO = """(address) => {
  history.pushState({}, "", `/${address}`);
  dispatchEvent(new PopStateEvent("popstate", { state: {} }));
  document.querySelector("[data-testid=stMain]").scrollTop = 0;
}"""
"""Opens an address as Back and Forward do: within the app, without loading it again. Scrolls to the top."""


def go(page: Page, address: str) -> None:
    """Open another address within the app, and wait until the page is complete. A load takes three times as long."""
    traffic(page).begin()
    page.evaluate(GO, address)
    wait_for_page(page)


def wait_for_page(page: Page) -> None:
    """Wait until a page is complete."""
    page.wait_for_selector("[data-testid=stMainBlockContainer]")
    settle(page)
    until(page, MOUNTED)
    settle(page)  # the second run of the first page (shell/first_run.py)


MOUNTED = """() => {
  const isMounted = ({ shadowRoot }) =>
    shadowRoot?.querySelector("style, section") && !shadowRoot.querySelector(".stage:not(.ready)");
  const isInvisible = (component) => component.closest("[class*=st-key-unseen]");
  const components = [...document.querySelectorAll("[data-testid=stBidiComponentIsolated]")];
  return components.every((component) => isMounted(component) || isInvisible(component));
}"""
"""Whether every visible component is mounted, and every stage has its machine."""

_WAIT = """async (ms) => {
  await new Promise((done) => setTimeout(done, ms));
  return Boolean(document.querySelector(".st-key-composition")) && !document.querySelector(".st-key-update_seen");
}"""
"""Wait, and return whether the first page's second run is still to come."""


def settle(page: Page, seconds: float = PATIENCE) -> None:
    """Wait until the app is idle: no rerun is unanswered, no script runs, and no message passes for some time.

    A timer in the page measures this time. On a slow computer it is as late as the timers of the page that send
    messages.
    """
    end = time.monotonic() + seconds
    messages = traffic(page)
    counts, waits = None, False
    while counts != (len(messages.sent), len(messages.received)) or messages.is_unanswered or waits:
        assert time.monotonic() < end, "the app did not answer"
        counts = (len(messages.sent), len(messages.received))
        if messages.is_unanswered:
            page.wait_for_timeout(20)
        else:
            # A page that is being closed has no timer. On a slow network several answers may be on their way.
            with contextlib.suppress(Error):
                waits = page.evaluate(_WAIT, _QUIET + 2500 * messages.late)
    page.wait_for_selector("[data-testid=stApp][data-test-script-state=notRunning]", timeout=1000 * seconds)


def until(page: Page, condition: str, given: object = None, seconds: float = PATIENCE) -> None:
    """Wait until a JavaScript function returns true, also on a page whose policy forbids `eval`."""
    end = time.monotonic() + seconds
    while not page.evaluate(condition, given):
        assert time.monotonic() < end, f"never true: {condition}"
        page.wait_for_timeout(100)


def clock_rate(rate: float) -> str:
    """Return JavaScript that makes the page's clock `rate` times as fast from now on."""
    return f"""() => {{
      const now = performance.now.bind(performance), request = requestAnimationFrame.bind(window), then = now();
      performance.now = () => then + {rate} * (now() - then);
      window.requestAnimationFrame = (draw) => request(() => draw(performance.now()));
    }}"""


def next_frame(page: Page) -> None:
    """Wait until the browser has drawn the last change, to the end of the next animation frame."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


@contextlib.contextmanager
def restyles(page: Page) -> Iterator[list[int]]:
    """Record how many elements each recalculation of styles covers, in Chromium. The list is complete at the end."""
    counts: list[int] = []
    browser = page.context.browser
    browser.start_tracing(page=page, categories=["devtools.timeline"])
    yield counts
    events = json.loads(browser.stop_tracing())["traceEvents"]
    counts += [each["args"].get("elementCount", 0) for each in events if each["name"] == "UpdateLayoutTree"]


def leave_out_figures(page: Page) -> None:
    """Remove the figures of a page, because loading Plotly takes more time than the rest of the page."""
    client = page.context.new_cdp_session(page)
    response = {
        "responseCode": 200,
        "responseHeaders": [{"name": "Content-Type", "value": "text/javascript"}],
        "body": b64encode(b"export default () => null").decode(),
    }

    def fulfill(event: dict) -> None:
        client.send("Fetch.fulfillRequest", {"requestId": event["requestId"]} | response)

    client.on("Fetch.requestPaused", fulfill)
    client.send("Fetch.enable", {"patterns": [{"urlPattern": "*/PlotlyChart.*.js"}]})


def inside(page: Page, expression: str) -> object:
    """Evaluate a JavaScript expression in which `root` is the stage's shadow tree."""
    return page.evaluate(f"(() => {{ const root = {STAGE}; return {expression}; }})()")


def drawn_deformation(page: Page) -> float:
    """Return the deformation of the spring as drawn [cm]."""
    place = "(name) => root.querySelector('.moving ' + name).transform.baseVal[0].matrix.e"
    slab, block = inside(page, f"['.slab', '.block'].map({place})")
    return slab - block


def press_preset(page: Page, name: str) -> None:
    """Press a preset, which may be in a closed expander."""
    page.locator(".st-key-preset button", has_text=name).dispatch_event("click")


def thumb(page: Page, key: str) -> tuple[float, float]:
    """Return the centre of a slider's thumb on the screen."""
    box = page.locator(f".st-key-{key} [style*=left]").first.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def script(name: str) -> str:
    """Return the JavaScript of a file in tests/checks/scripts, for a page to evaluate."""
    return (ROOT / "tests" / "checks" / "scripts" / f"{name}.js").read_text(encoding="utf-8").strip()


def module(name: str) -> str:
    """Return the JavaScript expression that imports a module of the app, such as stage/motion."""
    return f"import('/{modules.folder_url()}/{name}.js')"


NODE = Path(playwright.__file__).parent / "driver/node"
"""The JavaScript engine that Playwright contains."""
