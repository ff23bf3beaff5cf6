"""A random name for each browser, so that in a class one person has one vote, however many tabs are open.

The name says nothing of anybody. A class keeps only what is made from it and from the class's own code
(`class_codes.voter_of`).
"""

import secrets
from typing import Any

from starlette.requests import cookie_parser

NAME = "ramanujan_browser"
_KEPT = 30 * 24 * 3600
"""Seconds for which a browser keeps its name: as long as the longest class."""


class NamedBrowser:
    """Middleware that gives a browser its name with the first page that it asks for."""

    def __init__(self, app: Any) -> None:
        self.app = app

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        cookies = dict(scope.get("headers", ())).get(b"cookie", b"").decode("latin-1")
        if scope["type"] != "http" or NAME in cookie_parser(cookies):
            await self.app(scope, receive, send)
            return

        async def name(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start":
                headers = message.get("headers", ())
                if dict(headers).get(b"content-type", b"").startswith(b"text/html"):
                    cookie = f"{NAME}={secrets.token_urlsafe(12)}; Max-Age={_KEPT}; Path=/; HttpOnly; SameSite=Lax"
                    message = {**message, "headers": [*headers, (b"set-cookie", cookie.encode())]}
            await send(message)

        await self.app(scope, receive, name)
