"""A random name for each browser, so that in a class one person has one vote, however many tabs are open.

The name says nothing of anybody. A class keeps only what is made from it and from the class's own code
(`class_codes.voter_of`).
"""

import secrets
from typing import Any

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser

NAME = "ramanujan_browser"
_KEPT = 30 * 24 * 3600
"""Seconds for which a browser keeps its name: as long as the longest class."""


class NamedBrowser:
    """Middleware that gives a browser its name with the first page that it asks for.

    Over HTTPS the name is marked as secure, also where a proxy says that it was asked over HTTPS. Browsers are told not
    to guess the type of a file.
    """

    def __init__(self, app: Any) -> None:
        self.app = app

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        asked = Headers(scope=scope) if scope["type"] == "http" else {}
        is_secure = "https" in (scope.get("scheme"), asked.get("x-forwarded-proto"))

        async def name(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                headers["x-content-type-options"] = "nosniff"
                # The standalone file is embedded elsewhere and needs no name.
                is_page = headers.get("content-type", "").startswith("text/html") and "." not in scope["path"]
                if is_page and NAME not in cookie_parser(asked.get("cookie", "")):
                    cookie = f"{NAME}={secrets.token_urlsafe(12)}; Max-Age={_KEPT}; Path=/; HttpOnly; SameSite=Lax"
                    headers.append("set-cookie", cookie)
                cookies = headers.getlist("set-cookie")
                if is_secure and cookies:
                    del headers["set-cookie"]
                    for cookie in cookies:
                        headers.append("set-cookie", cookie if "; secure" in cookie.lower() else f"{cookie}; Secure")
            await send(message)

        await self.app(scope, receive, name if scope["type"] == "http" else send)
