"""What the server does before any visitor comes, and for all of them alike: warm up, offer modules, compress files.

The scripts of Streamlit's page are 8 MB. Streamlit leaves it to a proxy to compress them, and a laptop in a classroom
has none. What a script of the app says about styles is read after the first headings are drawn, on a slow machine
seconds later; so Streamlit's start page asks for the page's rules and first modules itself, and nothing jumps.
"""

import gc
import gzip
import importlib
import pkgutil
import re
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

import streamlit as st
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.base import BaseHTTPMiddleware, RequestResponseEndpoint
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

import ramanujan
from ramanujan.browser import modules
from ramanujan.shell.browser_cookie import NamedBrowser

try:
    import brotli
except ImportError:
    brotli = None

_PACKERS: dict[str, Callable[[bytes], bytes]] = {"gzip": lambda content: gzip.compress(content, 6)}
if brotli:
    # A quarter smaller. With this quality it is as quick as gzip; one more takes thirty times as long, for a tenth.
    _PACKERS = {"br": lambda content: brotli.compress(content, quality=9), **_PACKERS}
_FONT = re.compile(rb'<link\s[^>]*as="font"[^>]*>')
"""Asks for a font before it is known to be needed; page.css brings one that is smaller."""
_FIRST = ("begin", "page/library", "page/publish", "stage/stage")
"""Modules without which no machine is drawn; they bring what they import. To ask for all at once would delay them."""
_ANOTHER = {b"accept-encoding", b"if-none-match", b"if-modified-since", b"range"}
"""Headers by which a browser asks for less than the whole file as it is."""
_KEPT: dict[tuple[str, str], Response] = {}
"""Path of a file (nothing for the start page, which is found under any), content coding → answer."""
_TYPES = {"js": "text/javascript", "css": "text/css", "woff2": "font/woff2"}
_FOR_GOOD = "public, immutable, max-age=31536000"


def routes() -> list[Route]:
    """Return what the server offers besides Streamlit's own: the page's modules, below the app's address."""
    base = st.get_option("server.baseUrlPath").strip("/")
    return [Route(f"{base and '/'}{base}/modules/{{hash}}/{{name:path}}", _module)]


@asynccontextmanager
async def warmed_up(_: st.App) -> AsyncIterator[None]:
    """Import what any page needs when the server starts, then take it out of the garbage collector's rounds.

    A page imports what it shows when it is opened, which takes seconds; a class opens all of them at once. What has
    been imported never changes, and the collector need not walk through it again and again.
    """
    for module in pkgutil.walk_packages(ramanujan.__path__, "ramanujan."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    modules.place()
    gc.collect()
    gc.freeze()
    yield


async def _module(request: Request) -> Response:
    """Answer with one of the page's modules."""
    name = request.path_params["name"]
    if name not in modules.contents() or not modules.place().endswith(request.path_params["hash"]):
        raise HTTPException(404)
    headers = {"Cache-Control": _FOR_GOOD}
    return Response(modules.contents()[name], media_type=_TYPES[name.rpartition(".")[2]], headers=headers)


async def _once(request: Request, call_next: RequestResponseEndpoint) -> Response:
    """Make the start page and what a browser may keep for good as small as it can be, once for everybody."""
    path = request.url.path
    if request.method != "GET" or "/_stcore/" in path or "/media/" in path:
        return await call_next(request)
    accepted = request.headers.get("accept-encoding", "")
    coding = next((name for name in _PACKERS if name in accepted), "identity")
    if (path, coding) in _KEPT:
        return _KEPT[path, coding]
    request.scope["headers"] = [(name, value) for name, value in request.scope["headers"] if name not in _ANOTHER]
    answer = await call_next(request)
    is_page = answer.headers.get("content-type", "").startswith("text/html")
    if answer.status_code != 200 or not (is_page or "immutable" in answer.headers.get("cache-control", "")):
        return answer
    file = "" if is_page else path, coding
    content = b"".join([part async for part in answer.body_iterator])
    if file not in _KEPT:
        packed = await run_in_threadpool(_PACKERS.get(coding, bytes), _with_css(content) if is_page else content)
        # What Streamlit says of its file's length and age is not true of this one.
        headers = {name: answer.headers[name] for name in ("content-type", "cache-control")}
        _KEPT[file] = Response(packed, headers={**headers, "content-encoding": coding, "vary": "accept-encoding"})
    return _KEPT[file]


def _with_css(page: bytes) -> bytes:
    """Return Streamlit's start page with the app's own fonts, rules and modules."""
    place = f"./{modules.place()}"
    names = sorted(modules.contents())
    fonts = (f'<link rel="preload" as="font" crossorigin href="{place}/{name}">' for name in names if "fonts/" in name)
    scripts = (f'<script type="module" async src="{place}/{name}.js"></script>' for name in _FIRST)
    # At the end: Streamlit adds its own rules to the head, and of two alike the later one counts.
    sheets = (name for name in names if name.endswith(".css"))
    media = {"page/projector.css": ' media="not all"'}  # until pager.js lets it hold
    rules = (f'<link rel="stylesheet" href="{place}/{name}"{media.get(name, "")}>' for name in sheets)
    end = f"{''.join(rules)}{''.join(scripts)}</body>"
    return _FONT.sub("".join(fonts).encode(), page, count=1).replace(b"</body>", end.encode(), 1)


MIDDLEWARE = [Middleware(NamedBrowser), Middleware(BaseHTTPMiddleware, dispatch=_once)]
