"""The app in a browser, for tests and benchmarks: start it, open it, and wait for its answers."""

import contextlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from base64 import b64encode
from email.message import Message
from pathlib import Path
from weakref import WeakKeyDictionary

import pytest
from playwright.sync_api import Error, Page, WebSocket
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg

from ramanujan.browser import modules

ROOT = Path(__file__).parent.parent
CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"))), None
)
"""The browser; the first, which can show no window, takes a quarter less of a processor for the same visits."""
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]

STAGE = "document.querySelector('.st-key-stage [data-testid=stBidiComponentIsolated]').shadowRoot"
_FINISHED = {ForwardMsg.FINISHED_SUCCESSFULLY, ForwardMsg.FINISHED_FRAGMENT_RUN_SUCCESSFULLY}
_QUIET = 350
"""Milliseconds of silence, by the page's own timer, after which it has drawn.

Before they send, a slider waits 200 and a turn of steps 300; what is kept in the address waits 150.
"""


class running:  # noqa: N801 (reads as a sentence: with running(app) as address)
    """Run a Streamlit script on a free port for as long as the block lasts."""

    def __init__(self, script: Path) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.address = f"http://127.0.0.1:{port}"
        command = [sys.executable, "-m", "streamlit", "run", str(script), "--server.headless", "true"]
        self.process = subprocess.Popen(
            [*command, "--server.address", "127.0.0.1", "--server.port", str(port)],
            cwd=ROOT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def __enter__(self) -> str:
        try:
            return started(self.address)
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_: object) -> None:
        self.process.terminate()
        self.process.wait()


def started(address: str) -> str:
    """Return the address of an app when it answers."""
    for _ in range(240):
        with contextlib.suppress(OSError), urllib.request.urlopen(f"{address}/_stcore/health", timeout=1):
            return address
        time.sleep(0.25)
    raise RuntimeError("the app did not start")


def get(address: str, **headers: str) -> tuple[Message, bytes]:
    """Ask for a file with some headers, and return those of the answer and its content."""
    names = {name.replace("_", "-"): value for name, value in headers.items()}
    with urllib.request.urlopen(urllib.request.Request(address, headers=names), timeout=60) as answer:
        return answer.headers, answer.read()


PAGES = pytest.StashKey[list[Page]]()
"""The pages that a test opened."""


def evidence(page: Page, name: str) -> str:
    """Save a screenshot of a page, and return its place, the address and the console's messages."""
    folder = Path(tempfile.gettempdir()) / "ramanujan-failures"
    folder.mkdir(exist_ok=True)
    picture = folder / (re.sub(r"[^\w-]+", "_", name)[:100] + ".png")
    page.screenshot(path=picture)
    console = [f"console {message.type}: {message.text}" for message in page.console_messages()]
    return "\n".join([f"screenshot: {picture}", f"address: {page.url}", *console])


class Traffic:
    """The messages between a page and the app.

    Attributes
    ----------
    sent, received : sizes of the messages since the page was opened last [bytes]
    is_unanswered : whether the page waits for the end of a run
    late : how long a message takes each way [s], where a test has made the network slow
    """

    def __init__(self, page: Page) -> None:
        self.late = 0.0
        self.begin()
        page.on("websocket", self._watch)

    def begin(self) -> None:
        """Begin anew, for a page that is about to be opened."""
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
    """Return the messages of a page; they are counted from the first call on."""
    if page not in _TRAFFIC:
        _TRAFFIC[page] = Traffic(page)
    return _TRAFFIC[page]


def open_address(page: Page, address: str, *scripts: str) -> None:
    """Open an address in a tab, with scripts that run before those of the page, and wait until all of it is there."""
    messages = traffic(page)
    for script in scripts:
        page.add_init_script(script)
    messages.begin()
    page.goto(address)
    page.wait_for_selector("[data-testid=stMainBlockContainer]")
    settle(page)
    until(page, MOUNTED)
    settle(page)  # the first page has asked for what follows its machine


