"""The server’s own work, before any visitor and for all alike: it warms up, and offers the page’s files."""

import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import streamlit as st
from starlette.middleware import Middleware

from ramanujan.browser import modules
from ramanujan.shell import navigation
from ramanujan.shell.browser_cookie import NamedBrowser
from ramanujan.shell.page_files import PageFiles

MIDDLEWARE = [Middleware(NamedBrowser), Middleware(PageFiles)]


@asynccontextmanager
async def warmed_up(_: st.App) -> AsyncIterator[None]:
    """Import what any page needs when the server starts, then take it out of the garbage collector's rounds.

    A page imports what it shows when it is opened, which takes seconds; a class opens all of them at once. What has
    been imported never changes, and the collector need not walk through it again and again.
    """
    for page in navigation.PAGES.values():
        page.warm_up()
    modules.place()
    gc.collect()
    gc.freeze()
    yield
