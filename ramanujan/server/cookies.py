"""A random name for each browser, so that in a class one person has one vote, also in several tabs.

The name contains no personal data. A class stores only a hash of the name and of the class code
(`codes.hash_browser`).
"""

import secrets
from typing import Any

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser

from ramanujan.shell.class_keys import COOKIE

_LIFETIME = 30 * 24 * 3600
"""Lifetime of the cookie [s], longer than that of a class."""


class NamedBrowser:
    """Middleware that sets a cookie with a random name in the response to a browser's first request of a page.

    Over HTTPS, also behind a proxy that sets X-Forwarded-Proto, all cookies are marked as Secure.
    """

    def __init__(self, app: Any) -> None:
        self.app = app

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        request = Headers(scope=scope) if scope["type"] == "http" else {}
        # Each of several proxies appends its own protocol, so the visitor's is the first.
        protocol = request.get("x-forwarded-proto") or scope.get("scheme", "")
        is_secure = protocol.startswith("https")

        async def send_with_cookie(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                # The standalone file, which other sites embed, gets no cookie.
                name = scope["path"].rpartition("/")[2]
                is_page = headers.get("content-type", "").startswith("text/html") and "." not in name
                if is_page and COOKIE not in cookie_parser(request.get("cookie", "")):
                    headers.append("set-cookie", _new_cookie())
                if is_secure:
                    _mark_cookies_as_secure(headers)
            await send(message)

        await self.app(scope, receive, send_with_cookie if scope["type"] == "http" else send)


def _new_cookie() -> str:
    """Return the value of a Set-Cookie header with a new random name."""
    return f"{COOKIE}={secrets.token_urlsafe(12)}; Max-Age={_LIFETIME}; Path=/; HttpOnly; SameSite=Lax"


def _mark_cookies_as_secure(headers: MutableHeaders) -> None:
    """Add the attribute Secure to each cookie of a response that does not have it."""
    cookies = headers.getlist("set-cookie")
    if cookies:
        del headers["set-cookie"]
    for cookie in cookies:
        if "; secure" not in cookie.lower():
            cookie = f"{cookie}; Secure"
        headers.append("set-cookie", cookie)
