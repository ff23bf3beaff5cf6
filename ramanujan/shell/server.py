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
DELETION_INTERVAL = 3600.0
"""Time between two deletions of expired answers [s]."""


def settings() -> dict[str, Any]:
    """Return the arguments of `st.App` besides the script: the middleware, and the tasks at start and end."""
    return {"middleware": MIDDLEWARE, "lifespan": lifespan}


@asynccontextmanager
async def lifespan(_: st.App) -> AsyncIterator[None]:
    """Import all pages when the server starts, exclude them from garbage collection, and delete expired answers.

    The import of a page takes seconds, and a class opens every page within a minute. The garbage collector need not
    visit imported modules, because they are never deleted.
    """
    for page in navigation.PAGES.values():
        page.warm_up()
    modules.folder_url()  # fills the cache of the files
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
        await asyncio.sleep(DELETION_INTERVAL)
