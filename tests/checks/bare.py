"""A page that contains only components of the app, without Streamlit, in any of three browsers.

The data come from Python, as in the app. `Bare.put` calls a function that puts components on the page. It records their
data, and starts them on the page with begin.js.
"""

import threading
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from mimetypes import guess_type
from pathlib import Path
from unittest.mock import patch

from ramanujan import Oscillator
from ramanujan.browser import modules, stage
from ramanujan.shell.parameters import PARAMETERS, WATCH
from tests.checks.browser import ROOT, next_frame

THEME = tomllib.loads((ROOT / ".streamlit" / "config.toml").read_text())["theme"]
COMPRESSION = PARAMETERS["compression"]


class Bare:
    """A bare page; `page` is Playwright's page or the one of tests/checks/webkit.py."""

    def __init__(self, page: object, address: str) -> None:
        self.page = page
        page.goto(address)
        page.wait_for_function("Boolean(globalThis.put)")

    def put(self, draw: Callable[[], object]) -> None:
        """Put the components of a function of the app on the page, or call them again."""
        calls = []

        def component(name: str) -> Callable[..., None]:
            return lambda *, key, data=None, **_: calls.append({"name": name, "key": key, "data": data})

        with patch.object(modules, "component", component):
            draw()
        self.page.evaluate("(calls) => put(calls)", calls)

    def stage(self, machine: Oscillator | None = None, compression: float = 0.08, **options: object) -> None:
        """Put a stage on the page. The options of `stage.mount` override those of the first page."""
        payload = stage.payload(machine or Oscillator(1.0, 1.0, 10.0), compression)
        options = {"limits": COMPRESSION.limits, "watch": WATCH, "name": "oscillator"} | options
        self.put(lambda: stage.mount(payload, **options))
        next_frame(self.page)

    def sliders(self, **values: float) -> None:
        """Put sliders of the sidebar on the page, each with a value in its unit."""
        for key, value in values.items():
            parameter = PARAMETERS[key]
            attributes = {"min": parameter.least, "max": parameter.most, "step": parameter.step, "value": value}
            self.page.evaluate("([key, attributes]) => slide(key, attributes)", [key, attributes])

    @property
    def sent(self) -> list[list[object]]:
        """The messages of components and sliders to the server: [key, event, value]."""
        return self.page.evaluate("sent")


def html(theme: str) -> bytes:
    """Return the bare page in a theme."""
    text = (Path(__file__).parent / "bare.html").read_text(encoding="utf-8")
    style = "".join(f"--st-{_kebab(name)}: {value};" for name, value in THEME[theme].items() if isinstance(value, str))
    text = text.replace("MODULES", f"/{modules.folder_url()}")
    return text.replace("THEME", f"color-scheme: {theme}; {style}").encode()


def _kebab(name: str) -> str:
    return "".join(f"-{letter.lower()}" if letter.isupper() else letter for letter in name)


def _read_file(name: str) -> bytes | None:
    """Return a file of the app's page, or a module of the standalone file that imports the modules of this page."""
    if name.startswith("standalone/"):
        return (ROOT / "ramanujan" / name).read_bytes().replace(b"../browser/", b"../")
    return modules.collect_files().get(name)


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        path = self.path.partition("?")[0].removeprefix("/")
        name = path.removeprefix(f"{modules.folder_url()}/")
        content = html(path) if path in THEME else _read_file(name)
        self.send_response(404 if content is None else 200)
        kind = "text/html" if path in THEME else guess_type(path)[0] or "application/octet-stream"
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content or b"")))
        self.send_header("Cache-Control", "max-age=3600")
        self.end_headers()
        self.wfile.write(content or b"")

    def log_message(self, *_: object) -> None:
        """Write no log."""


@contextmanager
def serving(handler: Callable[..., BaseHTTPRequestHandler] = _Handler) -> Iterator[int]:
    """Serve the bare page during the block, or what another handler answers. Yield the port."""
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield server.server_port
        finally:
            server.shutdown()
