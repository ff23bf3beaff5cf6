"""Correction of links that were copied with punctuation, typed by hand, or extended by a mail program.

A request with such a link is redirected to the corrected address before a session begins. An invalid value remains in
the address, and the page explains why it was ignored.
"""

import re
from typing import Any
from urllib.parse import parse_qsl, quote, urlencode

import streamlit as st
from starlette.responses import RedirectResponse

from ramanujan.shell import address, class_keys, display_mode, parameters, stages
from ramanujan.shell.navigation import PAGES, Page

_TRACKING = re.compile(
    r"(utm|pk|mtm|hsa|matomo|piwik)_\w*|[a-z]{1,3}clk?id|[gw]braid|(mc_[ce]|sccid|s_c|rdt_c|li_fat_|vero_|igsh)(id)?|srsltid"
    r"|_(ga|gl|hsenc|hsmi|ke|openstat)|mkt_tok|oly_\w+_id|ref|ref_src",
    re.IGNORECASE,
)
"""Names of tracking parameters that other programs add to a link, such as utm_source, fbclid or gclid."""

EVERY_PAGE = (*display_mode.URL_PARAMETERS, *class_keys.URL_PARAMETERS)
"""URL parameters of every page, besides those of the sliders."""


def parameters_of(page: Page) -> tuple[address.URLParameter, ...]:
    """Return all URL parameters of a page."""
    return (
        *parameters.URL_PARAMETERS,
        *display_mode.URL_PARAMETERS,
        *class_keys.URL_PARAMETERS,
        *stages.URL_PARAMETERS,
        *page.url_parameters,
    )


def tidy(path: str, query: str) -> str | None:
    """Return the corrected address of a page; None if the link is correct or does not lead to a page.

    Parameters
    ----------
    path : path of the link, relative to the base path of the app
    query : query of the link, without its question mark

    >>> tidy("Derivation", "m_prime=9/8)&utm_source=mail")
    'derivation?m_prime=1.125'
    """
    bare_path = address.strip_punctuation(path).strip("/").casefold()
    page = next((page for page in PAGES.values() if page.path == bare_path), None)
    if page is None:
        return None
    known = {parameter.name: parameter for parameter in parameters_of(page)}
    parsed = parse_qsl(query, keep_blank_values=True)
    corrected = []
    for name, text in parsed:
        if name in known:
            corrected.append((name, known[name].tidy(text)))
        elif not _TRACKING.fullmatch(name):
            corrected.append((name, address.strip_punctuation(text)))
    if page.path == path and corrected == parsed:
        return None
    return f"{quote(page.path)}?{urlencode(corrected, safe=',~')}".rstrip("?")


class TidyLinks:
    """Middleware that redirects a request for a page to its corrected address."""

    def __init__(self, app: Any) -> None:
        base = st.get_option("server.baseUrlPath").strip("/")
        self.app = app
        self.base_path = f"/{base}/" if base else "/"

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        link = self._corrected(scope) if scope["type"] == "http" else None
        if link is None:
            await self.app(scope, receive, send)
            return
        redirect = RedirectResponse(f"{self.base_path}{link}", headers={"cache-control": "no-store"})
        await redirect(scope, receive, send)

    def _corrected(self, scope: dict[str, Any]) -> str | None:
        """Return the corrected address of a request; None if it is correct or does not lead to a page."""
        if not scope["path"].startswith(self.base_path):
            return None
        path = scope["path"].removeprefix(self.base_path)
        query = scope["query_string"].decode("latin-1")
        return tidy(path, query)
