"""The tasks of the server: fill caches, serve the page's files, delete expired answers."""

import asyncio
import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from typing import Any

import streamlit as st
from starlette.concurrency import run_in_threadpool
from starlette.middleware import Middleware

from ramanujan.browser import modules
from ramanujan.lesson.classes import ClassError, shared
from ramanujan.shell import navigation
from ramanujan.shell.browser_cookie import NamedBrowser
from ramanujan.shell.links import TidyLinks
from ramanujan.shell.page_files import PageFiles

MIDDLEWARE = [Middleware(TidyLinks), Middleware(NamedBrowser), Middleware(PageFiles)]
"""Middleware in order: correct a link, name the browser, serve the file or the page."""
HOUR = 3600.0
"""Seconds between two deletions of expired answers."""


def settings() -> dict[str, Any]:
    """Return the arguments of `st.App` besides the script: the middleware, and the tasks at start and end."""
    return {"middleware": MIDDLEWARE, "lifespan": warmed_up}


@asynccontextmanager
async def warmed_up(_: st.App) -> AsyncIterator[None]:
    """Import all pages when the server starts, and exclude them from garbage collection.

    The imports of a page take seconds, and a class opens every page within a minute. Imported modules never change, so
    the collector need not visit them.
    """
    for page in navigation.PAGES.values():
        page.warm_up()
    modules.place()
    gc.collect()
    gc.freeze()
    deletion = asyncio.create_task(delete_expired_answers())
    yield
    deletion.cancel()


async def delete_expired_answers() -> None:
    """Delete the answers of expired classes at once and then every hour, until the task is cancelled."""
    while True:
        # The store logs the reason of a failure, and the next hour tries again.
        with suppress(ClassError):
            await run_in_threadpool(lambda: shared().delete_expired())
        await asyncio.sleep(HOUR)
