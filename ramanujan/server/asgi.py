"""The tasks of the server: raise the limit of open files, fill caches, serve files, delete expired answers."""

import asyncio
import gc
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from typing import Any

import streamlit as st
from starlette.concurrency import run_in_threadpool
from starlette.middleware import Middleware

from ramanujan.classroom.rules import ClassError, shared
from ramanujan.server import open_files
from ramanujan.server.cookies import NamedBrowser
from ramanujan.server.packed_files import PageFiles
from ramanujan.server.security_headers import SecurityHeaders

MIDDLEWARE = [Middleware(NamedBrowser), Middleware(SecurityHeaders), Middleware(PageFiles)]
"""Middleware in order: name the browser, add headers, serve the file or the page."""
DELETION_INTERVAL = 3600.0
"""Time between two deletions of expired answers [s]."""


def settings(warm_up: Callable[[], None]) -> dict[str, Any]:
    """Return the arguments of `st.App` besides the script: the middleware, and the tasks at start and end.

    Parameters
    ----------
    warm_up : fills the caches of the pages
    """

    @asynccontextmanager
    async def lifespan(_: st.App) -> AsyncIterator[None]:
        open_files.raise_limit()
        warm_up()
        # The garbage collector need not visit imported modules, because they are never deleted.
        gc.collect()
        gc.freeze()
        deletion = asyncio.create_task(delete_expired_answers())
        yield
        deletion.cancel()

    return {"middleware": MIDDLEWARE, "lifespan": lifespan}


async def delete_expired_answers() -> None:
    """Delete the answers of expired classes at once and then every hour, until the task is cancelled."""
    while True:
        # The store logs the reason of a failure, and the next hour tries again.
        with suppress(ClassError):
            await run_in_threadpool(lambda: shared().delete_expired())
        await asyncio.sleep(DELETION_INTERVAL)
