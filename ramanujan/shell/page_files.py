"""The files of the page, as small as a browser takes them: Streamlit's scripts, its start page, our modules.

The scripts of Streamlit's page are 8 MB. Streamlit leaves it to a proxy to compress them, and a laptop in a classroom
has none. The server reads and packs each file once, for everybody. What it keeps depends on no client, and sixty
browsers that ask at once wait for one packing.
"""

import asyncio
import gzip
import re
from base64 import b64encode
from collections.abc import Callable, Hashable
from functools import cache, partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import streamlit as st
from starlette.concurrency import run_in_threadpool
from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.middleware.exceptions import ExceptionMiddleware
from starlette.requests import Request
from starlette.responses import FileResponse, Response
from starlette.routing import Mount, Route, Router
from starlette.staticfiles import StaticFiles

from ramanujan.browser import modules
from ramanujan.translation import LANGUAGE

try:
    import brotli
except ImportError:
    brotli = None

_PACKERS: dict[str, Callable[[bytes], bytes]] = {"gzip": lambda content: gzip.compress(content, 6)}
if brotli:
    # An eighth smaller than gzip. One more in quality takes ten times as long for large scripts, for another twelfth.
    _PACKERS = {"br": lambda content: brotli.compress(content, quality=9), **_PACKERS}
_KEPT: dict[tuple[Hashable, str], asyncio.Task[bytes]] = {}
"""Name of a file and content coding → the packed content, perhaps still in the making."""

_STREAMLIT = Path(st.__file__).parent / "static"
_TYPES = {"js": "text/javascript", "css": "text/css", "woff2": "font/woff2"}
_TEXT = (".js", ".css", ".svg")
"""Endings of files that packing makes smaller."""
_FOR_GOOD = {"cache-control": "public, immutable, max-age=31536000", "vary": "accept-encoding"}
_FONT = re.compile(rb'<link\s[^>]*as="font"[^>]*>')
"""Asks for a font before it is known to be needed; page.css brings one that is smaller."""
_FIRST = ("begin", "components/services", "components/publish", "stage/stage")
"""Modules without which no machine is drawn; they bring what they import. To ask for all at once would delay them."""
_ANOTHER = {b"if-none-match", b"if-modified-since", b"range"}
"""Headers by which a browser asks for less than the whole start page; what it knows of it may be Streamlit's own."""


