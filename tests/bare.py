"""A page with components of the app and nothing else: no Streamlit, no app, in any of three browsers.

What Python would send to the page is written by Python here, too: `Bare.put` calls the function that puts a component
on the page, keeps the data that would cross, and has the page's own begin.js begin it with them.
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
from tests.browser import ROOT, next_frame

THEME = tomllib.loads((ROOT / ".streamlit" / "config.toml").read_text())["theme"]
COMPRESSION = PARAMETERS["compression"]


class Bare:
    """A bare page; `page` is Playwright's, or what stands for it in WebKit."""

    def __init__(self, page: object, address: str) -> None:
        self.page = page
        page.goto(address)
        page.wait_for_function("Boolean(globalThis.put)")

    def put(self, draw: Callable[[], object]) -> None:
        """Put the components on the page that a function of the app puts there, or call them again."""
        calls = []

        def component(name: str) -> Callable[..., None]:
            return lambda *, key, data=None, **_: calls.append({"name": name, "key": key, "data": data})

        with patch.object(modules, "component", component):
            draw()
        self.page.evaluate("(calls) => put(calls)", calls)

    def stage(self, machine: Oscillator | None = None, compression: float = 0.08, **options: object) -> None:
        """Put a stage on the page, as the first page has it unless the options of `stage.mount` say otherwise."""
        payload = stage.payload(machine or Oscillator(1.0, 1.0, 10.0), compression)
        options = {"limits": COMPRESSION.limits, "watch": WATCH, "name": "oscillator"} | options
        self.put(lambda: stage.mount(payload, **options))
        next_frame(self.page)

    def sliders(self, **values: float) -> None:
        """Put sliders of the sidebar on the page, each with a value in its unit."""
        for key, value in values.items():
            known = PARAMETERS[key]
            given = {"min": known.least, "max": known.most, "step": known.step, "value": value}
            self.page.evaluate("([key, given]) => slide(key, given)", [key, given])

    @property
    def sent(self) -> list[list[object]]:
        """What components and sliders have told the server: [key, event, value]."""
        return self.page.evaluate("sent")


def written(theme: str) -> bytes:
    """Return the bare page in a theme."""
    text = (Path(__file__).parent / "bare.html").read_text(encoding="utf-8")
    style = "".join(f"--st-{_kebab(name)}: {value};" for name, value in THEME[theme].items() if isinstance(value, str))
    return text.replace("MODULES", f"/{modules.place()}").replace("THEME", f"color-scheme: {theme}; {style}").encode()


def _kebab(name: str) -> str:
    return "".join(f"-{letter.lower()}" if letter.isupper() else letter for letter in name)


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        path = self.path.partition("?")[0].removeprefix("/")
        found = written(path) if path in THEME else modules.contents().get(path.removeprefix(f"{modules.place()}/"))
        self.send_response(404 if found is None else 200)
        kind = "text/html" if path in THEME else guess_type(path)[0] or "application/octet-stream"
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(found or b"")))
        self.send_header("Cache-Control", "max-age=3600")
        self.end_headers()
        self.wfile.write(found or b"")

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@contextmanager
def serving() -> Iterator[str]:
    """Offer the bare page for as long as the block lasts; yield its address."""
    with ThreadingHTTPServer(("127.0.0.1", 0), _Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
