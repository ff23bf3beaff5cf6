"""The files of the page, compressed once when the server starts: Streamlit's scripts, our modules, the start page.

Streamlit leaves compression to a proxy. On a laptop without one, a first visit would load 8 MB instead of 2.5 MB.
Compression of all files takes less than a second, so every response comes from memory.
"""

import gzip
import re
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

import streamlit as st
from starlette.datastructures import MutableHeaders
from starlette.responses import Response
from starlette.staticfiles import NotModifiedResponse

from ramanujan import standalone
from ramanujan.browser import modules
from ramanujan.browser.components.link import STANDALONE_FILE
from ramanujan.server import start_page

_STREAMLIT = Path(st.__file__).parent / "static"
_TYPES = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2"}
_IMMUTABLE = {"cache-control": "public, immutable, max-age=31536000"}
_STREAMLIT_PATHS = {"_stcore", "media", "component", "static", "app", "auth", "oauth2callback"}
"""Names in addresses for which Streamlit, and not a page, is responsible."""
_GZIP_REFUSED = re.compile(r"gzip *; *q=0(\.0*)? *(,|$)", re.IGNORECASE)
"""A client's refusal of gzip. Starlette and this file only look for the word."""
_POLICY = re.compile('http-equiv="Content-Security-Policy" content="([^"]*)"')
"""The content security policy of the standalone file."""


class _File(NamedTuple):
    """A response: its body, the body compressed by gzip, the headers of both, and the status code."""

    content: bytes
    compressed: bytes
    headers: dict[str, str]
    status: int = 200


_MISSING = _File(b"", b"", {"content-type": "text/plain"}, 404)
"""The response for a module of another version of the app. Streamlit would send a page instead."""
_REFUSED = _File(b"", b"", {"content-type": "text/plain", "allow": "GET, HEAD"}, 405)
"""The response to a method that changes a file."""


class PageFiles:
    """Middleware that serves the page's files, and the app's own start page at the address of each page.

    It comes before Streamlit, because routes of an app cannot replace `/static/`.
    """

    def __init__(self, app: Any) -> None:
        base = st.get_option("server.baseUrlPath").strip("/")
        self.app = app
        self.root = f"/{base}" if base else ""
        self.files = _streamlit_files() | _module_files() | {STANDALONE_FILE: _standalone()}
        self.page = _page(has_formulas=True)
        # A whole class loads the lesson over one network. It starts without formulas, so it needs no fonts for them.
        self.lesson_page = _page(has_formulas=False)

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        request = MutableHeaders(scope=scope)
        if _GZIP_REFUSED.search(request.get("accept-encoding", "")):
            request["accept-encoding"] = "identity"
        file = self._file(scope)
        if file is None:
            await self.app(scope, receive, send)
            return
        headers = file.headers | {"vary": "accept-encoding"}
        response: Response
        if "etag" in headers and headers["etag"] in request.get("if-none-match", ""):
            response = NotModifiedResponse(MutableHeaders(headers))
        elif "gzip" in request.get("accept-encoding", ""):
            response = Response(file.compressed, file.status, headers | {"content-encoding": "gzip"})
        else:
            response = Response(file.content, file.status, headers)
        await response(scope, receive, send)

    def _file(self, scope: dict[str, Any]) -> _File | None:
        """Return the file at the address of a request, or None for a request to Streamlit."""
        if not f"{scope['path']}/".startswith(f"{self.root}/"):
            return None  # Streamlit does not find it, either
        path = scope["path"].removeprefix(self.root).strip("/")
        if scope["method"] not in {"GET", "HEAD"}:
            return _REFUSED if path in self.files else None
        if path in self.files:
            return self.files[path]
        parts = path.split("/")
        if parts[0] == "modules":
            return _MISSING
        if not _STREAMLIT_PATHS.isdisjoint(parts) or "." in parts[-1]:
            return None
        return self.lesson_page if parts[-1] == "lesson" else self.page


def _streamlit_files() -> dict[str, _File]:
    """Return address → file for Streamlit's scripts and styles; their names contain a hash of their content.

    The page uses few of Streamlit's four thousand icons, so the font contains only these (tests/fonts.py).
    """
    files = {}
    for path in (_STREAMLIT / "static").rglob("*"):
        address = path.relative_to(_STREAMLIT).as_posix()
        if path.name.startswith("MaterialSymbols"):
            icons = modules.collect_files()["icons.woff2"]
            files[address] = _compress(icons, _TYPES[".woff2"], {"cache-control": "public, max-age=86400"})
        elif path.suffix in {".js", ".css", ".svg"}:
            files[address] = _compress(path.read_bytes(), _TYPES[path.suffix], _IMMUTABLE)
    return files


def _module_files() -> dict[str, _File]:
    """Return address → file for our own modules, style sheets and fonts."""
    files = {}
    for name, content in modules.collect_files().items():
        files[f"{modules.folder_url()}/{name}"] = _compress(content, _TYPES[Path(name).suffix], _IMMUTABLE)
    return files


def _standalone() -> _File:
    """Return the standalone file, which other pages may embed. Browsers request it again if it has changed."""
    text = standalone.html()
    [policy] = _POLICY.findall(text)
    headers = {
        "cache-control": "no-cache",
        "content-security-policy": policy,
        "etag": f'W/"{sha256(text.encode()).hexdigest()[:16]}"',
    }
    return _compress(text.encode(), "text/html; charset=utf-8", headers)


def _compress(content: bytes, media_type: str, headers: dict[str, str]) -> _File:
    """Return a file with a compressed copy of its content."""
    return _File(content, gzip.compress(content, 6), {"content-type": media_type, **headers})


def _page(*, has_formulas: bool) -> _File:
    """Return the start page. A browser requests it at every visit, because the response sets the visitor's cookie."""
    html = start_page.html(has_formulas=has_formulas)
    return _compress(html, "text/html; charset=utf-8", {"cache-control": "no-cache"})
