"""Links as people and programs write them: copied out of a sentence, typed by hand, extended by a mailer.

A request for a page whose address can be tidied is redirected before a session begins. What no rule understands stays
in the address, and the page says why it ignores it.
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
"""Names of parameters by which other programs follow a link, such as utm_source, fbclid or gclid."""

KEPT_EVERYWHERE = (*display_mode.URL_PARAMETERS, *class_keys.URL_PARAMETERS)
"""The parameters that every page writes into its address, besides those of the sliders."""


def parameters_of(page: Page) -> tuple[address.URLParameter, ...]:
    """Return all that the address of a page may contain."""
    shared = (parameters, display_mode, class_keys, stages)
    return (*(each for room in shared for each in room.URL_PARAMETERS), *page.url_parameters)


def tidied(path: str, query: str) -> str | None:
    """Return the address of a page that a link means; None if the link is tidy or leads to no page.

    Parameters
    ----------
    path : of the link, below the app's own
    query : of the link, without its question mark

    >>> tidied("Derivation", "m_prime=9/8)&utm_source=mail")
    'derivation?m_prime=1.125'
    """
    meant = address.bare(path).strip("/").casefold()
    page = next((page for page in PAGES.values() if page.path == meant), None)
    if page is None:
        return None
    known = {parameter.name: parameter for parameter in parameters_of(page)}
    given = parse_qsl(query, keep_blank_values=True)
    kept = []
    for name, text in given:
        if name in known:
            kept.append((name, known[name].tidied(text)))
        elif not _TRACKING.fullmatch(name):
            kept.append((name, address.bare(text)))
    if page.path == path and kept == given:
        return None
    return f"{quote(page.path)}?{urlencode(kept, safe=',~')}".rstrip("?")


class TidyLinks:
    """Middleware that redirects a request for a page to the tidied address."""

    def __init__(self, app: Any) -> None:
        base = st.get_option("server.baseUrlPath").strip("/")
        self.app, self.place = app, f"/{base}/" if base else "/"

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        answer = self.app
        if scope["type"] == "http" and scope["path"].startswith(self.place):
            link = tidied(scope["path"].removeprefix(self.place), scope["query_string"].decode("latin-1"))
            if link is not None:
                answer = RedirectResponse(f"{self.place}{link}", headers={"cache-control": "no-store"})
        await answer(scope, receive, send)