class PageFiles:
    """Middleware that answers for Streamlit's files and for our modules, and puts the app's start page for Streamlit's.

    Routes of an app come after Streamlit's reserved ones, of which its files are one.
    """

    def __init__(self, app: Any) -> None:
        base = st.get_option("server.baseUrlPath").strip("/")
        place = f"{base and '/'}{base}"
        files = Mount(f"{place}/static", _StreamlitFiles(directory=_STREAMLIT / "static", follow_symlink=True))
        own = Route(f"{place}/modules/{{hash}}/{{name:path}}", _module)
        self.app = app
        router = Router([files, own], redirect_slashes=False, default=self._with_own_page)
        self.answer = ExceptionMiddleware(router)

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        await (self.answer if scope["type"] == "http" else self.app)(scope, receive, send)

    async def _with_own_page(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        if "/_stcore/" in scope["path"] or "/media/" in scope["path"]:
            await self.app(scope, receive, send)
            return
        replaced = False

        async def replace(message: dict[str, Any]) -> None:
            nonlocal replaced
            if message["type"] == "http.response.start" and message["status"] == 200:
                replaced = Headers(raw=message["headers"]).get("content-type", "").startswith("text/html")
                if replaced:
                    await (await _start_page(Headers(scope=scope), scope["path"]))(scope, receive, send)
            if not replaced:
                await send(message)

        asked = [(name, value) for name, value in scope["headers"] if name not in _ANOTHER]
        await self.app({**scope, "headers": asked}, receive, replace)


class _StreamlitFiles(StaticFiles):
    """Streamlit's scripts, styles and fonts; their names hold a hash of their content.

    Of its four thousand icons a page gets those alone that it may draw (tests/fonts.py).
    """

    async def get_response(self, path: str, scope: dict[str, Any]) -> Response:
        if "MaterialSymbols" in path:
            headers = {"content-type": _TYPES["woff2"], "cache-control": "public, max-age=86400"}
            return Response(modules.contents()["components/icons.woff2"], headers=headers)
        file, asked = await super().get_response(path, scope), Headers(scope=scope)
        file.headers.update(_FOR_GOOD)
        if not isinstance(file, FileResponse) or not path.endswith(_TEXT) or "range" in asked:
            return file
        stat = file.stat_result

        def read() -> bytes:
            content = Path(file.path).read_bytes()
            if len(content) != stat.st_size:
                raise OSError(f"{file.path} has changed while it was read")
            return content

        # Packed in one way or another it is the same file: what nginx calls a weak tag.
        headers = {"content-type": file.headers["content-type"], "etag": f"W/{file.headers['etag']}", **_FOR_GOOD}
        return await _packed(asked, (file.path, stat.st_size, stat.st_mtime_ns), read, headers) or file


async def _module(request: Request) -> Response:
    """Answer with one of the page's modules."""
    name = request.path_params["name"]
    content = modules.contents().get(name)
    if content is None or modules.place() != f"modules/{request.path_params['hash']}":
        raise HTTPException(404)
    headers = {"content-type": _TYPES[name.rpartition(".")[2]], **_FOR_GOOD}
    return await _packed(request.headers, name, lambda: content, headers) or Response(content, headers=headers)


async def _start_page(asked: Headers, path: str) -> Response:
    # It is never "not modified": with each comes the browser's name, if it has none.
    headers = {"content-type": "text/html; charset=utf-8", "cache-control": "no-cache", "vary": "accept-encoding"}
    headers |= {"content-security-policy": _policy(), "referrer-policy": "no-referrer"}
    # A lesson begins with words alone, and a whole class loads it over one network.
    has_formulas = not path.endswith("/lesson")
    page = partial(_with_own, has_formulas=has_formulas)
    return await _packed(asked, has_formulas, page, headers) or Response(page(), headers=headers)


async def _packed(
    asked: Headers, name: Hashable, read: Callable[[], bytes], headers: dict[str, str]
) -> Response | None:
    """Return an answer in the smallest coding that a browser takes, or nothing if it takes none."""
    coding = _coding(asked.get("accept-encoding", ""))
    if coding is None:
        return None
    if (name, coding) not in _KEPT:
        _KEPT[name, coding] = asyncio.create_task(run_in_threadpool(lambda: _PACKERS[coding](read())))
    try:
        # A client that leaves must not cancel the packing for the others.
        content = await asyncio.shield(_KEPT[name, coding])
    except Exception:
        _KEPT.pop((name, coding), None)
        raise
    return Response(content, headers={**headers, "content-encoding": coding})


def _coding(accepted: str) -> str | None:
    """Return the smallest content coding that an Accept-Encoding header takes.

    >>> _coding("gzip;q=1.0, br;q=0, *;q=0.5")
    'gzip'
    """
    weights = re.findall(r"([\w*-]+)\s*(?:;\s*q=(\d(?:\.\d*)?))?", accepted.lower())
    taken = {coding: float(weight or 1) for coding, weight in weights}
    return next((coding for coding in _PACKERS if taken.get(coding, taken.get("*", 0.0)) > 0), None)


@cache
def _policy() -> str:
    """Return the content security policy: the page loads files of its own server, and what its scripts make.

    Streamlit imports the scripts of components from blobs and computes with WebAssembly; it and Plotly write rules of
    style into the page. Of the scripts in the page itself only those of Streamlit's start page may run.
    """
    inline = re.findall(rb"<script>(.*?)</script>", (_STREAMLIT / "index.html").read_bytes(), re.DOTALL)
    hashes = " ".join(f"'sha256-{b64encode(sha256(script).digest()).decode()}'" for script in inline)
    return (
        f"default-src 'self' blob: data:; script-src 'self' blob: 'wasm-unsafe-eval' {hashes}; "
        "style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'self'; form-action 'self'"
    )


def _with_own(*, has_formulas: bool) -> bytes:
    """Return Streamlit's start page with the app's own fonts, rules and modules.

    What a script of the app says about styles is read after the first headings are drawn, on a slow machine seconds
    later; so the start page asks for the page's rules and first modules itself, and nothing jumps.
    """
    place = f"./{modules.place()}"
    names = sorted(modules.contents())
    # Formulas are measured with KaTeX's letters: where these come late, lines change their length.
    letters = re.compile(r"KaTeX_(Main-Regular|Math-Italic|Size1-Regular)\..*woff2")
    kept = (f"./static/media/{each.name}" for each in _STREAMLIT.glob("static/media/*") if letters.match(each.name))
    needed = (*(f"{place}/{name}" for name in names if "fonts/" in name), *(kept if has_formulas else ()))
    fonts = (f'<link rel="preload" as="font" crossorigin href="{name}">' for name in needed)
    scripts = (f'<script type="module" async src="{place}/{name}.js"></script>' for name in _FIRST)
    # At the end: Streamlit adds its own rules to the head, and of two alike the later one counts.
    sheets = (name for name in names if name.endswith(".css"))
    # The projector's rules wait until pager.js lets them hold.
    media = {"components/print.css": ' media="print"', "components/projector.css": ' media="not all"'}
    rules = (f'<link rel="stylesheet" href="{place}/{name}"{media.get(name, "")}>' for name in sheets)
    end = f"{''.join(rules)}{''.join(scripts)}</body>"
    page = _FONT.sub("".join(fonts).encode(), (_STREAMLIT / "index.html").read_bytes(), count=1)
    page = page.replace(b'<html lang="en"', f'<html lang="{LANGUAGE}"'.encode(), 1)
    return page.replace(b"</body>", end.encode(), 1)
