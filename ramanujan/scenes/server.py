"""What the server does before any visitor comes, and for all of them alike: warm up, and send its scripts compressed.

The scripts of Streamlit's page are 8 MB. Streamlit leaves it to a proxy to compress them, and a laptop in a classroom
has none.
"""

from __future__ import annotations

import gc
import importlib
import pkgutil
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import streamlit as st
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware

import ramanujan

__all__ = ["Compressed", "Middleware", "warm_up", "warmed_up"]

_SCRIPTS = "/static/"
_LEVEL = 6
_SMALLEST = 1000
"""Bytes from which on a file gets smaller."""


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
        self.app, self.compressing = app, GZipMiddleware(app, minimum_size=_SMALLEST, compresslevel=_LEVEL)
        self.kept: dict[str, list[dict[str, Any]]] = {}

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        if not _may_be_kept(scope):
            await self.app(scope, receive, send)
            return
        path = scope["path"]
        if path not in self.kept:
            answer: list[dict[str, Any]] = []

            async def keep(message: dict[str, Any]) -> None:
                answer.append(message)
                await send(message)

            await self.compressing(scope, receive, keep)
            if _is_file(answer[0]):
                self.kept[path] = answer
            return
        for message in self.kept[path]:
            await send(message)


def _is_file(start: dict[str, Any]) -> bool:
    """Tell whether an answer is a compressed file: there are some hundred, but any number of other addresses."""
    headers = dict(start["headers"])
    immutable = b"immutable" in headers.get(b"cache-control", b"")
    return start["status"] == 200 and immutable and headers.get(b"content-encoding") == b"gzip"


def _may_be_kept(scope: dict[str, Any]) -> bool:
    if scope["type"] != "http" or scope["method"] != "GET" or not scope["path"].startswith(_SCRIPTS):
        return False
    headers = dict(scope["headers"])
    conditional = {b"range", b"if-none-match", b"if-modified-since"}
    return b"gzip" in headers.get(b"accept-encoding", b"") and not conditional & headers.keys()
