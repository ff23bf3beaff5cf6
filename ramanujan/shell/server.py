"""What the server does before any visitor comes, and for all of them alike: warm up, dress the page, compress scripts.

The scripts of Streamlit's page are 8 MB. Streamlit leaves it to a proxy to compress them, and a laptop in a classroom
has none. What a script of the app says about styles is read after the first headings are drawn, on a slow machine
seconds later; so the page's rules stand in the page itself, and nothing jumps.
"""

from __future__ import annotations

import gc
import importlib
import pkgutil
import re
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import streamlit as st
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware

import ramanujan
from ramanujan.browser.page import bundle

__all__ = ["Compressed", "Dressed", "Middleware", "warm_up", "warmed_up"]

_SCRIPTS = "/static/"
_LEVEL = 6
_QUALITY = 9
"""Of Brotli: as quick as gzip; one more takes thirty times as long, for a tenth of the bytes."""
_SMALLEST = 1000
"""Bytes from which on a file gets smaller."""
_FONT = re.compile(rb'<link\s[^>]*as="font"[^>]*>')
"""Asks for a font before it is known to be needed; page.css brings one that is smaller."""
_ANOTHER = (b"accept-encoding", b"if-none-match", b"if-modified-since", b"range")
"""Headers by which a browser asks for less than the whole file as it is."""


@asynccontextmanager
async def warmed_up(_: st.App) -> AsyncIterator[None]:
    """Warm up when the server starts."""
    warm_up()
    yield


def warm_up() -> None:
    """Import what any page needs, then take it out of the garbage collector's rounds.

    A page imports what it shows when it is opened, which takes seconds; a class opens all of them at once. What has
    been imported never changes, and the collector need not walk through it again and again.
    """
    for module in pkgutil.walk_packages(ramanujan.__path__, "ramanujan."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    gc.collect()
    gc.freeze()


class Compressed:
    """Middleware that compresses the scripts and styles of Streamlit's page, each once for all visitors."""

    def __init__(self, app: Any) -> None:
        self.app, self.compressing = app, _compressing(_Whole(app))
        self.kept: dict[tuple[str, bool], list[dict[str, Any]]] = {}

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        if not _may_be_kept(scope):
            await self.app(scope, receive, send)
            return
        file = scope["path"], b"br" in dict(scope["headers"])[b"accept-encoding"]
        if file not in self.kept:
            answer: list[dict[str, Any]] = []

            async def keep(message: dict[str, Any]) -> None:
                answer.append(message)
                await send(message)

            await self.compressing(scope, receive, keep)
            if _is_file(answer[0]):
                self.kept[file] = answer
            return
        for message in self.kept[file]:
            await send(message)


def _compressing(app: Any) -> Any:
    """Return the middleware that compresses: with Brotli, a quarter smaller, where it is installed and understood."""
    try:
        from brotli_asgi import BrotliMiddleware
    except ImportError:
        return GZipMiddleware(app, minimum_size=_SMALLEST, compresslevel=_LEVEL)
    return BrotliMiddleware(app, minimum_size=_SMALLEST, quality=_QUALITY)


class Dressed:
    """Middleware that puts the rules of page.css into Streamlit's page."""

    def __init__(self, app: Any) -> None:
        self.app, self.whole = app, _Whole(app)
        self.compressing = GZipMiddleware(self._insert, minimum_size=_SMALLEST)

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        await (self.compressing if _may_be_page(scope) else self.app)(scope, receive, send)

    async def _insert(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        headers = [(name, value) for name, value in scope["headers"] if name not in _ANOTHER]
        start: dict[str, Any] = {}

        async def dress(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start" and _is_page(message):
                start.update(message)
            elif not start:
                await send(message)
            else:
                # At the end: Streamlit adds its own rules to the head, and of two alike the later one counts.
                rules = f"<style>{bundle.style()}</style></body>".encode()
                body = _FONT.sub(b"", message["body"]).replace(b"</body>", rules, 1)
                # What Streamlit says of its file is not true of this one.
                other = (b"content-length", b"etag", b"last-modified", b"accept-ranges")
                kept = [(name, value) for name, value in start["headers"] if name not in other]
                await send({**start, "headers": [*kept, (b"content-length", str(len(body)).encode())]})
                await send({**message, "body": body})

        await self.whole({**scope, "headers": headers}, receive, dress)


class _Whole:
    """Middleware that hands on an answer's parts in one piece."""

    def __init__(self, app: Any) -> None:
        self.app = app

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        parts: list[bytes] = []

        async def gather(message: dict[str, Any]) -> None:
            parts.append(message.get("body", b""))
            if message["type"] != "http.response.body":
                await send(message)
            elif not message.get("more_body"):
                await send({**message, "body": b"".join(parts)})

        await self.app(scope, receive, gather)


def _may_be_page(scope: dict[str, Any]) -> bool:
    return (
        scope["type"] == "http" and scope["method"] == "GET" and not scope["path"].startswith((_SCRIPTS, "/_stcore/"))
    )


def _is_page(start: dict[str, Any]) -> bool:
    return start["status"] == 200 and dict(start["headers"]).get(b"content-type", b"").startswith(b"text/html")


def _is_file(start: dict[str, Any]) -> bool:
    """Tell whether an answer is a compressed file: there are some hundred, but any number of other addresses."""
    headers = dict(start["headers"])
    immutable = b"immutable" in headers.get(b"cache-control", b"")
    return start["status"] == 200 and immutable and headers.get(b"content-encoding") in (b"gzip", b"br")


def _may_be_kept(scope: dict[str, Any]) -> bool:
    if scope["type"] != "http" or scope["method"] != "GET" or not scope["path"].startswith(_SCRIPTS):
        return False
    headers = dict(scope["headers"])
    conditional = {b"range", b"if-none-match", b"if-modified-since"}
    return b"gzip" in headers.get(b"accept-encoding", b"") and not conditional & headers.keys()