MOUNTED = """() => {
  const isMounted = ({ shadowRoot }) =>
    shadowRoot?.querySelector("style, section") && !shadowRoot.querySelector(".stage:not(.ready)");
  const isInvisible = (component) => component.closest("[class*=_published], [class*=_pick], .st-key-keys");
  const components = [...document.querySelectorAll("[data-testid=stBidiComponentIsolated]")];
  return components.every((component) => isMounted(component) || isInvisible(component));
}"""
"""Whether every visible component is mounted, and every stage has its machine."""

_WAIT = """async (ms) => {
  await new Promise((done) => setTimeout(done, ms));
  return Boolean(document.querySelector(".st-key-composition")) && !document.querySelector(".st-key-update_seen");
}"""
"""Waits for so long, and tells whether the first page has still to ask for what follows its machine."""


def settle(page: Page, seconds: float = 60) -> None:
    """Wait until the app has answered: every question answered, nothing running, nothing sent or received for a while.

    The page's own timer says how long a while is. Where the machine is slow it is late with the rest of the page, and
    not before what waits for a shorter time.
    """
    end = time.monotonic() + seconds
    messages = traffic(page)
    seen, alone = None, False
    while seen != (len(messages.sent), len(messages.received)) or messages.is_unanswered or alone:
        assert time.monotonic() < end, "the app did not answer"
        seen = (len(messages.sent), len(messages.received))
        if messages.is_unanswered:
            page.wait_for_timeout(20)
        else:
            # A page that is being left has no timer any more.
            # Of several messages on a slow way the first answer must not pass for the last.
            with contextlib.suppress(Error):
                alone = page.evaluate(_WAIT, _QUIET + 2500 * messages.late)
    page.wait_for_selector("[data-testid=stApp][data-test-script-state=notRunning]", timeout=1000 * seconds)


def until(page: Page, condition: str, given: object = None, seconds: float = 60) -> None:
    """Wait until a JavaScript function returns what is true, also where the page's policy forbids to evaluate text."""
    end = time.monotonic() + seconds
    while not page.evaluate(condition, given):
        assert time.monotonic() < end, f"never true: {condition}"
        page.wait_for_timeout(100)


def next_frame(page: Page) -> None:
    """Wait until the browser has drawn what just happened: to the end of the next animation frame."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def leave_out_figures(page: Page) -> None:
    """Let the page draw nothing where its figures are: to load Plotly takes more of a processor than all the rest."""
    client = page.context.new_cdp_session(page)
    answer = {
        "responseCode": 200,
        "responseHeaders": [{"name": "Content-Type", "value": "text/javascript"}],
        "body": b64encode(b"export default () => null").decode(),
    }

    def fulfill(event: dict) -> None:
        client.send("Fetch.fulfillRequest", {"requestId": event["requestId"]} | answer)

    client.on("Fetch.requestPaused", fulfill)
    client.send("Fetch.enable", {"patterns": [{"urlPattern": "*/PlotlyChart.*.js"}]})


def inside(page: Page, expression: str) -> object:
    """Evaluate a JavaScript expression with `root` as the stage's own document."""
    return page.evaluate(f"(() => {{ const root = {STAGE}; return {expression}; }})()")


def slab_over_block(page: Page) -> float:
    """Return the deformation of the spring as drawn [cm]."""
    place = "(name) => root.querySelector('.moving ' + name).transform.baseVal[0].matrix.e"
    slab, block = inside(page, f"['.slab', '.block'].map({place})")
    return slab - block


def press_preset(page: Page, name: str) -> None:
    """Press a preset; the first page has them in a fold."""
    page.locator(".st-key-preset button", has_text=name).dispatch_event("click", timeout=1000)


def thumb(page: Page, key: str) -> tuple[float, float]:
    """Return where the middle of a slider's thumb is on the screen."""
    box = page.locator(f".st-key-{key} [style*=left]").first.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def script(name: str) -> str:
    """Return the JavaScript of a file in tests/scripts, for a page to evaluate."""
    return (ROOT / "tests" / "scripts" / f"{name}.js").read_text(encoding="utf-8").strip()


def module(name: str) -> str:
    """Return the JavaScript expression that imports a module of the app, such as stage/motion."""
    return f"import('/{modules.place()}/{name}.js')"
